#!/bin/sh
# Error against run time: what does not depend on how fast the machine is.
# Usage: sh tests/compare/command/cli_workprec.sh build/scallop. One line for each check; non-zero if any failed.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

run 0 workprec --quick
cp out table.tsv
[ ! -s err ] || note "standard error: $(head -n 1 err)"
[ "$(header table.tsv)" = "method kind setting gait T quantity error time_median time_min time_q1 time_q3 repetitions \
gait_evaluations events root_iterations periods pareto status" ] || note "columns: $(header table.tsv)"
for line in 'scallop [0-9]' 'command: workprec --quick --limit 0.05$' 'parameters: m1=1 m2=1 F1=4 F2=1 L=10 alpha=0.75$' \
  'error: ' 'times: seconds' 'clock: a reading takes'; do
  grep -q "^# $line" table.tsv || note "no line '# $line'"
done
finish "workprec --quick: header and columns"

# In front of each program below: rows of the table, and what they are about.
cat >>tables.py <<'END'
exact_methods = ["exact", "certified"]
formulas = ["published", "limit", "derived series"]
makers = ["gsl rkf45", "gsl rk8pd", "cvode", "smoothed msbdf", "moreau"]
rivals = [m + ", " + way for m in makers for way in ("simulated", "root")]
def select(rows, **wanted):
    return [r for r in rows if all(r[k] == v for k, v in wanted.items())]
def groups(rows):
    found = [select(rows, gait=g, T=t, quantity=q) for g in ("quadratic", "sinusoidal") for t in ("0.5", "0.01")
           for q in ("v_start", "displacement")]
    if not all(found):
        bad("a gait, T and quantity without rows")
    return found
kinds = ["simulation", "root"]
def is_rival(r):
    return r["kind"] in kinds
def kind_wanted(name):
    return ("formula" if name in formulas else "exact" if name in exact_methods
            else "root" if name in rivals[1::2] else "simulation")
END
python <<'END'
t = read("table.tsv")
if sum(len(g) for g in groups(t)) != len(t):
    bad("rows of another gait, T or quantity")
for g in groups(t):
    there = {r["method"] for r in g}
    if there != set(exact_methods + formulas + rivals):
        bad(g[0]["gait"], g[0]["T"], "has or lacks", there ^ set(exact_methods + formulas + rivals))
    for r in g:
        if r["kind"] != kind_wanted(r["method"]):
            bad("kind:", r)
    seen = {(r["method"], r["setting"]) for r in g}
    if len(seen) != len(g):
        bad("the same method and setting twice:", g[0])
    if not {("published", "(28)" if g[0]["quantity"] == "displacement" else "(27)"), ("exact", "steady state"),
            ("certified", "200 digits"), ("derived series", "terms below T^16")} <= seen:
        bad("settings:", seen)
END
finish "every method at each gait, T and quantity"
python <<'END'
for r in read("table.tsv"):
    ok, cut, out = r["status"] == "ok", r["status"].startswith("cut off after 0.05 s"), r["status"].startswith("left out")
    n, median = int(r["repetitions"]), number(r, "time_median")
    least, q1, q3, error = number(r, "time_min", "time_q1", "time_q3", "error")
    noise = r["status"] == "no convergence" and is_rival(r) # the noise of its map is larger than its slope
    if not (ok or cut or out or noise) or (out and not r["method"].startswith("cvode")):
        bad(r)
    if ok and not (n >= 1 and 0 < least <= q1 <= median <= q3 and error >= 0):
        bad("not in order:", r)
    if cut and not (n == 0 and median >= 0.05 and math.isnan(q1)):
        bad("cut off, but:", r)
    if not is_rival(r) and not ok:
        bad("one of our own is not ok:", r)
    if r["pareto"] not in (("yes", "no") if ok else ("-",)):
        bad("pareto:", r)
END
finish "statuses, repetitions and the order of the times"
cp "$root/data/workprec.tsv" committed.tsv
python <<'END'
# What does not depend on the machine: the errors of our own methods, and the work of the exact one (quadratic gait: no sines)
key = lambda r: (r["method"], r["setting"], r["quantity"])
now = {key(r): r for r in select(read("table.tsv"), gait="quadratic", T="0.01") if not is_rival(r)}
then = {key(r): r for r in select(read("committed.tsv"), gait="quadratic", T="0.01") if not is_rival(r)}
if len(now) < 18 or not set(now) <= set(then):
    bad("rows are missing:", set(now) - set(then))
for k, r in now.items():
    for column in ("error", "gait_evaluations", "events", "root_iterations", "periods"):
        if r[column] != then[k][column]:
            bad(k, column, r[column], then[k][column])
