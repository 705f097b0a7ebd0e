# How far each series reaches: the tolerance for its relative error over T, a panel for each quantity; events as lines, numbered, with
# what happens below; radii of convergence as stars; the error of the best order at T. From a table of `scallop breakdown`.
set datafile columnheaders
MOST = 40
array quantity[MOST]
array series[MOST]
array event[MOST]
array event_T[MOST]
quantities = lines = events = radii = bests = 0
least = 1 # tolerance
low = 1e999
high = -1e999
put_quantity(text, i) = i > MOST ? 0 : i > quantities ? (quantities = i, quantity[i] = text, 0) : quantity[i] eq text ? 0 : put_quantity(text, i + 1)
put_series(text, i) = i > MOST ? 0 : i > lines ? (lines = i, series[i] = text, 0) : series[i] eq text ? 0 : put_series(text, i + 1)
note(T) = T > 0 && T - T == 0 ? (low = T < low ? T : low, high = T > high ? T : high, 0) : 0
put_event(T, text) = T > 0 && events < MOST ? (events = events + 1, event[events] = text, event_T[events] = T, note(T)) : 0
line_name(name, order) = order eq "nan" ? name : sprintf("%s, below T^%s", name, order)
row(what) = what eq "event" ? put_event(column("T"), strcol("note")) : \
            what eq "reach" ? (put_quantity(strcol("quantity"), 1), put_series(line_name(strcol("series"), strcol("order")), 1), \
                                note(column("T")), least = column("tolerance") < least ? column("tolerance") : least) : \
            what eq "best" ? (bests = bests + 1, put_quantity(strcol("quantity"), 1), note(column("T"))) : \
            what eq "radius" ? (radii = radii + 1, put_quantity(strcol("quantity"), 1), note(column("T"))) : 0
set table $all
plot table using (row(strcol("what"))) with table
unset table
if (high < low) { exit error "no row has a T that can be drawn" }
columns_of = quantities > 1 ? 2 : 1
rows = quantities > 0 ? (quantities + columns_of - 1) / columns_of : 1
key_rows = (lines + 3) / 2 + events + 1 # of the lists below
w = columns_of == 1 ? 800 : 1150
h = 60 + 270 * rows + 22 * key_rows
eval picture(w, h, 12)
bottom = (22.0 * key_rows + 50) / h
set logscale xy
set format y "10^{%T}"
set xrange [has_x_range ? low_x : low / (high / low)**0.03 / 1.1 : has_x_range ? high_x : high * (high / low)**0.03 * 1.3]
set format x (log10(high / low) > 2.999 ? "10^{%T}" : "%g")
if (has_y_range) { set yrange [low_y:high_y] } else { if (lines > 0 || bests == 0) { set yrange [lines > 0 ? least / 3 : 1e-16:10] } }
set grid lc rgb "#e4e4e4" lt 1
colours = "#0b3c8c #c8102e #2a9d4a #b8860b #7b3fa0 #1b9aaa #000000 #888888"
do for [k=1:events] { set arrow k from event_T[k], graph 0 to event_T[k], graph 1 nohead dt 3 lw 1.3 lc rgb "#555555"
                      set label k sprintf("%d", k) at event_T[k], graph 1 offset 0,(k % 2 ? 0.5 : 1.1) center font ",".(kind eq "png" ? 11 : 9) }
top = 1 - 50.0 / h
gap = 80.0 / h
set multiplot layout rows,columns_of title title noenhanced font small margins 0.09,0.98,bottom,top spacing 0.09,gap
unset key
pick(q, s) = strcol("what") eq "reach" && strcol("quantity") eq quantity[q] && line_name(strcol("series"), strcol("order")) eq series[s]
of(q, what) = quantities > 0 && strcol("what") eq what && strcol("quantity") eq quantity[q]
finite(T) = T > 0 && T - T == 0 ? T : NaN
dashes(s) = (s - 1) % 5 + 1
symbol_of(s) = int(word("7 4 9 10 13 6 5 8", (s - 1) % 8 + 1))
colour(s) = word(colours, (s - 1) % 8 + 1)
panels = quantities > 0 ? quantities : 1
line_height = 22.0 / h
do for [q=1:panels] {
  set ylabel "relative error" . (quantities > 0 ? ", " . symbol(quantity[q]) : "") noenhanced
  set xlabel (q > quantities - columns_of ? axis("T") : "") noenhanced
  if (q == panels) {
    set key at screen 0.09, screen (bottom - 55.0 / h) left top Left reverse noenhanced samplen 4 maxrows (lines + 3) / 2
    do for [k=1:events] { set label MOST+k sprintf("%d  T = %.4g: %s", k, event_T[k], event[k]) noenhanced left \
                          at screen 0.09, screen (line_height * (events - k + 0.7)) }
  }
  plot for [s=1:lines] table using (pick(q, s) ? finite(column("T")) : NaN):(column("tolerance")) with linespoints lw 1.8 dt dashes(s) \
         pt symbol_of(s) ps 0.9 lc rgb colour(s) notitle, \
       table using (of(q, "radius") ? finite(column("T")) : NaN):(1) \
         with points pt 3 ps 1.5 lw 1.5 lc rgb "black" notitle, \
       table using (of(q, "best") ? finite(column("T")) : NaN):(abs(column("error"))) with linespoints lw 1.2 pt 1 lc rgb grey notitle, \
       for [s=1:lines] keyentry with linespoints lw 1.8 dt dashes(s) pt symbol_of(s) ps 0.9 lc rgb colour(s) title series[s], \
       for [i=1:(radii > 0)] keyentry with points pt 3 ps 1.5 lw 1.5 lc rgb "black" title "radius of convergence", \
       for [i=1:(bests > 0)] keyentry with linespoints lw 1.2 pt 1 lc rgb grey title "derived, best order at T"
}
unset multiplot
