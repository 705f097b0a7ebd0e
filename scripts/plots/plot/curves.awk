# Columns over a column: a curve for each y column and each combination of values in the by columns.
function draw_curves(   n, i, k, hue, called) {
  if (x == "" || ys == 0)
    refuse("a plot without a script of its own needs x and y, columns of the table")
  for (n = 1; n <= rows; n++) {
    go(n)
    stretch("x column", v(x))
    for (i = 1; i <= ys; i++)
      stretch("y column " i, v(y[i]))
  }
  choose_logarithmic()
  for (n = 1; n <= rows; n++) {
    go(n)
    called = combination()
    for (i = 1; i <= ys; i++)
      add("", (ys > 1 || called == "" ? magnitude(symbol(y[i])) : "") (ys > 1 && called != "" ? ", " : "") called, v(x), \
        is_magnitude ? unsigned(v(y[i])) : v(y[i]))
    if (curves > 24 * ys)
      refuse("more than 24 combinations of values: each has a curve")
  }
  if (!("x" in most))
    refuse("no row has a number that the axis can show in both columns")
  # Colours and symbols tell the combinations apart and dashes the columns; without by columns all of them tell the columns apart.
  for (k = 1; k <= curves; k++) {
    hue = bys > 0 ? int((k - 1) / ys) + 1 : k
    style[k] = style_of_curve(hue, bys > 0 && ys > 1 ? (k - 1) % ys + 1 : hue)
  }
  print_panels(1, 800, 400, axis_title(x), names_of_y())
}

# An axis is logarithmic where the kind of table is drawn so, or its numbers are positive and far apart.
function is_wide(what, factor) { return least[what] > 0 && most[what] >= factor * least[what] }
function choose_logarithmic(   i, wide) {
  wide = 1
  for (i = 1; i <= ys; i++)
    wide = wide && is_wide("y column " i, 1000)
  if (of != "" && !has_range["x"])
    is_log["x"] = is_log["x"] || is_wide("x column", 30)
  if (of != "" && !has_range["y"])
    is_log["y"] = is_log["y"] || wide
  is_magnitude = is_magnitude && is_log["y"]
}

# "F₁ = 4, quadratic": a number says what it is of, a word does not.
function combination(   i, value, called) {
  for (i = 1; i <= bys; i++) {
    value = v(by[i])
    called = called (i > 1 ? ", " : "") (value ~ /^-?[0-9.]/ ? symbol(by[i]) " = " : "") value
  }
  return called
}

function magnitude(text) { return is_magnitude ? "|" text "|" : text }
function names_of_y(   i, text, unit) {
  unit = units[y[1]]
  for (i = 1; i <= ys; i++) {
    text = text (i > 1 ? ", " : "") magnitude(symbol(y[i]))
    unit = unit == units[y[i]] ? unit : ""
  }
  return text (unit == "" ? "" : " (" unit ")")
}
