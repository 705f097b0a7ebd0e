# How far the published displacement (28) can be trusted, and the derived terms below T^8: the largest T up to which the relative error
# stays below 1 % and 1e-6, over (F1/F2, alpha). Grey: as T -> 0 the error tends to a limit above that.
eval picture(1100, 900, 15)
set datafile columnheaders
set logscale x
set logscale cb
set logscale z
set border 15
set xtics out nomirror
set ytics out nomirror
set xrange [0.01:100]
set yrange [0.01:0.99]
set cbrange [0.05:10]
set format x "%g"
set palette defined (0 "#3b1f6b", 1 "#2f5d9b", 2 "#2a9d8f", 3 "#9fcf6f", 4 "#fff3a0")
set cblabel "T*: the error is smaller up to this period; grey: its limit for T = 0 is larger (quadratic, m_1 = m_2 = 1, F_2 = 1, L = 10)"
unset key
series = "published derived_8"
tolerances = "1e-2 1e-6"
titles = "'published (28), 1 %' 'published (28), 1e-6' 'derived, terms below T^8, 1 %' 'derived, terms below T^8, 1e-6'"
step = 10**(0.55 * 4.0 / 39)
half = 0.55 * 0.98 / 39
set multiplot
do for [k=0:3] {
  side = k % 2
  set lmargin at screen (side == 0 ? 0.065 : 0.49)
  set rmargin at screen (side == 0 ? 0.455 : 0.88)
  set tmargin at screen (k < 2 ? 0.955 : 0.455)
  set bmargin at screen (k < 2 ? 0.57 : 0.07)
  set title word(titles, k+1) offset 0,-0.5
  set xlabel (k < 2 ? "" : "F_1 / F_2") offset 0,0.3
  set ylabel (side == 0 ? "α" : "") offset 1,0
  if (k == 1) { set colorbox user origin 0.905,0.15 size 0.018,0.7 } else { unset colorbox }
  name = "reach_".word(tolerances, side+1)."_".word(series, k < 2 ? 1 : 2)
  T(x) = x > 0 && x < 1e300 ? (x < 0.05 ? 0.05 : x > 10 ? 10 : x) : NaN
  plot table using 1:2:($1/step):($1*step):($2-half):($2+half):(T(column(name))) with boxxyerror fillstyle solid noborder fillcolor palette, \
    table using 1:(column(name) == 0 ? $2 : NaN):($1/step):($1*step):($2-half):($2+half) with boxxyerror fillstyle solid noborder fillcolor rgb "#dddddd"
}
unset multiplot
