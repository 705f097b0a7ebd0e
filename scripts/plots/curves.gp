# Columns of any table, in curves. Variables besides those of common.gp: title, x_column, arrays y_columns (ys of them) and by_columns (bys),
# flags log_x, log_y and abs_y (magnitudes are drawn). A curve for each y column, and for each combination of values in the by columns.
MOST = 24         # combinations
FEW_POINTS = 40   # of a curve: each is marked
SHORT_TITLE = 26  # characters: the key stands beside the curves, not below
set datafile columnheaders
if (!exists("abs_y")) { abs_y = 0 }
drawn_y(y) = abs_y ? abs(y) : y

# The combinations of values, in the order of the rows
array combination[MOST]
array called[MOST]
combinations = 0
too_many = 0
joined(i) = i > bys ? "" : (i > 1 ? ", " : "") . strcol(by_columns[i]) . joined(i + 1)
# A number says what it is of, a word does not.
call(i) = i > bys ? "" : (i > 1 ? ", " : "") . (is_number(strcol(by_columns[i])) ? symbol(by_columns[i]) . " = " : "") . \
          strcol(by_columns[i]) . call(i + 1)
place(text, i) = i > MOST ? (too_many = 1, 0) : i > combinations ? (combinations = i, combination[i] = text, called[i] = call(1), 0) : \
                 combination[i] eq text ? 0 : place(text, i + 1)
set table $all
plot table using (place(joined(1), 1)) with table
unset table
if (combinations == 0) { exit error table . " has no rows" }
if (too_many) { exit error sprintf("more than %d combinations of values: each has a curve", MOST) }

# Curve c is of combination v(c) and y column q(c). A row that the axes cannot show interrupts it.
curves = combinations * ys
v(c) = (c - 1) / ys + 1
q(c) = (c - 1) % ys + 1
array shown[curves]
least_x = least_y = 1e999
most_x = most_y = -1e999
min(a, b) = a < b ? a : b
max(a, b) = a > b ? a : b
fits(value, logarithmic) = value - value == 0 && (!logarithmic || value > 0)
point(c, x, y) = fits(x, log_x) && fits(y, log_y) ? \
                 (shown[c] = shown[c] + 1, least_x = min(least_x, x), most_x = max(most_x, x), \
                  least_y = min(least_y, y), most_y = max(most_y, y), sprintf("%.17g %.17g", x, y)) : "NaN NaN"
row(c) = joined(1) eq combination[v(c)] ? point(c, column(x_column), drawn_y(column(y_columns[q(c)]))) : ""
do for [c=1:curves] {
  shown[c] = 0
  eval sprintf("set table $curve%d", c)
  plot table using (row(c)):(NaN) with table if (joined(1) eq combination[v(c)])
  unset table
}
if (most_x < least_x) { exit error "no row has a number that the axis can show in both columns" }
unset datafile
set datafile separator whitespace

# A logarithmic axis of few powers of ten has its own tics, and ends at the points.
apart(low, high) = 10**floor(log10((high - low) / 5))
step(low, high) = (r = (high - low) / 5 / apart(low, high), apart(low, high) * (r < 1.5 ? 1 : r < 3.5 ? 2 : r < 7.5 ? 5 : 10))
do for [axis in "x y"] {
  if (axis eq "x" ? log_x : log_y) {
    given = axis eq "x" ? has_x_range : has_y_range
    low = axis eq "x" ? (given ? low_x : least_x) : (given ? low_y : least_y)
    high = axis eq "x" ? (given ? high_x : most_x) : (given ? high_y : most_y)
    eval sprintf("set logscale %s", axis)
    if (log10(high) - log10(low) > 2.999) {
      eval sprintf("set format %s '10^{%%T}'", axis)
      if (low > 1e-290 && high < 1e290) { eval sprintf("set %srange [%.17g:%.17g]", axis, given ? low : low / 1.3, given ? high : high * 1.3) }
    } else {
      if (low > 1e-300 && high < 1e300) {
        margin = given ? 1 : high > low * (1 + 1e-6) ? (high / low)**0.04 : 1.1
        low = low / margin
        high = high * margin
        eval sprintf("set %srange [%.17g:%.17g]", axis, low, high)
        tics = ""
        if (high < 10 * low) {
          by = step(low, high)
          do for [n=ceil(low/by):floor(high/by)] { tics = tics . sprintf(", %.12g", n * by) }
        } else {
          do for [power=floor(log10(low)):ceil(log10(high))] { do for [head in "1 2 5"] {
            at = head * 10.0**power
            if (at >= low && at <= high) { tics = tics . sprintf(", %.12g", at) }
          } }
        }
        eval sprintf("set %stics (%s)", axis, tics[3:])
      }
    }
  }
}

