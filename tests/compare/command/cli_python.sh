#!/bin/sh
# The Python package and scripts/python/figure4.py: the numbers of the command, bit for bit, from the shared library beside it or in
# SCALLOP_LIBRARY.
# Usage: sh tests/compare/command/cli_python.sh build/scallop. One line for each check; non-zero if any failed.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

/usr/bin/python3 -c 'import numpy' 2>err || { echo "ok python: not tried, /usr/bin/python3 has no NumPy"; exit 0; }
abi=$(sed -n 's/^#define SCALLOP_ABI //p' "$root/model/version.h")
for name in libscallop-core libscallop; do
  [ ! -f "$(dirname "$tool")/$name.so.$abi" ] || beside=$(dirname "$tool")/$name.so.$abi
done
library=${SCALLOP_LIBRARY:-${beside:-$(dirname "$tool")/libscallop.so.$abi}}
if readelf -d "$library" 2>err | grep -q 'NEEDED.*lib\(asan\|ubsan\)'; then
  echo "ok python: not tried, the library wants the runtime of a sanitizer"
  exit 0
fi
export SCALLOP_LIBRARY="$library" PYTHONPATH="$root/scripts/python" PYTHONDONTWRITEBYTECODE=1
export PYTHONWARNINGS=error,ignore::ResourceWarning # read() leaves its files open
cat >>tables.py <<'END'
import ctypes, numpy
import crawling_scallop as scallop
from crawling_scallop import _exact as scallop_exact, _gaits, _library as scallop_library, _motion
def same(a, b):
    a, b = numpy.asarray(a, float), numpy.asarray(b, float)
    return a.shape == b.shape and ((a == b) & (numpy.signbit(a) == numpy.signbit(b)) | numpy.isnan(a) & numpy.isnan(b)).all()
PARAMETERS = ("m1", "m2", "F1", "F2", "L", "T", "alpha")
GAITS = {"quadratic": "quadratic", "sinusoidal": "sinusoidal", "trapezoidal:0.2,0.3": scallop.trapezoidal(0.2, 0.3),
         "trapezoidal:0.1,0.9,0.25,0.5": scallop.trapezoidal((0.1, 0.25), (0.9, 0.5)), "skewed:0.3": scallop.skewed(0.3),
         "skewed:0.25,1e-05": scallop.skewed([0.25, 1e-5]), "minimum-jerk": scallop.minimum_jerk(),
         "polynomial:0,3,-2": scallop.polynomial([0, 3, -2]), "constant:0": scallop.constant(),
         "constant:0.1,0.25": scallop.constant([0.1, 0.25])}
def columns(rows, *names):
    return {name: numpy.array([float(row[name]) for row in rows]) for name in names}
def crawlers(rows):
    return {**columns(rows, *PARAMETERS), "gait": [GAITS[row["gait"]] for row in rows]}
def compare(answer, rows, *names):
    for name in names:
        if not same(getattr(answer, name), [float(row[name]) for row in rows]):
            bad(name, "differs")
    for name in ("regime", "modes", "status"):
        if getattr(answer, name).tolist() != [row[name] for row in rows]:
            bad(name, "differs")
    if answer.solved.tolist() != [row["status"] == "ok" for row in rows]:
        bad("solved differs")
END

# ---- the same as the command ----
cat >layout.py <<'END'
import ctypes
import crawling_scallop._library as scallop
def fact(text, value):
    print('_Static_assert(%s == %d, "");' % (text, value))
print('#include <stddef.h>\n#include "asymptotics/asymptotics.h"\n#include "asymptotics/observed/order.h"\n#include "model/families.h"\n#include "model/measured/measured.h"\n#include "numerics/numerics.h"\n#include "numerics/wide/wide.h"')
if scallop.os.environ["WITH_FLINT"] != "0":
    print('#include "numerics/certified/certified.h"')
    fact("SCALLOP_MOST_DIGITS", scallop.MOST_DIGITS)
    fact("SCALLOP_EUNDECIDED", scallop.UNDECIDED)
else:
    del scallop.RationalCrawler, scallop.CertifiedPhase, scallop.CertifiedSteady
fact("SCALLOP_MEASURED_OTHERS", scallop.OTHERS)
fact("SCALLOP_FIT_PHASES", scallop.FITS - 1)
fact("SCALLOP_MODES_TEXT", 3 * scallop.MODES_KEPT + 8)
for name in ("SYMBOLS", "QUANTITIES", "FORMULA_MESSAGE"):
    fact("SCALLOP_" + name, getattr(scallop, name.replace("FORMULA_", "")))
if scallop.os.environ["WITH_FLINT"] != "0":
    fact("sizeof(fmpq_t)", ctypes.sizeof(scallop.Fmpq))
    fact("sizeof(arb_t)", ctypes.sizeof(scallop.Arb))
fact("sizeof(struct scallop_sample)", 8 * len(scallop.SAMPLE))
for place, name in enumerate(scallop.SAMPLE):
    fact(f"offsetof(struct scallop_sample, {name})", 8 * place)
for each in [each for each in vars(scallop).values() if isinstance(each, type) and issubclass(each, ctypes.Structure)]:
    fact(f"sizeof(struct {each.__name__})", ctypes.sizeof(each))
    for name, _ in each._fields_:
        fact(f"offsetof(struct {each.__name__}, {name})", getattr(each, name).offset)
        fact(f"sizeof(((struct {each.__name__} *)0)->{name})", getattr(each, name).size)
END
WITH_FLINT=${WITH_FLINT:-1} /usr/bin/python3 layout.py >layout.c || note "no layout"
[ "$(grep -c _Static_assert layout.c)" -gt 100 ] || note "$(grep -c _Static_assert layout.c) facts"
cc -std=c11 -I"$root" -fsyntax-only layout.c 2>err || note "$(head -n 3 err)"
finish "structures are those of the headers"

python <<'END'
import random
random.seed(20261130)
def spread(low, high):
    return math.exp(random.uniform(math.log(low), math.log(high)))
