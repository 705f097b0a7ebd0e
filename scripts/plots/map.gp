# A map over two axes, x_column and by_columns[1], from its grid, x running fastest. A column of numbers, y_columns[1], is shown by colours,
# with the boundaries of modes in it, if the table has them; of words regions are filled, with a number in each and a list below.
MOST = 60    # regions; of more the largest, and one that is called "all others"
KNOWN = 200  # regions that are told apart, in the order of the rows: gnuplot calls a function from itself 249 times at most
y_column = by_columns[1]
z_column = y_columns[1]

# Which columns there are: the first line that is no note, as one cell
set datafile separator "\001"
head = ""
set table $void
plot table using (strlen(head) == 0 ? (head = "\t" . strcol(1) . "\t", 1) : 1) with table
unset table
has(name) = strstrt(head, "\t" . name . "\t") > 0
set datafile separator "\t"
set datafile columnheaders

# The nodes: values along the axes, the region and the number of each
stats table using (column(x_column)) name "all" nooutput
count = int(all_records)
array xs[count]
array ys_[count]
array region[count]
array z[count]
array name[KNOWN]
array note[KNOWN]
nx = ny = n = regions = words = 0
z_low = 1e999
z_high = -1e999
is_digits(text) = is_number(text) && strstrt(text, " ") == 0 # modes may begin with a 0
is_value(text) = is_digits(text) || text eq "inf" || text eq "-inf" || text eq "nan" || text eq "-"
number(text) = text eq "inf" ? 1e999 : text eq "-inf" ? -1e999 : is_digits(text) ? text + 0 : NaN
place(text, more, i) = i > regions ? (regions = i, name[i] = i < KNOWN ? text : "", note[i] = more, i) : \
                       i == KNOWN || name[i] eq text ? i : place(text, more, i + 1)
take(x, y, text, value) = (n = n + 1, ny = n == 1 || y != ys_[ny] ? ny + 1 : ny, ys_[ny] = y, nx = ny == 1 ? n : nx, \
                           xs[ny == 1 ? n : 1] = ny == 1 ? x : xs[1], words = words + !is_value(text), z[n] = value, \
                           value - value == 0 ? (z_low = value < z_low ? value : z_low, z_high = value > z_high ? value : z_high) : 0, 0)
set table $void
plot table using (take(column(x_column), column(y_column), strcol(z_column), number(strcol(z_column)))) with table
unset table
is_regions = words > 0
region_column = is_regions ? z_column : "modes"
note_column = region_column eq "modes" && has("regime") ? "regime" : region_column
n = 0
set table $void
if (has(region_column)) { plot table using (n = n + 1, region[n] = place(strcol(region_column), strcol(note_column), 1)) with table } \
else { plot table using (n = n + 1, region[n] = place("", "", 1)) with table }
unset table
if (n != nx * ny) { exit error "the rows are not those of a whole grid" }
unset datafile
set datafile separator whitespace
# An expression of each node c, in the order of the rows, of which no row is written; a loop would be read anew for each node.
each(expression) = "set table $void; plot sample [k=1:n:1] '+' using (0) with table if ((c = int(k + 0.5), " . expression . ", 0)); unset table"
if (regions > MOST) {
  array nodes[KNOWN] # of each region, then its new number
  do for [k=1:KNOWN] { nodes[k] = 0 }
  eval each("nodes[region[c]] = nodes[region[c]] + 1")
  array large[MOST]
  array large_note[MOST]
  do for [r=1:MOST - 1] {
    most = 1
    do for [k=2:KNOWN - 1] { if (nodes[k] > nodes[most]) { most = k } }
    large[r] = name[most]
    large_note[r] = note[most]
    nodes[most] = -r
  }
  do for [r=1:MOST - 1] { name[r] = large[r]; note[r] = large_note[r] }
  name[MOST] = "all others"
  note[MOST] = ""
  eval each("region[c] = nodes[region[c]] < 0 ? -nodes[region[c]] : MOST")
  regions = MOST
}
at(i, j) = (j - 1) * nx + i
ci(c) = (c - 1) % nx + 1
cj(c) = (c - 1) / nx + 1
ux(x) = log_x ? log10(x) : x
uy(y) = log_y ? log10(y) : y
vx(u) = log_x ? 10**u : u
vy(u) = log_y ? 10**u : u
half(list_first, list_last, m) = m > 1 ? (list_last - list_first) / (m - 1) / 2.0 : 0.5
hx = half(ux(xs[1]), ux(xs[nx]), nx)
hy = half(uy(ys_[1]), uy(ys_[ny]), ny)
# Coordinates of a place between nodes: i and j are those of nodes, and 0.5 more is half-way to the next.
px(i) = vx(ux(xs[1]) + (i - 1) * 2 * hx)
py(j) = vy(uy(ys_[1]) + (j - 1) * 2 * hy)

