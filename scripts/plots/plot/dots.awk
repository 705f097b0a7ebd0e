# A line for each row, named by its by columns, with a symbol for each y column: magnitudes along a logarithmic axis; what is 0 is written.
function draw_dots(   n, i, over, value, called, longest, list, instead, title) {
  if (rows > 399)
    refuse("more than 399 rows: each has a line")
  over = of == "published" && "exact" in at ? " / exact" : ""
  is_log["x"] = 1
  is_log["y"] = 0
  for (n = 1; n <= rows; n++) {
    go(n)
    called = ""
    for (i = 1; i <= bys; i++)
      called = called (i > 1 ? "  " : "") v(by[i])
    longest = max(longest, characters(called))
    list = list (n > 1 ? ", " : "") shown(called) " " n
    instead = "none"
    for (i = 1; i <= ys; i++) {
      value = v(y[i])
      if (over != "")
        value = v("exact") + 0 == 0 || !is_number(value) ? "nan" : sprintf("%.6g", value / v("exact"))
      is_magnitude = is_magnitude || value ~ /^-[0-9.]/
      value = unsigned(value)
      add("", i, value, n)
      instead = fits(value, 1) ? "" : instead != "" && is_number(value) ? "0" : instead
    }
    if (instead != "")
      extras = extras "set label '" instead "' at graph 0.01, first " n " left textcolor rgb grey\n"
  }
  for (i = 1; i <= ys; i++) {
    curve_called[i] = magnitude(symbol(y[i]) over)
    title = title (i > 1 ? ", " : "") curve_called[i]
    style[i] = "with points pt " word(i, "7 5 9 11 13 6 4 8") " ps 1.1 " colour(i)
  }
  if (limit > 0) {
    stretch("x", limit)
    extras = extras "set arrow from " limit ", graph 0 to " limit ", graph 1 nohead dt 2 lw 2 lc rgb two\nset label " \
      shown("bound of " y[1] ": " limit) " at " limit ", graph 1 offset 0,0.6 right noenhanced textcolor rgb two\n"
  }
  if (!("x" in most))
    stretch("x", 1)
  set_range("y", rows + 0.7, 0.3) # downwards
  extras = extras "set border 1\nset ytics (" list ") scale 0 noenhanced\n"
  print_panels(1, 700 + 7 * longest, 20 * rows + 30, title, "")
}
