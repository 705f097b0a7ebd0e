eval picture(900, 380, 13)
set multiplot layout 1,2
set xlabel "t / T"
set ylabel "x / L"
set yrange [-1.1:3.3]
set key top left
pick(name, column) = strcol(1) eq name ? column : NaN
do for [name in "symmetric asymmetric"] {
  set title (name eq "symmetric" ? "alpha = 1/2: oscillation" : "alpha = 3/4: locomotion")
  plot table using 2:(pick(name, $3)) skip 1 with lines lw 3 lc rgb one title "body 1", \
       table using 2:(pick(name, $4)) skip 1 with lines lw 2 dt 2 lc rgb two title "body 2", \
       table using 2:(pick(name, $5)) skip 1 with lines lw 2 dt 4 lc rgb "black" title "centre", \
       table using 2:(pick(name, $6)-1) skip 1 with lines lw 1 lc rgb "#999999" title "l / L - 1"
}
unset multiplot
