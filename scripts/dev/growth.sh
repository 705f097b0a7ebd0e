#!/bin/sh
# How the cost grows: processor instructions (valgrind's callgrind) of commands whose size is doubled again and again, and the exponent that
# `scallop order` fits to each: scripts/dev/growth.sh BUILD. The count at the smallest size, which contains the start of the program, is
# subtracted from the others. Writes BUILD/growth.tsv and prints the exponents, with a minus, as they are those of 1/n. Takes some minutes.
set -eu
build=$1 scallop=$1/scallop
instructions() { # ARGUMENT...
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$scallop" "$@" --quiet 2>&1 >/dev/null | sed -n 's/,//g; s/.*refs: *//p'
}
recording() { # ROWS: of a motion out and back, in unequal steps
  awk -v n="$1" 'BEGIN { for (i = 0; i <= n; i++) { x = i / n; printf "%.6f\t%.6f\n", x, 1 - cos(6.283185307 * (x + 0.02 * sin(6.283185307 * x))) } }' >"$build/growth.rows"
}
grows() { # WHAT FIRST-SIZE LARGEST-SIZE ARGUMENT...: N is the size, ROWS a table of so many rows
  what=$1 size=$2 largest=$3
  shift 3
  start=''
  while [ "$size" -le "$largest" ]; do
    recording "$size"
    # shellcheck disable=SC2046
    count=$(instructions $(printf '%s\n' "$@" | sed "s/\bN\b/$size/; s#\bROWS\b#$build/growth.rows#"))
    if [ -z "$start" ]; then start=$count; else printf '%s\t%d\t%d\n' "$what" "$size" $((count - start)); fi
    size=$((2 * size))
  done
}
{
  printf 'what\tn\tinstructions\n'
  grows 'rows' 250 8000 steady --T 0.5:1:N --threads 1
  grows 'digits' 100 3200 steady --gait sinusoidal --certified --digits N
  grows 'order, in fractions' 8 256 series --source derived --order N
  grows 'order, in balls' 50 400 series --source derived --gait sinusoidal --order N
  grows 'rows of a recording' 25 800 steady --gait measured:ROWS
} >"$build/growth.tsv"
"$scallop" order "$build/growth.tsv" --x 1/n --y instructions --columns series,order,order_low,order_high,verdict --quiet
