# The model as a picture, docs/model.png: gnuplot -d -e "file='docs/model.png'" scripts/plots/model.gp
if (!exists("file")) file = "docs/model.png"
set terminal pngcairo size 1320,396 fontscale 1.2 font "DejaVu Sans,12"
set output file
set multiplot
unset key; unset tics; unset border
# The bodies, during an extension: body 1 slides backward, body 2 forward
set origin 0, 0; set size 0.6, 1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [0:100]; set yrange [0:50]
ground = 14
set object 1 rectangle from 2, ground - 3 to 98, ground fillcolor rgb "#dddddd" fillstyle solid 1 noborder
set arrow 1 from 2, ground to 98, ground nohead linewidth 1.5
set object 2 rectangle from 11, ground to 33, ground + 12 fillcolor rgb "#9db8d9" fillstyle solid 1 border rgb "#0b3d91"
set object 3 rectangle from 65, ground to 87, ground + 12 fillcolor rgb "#e6a8ae" fillstyle solid 1 border rgb "#c8102e"
set label 1 "body 1 (rear)" at 22, ground + 8 center
set label 2 "mass m₁" at 22, ground + 4 center
set label 3 "body 2 (front)" at 76, ground + 8 center
set label 4 "mass m₂" at 76, ground + 4 center
# The mechanism, and the separation
set arrow 2 from 33, ground + 6 to 65, ground + 6 nohead linewidth 4 linecolor rgb "#888888"
set label 5 "mechanism without mass" at 49, ground + 3 center textcolor rgb "#555555"
set arrow 3 from 22, ground + 18 to 76, ground + 18 heads filled size 1.5, 20 linewidth 1.5
set arrow 4 from 22, ground + 13 to 22, ground + 20 nohead dashtype 3
set arrow 5 from 76, ground + 13 to 76, ground + 20 nohead dashtype 3
set label 6 "separation l(t) = x₂ − x₁" at 49, ground + 20.5 center
# Friction opposes the motion of each body
set arrow 6 from 22, ground - 6 to 36, ground - 6 filled size 1.5, 20 linewidth 2.5 linecolor rgb "#0b3d91"
set label 7 "friction F₁" at 22, ground - 10 left textcolor rgb "#0b3d91"
set arrow 7 from 76, ground - 6 to 67, ground - 6 filled size 1.5, 20 linewidth 2.5 linecolor rgb "#c8102e"
set label 8 "friction F₂" at 76, ground - 10 right textcolor rgb "#c8102e"
set arrow 8 from 22, ground + 27 to 10, ground + 27 filled size 1.5, 20 linewidth 1.5 linecolor rgb "#0b3d91"
set label 9 "moves back" at 23.5, ground + 27 left textcolor rgb "#0b3d91"
set arrow 9 from 76, ground + 27 to 88, ground + 27 filled size 1.5, 20 linewidth 1.5 linecolor rgb "#c8102e"
set label 10 "moves forward" at 74.5, ground + 27 right textcolor rgb "#c8102e"
set arrow 10 from 86, ground - 7 to 98, ground - 7 filled size 1.5, 20 linewidth 1.5
set label 11 "x, forward" at 98, ground - 10.5 right
set label 12 "An extension" at 49, ground + 32.5 center font ",15"
plot NaN notitle
unset object; unset arrow; unset label
# The separation over a period
set origin 0.64, 0; set size 0.35, 1
set lmargin at screen 0.68; set rmargin at screen 0.98; set tmargin at screen 0.82; set bmargin at screen 0.2
set xrange [0:1.12]; set yrange [0:1.2]
alpha = 0.75
quadratic(u) = u < 0.5 ? 2*u**2 : 1 - 2*(1 - u)**2
sinusoidal(u) = (1 - cos(pi*u))/2
share(t) = t < alpha ? t/alpha : (1 - t)/(1 - alpha)
set border 3
set xtics ("0" 0, "α T" alpha, "T" 1) nomirror
set ytics ("0" 0, "L" 1) nomirror
set label 1 "A period of l(t)" at graph 0.5, 1.16 center font ",15"
set label 2 "extension" at alpha/2, 1.09 center
set label 3 "contraction" at (1 + alpha)/2, 1.09 center font ",10"
set label 4 "t" at 1.12, -0.1 center
set arrow 1 from alpha, 0 to alpha, 1.15 nohead dashtype 3
set arrow 2 from 1, 0 to 1, 1.15 nohead dashtype 3
set key at graph 0.02, 0.82 left top reverse Left samplen 2
set samples 400
plot [0:1] quadratic(share(x)) with lines linewidth 2 linecolor rgb "#0b3d91" title "quadratic", \
     sinusoidal(share(x)) with lines linewidth 2 dashtype 2 linecolor rgb "#c8102e" title "sinusoidal"
unset multiplot
