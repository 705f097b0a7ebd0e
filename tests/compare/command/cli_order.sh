#!/bin/sh
# What order concludes, from which tables, in which formats.
# Usage: sh tests/compare/command/cli_order.sh build/scallop. One line for each check; non-zero if any failed.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

square='1 1\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n'

# ---- verdicts ----
verdict() { # NAME VERDICT EXPECTED: of table.txt
  code=1
  [ "$2" != pass ] || code=0
  run $code order table.txt --expect "$3"
  [ "$(cells out verdict)" = "$2" ] || note "$(tail -n 2 out)"
  cp out table.out
  run $code order table.txt --expect "$3" --format json
  head -n 1 out | grep -q -F "\"verdict\": \"$2\"" || note "json: $(head -n 1 out)"
  run $code order table.txt --expect "$3" --rows
  cp out rows.out
  finish "order: $1: $2"
}
used() { cells rows.out use | grep -c "^$1\$"; }
table() { printf '%b' "$1" >table.txt; }
table "$square"
verdict "h^2" pass 2
verdict "h^2 where 3 is expected" too-low 3
verdict "h^2 where 1 is expected" too-high 1
run 0 order table.txt --expect 2.25 --tol 0.3
run 1 order table.txt --expect 2.25 --tol 0.2
run 0 order table.txt
[ "$(cells out verdict)" = measured ] || note "a verdict without --expect: $(tail -n 1 out)"
finish "order: --tol, and no verdict without --expect"
table "h err\n$square"
verdict "a header" pass 2
table "err what h\n1 a 1\n0.25 b 0.5\n0.0625 c 0.25\n0.015625 d 0.125\n"
verdict "columns in another order, one more" pass 2
table '0.25 0.0625\n1 1\n0.125 0.015625\n0.5 0.25\n'
verdict "unsorted" pass 2
[ "$(cells rows.out h | tr '\n' ' ')" = '1 0.5 0.25 0.125 ' ] || note "not sorted: $(cells rows.out h)"
finish "order: rows by falling h"
table '1 -1\n0.5 -0.25\n0.25 -0.0625\n0.125 -0.015625\n'
verdict "negative errors" pass 2
awk 'BEGIN { n = split("1 0.7 0.3 0.2 0.11 0.05 0.013 0.01", h, " "); for (i = 1; i <= n; i++) printf "%s %.17g\n", h[i], 3 * h[i] ^ 1.5 }' >table.txt
verdict "unequal refinement" pass 1.5
awk 'BEGIN { for (h = 1; h > 1e-5; h /= 2) printf "%.17g %.17g\n", h, h * h + h ^ 3 }' >table.txt
verdict "h^2 + h^3" pass 2
[ "$(used used)" -eq 17 ] || note "$(used used) of 17 rows are used"
finish "order: a correction that dies away leaves no row out"
awk 'BEGIN { for (i = 0; i < 9; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, i < 3 ? h : 4 * h * h } }' >table.txt
verdict "an early kink" pass 2
awk 'BEGIN { for (i = 0; i < 24; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, h * h + 1e-10 * (1 + i % 2) } }' >table.txt
verdict "a floor far down" pass 2
[ "$(used floor)" -ge 5 ] || note "only $(used floor) rows at the floor"
finish "order: rows at the floor are left out"
table '1 1\n0.5 0.25\n0.25 1.1e-16\n0.125 0.9e-16\n0.06 1e-16\n0.03 1.2e-16\n'
verdict "a floor high up" floor-limited 2
table 'h err noise\n1 1e-16 1e-16\n0.5 2e-16 1e-16\n0.25 1e-16 1e-16\n0.125 0 1e-16\n'
verdict "nothing above its noise" floor-limited 2
table '1 0\n0.5 0\n0.25 0\n0.125 0\n'
verdict "zeros" pass 2
table '1 0\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n0.0625 0.00390625\n'
verdict "a zero among others" pass 2
[ "$(used zero)" -eq 1 ] || note "$(used zero) zeros"
finish "order: a zero is left out"
table '1 -0.3\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n0.0625 0.00390625\n'
verdict "a change of sign" pass 2
[ "$(used before-sign-change)" -eq 1 ] || note "$(used before-sign-change) before a change of sign"
finish "order: what is before a change of sign is left out"
table '1 1\n0.5 2\n0.25 4\n0.125 8\n'
verdict "growing errors" too-low 2
table '1 1\n0.5 1\n0.25 1\n0.125 1\n'
verdict "errors that do not fall" too-low 2
table '1 1\n0.5 0.9\n0.25 0.1\n0.125 0.09\n0.0625 0.001\n'
verdict "jagged errors" scattered 2
table '1 1\n0.5 0.25\n'
verdict "two points" insufficient 2
table '1 1\n'
verdict "one point" insufficient 2
for point in '0.5 nan' '0.5 inf' 'nan 1' 'inf 1' '0 1' '-0.5 1' '1 1'; do
  table "1 1\n$point\n0.25 0.0625\n0.125 0.015625\n0.0625 0.00390625\n"
  verdict "a point '$point'" invalid 2
