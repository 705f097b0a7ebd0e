# Mean velocity over F1/F2 from 1 to 10^4, past the paper's range, with the boundaries between sequences of modes: alpha = 3/4, T = 1.
eval picture(900, 800, 15)
set datafile columnheaders
set logscale x
set xtics out nomirror
set ytics out nomirror 0,1,4
set xrange [1:1e4]
set yrange [-0.3:6.4]
set ylabel "mean velocity" offset 0.5,0
set xzeroaxis lt 1 lc rgb "#bbbbbb"
unset key
small = "DejaVu Sans,".(kind eq "png" ? "13" : "10")
# where the boundaries come to the edge T = 1 of their map
here(n) = column("T") == 1 ? column("F1/F2") : column("to_T") == 1 ? column("to_F1/F2") : NaN
first(w) = w[1:14] eq "start velocity" || w[1:12] eq "body 1 is st"
second(w) = !first(w)
what(w) = w[1:14] eq "start velocity" ? "start velocity changes sign " \
  : w[1:12] eq "body 1 is st" ? "sticks in both phases " \
  : w[1:16] eq "onset of stickin" ? " body 1 sticks in the extension" \
  : w[1:14] eq "permanent rest" ? " permanent rest of body 1" : w
set multiplot layout 3,1 title "quadratic gait, m_1 = m_2 = 1, L = 10, T = 1, α = 3/4; dotted: boundaries between regions of the same modes"
do for [i=1:3] {
  F2 = word("0.5 1 2", i)
  colour = word("#0b3c8c #c8102e #2a9d4a", i)
  changes = tables."/map_changes_".F2.".tsv"
  set label 1 "F_2 = ".F2 at graph 0.02,0.9 textcolor rgb colour
  set format x (i == 3 ? "10^{%T}" : "")
  set xlabel (i == 3 ? "F_1 / F_2" : "")
  plot changes using (here(0)):(-0.3):(0):(first(strcol("change")) ? 6.3 : 5.6) with vectors nohead lw 1.2 dt 3 lc rgb "#555555", \
    changes using (first(strcol("change")) ? here(0) : NaN):(5.9):(what(strcol("change"))) with labels right font small, \
    changes using (second(strcol("change")) ? here(0) : NaN):(5.1):(what(strcol("change"))) with labels left font small, \
    tables."/map_velocity_".F2.".tsv" using 1:(column("mean_velocity")) with lines lw 2.5 lc rgb colour
}
unset multiplot
