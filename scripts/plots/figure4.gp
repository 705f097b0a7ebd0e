eval picture(900, 380, 13)
set multiplot layout 1,2
set xlabel "duration T of the extension"
pick(ratio, column) = $1 == ratio ? column : NaN
colour(ratio) = ratio == 2 ? one : ratio == 10 ? two : three
set title "change of position"
set ylabel "Δx_C / L"
set yrange [0:0.6]
set key top right
plot for [r in "2 10 40"] table using 2:($1 == r+0 ? $3 : NaN) skip 1 with lines lw 2 lc rgb colour(r+0) title "F_1/F_2 = ".r, \
     for [r in "2 10 40"] table using 2:($1 == r+0 ? $4 : NaN) skip 1 with lines lw 2 dt 2 lc rgb colour(r+0) notitle, \
     NaN with lines lw 2 dt 2 lc rgb grey title "series (21)"
set title "change of velocity"
set ylabel "Δv_C T / L"
set yrange [0:0.6]
set key at graph 0.72,0.99 right top
plot for [r in "2 10 40"] table using 2:($1 == r+0 ? $5 : NaN) skip 1 with lines lw 2 lc rgb colour(r+0) title "F_1/F_2 = ".r, \
     for [r in "2 10 40"] table using 2:($1 == r+0 ? $6 : NaN) skip 1 with lines lw 2 dt 2 lc rgb colour(r+0) notitle, \
     NaN with lines lw 2 dt 2 lc rgb grey title "series (18)"
unset multiplot
