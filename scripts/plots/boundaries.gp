# The boundaries between the regions of a map, over the axes x_column and by_columns[1], as the parts of them in the cells of a grid; on both
# sides of the boundary of two regions the number of the region that is there, and a list of them below.
MOST = 60 # regions
set datafile columnheaders
y_column = by_columns[1]
to_x = "to_".x_column
to_y = "to_".y_column
array name[MOST]
regions = 0
place(text, i) = i > MOST ? MOST : i > regions ? (regions = i, name[i] = text, i) : name[i] eq text ? i : place(text, i + 1)
set table $all
plot table using (place(strcol("region_1"), 1) + place(strcol("region_2"), 1)) with table
unset table
stats table using (column(x_column)):(column(y_column)) name "begin" nooutput
stats table using (column(to_x)):(column(to_y)) name "end" nooutput
least(a, b) = a < b ? a : b
most(a, b) = a > b ? a : b
rows = (regions + 1) / 2
eval picture(900, 640 + 20 * rows, 13)
set title title noenhanced font small
set border 15 lw 1
set tics out nomirror
set xlabel axis(x_column) noenhanced
set ylabel axis(y_column) noenhanced
set rmargin 4
wide(low, high) = low > 0 && log10(high / low) > 3.999
x_low = has_x_range ? low_x : least(begin_min_x, end_min_x)
x_high = has_x_range ? high_x : most(begin_max_x, end_max_x)
y_low = has_y_range ? low_y : least(begin_min_y, end_min_y)
y_high = has_y_range ? high_y : most(begin_max_y, end_max_y)

# On both sides of each boundary a number, nearer to it than to any other, so that it is in its region: of some places the freest one.
ux(x) = log_x ? log10(x) : x
uy(y) = log_y ? log10(y) : y
across = ux(x_high) - ux(x_low)
up = uy(y_high) - uy(y_low)
px(x) = (ux(x) - ux(x_low)) / across
py(y) = (uy(y) - uy(y_low)) / up
MOST_PARTS = 20000
array mx[MOST_PARTS] # the middle of a part
array my[MOST_PARTS]
array dx[MOST_PARTS] # the way along it, region_1 being on the left
array dy[MOST_PARTS]
array pair[MOST_PARTS]
array count[MOST * MOST]
do for [k=1:MOST * MOST] { count[k] = 0 }
parts = 0
take(x1, y1, x2, y2, of) = (parts = parts + 1, mx[parts] = (x1 + x2) / 2, my[parts] = (y1 + y2) / 2, dx[parts] = x2 - x1, \
                            dy[parts] = y2 - y1, pair[parts] = of, count[of] = count[of] + 1, 0)
set table $all
plot table using (parts < MOST_PARTS ? take(px(column(x_column)), py(column(y_column)), px(column(to_x)), py(column(to_y)), \
                  (place(strcol("region_1"), 1) - 1) * MOST + place(strcol("region_2"), 1)) : 0) with table
unset table
set print $parts
print "x\ty\tpair"
do for [k=1:parts] { print sprintf("%.6f\t%.6f\t%d", mx[k], my[k], pair[k]) }
print "9\t9\t0" # never near
unset print
NEAR = 0.14 # of the picture: two numbers that are the same are not as near as this
MOST_NUMBERS = 200
array at_x[MOST_NUMBERS]
array at_y[MOST_NUMBERS]
array number[MOST_NUMBERS]
numbers = 0
set print $numbers
print "x\ty\tnumber"
do for [of=1:regions * MOST] { if (count[of] > 0) {
  do for [side=-1:1:2] {
    best = -1
    seen = 0
    do for [k=1:parts] { if (pair[k] == of) {
      seen = seen + 1
      long = sqrt(dx[k]**2 + dy[k]**2)
      if (long > 0 && seen % (count[of] / 9 + 1) == 0) { do for [away in "0.005 0.01 0.018 0.025"] {
        nx = mx[k] - side * dy[k] / long * away
        ny = my[k] + side * dx[k] / long * away
        if (nx > 0.02 && nx < 0.98 && ny > 0.02 && ny < 0.98) {
          stats $parts using (column(3) == of ? NaN : sqrt((column(1) - nx)**2 + (column(2) - ny)**2)) name "way" nooutput
          free = way_min < 1.2 * away ? -1 : away + least(way_min, 0.1)
          if (free > best) { best = free; best_x = nx; best_y = ny }
        }
      } }
    } }
    region = side > 0 ? (of - 1) / MOST + 1 : (of - 1) % MOST + 1
    is_new = best > 0 && numbers < MOST_NUMBERS
    do for [n=1:numbers] { if (number[n] == region && sqrt((at_x[n] - best_x)**2 + (at_y[n] - best_y)**2) < NEAR) { is_new = 0 } }
    if (is_new) {
      numbers = numbers + 1
      at_x[numbers] = best_x
      at_y[numbers] = best_y
      number[numbers] = region
      print sprintf("%.6f\t%.6f\t%d", best_x, best_y, region)
    }
  }
} }
unset print
vx(u) = log_x ? 10**(ux(x_low) + u * across) : x_low + u * across
vy(u) = log_y ? 10**(uy(y_low) + u * up) : y_low + u * up
if (log_x) { set logscale x; if (wide(x_low, x_high)) { set format x "10^{%T}" } else { set format x "%g" } }
if (log_y) { set logscale y; if (wide(y_low, y_high)) { set format y "10^{%T}" } else { set format y "%g" } }
if (x_low < x_high) { set xrange [x_low:x_high] }
if (y_low < y_high) { set yrange [y_low:y_high] }
set key at screen 0.5, screen 0.01 center bottom vertical Left reverse noenhanced samplen 0 maxrows rows width 2 font mono
set bmargin at screen (17.0 * rows + 62) / (height > 0 ? height : 640 + 20 * rows)
entry(k) = sprintf("%2d  %s", k, name[k])
plot table using (column(x_column)):(column(y_column)):(column(to_x) - column(x_column)):(column(to_y) - column(y_column)) \
       with vectors nohead lw 2 lc rgb "black" notitle, \
     table using (column(x_column)):(column(y_column)) with points pt 7 ps 0.15 lc rgb "black" notitle, \
     $numbers using (vx(column(1))):(vy(column(2))):3 with labels font "DejaVu Sans Bold,".(kind eq "png" ? 14 : 11) notitle, \
     for [k=1:regions] keyentry with points pt 7 ps 0 title entry(k)
