# What all pictures share; run before the script of each. It takes the variables kind (svg, png or pdf) and output_file; the script of a
# picture takes table, the path of its table, as well. Colours that stay apart for colour-blind readers and in grey; where both are
# drawn, the exact curve is solid and the series dashed.
# What sets the size, that of an SVG, and the size of letters in a PNG, which is half as large again: eval picture(WIDTH, HEIGHT, LETTERS)
# width and height, where they are set, come before.
if (!exists("title")) { title = "" }
if (!exists("width")) { width = height = 0 }
if (!exists("has_x_range")) { has_x_range = has_y_range = 0 }
picture(w, h, letters) = sized(width > 0 ? width : w, height > 0 ? height : h, letters)
sized(w, h, letters) = \
  (kind eq "svg" ? sprintf("set terminal svg size %d,%d font 'DejaVu Sans,12'", w, h) : \
   kind eq "png" ? sprintf("set terminal pngcairo size %d,%d font 'DejaVu Sans,%d'", w * 1.5, h * 1.5, letters) : \
                   sprintf("set terminal pdfcairo size %gin,%gin font 'DejaVu Sans,12'", w / 100.0, h / 100.0)) . \
  " background rgb 'white'; set output output_file"
set encoding utf8
eval picture(800, 500, 14)
set datafile separator "\t"
set datafile commentschars "#"
set border 3
set tics nomirror
set key samplen 2
one = "#0b3c8c"; two = "#c8102e"; three = "#2a9d4a"; grey = "#555555"

# What a column is called in an axis title or a key, with its unit in brackets. unit(column) is what the program says of units.
if (!exists("GPFUN_unit")) { unit(name) = "" }
array symbols[54] = [ "m1", "m₁", "m2", "m₂", "F1", "F₁", "F2", "F₂", "F1/F2", "F₁/F₂", "F1_over_F2", "F₁/F₂", "m1/m2", "m₁/m₂", \
  "m1_over_m2", "m₁/m₂", "alpha", "α", "x1", "x₁", "x2", "x₂", "xC", "x_C", "v1", "v₁", "v2", "v₂", "v0", "v₀", "t1", "t₁", "dT", "ΔT", \
  "dx1", "Δx₁", "dx2", "Δx₂", "dxC", "Δx_C", \
  "mean_velocity", "mean velocity", "friction_work", "friction work", "cost_of_transport", "cost of transport", "froude", "Froude number", \
  "displacement_error", "displacement error", "time_median", "time", "t_over_T", "t / T" ]
array units[28] = [ "m1", "mass", "m2", "mass", "F1", "force", "F2", "force", "L", "length", "T", "time", "t", "time", "v0", "length/time", \
  "x1", "length", "x2", "length", "xC", "length", "l", "length", "v1", "length/time", "v2", "length/time" ]
symbol_at(name, i) = i > |symbols| ? name : symbols[i] eq name ? symbols[i + 1] : symbol_at(name, i + 2)
unit_at(name, i) = i > |units| ? "" : units[i] eq name ? units[i + 1] : unit_at(name, i + 2)
symbol(name) = symbol_at(name, 1)
unit_words(name) = strlen(unit(name)) > 0 ? unit(name) : unit_at(name, 1)
in_unit(name) = strlen(unit_words(name)) > 0 ? " (" . unit_words(name) . ")" : ""
axis(name) = symbol(name) . in_unit(name)
is_number(text) = text[1:1] eq "-" ? strstrt("0123456789.", text[2:2]) > 0 : strstrt("0123456789.", text[1:1]) > 0
small = ",".(kind eq "png" ? 12 : 10)
mono = "DejaVu Sans Mono,".(kind eq "png" ? 12 : 10)
