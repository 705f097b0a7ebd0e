# Where to write the number of each region of a map, from its grid: the node that is farthest from other regions. Prints number x y
# modes regime. Numbers go from the largest region on, but a region keeps the number that it has in other maps, whose numbers come first:
#   awk -f scripts/plots/map_labels.awk [NUMBERS...] GRID
BEGIN { FS = OFS = "\t" }
FNR == 1 { numbers = $1 == "number" }
/^#/ { next }
numbers { if (FNR > 1) { number[$4] = $1; if ($1 > last) last = $1 } next }
!named { for (i = 1; i <= NF; i++) at[$i] = i; named = 1; next }
{
  if (!($1 in column)) { column[$1] = columns++; xs[columns - 1] = $1 }
  if (!($2 in row)) { row[$2] = rows++; ys[rows - 1] = $2 }
  i = column[$1] "," row[$2]
  modes[i] = $(at["modes"])
  regime[$(at["modes"])] = $(at["regime"])
  size[$(at["modes"])]++
}
function near(x, y) { return x < 0 || y < 0 || x >= columns || y >= rows ? 0 : depth[x "," y] }
function same(x, y, m) { return x < 0 || y < 0 || x >= columns || y >= rows ? 1 : modes[x "," y] == m }
END {
  # depth: how many steps to another region; of the plane's edge half as much counts as well, so that no number stands on it
  for (d = 1; d <= columns && changed != 0 || d == 1; d++) {
    changed = 0
    for (y = 0; y < rows; y++)
      for (x = 0; x < columns; x++) {
        i = x "," y
        if (depth[i] != d - 1) continue
        edge = x < y ? x : y
        if (columns - 1 - x < edge) edge = columns - 1 - x
        if (rows - 1 - y < edge) edge = rows - 1 - y
        if (edge < d - 1) continue
        m = modes[i]
        if (d == 1) next_depth[i] = 1
        else if (near(x - 1, y) >= d - 1 && near(x + 1, y) >= d - 1 && near(x, y - 1) >= d - 1 && near(x, y + 1) >= d - 1 && same(x - 1, y, m) && same(x + 1, y, m) && same(x, y - 1, m) && same(x, y + 1, m)) next_depth[i] = d
      }
    for (i in next_depth) { depth[i] = next_depth[i]; changed++ }
    split("", next_depth)
  }
  for (y = 0; y < rows; y++)
    for (x = 0; x < columns; x++) {
      m = modes[x "," y]
      if (depth[x "," y] >= best[m]) { best[m] = depth[x "," y]; bx[m] = x; by[m] = y }
    }
  print "number", "x", "y", "modes", "regime"
  while (1) {
    most = 0
    for (m in size) if (size[m] > most || (size[m] == most && most > 0 && m < chosen)) { most = size[m]; chosen = m }
    if (most == 0) break
    if (!(chosen in number)) number[chosen] = ++last
    line[number[chosen]] = number[chosen] OFS xs[bx[chosen]] OFS ys[by[chosen]] OFS chosen OFS regime[chosen]
    delete size[chosen]
  }
  for (n = 1; n <= last; n++) if (n in line) print line[n]
}
