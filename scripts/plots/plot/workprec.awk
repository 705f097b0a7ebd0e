# Error against run time, a panel for each gait and T (of more than three T the first, the middle one and the last). Methods differ by symbol, and
# in how they get to the steady state by the line: as a root filled and solid, by simulation open and dashed. The broad grey stairs are the
# Pareto front.
function draw_workprec(   n, k, names, Ts, rank) {
  need_all(names, split("method kind gait T quantity error time_median pareto status", names, " "))
  is_log["x"] = is_log["y"] = 1
  for (n = 1; n <= rows; n++) {
    go(n)
    if (!(v("T") in rank))
      rank[v("T")] = ++Ts
  }
  for (n = 1; n <= rows; n++) {
    go(n)
    k = rank[v("T")]
    if (v("quantity") == "displacement" && is_number(v("error")) && (Ts <= 3 || k == 1 || k == Ts || k == int((Ts + 1) / 2)))
      add_method(v("gait") " gait, T = " v("T"), max(v("error"), 1e-20)) # what is below is drawn there
  }
  if (!("x" in most))
    refuse("no row has a time")
  style[1] = "smooth unique with steps lw 9 lc rgb '#cccccc'"
  if (!has_range["y"])
    set_range("y", 1e-20 / 4, 30)
  extras = "set ytics add ('< 10^{-20}' 1e-20)\n"
  print_panels(min(Ts, 3), Ts == 1 ? 1000 : Ts == 2 ? 500 : 400, 390, "seconds for one steady state, on one machine", "relative error of the displacement")
}
function add_method(panel, error,   method) {
  if (curves == 0 || v("pareto") == "yes") # drawn first, behind the others
    add(panel, "Pareto front", v("time_median"), v("pareto") == "yes" ? error : "nan")
  method = v("status") ~ /^cut off/ ? "cut off: where it stood" : v("status") == "ok" ? v("method") : ""
  if (method == "")
    return
  add(panel, method, v("time_median"), error)
  if (!(curves in style))
    style[curves] = style_of_method(method, v("kind"))
}
function style_of_method(method, kind,   filled) {
  if (method ~ /^cut off/)
    return "with points pt 2 ps 0.7 lc rgb two"
  if (kind != "root" && kind != "simulation")
    return "with linespoints ps 1.4 lw 1.5 lc rgb 'black' pt " word(++formulas, "1 2 3 7 5") " dt " formulas
  sub(/,.*/, "", method)
  if (!(method in hue))
    hue[method] = ++hues
  filled = word(hue[method], "5 7 9 11 13 15")
  return "with linespoints ps 1 lw 1.5 " colour(hue[method]) " pt " (kind == "root" ? filled : filled - 1 " dt 2")
}
