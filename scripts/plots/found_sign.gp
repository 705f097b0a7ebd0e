# The error of (A.25) as printed, and of (23), which has the other sign in front of T^3; a term of order T^4 vanishes there.
eval picture(480, 340, 12)
table = tables."/errors.tsv"
array names[2] = [ "eqA25_dxC", "eq23_dxC" ]
array what[2] = [ "(A.25), + before T^3", "(23), − before T^3" ]
is(name) = strcol(1) eq name && strcol(7) eq "yes"
array slopes[2]
do for [i=1:2] {
  stats table using (is(names[i]) && $8 < 0.1 ? log10($8) : NaN):(log10(abs($9))) skip 1 name "fit" nooutput
  slopes[i] = sprintf("%s: measured T^{%.2f}, claimed T^4", what[i], fit_slope)
}
set logscale xy
set format xy "10^{%T}"
set xlabel "duration T of an extension\n"
set ylabel "error of the position x_C"
set key below center vertical maxrows 2 spacing 1.3
set xrange [1e-6:2]
plot for [i=1:2] table using 8:(is(names[i]) ? abs($9) : NaN) skip 1 with linespoints lw 2 pt 3+2*i ps 0.5 lc rgb (i == 1 ? two : one) title slopes[i]
