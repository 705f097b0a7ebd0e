# What all figures share. Colours that stay apart for colour-blind readers and in grey; the exact curve
# is solid and the series dashed.
if (kind eq "svg") set terminal svg size 900,380 font "DejaVu Sans,12" background rgb "white"
if (kind eq "png") set terminal pngcairo size 1350,570 font "DejaVu Sans,13" background rgb "white"
set output output_file
set datafile separator "\t"
set datafile commentschars "#"
set border 3
set tics nomirror
set key samplen 2
one = "#0b3c8c"; two = "#c8102e"; three = "#2a9d4a"; grey = "#555555"