with open("points.tsv", "w") as f:
    print(*PARAMETERS, "gait", "phase", "v0", sep="\t", file=f)
    for i in range(4000):
        print(*(repr(spread(1e-2, 1e2)) for _ in range(5)), repr(spread(1e-4, 1e1)), repr(random.uniform(0.02, 0.98)),
              list(GAITS)[i % len(GAITS)], ("extension", "contraction")[i // 8 % 2],
              repr(random.uniform(-3, 3) if i % 3 else 0.0), sep="\t", file=f)
    print(*"1e-300 1 4 1 10 1e200 0.75 quadratic extension 0".split(), sep="\t", file=f)
END
run 3 steady --points points.tsv
cp out steady.tsv
python <<'END'
rows = read("steady.tsv")
answer = scallop.steady(**crawlers(rows))
compare(answer, rows, "froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier")
if not same(answer.v_low, answer.v_start) or not same(answer.v_high, answer.v_start):
    bad("v_low or v_high")
if {"sliding", "stick-slip", "at-rest", "-"} != set(answer.regime.tolist()) or not math.isnan(answer.froude[-1]):
    bad("the points do not have every regime")
END
finish "steady: the rows of steady --points, every bit"

run 3 phase --points points.tsv
cp out phase.tsv
python <<'END'
rows = read("phase.tsv")
for kind in ("extension", "contraction"):
    some = [row for row in rows if row["phase"] == kind]
    compare(scallop.phase(kind, **crawlers(some), **columns(some, "v0")), some, "t1", "dT", "v_end", "dx1", "dx2", "dxC")
END
finish "phase: the rows of phase --points, every bit"

run 0 trajectory --start 2.5 --periods 3 --samples 50 --F1 3 --gait skewed:0.3
python <<'END'
rows = read("out")
motion = scallop.trajectory(2.5, periods=3, samples=50, F1=3, gait=GAITS["skewed:0.3"])
for name, values in columns(rows, *motion._fields).items():
    if not same(getattr(motion, name), values):
        bad(name, "differs")
END
finish "trajectory: the rows of trajectory"

python <<'END'
for kind in "extension", "contraction":
    for gait in "quadratic", "sinusoidal", "constant:0":
        if gait == "constant:0":
            gait = scallop.constant(0)
        phase = scallop.phase(kind, 0.5, F1=3, gait=gait)
        i = scallop.intervals(kind, 0.5, F1=3, gait=gait)
        if abs(i.dx1.sum() - phase.dx1) > 1e-14 or abs(i.dx2.sum() - phase.dx2) > 1e-14:
            bad(kind, gait, "displacements:", i, phase)
        modes = " ".join("-0+"[int(a) + 1] + "-0+"[int(b) + 1] for a, b in zip(i.s1, i.s2))
        if i.t_begin[0] != 0 or abs(i.duration.sum() - i.t_end[-1]) > 1e-15 or any(i.t_begin[1:] != i.t_end[:-1]):
            bad(kind, gait, "times:", i)
        if not set(modes.split()) >= set(phase.modes.split()):
            bad(kind, gait, "modes:", modes, phase.modes)
for wrong in dict(phase="period"), dict(phase="extension", T=[1, 2]), dict(phase="extension", L=0):
    try:
        bad(wrong, "gives", scallop.intervals(**wrong))
    except ValueError:
        pass
END
finish "intervals: they add up to the phase"

run 0 series --F1 3 --gait sinusoidal --v0 2.5
python <<'END'
rows = read("out")
found = 0
for row in rows:
    if row["phase"] == "contraction" and re.match("eq(1[2-9]|2[01]|A15B6)_", row["formula"]):
        continue
    taken = {}
    if row["phase"] != "period":
        start = 0 if re.match("eq(1[2-9]|2[01]|A15B6)_", row["formula"]) else 2.5
        exact = scallop.phase(row["phase"], start, F1=3, gait="sinusoidal")
        taken = dict(t1=exact.t1, dT=exact.dT)
    value = scallop.published(row["formula"], 2.5, F1=3, gait="sinusoidal", **taken)
    if math.isnan(value) and "_from_dT" in row["formula"]:
        continue  # it takes x_switch, which no command prints
    if "%.15g" % value != "%.15g" % float(row["published"]):
        bad(row["formula"], value, row["published"])
    if scallop.formulas()[row["formula"]][0] != row["equation"]:
        bad(row["formula"], "has another equation")
    found += 1
if found < 35 or {row["formula"] for row in rows} != {name for name in scallop.formulas() if not name.startswith(("eq6_", "eq7_", "eq8_"))}:  # for F1 = F2
    bad(found, "formulas")
if scallop.published("eqA23_dx1_from_dT_short", 2.5, dT=0.1, x_switch=[1, 2]).shape != (2,):
    bad("given values do not broadcast")
END
finish "published: the values of series"

# ---- formulas of one's own ----
python <<'END'
numbers = dict(m1=numpy.array([1.3, 0.2, 7]), m2=numpy.array([[0.9], [2]]), F1=3.7, F2=numpy.linspace(1, 2, 3), L=2.3,
               T=numpy.array([[0.7], [0.1]]), alpha=0.6)
m1, m2, F1, F2, L, T, alpha = numbers.values()
M = m1 + m2
for text, motion, wanted in (
    ("-(F1 - F2)/M*T^2/8", "steady", -(F1 - F2) / M * (T * T) / 8),
    ("-(F1 - F2)/M*T^2/8 + v0", "extension", -(F1 - F2) / M * (alpha * T * (alpha * T)) / 8 + 0.5),
    ("l0*m1 - lT*l_start", "contraction", -4 * L * m1 - 4 * L * L + 0 * M),
    ("max(F2, L^-1)*abs(l0)/mstar", "extension", numpy.maximum(F2, 1 / L) * (4 * L) / (m1 * m2 / M)),
    ("t1*2 + dT/x_switch", "extension", 0.25 * 2 + 8 / numpy.array([1.0, 2, 4]) + 0 * M),
):
    made = scallop.formula(text, motion, {"mstar": "m1*m2/M"})
    taken = dict(t1=0.25, dT=8, x_switch=[1.0, 2, 4]) if "t1" in text else {}
    got = made(0.5, **numbers, **taken)
    if got.shape != (2, 3) or not numpy.allclose(got, wanted, rtol=24 * 2**-53, atol=0):  # at most 12 roundings each
        bad(text, motion, got, wanted)
    if made.text != text or made.motion != motion:
        bad(made)
made = scallop.formula("T*L/F1")
if not isinstance(made(), float) or made(F1=[]).shape != (0,) or made() != 2.5:
    bad("not a number, or not nothing:", made(), made(F1=[]))
if not math.isinf(scallop.formula("1/(F1 - F2)")(F1=1)) or not math.isnan(scallop.formula("sqrt(-L)")()):
    bad("off its domain")
END
finish "formulas of one's own: NumPy's values, in the common shape"

if [ "${WITH_FLINT:-1}" != 0 ]; then
  run 0 series --source derived --order 8 --F1 3 --m2 0.7 --v0 0.4
  cp out derived.tsv
  run 0 series --source derived --order 8 --F1 3 --m2 0.7 --v0 0.4 --gait sinusoidal
  cp out derived_sine.tsv
  python <<'END'
import decimal, fractions
def compare_series(rows, gait, digits=17, **more):
    for motion, names in scallop_exact.QUANTITIES.items():
        got = scallop.series(motion, 0.4, 8, digits, F1=3, m2=0.7, gait=gait, **more)
        for name in names:
            some = {int(row["power"]): row["coefficient"] for row in rows
                    if row["phase"].replace("period", "steady") == motion and row["start"] != "rest" and row["quantity"] == name}
            terms = getattr(got, name)
            if name != "friction_work" and (not some or sorted(some) != sorted(terms)):
                bad(motion, name, "has other powers:", *terms)
            for power, text in some.items():
                a, wanted = terms[power], fractions.Fraction(text)
                if isinstance(a, fractions.Fraction):
                    right = a == wanted
                else:
                    unit = fractions.Fraction(10) ** decimal.Decimal(text).as_tuple().exponent
                    right = abs(fractions.Fraction(a.middle) - wanted) <= unit + fractions.Fraction(a.radius)
                    right = right and fractions.Fraction(a.radius) * 10**digits <= abs(wanted) + unit
                if not right or isinstance(a, scallop.Ball) and gait == "quadratic":
                    bad(motion, name, power, a, text)
compare_series(read("derived.tsv"), "quadratic")
compare_series(read("derived_sine.tsv"), "sinusoidal")
compare_series(read("derived_sine.tsv"), "sinusoidal", digits=60, alpha="3/4")
END
  finish "series: the coefficients of series --source derived"

  python <<'END'
from decimal import Decimal
from fractions import Fraction
third = Fraction(1, 3)
for same_number in (Fraction(7, 10), Decimal("0.7"), "0.7", "7/10", 0.7, numpy.float64(0.7), numpy.array(0.7)):
    if scallop.series(F1=3, m2=same_number, order=3).displacement != scallop.series(F1=3, m2="7/10", order=3).displacement:
        bad(repr(same_number), "is another number")
s = scallop.series("extension", v0=third, order=6, F1=3)
if s.v_end[0] != third or s.v_end[-5] != 0 or s.dx1[0] != -5 or type(s.v_end[0]) is not Fraction or s.modes != "++ -+ ++":
    bad("coefficients:", s)
try:
    bad("beyond the order:", s.v_end[6])
except KeyError:
    pass
T = numpy.array([[0.01, 0.005], [0.0025, 0.02]])
off = scallop.series("extension", v0=0.25, order=5, F1=3).dxC(T) - scallop.phase("extension", 0.25, F1=3, T=T / 0.75).dxC
if off.shape != T.shape or (abs(off) > 10 * T**5).any() or not isinstance(s.dxC(0.5), float):
    bad("the sums of the terms:", off)
rest = scallop.series("extension", F1=2, F2=2, order=4)
if rest.t1 or rest.dT or rest.modes != "-+" or rest.dx2 != {0: 5}:
    bad("equal forces:", rest)
work = scallop.series(order=4, digits=30).friction_work
if set(work) != {0} or abs(Fraction(work[0].middle) - Fraction(1760, 37)) > Fraction(work[0].radius) or work[0].radius > 1e-28:
    bad("friction_work:", work)
END
  finish "series: fractions, floats and arrays"

  python <<'END'
from fractions import Fraction
def holds(ball, wanted, digits):
    error = abs(Fraction(ball.middle) - wanted)
    return error <= ball.radius and Fraction(ball.radius) * 10**digits <= abs(wanted) and float(ball) == float(ball.middle)
made = scallop.formula("(F1 - F2)/M*T^2/8 + v0/mstar", "extension", {"mstar": "m1*m2/M"})
wanted = (Fraction(10, 3) - 1) / Fraction(17, 10) * Fraction(3, 8)**2 / 8 + Fraction(1, 7) / Fraction(7, 17)
for digits in (1, 17, 300):
    if not holds(made.ball(digits, v0="1/7", F1="10/3", m2=0.7, T=0.5), wanted, digits):
        bad(digits, made.ball(digits, v0="1/7", F1="10/3", m2=0.7, T=0.5), wanted)
if made.ball(F1=1, v0=0) != (0, 0) or "+/-" not in str(made.ball()):
    bad("not 0:", made.ball(F1=1, v0=0))
root = scallop.formula("sqrt(2)^2 - 2 + L^3*1e-40").ball(20)
if not holds(root, Fraction(1, 10**37), 20):
    bad("cancelled:", root)
zero = scallop.formula("sqrt(2)^2 - 2").ball()
if zero.middle != 0 or not 0 < zero.radius < 1e-300:
    bad("around 0:", zero)
END
  finish "formulas in balls"
fi

# ---- certified digits and errors are those of the command ----
run 0 steady --error --F1 3 --m2 0.7 --gait sinusoidal
cp out errors.tsv
run 0 phase --error --F1 3 --v0 0.5 --phase contraction
python <<'END'
steady, phase = read("errors.tsv")[0], read("out")[0]
for row, found in (steady, scallop.steady_errors(F1=3, m2=0.7, gait="sinusoidal")), (phase, scallop.phase_errors("contraction", 0.5, F1=3)):
    for name, value in found._asdict().items():
        if not (math.isnan(value) if math.isnan(number(row, name + "_error")) else near(value, number(row, name + "_error"), 0.01)):
            bad(name, value, row)
END
finish "steady_errors, phase_errors: those of --error"
if [ "${WITH_FLINT:-1}" != 0 ]; then
  run 0 steady --certified --digits 30 --F1 3 --gait sinusoidal
  cp out certified.tsv
  run 0 phase --certified --digits 30 --F1 3 --v0 0.5 --phase contraction
  python <<'END'
from decimal import Decimal
steady, phase = read("certified.tsv")[0], read("out")[0]
for row, found in ((steady, scallop.certified(F1=3, gait="sinusoidal", digits=30)),
                   (phase, scallop.certified("contraction", v0="1/2", F1=3, digits=30))):
    names = [name for name in vars(found) if name in row and isinstance(getattr(found, name), scallop.Ball)]
    if len(names) < 5:
        bad(names, row)
    for name in names:
        text = row[name]
        unit = Decimal(1).scaleb(Decimal(text).as_tuple().exponent)
        if abs(getattr(found, name).middle - Decimal(text)) > unit:
            bad(name, getattr(found, name), text)
    if (found.modes, found.regime) != (row["modes"], row["regime"]):
        bad(found, row)
END
  finish "certified: the digits of --certified"
fi

# ---- the tests of the package, and the examples in its docstrings and in the documents ----
if /usr/bin/python3 -c 'import pytest' 2>err; then
  SCALLOP_COMMAND=$tool SCALLOP_PAGES=$root/docs/reference/python.md:$root/docs/guide/order.md /usr/bin/python3 -m pytest -q -p no:cacheprovider --pyargs crawling_scallop \
    >said 2>&1 || note "$(grep -m 3 -e ^FAILED -e ^ERROR said || tail -n 3 said)"
  grep -q -E '^[3-9][0-9] passed' said || note "$(tail -n 1 said)"
  finish "pytest --pyargs crawling_scallop, with the examples of docs/reference/python.md and docs/guide/order.md"
fi
if command -v mypy >/dev/null && [ -f "$root/pyproject.toml" ]; then
  MYPYPATH=$root/scripts/python mypy --strict --config-file "$root/pyproject.toml" --cache-dir "$scratch/mypy" -p crawling_scallop >said 2>&1 || note "$(head -n 3 said)"
  finish "mypy --strict"
fi

# ---- arrays ----
python <<'END'
F1, T = numpy.array([1.5, 3, 40]), numpy.array([[0.1], [1]])
grid = scallop.steady(F1=F1, T=T)
if grid.displacement.shape != (2, 3) or grid.modes.shape != (2, 3) or grid.regime[0, 0] != "sliding":
    bad("shapes", grid)
for i in range(2):
    for j in range(3):
        one = scallop.steady(F1=F1[j], T=float(T[i, 0]))
        if one.displacement != grid.displacement[i, j] or one.modes != grid.modes[i, j]:
            bad("one by one differs")
        if not isinstance(one.displacement, float) or not isinstance(one.modes, str) or one.status != "ok" or not one.solved:
            bad("not a number and texts", one)
gaits = scallop.steady(gait=numpy.array(["quadratic", "sinusoidal"]), F1=[[3], [4]])
if gaits.v_mid[1, 0] != scallop.steady().v_mid or gaits.v_mid[0, 1] != scallop.steady(F1=3, gait="sinusoidal").v_mid:
    bad("gaits do not broadcast")
END
finish "parameters broadcast together"

python <<'END'
for answer in (scallop.steady(F1=[]), scallop.phase("extension", numpy.empty((0, 3))), scallop.steady(gait=[])):
    for name in (*answer._arrays, "regime", "modes", "status", "solved"):
        if getattr(answer, name).size != 0 or getattr(answer, name).shape[0] != 0:
            bad(name, getattr(answer, name))
if scallop.published("eq21_dxC", F1=[]).shape != (0,) or "array([]" not in repr(scallop.steady(F1=[])):
    bad("no formula of nothing")
END
finish "zero length"

python <<'END'
numbers = numpy.linspace(1, 7, 12)
wanted = scallop.steady(F1=numbers).v_start
for name, other in {"strided": numpy.repeat(numbers, 3)[::3], "backward": numbers[::-1].copy()[::-1],
                    "big-endian": numbers.astype(">f8"), "object": numbers.astype(object), "list": numbers.tolist(),
                    "unaligned": numpy.frombuffer(b"x" + numbers.tobytes(), numpy.uint8)[1:].view(float)}.items():
    if not same(scallop.steady(F1=other).v_start, wanted):
        bad(name, "differs")
for kind in (numpy.float32, numpy.int64, numpy.uint8, numpy.longdouble):
    if not same(scallop.steady(F1=numpy.array([2, 3, 5], kind)).v_start, scallop.steady(F1=[2.0, 3.0, 5.0]).v_start):
        bad(kind, "differs")
square = numbers.reshape(3, 4)
for other in (square, numpy.asfortranarray(square), numpy.tile(square, (2, 2))[:3, 4:]):
    if not same(scallop.steady(F1=other).v_start, wanted.reshape(3, 4)):
        bad("order in memory matters")
END
finish "arrays of every kind and order in memory"

python <<'END'
seen, give = [], _motion._crawlers
_motion._crawlers = lambda columns: seen.append(give(columns)) or seen[-1]
numbers = {name: numpy.linspace(0.5, 0.9, 100).reshape(10, 10) for name in PARAMETERS}
numbers["F1"].flags.writeable = False
scallop.steady(**numbers)
scallop.phase("extension", **numbers)
numbers["T"] = numbers["T"].T
before = numbers["T"].copy()
scallop.steady(**numbers)
for name in PARAMETERS:
    places = [getattr(each, name) == numbers[name].ctypes.data for each in seen]
    if places != [True, True, name != "T"]:
        bad(name, "is copied, or is not:", places)
if not same(numbers["T"], before):
    bad("T was changed")
odd = numpy.frombuffer(bytes(1) + before.tobytes(), numpy.uint8)[1:].view(float)
scallop.steady(T=odd)
if odd.flags.aligned or seen[-1].T % odd.itemsize != 0 or not same(odd, before.ravel()):
    bad("an array that is not aligned is handed over")
END
finish "float64 arrays in C order are not copied"

# ---- threads ----
python <<'END'
rows = crawlers(read("steady.tsv"))
for call in (scallop.steady, lambda **rows: scallop.phase("contraction", 0.5, **rows)):
    one, some = call(**rows), [call(threads=threads, **rows) for threads in (2, 3, 8)]
    for other in some:
        for name in one._arrays:
            if not same(getattr(one, name), getattr(other, name)):
                bad(name, "depends on the threads")
        for name in ("modes", "status", "regime"):
            if (getattr(one, name) != getattr(other, name)).any():
                bad(name, "depends on the threads")
END
finish "threads do not matter"

python <<'END'
import threading, time
ticks, stop, spans, asked = [], threading.Event(), [], []
def tick():
    while not stop.wait(0.001):
        ticks.append(time.perf_counter())
library = scallop_library.library()
class Timed:
    def __getattr__(self, name):
        return getattr(library, name)
    def scallop_steady_batch(self, *arguments):
        asked.append(arguments[-1])
        begin = time.perf_counter()
        failed = library.scallop_steady_batch(*arguments)
        spans.append((begin, time.perf_counter()))
        return failed
scallop_library._loaded = Timed()
ticker = threading.Thread(target=tick)
ticker.start()
count = 1 << 16
while not spans or spans[-1][1] - spans[-1][0] < 0.2:
    scallop.steady(T=numpy.linspace(0.1, 3, count), gait="sinusoidal")
    count *= 2
stop.set()
ticker.join()
begin, end = spans[-1]
scallop.steady(threads=3)
if asked[0] != 1 or asked[-1] != 3:
    bad("the library was asked for", asked, "threads")
within = sum(begin + 0.1 * (end - begin) < t < end - 0.1 * (end - begin) for t in ticks)
if within < 5:
    bad("another thread ran", within, "times in", end - begin, "s")
END
finish "other threads of Python run meanwhile"

python <<'END'
import gc
wanted = [scallop.steady(gait=scallop.skewed(i / 64)).displacement for i in range(1, 64)]
got = scallop.steady(gait=[scallop.skewed(i / 64) for i in range(1, 64)]).displacement
gc.collect()
if not same(got, wanted) or len(set(wanted)) < 50:
    bad("gaits made on the way differ")
for name, gait in GAITS.items():
    if not isinstance(gait, str) and gait.name != name:
        bad(gait, "is not called", name)
texts = ["skewed:0.3", "minimum-jerk", "trapezoidal:0.2,0.3", "quadratic"]
made = [scallop.skewed(0.3), scallop.minimum_jerk(), scallop.gait_of("trapezoidal", 0.2, 0.3), "quadratic"]
if not same(scallop.steady(gait=texts).v_start, scallop.steady(gait=made).v_start):
    bad("a gait as --gait writes it is another one")
many = scallop.steady(gait=scallop.constant(), alpha=[0.5, 0.75])
if not same(many.v_low, [-10, many.v_start[1]]) or not same(many.v_high, [9.25, many.v_start[1]]):
    bad("intervals:", many.v_low, many.v_high)
if many.status.tolist() != ["interval of steady states", "ok"]:
    bad("intervals:", many.status)
END
finish "gaits live as long as they are needed, with the names of --gait"

help_of steady >out
python out <<'END'
text = open(sys.argv[1]).read().split("\nGaits")[1].split("\n\n")[0].replace("\n      ", " ") # a long sentence goes on
listed = {line.split()[0].split(":")[0].rstrip("["): " ".join(line[2:].split("  ", 1)[1].split()) for line in text.strip().split("\n")[1:]}
if list(listed) != [*scallop.gaits(), "measured"]:
    bad("families:", list(listed), list(scallop.gaits()))
for name, (numbers, usual, sentence) in scallop.gaits().items():
    if listed[name] != sentence + (f" ({usual})" if numbers and usual else ""):
        bad(name, listed[name], "is not", numbers, usual, sentence)
END
finish "gaits() are those of --help"

# ---- bad input ----
python <<'END'
import reprlib
nan, inf = math.nan, math.inf
grid = numpy.ones((2, 3))
grid[1, 2] = -2
allowed = {name: entry[0].allowed.decode() for name, entry in _gaits._families().items() if entry[0].allowed}
families = ", ".join(name for name in scallop.gaits() if name not in ("quadratic", "sinusoidal"))
none = ", ".join(scallop.gaits()) + ", with numbers as in 'skewed:0.3', or a Gait"
for call, wanted in {
    (lambda: scallop.steady(F1=-3)): "F1 = -3.0: a finite number > 0",
    (lambda: scallop.steady(F1=[1, -3, -4], T=[1, 1, 0])): "row 1: F1 = -3.0: a finite number > 0",
    (lambda: scallop.steady(m2=grid)): "row (1, 2): m2 = -2.0: a finite number > 0",
    (lambda: scallop.steady(alpha=[0.5, 1])): "row 1: alpha = 1.0: a number between 0 and 1, both excluded",
    (lambda: scallop.phase("extension", [0, 1, inf])): "row 2: v0 = inf: a finite number",
    (lambda: scallop.phase("contraction", nan, L=inf)): "L = inf: a finite number > 0",
    (lambda: scallop.phase("rest")): "kind = 'rest': 'extension' or 'contraction'",
    (lambda: scallop.phase(["extension"])): "kind = ['extension']: 'extension' or 'contraction'",
    (lambda: scallop.steady(T="1")): "T: real numbers are wanted, not '1'",
    (lambda: scallop.steady(T=1j)): "T: real numbers are wanted, not 1j",
    (lambda: scallop.steady(T=None)): "T: real numbers are wanted, not None",
    (lambda: scallop.steady(T=[[1], [1, 2]])): "T: real numbers are wanted, not [[1], [1, 2]]",
    (lambda: scallop.steady(T=[1, 10**400])): "T: real numbers are wanted, not " + reprlib.repr([1, 10**400]),
    (lambda: scallop.steady(T=[1, 2], F1=[1, 2, 3])): "these do not broadcast together: F1 (3,), T (2,)",
    (lambda: scallop.steady(gait="walk")): "gait = 'walk': " + none,
    (lambda: scallop.steady(gait=["quadratic", None])): "gait = None: " + none,
    (lambda: scallop.steady(gait={})): "gait = {}: " + none,
    (lambda: scallop.steady(gait="measured:beats.tsv")): "gait = 'measured:beats.tsv': " + none,
    (lambda: scallop.steady(gait="skewed:2")): "gait = 'skewed:2': numbers = [2.0]: " + allowed["skewed"],
    (lambda: scallop.steady(gait="skewed:a")): "gait = 'skewed:a': could not convert string to float: 'a'",
    (lambda: scallop.steady(threads=0)): "threads = 0: a whole number from 1 to 2147483647",
    (lambda: scallop.steady(threads=1.5)): "threads = 1.5: a whole number from 1 to 2147483647",
    (lambda: scallop.trapezoidal(0.7, 0.4)): 
        "numbers = [0.7, 0.4]: trapezoidal:UP,DOWN or trapezoidal:UP,DOWN,UP,DOWN, fractions of the extension and of the contraction "
        "in which |l'| rises and falls: from 2^-100, UP + DOWN at most 1",
    (lambda: scallop.trapezoidal([1, 2, 3])): "up: one number, or two for extension and contraction, not [1, 2, 3]",
    (lambda: scallop.skewed(1)): "numbers = [1.0]: skewed:BETA or skewed:BETA,BETA, fractions of the extension and of the contraction in which |l'| rises: "
        "from 2^-100, below 1",
    (lambda: scallop.constant(0.6)): "numbers = [0.6]: " + allowed["constant"],
    (lambda: scallop.gait_of("constant")): "numbers = []: " + allowed["constant"],
    (lambda: scallop.gait_of("trapezoidal", 0.1)): "numbers = [0.1]: " + allowed["trapezoidal"],
    (lambda: scallop.gait_of("minimum-jerk", 0.1)): "numbers = [0.1]: none",
    (lambda: scallop.gait_of("polynomial")): "numbers = []: " + allowed["polynomial"],
    (lambda: scallop.gait_of("quadratic")): "family = 'quadratic': " + families,
    (lambda: scallop.gait_of("walk", 1)): "family = 'walk': " + families,
    (lambda: scallop.gait_of("skewed", "1")): "numbers: real numbers are wanted, not ('1',)",
    (lambda: scallop.polynomial([1, 2, 3])): "numbers = [1.0, 2.0, 3.0]: C1 is not 0, and so l' not at the start",
    (lambda: scallop.polynomial([0, 1])): "coefficients: a sequence of 3 to 16 numbers, not [0, 1]",
    (lambda: scallop.trajectory(periods=0)): "periods = 0: a whole number from 1 to 2147483647",
    (lambda: scallop.trajectory(T=[1, 2])): "a trajectory is that of one crawler: its parameters are numbers",
    (lambda: scallop.trajectory(nan)): "v0 = nan: a finite number",
    (lambda: scallop.published("eq21_dxc", F1=2)): 
        "name = 'eq21_dxc': a formula that formulas() lists; did you mean 'eq21_dxC'?",
    (lambda: scallop.published("eq21_dxC", L=[1, 0])): "row 1: L = 0.0: a finite number > 0",
    (lambda: scallop.formula("F1*(T")): "text = 'F1*(T': character 4: this '(' is not closed",
    (lambda: scallop.formula("alfa*T")): "text = 'alfa*T': character 1: 'alfa' is no quantity known here; did you mean 'alpha'?",
    (lambda: scallop.formula("q", parts={"q": "2*F1 +"})): 
        "text = 'q': q, character 7: a number, a name or '(' is missing before the end",
    (lambda: scallop.formula("T*v0")): "text = 'T*v0': the steady state has no v0",
    (lambda: scallop.formula("T", "period")): "motion = 'period': 'steady', 'extension' or 'contraction'",
    (lambda: scallop.formula(1)): "text = 1, parts = None: a text, and a dict of texts",
    (lambda: scallop.formula("T\0*2")): r"text = 'T\x00*2': it has a NUL",
    (lambda: scallop.formula("T", parts={"F1": "2"})): "parts: 'F1' cannot be the name of a part",
    (lambda: scallop.formula("T")(F1=[1, -2])): "row 1: F1 = -2.0: a finite number > 0",
}.items():
    try:
        bad("no error:", wanted, call())
    except ValueError as error:
        if str(error) != wanted:
            bad("got:", error, "wanted:", wanted)
END
finish "bad input is a ValueError that says where, what and what is allowed"

python <<'END'
t = numpy.linspace(0, 2, 61)[:-1]
l = 3 - 2 * numpy.cos(numpy.pi * t)
numpy.savetxt("recording.csv", numpy.column_stack([t, l]), delimiter=",", header="t [s],l [m]", comments="")
END
run 0 steady --F1 3 --gait measured:recording.csv
cp out measured.tsv
python <<'END'
import gc
table = numpy.loadtxt("recording.csv", delimiter=",", skiprows=1)
gait = scallop.measured(*table.T)
rows = read("measured.tsv")
answer = gait.steady(F1=[3.0])
compare(answer.value, rows, "v_start", "displacement", "multiplier")
if not (gait.L == float(rows[0]["L"]) and gait.T == float(rows[0]["T"]) and gait.alpha == float(rows[0]["alpha"])):
    bad("L, T, alpha", gait.L, gait.T, gait.alpha)
if gait.text != "60 rows, closed over a gap of one step after the last, period 2; a smooth least-squares spline, 42 segments, noise 8.8e-08 of L":
    bad(gait.text)
true = scallop.steady(F1=3, L=4, T=2, alpha=0.5, gait="sinusoidal").v_start
if not (answer.low["v_start"][0] < true < answer.high["v_start"][0] and abs(answer.value.v_start[0] / true - 1) < 1e-2):
    bad(answer, true)
if abs(gait.at(table[:, 0]) - table[:, 1]).max() > 1e-6 or gait.at(0.5).shape:
    bad("at")
if abs(numpy.array(gait.samples) - table.T).max() > 1e-14:
    bad("samples")
moving = gait.phase("extension", v0=0.1)
if not moving.low["dxC"] < moving.value.dxC < moving.high["dxC"]:
    bad(moving)
kept = next(other for other in gait.others if other)
wanted = scallop.steady(gait=kept, L=kept.L, T=kept.T, alpha=kept.alpha).v_start
del gait, answer, moving
gc.collect()
if scallop.steady(gait=kept, L=kept.L, T=kept.T, alpha=kept.alpha).v_start != wanted:
    bad("a gait that is gone")
shuffled = numpy.random.default_rng(1).permutation(numpy.vstack([table, [[numpy.nan, 1], [1, numpy.nan]]]))
if scallop.measured(shuffled[::-1, 0], shuffled[::-1, 1], fit="monotone").T != 2:
    bad("order of rows")
for arguments, wanted in (
    (([1, 2], [1]), "t and l: two arrays of one length are wanted, not shapes (2,) and (1,)"),
    (([0, 1, 2, 3], [1, 1, 1, 1]), "t and l: l is the same throughout: there is no gait in that"),
    (([0, 1, 2, 3, 4], [0, 1, 2, 3, 4]), "t and l: not periodic: l at the end is further from l at the start than a step between rows can bring it"),
    (("a", [0, 1]), "t: real numbers are wanted, not 'a'"),
    ((*table.T, "spline"), "fit = 'spline': one of chosen, monotone, cubic, smooth, phases"),
    ((*table.T, "smooth", -1), "sigma = -1: a number, 0 where it is not known"),
):
    try:
        bad("no error:", wanted, scallop.measured(*arguments))
    except ValueError as error:
        if str(error) != wanted:
            bad("got:", error, "wanted:", wanted)
END
finish "measured: a recording gives the gait of --gait measured, and intervals"

if [ "${WITH_FLINT:-1}" != 0 ]; then
  python <<'END'
import pathlib
with_series, core = scallop_library.LIBRARIES
for call, kind, wanted in (
    (lambda: scallop.series("rest"), ValueError, "motion = 'rest': 'steady', 'extension' or 'contraction'"),
    (lambda: scallop.series(order=0), ValueError, "order = 0: a whole number from 1 to 1000"),
    (lambda: scallop.series(digits=1.5), ValueError, "digits = 1.5: a whole number from 1 to 1000"),
    (lambda: scallop.series(F1="-1/3"), ValueError, "F1 = '-1/3': a finite number > 0"),
    (lambda: scallop.series(alpha=1), ValueError, "alpha = 1: a number between 0 and 1, both excluded"),
    (lambda: scallop.series(m1="1e999999999999"), ValueError, "m1 = '1e999999999999': the exponent is beyond 100000"),
    (lambda: scallop.series(m1="1/0"), ValueError, "m1: a finite number is wanted, not '1/0'"),
    (lambda: scallop.series(m1=math.inf), ValueError, "m1: a finite number is wanted, not inf"),
    (lambda: scallop.series(m1=[1, 2]), ValueError, "m1: a finite number is wanted, not [1, 2]"),
    (lambda: scallop.series("extension", v0=math.nan), ValueError, "v0: a finite number is wanted, not nan"),
    (lambda: scallop.series(gait="walk"), ValueError, "gait = 'walk': " + ", ".join(scallop.gaits()) + ", with numbers as in 'skewed:0.3', or a Gait"),
    (lambda: scallop.series("extension", gait=scallop.minimum_jerk()), ValueError, None),
    (lambda: scallop.formula("1/(F1 - F2)").ball(F1=1), ArithmeticError, "the formula has no finite value here, or none that is proven"),
    (lambda: scallop.formula("t1", "extension").ball(), ArithmeticError, "the formula has no finite value here, or none that is proven"),
    (lambda: scallop.formula("T").ball(0), ValueError, "digits = 0: a whole number from 1 to 1000"),
    (lambda: scallop.formula("T").ball(T=0), ValueError, "T = 0: a finite number > 0"),
):
    try:
        bad("no error:", wanted, call())
    except kind as error:
        if str(error) != wanted and wanted:
            bad("got:", error, "wanted:", wanted)
core = pathlib.Path(scallop.load()).with_name(core)
scallop.load(core)
try:
    bad("libscallop-core has", scallop.series())
except OSError as error:
    if str(error) != f"{core} has no derived series and no proven digits: {with_series}, built with FLINT, has":
        bad(error)
END
  finish "exact parameters that are bad, and a library without series"
fi

python <<'END'
far, reason = dict(m1=[1, 1e-300], T=[1, 1e200]), "out of range: a scaled quantity overflows or underflows"
for answer in (scallop.steady(**far), scallop.phase("extension", **far)):
    if answer.status.tolist() != ["ok", reason] or answer.solved.tolist() != [True, False]:
        bad(answer)
    if answer.regime[1] != "-" or answer.modes[1] != "-" or not all(math.isnan(each[1]) for each in answer._arrays.values()):
        bad(answer)
try:
    bad(scallop.trajectory(m1=1e-300, T=1e200))
except ArithmeticError as error:
    if str(error) != reason:
        bad(error)
END
finish "what cannot be solved is nan, and its status says why"

python <<'END'
def interrupt(*_):
    raise KeyboardInterrupt
ctypes.memmove = interrupt
try:
    bad(scallop.trajectory())
except KeyboardInterrupt:
    pass
END
finish "an interrupt ends a trajectory"

# ---- finding the library ----
mkdir -p tree/scripts/python tree/build tree/model
cp "$root/model/version.h" tree/model
cp -r "$root"/scripts/python/crawling_scallop "$root"/scripts/python/scallop.py tree/scripts/python
loads() { # FILE, or part of the message
  PYTHONPATH=tree/scripts/python /usr/bin/python3 -c 'import scallop; print(scallop.load())' >said 2>&1
  tail -n 1 said | grep -q -F -e "$1" || note "wanted $1: $(tail -n 1 said)"
}
loads "$library"
cp "$library" libscallop.so.9$abi
cp "$library" libscallop.so
cp "$library" libscallop.so.$abi.9.8
ln -s libscallop.so.$abi.9.8 link.so
echo text >libscallop.so.$abi
cc -shared -o libscallop-core.so.$abi -x c /dev/null
for pair in "libscallop.so.9$abi=libscallop.so.9$abi: version 9$abi of the binary interface: version $abi is wanted" \
  "libscallop.so=the name does not say the version of the binary interface: .so.$abi is wanted" \
  "link.so=$scratch/link.so" "libscallop.so.$abi=cannot load the library of crawling_scallop: $scratch/libscallop.so.$abi: " \
  "libscallop-core.so.$abi=has no scallop_status_text: it is older than this package, or another library" \
  "none.so.$abi=cannot load the library of crawling_scallop: $scratch/none.so.$abi: cannot open"; do
  SCALLOP_LIBRARY=${pair%%=*} loads "${pair#*=}"
done
unset SCALLOP_LIBRARY
mv libscallop.so.$abi.9.8 libscallop.so.$abi
loads "neither libscallop.so.$abi nor libscallop-core.so.$abi is in $scratch/tree/build"
LD_LIBRARY_PATH=$scratch loads libscallop.so.$abi
cp "$library" tree/build/libscallop-core.so.$abi
LD_LIBRARY_PATH=$scratch loads "$scratch/tree/build/libscallop-core.so.$abi"
export SCALLOP_LIBRARY="$library"
loads "$library"
python "$scratch/tree/build/libscallop-core.so.$abi" <<'END'
if scallop.load(sys.argv[1]) != sys.argv[1] or scallop.steady().v_start != 3.0166206576889527:
    bad("the argument does not come first")
END
finish "the library is found, in order, and refused when it is another one"

# ---- order ----
printf '0.1 0.011\n0.05 0.0026\n0.025 6.3e-4\n0.0125 1.57e-4\n' >textbook.txt
printf '0.1 0.011\n0.05 0.0026\n0.05 nan\n0.0125 1.57e-4\n' >invalid.txt
printf 'h value\n1 4.25\n0.5 3.5\n0.25 3.3125\n0.125 3.265625\n0.0625 3.25390625\n' >values.txt
: >orders.json
for table in textbook invalid values; do
  "$tool" order $table.txt --expect 2 --format json 2>err | head -n 1 >>orders.json
done
"$tool" order textbook.txt --at-least 3 --tol 0.2 --format json | head -n 1 >>orders.json
"$tool" order textbook.txt --format json | head -n 1 >>orders.json
python <<'END'
import json
import math
def numbers(name):
    rows = [line.split() for line in open(name) if line[0] != "h"]
    return [float(row[0]) for row in rows], [float(row[1]) for row in rows]
found = [scallop.order(*numbers("textbook.txt"), expect=2), scallop.order(*numbers("invalid.txt"), expect=2),
         scallop.order(*numbers("values.txt"), expect=2, values=True),
         scallop.order(*numbers("textbook.txt"), at_least=3, tol=0.2), scallop.order(*numbers("textbook.txt"))]
for order, line in zip(found, open("orders.json")):
    row = json.loads(line)
    for name in ("verdict", "interval", "reason"):
        if row[name] != getattr(order, name):
            bad(name, getattr(order, name), row)
    for name in ("order", "order_low", "order_high", "gci", "asymptotic_ratio"):
        number, wanted = getattr(order, name), row.get(name)
        if not (math.isnan(number) if wanted is None else abs(number - wanted) < 1e-4):
            bad(name, number, row)
    if order.passed != (row["verdict"] == "pass") or order.used != row["points"]:
        bad(order, row)
if [order.passed for order in found] != [True, False, True, False, False]:
    bad(found)
if scallop.order([0.5, 1, 0.25], [0.25, 0, 0.0625]).uses != ["used", "zero", "used"]:
    bad("uses in another order")
for wrong in (dict(expect=2, at_least=2), dict(tol=0), dict(tol=math.nan)):
    try:
        bad(scallop.order([1, 2, 3], [1, 2, 3], **wrong))
    except ValueError:
        pass
try:
    bad(scallop.order([1, 2, 3], [1, 2]))
except ValueError:
    pass
END
finish "order: the verdicts and the words of the command"

# ---- gaits of texts ----
python <<'END'
import gc
texts = [f"skewed:{0.1 + i * 1e-5!r}" for i in range(5000)]
def living():
    return sum(isinstance(each, scallop.Gait) for each in gc.get_objects())
before = living()
one_by_one = [scallop.steady(gait=text).displacement for text in texts]
if living() - before > 64:
    bad(living() - before, "gaits are kept after their calls")
together, again = scallop.steady(gait=texts), scallop.steady(gait=[scallop.gait_of("skewed", float(text[7:])) for text in texts])
if living() - before > 64:
    bad(living() - before, "gaits are kept after a call with all of them")
if not same(one_by_one, again.displacement) or not same(together.displacement, again.displacement):
    bad("gaits of texts are not those of their numbers")
f = scallop.formula("lT*T^2", "extension")
if not same(f(gait=texts[:300]), [f(gait=scallop.gait_of("skewed", float(text[7:]))) for text in texts[:300]]):
    bad("nor are they in a formula")
END
finish "gaits of texts are kept no longer than needed"

# ---- the example ----
run 0 figure 4 --digits 17
cp out figure4.tsv
python "$root/data/figure4.tsv" <<'END'
import figure4
table, exact, committed = figure4.table(), read("figure4.tsv"), read(sys.argv[1])
if not same(table, [[float(row[name]) for name in figure4.COLUMNS] for row in exact]):
    bad("not the numbers of figure 4")
if [["%.12g" % x for x in row] for row in table.tolist()] != [[row[name] for name in figure4.COLUMNS] for row in committed]:
    bad("not the digits of data/figure4.tsv")
END
finish "figure4.py: the numbers of figure 4"

if command -v gnuplot >/dev/null; then
  /usr/bin/python3 "$root/scripts/python/figure4.py" --output python.svg || note "exit code $?"
  gnuplot -e "table = 'figure4.tsv'; output_file = 'table.svg'; kind = 'svg'" \
    "$root/scripts/plots/common.gp" "$root/scripts/plots/figure4.gp"
  cmp python.svg table.svg >said || note "$(cat said)"
  /usr/bin/python3 "$root/scripts/python/figure4.py" --output none/python.svg 2>err
  [ $? = 4 ] || note "no exit code 4 for a folder that is not there"
  finish "figure4.py: the picture of figure 4"
fi
PATH=/nowhere SCALLOP_LIBRARY=$library /usr/bin/python3 "$root/scripts/python/figure4.py" --output kept.svg 2>err
[ $? = 3 ] || note "no exit code 3 without gnuplot"
grep -q 'gnuplot is not installed' err || note "$(tail -n 1 err)"
[ ! -f kept.svg ] || note "a file is there"
finish "figure4.py: without gnuplot"
exit $failed
