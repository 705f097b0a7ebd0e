eval picture(900, 380, 13)
set multiplot layout 1,2
set xlabel "t / T"
set key top left
set title "positions"
set ylabel "x / L"
plot table using 1:2 skip 1 with lines lw 3 lc rgb one title "body 1", \
     table using 1:3 skip 1 with lines lw 2 dt 2 lc rgb two title "body 2"
set title "velocities"
set ylabel "v T / L"
set xzeroaxis lt 1 lc rgb "#999999"
plot table using 1:4 skip 1 with lines lw 3 lc rgb one title "body 1", \
     table using 1:5 skip 1 with lines lw 2 dt 2 lc rgb two title "body 2"
unset multiplot
