# The displacement over the Froude number: stick-slip crawls far below 1.
eval picture(480, 340, 12)
set logscale x
set xlabel "Froude number  M L / (T^2 (F_1 + F_2))"
set ylabel "displacement in a period, over L"
set xrange [0.01:10]
set yrange [0:0.4]
set key bottom right
plot table using 1:(strcol(4) ne "at-rest" ? $3 : NaN) skip 1 with lines lw 2 lc rgb "#b8860b" title "one sticks for a part of the period", \
     table using 1:(strcol(4) eq "sliding" ? $3 : NaN) skip 1 with lines lw 2 lc rgb one title "both bodies slide", \
     table using 1:(strcol(4) eq "at-rest" ? $3 : NaN) skip 1 with lines lw 4 lc rgb grey title "body 1 never moves"
