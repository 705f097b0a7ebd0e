#!/bin/sh
# One test of `make check`: scripts/dev/test.sh [--within RUNS PROCESS] BUILD NAME. NAME is a program of BUILD, a file of
# tests/compare/command/, or tables, claims, reference, explorer. --within: what it says goes to RUNS/NAME/log, its seconds to
# RUNS/NAME/seconds, its exit code at last to RUNS/NAME/code; when PROCESS has ended neither it nor a further one begins.
set -u
if [ "$1" = --within ]; then
  kill -0 "$3" 2>/dev/null || exit 255
  run=$2/$5 begun=$(date +%s)
  mkdir -p "$run"
  sh "$0" "$4" "$5" </dev/null >"$run/log" 2>&1
  echo $? >"$run/code.part"
  echo $(($(date +%s) - begun)) >"$run/seconds"
  mv "$run/code.part" "$run/code"
  echo "$5"
  exit 0
fi
build=$1

same_tables() {
  rm -rf "$build/tables"
  sh scripts/dev/tables.sh "$build/scallop" "$build/tables" && for table in "$build"/tables/*.tsv; do
    cmp "$table" "data/$(basename "$table")" || return 1
  done || return 1
  # map_reach, stress and workprec take minutes, or are times: tests/compare/command/cli_{breakdown,stress,workprec}.cases
  [ "$(cd data && ls ./*.tsv)" = "$(cd "$build/tables" && { ls ./*; for name in map_reach stress workprec; do echo "./$name.tsv"; done; } | LC_ALL=C sort)" ] &&
    [ "$(cd data && ls ./*.tsv | sed 's/tsv$/cfg/')" = "$(cd data/scenes && ls ./*.cfg)" ]
}
case $2 in
  *.cases) /usr/bin/python3 tests/support/cases.py "$build/scallop" "tests/compare/command/$2" ;;
  tables) same_tables ;;
  claims) "$build/scallop" claims --quiet | diff - data/claims.tsv ;;
  reference) /usr/bin/python3 scripts/python/reference.py --check tests/support/reference.tsv --every 40 ;;
  explorer) sh tests/explorer/core.sh "$build" ;;
  cli_*) sh "tests/compare/command/$2" "$build/scallop" ;;
  fuzz_*) "$build/$2" tests/corpus/"${2#fuzz_}"/* ;;
  *) "$build/$2" ;;
esac
