# How far each series reaches: the tolerance for its relative error over T, a panel for each quantity; radii of convergence as stars; the error
# of the best order at T; events as lines, numbered, with what happens below.
function draw_reach(   n, k, cell, T, what, quantity, order) {
  for (n = split("what quantity series order tolerance T error note", cell, " "); n > 0; n--)
    need(cell[n])
  is_log["x"] = is_log["y"] = 1
  for (n = 1; n <= rows; n++) {
    split(line[n], cell)
    T = cell[at["T"]]
    what = cell[at["what"]]
    quantity = cell[at["quantity"]]
    order = cell[at["order"]]
    if (what == "event" && fits(T, 1))
      add_event(T, cell[at["note"]])
    else if (what == "reach") {
      add(quantity, cell[at["series"]] (order == "nan" ? "" : ", below T^" order), T, cell[at["tolerance"]])
      stretch("tolerance", cell[at["tolerance"]])
    } else if (what == "radius")
      add(quantity, "radius of convergence", T, 1)
    else if (what == "best") {
      sub(/^-/, "", cell[at["error"]])
      add(quantity, "derived, best order at T", T, cell[at["error"]])
    }
  }
  if (!("x" in most))
    refuse("no row has a T that can be drawn")
  for (k = 1; k <= curves; k++)
    style[k] = curve_called[k] ~ /^radius/ ? "with points pt 3 ps 1.5 lw 1.5 lc rgb 'black'" : \
      curve_called[k] ~ /^derived, best/ ? "with linespoints lw 1.2 pt 1 lc rgb grey" : style_of_curve(k, k)
  if (!has_range["y"])
    set_range("y", "tolerance" in least ? least["tolerance"] / 3 : 1e-16, 10)
  panels = max(panels, 1) # of events alone
  print_panels(panels > 1 ? 2 : 1, panels > 1 ? 575 : 800, 270, axis_title("T"), "relative error")
}
function add_event(T, note) {
  stretch("x", T)
  belows++
  below[belows] = sprintf("%d  T = %.4g: %s", belows, T, note)
  extras = extras sprintf("set arrow from %s, graph 0 to %s, graph 1 nohead dt 3 lw 1.3 lc rgb '#555555'\nset label '%d' at %s, graph 1 " \
    "offset 0,%s center font letters(9)\n", T, T, belows, T, belows % 2 ? "0.5" : "1.1")
}
