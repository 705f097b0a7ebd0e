#!/bin/sh
# What claims and figure conclude.
# Usage: sh tests/compare/command/cli_results.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/../../support/common.sh"

parameters='m1 m2 F1 F2 L T alpha gait'
square='1 1\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n'
printf '%b' "$square" >square.txt
printf 'name\tT\talpha\tgait\tF1\na\t0.5\t0.6\tquadratic\t2\nb\t2\t0.7\tsinusoidal\t3\nc\t0.01\t0.3\tquadratic\t8\n' >points.tsv

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
    if said.stderr or "cut -f" in command or not any(c.lstrip("-")[:1].isdigit() for c in cells):
        bad(r["claim"], r["conditions"], "is not shown by:", r["reason"], said.stdout, said.stderr)
if met < 90:
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
run 0 claims --summary
python summary out <<'END'
rows = [r for r in read("claims.tsv") if r["inside"] == "yes" and r["source"] == "paper"]
orders, claims = [r for r in rows if r["measured"] == "-"], {}
for r in rows:
    claims.setdefault(r["claim"], []).append(r)
said = open(sys.argv[1]).read()
count = {v: sum(r["verdict"] == v for r in orders) for v in ("holds", "sharper", "refuted", "undecided")}
if ("%d checks of %d formulas under the paper's conditions: %d hold, %d errors fall faster than claimed, %d are refuted, %d undecided"
        % (len(orders), len({r["claim"] for r in orders}), *count.values())) not in said:
    bad(said, count)
words = {c: {r["verdict"] for r in found} for c, found in claims.items() if found[0]["measured"] != "-"}
fails = sum("refuted" in v for v in words.values())
if "%d statements in words: %d fail under some condition, 0 undecided, %d hold" % (len(words), fails, len(words) - fails) not in said:
    bad(said, len(words), fails)
summary = {r["claim"]: r for r in read(sys.argv[2])}
if set(summary) != set(claims):
    bad(set(summary) ^ set(claims))
for name, found in claims.items():
    s, failed = summary[name], [r for r in found if r["verdict"] == "refuted"]
    wanted = "refuted" if failed else "holds" if any(r["verdict"] == "holds" for r in found) else "sharper"
    if (s["verdict"], int(s["checks"]), int(s["failed"])) != (wanted, len(found), len(failed)):
        bad(s, wanted, len(found), len(failed))
    if failed and s["condition"] != failed[0]["gait"] + "; " + failed[0]["conditions"]:
        bad(s, failed[0])
# How the verdicts are known: nothing that is not proven for all parameters says so.
for r in read("claims.tsv"):
    if r["evidence"] not in ("proven for all parameters", "certified for the crawler named", "measured in doubles") and not re.fullmatch(r"sampled: \d+ cases, no seed", r["evidence"]):
        bad(r)
    if r["gait"] == "quadratic" and r["measured"] == "-" and not r["claim"].startswith("limit_") and not r["evidence"].startswith("proven"):
        bad("not proven for all parameters:", r)
    if "quasi-random" in r["conditions"] and r["verdict"] == "holds" and r["evidence"][:7] not in ("proven ", "sampled"):
        bad(r)
    sticks = re.search("modes .*0", r["measured"]) or r["claim"] in ("mean_velocity_has_one_maximum", "mean_velocity_decays_once_sticking_begins")
    if sticks and r["verdict"] == "refuted" and r["inside"] == "yes" and not re.search("sticks|stuck", r["claim"]) and "\"" not in r["conditions"] + r["measured"]:
        bad("refuted where a body sticks, and nothing says that the paper claims it there:", r)
    if r["gait"] == "sinusoidal" and r["quantity"] in ("v_start", "displacement") and r["evidence"].startswith("proven") and r["measured"] == "-":
        bad("the sinusoidal steady state has no formula:", r)
END
run 0 claims --errors all --gait quadratic
cp out errors.txt
run 0 order errors.txt --digits 6
python <<'END'
wanted = {"; ".join(r[c] for c in ("claim", "equation", "quantity", "gait", "conditions", "inside")): r["derived_order"]
          for r in read("claims.tsv") if r["gait"] == "quadratic" and r["derived_order"] != "-"}
rows = read("out")
for row in rows:
    name, order = row["series"], float(row["order"])
    if math.isnan(order) != (wanted[name] == "none") or abs(order - float(wanted[name].replace("none", "nan"))) > 0.02:
        bad(name, wanted[name], row)
found = len(rows)
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
