#!/bin/sh
# scripts/dev/gates.sh on gates of its own: what fails is told, is never passed, and ends the run only in CI.
gates=$(cd "$(dirname "$0")/../../.." && pwd)/scripts/dev/gates.sh
. "$(dirname "$0")/../../support/common.sh"

cat >table <<'ROWS'
# a comment
good   ci  echo "3 passed, 0 failed"
bad    ci  echo "FAIL that one"; echo "2 passed, 1 failed"; exit 1
killed -   kill -9 $$
last   ci  cat; echo here
ROWS
sh "$gates" table logs >out 2>err
[ $? = 1 ] || note "a gate failed, and the exit code is not 1"
[ "$(awk '{ print $1, $2 }' out)" = "good passed
bad FAILED
killed FAILED
last passed" ] || note "the rows are: $(cat out)"
grep -q '^bad .* logs/bad.log: FAIL that one$' out || note "what fails is not told: $(cat out)"
[ "$(cat logs/last.log)" = here ] || note "the log of a gate has: $(cat logs/last.log)"
finish "make gates: a failure is told, and the gates behind it run"

sh "$gates" --ci table logs >out 2>err
[ $? = 1 ] || note "a gate failed in CI, and the exit code is not 1"
grep -q '^2 passed, 1 failed$' out || note "what a gate prints is not seen: $(cat out)"
[ ! -e logs/last.log ] || note "CI goes on after a failure: $(cat out)"
finish "in CI the first failure ends the run"

grep -v bad table | grep -v killed >fine
sh "$gates" fine logs >out 2>err || note "all passed, and the exit code is $?"
: >empty
sh "$gates" empty logs >out 2>err
[ $? = 2 ] || note "a table without gates passes"
finish "the exit code tells whether all gates passed"
exit $failed
