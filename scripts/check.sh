#!/bin/sh
# Runs every test and counts: scripts/check.sh BUILD TEST_PROGRAM... Ends with one line, "N passed, M failed".
set -u
build=$1
shift
passed=0 failed=0
log=$build/check.log
: >"$log"
run() {
  name=$1
  shift
  if "$@" >"$build/one.log" 2>&1; then
    count=$(grep -c -e '^\[       OK \]' -e '^ok ' "$build/one.log")
    if [ "$count" = 0 ]; then
      case $name in
        test_* | cli_* | fuzz_*) failed=$((failed + 1)); echo "FAIL $name: it ran no test"; return ;;
        *) count=1 ;;
      esac
    fi
    passed=$((passed + count))
    echo "ok   $name ($count)"
  else
    bad=$(grep -c '^\[  FAILED  \] [a-z]' "$build/one.log")
    [ "$bad" -gt 0 ] || bad=1
    failed=$((failed + bad))
    echo "FAIL $name"
    cat "$build/one.log"
  fi
  cat "$build/one.log" >>"$log"
}
for program in "$@"; do
  name=$(basename "$program")
  case $name in
    fuzz_*) run "$name" "$program" tests/corpus/"${name#fuzz_}"/* ;;
    *) run "$name" "$program" ;;
  esac
done
for script in tests/cli_*.sh; do
  case $script in
    *_without_flint.sh) run "$(basename "$script")" sh "$script" "$build/scallop" ;;
    *) [ "${WITH_FLINT:-1}" = 0 ] || run "$(basename "$script")" sh "$script" "$build/scallop" ;;
  esac
done
same_tables() {
  rm -rf "$build/tables"
  sh scripts/tables.sh "$build/scallop" "$build/tables" && for table in "$build"/tables/*.tsv; do
    cmp "$table" "data/$(basename "$table")" || return 1
  done && [ "$(ls data)" = "$({ ls "$build/tables"; echo workprec.tsv; } | sort)" ] # that one has times: tests/cli_workprec.sh
}
if [ "${WITH_FLINT:-1}" != 0 ]; then
  run "data/ is what the tool writes" same_tables
  run "verdicts are those of data/claims.tsv" "$build/scallop" claims --check
fi
run "reference table, every 40th row" /usr/bin/python3 scripts/reference.py --check tests/reference.tsv --every 40
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
