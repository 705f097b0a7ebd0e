# A map over two axes, from its grid, x running fastest: a column of numbers in colours, with the boundaries of modes; of words regions are filled,
# with a number in each and a list below.
function choose_axes_of_map(   axis, part) {
  picture = picture == "" ? of : picture
  if (x != "" || bys > 0)
    refuse("the axes of a map are those of --map")
  if (ys > 1)
    refuse("a map shows one column")
  if (picture == "map" && ys == 0)
    y[ys = 1] = "regime" in at ? "regime" : "modes"
  for (axis in axis_of_map) {
    split(axis_of_map[axis], part, /,? /) # F1/F2 from 0.1 to 10, 41 values, log
    axis_of_map[axis] = part[1]
    stretch(axis, part[3])
    stretch(axis, part[5])
    is_log[axis] = part[8] == "log"
  }
  x = axis_of_map["x"]
  by[bys = 1] = axis_of_map["y"]
  title = title == "" ? held : title
  if (x == "" || by[1] == "")
    refuse("the table has no axes of a map")
}

# Along the axes: given[axis, i], count[axis] of them; of the nodes: number[i, j] of their region, and z[i, j], what is shown.
function read_grid(   n, i, j, modes, regime, text, nodes, kinds, least_nodes, larger, spare) {
  for (n = 1; n <= rows; n++) {
    go(n)
    if (n == 1 || v(by[1]) != given["y", j]) {
      given["y", ++j] = v(by[1])
      i = 0
    }
    given["x", ++i] = v(x)
    z[i, j] = v(y[1])
    modes[i, j] = v("modes")
    regime[i, j] = v("regime")
    has_words = has_words || !is_number(z[i, j]) && z[i, j] !~ /^(-|nan|-?inf)$/
  }
  count["x"] = i
  count["y"] = j
  if (i * j != rows)
    refuse("the rows are not those of a whole grid")
  for (n in z)
    kinds += nodes[has_words ? z[n] : modes[n]]++ == 0
  do { # of more than 60 regions 59 of the largest, and one of all others
    larger = 0
    least_nodes++
    for (text in nodes)
      larger += nodes[text] > least_nodes
  } while (larger > 59)
  spare = kinds > 60 ? 59 - larger : kinds
  for (j = 1; j <= count["y"]; j++)
    for (i = 1; i <= count["x"]; i++) {
      text = has_words ? z[i, j] : modes[i, j]
      if (!(text in region_number) && nodes[text] <= least_nodes && spare-- <= 0)
        region_number[text] = 60
      number[i, j] = number_of(text, (!has_words || y[1] == "modes") && regime[i, j] != text && regime[i, j] != "" ? "  " regime[i, j] : "")
    }
  if (kinds > 60)
    region[regions = 60] = "all others"
}
function number_of(text, more) {
  if (!(text in region_number)) {
    region[region_number[text] = ++regions] = text
    note[regions] = more
  }
  return region_number[text]
}

# Places of nodes along an axis, and edges half-way between them. At F1 = F2 and at alpha = 1/2 the bodies, or the phases, are alike, and modes can
# be others than on both sides, on that line alone: its cells are narrow.
function is_line(axis, i) {
  return i > 1 && i < count[axis] && (axis_of_map[axis] == "F1/F2" && abs(given[axis, i] - 1) < 1e-9 || \
    axis_of_map[axis] == "alpha" && abs(given[axis, i] - 0.5) < 1e-9)
}
function lay_out(axis, narrow,   i, m, half) {
  m = count[axis]
  for (i = 1; i <= m; i++)
    u[axis, i] = place(axis, given[axis, i])
  half = m > 1 ? 0 : 0.5
  edge[axis, 0] = u[axis, 1] - half
  edge[axis, m] = u[axis, m] + half
  seam[axis] = 0.001 * (edge[axis, m] - edge[axis, 0])
  narrow *= edge[axis, m] - edge[axis, 0]
  for (i = 1; i < m; i++)
    edge[axis, i] = narrow && is_line(axis, i) ? u[axis, i] + narrow : narrow && is_line(axis, i + 1) ? u[axis, i + 1] - narrow : \
      (u[axis, i] + u[axis, i + 1]) / 2
}
function place(axis, value) { return is_log[axis] ? log10(value) : value + 0 }
function value(axis, p) { return is_log[axis] ? 10 ^ p : p }
function point(across, up) { return sprintf("%.10g\t%.10g", value("x", across), value("y", up)) }

