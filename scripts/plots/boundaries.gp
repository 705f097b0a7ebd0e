# The curves between the regions of a map, over the axes x_column and by_columns[1], followed one by one; on both sides of each the
# number of the region that is there, and a list of them below.
MOST = 60 # regions
set datafile columnheaders
y_column = by_columns[1]
array name[MOST]
regions = 0
curves = 0
place(text, i) = i > MOST ? MOST : i > regions ? (regions = i, name[i] = text, i) : name[i] eq text ? i : place(text, i + 1)
set table $all
plot table using (c = int(column("curve")), curves = c > curves ? c : curves, place(strcol("region_1"), 1) + place(strcol("region_2"), 1)) \
     with table
unset table
stats table using (column(x_column)):(column(y_column)) name "seen" nooutput
rows = (regions + 1) / 2
eval picture(900, 640 + 20 * rows, 13)
set title title noenhanced font small
set border 15 lw 1
set tics out nomirror
set xlabel axis(x_column) noenhanced
set ylabel axis(y_column) noenhanced
set rmargin 4
wide(low, high) = low > 0 && log10(high / low) > 3.999
x_low = has_x_range ? low_x : seen_min_x
x_high = has_x_range ? high_x : seen_max_x
y_low = has_y_range ? low_y : seen_min_y
y_high = has_y_range ? high_y : seen_max_y

# On both sides of each curve a number, nearer to the curve than to any other, so that it is in its region: of some places the freest one.
ux(x) = log_x ? log10(x) : x
uy(y) = log_y ? log10(y) : y
across = ux(x_high) - ux(x_low)
up = uy(y_high) - uy(y_low)
MOST_POINTS = 20000
array px[MOST_POINTS]
array py[MOST_POINTS]
array of[MOST_POINTS]
array left[MOST_POINTS]
array right[MOST_POINTS]
points = 0
take(c, x, y, one, two) = (points = points + 1, of[points] = int(c), px[points] = (ux(x) - ux(x_low)) / across, \
                           py[points] = (uy(y) - uy(y_low)) / up, left[points] = place(one, 1), right[points] = place(two, 1), 0)
set table $all
plot table using (points < MOST_POINTS ? take(column("curve"), column(x_column), column(y_column), strcol("region_1"), strcol("region_2")) : 0) \
     with table
unset table
set print $points
print "x\ty\tcurve"
do for [k=1:points] { print sprintf("%.6f\t%.6f\t%d", px[k], py[k], of[k]) }
print sprintf("9\t9\t%d", curves + 1) # never near
unset print
NEAR = 0.14 # of the picture: two numbers that are the same are not as near as this
MOST_NUMBERS = 200
array at_x[MOST_NUMBERS]
array at_y[MOST_NUMBERS]
array number[MOST_NUMBERS]
numbers = 0
set print $numbers
print "x\ty\tnumber"
first = 1
do for [k=1:points] { if (k == points || of[k + 1] != of[k]) {
  do for [side=-1:1:2] {
    best = -1
    do for [part=1:9] { do for [away in "0.005 0.01 0.018 0.025"] {
      at = first + int((k - first) * part / 10.0)
      from = at > first ? at - 1 : at
      to = at < k ? at + 1 : at
      dx = px[to] - px[from]
      dy = py[to] - py[from]
      long = sqrt(dx**2 + dy**2)
      x = px[at] + (long > 0 ? side * dy / long * away : 0)
      y = py[at] - (long > 0 ? side * dx / long * away : 0)
      if (long > 0 && x > 0.02 && x < 0.98 && y > 0.02 && y < 0.98) {
        stats $points using (column(3) == of[k] ? NaN : sqrt((column(1) - x)**2 + (column(2) - y)**2)) name "way" nooutput
        free = way_min < 1.2 * away ? -1 : away + (way_min < 0.1 ? way_min : 0.1)
        if (free > best) { best = free; best_x = x; best_y = y }
      }
    } }
    region = side < 0 ? left[first] : right[first]
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
  first = k + 1
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
plot for [c=1:curves] table using (int(column("curve")) == c ? column(x_column) : NaN):(column(y_column)) with lines lw 2 lc rgb "black" notitle, \
     $numbers using (vx(column(1))):(vy(column(2))):3 with labels font "DejaVu Sans Bold,".(kind eq "png" ? 14 : 11) notitle, \
     for [k=1:regions] keyentry with points pt 7 ps 0 title entry(k)
