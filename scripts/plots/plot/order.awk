# Errors over h: of each series its points, those that are not used in grey, the fitted line and, dashed, the slope that is expected, both through
# the middle of the points used (through the finest where the order is a limit); the key says the order, its interval and the verdict.
function draw_order(   n, i, k, called, key, start, list, hue) {
  if (x != "h" || ys != 1 || y[1] != "err") {
    draw_curves()
    return
  }
  for (n = 1; n <= rows; n = start[k] + count_of[k]) {
    start[++k] = n
    for (count_of[k] = 0; n + count_of[k] <= rows && series_of(n + count_of[k]) == series_of(n); )
      count_of[k]++
    if (k > 24)
      refuse("more than 24 series: each has a line of the key")
  }
  for (i = 1; i <= k; i++)
    draw_series(i, start[i], start[i] + count_of[i] - 1)
  for (n = 1; n <= rows; n++) {
    go(n)
    if (!is_used())
      add("", "not used", v("h"), unsigned(v("err")))
  }
  style_of("not used", "with points pt 6 ps 1.2 lw 1.5 lc rgb '#888888'")
  for (i = 1; i <= k; i++)
    if (finest[i] && is_number(expected[i])) {
      draw_slope("expected slope", expected[i], start[i], finest[i], across[i], up[i])
      style_of("expected slope", "with lines lw 1.5 dt 2 lc rgb '#555555'")
    }
  print_panels(1, 800, 400, axis_title("h"), "|" (units["err"] == "" ? "error" : axis_title("err")) "|")
}
function series_of(n) {
  go(n)
  return v("file") "\t" v("series") "\t" v("y")
}
function name_of_series(   i, text) {
  for (i = 1; i <= bys; i++)
    text = text (text == "" || v(by[i]) == "" ? "" : ", ") v(by[i])
  return text == "" ? v("y") : text
}

function is_used() { return v("use") == "used" && fits(v("h"), 1) && fits(unsigned(v("err")), 1) }

function draw_series(i, from, to,   n, key, order, used) {
  go(from)
  order = v("order")
  expected[i] = v("expected")
  key = name_of_series() ": " (is_number(order) ? "order " order \
    (is_number(v("order_low")) ? " (" v("order_low") " to " v("order_high") ")" : "") ", " : "") \
    (is_number(expected[i]) ? "expected " expected[i] ": " : "") v("verdict")
  for (n = from; n <= to; n++) {
    go(n)
    if (!is_used())
      continue
    add("", key, v("h"), unsigned(v("err")))
    used++
    across[i] += log(v("h"))
    up[i] += log(unsigned(v("err")))
    finest[i] = n
  }
  add("", key, "", "") # so that a series without points is in the key
  style_of(key, "with points pt 7 ps 1.1 " colour(i))
  if (!used || !is_number(order))
    return
  across[i] /= used
  up[i] /= used
  go(finest[i])
  if (v("interval") == "limit") {
    across[i] = log(v("h"))
    up[i] = log(unsigned(v("err")))
  }
  draw_slope("\t" i, order, from, finest[i], across[i], up[i])
  style_of("\t" i, "with lines lw 2 " colour(i))
}
# A line of slope p through a point, over the h of the rows
function draw_slope(called, p, from, to, across, up,   n, at_h) {
  for (n = 1; n <= 2; n++) {
    go(n == 1 ? from : to)
    at_h = log(v("h"))
    add("", called, v("h"), sprintf("%.17g", exp(up + p * (at_h - across))))
  }
  add("", called, "", "")
}
function style_of(called, how) {
  if (called in curve_place)
    style[curve_place[called]] = how
}