# Along a row a region is one cell. Cells overlap a little: else there would be seams.
function put_cells(   i, j, first) {
  for (j = 1; j <= count["y"]; j++)
    for (i = first = 1; i <= count["x"]; i++)
      if (!has_words || i == count["x"] || number[i + 1, j] != number[i, j]) {
        put(has_words || is_number(z[i, j]) ? "cells" : "holes", point(edge["x", first - 1], edge["y", j - 1]) "\t" \
          point(edge["x", i] + seam["x"], edge["y", j] + seam["y"]) "\t" (has_words ? fill(number[i, j]) : z[i, j]))
        stretch("z", z[i, j])
        first = i + 1
      }
}
function fill(k) {
  return region[k] == "all others" ? 16777215 : word(k, "13624055 16507054 14019792 16175059 14472174 14935011 12904170 15985844 " \
    "15323857 14277616 16374252 13359536")
}

# Squares between four nodes: a boundary goes from the middle of an edge to the centre. Where one corner is of another region than the three others,
# it is cut off: the boundary goes to the middle of the next edge.
function put_boundaries(   i, j, west, east, south, north, ends, k, n) {
  for (j = 1; j < count["y"]; j++)
    for (i = 1; i < count["x"]; i++) {
      south = number[i, j] != number[i + 1, j]
      north = number[i, j + 1] != number[i + 1, j + 1]
      west = number[i, j] != number[i, j + 1]
      east = number[i + 1, j] != number[i + 1, j + 1]
      n = 0
      if (south)
        ends[++n] = point(edge["x", i], u["y", j])
      if (north)
        ends[++n] = point(edge["x", i], u["y", j + 1])
      if (west)
        ends[++n] = point(u["x", i], edge["y", j])
      if (east)
        ends[++n] = point(u["x", i + 1], edge["y", j])
      if (n == 2 && south != north) {
        put("lines", ends[1] "\n" ends[2] "\n")
        cut_corner(edge["x", i], edge["y", j], u["x", i + !west], u["y", j + !south], fill(number[i + west, j + south]))
      } else
        for (k = 1; k <= n; k++)
          put("lines", ends[k] "\n" point(edge["x", i], edge["y", j]) "\n")
    }
}
# What is beyond the line from (cx, ny) to (nx, cy), up to the centre (cx, cy) and over the seams, is of the other region.
function cut_corner(cx, cy, nx, ny, tint,   ox, oy) {
  ox = cx + (nx < cx ? 1 : -1) * seam["x"]
  oy = cy + (ny < cy ? 1 : -1) * seam["y"]
  tint = "\t" tint "\n"
  put("corners", point(cx, ny) tint point(ox, ny) tint point(ox, oy) tint point(nx, oy) tint point(nx, cy) tint)
}

# Parts of a region that hang together along rows and columns: a part is called by one of its nodes. The number of a region stands in its largest
# part, and in each that is not small, at the node from where the way out of the region is longest.
function root(n) {
  while (part[n] != n)
    n = part[n] = part[part[n]]
  return n
}
function put_numbers(   i, j, m, n, k, far, across, up, size, order, parts, best, spot, largest) {
  for (j = 1; j <= count["y"]; j++)
    for (i = 1; i <= count["x"]; i++) {
      n = part[i, j] = i SUBSEP j
      far["w", n] = number[i - 1, j] == number[n] ? far["w", i - 1, j] + 1 : 1
      far["s", n] = number[i, j - 1] == number[n] ? far["s", i, j - 1] + 1 : 1
      if (far["w", n] > 1)
        part[n] = root((i - 1) SUBSEP j)
      if (far["s", n] > 1)
        part[root(n)] = root(i SUBSEP (j - 1))
    }
  for (j = count["y"]; j > 0; j--)
    for (i = count["x"]; i > 0; i--) {
      n = i SUBSEP j
      far["e", n] = number[i + 1, j] == number[n] ? far["e", i + 1, j] + 1 : 1
      far["n", n] = number[i, j + 1] == number[n] ? far["n", i, j + 1] + 1 : 1
      across = min(way(far["w", n], i), way(far["e", n], count["x"] + 1 - i))
      up = min(way(far["s", n], j), way(far["n", n], count["y"] + 1 - j))
      m = root(n)
      if (size[m]++ == 0)
        order[++parts] = m
      if (min(across, up) + 0.01 * (across + up) > best[m]) {
        best[m] = min(across, up) + 0.01 * (across + up)
        spot[m] = n
      }
    }
  for (k = 1; k <= parts; k++) {
    m = order[k]
    if (size[m] > size[largest[number[m]]])
      largest[number[m]] = m
  }
  for (k = 1; k <= parts; k++) {
    m = order[k]
    if (region[number[m]] != "all others" && (size[m] > 0.02 * rows || largest[number[m]] == m))
      put_number(spot[m])
  }
}
function way(far, room) { return far > 40 ? 41 : far == room ? far * 0.8 + 0.3 : far } # room: up to the edge of the map
function put_number(n,   at_node, is_strip) {
  split(n, at_node, SUBSEP)
  is_strip = is_line("x", at_node[1]) && number[at_node[1] - 1, at_node[2]] != number[n] || \
    is_line("y", at_node[2]) && number[at_node[1], at_node[2] - 1] != number[n]
  put(is_strip ? "boxed" : "numbers", point(u["x", at_node[1]], u["y", at_node[2]]) "\t" number[n])
}

