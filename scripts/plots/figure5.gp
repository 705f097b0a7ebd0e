eval picture(900, 380, 13)
set multiplot layout 1,2
set ylabel "mean velocity"
set xzeroaxis lt 1 lc rgb "#999999"
set xlabel "alpha"
set title "F_2 = 1"
set key top left
set yrange [-8:8]
plot for [i=1:3] table using 2:(strcol(1) eq "A" && abs($4-word("2 4 10",i)) < 1e-9 ? $5 : NaN) skip 1 with lines lw 2 lc rgb word(one." ".two." ".three,i) title "F_1 = ".word("2 4 10",i), \
     for [i=1:3] table using 2:(strcol(1) eq "A" && abs($4-word("2 4 10",i)) < 1e-9 ? $6 : NaN) skip 1 with lines lw 1.5 dt 2 lc rgb word(one." ".two." ".three,i) notitle, \
     NaN with lines lw 1.5 dt 2 lc rgb grey title "series (28)"
set xlabel "F_1 / F_2"
set title "alpha = 3/4"
set logscale x
set xrange [1:1000]
set yrange [-0.5:8]
set key top right
plot for [i=1:3] table using 4:(strcol(1) eq "B" && $3 == word("0.5 1 2",i)+0 ? $5 : NaN) skip 1 with lines lw 2 lc rgb word(one." ".two." ".three,i) title "F_2 = ".word("0.5 1 2",i), \
     table using 4:(strcol(1) eq "B" && $3 == 1 ? $6 : NaN) skip 1 with lines lw 1.5 dt 2 lc rgb grey title "series (28)"
unset multiplot
