#!/bin/sh
# Where the time goes: instructions an answer takes, by function, counted by valgrind's callgrind, so that they repeat exactly.
# scripts/dev/instructions.sh BUILD. The difference of two runs, so that what comes before the passes does not count.
set -eu
build=$1
counts() { # what, crawlers, gait, passes: instructions and function
  valgrind --tool=callgrind --dump-instr=no --callgrind-out-file="$build/callgrind.out" \
    "$build/scallop-bench" "$1" "$2" "$3" "$4" >/dev/null 2>&1
  callgrind_annotate --auto=no --threshold=100 "$build/callgrind.out" | sed -n "1,/^-- Auto/p" | grep -E '^ *[0-9,]+ \(.*%\) ' |
    sed -E 's/^ *([0-9,]+) \([^)]*\) +/\1\t/; s/\[[^]]*\]//; s/\t.*:/\t/' | tr -d ',' | sed 's/ *$//'
}
table() { # what, crawlers, gait
  counts "$1" "$2" "$3" 100 >"$build/few.tsv"
  counts "$1" "$2" "$3" 300 >"$build/many.tsv"
  echo "# $1, $2, $3: instructions an answer"
  awk -F '\t' -v answers=12800 'NR == FNR { few[$2] += $1; next } { many[$2] += $1 }
    END { for (f in many) { n = (many[f] - few[f]) / answers; if (n >= 10) printf "%.0f\t%s\n", n, f } }' "$build/few.tsv" "$build/many.tsv" |
    sed 's/PROGRAM TOTALS/all/' | sort -rn
}
table floor regular quadratic
table steady regular quadratic
table steady stick-slip quadratic
table steady regular sinusoidal
table batch regular quadratic
table batch stick-slip quadratic
table period regular quadratic
table period regular sinusoidal
