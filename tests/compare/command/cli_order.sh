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
if counts != {"tables": 3, "passed": 0, "failed": 0, "measured": 3, "not_measured": 0, "errors": 0}:
    bad(counts)
END
finish "order: one order for each series"
awk 'BEGIN { print "note h err"; for (i = 0; i < 5000; i++) printf "m%d 1 1\n", i }' >table.txt
run 2 order table.txt
grep -q 'more than 4096 series' err || note "$(cat err)"
finish "order: not more series than 4096"

# ---- which columns ----
columns() { # NAME TABLE WANTED OPTION...: the columns y and the orders to two digits
  table "$2"
  name=$1 shown=$3
  shift 3
  run 0 order table.txt "$@"
  [ "$(rows out | cut -f 3,4 | sed 's/\(\.[0-9][0-9]\)[0-9]*$/\1/' | tr '\t\n' ': ')" = "$shown " ] || note "$(cat out)"
  finish "order: $name"
}
commas='N, h, L2, H1, rate\n10, 0.1, 0.011, 0.1, -\n20, 0.05, 0.0026, 0.05, 2\n40, 0.025, 6.3e-4, 0.025, 2\n80, 0.0125, 1.57e-4, 0.0125, 2\n'
columns "commas, and no order that the table brings along" "$commas" 'L2:2.04 H1:1.00'
columns "--y" "$commas" 'H1:1.00' --y H1
columns "--y, several" "$commas" 'H1:1.00 L2:2.04' --y H1,L2
columns "--y, twice" "$commas" 'H1:1.00 L2:2.04' --y H1 --y L2,H1
columns "--y, by number" "$commas" 'L2:2.04' --y 3
columns "--x" "$commas" 'h:-1.00' --x N --y h
columns "the first column against the others" 'dx a b\n1 1 1\n0.5 0.25 0.5\n0.25 0.0625 0.25\n' 'a:2.00 b:1.00'
columns "no header" '1,1,1\n0.5,0.25,0.5\n0.25,0.0625,0.25\n' 'column 2:2.00 column 3:1.00'
columns "the index of pandas" ',h,err\n0,1,1\n1,0.5,0.25\n2,0.25,0.0625\n' 'err:2.00'
columns "the index of pandas, no h" ',dx,L2,H1\n0,1,1,1\n1,0.5,0.25,0.5\n2,0.25,0.0625,0.25\n' 'L2:2.00 H1:1.00'
columns "a comma at the end of a row" 'h,err\n1,1,\n0.5,0.25,\n0.25,0.0625,\n' 'err:2.00'
columns "err before others" 'h x err\n1 5 1\n0.5 5 0.25\n0.25 5 0.0625\n' 'err:2.00'
columns "--values" 'h u\n1 4\n0.5 3.25\n0.25 3.0625\n0.125 3.015625\n' 'u:2.00' --values
columns "tabs with commas in texts" 'case\th\terr\na, b\t1\t1\na, b\t0.5\t0.25\na, b\t0.25\t0.0625\n' 'err:2.00'

columns "--expect by name chooses columns" "$commas" 'L2:2.04 H1:1.00' --expect L2=2,H1=1
columns "--x 1/N" "$commas" 'L2:2.04' --x 1/N --y L2
columns "--per cells" "$commas" 'H1:1.00' --x N --per cells --y H1
columns "--per dofs" "$commas" 'H1:2.00' --x N --per dofs:2 --y H1
run 0 order table.txt --x N --y H1
cells out reason | grep -q 'h looks like a number of cells: --x 1/N, or --per$' || note "$(cat out)"
grep -q -x 'scallop order: note: table.txt: columns between commas; h is column 1 (N), errors: H1; rows: 4' err || note "$(cat err)"
run 1 order table.txt --expect 2,2 --y L2,H1
[ "$(cells out expected verdict | tr '\n' ' ')" = '2 pass 2 too-low ' ] || note "$(cat out)"
run 0 order table.txt --expect L2=2 --y L2,H1
[ "$(cells out comparison verdict | tr '\n' ' ')" = 'equal pass none measured ' ] || note "$(cat out)"
for wanted in 2,1,1 L2=2,1 L3=2 L2=x; do run 2 order table.txt --expect $wanted; done
run 2 order table.txt --per volumes
finish "order: an order for each column, numbers of cells"
table 'h;L2;H1\n0,1;1,1D-2;0,1\n0,05;2,6E-3;NA\n0,025;6,3e-4;0,025\n0,0125;1,57e-4;0,0125\n'
run 0 order table.txt --expect 2,1
[ "$(cells out points | tr '\n' ' ')" = '4 3 ' ] && grep -q 'rows without a value: 1$' out || note "$(cat out)"
for format in csv json markdown; do
  run 0 steady --T 0.5,0.25,0.125,0.0625 --columns T,modes,error.eq28_displacement --format $format -o again
  run 0 order again --expect 4
done
finish "order: decimal commas, cells without a value, the tool's own formats"

