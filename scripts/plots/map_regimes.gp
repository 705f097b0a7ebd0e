# Regions of the same modes over (froude, alpha) and (F1/F2, froude): the regime by colour from a grid, the boundaries from
# their parts, a number in each region and what it stands for below. tables: of grids and numbers, which maps.sh writes.
eval picture(1250, 820, 15)
set datafile columnheaders
set border 15
set xtics out nomirror
set ytics out nomirror
set palette defined (0 "#d9e7f7", 1 "#fbe3b5", 2 "#e2e2e2")
set cbrange [0:2]
unset colorbox
unset key
colour(r) = r eq "sliding" ? 0 : r eq "stick-slip" ? 1 : r eq "at-rest" ? 2 : NaN
set multiplot
many = 0
array grids[2] = [ "froude_alpha", "ratio_froude" ]
array names[2] = [ "Froude number  M L / (T^2 (F_1 + F_2))", "F_1 / F_2" ]
array ynames[2] = [ "α", "Froude number  M L / (T^2 (F_1 + F_2))" ]
do for [k=1:2] {
  set lmargin at screen (k == 1 ? 0.05 : 0.555)
  set rmargin at screen (k == 1 ? 0.49 : 0.99)
  set tmargin at screen 0.95
  set bmargin at screen 0.38
  set logscale x
  if (k == 2) { set logscale y } else { unset logscale y }
  if (k == 1) { set xrange [0.01:100]; set yrange [0.01:0.99] } else { set xrange [0.1:10]; set yrange [0.003:100] }
  set format x "%g"
  set format y "%g"
  set xlabel names[k] offset 0,0.3
  set ylabel ynames[k] offset 1,0
  set title (k == 1 ? "quadratic gait, m_1 = m_2, F_1 / F_2 = 4" : "quadratic gait, m_1 = m_2, α = 3/4") offset 0,-0.5
  grid = work."/map_".grids[k]."_grid.tsv"
  parts = tables."/map_".grids[k].".tsv"
  numbers = work."/map_".grids[k]."_numbers.tsv"
  half = 0.55 * 0.98 / 89 # a little more than half of a cell: no seams
  step = 10**(0.55 * (k == 1 ? 4 : 2) / 89)
  ystep = 10**(0.55 * log10(100 / 0.003) / 89)
  plot grid using 1:2:($1/step):($1*step):(k == 1 ? $2-half : $2/ystep):(k == 1 ? $2+half : $2*ystep):(colour(strcol("regime"))) with boxxyerror fillstyle solid noborder fillcolor palette, \
    parts using 1:2:($3 - $1):($4 - $2) with vectors nohead lw 1.6 lc rgb "black", \
    parts using 1:2 with points pt 7 ps 0.1 lc rgb "black", \
    numbers using 2:3:1 with labels font "DejaVu Sans Bold,".(kind eq "png" ? "15" : "12") textcolor rgb "black"
  unset logscale
  set xrange [*:*]
  set yrange [*:*]
  stats numbers using 1 nooutput
  many = int(STATS_records)
  unset xlabel
  unset ylabel
  unset title
  unset border
  unset tics
  set xrange [0:1]
  set yrange [0:1]
  set bmargin at screen 0.0
  set tmargin at screen 0.30
  lines = (many + 1) / 2
  y_of(n) = 0.97 - 0.93 * (int(n-1) % lines) / (lines < 6 ? 6 : lines)
  plot numbers using (($0 >= lines ? 0.52 : 0)):(y_of($0 + 1)):(sprintf("%d", $1)) with labels left font "DejaVu Sans Bold,".(kind eq "png" ? "14" : "11"), \
    numbers using (($0 >= lines ? 0.57 : 0.05)):(y_of($0 + 1)):(stringcolumn(4)) with labels left font "DejaVu Sans Mono,".(kind eq "png" ? "13" : "10"), \
    numbers using (($0 >= lines ? 0.57 : 0.05) + 0.25):(y_of($0 + 1)):(stringcolumn(5)) with labels left font "DejaVu Sans,".(kind eq "png" ? "13" : "10")
  set border 15
  set xtics out nomirror
  set ytics out nomirror
}
unset multiplot
