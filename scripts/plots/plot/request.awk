# The request, the table, and which picture of which columns it gets. Of the environment: PLOT_of, what the table is of, "" in a scene; PLOT_table,
# its path; PLOT_file, the picture, whose ending is its format; PLOT_output, where it is written until it is complete; PLOT_x to PLOT_size as in
# docs/reference/plots.md; PLOT_log_x and PLOT_log_y, "1"; PLOT_units, lines of a column, a tab and its unit; PLOT_picture, the name of a
# picture that comes with the tool, or PLOT_script, the path of a script for gnuplot, instead of what such a table gets.
BEGIN {
  FS = "\t"
  of = ENVIRON["PLOT_of"]
  picture = ENVIRON["PLOT_picture"]
  format = ENVIRON["PLOT_file"]
  sub(/.*[.]/, "", format)
  title = ENVIRON["PLOT_title"]
  x = ENVIRON["PLOT_x"]
  ys = read_list("y", y)
  bys = read_list("by", by)
  split(ENVIRON["PLOT_size"], size, "x")
  read_range("x", ENVIRON["PLOT_x_range"])
  read_range("y", ENVIRON["PLOT_y_range"])
  parameters = "T,alpha,F1,F2,m1,m2,L,gait,phase,v0"
  looked_at = split(parameters ",file,series,y,quantity,scene,stepper", look_at, ",")
  if (picture ~ /^figure/)
    script = ENVIRON["PLOT_" picture]
  else if (ENVIRON["PLOT_script"] != "")
    script = "load " path(ENVIRON["PLOT_script"])
  if (script) {
    begin_program()
    print script "\nunset output"
    exit
  }
}

