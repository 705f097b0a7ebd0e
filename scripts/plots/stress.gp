# The largest error of every family of cases of `scallop stress`, in units, beside the promise. A family has a row for each gait, quadratic first.
eval picture(480, 560, 12)
promised = system("sed -n 's/^# promised, in units: error \\([0-9.]*\\),.*/\\1/p' '".table."'") + 0
family(row) = -floor((row - 1) / 2) # the header was row 0
stats table using 8 skip 1 nooutput
set lmargin 24
set xrange [0:promised * 1.04]
set yrange [family(STATS_records) - 0.6:0.6]
set xlabel "largest error, in units\n" offset 0,0.6
set key below center horizontal
set grid xtics lc rgb "#dddddd" lt 1
set arrow 1 from promised,graph 0 to promised,graph 1 nohead lw 1.5 lc rgb two
plot table using (strcol(2) eq "quadratic" ? $8 : NaN):(family($0)):ytic(1) skip 1 with points pt 7 ps 0.9 lc rgb one title "quadratic gait", \
     table using (strcol(2) eq "sinusoidal" ? $8 : NaN):(family($0)) skip 1 with points pt 13 ps 1.1 lc rgb two title "sinusoidal gait", \
     keyentry with lines lw 1.5 lc rgb two title "promised"
