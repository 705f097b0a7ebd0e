#!/bin/sh
# What needs FLINT: derived series, bounds, certified digits, and the ledger against the committed one.
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"
cp "$root/data/claims.tsv" ledger.tsv

# ---- a gait's own numbers, as they are written ----
exactly=3.979746562215900423295663676279 # for 1/5 and 3/10
run 0 steady --certified --gait trapezoidal:0.2,0.3 --digits 31
[ "$(cells out v_start)" = $exactly ] || note "$(cells out v_start)"
printf 'gait\ntrapezoidal:0.2,0.3\n' >gaits.tsv
run 0 steady --certified --points gaits.tsv --digits 31
[ "$(cells out v_start)" = $exactly ] || note "--points: $(cells out v_start)"
printf 'crawler = { gait = "trapezoidal:0.2,0.3"; };\nwant = ( { what = "steady"; columns = [ "certified.v_start" ]; digits = 31; } );\n' >gait.cfg
run 0 run gait.cfg
[ "$(cells out certified.v_start)" = $exactly ] || note "a scene: $(cat out)"
run 0 series --source derived --order 4 --gait trapezoidal:0.2,0.3,0.7,0.1 # from rest: (F1 - F2)/(L V/DOWN), V = 5/3
[ "$(awk -F '\t' '$1 == "contraction" && $3 == "dT" && $4 == 3 { print $5 }' out)" = 9/500 ] || note "$(cat out)"
finish "the numbers of a gait are those that are written, on the command line, of points and in scenes"
# ---- derived series ----
run 0 series --source derived --order 9
cp out derived
python derived <<'END'
# By hand for the default crawler: U = (F1-F2)(2a-1) L m*/(a^2 F1 m1 + (1-a)^2 F2 m2) = 3/2 10/2 / (37/16)
wanted = {("v_start", "-1"): "120/37", ("displacement", "0"): "120/37", ("displacement", "4"): "-711/350464"}
t = read("derived")
found = {(r["quantity"], r["power"]): r["coefficient"] for r in t if r["start"] == "steady"}
for key, value in wanted.items():
    if found.get(key) != value:
        bad(key, found.get(key), "for", value)
rest = {(r["quantity"], r["power"]): r["coefficient"] for r in t if r["phase"] == "extension" and r["start"] == "rest"}
if rest.get(("dT", "3")) != "3/40" or rest.get(("dxC", "2")) != "3/4":
    bad("from rest:", rest)
if {r["status"] for r in t} != {"ok"}:
    bad({r["status"] for r in t})
from fractions import Fraction
for name in ("v_start", "displacement"):
    s = sum(Fraction(r["coefficient"]) for r in t if r["start"] == "steady" and r["quantity"] == name) # T = 1
    last = [r for r in t if r["start"] == "steady" and r["quantity"] == name][-1]
    if abs(float(s) - float(last["sum"])) > 1e-15:
        bad(name, float(s), last["sum"])
END
finish "series --source derived: exact coefficients and their sums"

run 0 series --source derived --order 9 --T 0.01
python out <<'END'
import sys
last = {}
for r in read("out"):
    key = (r["phase"], r["start"], r["quantity"])
    error = abs(float(r["error"]))
    if key in last and last[key] > 0 and not error < last[key]:
        bad("a further term does not help:", r)
    last[key] = error
END
finish "series --source derived: every term makes the error smaller at a small T"

run 0 series --source limit --gait sinusoidal --digits 30
grep -q 'v_start	-1	3.90671748503650533459407563048	' out || note "$(grep v_start out)"
finish "series --source limit: the sinusoidal gait's, 30 digits"
run 0 series --source derived --gait sinusoidal --digits 20 --order 6
cp out short
run 0 series --source derived --gait sinusoidal --digits 60 --order 6
python <<'END'
for a, b in zip(read("short"), read("out")):
    x, y = a["coefficient"], b["coefficient"]
    if x.lstrip("-").replace(".", "").strip("0")[:18] != y.lstrip("-").replace(".", "").strip("0")[:18]:
        bad(x, "and", y)
    if len(y.lstrip("-").replace(".", "").lstrip("0").split("e")[0]) not in range(1, 61):
        bad("digits:", y)
END
finish "series: 20 digits are the first 20 of 60"

run 0 series --source derived --v0 2.5 --order 4
[ "$(rows out | cut -f 1,2 | sort -u | tr '\t\n' ' ,')" = "contraction rest,contraction v0,extension rest,extension v0,period steady," ] \
  || note "$(rows out | cut -f 1,2 | sort -u)"
finish "series --source derived --v0: phases from that velocity too"

run 0 series --source derived --T 4 --order 3
grep -q 'not of this motion: its modes are -- -+ 0+ | +- --' out || note "$(tail -n 1 out)"
finish "series: where a body sticks, the status says that the series is not about that motion"