# At F1 = F2 and at alpha = 1/2 the bodies, or the phases, are alike, and modes are others than on both sides, on that line alone: such a node
# is thin, and its region a line there. Seen from a side (dx, dy) a thin node is of the region there.
alike(name, value) = abs(value - (name eq "alpha" ? 0.5 : name eq "F1/F2" ? 1 : 1e999)) < 1e-9
array across[n] # 1: alone in its row, 2: in its column, 3: in both
of(i, j) = region[at(i, j)]
alone(x, i, m, c, step) = i > 1 && i < m && alike(x, step == 1 ? xs[i] : ys_[i]) && region[c - step] != region[c] && region[c + step] != region[c]
eval each("across[c] = alone(x_column, ci(c), nx, c, 1) + 2 * alone(y_column, cj(c), ny, c, nx)")
thin(i, j) = across[at(i, j)] > 0
array thins[n]
thin_count = 0
eval each("across[c] > 0 ? (thin_count = thin_count + 1, thins[thin_count] = c) : 0")
seen(i, j, dx, dy, far) = far == 0 || !thin(i, j) ? of(i, j) : \
                          seen(i + (across[at(i, j)] == 2 ? 0 : dx), j + (across[at(i, j)] == 1 ? 0 : dy), dx, dy, far - 1)

# Parts of a region that hang together along rows and columns: a part is called by one of its nodes, at which part[c] = c.
array part[n]
root(c) = part[c] == c ? c : (part[c] = part[part[c]], root(part[c]))
join(c, d) = region[c] == region[d] ? (a = root(c), b = root(d), a < b ? (part[b] = a) : (part[a] = b)) : 0
eval each("part[c] = c, ci(c) > 1 ? join(c, c - 1) : 0, cj(c) > 1 ? join(c, c - nx) : 0")
eval each("part[c] = root(c)")

# The number of a region stands in each part where the way out of it is longest, along the row, and along the column, of a node.
array west[n]
array east[n]
array south[n]
array north[n]
eval each("west[c] = ci(c) > 1 && region[c - 1] == region[c] ? west[c - 1] + 1 : 1, \
           south[c] = cj(c) > 1 && region[c - nx] == region[c] ? south[c - nx] + 1 : 1")
eval each("c = n + 1 - c, east[c] = ci(c) < nx && region[c + 1] == region[c] ? east[c + 1] + 1 : 1, \
           north[c] = cj(c) < ny && region[c + nx] == region[c] ? north[c + nx] + 1 : 1")
array best[n]
array best_i[n]
array best_j[n]
array size[n]
eval each("best[c] = -1, size[c] = 0")
least(a, b) = a < b ? a : b
way(far, room) = far > 40 ? 41 : far == room ? far * 0.8 + 0.3 : far # room: up to the edge of the map
score(i, j, c) = (e = least(way(west[c], i), way(east[c], nx + 1 - i)), f = least(way(south[c], j), way(north[c], ny + 1 - j)), \
                  least(e, f) + 0.01 * (e + f))
better(c, p, now) = (size[p] = size[p] + 1, now > best[p] ? (best[p] = now, best_i[p] = ci(c), best_j[p] = cj(c)) : 0)
eval each("better(c, part[c], score(ci(c), cj(c), c))")

