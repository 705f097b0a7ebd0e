#!/bin/sh
# scallop stress: the gate for CI, families, single points, friction smoothed for stiff solvers, and estimates of errors.
committed=$(cd "$(dirname "$0")/../../.." && pwd)/data/stress.tsv
. tests/support/common.sh

# the gate: every promise of accuracy, on few cases of every family and of every kind of gait
run 0 stress --check --quiet
cp out check.tsv
{
  echo 't l'
  printf '%s\n' '0 0' '1 0.4' '2 1.3' '3 1.9' '4 2' '5 2.1' '6 3' '7 3.9' '8 4' '9 3.5' '10 2' '11 0.6' '12 0.1' '13 0'
} >walk.tsv
run 0 stress --check --quiet --cases 3 --gait measured:walk.tsv
rows out >>check.tsv
python check.tsv <<'END'
rows = read(sys.argv[1])
kinds = {r["gait"].split(":")[0] for r in rows}
if len(rows) != 24 * 8 or kinds != set("quadratic sinusoidal trapezoidal skewed constant polynomial minimum-jerk measured".split()):
    bad("not 24 families and 8 kinds of gait:", len(rows), kinds)
for r in rows:
    n, refused = number(r, "cases", "refused")
    wanted = 2 if r["family"] == "trajectory" else 30 if r["family"].startswith("phase") else 4
    if r["verdict"] != "holds":
        bad(r["family"], r["gait"], r["verdict"])
    if r["gait"] == "constant:0" and r["family"].startswith("equal-"):
        refused = 0 if refused < n else n  # where the steady states fill an interval
    if (r["gait"], r["family"]) == ("constant:0", "at-rest"):
        wanted = 0  # bodies are thrown into motion where l' jumps
    if n != (wanted if r["gait"] != "measured:walk.tsv" else 3) or refused > ((n if n > 3 else 4) / 2 if "range" in r["family"] else 0):
        bad("cases:", r["family"], n, refused)
    if n > 0 and not number(r, "units") <= 8:
        bad("units:", r["family"], r["units"])
    if n > 0 and r["family"] != "trajectory":
        rounding, perturbed, least, most = number(r, "rounding", "perturbed", "estimate_least", "estimate_most")
        if not (rounding <= 32 and perturbed <= 17 and least >= 1 and most <= 100):
            bad("spreads or estimates:", r["family"], r["gait"])
END
finish "stress --check: every family and kind of gait keeps its promises"

# families, seeds, and what can be pasted
run 0 stress --family wild --gait quadratic --cases 20 --seed 3
cp out first
run 0 stress --family wild --gait quadratic --cases 20 --seed 3
cmp -s out first || note "the same seed gives other bytes"
OMP_NUM_THREADS=1 run 0 stress --family wild --gait quadratic --cases 20 --seed 3
cmp -s out first || note "one thread gives other bytes"
run 0 stress --family wild --gait quadratic --cases 20 --seed 4
cmp -s out first && note "another seed gives the same"
at=$(cells first worst_at)
quantity=$(cells first quantity)
# shellcheck disable=SC2086
run 0 steady $at
# shellcheck disable=SC2086
run 0 stress $at
[ "$(awk -F '\t' -v q="$quantity" '$1 == q { print $4, $6 }' out)" = "$(cells first units condition)" ] ||
  note "the point of worst_at has other units"
finish "the worst case can be pasted into steady and stress"

run 0 stress --family phase-wild --gait sinusoidal --cases 10
# shellcheck disable=SC2046
run 0 phase $(cells out worst_at)
run 0 stress --family trajectory --check --gait quadratic
# shellcheck disable=SC2046
run 0 trajectory $(cells out worst_at) --samples 1
[ "$(rows out | wc -l)" = 10001 ] || note "not 10000 periods"
finish "so can that of a phase and of a trajectory"

# the committed table, from more cases
python "$committed" <<'END'
rows = read(sys.argv[1])
if len(rows) != 48 or any(r["verdict"] != "holds" for r in rows):
    bad("data/stress.tsv does not hold")
if min(number(r, "cases") for r in rows if r["family"] != "trajectory") < 500:
    bad("data/stress.tsv is of few cases")
END
finish "data/stress.tsv holds"

# a point
run 0 stress --T 5 --gait sinusoidal --format json
python out <<'END'
rows = [json.loads(l) for l in open(sys.argv[1])]
if [r["quantity"] for r in rows] != "froude v_start v_mid displacement mean_velocity multiplier".split():
    bad("quantities", rows)
for r in rows:
    if r["verdict"] != "holds" or not abs(r["value"] - r["certified"]) <= r["estimate"] + 2**-52 * abs(r["value"]):
        bad(r)
END
run 0 stress --check --m1 80 --m2 40 --F1 6 --F2 1.8 --T 12000 --gait sinusoidal --alpha 1e-152
run 3 stress --T 1e200 --quiet
grep -q "out of range" out || note "a refused point does not say so: $(tail -n 1 out)"
finish "a point, and one that is refused"

# bad usage
for arguments in "--family nosuch" "--family wlid" "--cases 0" "--seed -1" "--stiff --cases 3" "--quick" "--T 2 --family wild" "--T 2 --full" \
  "--stiff --phase extension" "--cases 5 6" "--alpha 2"; do
  # shellcheck disable=SC2086
  run 2 stress $arguments
  [ ! -s out ] || note "$arguments: something on standard output"
  [ "$(wc -l <err)" = 1 ] || note "$arguments: not one line: $(cat err)"
done
run 2 stress --family wlid
grep -q "'wild'" err || note "no suggestion for wlid: $(cat err)"
finish "bad usage is refused in a line"

# friction smoothed for stiff solvers
run 0 stress --stiff --quick --quiet
python out <<'END'
rows = read(sys.argv[1])
for name in ("msbdf", "bsimp", "rk4imp"):
    for gait in ("quadratic", "sinusoidal"):
        mine = [r for r in rows if r["stepper"] == name and r["gait"] == gait and r["scene"] == "stick-slip" and r["status"] == "ok"]
        if len(mine) < 3:
            bad("too few runs of", name, gait)
for r in rows:
    if r["stepper"] == "msbdf" and r["scene"] == "stick-slip" and float(r["delta"]) <= 1e-3:
        creep, predicted = number(r, "creep_over_delta", "predicted_creep_over_delta")
        if not near(creep, predicted, 0.06):
            bad("creep", creep, predicted)
END
run 0 stress --stiff --quick --quiet --summary
python out <<'END'
for r in read(sys.argv[1]):
    if r["stepper"] == "msbdf" and r["scene"] != "stiff" and r["gait"] == "quadratic" and r["verdict"] != "pass":
        bad("order", r)
END
finish "stress --stiff: order one in delta, and the creep that is predicted"

# estimates of errors
run 0 steady --error --T 3
python out <<'END'
r = read(sys.argv[1])[0]
names = "froude v_start v_mid displacement mean_velocity multiplier".split()
if not all(0 <= number(r, n + "_error") <= 8 * 2**-52 * max(abs(number(r, n)), 10) for n in names):
    bad(r)
END
run 0 phase --error --v0 1
[ "$(header out | tail -n 1 | tr ' ' '\n' | grep -c _error)" = 6 ] || note "phase --error has not six columns of errors: $(header out)"
printf 'T\n1\n-2\n3\n' >points
run 3 steady --error --points points
[ "$(rows out | wc -l)" = 3 ] || note "not three rows"
run 2 steady --error --certified
run 2 phase --error --certified
finish "--error"

exit $failed
