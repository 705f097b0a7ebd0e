#!/bin/sh
# scallop breakdown --map: grids, boundaries between regions.
. tests/support/common.sh

# ---- bad usage: one line, nothing on standard output ----
refused() { # WORD-IN-THE-MESSAGE ARGUMENT...
  word=$1
  shift
  run 2 breakdown "$@"
  [ ! -s out ] || note "$*: something on standard output"
  [ "$(wc -l <err)" = 1 ] || note "$*: not one line: $(cat err)"
  grep -q -e "$word" err || note "$*: '$word' is not said: $(cat err)"
}
refused "'froude'" --map frude alpha
refused "'alpha'" --map F1/F2 alhpa
refused "different" --map alpha alpha
refused "vary apart" --map T froude
refused "needs two values" --map alpha
refused "FROM:TO:COUNT" --map F1/F2 alpha --x 1:2
refused "FROM < TO" --map F1/F2 alpha --boundaries --x 2:1:3
refused "FROM = TO" --map F1/F2 alpha --x 1:2:1
refused "> 0" --map F1/F2 alpha --x 0:2:3
refused "both excluded" --map F1/F2 alpha --y 0.5:1:3
refused "FROM:TO:COUNT:log" --map F1/F2 alpha --y 0.5:0.6:3:lin
refused "where F1/F2 sets it" --map F1/F2 alpha --F1 3
refused "where froude sets it" --map froude alpha --T 3
refused "displacement" --map F1/F2 alpha --quantity displacment
refused "2 to 2001" --map F1/F2 alpha --boundaries --x 1:1:1
finish "bad usage is refused in a line"

# ---- a grid ----
few="--source published --quiet"
# shellcheck disable=SC2086
run 0 breakdown --map F1/F2 froude --x 2:200:3 --y 0.05:20:2 --alpha 0.8 --L 3 $few
cp out grid
python grid <<'END'
rows = read(sys.argv[1])
if [(number(r, "F1/F2"), number(r, "froude")) for r in rows] != [(2, 0.05), (20, 0.05), (200, 0.05), (2, 20), (20, 20), (200, 20)]:
    bad("not in order", [(r["F1/F2"], r["froude"]) for r in rows])
for r in rows:
    F1, F2, m1, m2, T, fr = number(r, "F1", "F2", "m1", "m2", "T", "froude")
    if F1 != F2 * number(r, "F1/F2") or not near((m1 + m2) * 3 / (T * T * (F1 + F2)), fr, 1e-15) or r["alpha"] != "0.8":
        bad(r)
    if not near(number(r, "mean_velocity") * T, number(r, "displacement"), 1e-15):
        bad("mean velocity", r)
# where a series reaches to does not depend on T
for a, b in zip(rows[:3], rows[3:]):
    if any(a[k] != b[k] for k in a if k.startswith("T_1e-")):
        bad("T differs", a, b)
END
# shellcheck disable=SC2086
run 0 breakdown --map F1/F2 m1/m2 --x 2:200:3 --y 1:1:1 --alpha 0.8 --L 3 $few
[ "$(cells out T_1e-2_published T_1e-6_published)" = "$(cells grid T_1e-2_published T_1e-6_published | head -n 3)" ] ||
  note "T is another one where T is no axis: $(cells out T_1e-2_published), $(cells grid T_1e-2_published)"
run 0 steady --points grid --L 3
[ "$(cells out modes regime v_start displacement mean_velocity status)" = "$(cells grid modes regime v_start displacement mean_velocity status)" ] ||
  note "steady gives something else for the rows of the map"
# shellcheck disable=SC2086
OMP_NUM_THREADS=1 run 0 breakdown --map F1/F2 froude --x 2:200:3 --y 0.05:20:2 --alpha 0.8 --L 3 $few
cmp -s out grid || note "one thread gives other bytes"
# shellcheck disable=SC2086
OMP_NUM_THREADS=100000 run 0 breakdown --map F1/F2 froude --x 2:200:3 --y 0.05:20:2 --alpha 0.8 --L 3 $few
cmp -s out grid || note "100000 threads: other bytes, or none"
# shellcheck disable=SC2086
run 3 breakdown --map F1/F2 m1/m2 --x 1e300:1e305:2 --y 1:1:1 --F2 1e5 $few
[ "$(cells out status | sed -n 2p | cut -c 1-11)" = "F1_over_F2:" ] || note "F1 = 1e310 has a steady state: $(cells out status)"
# shellcheck disable=SC2086
run 0 breakdown --map alpha T --x 0.6:0.8:2 --y 1:2:2 --format json --tol 1e-3 $few
python out <<'END'
rows = [json.loads(l) for l in open(sys.argv[1])]
if len(rows) != 4 or [k for k in rows[0] if k.startswith("T_")] != ["T_1e-3_published"] or "error_published" not in rows[0]:
    bad(rows[0])
