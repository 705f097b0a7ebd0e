#!/bin/sh
# What order, claims and figure conclude.
# Usage: sh tests/compare/command/cli_results.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/../../support/common.sh"

parameters='m1 m2 F1 F2 L T alpha gait'
square='1 1\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n'
printf '%b' "$square" >square.txt
printf 'name\tT\talpha\tgait\tF1\na\t0.5\t0.6\tquadratic\t2\nb\t2\t0.7\tsinusoidal\t3\nc\t0.01\t0.3\tquadratic\t8\n' >points.tsv

# ---- order ----
verdict() { # NAME VERDICT EXPECTED: of table.txt
  code=1
  [ "$2" != pass ] || code=0
  run $code order table.txt --expect "$3"
  [ "$(tail -n 1 out)" = "# expected $3 within 0.1: $2" ] || note "$(tail -n 2 out)"
  cp out table.out
  run $code order table.txt --expect "$3" --format json
  tail -n 1 out | grep -q -F "\"verdict\": \"$2\"" || note "json: $(tail -n 1 out)"
  finish "order: $1: $2"
}
used() { rows table.out | awk -F '\t' -v use="$1" '$4 == use { n++ } END { print n + 0 }'; }
table() { printf '%b' "$1" >table.txt; }
table "$square"
verdict "h^2" pass 2
verdict "h^2 where 3 is expected" too-low 3
verdict "h^2 where 1 is expected" too-high 1
run 0 order table.txt --expect 2.25 --tol 0.3
run 1 order table.txt --expect 2.25 --tol 0.2
run 0 order table.txt
grep -q 'expected' out && note "a verdict without --expect: $(tail -n 1 out)"
finish "order: --tol, and no verdict without --expect"
table "h err\n$square"
verdict "a header" pass 2
table "err what h\n1 a 1\n0.25 b 0.5\n0.0625 c 0.25\n0.015625 d 0.125\n"
verdict "columns in another order, one more" pass 2
table '0.25 0.0625\n1 1\n0.125 0.015625\n0.5 0.25\n'
verdict "unsorted" pass 2
[ "$(cells table.out h | tr '\n' ' ')" = '1 0.5 0.25 0.125 ' ] || note "not sorted: $(cells table.out h)"
finish "order: rows by falling h"
table '1 -1\n0.5 -0.25\n0.25 -0.0625\n0.125 -0.015625\n'
verdict "negative errors" pass 2
awk 'BEGIN { n = split("1 0.7 0.3 0.2 0.11 0.05 0.013 0.01", h, " "); for (i = 1; i <= n; i++) printf "%s %.17g\n", h[i], 3 * h[i] ^ 1.5 }' >table.txt
verdict "unequal refinement" pass 1.5
awk 'BEGIN { for (h = 1; h > 1e-5; h /= 2) printf "%.17g %.17g\n", h, h * h + h ^ 3 }' >table.txt
verdict "h^2 + h^3" pass 2
[ "$(used coarse)" -ge 1 ] || note "nothing is coarse"
finish "order: coarse points are left out"
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
verdict "jagged errors" not-asymptotic 2
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
[ "$(rows table.out | wc -l)" -eq 6 ] || note "$(rows table.out | wc -l) differences of 7 values"
[ "$(cells table.out err | head -n 1)" = 1 ] || note "the first error: $(cells table.out err | head -n 1)"
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
cp out table.out
[ "$(cells table.out series | uniq -c | tr -s ' \n' ' ')" = ' 8 euler; a 8 heun; a 8 exact; b ' ] || note "$(cat table.out)"
[ "$(grep '^# expected' table.out | sed 's/.*: //' | tr '\n' ' ')" = 'too-low pass pass ' ] || note "$(grep '^#' table.out)"
run 0 order table.txt --format json
python <<'END'
import json
rows = [r for r in map(json.loads, open("out")) if "state" in r]
if [(r["series"], r["state"]) for r in rows] != [("euler; a", "fitted"), ("heun; a", "fitted"), ("exact; b", "exact")]:
    bad(rows)
END
finish "order: one order for each series"
awk 'BEGIN { print "note h err"; for (i = 0; i < 5000; i++) printf "m%d 1 1\n", i }' >table.txt
run 2 order table.txt
grep -q 'more than 4096 series' err || note "$(cat err)"
finish "order: not more series than 4096"

# ---- claims ----
run 0 claims
cp out claims.tsv
cp err summary
case $(header claims.tsv) in
  'claim equation quantity gait claimed_order order order_lo order_hi points verdict '*) ;;
  *) note "columns: $(header claims.tsv)" ;;
esac
finish "claims: the columns begin as promised"
python <<'END'
t = read("claims.tsv")
if len(t) <= 200:
    bad(len(t), "rows")
