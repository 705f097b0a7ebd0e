# The boundaries between the regions of a map, as the parts of them in the cells of a grid, with the numbers of the regions on both sides, and a list
# of them below.
function draw_boundaries(   n, k, name, sides, order, counts) {
  split(x "\t" by[1] "\tto_" x "\tto_" by[1] "\tregion_1\tregion_2", name)
  need_all(name, 6)
  for (n = 1; n <= rows; n++) {
    go(n)
    for (k = 1; k <= 4; k++)
      stretch(k % 2 ? "x" : "y", end[n, k] = v(name[k]))
    sides_of[n] = sides = number_of(v("region_1"), "") "\t" number_of(v("region_2"), "")
    if (!(sides in counts))
      order[++pairs] = sides
    part[sides, ++counts[sides]] = n
    put("lines", end[n, 1] "\t" end[n, 2] "\n" end[n, 3] "\t" end[n, 4] "\n")
  }
  begin_map(0)
  set_axis("x", least["x"], most["x"], 1)
  set_axis("y", least["y"], most["y"], 1)
  for (n = 1; n <= rows; n++)
    for (k = 1; k <= 2; k++) {
      middle[n, k] = (share(k, end[n, k]) + share(k, end[n, k + 2])) / 2
      turn[n, k] = share(k, end[n, k + 2]) - share(k, end[n, k])
    }
  for (k = 1; k <= pairs; k++)
    put_sides(order[k], counts[order[k]])
  plot_if("lines", "1:2 with lines lw 2 lc rgb 'black'")
  plot_if("lines", "1:2 with points pt 7 ps 0.15 lc rgb 'black'")
  plot_if("numbers", "1:2:3 with labels font 'DejaVu Sans Bold'.letters(11)")
  print_plot()
}
# A value as a share of its axis, and the place of a share
function share(k, number,   axis) {
  axis = k == 1 ? "x" : "y"
  return (place(axis, number) - place(axis, least[axis])) / (place(axis, most[axis]) - place(axis, least[axis]) + 1e-300)
}
function at_share(axis, s) { return place(axis, least[axis]) + s * (place(axis, most[axis]) - place(axis, least[axis])) }

# Of some parts of a boundary, that which is farthest from others has the numbers beside it, the first of them on its left; but not where the same
# number is near.
function put_sides(sides, count_of,   i, n, m, far, best, spot, number, side, away, across, up) {
  split(sides, number)
  for (i = 1; i <= count_of; i += int(count_of / 9) + 1) {
    n = part[sides, i]
    far = 0.04
    for (m = 1; m <= rows; m++)
      if (sides_of[m] != sides)
        far = min(far, sqrt((middle[m, 1] - middle[n, 1]) ^ 2 + (middle[m, 2] - middle[n, 2]) ^ 2))
    if (far >= best) {
      best = far
      spot = n
    }
  }
  for (side = 1; side <= 2; side++) {
    away = (side == 1 ? -0.45 : 0.45) * best / sqrt(turn[spot, 1] ^ 2 + turn[spot, 2] ^ 2 + 1e-300)
    across = middle[spot, 1] + away * turn[spot, 2]
    up = middle[spot, 2] - away * turn[spot, 1]
    for (i = 1; i <= numbers[number[side]]; i++)
      if ((number_at[number[side], i, 1] - across) ^ 2 + (number_at[number[side], i, 2] - up) ^ 2 < 0.02)
        break
    if (i > numbers[number[side]]) {
      numbers[number[side]] = i
      number_at[number[side], i, 1] = across
      number_at[number[side], i, 2] = up
      put("numbers", point(at_share("x", across), at_share("y", up)) "\t" number[side])
    }
  }
}
