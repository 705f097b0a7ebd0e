#!/bin/sh
# Runs every test, as many at a time as there are cores (JOBS=N: as N), and counts: scripts/dev/check.sh BUILD TEST_PROGRAM...
# scripts/dev/test.sh has how each is run. A line for each, in the same order whichever ends first; of one that fails, all that it said. Ends with "N passed, M failed".
set -u
build=$1
shift
at_a_time=${JOBS:-$(getconf _NPROCESSORS_ONLN)}
case $at_a_time in '' | *[!0-9]* | 0*) echo "check.sh: JOBS: '$at_a_time' is not a number of 1 or more" >&2; exit 2 ;; esac
runs=$build/check
for ran in "$runs"/*/seconds; do [ ! -f "$ran" ] || echo "$(basename "$(dirname "$ran")") $(cat "$ran")"; done >"$build/check.seconds"
rm -rf "$runs"
mkdir -p "$runs"

title() {
  case $1 in
    tables) echo "data/ is what the tool writes" ;;
    claims) echo "claims are those of data/claims.tsv" ;;
    reference) echo "reference table, every 40th row" ;;
    explorer) echo "the core of the explorer in WebAssembly" ;;
    *) echo "$1" ;;
  esac
}

passed=0 failed=0
count() { # TEST, which has ended
  log=$runs/$1/log name=$(title "$1")
  if [ ! -f "$runs/$1/code" ]; then
    failed=$((failed + 1))
    echo "FAIL $name: it did not end"
  elif [ "$(cat "$runs/$1/code")" = 0 ] && grep -q '^skipped: ' "$log"; then
    echo "skip $name: $(sed -n 's/^skipped: //p' "$log")"
  elif [ "$(cat "$runs/$1/code")" = 0 ]; then
    count=$(grep -c -e '^\[       OK \]' -e '^ok ' "$log")
    if [ "$count" = 0 ]; then
      case $1 in
        test_* | cli_* | fuzz_*) failed=$((failed + 1)); echo "FAIL $name: it ran no test"; return ;;
        *) count=1 ;;
      esac
    fi
    passed=$((passed + count))
    echo "ok   $name ($count)"
  else
    bad=$(sed -n 's/^\[  FAILED  \] \([a-z0-9_]*\)$/\1/p' "$log" | sort -u | grep -c .) # cmocka names each where it fails, and in a list
    [ "$bad" -gt 0 ] || bad=1
    failed=$((failed + bad))
    echo "FAIL $name"
    cat "$log"
  fi
}
report() { # TEST...: each as soon as it and those before it have ended, which the lines of standard input tell
  for test in "$@"; do
    until [ -f "$runs/$test/code" ] || ! read -r _; do :; done
    count "$test"
    cat "$runs/$test/log" >>"$build/check.log"
  done
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ]
}

together='' alone=''
for script in tests/compare/command/cli_*; do
  name=$(basename "$script")
  case $name in
    cli_workprec.*) [ "${WITH_FLINT:-1}" = 0 ] || alone="$alone $name" ;; # beside others its own runs pass the limits it gives them
    *_without_flint.*) together="$together $name" ;;
    *) [ "${WITH_FLINT:-1}" = 0 ] || together="$together $name" ;;
  esac
done
[ "${WITH_FLINT:-1}" = 0 ] || together="$together tables claims"
together="$together reference explorer"
for program in "$@"; do
  together="$together $(basename "$program")"
done
: >"$build/check.log"
each() { # NUMBER-AT-A-TIME TEST...: those that took longest in the last run first, so that the others fill the cores beside them
  number=$1
  shift
  [ $# = 0 ] || printf '%s\n' "$@" | awk 'FILENAME != "-" { took[$1] = $2; next } { print $1 in took ? took[$1] : 9999, $1 }' "$build/check.seconds" - |
    sort -s -r -n | cut -d ' ' -f 2 | xargs -P "$number" -n 1 sh "$(dirname "$0")/test.sh" --within "$runs" $$ "$build"
}
# shellcheck disable=SC2086
{ each "$at_a_time" $together; each 1 $alone; } | report $together $alone
