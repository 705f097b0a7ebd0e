#!/bin/sh
# Is the bound of the error kept whatever the compiler makes of the code? scripts/dev/matrix.sh BUILD, MAKE being set: gcc and clang,
# without optimisation and with all of it, with and without fused multiply-add, each built in a folder of its own in BUILD/matrix. Ends with a table.
set -u
folder=$1/matrix at_a_time=${JOBS:-$(getconf _NPROCESSORS_ONLN)}
tests='reference certified laws symmetry batch shortcuts wide'
results=$folder/results.tsv
failed=0
mkdir -p "$folder"
: >"$results"

try() { # BUILD NAME COMMAND...
  build=$1 name=$2
  shift 2
  if "$@" >"$build/$name.log" 2>&1; then
    passed_here=$((passed_here + 1))
  else
    failed_here="$failed_here $name"
    echo "FAIL $name: $build/$name.log"
    grep -e '^ERROR' -e '^got' -e 'to see it' -e '^\[  FAILED  \] [a-z]' "$build/$name.log" | head -n 12
  fi
}
for compiler in gcc clang; do
  for optimisation in -O0 '-O3 -march=native'; do
    for contraction in off fast; do
      flags="$optimisation -ffp-contract=$contraction"
      build=$folder/$compiler${optimisation%% *}-$contraction
      mkdir -p "$build"
      passed_here=0 failed_here=''
      echo "$compiler $flags"
      programs=$build/scallop
      for test in $tests; do
        programs="$programs $build/test_$test"
      done
      # With -O3 gcc warns of arrays that it takes for too small: warnings are the business of the other builds. CONTRACTED: tests/support/check.h
      told="-Wno-error"
      [ $contraction = off ] || told="$told -DCONTRACTED"
      # shellcheck disable=SC2086
      try "$build" build $MAKE -j"$at_a_time" --no-print-directory CC=$compiler B="$build" CFLAGS="$flags $told" $programs
      if [ -z "$failed_here" ]; then
        try "$build" stress "$build/scallop" stress --check
        for test in $tests; do
          try "$build" "test_$test" "$build/test_$test"
        done
      fi
      [ -z "$failed_here" ] || failed=1
      printf '%-8s %-36s %2d passed, failed:%s\n' $compiler "$flags" $passed_here "${failed_here:- none}" >>"$results"
    done
  done
done
cat "$results"
exit $failed