# The frame, and the list of regions below it, in as many columns as fit, and so long that it leaves half of a given height for the map
function begin_map(has_boxes,   k, letters, beside, deep, listed, across, up, text) {
  for (k = 1; k <= regions; k++)
    letters = max(letters, characters(region[k] note[k]) + 4)
  wide = size[1] ? size[1] : 900
  beside = max(1, min(regions, int(wide / (7 * letters + 50))))
  letters = min(letters, int((wide / beside - 50) / 7))
  deep = int((regions + beside - 1) / beside)
  if (size[2])
    deep = min(deep, max(1, int((size[2] / 2 - 70) / 17)))
  begin_picture(900, 650 + 20 * deep, 13)
  print "set border 15 lw 1\nset tics out nomirror\nset rmargin 4\nset bmargin at screen " (17 * deep + 70) / high "\nset key off"
  print "set xlabel " shown(axis_title(x)) " noenhanced\nset ylabel " shown(axis_title(by[1])) " noenhanced"
  listed = min(regions, deep * beside)
  for (k = 1; k <= listed; k++) {
    across = 0.5 + (int((k - 1) / deep) - beside / 2) * (7 * letters + 50) / wide
    up = (8 + 17 * (deep - 0.5 - (k - 1) % deep)) / high
    text = characters(region[k] note[k]) + 4 > letters ? substr(region[k], 1, letters - 5 - length(note[k])) "…" note[k] : region[k] note[k]
    text = k == listed && listed < regions ? "    " regions - k + 1 " more" : sprintf("%2d  %s", k, text)
    print "set label " shown(text) " at screen " across + 38 / wide ", screen " up " left noenhanced font mono"
    if (has_boxes && text !~ / more$/)
      print "set object rectangle center screen " across + 20 / wide ", screen " up " size screen " 20 / wide ", screen " 8 / high \
        " fillcolor rgb " fill(k) " fillstyle solid border lc rgb '#555555'"
  }
}
function plot_if(block, how) {
  if (block in lines_of)
    plot("$" block " using " how " notitle")
}

function draw_map(   axis) {
  read_grid()
  lay_out("x", has_words ? 0.003 : 0)
  lay_out("y", has_words ? 0.003 : 0)
  put_cells()
  lay_out("x", has_words ? 0.003 : 0.001)
  lay_out("y", has_words ? 0.003 : 0.001)
  put_boundaries()
  regions = has_words ? regions : 0
  begin_map(1)
  for (axis in count)
    set_axis(axis, value(axis, edge[axis, 0]), value(axis, edge[axis, count[axis]]), 1)
  if (has_words) {
    put_numbers()
    print "set style textbox opaque border lc rgb 'black'"
    plot_if("cells", "1:2:1:3:2:4:5 with boxxyerror lc rgb variable fs solid noborder")
    plot_if("corners", "1:2:3 with filledcurves closed lc rgb variable fs solid noborder")
    plot_if("lines", "1:2 with lines lw 1.6 lc rgb 'black'")
    plot_if("boxed", "1:2:3 with labels boxed font 'DejaVu Sans Bold'.letters(13)")
    plot_if("numbers", "1:2:3 with labels font 'DejaVu Sans Bold'.letters(13)")
  } else {
    if (least["z"] < most["z"])
      print "set cbrange [" least["z"] ":" most["z"] "]"
    if (least["z"] > 0 && most["z"] > 100 * least["z"])
      print "set logscale cb\nset format cb '10^{%T}'"
    print "set palette defined (0 '#3b1f6b', 1 '#2f5d9b', 2 '#2a9d8f', 3 '#9fcf6f', 4 '#fff3a0')\nset rmargin at screen 0.82"
    print "set colorbox user origin screen 0.85,0.2 size 0.025,0.6\nset cblabel " shown(axis_title(y[1])) " noenhanced offset 1,0"
    plot_if("cells", "1:2:1:3:2:4:5 with boxxyerror fs solid noborder fc palette")
    plot_if("holes", "1:2:1:3:2:4 with boxxyerror lc rgb '#dddddd' fs solid noborder")
    plot_if("lines", "1:2 with lines lw 1.2 lc rgb 'white'")
  }
  print_plot()
}
