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
run 0 stress --check --quiet --cases 2 --gait trapezoidal:0.2,0.3 --family short-ramps
[ "$(cells out gait)" = trapezoidal:0.2,0.3 ] || note "a family with a gait of its own has no other: $(rows out)"
python check.tsv <<'END'
rows = read(sys.argv[1])
kinds = {r["gait"].split(":")[0] for r in rows}
if len(rows) != 24 * 8 + 4 * 2 or kinds != set("quadratic sinusoidal trapezoidal skewed constant polynomial minimum-jerk measured".split()):
    bad("not 24 families with 8 kinds of gait and 4 with one and a measured one:", len(rows), kinds)
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

# measured gaits that once broke a promise: a multiplier beside a node that is nearer than u tells, by 45 200 units; steep rises with reversals, by
# 14 units and by 58 over the rounding modes; rises of 1e-9 beside dwells, by 37 over them and v_mid by 53; many crossings, by 12
table() {
  name=$1
  shift
  echo 't l' >"$name.tsv"
  printf '%s %s\n' "$@" >>"$name.tsv"
}
table node 0 0 1 0.05 1.0006 5.05 1.00092 1.05 2.00092 8.05 3.00092 0
table steep 0 0 1 0.5093748166357984 1.0027482628466624 1.6820039673925065 1.0045613405719915 0.44081388425167667 \
  1.0068378053981006 2.3058508921469314 1.0094774866477187 0.7783800681924824 1.7816175679993478 3.742608443401032 \
  2.388890709030542 0
table rises 0 0 0.5606760217141853 0 0.5606760218902216 1.4148246395328843 1.2885351352910854 1.4148246395328843 \
  1.2886144968153905 1.8410546196903934 1.431310652987457 1.8410546196903934 1.6878921552969846 2.3037839606510735 \
  1.6878921794537314 2.788557262350161 1.9052441950356984 2.788557262350161 2.553818051858653 3.3996120350732055 \
  3.1454806624190255 0
table dwells 0 0 0.81254189938 0 0.81254190038 0.71 1.779 0.71 2.659 0.261 3.356 0.261 3.734 0
table walk 0 0 0.6099999476023906 0.1727869562264112 1.4319176934391127 0.41799795104213433 2.391693105856306 \
  0.9250446775856626 2.883481943587187 1.5017258086345167 3.8362927526315507 1.9444558491898065 4.686973958361929 \
  2.3881591420869563 4.88824175832635 2.951263221320923 5.717397266680373 3.3158438006855167 6.39728141449116 \
  2.728840519545949 7.105578286732724 1.7955540640657812 7.4502054815009675 0.6455751509207507 8.091028790905208 \
  0.550887422041535 9.03578881101399 0.17688908923090735 9.990645014052168 0.061167319712547734 10.885107487352046 \
  0.036360864986611605 11.688423714477063 0
run 0 stress --check --gait measured:node.tsv --m1 3 --m2 1 --F1 1 --F2 1.00000000000003 --L 1 --T 0.03 --alpha 0.7
run 0 stress --check --gait measured:steep.tsv --m1 0.3733162657509159 --m2 0.7639932825932226 --F1 0.34530258189679897 \
  --F2 0.3453025737588751 --L 0.13407468010744872 --T 0.03442840612924788 --alpha 0.5000000060259444
run 0 stress --check --gait measured:steep.tsv --m1 0.36814836629600545 --m2 5.104107911304942 --F1 801775.0806686243 \
  --F2 2.033840588766835e-05 --L 0.22699665563414761 --T 0.7340909989141711 --alpha 0.001756095164060071
run 0 stress --check --gait measured:rises.tsv --m1 0.72386 --m2 0.753226 --F1 1202.96 --F2 2.52682e-05 --L 1 --T 0.1 --alpha 0.06
run 0 stress --check --gait measured:dwells.tsv --m1 0.72386 --m2 0.753226 --F1 1202.96 --F2 2.52682e-05 --L 1 --T 0.1 --alpha 0.06
run 0 stress --check --gait measured:rises.tsv --family phase-small-period --cases 10 --seed 1008
run 0 stress --check --gait measured:walk.tsv --m1 0.20754513852043013 --m2 2.215547633484659 --F1 2.0353569821211313 \
  --F2 0.362825996587506 --L 2.090212689516891 --T 0.27490881067050715 --alpha 0.999999999990556
finish "measured gaits with nodes, steep rises and many crossings keep the promises"

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
if len(rows) != 24 * 2 + 4 or any(r["verdict"] != "holds" for r in rows):
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
for gait in ("quadratic", "sinusoidal"):
    mine = [r for r in rows if r["gait"] == gait and r["scene"] == "stick-slip" and r["status"] == "ok"]
    if len(mine) < 3 or {r["stepper"] for r in mine} != {"msbdf"}:
        bad("runs of", gait, mine)
for r in rows:
    if r["scene"] == "stick-slip" and float(r["delta"]) <= 1e-3:
        creep, predicted = number(r, "creep_over_delta", "predicted_creep_over_delta")
        if not near(creep, predicted, 0.06):
            bad("creep", creep, predicted)
END
mv out runs.tsv
run 0 order runs.tsv --x delta --y v_end_error,displacement_error --expect 1
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
