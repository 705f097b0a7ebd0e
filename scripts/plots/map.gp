# A map over two axes, x_column and by_columns[1], from its grid, x running fastest. Regions of the same text in y_columns[1] are filled,
# with a number in each and a list below; a column of numbers is shown by colours, with the boundaries of modes in it.
MOST = 60 # regions
set datafile columnheaders
y_column = by_columns[1]
z_column = y_columns[1]

# The nodes: values along the axes, the region and the number of each
stats table using (column(x_column)) name "all" nooutput
count = int(all_records)
array xs[count]
array ys_[count]
array region[count]
array z[count]
array name[MOST]
array note[MOST]
nx = ny = n = regions = 0
z_low = 1e999
z_high = -1e999
number(text) = text eq "inf" ? 1e999 : text eq "-inf" ? -1e999 : text eq "nan" || text eq "-" ? NaN : text + 0
place(text, more, i) = i > MOST ? MOST : i > regions ? (regions = i, name[i] = text, note[i] = more, i) : \
                       name[i] eq text ? i : place(text, more, i + 1)
take(x, y, text, more, value) = (n = n + 1, ny = n == 1 || y != ys_[ny] ? ny + 1 : ny, ys_[ny] = y, \
                                 nx = ny == 1 ? n : nx, xs[ny == 1 ? n : 1] = ny == 1 ? x : xs[1], \
                                 region[n] = place(text, more, 1), z[n] = value, \
                                 value - value == 0 ? (z_low = value < z_low ? value : z_low, z_high = value > z_high ? value : z_high) : 0, 0)
is_regions = z_column eq "modes" || z_column eq "regime"
set table $nodes
plot table using (take(column(x_column), column(y_column), strcol(is_regions ? z_column : "modes"), strcol("regime"), \
                       is_regions ? NaN : number(strcol(z_column)))) with table
unset table
if (n != nx * ny) { exit error "the rows are not those of a whole grid" }
unset datafile
set datafile separator whitespace
at(i, j) = (j - 1) * nx + i
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
do for [j=1:ny] { do for [i=1:nx] {
  across[at(i, j)] = (alike(x_column, xs[i]) && i > 1 && i < nx && of(i - 1, j) != of(i, j) && of(i + 1, j) != of(i, j) ? 1 : 0) \
                     + (alike(y_column, ys_[j]) && j > 1 && j < ny && of(i, j - 1) != of(i, j) && of(i, j + 1) != of(i, j) ? 2 : 0)
} }
thin(i, j) = across[at(i, j)] > 0
seen(i, j, dx, dy, far) = far == 0 || !thin(i, j) ? of(i, j) : \
                          seen(i + (across[at(i, j)] == 2 ? 0 : dx), j + (across[at(i, j)] == 1 ? 0 : dy), dx, dy, far - 1)

# Parts of a region that hang together along rows and columns: a part is called by its least node.
array part[n]
do for [c=1:n] { part[c] = c }
least(c, d) = region[c] == region[d] && part[d] < part[c] ? (part[c] = part[d], 1) : 0
near(i, j, i2, j2) = i2 < 1 || j2 < 1 || i2 > nx || j2 > ny ? 0 : least(at(i, j), at(i2, j2))
changed = 1
while (changed > 0) {
  changed = 0
  do for [j=1:ny] { do for [i=1:nx] { changed = changed + near(i, j, i - 1, j) + near(i, j, i, j - 1) } }
  do for [j=ny:1:-1] { do for [i=nx:1:-1] { changed = changed + near(i, j, i + 1, j) + near(i, j, i, j + 1) } }
}

# The number of a region stands in each part where the way out of it is longest, along the row, and along the column, of a node.
array best[n]
array best_i[n]
array best_j[n]
array size[n]
do for [c=1:n] { best[c] = -1; size[c] = 0 }
way(i, j, di, dj, k, far) = i < 1 || j < 1 || i > nx || j > ny ? far * 0.8 + 0.3 : region[at(i, j)] != k ? far : \
                            far > 40 ? far : way(i + di, j + dj, di, dj, k, far + 1)
