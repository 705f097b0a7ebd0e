# The largest error of every family of cases of `scallop stress`, in units, beside the bound. A family has a row for each gait, or one for its own.
bound = system("sed -n 's/^# bounds, in units: error \\([0-9.]*\\),.*/\\1/p' '".table."'") + 0
families = system("grep -v '^#' '".table."' | tail -n +2 | cut -f 1 | uniq | wc -l") + 0
eval picture(480, 110 + 19 * families, 12)
before = ""
line = 1
family(name) = (line = name eq before ? line : before eq "" ? 1 : line - 1, before = name, line) # the header is line 1, outside
set lmargin 24
set xrange [0:bound * 1.04]
set yrange [0.4 - families:0.6]
set xlabel "largest error, in units\n" offset 0,0.6
set key below center horizontal
set grid xtics lc rgb "#dddddd" lt 1
set arrow 1 from bound,graph 0 to bound,graph 1 nohead lw 1.5 lc rgb two
plot table using (y = family(strcol(1)), strcol(2) eq "quadratic" ? $8 : NaN):(y):ytic(1) skip 1 with points pt 7 ps 0.9 lc rgb one title "quadratic gait", \
     before = "", table using (y = family(strcol(1)), strcol(2) eq "sinusoidal" ? $8 : NaN):(y) skip 1 with points pt 13 ps 1.1 lc rgb two title "sinusoidal gait", \
     before = "", table using (y = family(strcol(1)), strcol(2) ne "quadratic" && strcol(2) ne "sinusoidal" ? $8 : NaN):(y) skip 1 with points pt 9 ps 1 lc rgb "#666666" title "a gait of its own", \
     keyentry with lines lw 1.5 lc rgb two title "bound"
