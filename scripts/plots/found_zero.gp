# The displacement over F1/F2 at alpha = 0.55: it changes its sign while both bodies slide.
eval picture(480, 340, 12)
table = tables."/found_ratio.tsv"
is(regime) = $1 == 0.55 && strcol(2) eq "quadratic" && strcol(6) eq regime
ratio = before = zero = NaN # of the row before: between two rows the displacement changes its sign
stats table using (is("sliding") ? (before > 0 && $4 <= 0 ? zero = ratio + ($3 - ratio) * before / (before - $4) : 0, ratio = $3, before = $4, 1) : NaN) skip 1 nooutput
set logscale x
set xlabel "F_1 / F_2"
set ylabel "displacement in a period, over L"
set xrange [1:200]
set xzeroaxis lt 1 lc rgb "#999999"
set yrange [-0.2:0.16]
set key bottom left
set label 1 sprintf("0 at %.1f", zero) at zero,0 point pt 7 ps 1 lc rgb two offset 0.8,0.8
plot table using 3:(is("stick-slip") || is("sliding") ? $4 / 10 : NaN) skip 1 with lines lw 2 lc rgb "#b8860b" title "one sticks for a part of the period", \
     table using 3:(is("sliding") ? $4 / 10 : NaN) skip 1 with lines lw 2 lc rgb one title "α = 0.55: both bodies slide"
