# Columns of any table, in curves. Variables besides those of common.gp: title, x_column, arrays y_columns (ys of them) and by_columns (bys),
# flags log_x and log_y. A curve for each y column, and for each combination of values in the by columns.
MOST = 24         # combinations
FEW_POINTS = 40   # of a curve: each is marked
SHORT_TITLE = 26  # characters: the key stands beside the curves, not below
set datafile columnheaders

# The combinations of values, in the order of the rows
array combination[MOST]
combinations = 0
too_many = 0
joined(i) = i > bys ? "" : (i > 1 ? ", " : "") . strcol(by_columns[i]) . joined(i + 1)
place(text, i) = i > MOST ? (too_many = 1, 0) : i > combinations ? (combinations = i, combination[i] = text, 0) : \
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
row(c) = joined(1) eq combination[v(c)] ? point(c, column(x_column), column(y_columns[q(c)])) : ""
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
    low = axis eq "x" ? least_x : least_y
    high = axis eq "x" ? most_x : most_y
    eval sprintf("set logscale %s", axis)
    if (log10(high) - log10(low) > 2.999) {
      eval sprintf("set format %s '10^{%%T}'", axis)
    } else {
      if (low > 1e-300 && high < 1e300) {
        margin = high > low * (1 + 1e-6) ? (high / low)**0.04 : 1.1
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

# Colours tell the combinations apart and dashes the columns; without by_columns colours tell the columns apart.
colours = "#0b3c8c #c8102e #2a9d4a #b8860b #7b3fa0 #1b9aaa #000000 #888888"
hue(c) = bys > 0 ? v(c) : q(c)
colour(c) = word(colours, (hue(c) - 1) % 8 + 1)
dashes(c) = bys > 0 ? (q(c) - 1) % 5 + 1 : 1
symbol(c) = 5 + 2 * ((hue(c) - 1) % 5)
y_names(i) = i > ys ? "" : (i > 1 ? ", " : "") . y_columns[i] . y_names(i + 1)
by_names(i) = i > bys ? "" : (i > 1 ? ", " : "") . by_columns[i] . by_names(i + 1)
entry(c) = (ys > 1 || bys == 0 ? y_columns[q(c)] : "") . (ys > 1 && bys > 0 ? ", " : "") . \
           (bys > 0 ? by_names(1) . " = " . combination[v(c)] : "") . (shown[c] == 0 ? " (none)" : "")
longest = 0
most = 0
do for [c=1:curves] {
  longest = max(longest, strlen(entry(c)))
  most = max(most, shown[c])
}
set title title noenhanced
set xlabel x_column noenhanced
set ylabel y_names(1) noenhanced
set key noenhanced Left reverse
if (longest > SHORT_TITLE) { set key below left } else { set key outside right top }
if (curves == 1 && bys == 0) { unset key } # the axis names it
set grid lc rgb "#dddddd" lt 1
set xzeroaxis lt 1 lc rgb "#999999"
drawn = most > FEW_POINTS ? "lines" : "linespoints ps 0.6 pt symbol(c)"
data(c) = sprintf("$curve%d", c)
plot for [c=1:curves] data(c) using 1:2 with @drawn lw 2 dt dashes(c) lc rgb colour(c) notitle, \
     for [c=1:curves] keyentry with @drawn lw 2 dt dashes(c) lc rgb colour(c) title entry(c)
