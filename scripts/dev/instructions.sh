#!/bin/sh
# Where the time goes: instructions an answer takes, by function, counted by valgrind's callgrind, so that they repeat exactly.
# scripts/dev/instructions.sh BUILD. The difference of two runs, so that what comes before the passes does not count. The sums are written to
# BUILD/instructions.tsv and compared with bench/instructions.tsv: exit code 1 where one has risen by more than 3 %. Counts of another compiler or C
# library are not compared. To take new counts, copy the first file over the second.
set -eu
build=$1
set -- "$(${CC:-cc} -dumpfullversion), $(getconf GNU_LIBC_VERSION)"
printf '# %s\nanswer\tinstructions\n' "$1" >"$build/instructions.tsv"
counts() { # COMMAND...: instructions and function
  valgrind --tool=callgrind --dump-instr=no --callgrind-out-file="$build/callgrind.out" "$@" >/dev/null 2>&1
  callgrind_annotate --auto=no --threshold=100 "$build/callgrind.out" | sed -n "1,/^-- Auto/p" | grep -E '^ *[0-9,]+ \(.*%\) ' |
    sed -E 's/^ *([0-9,]+) \([^)]*\) +/\1\t/; s/\[[^]]*\]//; s/\t.*:/\t/' | tr -d ',' | sed 's/ *$//'
}
difference() { # WHAT, ANSWERS that many.tsv has more than few.tsv
  echo "# $1"
  awk -F '\t' -v answers="$2" 'NR == FNR { few[$2] += $1; next } { many[$2] += $1 }
    END { for (f in many) { n = (many[f] - few[f]) / answers; if (n >= 10) printf "%.0f\t%s\n", n, f } }' "$build/few.tsv" "$build/many.tsv" |
    sed 's/PROGRAM TOTALS/all/' | sort -rn | tee "$build/functions.tsv"
  sed -n "s/^\([0-9]*\)\tall\$/${1%:*}\t\1/p" "$build/functions.tsv" >>"$build/instructions.tsv"
}
table() { # what, crawlers, gait
  counts "$build/scallop-bench" "$1" "$2" "$3" 100 >"$build/few.tsv"
  counts "$build/scallop-bench" "$1" "$2" "$3" 300 >"$build/many.tsv"
  difference "$1, $2, $3: instructions an answer" 12800
}
rows() { # NUMBER: of seven parameters with six digits
  awk -v n="$1" 'function part(k) { k *= 0.6180339887; return k - int(k) }
    BEGIN { print "m1\tm2\tF1\tF2\tL\tT\talpha"
      for (i = 1; i <= n; i++) printf "%.6f\t%.6f\t%.6f\t%.6f\t%.6f\t%.6f\t%.6f\n", 0.8 + part(i) / 2, 0.8 + part(3 * i) / 2, 3 + part(7 * i),
        0.8 + part(11 * i) / 2, 1 + part(13 * i), 0.1 + part(17 * i) / 5, 0.6 + part(19 * i) / 4 }' >"$build/rows.tsv"
  counts "$build/scallop" steady --points "$build/rows.tsv"
}
table floor regular quadratic
table steady regular quadratic
table steady stick-slip quadratic
table steady regular sinusoidal
table steady regular minimum-jerk
table batch regular quadratic
table batch stick-slip quadratic
table batch regular sinusoidal
table period regular quadratic
table period regular sinusoidal
rows 1000 >"$build/few.tsv"
rows 3000 >"$build/many.tsv"
difference "steady --points: instructions a row" 2000
awk -F '\t' 'FNR == 1 { compiler[FILENAME] = $0; next }
  FNR == NR { was[$1] = $2; next }
  compiler[ARGV[1]] == compiler[FILENAME] && $2 + 0 > 1.03 * was[$1] { printf "%s: %d instructions, %d before: more than 3 %% more\n", $1, $2, was[$1]; worse = 1 }
  END {
    if (compiler[ARGV[1]] != compiler[FILENAME])
      print "not compared with bench/instructions.tsv (" substr(compiler[ARGV[1]], 3) "): this is " substr(compiler[FILENAME], 3)
    exit worse
  }' bench/instructions.tsv "$build/instructions.tsv"