score(i, j, k) = (a = way(i, j, -1, 0, k, 0), b = way(i, j, 1, 0, k, 0), c = way(i, j, 0, -1, k, 0), d = way(i, j, 0, 1, k, 0), \
                  e = (a < b ? a : b), f = (c < d ? c : d), (e < f ? e : f) + 0.01 * (e + f))
do for [j=1:ny] { do for [i=1:nx] {
  p = part[at(i, j)]
  size[p] = size[p] + 1
  now = score(i, j, region[p])
  if (now > best[p]) { best[p] = now; best_i[p] = i; best_j[p] = j }
} }

# Cells, and where three corners of a square between nodes are of one region and the fourth is not, the corner that is cut off
colours = "#cfe2f7 #fbe0ae #d5ecd0 #f6cfd3 #dcd3ee #e3e3e3 #c4ebea #f3ecb4 #e9d2bd #d9e3f0 #f9d9ec #cbd9b0"
fill(k) = int(sprintf("0x%s", word(colours, (k - 1) % 12 + 1)[2:7]))
seam = 0.52 # half of a cell, and a little more
over = seam - 0.5
cell(i, j, left, right, low, high, k) = sprintf("%.10g %.10g %.10g %.10g %.10g %.10g %d %.10g", px(i), py(j), px(i + left), px(i + right), \
                                                py(j + low), py(j + high), fill(k), z[at(i, j)])
set print $cells
do for [j=1:ny] { do for [i=1:nx] {
  if (!thin(i, j)) {
    print cell(i, j, -seam, seam, -seam, seam, of(i, j))
  } else {
    do for [dx=-1:1:2] { do for [dy=-1:1:2] {
      print cell(i, j, dx < 0 ? -seam : -over, dx < 0 ? over : seam, dy < 0 ? -seam : -over, dy < 0 ? over : seam, seen(i, j, dx, dy, 3))
    } }
  }
} }

# Squares between four nodes. Where one corner is of another region than the three others, that region is cut off there; a boundary goes
# from the middle of an edge to that of the next. Else it goes through the centre.
point(x, y) = sprintf("%.10g %.10g", px(x), py(y))
set print $corners
print "NaN NaN 0"
corner(i, j, c) = seen(i + c % 2, j + c / 2, 1 - 2 * (c % 2), 1 - 2 * (c / 2), 3) # c: 0 south-west, 1 south-east, 2 and 3 north
do for [j=1:ny-1] { do for [i=1:nx-1] { do for [c=0:3] {
  oi = i + c % 2
  oj = j + c / 2
  next = corner(i, j, 3 - c)
  if (next != corner(i, j, c) && next == corner(i, j, (c + 2) % 4) && next == corner(i, j, c + 1 - 2 * (c % 2))) {
    sx = oi == i ? over : -over
    sy = oj == j ? over : -over
    print sprintf("\n%s %d\n%s %d\n%s %d\n%s %d\n%s %d\n", point(i + 0.5, oj), fill(next), point(i + 0.5 + sx, oj), fill(next), \
                  point(i + 0.5 + sx, j + 0.5 + sy), fill(next), point(oi, j + 0.5 + sy), fill(next), point(oi, j + 0.5), fill(next))
  }
} } }
set print $lines
print "NaN NaN"
half_way(x, y, i, j) = sprintf("\n%s\n%s\n", point(x, y), point(i, j))
do for [j=1:ny-1] { do for [i=1:nx-1] {
  south = corner(i, j, 0) != corner(i, j, 1)
  north = corner(i, j, 2) != corner(i, j, 3)
  west = corner(i, j, 0) != corner(i, j, 2)
  east = corner(i, j, 1) != corner(i, j, 3)
  if (south + north + west + east == 2 && south != north) {
    print half_way(i + 0.5, south ? j : j + 1, west ? i : i + 1, j + 0.5)
  } else {
    if (south) { print half_way(i + 0.5, j, i + 0.5, j + 0.5) }
    if (north) { print half_way(i + 0.5, j + 1, i + 0.5, j + 0.5) }
    if (west) { print half_way(i, j + 0.5, i + 0.5, j + 0.5) }
    if (east) { print half_way(i + 1, j + 0.5, i + 0.5, j + 0.5) }
  }
} }
# From a thin node half-way to each node of its region beside it, with corners only where no side is of the region; and all the way to a
# thin one of another region that the line runs into
set print $thin
print "NaN NaN 0"
inside(i, j) = i > 0 && j > 0 && i <= nx && j <= ny
same(i, j, k) = inside(i, j) ? of(i, j) == k : 0
do for [j=1:ny] { do for [i=1:nx] { if (thin(i, j)) { do for [dx=-1:1] { do for [dy=-1:1] {
  k = of(i, j)
  if ((dx != 0 || dy != 0) && same(i + dx, j + dy, k) && (dx * dy == 0 || !(same(i + dx, j, k) || same(i, j + dy, k)))) {
    print sprintf("\n%s %d\n%s %d\n", point(i, j), fill(k), point(i + 0.5 * dx, j + 0.5 * dy), fill(k))
  } else { if (dx * dy == 0 && across[at(i, j)] == (dx == 0 ? 1 : 2) && inside(i + dx, j + dy) && thin(i + dx, j + dy)) {
    print sprintf("\n%s %d\n%s %d\n", point(i, j), fill(k), point(i + dx, j + dy), fill(k))
  } }
} } } } }
unset print
# Regions that are thin throughout
array is_line[regions]
do for [k=1:regions] { is_line[k] = 1 }
do for [c=1:n] { if (across[c] == 0) { is_line[region[c]] = 0 } }

