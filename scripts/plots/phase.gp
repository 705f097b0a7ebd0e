# The line and the curves of docs/background/theory.md over a period, for scripts/plots/pages.sh: work, a folder with its tables, is set.
set terminal pngcairo size 1440,620 fontscale 1.15 font "DejaVu Sans,13"
set output "docs/background/phase.png"
set datafile separator "\t"
set multiplot layout 1, 2 margins 0.065, 0.985, 0.12, 0.87 spacing 0.07
unset key
set border 3
set xtics nomirror 0.25; set ytics nomirror
set xlabel "t/T"; set ylabel "velocity" offset 1
set xrange [0:1]
set arrow 1 from 0.75, graph 0 to 0.75, graph 1 nohead dashtype 3
set arrow 2 from 0, 0 to 1, 0 nohead linecolor rgb "#999999"
set label 9 "extension" at 0.375, graph 1.025 center textcolor rgb "#555555"
set label 10 "contraction" at 0.875, graph 1.025 center textcolor rgb "#555555"
set style line 1 linewidth 3 linecolor rgb "black"
set style line 2 linewidth 2 linecolor rgb "#0b3d91" dashtype 2
set style line 3 linewidth 2 linecolor rgb "#c8102e" dashtype 4

set yrange [-8:8]
set title "T = 1: both bodies slide" offset 0, 0.9
set label 2 "+ +" at 0.06, 5.4 center
set label 3 "− −" at 0.06, -5.4 center
set label 4 "− +" at 0.38, -2.5 center
set label 5 "+ −" at 0.875, -2.5 center
set label 11 "c" at 0.4, 2.75 left
set label 12 "(m_2/M) l'" at 0.6, 6.2 left textcolor rgb "#0b3d91"
set label 13 "−(m_1/M) l'" at 0.52, -6.2 right textcolor rgb "#c8102e"
set label 6 "body 1 reverses" at 0.11, 1.0 left font ",11"
set arrow 3 from 0.105, 1.2 to 0.083, 2.5 filled size 0.012, 20
draw(name) = sprintf("plot '%s' using 1:2 with lines linestyle 1, '' using 1:3 with lines linestyle 2, '' using 1:4 with lines linestyle 3, \
  '%s.changes' using 1:2 with points pointtype 7 pointsize 1.5 linecolor rgb 'black'", work . "/" . name, work . "/" . name)
eval draw("slides")
unset label 6; unset arrow 3
set yrange [-4:4]
set title "T = 5: body 1 sticks" offset 0, 0.9
set label 2 "+ +" at 0.06, 3.2 center
set label 3 "− −" at 0.06, -3.2 center
set label 4 "− +" at 0.36, -1.6 center
set label 5 "+ −" at 0.875, -1.6 center
set label 11 "c" at 0.2, 0.35 left
set label 12 "(m_2/M) l'" at 0.16, 2.0 right textcolor rgb "#0b3d91"
set label 13 "−(m_1/M) l'" at 0.2, -2.4 center textcolor rgb "#c8102e"
set label 6 "c follows the curve" at 0.47, 2.8 left font ",11"
set arrow 3 from 0.60, 2.6 to 0.56, 1.5 filled size 0.012, 20
eval draw("sticks")
