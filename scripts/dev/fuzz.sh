#!/bin/sh
# Runs fuzz targets one after another: scripts/dev/fuzz.sh FOLDER SECONDS TARGET... The programs are FOLDER/fuzz_TARGET. Each starts from
# what it has found before, in FOLDER/TARGET, and from tests/corpus/TARGET, which stays as it is. What breaks one is left as a file in
# FOLDER/found, with the command that replays it; then the exit code is 1.
set -u
folder=$1 seconds=$2
shift 2
failed=0
LSAN_OPTIONS=suppressions=tests/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
mkdir -p "$folder/found"
for target in "$@"; do
  program=$folder/fuzz_$target log=$folder/$target.log
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
