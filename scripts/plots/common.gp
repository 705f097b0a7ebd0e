# What all pictures share; run before the script of each. It takes the variables kind (svg, png or pdf) and output_file; the script of a
# picture takes table, the path of its table, as well. Colours that stay apart for colour-blind readers and in grey; where both are
# drawn, the exact curve is solid and the series dashed.
# What sets the size, that of an SVG, and the size of letters in a PNG, which is half as large again: eval picture(WIDTH, HEIGHT, LETTERS)
# width and height, where they are set, come before.
if (!exists("title")) { title = "" }
if (!exists("width")) { width = height = 0 }
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
letters(size) = sprintf(",%d", kind eq "png" ? 1.2 * size + 0.5 : size)
small = letters(10)
mono = "DejaVu Sans Mono" . small