done
awk 'BEGIN { print "h value"; for (i = 0; i < 7; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, 3 + h * h } }' >table.txt
verdict "values, by Richardson" pass 2
[ "$(rows rows.out | wc -l)" -eq 6 ] || note "$(rows rows.out | wc -l) differences of 7 values"
[ "$(cells rows.out err | head -n 1)" = 1 ] || note "the first error: $(cells rows.out err | head -n 1)"
finish "order: 7 values give 6 errors"
awk 'BEGIN { print "h value"; n = split("1 0.7 0.4 0.3 0.2 0.15 0.1 0.06", h, " "); for (i = 1; i <= n; i++) printf "%s %.17g\n", h[i], 3 - h[i] ^ 3 }' >table.txt
verdict "values at unequal refinement" pass 3
table 'h value\n1 2\n0.5 1.25\n'
verdict "two values" insufficient 2
table 'h value\n1 2\n1 1.25\n0.5 1.1\n0.25 1\n'
verdict "values at a repeated h" invalid 2
awk 'BEGIN { print "h value"; for (i = 0; i < 7; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, 3 + h } }' >table.txt
verdict "values of order 1 where 2 is expected" too-low 2
awk 'BEGIN { print "h value"; for (i = 0; i < 40; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, 3 + h ^ 2 } }' >table.txt
verdict "values down to where they stay the same" pass 2
[ "$(used floor)" -gt 0 ] || note "no floor: $(cat table.out)"
finish "order: values that meet the roundoff floor"
table 'h value\n1 3\n0.5 3\n0.25 3\n0.125 3\n'
verdict "values that stay the same" floor-limited 2
# several series: columns of text left of h name them, in whichever order the rows come
awk 'BEGIN { print "n method case h noise err use"; for (i = 0; i < 8; i++) { h = 2 ^ -i
  printf "%d euler a %.17g 0 %.17g x\n%d heun a %.17g 0 %.17g y\n%d exact b %.17g 0 0 z\n", i, h, h, i, h, h * h, i, h } }' >table.txt
run 1 order table.txt --expect 2
[ "$(cells out series | tr '\n' ' ')" = 'euler; a heun; a exact; b ' ] || note "$(cat out)"
[ "$(cells out verdict | tr '\n' ' ')" = 'too-low pass pass ' ] || note "$(cat out)"
run 0 order table.txt --format json
python <<'END'
import json
*rows, counts = map(json.loads, open("out"))
if [(r["series"], r["order"], r["points"]) for r in rows] != [("euler; a", 1, 8), ("heun; a", 2, 8), ("exact; b", None, 0)]:
    bad(rows)
if counts != {"tables": 3, "passed": 3, "failed": 0}:
    bad(counts)
END
finish "order: one order for each series"
awk 'BEGIN { print "note h err"; for (i = 0; i < 5000; i++) printf "m%d 1 1\n", i }' >table.txt
run 2 order table.txt
grep -q 'more than 4096 series' err || note "$(cat err)"
finish "order: not more series than 4096"
exit $failed