rows = (regions + 1) / 2
eval picture(900, 640 + 20 * (is_regions ? rows : 0), 13)
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
do for [c=1:n] { if (size[c] > 0 && (largest[region[c]] == 0 || size[c] > size[largest[region[c]]])) { largest[region[c]] = c } }
set print $numbers
print "NaN NaN 0"
do for [c=1:n] { if (size[c] > NOT_SMALL * n || largest[region[c]] == c) {
  print sprintf("%.10g %.10g %d", px(best_i[c]), py(best_j[c]), region[c])
} }
unset print
if (is_regions) {
  set key at screen 0.5, screen 0.01 center bottom vertical Left reverse noenhanced samplen 2 maxrows rows width 2 font mono
  set bmargin at screen (17.0 * rows + 62) / (height > 0 ? height : 640 + 20 * rows)
  entry(k) = sprintf("%2d  %s%s", k, name[k], z_column eq "modes" && note[k] ne name[k] ? "  " . note[k] : "")
  set style fill solid noborder
  set style textbox opaque border lc rgb "black"
  plot $cells using 1:2:3:4:5:6:7 with boxxyerror lc rgb variable fs solid notitle, \
       $corners using 1:2:3 with filledcurves closed lc rgb variable fs solid notitle, \
       $lines using 1:2 with lines lw 1.6 lc rgb "black" notitle, \
       $thin using 1:2 with lines lw 5 lc rgb "black" notitle, \
       $thin using 1:2:3 with lines lw 3 lc rgb variable notitle, \
       $numbers using (is_line[$3 > 0 ? $3 : 1] ? $1 : NaN):2:3 with labels boxed font "DejaVu Sans Bold,".(kind eq "png" ? 17 : 13) notitle, \
       $numbers using (is_line[$3 > 0 ? $3 : 1] ? NaN : $1):2:3 with labels font "DejaVu Sans Bold,".(kind eq "png" ? 17 : 13) notitle, \
       for [k=1:regions] keyentry with boxes lc rgb fill(k) fs solid border lc rgb "#555555" title entry(k)
} else {
  unset key
  logarithmic = z_low > 0 && z_high > 100 * z_low && z_high < 1e300
  if (logarithmic) { set logscale cb; set format cb "10^{%T}" }
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
