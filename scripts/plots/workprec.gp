# Error against run time, from data/workprec.tsv: rows are gaits, columns T. Methods differ by symbol, and in how they get to the steady
# state by the line: as a root filled and solid, by simulation open and dashed. The broad grey stairs are the Pareto front.
eval picture(1200, 900, 14)
set datafile missing NaN
set logscale xy
least = 1e-20 # what is below is drawn here
clip(e) = e < least ? least : e
set xrange [1e-9:30]
set yrange [least/4:30]
set format x "10^{%T}"
set xtics 1e-9, 100, 10
set grid lc rgb "#dddddd" lt 1

here(g, T) = strcol(4) eq g && $5 == T && strcol(6) eq "displacement"
ok(g, T) = here(g, T) && strcol(18) eq "ok"
is(m, g, T) = strcol(1) eq m && ok(g, T) ? clip($7) : NaN
by(name, kind, g, T) = strcol(1)[1:strlen(name)] eq name && strcol(2) eq kind && ok(g, T) ? clip($7) : NaN
cut(g, T) = here(g, T) && strcol(18)[1:7] eq "cut off" ? clip($7) : NaN
front(g, T) = strcol(17) eq "yes" && here(g, T) ? clip($7) : NaN

rival(i) = word("'gsl rkf45' 'gsl rk8pd' 'gsl msadams' cvode moreau arkode", i)
rivals = system("grep -c '^arkode' '".table."'") > 0 ? 6 : 5 # an older table has no rows of the last
open(i) = word("4 6 8 10 12 14", i) + 0 # the symbol after it is the same, filled
colour(i) = word("#c8102e #0b3c8c #b8860b #2a9d4a #7b3fa0 #1f9fc0", i)
grey = "#777777"

set multiplot layout 2,3 margins 0.075,0.99,0.175,0.955 spacing 0.02,0.085
do for [g in "quadratic sinusoidal"] {
  do for [T in "1 0.01 0.0001"] {
    set title sprintf("%s gait, T = %s", g, T) offset 0,-0.6
    set xlabel (g eq "sinusoidal" ? "seconds for one steady state, on one machine" : "") offset 0,0.3
    set ylabel (T eq "1" ? "relative error of the displacement" : "") offset 1.2,0
    if (T eq "1") { set ytics ("1" 1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12, "10^{-16}" 1e-16, "< 10^{-20}" 1e-20) }
    if (T ne "1") { set ytics ("" 1, "" 1e-4, "" 1e-8, "" 1e-12, "" 1e-16, "" 1e-20) }
    unset key
    if (g eq "sinusoidal" && T eq "1") { set key at screen 0.53,0.005 center bottom vertical maxrows (rivals == 5 ? 5 : 6) samplen 3.5 width -1 }
    plot table using 8:(front(g, T+0)) smooth unique with steps lw 9 lc rgb "#cccccc" notitle, \
      table using 8:(is("published", g, T+0)) with points pt 1 ps 1.5 lw 2 lc rgb "black" notitle, \
      table using 8:(is("derived series, coefficients known", g, T+0)) with linespoints pt 3 ps 1.1 lw 1.5 dt 3 lc rgb "black" notitle, \
      table using 8:(is("derived series", g, T+0)) with linespoints pt 2 ps 1.1 lw 1.5 dt 4 lc rgb "black" notitle, \
      table using 8:(is("exact", g, T+0)) with points pt 7 ps 2.2 lc rgb "black" notitle, \
      table using 8:(is("certified", g, T+0)) with linespoints pt 5 ps 1.3 lw 1.5 lc rgb "black" notitle, \
      for [i=1:rivals] table using 8:(by(rival(i), "root", g, T+0)) with linespoints pt open(i)+1 ps 1 lw 1.5 lc rgb colour(i) notitle, \
      for [i=1:rivals] table using 8:(by(rival(i), "simulation", g, T+0)) with linespoints pt open(i) ps 1 lw 1.5 dt 2 lc rgb colour(i) notitle, \
      table using 8:(by("smoothed", "root", g, T+0)) with points pt 15 ps 1.3 lc rgb grey notitle, \
      table using 8:(by("smoothed", "simulation", g, T+0)) with points pt 14 ps 1.3 lw 1.2 lc rgb grey notitle, \
      table using 8:(cut(g, T+0)) with points pt 2 ps 0.7 lw 1 lc rgb "#c8102e" notitle, \
      keyentry with lines lw 9 lc rgb "#cccccc" title "Pareto front", \
      keyentry with points pt 1 ps 1.5 lw 2 lc rgb "black" title "published (28)", \
      keyentry with linespoints pt 3 ps 1.1 lw 1.5 dt 3 lc rgb "black" title "series, coefficients known", \
      keyentry with linespoints pt 2 ps 1.1 lw 1.5 dt 4 lc rgb "black" title "series, derived", \
      keyentry with points pt 7 ps 2.2 lc rgb "black" title "exact", \
      keyentry with linespoints pt 5 ps 1.3 lw 1.5 lc rgb "black" title "certified", \
      for [i=1:rivals] keyentry with linespoints pt open(i)+1 ps 1 lw 1.5 lc rgb colour(i) title rival(i).", root", \
      keyentry with points pt 15 ps 1.3 lc rgb grey title "smoothed friction, root", \
      for [i=1:rivals] keyentry with linespoints pt open(i) ps 1 lw 1.5 dt 2 lc rgb colour(i) title rival(i).", simulated", \
      keyentry with points pt 14 ps 1.3 lw 1.2 lc rgb grey title "smoothed friction, simulated", \
      keyentry with points pt 2 ps 0.7 lw 1 lc rgb "#c8102e" title "cut off: where it stood"
  }
}
unset multiplot
