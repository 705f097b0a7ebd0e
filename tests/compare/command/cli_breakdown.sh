#!/bin/sh
# scallop breakdown, for one crawler: rows, selections, what can be pasted, refusals.
. tests/support/common.sh

run 0 breakdown --all
python out <<'END2'
rows = read(sys.argv[1])
kinds = [r["what"] for r in rows]
if set(kinds) != {"event", "reach", "radius", "best"}:
    bad("kinds:", set(kinds))
events = [r for r in rows if r["what"] == "event"]
T = [number(r, "T") for r in events]
if T != sorted(T) or T[0] != 0 or len(T) != 6:
    bad("events:", T)
if events[1]["note"] != "start velocity changes sign" or "permanent rest of body 1" not in events[-1]["note"]:
    bad("first or last event:", events[1]["note"], events[-1]["note"])
if not near(T[1], 2.7889395095954335, 4e-16):
    bad("the first event:", T[1])
for r in rows:
    t, froude = number(r, "T", "froude")
    if t > 0 and math.isfinite(t) and not near(froude, 4 / t**2, 1e-15): # M L/(F1 + F2) = 4
        bad("froude:", t, froude)
    if r["what"] == "reach" and math.isfinite(t) and t > 0:
        error, tolerance = number(r, "error", "tolerance")
        if not near(abs(error), tolerance, 1e-3) or r["status"] != "certified":
            bad("reach:", r)
        if (t > T[1]) != ("does not describe the motion" in r["note"]):
            bad("above and below the first event:", r["note"])
    if r["what"] == "radius" and (r["series"] != "poles" or not near(t, 12.240931701854283, 1e-15)):
        bad("radius:", r)
series = {(r["quantity"], r["series"]) for r in rows if r["what"] == "reach"}
if len(series) != 12 or ("displacement", "text_steady_xC") not in series or ("v_mid", "limit") not in series:
    bad("series:", series)
tolerances = {r["tolerance"] for r in rows if r["what"] == "reach"}
if len(tolerances) != 12:
    bad("tolerances:", tolerances)
END2
finish "breakdown: events in order, reaches, radius, best orders"

# What reaches to T* does so when it is pasted into series.
run 0 breakdown --only reach --quantity displacement --tol 1e-6 --source published
T=$(cells out T)
"$tool" series --T "$T" >out 2>err
python out <<'END2'
rows = [r for r in read(sys.argv[1]) if r["formula"] == "text_steady_xC"]
published, exact = number(rows[0], "published", "exact")
if not near(abs(published / exact - 1), 1e-6, 1e-8):
    bad("at T* the error is", published / exact - 1)
END2
for T in 2.7889395095954 2.7889395095955; do
  run 0 steady --T "$T"
  echo "$T $(cells out v_start)"
done >velocities
awk 'NR == 1 && $2 <= 0 || NR == 2 && $2 >= 0 { bad = 1 } END { exit bad }' velocities || note "v_start: $(cat velocities)"
finish "T* and events can be pasted into series and steady"