run 0 series --source derived --gait sinusoidal --T 1e-40 --order 4
rows out | grep '	v_start	' | cut -f 7 | grep -q -E '^-?[0-9.]+e-[0-9]+$' || note "$(rows out | grep v_start)"
! rows out | grep -v '	rest	' | cut -f 7 | grep -q -x '0' || note "an error that is not 0 is printed so: $(rows out | grep -m 1 '	0	ok')"
! grep -q '\[' out || note "a ball: $(grep -m 1 '\[' out)"
finish "series: errors of a sinusoidal gait are seen at T = 1e-40"
run 0 series --source derived --order 9 --m1 0.02 --m2 1 --F1 10 --F2 1 --alpha 0.7 --gait sinusoidal
! grep -q '\[' out || note "a ball: $(grep -m 1 '\[' out)"
finish "series: every coefficient is a number"

# ---- bounds ----
for gait in quadratic sinusoidal; do
  for T in 2.4 0.3 1e-8; do
    run 0 series --bound --order 4 --T $T --gait $gait
    cp out bound
    run 0 series --source derived --order 4 --T $T --gait $gait
    python <<'END'
t, s = read("bound"), read("out")
for b in t:
    last = [r for r in s if r["start"] == "steady" and r["quantity"] == b["quantity"]][-1]
    error, bound = abs(float(last["error"])), float(b["bound"])
    if not error <= bound:
        bad(b["quantity"], "error", error, "above its bound", bound)
    if not error >= 1e-3 * bound:
        bad(b["quantity"], "error", error, "far below its bound", bound)
END
  done
done
finish "series --bound: above the error, and not far, from 1e-8 to T0"
run 0 series --bound --L 1e-140 --T 1e-75
cells out C | grep -q -x '[0-9.]*e+[0-9]* *' || note "$(rows out)"
finish "series --bound: numbers beyond a double's range"
run 0 series --bound --T 2.6
[ "$(cells out bound | sort -u)" = nan ] || note "$(rows out)"
finish "series --bound: none beyond T0"

# ---- bad input: a reason, at once, and nothing half-written ----
printf 'old\n' >kept
refused_at_once() { # NAME CODE TEXT ARGUMENT...
  name=$1 wanted=$2 text=$3
  shift 3
  timeout 10 "$tool" "$@" -o kept </dev/null >out 2>err
  code=$?
  [ $code = "$wanted" ] || note "exit code $code, not $wanted"
  grep -q -e "$text" err || note "no '$text' in: $(cat err)"
  [ "$(cat kept)" = old ] || note "the output was touched"
  [ ! -s out ] || note "something on standard output"
  [ "$(ls)" = "$(ls | grep -v part)" ] || note "a part is left behind"
  finish "$name"
}
refused_at_once "order 0" 2 "from 1 to 1000" series --source derived --order 0
refused_at_once "order 10000" 2 "from 1 to 1000" series --source derived --order 10000
refused_at_once "order 0 of a bound" 2 "from 1 to 1000" series --bound --order 0
refused_at_once "digits 0" 2 "from 1 to 17; with --certified to 10000" steady --certified --digits 0
refused_at_once "10 million digits" 2 "from 1 to 17; with --certified to 10000" steady --certified --digits 10000000
refused_at_once "10 million digits of a series" 2 "from 1 to 17; with --source derived or limit to 10000" series --source derived --digits 10000000
refused_at_once "20 digits of a double" 2 "more than a double has" steady --digits 20 --columns displacement
refused_at_once "20 digits of a published value" 2 "with --source" series --digits 20
refused_at_once "order 61 of a bound" 2 "from 1 to 60" series --bound --order 61
refused_at_once "digits of a bound" 2 "exclude each other" series --bound --digits 6
refused_at_once "unknown source" 2 "published, derived, limit or closed" series --source guessed
refused_at_once "order of the published" 2 "needs --source derived" series --order 4
refused_at_once "order of the limit" 2 "the limit is one term" series --source limit --order 4
refused_at_once "start velocity of the limit" 2 "steady state" series --source limit --v0 1
refused_at_once "bound of the published" 2 "leave --source out" series --bound --source published
refused_at_once "points of a closed form" 2 "of one motion" series --symbolic --source closed --points kept
refused_at_once "bound where the limit is at rest" 3 "alpha = 1/2" series --bound --alpha 0.5
refused_at_once "bound of equal forces" 3 "F1 = F2" series --bound --F2 4
run 0 series --source derived --order 1000
finish "order 1000 ends"

# ---- certified digits ----
for gait in quadratic sinusoidal; do
  run 0 steady --certified --digits 1000 --T 1e-30 --gait $gait
  cp out long
  run 0 steady --certified --digits 30 --T 1e-30 --gait $gait
  python <<'END'