# ---- what passes ----
table '0.1 0.011\n0.05 0.0026\n0.025 6.3e-4\n0.0125 1.57e-4\n'
run 0 order table.txt --expect 2
run 0 order table.txt --expect 4/2
run 0 order table.txt --at-least 3/2
run 1 order table.txt --expect 3/2
run 1 order table.txt --at-least 5/2
grep -q 'below the expected 2.5 in rows 1 to 4' out || note "$(cat out)"
finish "order: fractions, --at-least"
table 'h err\n1 1\n0.5 0.25\n0.25 0.1\n0.125 nan\n0.5 0.1\n'
run 1 order table.txt --expect 2
[ "$(cells out reason)" = 'NaN in row 4; h repeated in rows 2 and 5' ] || note "$(cells out reason)"
run 0 order table.txt
run 1 order table.txt --require-measured
finish "order: the reason names the rows"
printf '1 1\n0.5 0.5\n0.25 0.25\n' >first.txt
printf '1 1\n0.5 0.25\n0.25 0.0625\n' >second.txt
run 1 order first.txt second.txt --expect 2
[ "$(cells out file verdict | tr ' \n' ': ')" = 'first.txt:too-low second.txt:pass ' ] || note "$(cat out)"
[ "$(tail -n 1 out)" = '# 2 tables: 1 passed, 1 failed' ] || note "$(tail -n 1 out)"
run 0 order first.txt second.txt --at-least 1
finish "order: several files, each has to pass"

# ---- formats ----
printf 'c<&"|\th\terr_1\na<&"|#\t1\t1\na<&"|#\t0.5\t0.25\na<&"|#\t0.25\t0.0625\n' >odd.txt
run 1 order first.txt odd.txt --expect 2 --format junit
python <<'END'
import xml.etree.ElementTree as tree
suites = tree.parse("out").getroot()
cases = suites.findall("testsuite/testcase")
found = [(case.get("classname"), case.get("name"), [f.get("type") for f in case.findall("failure")]) for case in cases]
if found != [("first.txt", "first.txt: column 2", ["too-low"]), ("odd.txt", 'odd.txt: a<&"|#: err_1', [])]:
    bad(found)
if [suites.get(name) for name in ("tests", "failures")] != ["2", "1"]:
    bad(suites.attrib)
END
finish "order: JUnit"
run 1 order first.txt odd.txt --expect 2 --format markdown
grep -q -F '| first.txt |  | column 2 | 1.0000 |' out || note "$(cat out)"
grep -q -F '| odd.txt | a&lt;&"\|# | err_1 | 2.0000 |' out || note "$(cat out)"
finish "order: Markdown"
run 0 order second.txt --expect 2 --format junit -o here.xml
[ ! -s out ] && grep -q '</testsuites>' here.xml || note "$(cat out)"
run 4 order second.txt --format junit -o none/here.xml
grep -q 'cannot write none/here.xml' err || note "$(cat err)"
if [ -c /dev/full ]; then
  "$tool" order second.txt --format markdown >/dev/full 2>err
  [ $? = 4 ] || note "no exit code 4 for a full device"
fi
finish "order: a file for the report"
run 1 order first.txt odd.txt --expect 2 -o here.tsv --quiet
[ "$(cat err)" = 'scallop order: first.txt: column 2: too-low: order 1 is 1 below the expected 2 in rows 1 to 3
scallop order: odd.txt: a<&"|#: err_1: pass: order 2 in rows 1 to 3' ] || note "$(cat err)"
finish "order: with -o the verdict on each table is a line on standard error"

# ---- no order is expected: nothing passes ----
printf '1 1\n' >short.txt
run 1 order second.txt short.txt --require-measured --format junit
grep -q 'tests="2" failures="1" errors="0" skipped="0"' out || note "$(cat out)"
run 0 order second.txt short.txt --format junit
grep -q 'tests="2" failures="0" errors="0" skipped="1"' out && grep -q '<skipped message="1 usable row' out || note "$(cat out)"
run 0 order second.txt short.txt
[ "$(cells out verdict | tr '\n' ' ')" = 'measured insufficient ' ] || note "$(cat out)"
[ "$(tail -n 1 out)" = '# 2 tables: 1 measured, 1 not measured' ] || note "$(tail -n 1 out)"
run 0 order second.txt short.txt --format json
[ "$(tail -n 1 out)" = '{"tables": 2, "passed": 0, "failed": 0, "measured": 1, "not_measured": 1, "errors": 0}' ] || note "$(tail -n 1 out)"
printf '1 0.3\n0.5 0.3\n0.25 0.3\n0.125 0.3\n' >constant.txt
run 0 order constant.txt
[ "$(tail -n 1 out)" = '# 1 table: 1 measured, 0 not measured' ] || note "$(tail -n 1 out)"
finish "order: without --expect a table is measured, and none passes"

# ---- a file that cannot be read is told, and does not stop the others ----
printf 'h err\n1 x\n' >words.txt
for format in tsv csv json table markdown junit; do
  run 4 order nowhere.txt words.txt second.txt first.txt --expect 2 --format $format -o report --quiet
  grep -q 'nowhere.txt.*cannot read nowhere.txt: No such file' report || grep -q 'reason.*cannot read nowhere.txt' report || note "$format: $(cat report)"
  grep -q '[12] passed, 1 failed, 2 not read\|"passed": 1, "failed": 1, .*"errors": 2\|failures="1" errors="2"' report || [ $format = csv ] || [ $format = markdown ] \
    || note "$format: no summary: $(tail -n 1 report)"
  [ "$(wc -l <err)" = 4 ] || note "$format: $(cat err)"
done
run 2 order second.txt words.txt --expect 2 --format junit
python <<'END'
import xml.etree.ElementTree as tree
cases = tree.parse("out").getroot().findall("testsuite/testcase")
found = [(case.get("name"), [(f.tag, f.get("message")) for f in case if f.tag != "system-out"]) for case in cases]
if found != [("second.txt: column 2", []), ("words.txt", [("error", "words.txt:2: column 2: 'x' is not a number")])]:
    bad(found)
END
finish "order: a file that cannot be read"
exit $failed
