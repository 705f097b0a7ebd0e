# How far each series reaches: the tolerance for its relative error over T, a panel for each quantity; radii of convergence as stars; the error
# of the best order at T; transitions as lines, numbered, with what happens below.
function draw_reach(   n, k, names) {
  need_all(names, split("kind quantity series order tolerance T error note", names, " "))
  is_log["x"] = is_log["y"] = 1
  for (n = 1; n <= rows; n++) {
    go(n)
    if (v("kind") == "transition" && fits(v("T"), 1))
      add_transition(v("T"), v("note"))
    else if (v("kind") == "reach") {
      add(v("quantity"), v("series") (v("order") == "nan" ? "" : ", below T^" v("order")), v("T"), v("tolerance"))
      stretch("tolerance", v("tolerance"))
    } else if (v("kind") == "radius")
      add(v("quantity"), "radius of convergence", v("T"), 1)
    else if (v("kind") == "best")
      add(v("quantity"), "derived, best order at T", v("T"), unsigned(v("error")))
  }
  if (!("x" in most))
    refuse("no row has a T that can be drawn")
  for (k = 1; k <= curves; k++)
    style[k] = style_of_curve(k, k)
  style[curve_place["radius of convergence"]] = "with points pt 3 ps 1.5 lw 1.5 lc rgb 'black'"
  style[curve_place["derived, best order at T"]] = "with linespoints lw 1.2 pt 1 lc rgb grey"
  if (!has_range["y"])
    set_range("y", "tolerance" in least ? least["tolerance"] / 3 : 1e-16, 10)
  panels = max(panels, 1) # of transitions alone
  print_panels(panels > 1 ? 2 : 1, panels > 1 ? 575 : 800, 270, axis_title("T"), "relative error")
}
function add_transition(T, note) {
  stretch("x", T)
  belows++
  below[belows] = sprintf("%d  T = %.4g: %s", belows, T, note)
  extras = extras sprintf("set arrow from %s, graph 0 to %s, graph 1 nohead dt 3 lw 1.3 lc rgb '#555555'\nset label '%d' at %s, graph 1 " \
    "offset 0,%s center font letters(9)\n", T, T, belows, T, belows % 2 ? "0.5" : "1.1")
}
