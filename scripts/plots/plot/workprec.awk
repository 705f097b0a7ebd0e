# Error against run time, a panel for each gait and T (of more than three T the first, the middle one and the last). Methods differ by symbol, and
# in how they get to the steady state by the line: as a root filled and solid, by simulation open and dashed. The broad grey stairs are the
# Pareto front.
function draw_workprec(   n, k, cell, Ts, rank, panel, time, error, status, method) {
  for (n = split("method kind gait T quantity error time_median pareto status", cell, " "); n > 0; n--)
    need(cell[n])
  is_log["x"] = is_log["y"] = 1
  for (n = 1; n <= rows; n++) {
    split(line[n], cell)
    if (!(cell[at["T"]] in rank))
      rank[cell[at["T"]]] = ++Ts
  }
  for (n = 1; n <= rows; n++) {
    split(line[n], cell)
    k = rank[cell[at["T"]]]
    error = cell[at["error"]]
    if (cell[at["quantity"]] != "displacement" || !is_number(error) || (Ts > 3 && k != 1 && k != Ts && k != int((Ts + 1) / 2)))
      continue
    panel = cell[at["gait"]] " gait, T = " cell[at["T"]]
    error = max(error, 1e-20) # what is below is drawn there
    time = cell[at["time_median"]]
    status = cell[at["status"]]
    method = status ~ /^cut off/ ? "cut off: where it stood" : cell[at["method"]]
    if (curves == 0 || cell[at["pareto"]] == "yes") # it is drawn first, behind the others
      add(panel, "Pareto front", time, cell[at["pareto"]] == "yes" ? error : "nan")
    if (status == "ok" || status ~ /^cut off/) {
      add(panel, method, time, error)
      if (!(curves in style))
        style[curves] = style_of_method(method, cell[at["kind"]])
    }
  }
  if (!("x" in most))
    refuse("no row has a time")
  style[1] = "smooth unique with steps lw 9 lc rgb '#cccccc'"
  if (!has_range["y"])
    set_range("y", 1e-20 / 4, 30)
  extras = "set ytics add ('< 10^{-20}' 1e-20)\n"
  print_panels(min(Ts, 3), Ts == 1 ? 1000 : Ts == 2 ? 500 : 400, 390, "seconds for one steady state, on one machine", "relative error of the displacement")
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
