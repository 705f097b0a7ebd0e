#!/bin/sh
# The figure of docs/reference/gaits.md: which smoothness of a measured gait the displacement needs. On the left l'' of the curves through 30 rows of the
# sinusoidal gait near the turn of l, where the exact l'' jumps; on the right the error of the displacement as rows are added.
#     scripts/plots/smoothness.sh SCALLOP FILE.png
set -eu
scallop=$1 picture=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
kinds='monotone cubic smooth phases'
size='--L 3 --T 0.5 --alpha 0.6' crawler='--m1 0.8 --m2 1.7 --F1 2.2 --F2 0.9'
record() { # ROWS: of one period of the sinusoidal gait with that size, which begins within a phase
  awk -v rows="$1" 'BEGIN {
    pi = atan2(0, -1)
    print "t\tl"
    for (i = 0; i < rows; i++) {
      t = (i/rows + 0.2371) % 1
      s = t < 0.6 ? t/0.6 : (1 - t)/0.4
      printf "%.17g\t%.17g\n", 0.5*i/rows, 3*(1 - cos(pi*s))/2
    }
  }' >"$work/rows.tsv"
}
bend() { # OPTION...: t/T, and l'' T^2/L by second differences, near the turn
  # shellcheck disable=SC2086
  "$scallop" trajectory "$@" --samples 1001 --columns t,l --quiet | awk -F '\t' '/^[0-9]/ { t[n] = $1; l[n++] = $2 }
    END { for (i = 1; i < n - 1; i++) if (t[i] > 0.25 && t[i] < 0.36) print t[i]/0.5, (l[i + 1] - 2*l[i] + l[i - 1])/(t[i] - t[i - 1])^2*0.25/3 }'
}
# shellcheck disable=SC2086
bend --gait sinusoidal $size >"$work/exact.bend"
record 30
for kind in $kinds; do
  bend --gait "measured:$work/rows.tsv:$kind:period=0.5" >"$work/$kind.bend"
done
# shellcheck disable=SC2086
exact=$("$scallop" steady --gait sinusoidal $size $crawler --columns displacement --quiet | tail -n 1)
for rows in 16 23 32 45 64 91 128 181 256 362 512; do
  record $rows
  for kind in $kinds; do
    # shellcheck disable=SC2086
    found=$("$scallop" steady --gait "measured:$work/rows.tsv:$kind:period=0.5" $crawler --columns displacement --quiet | tail -n 1)
    awk -v n=$rows -v x="$found" -v exact="$exact" 'BEGIN { e = x/exact - 1; print n, e < 0 ? -e : e }' >>"$work/$kind.error"
  done
done
gnuplot -d <<END
set terminal pngcairo size 1100,430 font 'DejaVu Sans,11' background rgb 'white'
set output '$picture'
set multiplot layout 1,2
set border 3 lw 1
set tics nomirror
set style line 1 lc rgb '#b3543e' lw 1.6 dt 4
set style line 2 lc rgb '#2f5d9b' lw 1.6 dt 2
set style line 3 lc rgb '#8a8a8a' lw 1.6 dt 5
set style line 4 lc rgb '#2a9d8f' lw 2.2
kinds = '$kinds'
set title "l'' where l turns: 30 rows, sinusoidal gait" noenhanced
set xlabel 't/T' noenhanced
set ylabel "l'' T^2/L" noenhanced
set key bottom left Left reverse samplen 3 spacing 1.1 noenhanced
set xrange [0.5:0.72]
plot '$work/exact.bend' using 1:2 with lines lc rgb 'black' lw 1.2 title 'exact', for [i=1:4] '$work/'.word(kinds, i).'.bend' using 1:2 with lines ls i title word(kinds, i)
set title 'error of the displacement' noenhanced
set xlabel 'rows of a period' noenhanced
set ylabel '|displacement/exact - 1|' noenhanced
set logscale xy
set format y '10^{%T}'
set xrange [14:600]
set xtics (16, 32, 64, 128, 256, 512)
plot for [i=1:4] '$work/'.word(kinds, i).'.error' using 1:2 with linespoints ls i pt 7 ps 0.6 title word(kinds, i)
END
