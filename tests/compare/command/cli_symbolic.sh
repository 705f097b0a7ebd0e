#!/bin/sh
# series --symbolic and series --emit: formulas, and programs that compute with them.
# Usage: sh tests/compare/command/cli_symbolic.sh build/scallop. One line for each check; non-zero if any failed.
# shellcheck disable=SC2154
. "$(dirname "$0")/../../support/common.sh"

# ---- the table: each coefficient, at this crawler, is the number of --source derived ----
crawler="--m1 1.5 --m2 0.7 --F1 3 --F2 1.25 --L 2.5 --alpha 0.6 --v0 -0.4"
# shellcheck disable=SC2086
run 0 series --symbolic --order 8 $crawler
cp out formulas
# shellcheck disable=SC2086
run 0 series --source derived --order 8 $crawler
python formulas out <<'END'
from fractions import Fraction as F
L = F("2.5")
at = {"m1": F("1.5"), "m2": F("0.7"), "M": F("2.2"), "F1": F(3), "F2": F("1.25"), "L": L, "alpha": F("0.6"), "v0": F("-0.4")}
key = lambda r: (r["phase"], r["start"], r["quantity"], r["power"])
numbers = {key(r): F(r["coefficient"]) for r in read(sys.argv[2])}
formulas = read(sys.argv[1])
for r in formulas:
    sign = -1 if r["phase"] == "contraction" else 1 # l'' of the quadratic gait: 4 L and -4 L in an extension
    value = eval(re.sub(r"\b(\d+)\b", r"F(\1)", r["coefficient"].replace("^", "**")),
                 {"F": F}, {**at, "l0": 4 * sign * L, "lT": -4 * sign * L})
    if value != numbers.pop(key(r), 0): # one that is 0 here has no row
        bad(key(r), value)
if len(formulas) < 80 or {k[2] for k in numbers if k[1] != "steady"} or {k[2] for k in numbers} != {"mean_velocity"}:
    bad(len(formulas), "formulas; left:", numbers.keys())
END
finish "series --symbolic: every coefficient is the number that --source derived prints"

run 0 series --symbolic --order 3
[ "$(rows out | head -n 1)" = "extension	rest	t1	1	1	-+ ++" ] || note "$(rows out | head -n 1)"
grep -q '^period	steady	displacement	0	m1\*m2\*L\*(2\*alpha - 1)\*(F1 - F2)/(M\*(m1\*F1\*alpha^2 + m2\*F2\*(1 - alpha)^2))	' out || note "(28) is $(grep displacement out)"
run 0 series --symbolic --source limit --gait sinusoidal --order 4
[ "$(rows out | wc -l)" = 8 ] || note "$(rows out | wc -l) terms"
grep -q 'root of F1\*alpha\*asin' out || note "no equation"
run 0 series --symbolic --source closed --format json
grep -q '"quantity": "v_mid", "power": "-", "coefficient": "' out || note "$(tail -n 1 out | cut -c 1-99)"
finish "series --symbolic: (28), the limit's equation and terms, and the closed form"

# ---- Python: formulas are exact for fractions; of numbers, constants are rounded ----
for options in "--symbolic --order 8" "--source derived --order 8"; do
  # shellcheck disable=SC2086
  run 0 series $options $crawler --emit python -o made.py
  # shellcheck disable=SC2086
  run 0 series --source derived --order 8 $crawler
  python out "$options" <<'END'
from fractions import Fraction as F
import inspect, made
L, T = F("2.5"), F(2, 7)
sums = {}
for r in read(sys.argv[1]):
    key = (r["phase"], r["start"], r["quantity"])
    sums[key] = sums.get(key, 0) + F(r["coefficient"]) * T ** int(r["power"])
called = 0
for (phase, start, quantity), wanted in sums.items():
    f = getattr(made, "_".join((phase, start, quantity)), None)
    if not f:
        continue
    sign = -1 if phase == "contraction" else 1
    at = {"m1": F("1.5"), "m2": F("0.7"), "F1": F(3), "F2": F("1.25"), "L": L, "alpha": F("0.6"), "v0": F("-0.4"), "T": T,
          "l0": 4 * sign * L, "lT": -4 * sign * L}
    got = f(**{name: at[name] for name in inspect.signature(f).parameters})
    if got != wanted and ("symbolic" in sys.argv[2] or not abs(got - wanted) < 1e-15 * L):
        bad(f.__name__, got, wanted)
    called += 1
if called < 27:
    bad(called, "functions")
END
done
finish "--emit python: functions that are exact for fractions"

