#!/bin/sh
# series --symbolic and series --emit: formulas, and programs that compute with them.
# Usage: sh tests/compare/command/cli_symbolic.sh build/scallop. One line for each check; non-zero if any failed.
# shellcheck disable=SC2154
. "$(dirname "$0")/../../support/common.sh"
compile() { cc -std=c11 -O1 -Wall -Wextra -Werror "$@" -lm >said 2>&1 || note "cc: $(head -n 2 said)"; }

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

# ---- C: within the rounding of its operations ----
# Fewer than 2000 operations, and pow to a unit, each wrong by 2^-53 of a term, of which those of a sum in brackets are at most some
# thousand times as large as the sum here: 2^-53 2000 1000 = 2e-10 of the largest term.
for options in "--symbolic --order 8" "--source derived --order 8" "--source derived --order 8 --gait sinusoidal"; do
  # shellcheck disable=SC2086
  run 0 series $options $crawler --emit c -o made.c
  # shellcheck disable=SC2086
  run 0 series $options $crawler --emit python -o made.py
  python <<'END'
import inspect, made
sys.stdout = open("main.c", "w")
print('#include <stdio.h>\n#include "made.c"\nint main(void)\n{')
for name, f in inspect.getmembers(made, inspect.isfunction):
    sign = -1 if name.startswith("contraction") else 1
    at = {"m1": 1.5, "m2": 0.7, "F1": 3, "F2": 1.25, "L": 2.5, "alpha": 0.6, "v0": -0.4, "T": 0.3, "l0": 10 * sign, "lT": -10 * sign}
    print('  printf("%s %%.17g\\n", %s(%s));' % (name, name, ", ".join(str(at[p]) for p in inspect.signature(f).parameters)))
print("  return 0;\n}")
sys.stdout.close()
sys.stdout = sys.__stdout__
END
  compile main.c -o made
  ./made >numbers || note "the program fails"
  python numbers <<'END'
import inspect, made
lines = [l.split() for l in open(sys.argv[1])]
for name, number in lines:
    f = getattr(made, name)
    sign = -1 if name.startswith("contraction") else 1
    at = {"m1": 1.5, "m2": 0.7, "F1": 3, "F2": 1.25, "L": 2.5, "alpha": 0.6, "v0": -0.4, "T": 0.3, "l0": 10 * sign, "lT": -10 * sign}
    wanted = f(**{p: at[p] for p in inspect.signature(f).parameters})
    if not abs(float(number) - wanted) <= 2e-10 * max(abs(wanted), 1e-3):
        bad(name, number, wanted)
if len(lines) < 27:
    bad(len(lines), "functions")
END
done
finish "--emit c: a program that compiles without a warning, and agrees with Python's"

# The closed form is the steady state itself.
run 0 series --symbolic --source closed --emit c -o closed.c
printf '#include <stdio.h>\n#include "closed.c"\nint main(void)\n{\n  printf("%%.15g %%.15g\\n", period_steady_v_start(1, 1, 4, 1, 10, 0.75, 1), period_steady_displacement(1, 1, 4, 1, 10, 0.75, 1));\n  return 0;\n}\n' >closed_main.c
compile closed_main.c -o closed
./closed >numbers
run 0 steady --digits 15
[ "$(cat numbers)" = "$(cells out v_start displacement)" ] || note "$(cat numbers) is not $(cells out v_start displacement)"
run 0 series --symbolic --source limit --gait sinusoidal --order 4 --emit c -o limit.c
printf '#include "limit.c"\nint main(void)\n{\n  return period_product_U(1, 1, 4, 1, 0.75, 1, 1) < 0;\n}\n' >limit_main.c
compile limit_main.c -o limit
./limit || note "the limit's program fails"
finish "--emit c: the closed form is the steady state, and the limit is a function without T"

# ---- documents ----
run 0 series --symbolic --order 6 --v0 1 --emit mathml
python out <<'END'
import xml.dom.minidom
text = open(sys.argv[1]).read().replace("<!DOCTYPE html>", "").replace('<meta charset="utf-8">', "").replace("<br>", "")
page = xml.dom.minidom.parseString(text)
if len(page.getElementsByTagName("math")) != 27:
    bad(len(page.getElementsByTagName("math")), "formulas")
for fraction in page.getElementsByTagName("mfrac"):
    if len([c for c in fraction.childNodes if c.nodeType == 1]) != 2:
        bad(fraction.toxml())
END
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
finish "--emit mathml and latex: well-formed, a formula for each quantity"

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
refused "derived series" --emit c
refused "takes text, latex, c, python or mathml" --symbolic --emit fortran
refused "for tables" --symbolic --emit c --format json
refused "derived series" --bound --emit c
run 3 series --symbolic --gait minimum-jerk
grep -q "l'' = 0" err && grep -q "no formula: l'' = 0" out || note "$(cat err)"
run 3 series --symbolic --alpha 0.5 --source closed
grep -q "alpha = 1/2" err || note "$(cat err)"
run 3 series --symbolic --gait sinusoidal --emit c
grep -q "not linear" err && grep -q extension_rest_dT out || note "$(cat err)"
run 4 series --symbolic --emit c -o no/such/folder/made.c
run 0 series --symbolic --order 4 --quiet
cells out start quantity power >got
grep -q '^rest.dT.3' got || note "the power of a term that stands alone: $(grep 'rest.dT' got)"
finish "what has no formula is refused with its reason"
# ---- the name of a measured gait's file, in what is emitted ----
named() { # NAME
  printf 't l\n0 3\n1 5\n2 2\n4 1\n5 2\n10 3\n' >"$1"
  for language in c python mathml latex; do
    run 0 series --source derived --order 2 --gait "measured:$1" --quiet --emit $language
    mv out "emitted.$language"
  done
  "${CC:-cc}" -x c -c -o emitted.o emitted.c 2>said || note "$1: no C: $(head -n 1 said)"
  /usr/bin/python3 emitted.python >said 2>&1 || note "$1: no Python: $(tail -n 1 said)"
  [ ! -e hacked ] || note "$1: Python ran the name"
  ! grep -q '<img' emitted.mathml || note "$1: the name is markup"
}
mkdir 'a*' # a slash is one of a folder
named '"""+str(__import__("os").system("touch hacked"))+"""'
named 'a*/; int main(void) { return hacked; }'
named '<img src=x onerror=alert(1)>&amp;'
named 'back\slash\N{'
finish "the name of a file is no program in what is emitted"

exit $failed