# Cells, and where three corners of a square between nodes are of one region and the fourth is not, the corner that is cut off
colours = "#cfe2f7 #fbe0ae #d5ecd0 #f6cfd3 #dcd3ee #e3e3e3 #c4ebea #f3ecb4 #e9d2bd #d9e3f0 #f9d9ec #cbd9b0"
fill(k) = k == MOST ? 0xffffff : int(sprintf("0x%s", word(colours, (k - 1) % 12 + 1)[2:7]))
seam = 0.52 # half of a cell, and a little more
over = seam - 0.5
cell(i, j, left, right, low, high, k) = sprintf("%.10g %.10g %.10g %.10g %.10g %.10g %d %.10g", px(i), py(j), px(i + left), px(i + right), \
                                                py(j + low), py(j + high), fill(k), z[at(i, j)])
# Along a row a region is one cell.
array wide[n]
eval each("c = n + 1 - c, wide[c] = across[c] ? 0 : 1 + (is_regions && ci(c) < nx && region[c + 1] == region[c] ? wide[c + 1] : 0)")
begins(c) = wide[c] > 0 && (!is_regions || ci(c) == 1 || wide[c - 1] == 0 || region[c - 1] != region[c])
set table $cells
plot sample [k=1:n:1] '+' using (c = int(k + 0.5), cell(ci(c), cj(c), -seam, wide[c] - 1 + seam, -seam, seam, region[c])) with table \
  if (begins(int(k + 0.5)))
do for [t=1:thin_count] { plot sample [k=0:3:1] '+' using (c = thins[t], dx = 2 * (int(k + 0.5) % 2) - 1, dy = 2 * (int(k + 0.5) / 2) - 1, \
  cell(ci(c), cj(c), dx < 0 ? -seam : -over, dx < 0 ? over : seam, dy < 0 ? -seam : -over, dy < 0 ? over : seam, \
       seen(ci(c), cj(c), dx, dy, 3))) with table }
unset table

# Squares between four nodes. Where one corner is of another region than the three others, that region is cut off there; a boundary goes
# from the middle of an edge to that of the next. Else it goes through the centre.
point(x, y) = sprintf("%.10g %.10g", px(x), py(y))
corner(i, j, c) = seen(i + c % 2, j + c / 2, 1 - 2 * (c % 2), 1 - 2 * (c / 2), 3) # c: 0 south-west, 1 south-east, 2 and 3 north
array square[n]
squares = 0
is_mixed(c) = ci(c) < nx && cj(c) < ny && (region[c + 1] != region[c] || region[c + nx] != region[c] || region[c + nx + 1] != region[c])
eval each("is_mixed(c) ? (squares = squares + 1, square[squares] = c) : 0")
set print $corners
print "NaN NaN 0"
do for [k=1:squares] {
  i = ci(square[k])
  j = cj(square[k])
  do for [c=0:3] {
    oi = i + c % 2
    oj = j + c / 2
    next = corner(i, j, 3 - c)
    if (next != corner(i, j, c) && next == corner(i, j, (c + 2) % 4) && next == corner(i, j, c + 1 - 2 * (c % 2))) {
      sx = oi == i ? over : -over
      sy = oj == j ? over : -over
      print sprintf("\n%s %d\n%s %d\n%s %d\n%s %d\n", point(i + 0.5, oj), fill(next), point(i + 0.5 + sx, oj), fill(next), \
                    point(i + 0.5 + sx, j + 0.5 + sy), fill(next), point(oi, j + 0.5 + sy), fill(next), point(oi, j + 0.5), fill(next))
    }
  }
}
set print $lines
print "NaN NaN"
half_way(x, y, i, j) = sprintf("\n%s\n%s\n", point(x, y), point(i, j))
do for [k=1:squares] {
  i = ci(square[k])
  j = cj(square[k])
  is_south = corner(i, j, 0) != corner(i, j, 1)
  is_north = corner(i, j, 2) != corner(i, j, 3)
  is_west = corner(i, j, 0) != corner(i, j, 2)
  is_east = corner(i, j, 1) != corner(i, j, 3)
  if (is_south + is_north + is_west + is_east == 2 && is_south != is_north) {
    print half_way(i + 0.5, is_south ? j : j + 1, is_west ? i : i + 1, j + 0.5)
  } else {
    if (is_south) { print half_way(i + 0.5, j, i + 0.5, j + 0.5) }
    if (is_north) { print half_way(i + 0.5, j + 1, i + 0.5, j + 0.5) }
    if (is_west) { print half_way(i, j + 0.5, i + 0.5, j + 0.5) }
    if (is_east) { print half_way(i + 1, j + 0.5, i + 0.5, j + 0.5) }
  }
}
# From a thin node half-way to each node of its region beside it, with corners only where no side is of the region; and all the way to a
# thin one of another region that the line runs into
set print $thin
print "NaN NaN 0"
inside(i, j) = i > 0 && j > 0 && i <= nx && j <= ny
same(i, j, k) = inside(i, j) ? of(i, j) == k : 0
do for [t=1:thin_count] { do for [dx=-1:1] { do for [dy=-1:1] {
  i = ci(thins[t])
  j = cj(thins[t])
  k = of(i, j)
  if ((dx != 0 || dy != 0) && same(i + dx, j + dy, k) && (dx * dy == 0 || !(same(i + dx, j, k) || same(i, j + dy, k)))) {
    print sprintf("\n%s %d\n%s %d\n", point(i, j), fill(k), point(i + 0.5 * dx, j + 0.5 * dy), fill(k))
  } else { if (dx * dy == 0 && across[at(i, j)] == (dx == 0 ? 1 : 2) && inside(i + dx, j + dy) && thin(i + dx, j + dy)) {
    print sprintf("\n%s %d\n%s %d\n", point(i, j), fill(k), point(i + dx, j + dy), fill(k))
  } }
} } }
unset print
# Regions that are thin throughout
array is_line[regions]
do for [k=1:regions] { is_line[k] = 1 }
eval each("across[c] == 0 ? (is_line[region[c]] = 0) : 0")

