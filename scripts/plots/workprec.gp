# Error against run time, from a table of `scallop workprec`, a panel for each gait (rows) and T (columns). Methods differ by symbol, and in
# how they get to the steady state by the line: as a root filled and solid, by simulation open and dashed. The broad grey stairs are the
# Pareto front.
set datafile columnheaders missing NaN
MOST = 12
array gait[MOST]
array period[MOST]
gaits = periods = rivals = 0
known_rivals = "'gsl rkf45' 'gsl rk8pd' cvode moreau"
array rival_of[4]
put_gait(text, i) = i > MOST ? 0 : i > gaits ? (gaits = i, gait[i] = text, 0) : gait[i] eq text ? 0 : put_gait(text, i + 1)
put_period(text, i) = i > MOST ? 0 : i > periods ? (periods = i, period[i] = text, 0) : period[i] eq text ? 0 : put_period(text, i + 1)
begins(text, head) = text[1:strlen(head)] eq head
known(text, i) = i > 4 ? 0 : begins(text, word(known_rivals, i)) ? i : known(text, i + 1)
put_rival(k, i) = k == 0 ? 0 : i > rivals ? (rivals = i, rival_of[i] = k, 0) : rival_of[i] == k ? 0 : put_rival(k, i + 1)
fastest = 1e999
slowest = -1e999
note(t) = t > 0 ? (fastest = t < fastest ? t : fastest, slowest = t > slowest ? t : slowest, 0) : 0
set table $all
plot table using (put_gait(strcol("gait"), 1), put_period(strcol("T"), 1), put_rival(known(strcol("method"), 1), 1), note(column("time_median"))) \
     with table
unset table
if (slowest < fastest) { exit error "no row has a time" }
shown = periods > 3 ? 3 : periods # of more the first, the middle one and the last
panel_T(i) = period[periods <= 3 ? i : i == 1 ? 1 : i == 2 ? (periods + 1) / 2 : periods]

eval picture(shown == 1 ? 1000 : shown == 2 ? 1000 : 1200, 390 * gaits + 190, 14)
set logscale xy
least = 1e-20 # what is below is drawn here
clip(e) = e < least ? least : e
set xrange [has_x_range ? low_x : fastest / 2 : has_x_range ? high_x : slowest * 2]
set yrange [has_y_range ? low_y : least/4 : has_y_range ? high_y : 30]
set format x "10^{%T}"
set xtics 1e-12, 100, 1e6
set grid lc rgb "#dddddd" lt 1

here(g, T) = strcol("gait") eq g && strcol("T") eq T && strcol("quantity") eq "displacement"
ok(g, T) = here(g, T) && strcol("status") eq "ok"
is(m, g, T) = strcol("method") eq m && ok(g, T) ? clip(column("error")) : NaN
by(name, kind, g, T) = begins(strcol("method"), name) && strcol("kind") eq kind && ok(g, T) ? clip(column("error")) : NaN
cut(g, T) = here(g, T) && begins(strcol("status"), "cut off") ? clip(column("error")) : NaN
front(g, T) = strcol("pareto") eq "yes" && here(g, T) ? clip(column("error")) : NaN

rival(i) = word(known_rivals, rival_of[i])
open(i) = word("4 6 10 12", rival_of[i]) + 0 # the symbol after it is the same, filled
colour(i) = word("#c8102e #0b3c8c #2a9d4a #7b3fa0", rival_of[i])
grey = "#777777"

high = 390.0 * gaits + 190
left = 90.0 / (shown == 1 ? 1000 : shown == 2 ? 1000 : 1200)
bottom = 175 / high
top = 1 - 62 / high
gap = 76 / high
set multiplot layout gaits,shown margins left,0.985,bottom,top spacing 0.02,gap title title noenhanced font small
do for [row=1:gaits] {
  do for [c=1:shown] {
    g = gait[row]
    T = panel_T(c)
    set title sprintf("%s gait, T = %s", g, T) offset 0,-0.6 noenhanced
    set xlabel (row == gaits ? "seconds for one steady state, on one machine" : "") offset 0,0.3
    set ylabel (c == 1 ? "relative error of the displacement" : "") offset 1.2,0
    if (c == 1) { set ytics ("1" 1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12, "10^{-16}" 1e-16, "< 10^{-20}" 1e-20) }
    if (c > 1) { set ytics ("" 1, "" 1e-4, "" 1e-8, "" 1e-12, "" 1e-16, "" 1e-20) }
    unset key
    if (row == gaits && c == 1) { set key at screen 0.53,0.005 center bottom vertical maxrows (shown == 1 ? 8 : 4) samplen 3.5 width -1 }
    plot table using "time_median":(front(g, T)) smooth unique with steps lw 9 lc rgb "#cccccc" notitle, \
      table using "time_median":(is("published", g, T)) with points pt 1 ps 1.5 lw 2 lc rgb "black" notitle, \
      table using "time_median":(is("derived series", g, T)) with linespoints pt 2 ps 1.1 lw 1.5 dt 4 lc rgb "black" notitle, \
      table using "time_median":(is("exact", g, T)) with points pt 7 ps 2.2 lc rgb "black" notitle, \
      table using "time_median":(is("certified", g, T)) with linespoints pt 5 ps 1.3 lw 1.5 lc rgb "black" notitle, \
      for [i=1:rivals] table using "time_median":(by(rival(i), "root", g, T)) with linespoints pt open(i)+1 ps 1 lw 1.5 lc rgb colour(i) notitle, \
      for [i=1:rivals] table using "time_median":(by(rival(i), "simulation", g, T)) with linespoints pt open(i) ps 1 lw 1.5 dt 2 lc rgb colour(i) notitle, \
      table using "time_median":(by("smoothed", "root", g, T)) with points pt 15 ps 1.3 lc rgb grey notitle, \
      table using "time_median":(by("smoothed", "simulation", g, T)) with points pt 14 ps 1.3 lw 1.2 lc rgb grey notitle, \
      table using "time_median":(cut(g, T)) with points pt 2 ps 0.7 lw 1 lc rgb "#c8102e" notitle, \
      keyentry with lines lw 9 lc rgb "#cccccc" title "Pareto front", \
      keyentry with points pt 1 ps 1.5 lw 2 lc rgb "black" title "published (28)", \
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
