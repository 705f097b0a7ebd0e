# What gnuplot is told: texts, the head of a program, data, axes.

# In double quotes a backslash, 0 and three octal digits are a byte, whatever digit follows.
function quoted(text,   i, c, out) {
  if (!("a" in octal))
    for (i = 1; i < 256; i++)
      octal[sprintf("%c", i)] = sprintf("\\0%03o", i)
  for (i = 1; i <= length(text); i++) {
    c = substr(text, i, 1)
    out = out (c ~ /[A-Za-z0-9 _.\/:+=,()-]/ ? c : octal[c])
  }
  return "\"" out "\""
}
# "./" keeps '<', '|', '-' and whatever else means no file to gnuplot off the first place.
function path(text) { return quoted((text ~ /^\// ? "" : "./") text) }
# A text to be read: what is no character of UTF-8 becomes "?", and in an SVG what gnuplot would leave and XML not take for text is written
# otherwise.
function shown(text,   one, out) {
  one = "^([\302-\337][\200-\277]|\340[\240-\277][\200-\277]|[\341-\354\356\357][\200-\277][\200-\277]|\355[\200-\237][\200-\277]|" \
    "\360[\220-\277][\200-\277][\200-\277]|[\361-\363][\200-\277][\200-\277][\200-\277]|\364[\200-\217][\200-\277][\200-\277])"
  while (match(text, /[\001-\037\177-\377]/)) {
    out = out substr(text, 1, RSTART - 1)
    text = substr(text, RSTART)
    out = out (match(text, one) ? substr(text, 1, RLENGTH) : "?")
    text = substr(text, max(RLENGTH, 1) + 1)
  }
  text = out text
  if (format == "svg") {
    gsub(/&#x/, "\\&#x26;#x", text)
    gsub(/]]>/, "]]\\&#x3e;", text)
  }
  return quoted(text)
}
function characters(text) { return gsub(/[^\200-\277]/, "", text) }

# What a column is called in an axis title or a key, and its unit: those of quantities are in the request.
function describe(   list, i, part) {
  split("m1:m₁:mass m2:m₂:mass F1:F₁:force F2:F₂:force L:L:length T:T:time t:t:time x1:x₁:length x2:x₂:length xC:x_C:length l:l:length " \
    "v1:v₁:length/time v2:v₂:length/time v0:v₀:length/time t1:t₁ dT:ΔT dx1:Δx₁ dx2:Δx₂ dxC:Δx_C alpha:α F1/F2:F₁/F₂ F1_over_F2:F₁/F₂ " \
    "m1/m2:m₁/m₂ m1_over_m2:m₁/m₂ t_over_T:t_/_T mean_velocity:mean_velocity friction_work:friction_work froude:Froude_number " \
    "cost_of_transport:cost_of_transport displacement_error:displacement_error time_median:time", list, " ")
  for (i in list) {
    split(list[i], part, ":")
    if (part[2] !~ /x_C/)
      gsub(/_/, " ", part[2])
    symbols[part[1]] = part[2]
    units[part[1]] = part[3]
  }
  for (i = split(ENVIRON["PLOT_units"], list, "\n"); i > 0; i--) {
    split(list[i], part, "\t")
    units[part[1]] = part[2]
  }
}
function symbol(name) { return name in symbols ? symbols[name] : name }
function axis_title(name) { return symbol(name) (units[name] == "" ? "" : " (" units[name] ")") }

# Every program begins with the request, in the variables that scripts take, and common.gp.
function begin_program() {
  print "table = " path(ENVIRON["PLOT_table"]) "\noutput_file = " path(ENVIRON["PLOT_output"])
  print "kind = " quoted(format) "\ntitle = " shown(title) "\nx_column = " quoted(x)
  print_columns("y", y, ys)
  print_columns("by", by, bys)
  printf "log_x = %d\nlog_y = %d\nwidth = %d\nheight = %d\n", is_log["x"], is_log["y"], size[1], size[2]
  print ENVIRON["PLOT_common"]
}
function print_columns(name, columns, count,   i) {
  print "array " name "_columns[8]\n" name "s = " count
  for (i = 1; i <= count; i++)
    print name "_columns[" i "] = " quoted(columns[i])
}
# A picture of so many pixels, unless others are asked for, and in a PNG with letters of this size
function begin_picture(pixels_across, pixels_up, letters) {
  wide = size[1] ? size[1] : pixels_across
  high = size[2] ? size[2] : pixels_up
  begin_program()
  printf "eval picture(%d, %d, %d)\nset title title noenhanced font small\n", wide, high, letters
}

# Data are lines of named blocks, which are printed before what plots them.
function put(block, text) {
  if (!(block in lines_of))
    block_called[++blocks] = block
  line_of[block, ++lines_of[block]] = text
}
function plot(what) { plots = plots (plots == "" ? "plot " : ", \\\n  ") what }
function print_plot(   i, k, block) {
  for (i = 1; i <= blocks; i++) {
    block = block_called[i]
    print "$" block " << END"
    for (k = 1; k <= lines_of[block]; k++)
      print line_of[block, k]
    print "END"
  }
  print (plots == "" ? "plot NaN notitle" : plots)
  plots = ""
  blocks = 0
}

# The rows of a list in columns of that many pixels in the picture
function rows_of_list(entries, pixels, pixels_of_column,   beside) {
  beside = max(1, int(pixels / pixels_of_column))
  return int((entries + beside - 1) / beside)
}

function max(a, b) { return a + 0 > b + 0 ? a : b }
function min(a, b) { return a + 0 < b + 0 ? a : b }
function abs(number) { return number < 0 ? -number : number }
function unsigned(text) { return substr(text, 1 + (text ~ /^-/)) }
function log10(number) { return log(number) / log(10) }
function floor(number) { return int(number) - (int(number) > number) }
function word(k, list,   words, count) {
  count = split(list, words, " ")
  return words[(k - 1) % count + 1]
}
function colour(k) { return "lc rgb '" word(k, "#0b3c8c #c8102e #2a9d4a #b8860b #7b3fa0 #1b9aaa #000000 #888888") "'" }

function set_range(axis, low, high) {
  has_range[axis] = 1
  low_end[axis] = low
  high_end[axis] = high
}
# An axis, "x" or "y", for numbers from low to high, or as wide as is asked for; gnuplot finds the ends of a linear one that need not be exact. A
# logarithmic one of few powers of ten has tics of its own, and ends at the numbers, with a margin unless they are exact.
function set_axis(axis, low, high, exact,   is_long, margin) {
  exact = exact || has_range[axis]
  low = has_range[axis] ? low_end[axis] + 0 : low
  high = has_range[axis] ? high_end[axis] + 0 : high
  if (is_log[axis]) {
    is_long = log10(high) - log10(low) > 2.999
    print "set logscale " axis "; set format " axis (is_long ? " '10^{%T}'" : " '%g'")
    if (low < 1e-290 || high > 1e290)
      return
    margin = exact ? 1 : is_long ? 1.3 : high > low * (1 + 1e-6) ? (high / low) ^ 0.04 : 1.1
    low /= margin
    high *= margin
    if (!is_long)
      print "set " axis "tics (" tics(low, high) ")"
  }
  if (low != high && (is_log[axis] || exact))
    printf "set %srange [%.17g:%.17g]\n", axis, low, high
}
# Some five, or 1, 2 and 5 of each power of ten
function tics(low, high,   power, by, k, list) {
  power = 10 ^ floor(log10((high - low) / 5))
  by = power * (high - low < 7.5 * power ? 1 : high - low < 17.5 * power ? 2 : high - low < 37.5 * power ? 5 : 10)
  for (k = floor(low / by) + 1; high < 10 * low && k * by <= high; k++)
    list = list sprintf("%s%.12g", list == "" ? "" : ", ", k * by)
  for (power = floor(log10(low)); high >= 10 * low && power <= log10(high); power++)
    for (k = 1; k <= 3; k++)
      list = list sprintf("%s%.12g", list == "" ? "" : ", ", word(k, "1 2 5") * 10 ^ power)
  return list
}