a, b = read("long")[0], read("out")[0]
for name in ("v_start", "v_mid", "displacement", "mean_velocity"):
    x, y = a[name].replace(".", ""), b[name].replace(".", "")
    if len(x) < 1000 or x[:28] != y[:28]:
        bad(name, len(x), x[:40], y)
if a["v_start"].replace(".", "")[:50] != a["displacement"].replace(".", "")[:50]:
    bad("v_start T is not the displacement to 50 digits at T = 1e-30")
END
done
finish "steady --certified: 1000 digits at T = 1e-30"
run 0 steady --certified --T 0.1 --digits 40
[ "$(cells out froude)" = "400.$(printf '%037d' 0)" ] || note "$(cells out froude)"
finish "certified: 0.1 is 1/10, not a double"
run 0 phase --certified --v0 0.1 --digits 25
run 0 phase --certified --v0 1e-1 --digits 25
run 0 phase --certified --v0 0.12345678901234567890123456789
[ "$(cells out v0)" = 0.12345678901234567890123456789 ] || note "$(cells out v0)"
finish "phase --certified: v0 as it was written"
run 0 steady --certified --F2 4
[ "$(cells out v_start displacement)" = "0 0" ] || note "$(rows out)"
finish "certified: an exact 0 is 0"
run 0 steady --certified --alpha 0.5 --digits 10
case $(cells out displacement) in
  0 | 0e-[1-9]*) ;;
  *) note "$(cells out displacement)" ;;
esac
finish "certified: what cannot be told from 0 shows no digit"
printf 'T\tF1\n1\t4\n0.5\tx\n1e-30\t3\n' >points.tsv
run 3 steady --certified --points points.tsv --digits 50
[ "$(rows out | wc -l)" = 3 ] || note "$(rows out | wc -l) rows"
[ "$(cells out status | sed -n 3p)" = certified ] || note "$(cells out status)"
finish "steady --certified --points"
run 0 steady --certified --format json --digits 40
python <<'END'
import decimal
r = json.loads(open("out").read(), parse_float=decimal.Decimal)
if len(str(r["v_start"])) < 40 or r["status"] != "certified":
    bad(r)
END
finish "steady --certified --format json: all digits, as numbers"
run 0 steady --certified --m1 1.00000000000000000000000000001 --digits 40
cells out m1 | grep -q '1.00000000000000000000000000001' || note "$(cells out m1)"
one=$(cells out v_start)
run 0 steady --certified --digits 40
[ "$one" != "$(cells out v_start)" ] || note "the 30th digit of m1 does not count"
finish "certified: every digit that is written counts"

# ---- nothing of FLINT where nobody asked ----
LD_DEBUG=files "$tool" steady >out 2>loaded
! grep -q -E 'libflint|libgmp|libgomp|libomp' loaded || note "$(grep -m 1 -E 'libflint|libgmp|libg?omp' loaded)"
LD_DEBUG=files "$tool" steady --certified >out 2>loaded
grep -q -E 'libflint' loaded || note "FLINT is not seen to be loaded: this test sees nothing"
finish "steady does not load FLINT, steady --certified does"

# ---- claims ----
for option in --against --check; do
  refused_at_once "claims $option" 2 "$option is no longer there: .scallop claims | diff - FILE." claims $option
done
refused_at_once "claims --verdict of no such name" 2 "it takes holds, sharper, refuted or undecided" claims --verdict refused
run 0 claims --verdict sharper --quiet
awk -F '\t' '/^#/ || $1 == "claim" || $10 == "sharper"' ledger.tsv | sed 's/^# command: claims$/& --verdict sharper/' >wanted.tsv
cmp -s out wanted.tsv || note "other rows than those with this verdict"
finish "claims --verdict prints the rows of the ledger with this verdict"
python <<'END'
rows = [r for r in read("ledger.tsv")]
by = {(r["claim"], r["gait"], r["conditions"]): r for r in rows}
for r in rows:
    if r["derived_order"] == "-":
        continue
    if r["verdict"] == "refuted":
        right = by.get((r["corrected"], r["gait"], r["conditions"]))
        if not right or right["verdict"] not in ("holds", "sharper"):
            bad(r["claim"], r["conditions"], "is refuted, and", r["corrected"], "does not hold")
    if r["derived_order"] == "none":
        if r["order"] != "nan":
            bad("exact, but measured:", r)
    elif abs(float(r["order"]) - int(r["derived_order"])) > 1e-6:
        bad("proven", r["derived_order"], "measured", r["order"], r["claim"])
    if (r["coefficient"] == "-") != (r["derived_order"] == "none"):
        bad("coefficient", r)
END
finish "the ledger: what is measured is what is proven, and every refuted formula names one that holds"
exit $failed
