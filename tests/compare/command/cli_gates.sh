#!/bin/sh
# scripts/dev/gates.sh on gates of its own: what fails is told, is never passed, and ends the run only in CI; what was not run is named.
gates=$(cd "$(dirname "$0")/../../.." && pwd)/scripts/dev/gates.sh
. "$(dirname "$0")/../../support/common.sh"

cat >table <<'ROWS'
# a comment
good   ci  echo "3 passed, 0 failed"
bad    ci  echo "FAIL that one"; echo "2 passed, 1 failed"; exit 1
killed -   kill -9 $$
last   ci  cat; echo here
ROWS
says() { # CODE WORDS OPTION...: the first two words of each row
  wanted=$1 words=$2
  shift 2
  sh "$gates" "$@" >out 2>err
  code=$?
  [ $code = "$wanted" ] || note "$*: exit code $code, not $wanted"
  [ "$(grep -E '^(good|bad|killed|last) ' out | awk '{ print $1, $2 }' | tr '\n' ';')" = "$words" ] || note "$*: the rows are $(cat out err)"
}
says 1 'good passed;bad FAILED;killed FAILED;last passed;' table logs
grep -q '^bad .* logs/bad.log: FAIL that one$' out || note "what fails is not told: $(cat out)"
[ "$(cat logs/last.log)" = here ] || note "the log of a gate has: $(cat logs/last.log)"
finish "make gates: a failure is told, and the gates behind it run"
says 1 'good passed;bad FAILED;killed not;last not;' --ci table logs
grep -q '^2 passed, 1 failed$' out || note "what a gate prints is not seen: $(cat out)"
[ ! -e logs/last.log ] || note "CI goes on after a failure: $(cat out)"
finish "in CI the first failure ends the run"
says 0 'good passed;bad not;killed not;last not;' table logs good
grep -q '^killed  *not run: it has never passed here$' out || note "no word of a gate that never passed: $(cat out)"
grep -q -E '^last  *not run: passed 20[0-9]{2}-[0-9]{2}-[0-9]{2} [0-9]{2}:[0-9]{2} on ' out || note "no word of the last time: $(cat out)"
[ "$(grep -c '^good ' logs/passed)" = 1 ] || note "more than the last time is kept: $(cat logs/passed)"
says 2 '' table logs goood
: >empty
says 2 '' empty logs
finish "gates that are not run are named, with the last time that they passed; the exit code"
exit $failed
