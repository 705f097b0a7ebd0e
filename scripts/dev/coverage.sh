#!/bin/sh
# Which lines and branches of the library the tests reach: scripts/dev/coverage.sh BUILD. Builds in BUILD/coverage for counting, runs every test and
# prints a table. Exit code 1 if a test failed, a line was not reached, or fewer than 95 % of the branches were taken.
# Of the branches only those that are in the source count: without optimization, functions not inlined (once each, not where they
# are used), no clones for other processors, no threads; counts are atomic all the same, as one lost would stop gcovr.
set -eu
build=$1/coverage
mkdir -p "$build"
find "$build" -name '*.gcda' -delete # counts are added to those of earlier runs
export GCOV_ERROR_FILE="$PWD/$build/lost.txt"
: >"$GCOV_ERROR_FILE"
passed=1
"${MAKE:-make}" --no-print-directory check B="$build" WITH_OPENMP=0 CFLAGS="-O0 -g --coverage -fprofile-update=atomic" \
  CPPFLAGS="${CPPFLAGS:-} -D'SCALLOP_INLINE=static inline' -DVECTOR=" || passed=0
[ ! -s "$GCOV_ERROR_FILE" ] || { echo "coverage: counts were lost:" >&2; cat "$GCOV_ERROR_FILE" >&2; exit 1; }

count() { # OPTION...
  gcovr --root . --filter 'model/' --filter 'asymptotics/' --filter 'numerics/' \
    --exclude-unreachable-branches --exclude-throw-branches "$@"
}
count --object-directory "$build" --json "$build/counts.json" "$build"
count --add-tracefile "$build/counts.json" --csv "$build/counts.csv"
count --add-tracefile "$build/counts.json" --txt "$build/lines.txt"
count --add-tracefile "$build/counts.json" --branches --txt "$build/branches.txt"
awk -F , '
  function row(name, l, reached, b, taken) {
    printf "%-30s %6d %6d %6.1f %%  %6d %6d %6.1f %%\n", name, l, reached, l ? 100 * reached / l : 100, b, taken, b ? 100 * taken / b : 100
  }
  function total(name) { row(name, l[name], reached[name], b[name], taken[name]) }
  function add(name) { l[name] += $2; reached[name] += $3; b[name] += $5; taken[name] += $6 }
  NR == 1 { printf "%-30s %6s %6s %8s  %8s %6s %8s\n", "", "lines", "reached", "", "branches", "taken", ""; next }
  { row($1, $2, $3, $5, $6); split($1, path, "/"); if (!(path[1] in l)) folder[++folders] = path[1]; add(path[1]); add("all") }
  END {
    for (i = 1; i <= folders; i++) total(folder[i])
    total("all")
    exit !folders || reached["all"] < l["all"] || 100 * taken["all"] < 95 * b["all"]
  }' "$build/counts.csv" || passed=0
echo "not reached: $build/lines.txt, $build/branches.txt"
[ $passed = 1 ]