for i, r in enumerate(t):
    row = "row %d:" % (i + 1)
    if r["verdict"] not in ("holds", "sharper", "refuted", "undecided") or r["inside"] not in ("yes", "no"):
        bad(row, r["verdict"], r["inside"])
    if not all(r.values()):
        bad(row, "an empty cell:", r)
    if r["verdict"] == "undecided" and (r["inside"] == "yes" or r["reason"] == "-"):
        bad(row, r)
    order, low, high, claimed = number(r, "order", "order_lo", "order_hi", "claimed_order")
    if not math.isnan(order) and not low <= order <= high:
        bad(row, low, order, high)
    if r["measured"] == "-" and r["verdict"] == "holds" and abs(order - claimed) > 0.25:
        bad(row, "holds, with", order, "for", claimed)
    if r["measured"] == "-" and r["verdict"] == "sharper" and not order > claimed and not math.isnan(order):
        bad(row, "sharper, with", order, "for", claimed)
    if r["measured"] == "-" and r["verdict"] == "refuted" and not order < claimed:
        bad(row, "refuted, with", order, "for", claimed)
if not {"quadratic", "sinusoidal"} <= {r["gait"] for r in t}:
    bad("gaits:", {r["gait"] for r in t})
END
finish "claims: over 200 rows, none undecided inside the paper's conditions, verdicts as measured"
python "$tool" <<'END'
import subprocess
shown = {"at the boundary, the first row": lambda x: len(x) == 2 and x[0] < x[1], "falls and rises again": lambda x: x[1] < x[0] and x[1] < x[2],
         "rises, in stick-slip": lambda x: len(x) == 2 and x[0] < x[1], "dxC falls": lambda x: len(x) == 2 and x[1] < x[0]}
met = dict.fromkeys(shown, 0)
for r in read("claims.tsv"):
    for what, holds in shown.items():
        if what in r["reason"]:
            command = "scallop() { '%s' \"$@\"; }\n%s" % (sys.argv[1], r["reason"].split(": ", 1)[1])
            said = subprocess.run(["sh", "-c", command], capture_output=True, text=True).stdout
            last = [float(line.split("\t")[-1]) for line in said.splitlines() if line[:1].isdigit()]
            met[what] += 1
            if not last or not holds(last):
                bad(r["claim"], r["conditions"], "is not shown by:", r["reason"], said)
    if r["claim"] == "steady_state_is_reached" and r["verdict"] == "refuted":
        command = "scallop() { '%s' \"$@\"; }\n%s" % (sys.argv[1], r["reason"].split(": ", 1)[1])
        said = subprocess.run(["sh", "-c", command], capture_output=True, text=True).stdout.splitlines()
        if not 0.1 < float(said[-1]) < 0.9:
            bad("multiplier", said)
if not all(met.values()):
    bad(met)
END
finish "claims: the commands that refute a claim in words show it"
python "$tool" <<'END'
import subprocess
met = 0
for r in read("claims.tsv"):
    if r["measured"] == "-" or "scallop " not in r["reason"]:
        continue
    command = r["reason"].split(": ", 1)[-1]
    said = subprocess.run(["sh", "-c", "scallop() { '%s' \"$@\"; }\n%s" % (sys.argv[1], command)], capture_output=True, text=True)
    met += 1
    cells = [c for line in said.stdout.splitlines() if line[:1] != "#" for c in line.split("\t")]
    if said.stderr or not any(c.lstrip("-")[:1].isdigit() for c in cells):
        bad(r["claim"], r["conditions"], "is not shown by:", r["reason"], said.stdout, said.stderr)
if met < 100:
    bad(met, "commands")
END
finish "claims: every command behind a verdict in words can be pasted"
python <<'END'
seen = {}
for i, r in enumerate(read("claims.tsv")):
    key = tuple(r[c] for c in ("claim", "equation", "quantity", "gait", "conditions"))
    if key in seen:
        bad("rows", seen[key] + 1, "and", i + 1, "test the same:", *key)
    seen[key] = i
