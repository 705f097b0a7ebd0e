# The displacement over alpha, exact and by (28): below 1/2 the bodies exchange their parts, and so they must in the formula.
eval picture(480, 340, 12)
set xlabel "α, the share of the extension in the period"
set ylabel "displacement in a period, over L"
set xzeroaxis lt 1 lc rgb "#999999"
set yrange [-1.6:0.8]
set key bottom right
plot table using 1:2 skip 1 with lines lw 3 lc rgb one title "exact", \
     table using 1:3 skip 1 with lines lw 1.5 dt 2 lc rgb two title "(28) as printed", \
     table using 1:4 skip 1 with lines lw 1.5 dt 4 lc rgb grey title "(28) with the bodies exchanged"
