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
if (log_x) { set logscale x; if (wide(x_low, x_high)) { set format x "10^{%T}" } else { set format x "%g" } }
if (log_y) { set logscale y; if (wide(y_low, y_high)) { set format y "10^{%T}" } else { set format y "%g" } }
if (x_low < x_high) { set xrange [x_low:x_high] }
if (y_low < y_high) { set yrange [y_low:y_high] }

# In the middle of each curve: what is on its left and on its right, a little way off, as the picture goes
ux(x) = log_x ? log10(x) : x
uy(y) = log_y ? log10(y) : y
vx(u) = log_x ? 10**u : u
vy(u) = log_y ? 10**u : u
across = ux(x_high) - ux(x_low)
up = uy(y_high) - uy(y_low)
AWAY = 0.02
NEAR = 0.12 # of the picture: two numbers that are the same are not as near as this
MOST_NUMBERS = 400
array at_x[MOST_NUMBERS]
array at_y[MOST_NUMBERS]
array number[MOST_NUMBERS]
numbers = 0
is_near(x, y, k, i) = i > numbers ? 0 : number[i] == k && sqrt((at_x[i] - x)**2 + (at_y[i] - y)**2) < NEAR ? 1 : is_near(x, y, k, i + 1)
set print $numbers
print "x\ty\tnumber"
do for [c=1:curves] {
  points = 0
  set table $one
  plot table using (int(column("curve")) == c ? (points = points + 1) : points) with table
  unset table
  if (points > 1) {
    middle = (points + 1) / 2
    first = middle > 1 ? middle - 1 : 1
    last = middle < points ? middle + 1 : points
    k = 0
    take(x, y, one, two) = (k = k + 1, k == first ? (x1 = x, y1 = y) : 0, k == last ? (x2 = x, y2 = y) : 0, \
                            k == middle ? (xm = x, ym = y, left = place(one, 1), right = place(two, 1)) : 0, 0)
    set table $one
    plot table using (int(column("curve")) == c ? take(column(x_column), column(y_column), strcol("region_1"), strcol("region_2")) : 0) with table
    unset table
    dx = (ux(x2) - ux(x1)) / across
    dy = (uy(y2) - uy(y1)) / up
    length = sqrt(dx**2 + dy**2)
    do for [side=-1:1:2] {
      x = (ux(xm) - ux(x_low)) / across + (length > 0 ? side * dy / length * AWAY : 0)
      y = (uy(ym) - uy(y_low)) / up - (length > 0 ? side * dx / length * AWAY : 0)
      region = side < 0 ? left : right
      if (numbers < MOST_NUMBERS && !is_near(x, y, region, 1)) {
        numbers = numbers + 1
        at_x[numbers] = x
        at_y[numbers] = y
        number[numbers] = region
        print sprintf("%.10g\t%.10g\t%d", vx(ux(x_low) + x * across), vy(uy(y_low) + y * up), region)
      }
    }
  }
}
unset print
set key at screen 0.5, screen 0.01 center bottom vertical Left reverse noenhanced samplen 0 maxrows rows width 2 font mono
set bmargin at screen (17.0 * rows + 62) / (height > 0 ? height : 640 + 20 * rows)
entry(k) = sprintf("%2d  %s", k, name[k])
plot for [c=1:curves] table using (int(column("curve")) == c ? column(x_column) : NaN):(column(y_column)) with lines lw 2 lc rgb "black" notitle, \
     $numbers using 1:2:3 with labels font "DejaVu Sans Bold,".(kind eq "png" ? 14 : 11) notitle, \
     for [k=1:regions] keyentry with points pt 7 ps 0 title entry(k)