# The list: as many columns as fit, as many rows as leave half of the height for the map, and texts as long as the columns are wide
text_of(k, most) = strlen(name[k]) > most ? name[k][1:most - 1] . "…" : name[k]
with_note(k) = region_column eq "modes" && note[k] ne name[k] ? "  " . note[k] : ""
entry(k, most) = sprintf("%2d  %s%s", k, text_of(k, most - 4 - strlen(with_note(k))), with_note(k))
LETTER = 7.0 # its width, and that of the box beside an entry, in pixels
BOX = 50
ROW = 17
wide_in = width > 0 ? width : 900
longest = 0
do for [k=1:regions] { longest = strlen(entry(k, 999)) > longest ? strlen(entry(k, 999)) : longest }
columns = int(wide_in / (LETTER * longest + BOX))
columns = columns < 1 ? 1 : columns > regions ? regions : columns
letters = int((wide_in / columns - BOX) / LETTER)
letters = letters < longest ? letters : longest
rows = (regions + columns - 1) / columns
most_rows = height > 0 ? int((height / 2.0 - 70) / ROW) : rows
rows = rows > most_rows ? (most_rows < 1 ? 1 : most_rows) : rows
listed = regions > rows * columns ? rows * columns - 1 : regions
high_in = height > 0 ? height : 650 + 20 * (is_regions ? rows : 0)
eval picture(900, 650 + 20 * (is_regions ? rows : 0), 13)
entry_x(k) = 0.5 + ((k - 1) / rows - columns / 2.0) * (LETTER * letters + BOX) / wide_in
entry_y(k) = (8 + ROW * (rows - 0.5 - (k - 1) % rows)) / high_in
set title title noenhanced font small
set border 15 lw 1
set tics out nomirror
set xlabel axis(x_column) noenhanced
set ylabel axis(y_column) noenhanced
wide(low, high) = low > 0 && log10(high / low) > 3.999
if (log_x) { set logscale x; if (wide(xs[1], xs[nx])) { set format x "10^{%T}" } else { set format x "%g" } }
if (log_y) { set logscale y; if (wide(ys_[1], ys_[ny])) { set format y "10^{%T}" } else { set format y "%g" } }
set xrange [has_x_range ? low_x : px(nx > 1 ? 1 : 0.5) : has_x_range ? high_x : px(nx > 1 ? nx : 1.5)]
set yrange [has_y_range ? low_y : py(ny > 1 ? 1 : 0.5) : has_y_range ? high_y : py(ny > 1 ? ny : 1.5)]
set rmargin 4
# The largest part of each region has a number, and each that is not small.
NOT_SMALL = 0.02 # of the map
array largest[regions]
do for [k=1:regions] { largest[k] = 0 }
eval each("size[c] > 0 && (largest[region[c]] == 0 || size[c] > size[largest[region[c]] > 0 ? largest[region[c]] : 1]) ? (largest[region[c]] = c) : 0")
set print $numbers
print "NaN NaN 0"
array numbered[n]
numbers = 0
eval each("size[c] > NOT_SMALL * n || largest[region[c]] == c ? (numbers = numbers + 1, numbered[numbers] = c) : 0")
do for [k=1:numbers] { print sprintf("%.10g %.10g %d", px(best_i[numbered[k]]), py(best_j[numbered[k]]), region[numbered[k]]) }
unset print
if (is_regions) {
  unset key
  set bmargin at screen (ROW * rows + 70.0) / high_in
  do for [k=1:listed] {
    set object k rectangle from screen entry_x(k) + 10.0 / wide_in, entry_y(k) - 4.0 / high_in to screen entry_x(k) + 30.0 / wide_in, entry_y(k) + 4.0 / high_in \
      fillcolor rgb fill(k) fillstyle solid border lc rgb "#555555"
    set label k entry(k, letters) at screen entry_x(k) + 38.0 / wide_in, entry_y(k) left noenhanced font mono
  }
  if (listed < regions) { set label regions sprintf("    %d more", regions - listed) at screen entry_x(listed + 1) + 38.0 / wide_in, entry_y(listed + 1) left noenhanced font mono }
  set style fill solid noborder
  set style textbox opaque border lc rgb "black"
  plot $cells using 1:2:3:4:5:6:7 with boxxyerror lc rgb variable fs solid notitle, \
       $corners using 1:2:3 with filledcurves closed lc rgb variable fs solid notitle, \
       $lines using 1:2 with lines lw 1.6 lc rgb "black" notitle, \
       $thin using 1:2 with lines lw 5 lc rgb "black" notitle, \
       $thin using 1:2:3 with lines lw 3 lc rgb variable notitle, \
       $numbers using (is_line[$3 > 0 ? $3 : 1] ? $1 : NaN):2:3 with labels boxed font "DejaVu Sans Bold,".(kind eq "png" ? 17 : 13) notitle, \
       $numbers using (is_line[$3 > 0 ? $3 : 1] ? NaN : $1):2:3 with labels font "DejaVu Sans Bold,".(kind eq "png" ? 17 : 13) notitle
} else {
  unset key
  logarithmic = z_low > 0 && z_high > 100 * z_low && z_high < 1e300
  if (logarithmic) { set logscale cb; set format cb "10^{%T}" }
  if (z_low > z_high) { set cbrange [0:1] } # no value is finite
  set palette defined (0 "#3b1f6b", 1 "#2f5d9b", 2 "#2a9d8f", 3 "#9fcf6f", 4 "#fff3a0")
  set cblabel axis(z_column) noenhanced
  set rmargin at screen 0.82
  set cblabel offset 1,0
  set colorbox user origin screen 0.85,0.2 size 0.025,0.6
  plot $cells using 1:2:3:4:5:6:($8 - $8 == 0 ? $8 : NaN) with boxxyerror fs solid noborder fc palette notitle, \
       $cells using ($8 - $8 == 0 ? NaN : $1):2:3:4:5:6 with boxxyerror lc rgb "#dddddd" fs solid notitle, \
       $lines using 1:2 with lines lw 1.2 lc rgb "white" notitle, \
       $thin using 1:2 with lines lw 1.2 lc rgb "white" notitle
}
