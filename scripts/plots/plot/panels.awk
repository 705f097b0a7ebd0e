# Curves in panels, with one key: add() takes their points, style[] says how each curve is drawn, and extras is for every panel.

# A point that the axes cannot show interrupts the curve.
function fits(text, logarithmic) { return is_number(text) && (!logarithmic || text + 0 > 0) }
function add(panel, curve, across, up,   block) {
  if (!(panel in panel_place))
    panel_called[panel_place[panel] = ++panels] = panel
  if (!(curve in curve_place))
    curve_called[curve_place[curve] = ++curves] = curve
  block = "at_" panel_place[panel] "_" curve_place[curve]
  if (fits(across, is_log["x"]) && fits(up, is_log["y"])) {
    stretch("x", across)
    stretch("y", up)
    is_drawn[curve_place[curve]] = 1
    most_points = max(most_points, ++points[block])
    put(block, across "\t" up)
  } else
    put(block, "NaN\tNaN")
}

# Of a short curve each point has a symbol, of a long one ten, or of one alone none.
function style_of_curve(hue, dashes) {
  return "with " (most_points <= 40 ? "linespoints ps 0.7" : curves > 1 ? "linespoints pn 10 ps 0.9" : "lines") \
    (most_points <= 40 || curves > 1 ? " pt " word(hue, "7 5 9 11 13 6 4 8 10 12") : "") " lw 2 dt " (dashes - 1) % 5 + 1 " " colour(hue)
}

# Panels of w x h pixels, so many beside each other. Below the key stand the texts of below[].
function print_panels(beside, w, h, x_title, y_title,   k, p, hidden, longest, has_titles, is_below, key_rows, bottom, deep, margin) {
  deep = int((panels + beside - 1) / beside)
  for (k = 1; k <= curves; k++) {
    if (curve_called[k] ~ /^\t/) { # not in the key
      hidden++
      continue
    }
    curve_called[k] = curve_called[k] (is_drawn[k] ? "" : " (none)")
    longest = max(longest, characters(curve_called[k]))
  }
  has_titles = panels > 0 && panel_called[1] != ""
  is_below = has_titles || belows > 0 || longest > 26 || curves > 20
  key_rows = is_below ? rows_of_list(curves - hidden, beside * w, 7 * longest + 60) : 0
  bottom = 18 * key_rows + 55 + 22 * belows
  begin_picture(beside * w, deep * h + (is_below ? bottom + 25 : 100), has_titles ? 12 : 14)
  margin = is_log["x"] || most_points > 40 ? 0 : 0.02 * (most["x"] - least["x"])
  set_axis("x", least["x"] - margin, most["x"] + margin, !is_log["x"])
  set_axis("y", least["y"], most["y"])
  print "set grid lc rgb '#dddddd' lt 1\nset xzeroaxis lt 1 lc rgb '#999999'\nset ylabel " shown(y_title) " noenhanced\nset key off\n" extras
  if (has_titles)
    printf "set multiplot layout %d,%d margins %f,%f,%f,%f spacing %f,%f title title noenhanced font small\n", deep, beside, 95 / wide, \
      1 - 20 / wide, bottom / high, 1 - 65 / high, 90 / wide, 75 / high
  else if (is_below)
    print "set bmargin at screen " bottom / high
  for (p = 1; p <= panels; p++) {
    print "set xlabel " shown(p > panels - beside ? x_title : "") " noenhanced"
    if (has_titles)
      print "set title " shown(symbol(panel_called[p])) " noenhanced"
    for (k = 1; k <= curves; k++)
      if (points["at_" p "_" k])
        plot("$at_" p "_" k " using 1:2 " style[k] " notitle")
    if (p == panels)
      print_key(is_below, key_rows, x_title y_title)
    print_plot()
  }
  print "unset multiplot"
}
function print_key(is_below, key_rows, titles,   k, sample) {
  for (k = 1; k <= curves; k++) {
    if (curve_called[k] ~ /^\t/)
      continue
    sample = style[k]
    sub(/^smooth unique with steps/, "with lines", sample)
    plot("keyentry " sample " title " shown(curve_called[k]))
  }
  print "set key noenhanced Left reverse samplen 4 " (is_below ? "at screen 0.5, screen " (22 * belows + 8) / high " center bottom vertical maxrows " \
    key_rows " font small" : curves == 1 && index(titles, curve_called[1]) ? "off" : "on outside right top") (is_below ? " on" : "")
  for (k = 1; k <= belows; k++)
    print "set label " shown(below[k]) " noenhanced left at screen " 70 / wide ", screen " 22 * (belows - k + 0.7) / high
}