# The closed form is the steady state itself, and the limit a function without T.
run 0 series --symbolic --source closed --emit python -o made.py
run 0 steady
python out <<'END'
import made
[row] = read(sys.argv[1])
for name in ("v_start", "displacement"):
    got = getattr(made, "period_steady_" + name)(m1=1, m2=1, F1=4, F2=1, L=10, alpha=0.75, T=1)
    if not abs(got - float(row[name])) <= 1e-14 * abs(got):
        bad(name, got, row[name])
END
run 0 series --symbolic --source limit --gait sinusoidal --order 4 --emit python -o made.py
python <<'END'
import made
if not made.period_product_U(m1=1, m2=1, F1=4, F2=1, alpha=0.75, l0=1, k0=1) > 0:
    bad("the limit")
END
finish "--emit python: the closed form is the steady state, and the limit is a function without T"

# ---- documents ----
run 0 series --symbolic --order 6 --v0 1 --emit latex
[ "$(grep -c '^.begin{align\*}' out)" = 27 ] || note "$(grep -c '^.begin{align\*}' out) formulas in LaTeX"
grep -q '^  .Delta T &= -.frac{T^{3} (F_{1} - F_{2})}{m_{2} l_{T}} ' out || note "dT is $(grep -m 1 Delta out)"
python out <<'END'
depth = 0
for c in open(sys.argv[1]).read():
    depth += (c == "{") - (c == "}")
    if depth < 0:
        bad("a brace closes that is not open")
if depth:
    bad("braces stay open")
END
finish "--emit latex: well-formed, a formula for each quantity"

# ---- what is refused ----
refused() { # WORDS ARGUMENT...
  words=$1
  shift
  run 2 series "$@"
  grep -q -e "$words" err || note "$*: $(cat err)"
}
refused "order from 1 to 16" --symbolic --order 17
refused "order from 1 to 10" --symbolic --source limit --order 11
refused "closed form has no terms" --symbolic --source closed --order 4
refused "derived series: the published ones" --symbolic --source published
refused "needs --symbolic" --source closed
refused "steady state" --symbolic --source limit --v0 1
refused "exclude each other" --symbolic --digits 5
refused "exclude each other" --symbolic --bound
refused "exclude each other" --symbolic --points -
refused "derived series" --emit latex
refused "emit c is no longer there: sympy" --symbolic --emit c
refused "takes text, latex or python" --symbolic --emit fortran
refused "for tables" --symbolic --emit python --format json
refused "derived series" --bound --emit python
run 3 series --symbolic --gait minimum-jerk
grep -q "l'' = 0" err && grep -q "no formula: l'' = 0" out || note "$(cat err)"
run 3 series --symbolic --alpha 0.5 --source closed
grep -q "alpha = 1/2" err || note "$(cat err)"
run 3 series --symbolic --gait sinusoidal --emit python
grep -q "not linear" err && grep -q extension_rest_dT out || note "$(cat err)"
run 4 series --symbolic --emit python -o no/such/folder/made.py
run 0 series --symbolic --order 4 --quiet
cells out start quantity power >got
grep -q '^rest.dT.3' got || note "the power of a term that stands alone: $(grep 'rest.dT' got)"
run 0 series --symbolic --order 3 --v0 1 --quiet
cells out start quantity power >got
[ "$(grep -c '^v0.dT.2$' got)" = 2 ] && [ "$(grep -c '^v0.t1.2$' got)" = 2 ] && [ "$(grep -c '^rest.t1.1$' got)" = 2 ] || note "--v0 1: $(grep 't1\|dT' got)"
run 0 series --symbolic --order 2 --quiet
cells out start quantity power >got
[ "$(grep -c '^steady.v_start.1$' got)" = 1 ] && [ "$(grep -c '^rest.v_end.1$' got)" = 2 ] || note "--order 2: $(cat got)"
run 0 series --symbolic --source limit --order 2 --quiet
[ "$(cells out quantity power | sort -u)" = "U 1" ] || note "limit: $(cells out quantity power)"
run 0 series --symbolic --order 1 --v0 1 --quiet
finish "what has no formula is refused with its reason"
# ---- the name of a measured gait's file, in what is emitted ----
named() { # NAME
  printf 't l\n0 3\n1 5\n2 2\n4 1\n5 2\n10 3\n' >"$1"
  for language in python latex; do
    run 0 series --source derived --order 2 --gait "measured:$1:monotone" --quiet --emit $language
    mv out "emitted.$language"
  done
  /usr/bin/python3 emitted.python >said 2>&1 || note "$1: no Python: $(tail -n 1 said)"
  [ ! -e hacked ] || note "$1: Python ran the name"
}
mkdir 'a*' # a slash is one of a folder
named '"""+str(__import__("os").system("touch hacked"))+"""'
named 'a*/; int main(void) { return hacked; }'
named '<img src=x onerror=alert(1)>&amp;'
named 'back\slash\N{'
finish "the name of a file is no program in what is emitted"

exit $failed