# Colours and symbols tell the combinations apart and dashes the columns; without by_columns all of them tell the columns apart.
colours = "#0b3c8c #c8102e #2a9d4a #b8860b #7b3fa0 #1b9aaa #000000 #888888"
hue(c) = bys > 0 ? v(c) : q(c)
colour(c) = word(colours, (hue(c) - 1) % 8 + 1)
dashes(c) = bys > 0 && ys > 1 ? (q(c) - 1) % 5 + 1 : (hue(c) - 1) % 5 + 1
symbol_of(c) = int(word("7 5 9 11 13 6 4 8 10 12", (hue(c) - 1) % 10 + 1))
magnitude(text) = abs_y ? "|" . text . "|" : text
same_unit(i) = i > ys ? 1 : unit_words(y_columns[i]) eq unit_words(y_columns[1]) ? same_unit(i + 1) : 0
y_names(i) = i > ys ? "" : (i > 1 ? ", " : "") . magnitude(symbol(y_columns[i])) . y_names(i + 1)
entry(c) = (ys > 1 || bys == 0 ? magnitude(symbol(y_columns[q(c)])) : "") . (ys > 1 && bys > 0 ? ", " : "") . \
           (bys > 0 ? called[v(c)] : "") . (shown[c] == 0 ? " (none)" : "")
longest = 0
most = 0
do for [c=1:curves] {
  longest = max(longest, strlen(entry(c)))
  most = max(most, shown[c])
}
if (has_x_range) { set xrange [low_x:high_x] } else { if (!log_x && most_x > least_x) {
  margin = most > FEW_POINTS ? 0 : (most_x - least_x) * 0.02
  set xrange [least_x - margin:most_x + margin]
} }
if (has_y_range) { set yrange [low_y:high_y] }
set title title noenhanced font small
set xlabel axis(x_column) noenhanced
set ylabel y_names(1) . (same_unit(1) ? in_unit(y_columns[1]) : "") noenhanced
set key noenhanced Left reverse samplen 4
key_columns = longest > 56 ? 1 : longest > 34 ? 2 : 3
key_rows = (curves + key_columns - 1) / key_columns
if (longest > SHORT_TITLE || curves > 20) {
  eval picture(800, 480 + 17 * key_rows, 14)
  set key at screen 0.5, screen 0.01 center bottom vertical maxrows key_rows font small
  set bmargin at screen (18.0 * key_rows + 55) / (height > 0 ? height : 480 + 17 * key_rows)
} else { set key outside right top }
if (curves == 1 && bys == 0) { unset key } # the axis names it
set grid lc rgb "#dddddd" lt 1
set xzeroaxis lt 1 lc rgb "#999999"
few = most <= FEW_POINTS
data(c) = sprintf("$curve%d", c)
# Ten symbols on a long curve; a short one has one at each point.
drawn = few ? "linespoints ps 0.7 pt symbol_of(c)" : curves > 1 ? "linespoints pn 10 ps 0.9 pt symbol_of(c)" : "lines"
plot for [c=1:curves] data(c) using 1:2 with @drawn lw 2 dt dashes(c) lc rgb colour(c) notitle, \
     for [c=1:curves] keyentry with @drawn lw 2 dt dashes(c) lc rgb colour(c) title entry(c)
