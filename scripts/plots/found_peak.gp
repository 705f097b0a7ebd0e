# The displacement over F1/F2 at alpha = 3/4 for both gaits, with the boundary where the start velocity vanishes and the highest point.
eval picture(480, 340, 12)
table = tables."/found_ratio.tsv"
array gaits[2] = [ "quadratic", "sinusoidal" ]
array boundary[2]
array peak[2]
is(g) = $1 == 0.75 && strcol(2) eq g
do for [i=1:2] {
  colour = i == 1 ? one : two
  ratio = start = NaN # of the row before: between two rows v_start changes its sign
  stats table using (is(gaits[i]) ? (start > 0 && $5 <= 0 ? boundary[i] = ratio * ($3 / ratio)**(start / (start - $5)) : 0, ratio = $3, start = $5, 1) : NaN) skip 1 nooutput
  stats table using (is(gaits[i]) ? $4 / 10 : NaN) skip 1 name "high" nooutput
  stats table using (is(gaits[i]) && $4 / 10 == high_max ? $3 : NaN) skip 1 name "at" nooutput
  peak[i] = at_max
  set arrow i from boundary[i],0 to boundary[i],high_max nohead lw 1.2 dt 3 lc rgb colour
  set label i "" at peak[i],high_max point pt 7 ps 1 lc rgb colour
}
set logscale x
set xlabel "F_1 / F_2"
set ylabel "displacement in a period, over L"
set xrange [1:200]
set yrange [0:0.5]
set key below center vertical maxrows 3
plot for [i=1:2] table using 3:(is(gaits[i]) ? $4 / 10 : NaN) skip 1 with lines lw 2 lc rgb (i == 1 ? one : two) \
       title sprintf("%s gait: highest at %.0f, boundary at %.0f", gaits[i], peak[i], boundary[i]), \
     keyentry with lines lw 1.2 dt 3 lc rgb grey title "boundary: the start velocity vanishes"