END
finish "data/workprec.tsv is of this version"
python <<'END'
# What simulation costs grows like 1/T^2: a million periods are not done in the limit
t = read("table.tsv")
for gait in ("quadratic", "sinusoidal"):
    r, = select(t, gait=gait, T="0.01", quantity="v_start", method="gsl rk8pd, simulated")
    if not r["status"].startswith("cut off after 0.05 s: ") or not number(r, "periods") > 10:
        bad("simulated in time:", r)
    if not 0.05 <= number(r, "time_median"):
        bad("cut off before the limit:", r)
    few, = select(t, gait=gait, T="0.5", quantity="v_start", method="exact")
    more, = select(t, gait=gait, T="0.01", quantity="v_start", method="exact")
    if not 1 <= number(more, "periods") <= 2 * number(few, "periods") + 4:
        bad("exact periods grow:", few, more)
END
finish "T = 0.01: simulation is cut off, and the exact solver's work does not grow"
python <<'END'
t = read("table.tsv")
for g in groups(t):
    one = lambda method, setting: number(select(g, method=method, setting=setting)[0], "error")
    if not one("exact", "steady state") <= 2e-15:
        bad("error of exact:", g[0])
    for digits in (16, 50, 200):
        if not 0 < one("certified", "%d digits" % digits) <= 10.0 ** -digits:
            bad("certified to", digits, "digits:", one("certified", "%d digits" % digits), g[0])
    orders = [one("limit", "leading terms")] + [one("derived series", "terms below T^%d" % n) for n in (4, 8, 16)]
    if not all(b < a or (a == b and i == 0) for i, (a, b) in enumerate(zip(orders, orders[1:]))) or not 0 < orders[-1] < 1e-16:
        bad("derived series:", orders, g[0])
    for r in select(g, method="published"): # right for the quadratic gait only
        if g[0]["gait"] == "quadratic" and not near(number(r, "error"), orders[0], 0.01):
            bad("published is not the limit:", r, orders[0])
        if g[0]["gait"] == "sinusoidal" and not 0.02 < number(r, "error") < 0.05:
            bad("published:", r)
END
finish "errors of formulas, of the exact and of the certified solver"
python <<'END'
# 120/37 - 711/350464 T^4 + ...: at T = 0.5 (28) is 3.2432432 for 3.2431164381, so wrong by 3.91e-5
r, = select(read("table.tsv"), gait="quadratic", T="0.5", method="published", quantity="displacement")
if r["error"] not in ("3.91e-5", "3.91e-05"):
    bad("error of (28):", r["error"])
END
finish "the error of (28) at T = 0.5, by hand"
python <<'END'
for g in groups(read("table.tsv")):
    runs = [r for r in g if r["status"] == "ok"]
    for r in runs:
        e, s = number(r, "error", "time_median")
        beaten = any(number(o, "error") <= e and number(o, "time_median") <= s
                     and (number(o, "error") < e or number(o, "time_median") < s) for o in runs)
        if r["pareto"] != ("no" if beaten else "yes"):
            bad("pareto:", r, "beaten:", beaten)
END
finish "the Pareto front, found again from the rows"
python <<'END'
# A rival is as good as its tolerance says, in the units of the problem, where it was not cut off
t = sum(groups(read("table.tsv")), [])
for r in t:
    if is_rival(r) and r["status"] == "ok" and r["T"] == "0.5" and not r["method"].startswith(("smoothed", "moreau")):
        if not number(r, "error") <= 1e-2:
            bad("a rival is far off:", r)
        if not (number(r, "gait_evaluations") > 10 and number(r, "periods") >= 2 and number(r, "events") >= 4):
            bad("work:", r)
        if (number(r, "root_iterations") > 0) != (r["kind"] == "root"):
            bad("root iterations:", r)
END
finish "rivals: error and work"

cheapest() { awk -f "$root/scripts/plots/cheapest.awk" "$1"; }
# The summary of the table above, and all of it found again from the rows
cheapest table.tsv >summary.tsv || note "exit code $?"
python <<'END'
def cheapest(rows, wanted, allowed):
    rows = [r for r in rows if r["status"] == "ok" and number(r, "error") <= wanted and allowed(r)]
    return min(rows, key=lambda r: number(r, "time_median")) if rows else None
def cells(row, to):
    if not row:
        return ["-", "-", "nan"]
    return [row["method"], row["setting"], "%.3g" % (number(row, "time_median") / number(to, "time_median")) if to else "nan"]
wanted_rows = []
for g in groups(read("table.tsv")):
    for text in ["1e-%d" % n for n in (2, 4, 6, 8, 10, 12, 15, 30, 100)]:
        e = float(text)
        best = cheapest(g, e, lambda r: True)
        if not best:
            bad("no setting reaches", text)
        exact = cheapest(g, e, lambda r: r["kind"] == "exact")
        wanted_rows.append([best["gait"], best["T"], best["quantity"], text, best["method"], best["setting"], best["error"]]
                           + cells(cheapest(g, e, lambda r: r["method"] != best["method"]), best) + cells(exact, best)
                           + cells(cheapest(g, e, is_rival), exact)
                           + cells(cheapest(g, e, lambda r: r["kind"] == "simulation"), exact))