END
held() { # X Y PARAMETERS: what the head of a map over X and Y says
  for what in '--source limit' --boundaries; do
    # shellcheck disable=SC2086
    run 0 breakdown --map "$1" "$2" --x 0.2:0.3:2 --y 0.4:0.5:2 --quiet $what
    [ "$(sed -n 's/^# parameters: //p' out)" = "$3" ] || note "the head of a map over $1 and $2: $(grep parameters out)"
  done
}
held F1/F2 froude "m1=1 m2=1 F2=1 L=10 alpha=0.75 gait=quadratic"
held m1/m2 T "m2=1 F1=4 F2=1 L=10 alpha=0.75 gait=quadratic"
held alpha F1/F2 "m1=1 m2=1 F2=1 L=10 T=1 gait=quadratic"
finish "a grid: rows in order, what steady gives, T from what it depends on, and a head without what varies"

# ---- what no column asks for is not computed: a point takes 13 ms with all of it ----
large="--x 0.1:10:101 --y 0.1:0.9:100"
# shellcheck disable=SC2086
quick() { (keep_counts_apart && exec timeout --foreground 60 "$tool" breakdown --map F1/F2 alpha $large --quiet "$@") >out 2>err; }
quick --columns F1/F2,alpha,modes,regime || note "exit code $?: $(cat err)"
[ "$(rows out | wc -l)" = 10100 ] || note "not all rows"
quick --columns T_1e-2_publishd
[ $? = 2 ] || note "a column that is not there is refused late: $(cat err)"
grid="breakdown --map F1/F2 froude --x 2:200:3 --y 0.05:20:2 --alpha 0.8 --L 3 --quiet"
# shellcheck disable=SC2086
run 0 $grid --columns 'modes,twice = 2*error_limit,T_1e-2_published'
cp out some
# shellcheck disable=SC2086
run 0 $grid
[ "$(cells out modes)" = "$(cells some modes)" ] && [ "$(cells out T_1e-2_published)" = "$(cells some T_1e-2_published)" ] &&
  [ "$(cells out error_limit | awk '{ printf "%.12g\n", 2 * $1 }')" = "$(cells some twice | awk '{ printf "%.12g\n", $1 }')" ] ||
  note "chosen columns have other numbers"
finish "a map computes what its columns ask for, and refuses others first"

# ---- written whole, or not at all ----
(
  keep_counts_apart
  ulimit -f 1
  echo earlier >small
  "$tool" breakdown --map F1/F2 alpha --x 1.5:60:16 --y 0.55:0.9:16 --source published -o small >/dev/null 2>small.err
  [ $? = 4 ] || echo "exit code is not 4"
  [ "$(wc -l <small.err)" = 1 ] || cat small.err
  [ "$(cat small)" = earlier ] || echo "the earlier file is gone"
) >said 2>&1
[ ! -s said ] || note "where no file may grow: $(cat said)"
run 4 breakdown --map F1/F2 alpha --x 1:2:2 --y 0.6:0.7:2 --source published -o nowhere/map
finish "a full disk: exit code 4, the earlier file stays"

# ---- boundaries against closed forms, and by proof ----
run 0 breakdown --map froude alpha --boundaries --quiet
cp out curves
python curves "$tool" <<'END'
import subprocess
from fractions import Fraction as Q
rows = read(sys.argv[1])
guess = "one end is a guess: boundaries meet there"
sound = [r for r in rows if r["status"] == "ok"]
if any(r["status"] not in ("ok", guess) for r in rows):
    bad([r for r in rows if r["status"] not in ("ok", guess)][0])
def ends(r):
    return [number(r, "froude", "alpha"), number(r, "to_froude", "to_alpha")]
# Quadratic gait, m1 = m2, F1 = 4, F2 = 1: |l''| is 4 in units of the phase, q = 1/2, eps = a^2/froude, delta = 3/5.
delta = Q(3, 5)
def zero_start(fr, a): # the velocity at the end of the contraction, but for a factor > 0, where the extension begins from rest
    e, c, b = a * a / fr, (1 - a) * (1 - a) / fr, 1 - a
    u = delta * e / (2 + delta * e)                # body 1 turns back: c = 2 u
    v = (2 - e) * u * b / a                        # at the start of the contraction, in its units
    t = v / (2 + c)
    return 2 * t - delta * c * (1 - t)