# The head has the parameters that hold, the axes of a map, and how small errors may be.
/^#/ {
  if (sub(/^# parameters: /, ""))
    held = substr($0, 1, 111)
  else if (/^# [xy]: /)
    axis_of_map[substr($0, 3, 1)] = substr($0, 6)
  else if (of == "stress" && sub(/^# bounds, in units: error /, ""))
    limit = $0 + 0
  next
}
!columns {
  columns = NF
  for (i = NF; i > 0; i--)
    at[column[i] = $i] = i
  next
}
{
  line[++rows] = $0
  for (i = 1; i <= looked_at; i++)
    if (look_at[i] in at)
      look(look_at[i], $(at[look_at[i]]) "")
}
END {
  if (script || code)
    exit code
  if (rows == 0)
    refuse("the table has no " (columns ? "rows" : "columns"))
  if (of == "breakdown" && axis_of_map["x"] != "") # of a scene
    of = "region_1" in at ? "boundaries" : "map"
  if (of picture ~ /^(map|boundaries)/)
    choose_axes_of_map()
  else if (of != "") # else a scene says all
    choose_columns()
  need(x)
  need_all(y, ys)
  need_all(by, bys)
  describe()
  if (picture == "map")
    draw_map()
  else if (picture == "boundaries")
    draw_boundaries()
  else if (picture == "reach")
    draw_reach()
  else if (picture == "workprec")
    draw_workprec()
  else if (picture == "dots")
    draw_dots()
  else if (picture == "order")
    draw_order()
  else if (picture == "curves" || picture == "")
    draw_curves()
  else
    refuse("the tool has no picture " picture)
  print "unset output"
}

function refuse(why) {
  print why >"/dev/stderr"
  exit code = 2
}
function need(name) {
  if (name != "" && !(name in at))
    refuse("the table has no column " name)
}
function need_all(names, count,   i) {
  for (i = 1; i <= count; i++)
    need(names[i])
}
# Goes to a row, and what it has in a column
function go(n) { split(line[n], cell) }
function v(name) { return cell[at[name]] }

function read_list(name, list,   count, i) {
  count = split(ENVIRON["PLOT_" name], list, / *, */)
  for (i = 1; i <= count; i++)
    if (list[i] == "" || count > 8)
      refuse("--plot-" name ": it takes one to eight columns, with commas between")
  return count
}
# FROM:TO, FROM:TO:log or FROM:TO:linear
function read_range(axis, text,   part) {
  has_range[axis] = split(text, part, ":") > 0
  low_end[axis] = part[1]
  high_end[axis] = part[2]
  is_log[axis] = ENVIRON["PLOT_log_" axis] + 0 || part[3] == "log"
}

# How many values a column has, the last of them, and the least and the greatest number among them
function look(name, value) {
  if (value == last[name] && name in values)
    return
  last[name] = value
  values[name] += !((name, value) in known)
  known[name, value]
  stretch(name, value)
}
function is_number(text) { return text ~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/ }
function stretch(what, text) {
  if (!is_number(text))
    return
  if (!(what in least) || text + 0 < least[what])
    least[what] = text + 0
  if (!(what in most) || text + 0 > most[what])
    most[what] = text + 0
}

# What is drawn of a table by what it is of: the picture, and x, y and by where they are not named; the axes that are logarithmic whatever their
# values are; "|": magnitudes. "*": what varies; "relative.": the columns that begin so; "?": the first number that is no parameter. The first row whose y there is, or of no y where none is
# named.
function kind_of_table(part,   kinds, kind, i) {
  kinds = split( \
    "trajectory        : curves   : t     : x1,x2,xC                   :                             :    \n" \
    "order             : order    : h     : err                        : file,series,y               : xy|\n" \
    "derived           : curves   : power : error                      : phase,quantity              : y| \n" \
    "published         : dots     :       : error                      : formula,phase,quantity      :    \n" \
    "bounds            : dots     :       : bound                      : quantity                    :    \n" \
    "breakdown         : reach    : T     :                            :                             :    \n" \
    "workprec          : workprec :       : error                      :                             :    \n" \
    "stress            : dots     :       : error_units,spread_rounding,change_per_ulp : family,gait                 :    \n" \
    "stress of a point : dots     :       : error_units,spread_rounding,change_per_ulp : quantity                    :    \n" \
    "stiff             : curves   : delta : displacement_error         : scene,gait,stepper          : xy|\n" \
    "phase             : curves   : *     : dxC                        : *                           :    \n" \
    "steady            : curves   : *     : mean_velocity              : *                           :    \n" \
    "series            : curves   : *     : relative.                  : *                           : xy|\n" \
    "series            : curves   : *     : eq28_displacement             : *                           :    \n" \
    "steady            : curves   : *     : ?                          : *                           :    \n" \
    "phase             : curves   : *     : ?                          : *                           :    \n" \
    "series            : curves   : *     : ?                          : *                           :    ", kind, "\n")
  for (i = 1; i <= kinds; i++) {
    split(kind[i], part, / *: */)
    if (part[1] == of && (part[4] == "" ? ys == 0 : columns_of(part[4]) > 0))
      return 1
  }
  return split(":curves:*::*:", part, ":") * 0 # any other: y is named, and x where nothing varies
}

# The columns of a list, of which the first is there, or those that begin so, at most 8, or for "?" the first numbers that are no parameter: in
# found. Returns how many.
function columns_of(list,   i, count) {
  if (list !~ /[.?]$/) {
    count = split(list, found, ",")
    return found[1] in at ? count : 0
  }
  go(1)
  for (i = 1; i <= columns && count < (list == "?" ? 1 : 8); i++)
    if (list == "?" ? is_number(v(column[i])) && index("," parameters ",", "," column[i] ",") == 0 : index(column[i], list) == 1)
      found[++count] = column[i]
  return count + 0
}

function choose_columns(   part, is_known, count, names, i, name) {
  is_known = kind_of_table(part)
  picture = part[2]
  for (i = ys == 0 ? columns_of(part[4]) : 0; i > 0; i--) {
    y[i] = found[i]
    ys = max(ys, i)
  }
  for (i = split(parameters, names, ","); i > 0 && x part[3] == "*"; i--) # what has the most values
    if (values[names[i]] > 1 && values[names[i]] >= values[name] && least[names[i]] < most[names[i]])
      name = names[i]
  x = x != "" ? x : part[3] != "*" ? part[3] : name
  if (part[3] == "*" && (x == "" || ys == 0))
    refuse(is_known ? "no parameter varies: a curve needs several points: --T 0.1:1:20, or --points FILE" : \
                      "--plot-x NAME and --plot-y NAME choose the columns of this table")
  count = bys > 0 ? 0 : split(part[5] == "*" ? parameters : part[5], names, ",")
  for (i = 1; i <= count && bys < 8; i++) # what is the same in all rows names no curve
    if (names[i] != x && (picture == "dots" || values[names[i]] > 1))
      by[++bys] = names[i]
  is_magnitude = part[6] ~ /[|]/
  is_log["x"] = has_range["x"] ? is_log["x"] : part[6] ~ /x/
  is_log["y"] = has_range["y"] ? is_log["y"] : part[6] ~ /y/
  for (i = split("m1,m2,F1,F2,L,T,alpha,gait", names, ","); i > 0 && held == ""; i--) # that are the same in all rows
    if (values[names[i]] == 1)
      text = names[i] "=" last[names[i]] (text == "" ? "" : " ") text
  title = title != "" ? title : held != "" ? held : substr(text, 1, 111)
}
