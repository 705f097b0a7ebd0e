# l' of each family of gaits over a period, for scripts/plots/pages.sh: work, a folder with its tables, is set.
set terminal pngcairo size 1440,640 fontscale 1.1 font "DejaVu Sans,12"
set output "docs/reference/gaits.png"
set datafile separator "\t"
set multiplot layout 2, 4 margins 0.055, 0.99, 0.08, 0.94 spacing 0.035, 0.13
unset key
set border 3
set xtics nomirror ("0" 0, "α T" 0.6, "T" 1); set ytics nomirror
set xrange [0:1]; set yrange [-6:4]
set arrow 1 from 0, 0 to 1, 0 nohead linecolor rgb "#999999"
set arrow 2 from 0.6, graph 0 to 0.6, graph 1 nohead dashtype 3
names = "quadratic sinusoidal trapezoidal:0.2,0.3 skewed:0.25 constant:0.05 polynomial:0,3,-2 minimum-jerk measured:FILE"
do for [k = 1:8] {
  set title word(names, k) offset 0, -0.6
  set ylabel (k % 4 == 1 ? "l' T/L" : "") offset 0.9
  plot work . "/gait" . k using 1:2 with lines linewidth 2.5 linecolor rgb "#0b3d91"
}
