#!/bin/sh
# Builds the fuzz targets with libFuzzer (needs clang) and runs them one after another: fuzz.sh BUILD, MAKE being set. FUZZ_SECONDS (60) for
# each of FUZZ_TARGETS (all). Each starts from what it has found before, in BUILD/fuzz/TARGET, and from tests/corpus/TARGET, which stays as
# it is. What breaks one is left as a file in BUILD/fuzz/found, with the command that replays it; then the exit code is 1.
set -u
folder=$1/fuzz seconds=${FUZZ_SECONDS:-60} failed=0
"${MAKE:-make}" fuzz-programs CC=clang B="$folder" WITH_OPENMP=0 FUZZER=-fsanitize=fuzzer \
  CFLAGS="-O1 -g -fno-omit-frame-pointer -Wno-pass-failed -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all" || exit 2
LSAN_OPTIONS=suppressions=tests/support/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
mkdir -p "$folder/found"
for target in ${FUZZ_TARGETS:-$(find tests/fuzz -name 'fuzz_*.c' | sed 's|.*/fuzz_\(.*\)\.c|\1|' | sort)}; do
  program=$folder/fuzz_$target log=$folder/$target.log
  [ -x "$program" ] || continue # a build without FLINT
  mkdir -p "$folder/$target"
  cp tests/corpus/"$target"/* "$folder/$target"
  "$program" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 -dict=tests/fuzz/words.dict \
    -artifact_prefix="$folder/found/$target-" "$folder/$target" >"$log" 2>&1
  code=$?
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  covered=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
  if [ $code = 0 ]; then
    echo "ok   $target: $executions executions, $covered edges covered"
  else
    failed=1
    file=$(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)
    echo "FAIL $target: $(grep -m 1 -e '^fuzz: ' -e 'ERROR: ' -e 'runtime error' "$log")"
    echo "     replay: $program $file"
  fi
done
exit $failed
