# The certified error of published formulas against T, where the paper's conditions hold: no floor, however small T is.
eval picture(900, 380, 13)
set multiplot layout 1,2
set logscale xy
set format y "10^{%T}"
set format x "10^{%T}"
set key bottom right spacing 1.4
set ylabel "|error|"
set xrange [1e-21:10]
names(i) = word("eq14_dT eq18_v_end eq21_dxC eq23_dxC eqA25_dxC", i)
titles = "'(14) dT, O(T^5)' '(18) v_1, O(T^3)' '(21) x_C, O(T^4)' '(23) x_C, O(T^4)' '(A.25) x_C, O(T^4)'"
colours = "#0b3c8c #c8102e #2a9d4a #b8860b #555555"
set xlabel "duration T of an extension"
set title "one extension (quadratic gait)"
set yrange [1e-130:1e10]
plot for [i=1:5] table using 8:(strcol(1) eq names(i) && strcol(7) eq "yes" && strcol(6)[1:3] ne "con" ? abs($9) : NaN) skip 1 \
     with linespoints lw 1.5 pt 2*i+3 ps 0.6 pointinterval 5 lc rgb word(colours, i) title word(titles, i)
set xlabel "period T"
set title "steady state (quadratic gait)"
titles = "'(27) v_0, O(T)' '(28) x_C, O(T^4)'"
set yrange [1e-90:1e10]
plot for [i=1:2] table using 8:(strcol(1) eq word("eq27_v_start eq28_displacement", i) && strcol(7) eq "yes" ? abs($9) : NaN) skip 1 \
     with linespoints lw 1.5 pt 2*i+3 ps 0.6 pointinterval 5 lc rgb word(colours, i) title word(titles, i)
unset multiplot