one = Q(1)
forms = { # by the change, for alpha > 1/2: a function of (froude, alpha) that changes its sign there
    "onset of sticking: body 1 in the extension": lambda fr, a: a * a - 2 * fr,
    "start velocity changes sign": zero_start,
    "permanent rest of body 1": lambda fr, a: delta * (one - a) * (one - a) - 2 * fr,
}
counted = 0
h = Q(1, 10**12)
for r in sound:
    for fr, a in ends(r):
        fr, a = Q(fr), Q(a)
        if a <= Q(1, 2) or r["what"] not in forms or (r["what"] == "permanent rest of body 1" and r["region_1"] != "0+ | +- 0-"):
            continue
        f = forms[r["what"]]
        if f(fr - h * fr, a) * f(fr + h * fr, a) >= 0 and f(fr, a - h) * f(fr, a + h) >= 0:
            bad("not within 1e-12 of the closed form:", r)
        counted += 1
if counted < 100:
    bad("only", counted, "ends have a closed form")
# A part begins where another ends, at the edge of the map, or where boundaries meet: there three at least.
def place(end):
    return tuple("%.11g" % x for x in end)
times = {}
for r in rows:
    for end in ends(r):
        times[place(end)] = times.get(place(end), 0) + 1
at_edge = {"%.9g" % x for x in (0.01, 100, 0.99)}
meeting = [p for p, n in times.items() if n > 2]
for p, n in times.items():
    if n == 1 and not any("%.9g" % float(x) in at_edge for x in p):
        bad("a part ends alone at", p)
if len(meeting) != 4:
    bad("boundaries meet at", meeting)
if not any(near(float(x), 0.125, 1e-2) and near(float(y), 0.5, 1e-2) for x, y in meeting):
    bad("at alpha = 1/2 and froude = 1/8 four regions meet, not at", meeting)
# The regions on the two sides at 1e-12 along the edge of the cell, by proof, where every fifth part begins
points, wanted = [], []
for r in sound[::5]:
    (x, y), (x1, y1) = ends(r)
    for side in (1, -1): # to the left of the way, to the right
        points.append((Q(r["froude"]) * (1 + (-h if y1 > y else h) * side), Q(r["alpha"])))
        points.append((Q(r["froude"]), Q(r["alpha"]) + (h if x1 > x else -h) * side))
    wanted.append([r["region_1"]] * 2 + [r["region_2"]] * 2)
from decimal import Decimal, getcontext
getcontext().prec = 40
with open("sides", "w") as f:
    f.write("alpha\tT\n")
    for fr, a in points: # froude = 20/(5 T^2)
        T = (Decimal(4) * fr.denominator / fr.numerator).sqrt()
        f.write("%s\t%s\n" % (Decimal(a.numerator) / a.denominator, T))
subprocess.run([sys.argv[2], "steady", "--certified", "--points", "sides", "--digits", "15", "-o", "proven"], check=True)
proven = read("proven")
if len(proven) != 4 * len(wanted) or len(wanted) < 50:
    bad("points", len(proven), len(wanted))
for i, w in enumerate(wanted):
    found = [p["modes"] for p in proven[4 * i:4 * i + 4]]
    if found[::2] != w[::2] and found[1::2] != w[1::2]:
        bad("on the sides at 1e-12:", found, "and not", w, [float(x) for x in points[4 * i]])
END
finish "boundaries: closed forms, where they meet, and proven modes on both sides at 1e-12"

# Here the start velocity is so small beside three regions that rounding chooses its sign, unless it is solved for in wider arithmetic.
run 0 breakdown --map m1/m2 T --boundaries --x 0.0221:0.0223:9 --y 2.177:2.178:9 --quiet
python out <<'END'
rows = read(sys.argv[1])
if len({(r["region_1"], r["region_2"]) for r in rows}) != 3:
    bad("not three boundaries:", {(r["region_1"], r["region_2"]) for r in rows})
at = [number(r, "m1/m2", "T") for r in rows if r["status"] != "ok"]
if len(at) != 3 or max(x for x, _ in at) / min(x for x, _ in at) > 1.001:
    bad("they do not meet once:", at)
END
finish "boundaries where rounding decides the modes in double"

run 0 breakdown --map F1/F2 froude --boundaries --gait sinusoidal --x 3:30:9 --y 0.02:2:9 --quiet
cp out curves
OMP_NUM_THREADS=1 run 0 breakdown --map F1/F2 froude --boundaries --gait sinusoidal --x 3:30:9 --y 0.02:2:9 --quiet
cmp -s out curves || note "one thread gives other bytes"
OMP_NUM_THREADS=100000 run 0 breakdown --map F1/F2 froude --boundaries --gait sinusoidal --x 3:30:9 --y 0.02:2:9 --quiet
cmp -s out curves || note "100000 threads: other bytes, or none"
python curves <<'END'
rows = read(sys.argv[1])
whats = {r["what"] for r in rows}
for w in ("start velocity changes sign", "permanent rest of body 1", "onset of sticking: body 1 in the extension"):
    if w not in whats:
        bad(w, "is not among", whats)
END
finish "boundaries of the sinusoidal gait, the same bytes from one thread"

exit $failed
