#!/bin/sh
# Memory errors and leaks, found by valgrind's memcheck: scripts/dev/valgrind.sh BUILD PROGRAM... The test programs and the replays of
# the fuzz targets, and the commands below, as many at a time as there are cores (JOBS=N: as N). A line for each; of one that
# fails, what valgrind said. Ends with "N clean, M not".
#
# Numbers are not judged: valgrind computes long double with 64 bits, and it keeps one signal for itself, so that tests of either
# fail. A program has to come to its end without a memory error, whatever its own verdicts are. Random cases are thinned out
# (SCALLOP_TEST_THIN: tests/support/check.h): a memory error is in a way through the code, and not in a number.
set -u
build=$1
shift
logs=$build/valgrind
export OMP_NUM_THREADS=2 OMP_WAIT_POLICY=passive SCALLOP_TEST_THIN="${SCALLOP_TEST_THIN:-20}"

memcheck() { # NAME COMMAND...: its exit code
  name=$1
  shift
  rm -f "$logs/$name".*.log
  # A process writes into a file of its own, which stays empty where nothing is wrong: some tests make others, and end them
  valgrind -q --error-exitcode=99 --leak-check=full --num-callers=20 --suppressions=scripts/dev/valgrind.supp \
    --log-file="$logs/$name.%p.log" "$@" </dev/null >"$logs/$name.out" 2>&1
}
ended() { # NAME CODE WANTED
  case $1 in
    test_*) grep -q '^\[==========\] [0-9]* test(s) run' "$logs/$1.out" ;;
    *) [ "$2" = "$3" ] ;;
  esac
}
judge() { # CODE NAME COMMAND...: a line, and how it ended as the exit code
  wanted=$1 name=$2 begun=$(date +%s)
  shift 2
  memcheck "$name" "$@"
  code=$?
  # A failed assertion of cmocka jumps out of its test, and what the test holds is lost: then only errors count
  if [ -n "$(cat "$logs/$name".*.log)" ] && grep -q '^\[  FAILED' "$logs/$name.out"; then
    memcheck "$name" --leak-check=no "$@"
    code=$?
  fi
  if [ -n "$(cat "$logs/$name".*.log)" ] || [ $code = 99 ]; then
    echo "FAIL $name: $*"
    cat "$logs/$name".*.log
  elif ! ended "$name" $code "$wanted"; then
    echo "FAIL $name: exit code $code before its end: $*"
    tail -n 3 "$logs/$name.out"
  else
    echo "ok   $name ($(($(date +%s) - begun)) s)"
  fi
}
if [ "${1-}" = --judge ]; then # CODE NAME COMMAND..., from xargs below
  shift
  judge "$@"
  exit 0
fi

rm -rf "$logs"
mkdir -p "$logs"
programs() { # PROGRAM...: a line for each, as judge() takes it
  for program in "$@"; do
    name=$(basename "$program")
    case $name in
      # Minutes each; the commands below and the programs beside them take the same ways
      test_bounds | test_certified | test_claims | test_claims_words | test_derived | test_digits) ;;
      fuzz_*) echo 0 "$name" "$program" tests/corpus/"${name#fuzz_}"/* ;;
      *) echo 0 "$name" "$program" ;;
    esac
  done
}
printf 'h err\n1 0.5\n0.5 0.12\n0.25 0.0301\n0.125 0.0075\n0.0625 0.00187\n' >"$logs/order.txt"
printf 'T\tgait\tF1\n1\tquadratic\t4\n0.5\tsinusoidal\t3\n-1\tquadratic\t4\n' >"$logs/bad.tsv"
commands() { # of each its exit code and its arguments
  cat <<END
0 steady
0 steady --gait sinusoidal --T 3 --format json -o $logs/steady.json
0 steady --points tests/support/reference.tsv
3 steady --points $logs/bad.tsv
0 phase --v0 2.5
0 phase --phase contraction --gait sinusoidal --v0 -1 --format json
0 trajectory --periods 3 --samples 50 -o $logs/trajectory.tsv
0 trajectory --start rest --gait sinusoidal
0 series --T 0.1
0 order $logs/order.txt
1 order $logs/order.txt --expect 3
0 figure 4
2 steady --Tee 1
END
  [ ! -f "$build/scallop-flint.so" ] || cat <<END
0 steady --certified --digits 60
3 steady --certified --points $logs/bad.tsv
0 phase --certified --gait sinusoidal --digits 100
0 series --source derived --order 9 --v0 2 --format json
0 series --source derived --gait sinusoidal --digits 30 --order 6
0 series --source limit
0 series --bound --order 4
0 stress --T 0.5
0 stress --cases 3
0 stress --phase contraction --v0 -1 --gait sinusoidal --format json
0 claims --errors eq14_dT,eq28_displacement --gait quadratic
0 claims --quiet
0 workprec --quick --limit 0.01
END
}
{
  programs "$@"
  commands | grep -n '' | while IFS=': ' read -r number code arguments; do
    echo "$code $number-${arguments%% *} $build/scallop $arguments"
  done
} | xargs -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -L 1 sh scripts/dev/valgrind.sh "$build" --judge | tee "$logs/said"
clean=$(grep -c '^ok ' "$logs/said") dirty=$(grep -c '^FAIL ' "$logs/said")
echo "$clean clean, $dirty not"
[ "$dirty" = 0 ]
