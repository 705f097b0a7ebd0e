# One line for each row of a table, named by its by columns, with a symbol for each y column: magnitudes along a logarithmic axis; what is 0 is written.
# over_column: what the numbers are divided by, or "". limit: where a line is drawn, or NaN.
set datafile columnheaders
if (!exists("over_column")) { over_column = "" }
if (!exists("limit")) { limit = NaN }
MOST = 400
array name[MOST]
array instead[MOST]
rows = 0
least = 1e999
most = -1e999
joined(i) = i > bys ? "" : (i > 1 ? "  " : "") . strcol(by_columns[i]) . joined(i + 1)
negative = 0
signed(v) = (negative = negative || v < 0, abs(v))
size(q) = signed(column(y_columns[q]) / (strlen(over_column) > 0 ? column(over_column) : 1))
shown(v) = v - v == 0 && v > 0
note(v) = v == 0 ? (said = "0", 0) : shown(v) ? (any = 1, least = v < least ? v : least, most = v > most ? v : most, v) : NaN
all(q) = q > ys ? 0 : (note(size(q)), all(q + 1))
set table $all
plot table using (rows < MOST ? (rows = rows + 1, name[rows] = joined(1), any = 0, said = "none", all(1), \
                                             instead[rows] = any ? "" : said, 0) : NaN) with table
unset table
if (rows == 0) { exit error "the table has no rows" }
if (rows == MOST) { exit error sprintf("more than %d rows: each has a line", MOST - 1) }
if (most < least) { least = 0.1; most = 1 }
if (limit - limit == 0) { least = limit < least ? limit : least; most = limit > most ? limit : most }
longest = 0
do for [i=1:rows] { longest = strlen(name[i]) > longest ? strlen(name[i]) : longest }
eval picture(860 + 3 * longest, 120 + 20 * rows + (ys > 1 ? 24 : 0), 12)
over(text) = strlen(over_column) > 0 ? text . " / " . over_column : text
magnitude(text) = negative ? "|" . over(text) . "|" : over(text)
names(q) = q > ys ? "" : (q > 1 ? ", " : "") . magnitude(symbol(y_columns[q])) . names(q + 1)
set title title noenhanced font small
set xlabel names(1) noenhanced
set logscale x
if (has_x_range) { set xrange [low_x:high_x] } else { set xrange [least / (most / least)**0.03 / 1.2:most * (most / least)**0.03 * 1.2] }
if (log10(most / least) > 2.999) { set format x "10^{%T}" } else { set format x "%g" }
set yrange [rows + 0.7:0.3]
unset ytics
set border 1
set lmargin 1 + longest * 1.02
set rmargin 4
do for [i=1:rows] { set label i name[i] at graph -0.01, first i right noenhanced
                    set label MOST+i instead[i] at graph 0.01, first i left noenhanced textcolor rgb grey }
set grid x lc rgb "#dddddd" lt 1
do for [i=1:rows] { set arrow i from graph 0, first i to graph 1, first i nohead lc rgb "#eeeeee" back }
if (limit - limit == 0) { set arrow rows+1 from limit, graph 0 to limit, graph 1 nohead dt 2 lw 2 lc rgb two
                          set label rows+1 sprintf("promised for %s: %g", y_columns[1], limit) at limit, graph 1.0 offset 0,0.6 right noenhanced textcolor rgb two }
set key below noenhanced Left reverse
set bmargin (ys > 1 ? 5.5 : 4)
set key at screen 0.5, screen 8.0 / (144 + 20 * rows) center bottom horizontal
if (ys == 1) { unset key }
colours = "#0b3c8c #c8102e #2a9d4a #b8860b #7b3fa0 #1b9aaa #000000 #888888"
plot for [q=1:ys] table using (shown(size(q)) ? size(q) : NaN):($0 + 1) with points pt int(word("7 5 9 11 13 6 4 8", q)) ps 1.1 \
     lc rgb word(colours, q) title magnitude(symbol(y_columns[q]))
