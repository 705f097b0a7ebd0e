# The relative error of (28) against T for both gaits: the measured slopes, and the claimed one beside them.
eval picture(480, 340, 12)
array gaits[2] = [ "quadratic", "sinusoidal" ]
array slopes[2]
do for [i=1:2] {
  stats table using (strcol(1) eq gaits[i] && $2 <= 0.1 ? log10($2) : NaN):(log10(abs($3))) skip 1 name "fit" nooutput
  slopes[i] = sprintf("%s gait: measured T^{%.2f}", gaits[i], abs(fit_slope) < 0.005 ? 0 : fit_slope)
}
stats table using (strcol(1) eq gaits[2] && $2 == 1 ? abs($3) : NaN) skip 1 name "last" nooutput
set logscale xy
set format y "10^{%T}"
set xlabel "period T"
set ylabel "relative error of (28)"
set key bottom right spacing 1.35
set xrange [1e-3:1]
plot table using 2:(strcol(1) eq gaits[2] ? abs($3) : NaN) skip 1 with linespoints lw 2 pt 7 ps 0.5 pointinterval 3 lc rgb two title slopes[2], \
     table using 2:(strcol(1) eq gaits[1] ? abs($3) : NaN) skip 1 with linespoints lw 2 pt 5 ps 0.5 pointinterval 3 lc rgb one title slopes[1], \
     last_max * x**4 with lines lw 1.5 dt 2 lc rgb grey title "claimed for both: T^4"