got = read("summary.tsv")
if list(got[0]) != ["gait", "T", "quantity", "wanted_error", "method", "setting", "error", "next_method", "next_setting",
                    "next_ratio", "exact_method", "exact_setting", "exact_ratio", "rival_method", "rival_setting",
                    "rival_over_exact", "simulation_method", "simulation_setting", "simulation_over_exact"]:
    bad("columns:", list(got[0]))
if len(got) != len(wanted_rows):
    bad(len(got), "rows, not", len(wanted_rows))
for a, b in zip(got, wanted_rows):
    if list(a.values()) != b:
        bad("got", list(a.values()), "wanted", b)
END
finish "cheapest.awk: the summary, found again from the rows"
sed 's/^\(exact	.*\)	ok$/\1	cut off after 1 s: 3 periods/' table.tsv >cut.tsv
cheapest cut.tsv >summary.tsv || note "exit code $?"
python <<'END'
rows = read("summary.tsv")
if not rows or {r["exact_method"] for r in rows} != {"certified"} or "exact" in {r["method"] for r in rows}:
    bad("a method that was cut off has an answer:", rows)
END
finish "cheapest.awk: rows that were cut off"
while IFS=: read -r change message; do
  sed "$change" table.tsv | cheapest - >out 2>err && note "$change is not refused"
  grep -q "^cheapest.awk: .*$message" err || note "$change: $(cat err)"
done <<'END'
s/^method/name/:no column 'method'
s/\tok$//:as many columns
s/\tok$/\tok\tok/:as many columns
END
finish "cheapest.awk: tables that are none"

run 0 workprec --quick --gait sinusoidal --T 0.3 --F1 3 --alpha 0.7 --limit 0.02 --format json
python <<'END'
rows = [json.loads(line) for line in open("out")]
if {r["gait"] for r in rows} != {"sinusoidal"} or {r["T"] for r in rows} != {0.3}:
    bad("gait and T:", rows[0])
e = [r for r in rows if r["method"] == "exact"]
if len(e) != 2 or not all(0 <= r["error"] <= 2e-15 and r["status"] == "ok" for r in e): # 0.7 and 0.3 are no doubles
    bad("exact:", e)
END
finish "json, and parameters that are no doubles"

# F1 = F2: the centre of mass rests in the steady state, errors are over L/T and L, and all of this tool's are 0 or next to it
run 0 workprec --quick --gait quadratic --T 0.5 --F1 1 --limit 0.001
rows out | awk -F '\t' '$1 == "exact" && !($7 <= 1e-16) { print "exact: " $0 } $1 == "certified" && !($7 <= 1e-16) { print "certified: " $0 }' >said
[ ! -s said ] || note "$(head -n 1 said)"
finish "a steady state at rest: errors over L/T and L"

# Where the contraction has no turn the published formulas are wrong, and those in their place are not
run 0 workprec --quick --gait quadratic --T 0.01 --m1 0.01 --limit 0.001
rows out | awk -F '\t' '$1 == "published" && $7 < 0.1 { print $0 } $1 == "corrected" { n++; if (!($7 < 1e-3)) print $0 }
  END { if (n != 3 && n != 2) print n + 0 " corrected rows" }' >said
[ ! -s said ] || note "$(head -n 1 said)"
finish "corrected formulas"

refuse() { # CODE PATTERN ARGUMENT...
  wanted=$1 pattern=$2
  shift 2
  run "$wanted" workprec "$@"
  grep -q -e "$pattern" err || note "workprec $*: $(cat err)"
  [ "$(wc -l <err)" -eq 1 ] && [ ! -s out ] || note "workprec $*: one line on standard error and none on standard output wanted"
}
for value in 0 -1 nan inf x '' 1e-4 3601 1s; do
  refuse 2 "--limit: '$value'.*from 0.001 to 3600" --limit "$value"
done
refuse 2 "unknown option '--quik': did you mean '--quick'" --quik
refuse 2 "does not take the option '--points'" --points x
refuse 2 "does not take the option '--digits'" --digits 3
refuse 2 "unexpected argument 'foo'" foo
refuse 2 "--T: '0'.*> 0" --T 0
printf 'old\n' >kept
refuse 3 'no certified steady state.*quadratic gait and T = 1' --m1 1e-300 --m2 1e300 -o kept
refuse 4 'cannot write nowhere/x' --quick -o nowhere/x
[ "$(cat kept)" = old ] || note "the earlier file is gone"
refuse 2 "--from is no longer there: .LC_ALL=C awk -f cheapest.awk FILE. summarises a table" --from committed.tsv
refuse 2 "--summary is no longer there: .LC_ALL=C awk -f cheapest.awk FILE. summarises a table" --summary
finish "bad usage"
exit $failed