END
finish "claims: no two rows say that they test the same"
for place in inside outside; do
  yes=yes
  [ $place = inside ] || yes=no
  counts=$(cells claims.tsv inside verdict source | awk -v i=$yes '$1 == i && $3 == "paper" { n[$2]++ }
    END { printf "%d hold, %d are sharper than claimed, %d refuted, %d undecided", n["holds"], n["sharper"], n["refuted"], n["undecided"] }')
  grep "^$place " summary | grep -q -F "$counts" || note "$place: $counts, but: $(cat summary)"
done
run 0 claims --errors all --gait quadratic
cp out errors.txt
run 0 order errors.txt --digits 6
python <<'END'
wanted = {"; ".join(r[c] for c in ("claim", "equation", "quantity", "gait", "conditions", "inside")): r["derived_order"]
          for r in read("claims.tsv") if r["gait"] == "quadratic" and r["derived_order"] != "-"}
name, found = None, 0
for line in open("out"):
    if line.startswith("# series: "):
        name = line[len("# series: "):].rstrip("\n")
    elif line.startswith("# order "):
        order = float(line.split()[2].rstrip(","))
        if math.isnan(order) != (wanted[name] == "none") or abs(order - float(wanted[name].replace("none", "nan"))) > 0.02:
            bad(name, wanted[name], line)
        found += 1
if found != len(wanted) or found < 200:
    bad(found, "series for", len(wanted), "rows")
END
finish "claims --errors, read by order: the order of each row"
run 0 claims --quiet
[ ! -s err ] || note "--quiet: $(head -n 1 err)"
finish "claims: the summary counts the rows, --quiet is quiet"

# ---- figures ----
for n in 2 3 4 5; do
  run 0 figure $n
  cp out figure$n.tsv
  grep -q "^# figure $n: " out || note "no '# figure $n:' in the header"
  grep -q '^# assumed: ' out || [ $n = 4 ] || note "no '# assumed:' in the header"
  [ ! -s err ] || note "standard error: $(cat err)"
  rows out | grep -q -e nan -e inf && note "nan or inf"
  finish "figure $n: header, and numbers everywhere"
done
python <<'END'
t = read("figure2.tsv")
symmetric = [r for r in t if r["kinematics"] == "symmetric"]
asymmetric = [r for r in t if r["kinematics"] == "asymmetric"]
if len(symmetric) != 321 or len(asymmetric) != 321 or symmetric + asymmetric != t:
    bad(len(symmetric), len(asymmetric), "rows")
for rows in symmetric, asymmetric:
    if [float(rows[0][c]) for c in list(rows[0])[1:]] != [0] * 5 or float(rows[-1]["t_over_T"]) != 8:
        bad("from", rows[0], "to", rows[-1])
if not number(asymmetric[-1], "xC_over_L") > number(symmetric[-1], "xC_over_L") > 0:
    bad("ends at", symmetric[-1], asymmetric[-1])
END
finish "figure 2: 8 periods from rest, both kinematics, the asymmetric one goes farther"
python <<'END'
t = read("figure3.tsv")
first, last = t[0], t[-1]
if [float(v) for v in first.values()] != [0] * 5 or float(last["t_over_T"]) != 1:
    bad("from", first, "to", last)
x1, x2, v1, v2 = number(last, "x1_over_L", "x2_over_L", "v1_T_over_L", "v2_T_over_L")
if not near(x2 - x1, 1, 1e-13) or not near(v1, v2, 1e-13) or not x1 < 0 < x2 or not v1 > 0:
    bad("last row:", last)
END
finish "figure 3: one extension, the bodies end with one velocity"
python <<'END'
t = read("figure4.tsv")
for ratio in ("2", "10", "40"):
    rows = [r for r in t if r["F1_over_F2"] == ratio]
    if len(rows) < 50:
        bad("F1/F2 =", ratio, len(rows), "rows")
    for a, b in (("dxC_over_L", "series_dxC_over_L"), ("dvC_T_over_L", "series_dvC_T_over_L")):
        if not near(number(rows[0], a), number(rows[0], b), 1e-3) or not number(rows[0], a) > 0:
            bad("F1/F2 =", ratio, rows[0])
        if near(number(rows[-1], a), number(rows[-1], b), 1e-3):
            bad("no difference at the onset of sticking:", rows[-1])
END
finish "figure 4: exact and series agree at the first T"
python <<'END'
t = read("figure5.tsv")
a, b = [r for r in t if r["panel"] == "A"], [r for r in t if r["panel"] == "B"]
if a + b != t or number(a[0], "alpha", "F2", "F1_over_F2") != [0.01, 1, 2]:
    bad(len(a), len(b), "rows, first:", t[0])
for r in a:
    if r["alpha"] == "0.5" and abs(number(r, "mean_velocity")) > 1e-12:
        bad("symmetric kinematics, and it moves on:", r)
if number(a[0], "mean_velocity") >= 0 or number(a[98], "mean_velocity") <= 0:
    bad("ends of A:", a[0], a[98])
for f2 in ("0.5", "1", "2"):
    rows = [r for r in b if r["F2"] == f2]
    v = [number(r, "mean_velocity") for r in rows]
    if number(rows[0], "F1_over_F2") != 1 or abs(v[0]) > 1e-12 or not 0 < v.index(max(v)) < len(v) - 1:
        bad("B, F2 =", f2, rows[0])
at = [r for r in a if r["alpha"] == "0.75" and r["F1_over_F2"] == "4"]
if len(at) != 1 or at[0]["v_start"] != "3.01662065769":
    bad("the default point:", at)
END
finish "figure 5: signs, maxima, and the default point"
exit $failed