run 0 breakdown --only event --gait sinusoidal
[ "$(rows out | wc -l)" = 7 ] || note "events: $(cells out T)"
run 0 breakdown --phase contraction --only reach --quantity dT --tol 0.01
grep -qx "# contraction from v0 = 0; T is its duration, not the period" out || note "the head does not say what T is"
cells out series >names
grep -q rest_dT names && grep -q derived names && grep -q limit names || note "series of dT: $(cat names)"
run 0 breakdown --v0 0.5 --only reach --quantity v_end --source derived --order 5 --tol 1e-3
[ "$(cells out order)" = 5 ] || note "order: $(cells out order)"
run 0 breakdown --only reach --quantity displacement --tol 1e-3 --alpha 0.3 --source published
[ "$(cells out T)" = 0 ] || note "a wrong formula reaches to $(cells out T)"
grep -q 'the error tends to 1.4' out || note "the limit of its error: $(cells out note)"
# Above the limit of its error, 0.0241823, it does reach some T.
reaches() { # T-ROUNDED ARGUMENT...
  rounded=$1
  shift
  run 0 breakdown --only reach --source published --quantity displacement --gait sinusoidal "$@"
  [ "$(printf '%.6f' "$(cells out T)")" = "$rounded" ] || note "$*: it reaches to $(cells out T), not $rounded"
}
reaches 2.622467 --tol 0.1
reaches 0.752825 --tol 0.05 --m1 2 --m2 0.5 --F1 6 --F2 1.5 --L 3 --alpha 0.6
reaches 0.000000 --tol 0.0241822
run 0 breakdown --F1 1 --only reach --quantity displacement
[ "$(cells out T | sort -u)" = inf ] || note "F1 = F2: $(cells out T | sort -u)"
run 0 breakdown --only best --quantity v_start --format json
/usr/bin/python3 -c 'import json; [json.loads(l) for l in open("out")]' || note "json"
for phase in "" "--phase extension"; do
  # shellcheck disable=SC2086
  run 0 breakdown --only event $phase
  ! grep -qE "^# parameters:.* (T${phase:+|alpha})=" out || note "$phase: the head names what is not used: $(grep parameters out)"
done
finish "phases, selections, formulas that reach nowhere, json, parameters that are not used"

# Where the series is not that of a rational function its nearest singularity is proven, and one for all quantities; t1 has its own.
run 0 breakdown --only radius --gait sinusoidal
[ "$(cells out series | sort | uniq -c | awk '{ print $1 $2 }')" = 4singularity ] || note "methods: $(cells out series)"
[ "$(cells out status | sort -u)" = certified ] || note "status: $(cells out status)"
[ "$(cells out T | sort -u | wc -l)" = 1 ] || note "radii: $(cells out T)"
awk 'BEGIN { FS = "\t" } /^radius/ && !($8 <= 1e-14) { bad = 1 } END { exit bad }' out || note "errors: $(cells out error)"
grep -q 'T^2 = +-23.7268.* +- 0.0938' out || note "the place: $(cells out note)"
run 0 breakdown --only radius --gait sinusoidal --phase contraction --v0 0.5
[ "$(cells out T | sort -u | wc -l)" = 2 ] || note "of a phase: $(cells out T)"
run 0 breakdown --only radius --F1 1 --gait sinusoidal
[ "$(cells out T | sort -u)" = inf ] || note "F1 = F2: $(cells out T)"
finish "radius of convergence"

refused() { # WHAT ARGUMENT...
  what=$1
  shift
  run 2 breakdown "$@"
  [ ! -s out ] || note "output in spite of an error: $*"
  grep -q -- "$what" err || note "$*: $(head -n 1 err)"
}
refused "did you mean 'displacement'" --quantity displacment
refused "a phase has t1, dT, v_end" --v0 1 --quantity v_mid
refused "is of a phase" --quantity dT
refused "event, reversal, reach, radius or best" --only events,reach
refused 'from 1e-20 on' --tol 1e-21
refused 'from 1e-20 on' --tol 0
refused 'order needs the derived series' --order 4 --source limit
refused 'without --map' --x 1:2:3
refused 'without --map' --boundaries
refused 'without --map' --T 2
refused 'tol needs the rows of --only reach' --only event --tol 0.1
refused 'source needs rows about series' --only event --source derived
refused 'quantity needs rows about series' --only reversal --quantity displacement
refused 'source needs the rows of --only reach' --only best --source limit
run 3 breakdown --quantity v_mid --source published --only reach
grep -q 'no row' err || note "an empty table without a word: $(cat err)"
run 0 breakdown --only best --quantity displacement
[ "$(rows out | grep -c 'more terms are better still')" = 9 ] || note "best: $(cells out note | head -n 1)"
printf '0 0\n1 2\n1.5 1.9\n2 3\n4 0\n' >turns.txt
run 3 breakdown --only radius --gait measured:turns.txt
grep -q 'no derived series' err || note "no series: $(cat err)"
run 3 breakdown --alpha 1e-300
grep -q 'out of range' err || note "overflow: $(cat err)"
finish "what is refused"
