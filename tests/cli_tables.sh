#!/bin/sh
# What the tables of the command line hold: columns, header lines, numbers that read back, JSON, verdicts.
# Usage: sh tests/cli_tables.sh build/scallop. One line for each check; non-zero if any failed.
set -u
tool=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
cd "$scratch" || exit 1
failed=0 problem=''

note() { problem="$problem$*; "; }
finish() { # NAME: of the checks since the last one
  if [ -z "$problem" ]; then
    echo "ok $1"
  else
    echo "FAIL $1: $problem"
    failed=1
  fi
  problem=''
}
run() { # CODE ARGUMENT...
  wanted=$1
  shift
  "$tool" "$@" </dev/null >out 2>err
  code=$?
  [ "$code" = "$wanted" ] || note "scallop $* gives exit code $code, not $wanted: $(head -n 2 err)"
}
header() { sed '/^#/d; q' "$1" | tr '\t' ' '; }
rows() { sed '/^#/d' "$1" | sed 1d; }
cells() { # FILE COLUMN...: those columns of every row, separated by blanks
  file=$1
  shift
  sed '/^#/d' "$file" | awk -F '\t' -v names="$*" '
    NR == 1 { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i; next }
    { for (i = 1; i <= n; i++) printf "%s%s", $(at[name[i]]), i < n ? " " : "\n" }'
}
# The Python below has this in front. bad(text) notes a problem; it is printed and shown by python().
cat >tables.py <<'END'
import json, math, sys
def read(name):
    lines = [l.rstrip("\n").split("\t") for l in open(name, encoding="utf-8") if not l.startswith("#")]
    return [dict(zip(lines[0], l)) for l in lines[1:]]
def number(row, *names):
    values = [float(row[n]) for n in names]
    return values[0] if len(values) == 1 else values
def near(a, b, tolerance):
    return abs(a - b) <= tolerance * max(abs(a), abs(b))
def bad(*text):
    print(*text)
    sys.exit()
END
python() { # reads the program from standard input; its arguments follow
  cat tables.py - >program.py
  /usr/bin/python3 program.py "$@" >said 2>&1 || note "python: $(tail -n 1 said)"
  [ ! -s said ] || note "$(head -n 3 said)"
}

parameters='m1 m2 F1 F2 L T alpha gait'
square='1 1\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n'
printf '%b' "$square" >square.txt
printf 'name\tT\talpha\tgait\tF1\na\t0.5\t0.6\tquadratic\t2\nb\t2\t0.7\tsinusoidal\t3\nc\t0.01\t0.3\tquadratic\t8\n' >points.tsv

# ---- columns ----
columns() { # EXPECTED COMMAND...
  expected=$1
  shift
  run 0 "$@"
  [ "$(header out)" = "$expected" ] || note "columns: $(header out)"
  sed '/^#/d' out | awk -F '\t' 'NR == 1 { n = NF } NF != n { print "line " NR ": " NF " columns, not " n }' >uneven
  [ ! -s uneven ] || note "$(head -n 3 uneven)"
  finish "columns of $*"
}
steady="$parameters froude v_start v_mid displacement mean_velocity multiplier regime modes status"
phase="$parameters phase v0 t1 dT v_end dx1 dx2 dxC regime modes status"
columns "$steady" steady
columns "$steady" steady --points points.tsv
columns "$phase" phase
columns "$phase" phase --points points.tsv
columns 't x1 x2 xC v1 v2 l' trajectory
columns 'formula equation phase quantity remainder published exact error' series
columns 'h err pairwise use' order square.txt
columns 'kinematics t_over_T x1_over_L x2_over_L xC_over_L l_over_L' figure 2
columns 't_over_T x1_over_L x2_over_L v1_T_over_L v2_T_over_L' figure 3
columns 'F1_over_F2 T dxC_over_L series_dxC_over_L dvC_T_over_L series_dvC_T_over_L' figure 4
columns 'panel alpha F2 F1_over_F2 mean_velocity series_mean_velocity v_start regime' figure 5

# ---- header lines, and the same bytes ----
all='steady|steady --gait sinusoidal|steady --points points.tsv|phase|phase --phase contraction --v0 2|trajectory --start steady|
trajectory --start 1.5 --periods 2|series|series --points points.tsv|order square.txt --expect 2|figure 2|figure 3|figure 4|figure 5|claims'
version=$("$tool" --version)
IFS='|'
for arguments in $(printf '%s' "$all" | tr -d '\n'); do
  unset IFS
  # shellcheck disable=SC2086
  set -- $arguments
  run 0 "$@"
  cp out first
  [ "$(sed -n 1p out)" = "# $version" ] || note "line 1: $(sed -n 1p out)"
  case $(sed -n 2p out) in "# command: $1"*) ;; *) note "line 2: $(sed -n 2p out)" ;; esac
  if grep '^#' out | grep -q -E '(19|20)[0-9][0-9]-[0-9]|[0-9]:[0-9][0-9]|Jan |Feb |Mar |Apr |May |Jun |Jul |Aug |Sep |Oct |Nov |Dec '; then
    note "a date: $(grep '^#' out)"
  fi
  if grep '^#' out | grep -q -F -e "$scratch" -e "$tool" -e /tmp -e points.tsv -e square.txt; then
    note "a path: $(grep '^#' out)"
  fi
  finish "header lines: scallop $arguments"
  run 0 "$@"
  cmp -s first out || note "the second run differs"
  mkdir -p deep/er
  "$tool" "$@" -o deep/er/table.tsv >out 2>err || note "-o: exit code $?"
  [ ! -s out ] || note "-o prints to standard output"
  cmp -s first deep/er/table.tsv || note "-o differs"
  rm -f deep/er/table.tsv
  [ -z "$(ls -A deep/er)" ] || note "left behind: $(ls -A deep/er)"
  case $1 in
    steady | phase | series) case $arguments in *--points*) set -- "$1" --points "$scratch/points.tsv" ;; esac ;;
    order) set -- order "$scratch/square.txt" --expect 2 ;;
  esac
  (cd / && TZ=Asia/Tokyo LC_ALL=de_DE.UTF-8 "$tool" "$@" --quiet) >out 2>err || note "elsewhere: exit code $?"
  cmp -s first out || note "another folder, time zone and locale: differs"
  finish "same bytes: scallop $arguments"
  # JSON: every line an object with the same columns and values as the TSV table
  "$tool" "$@" --format json >json 2>err || note "json: exit code $?"
  python first json "$1" <<'END'
def constant(text):
    raise ValueError(text + " is not JSON")
objects = [json.loads(l, parse_constant=constant) for l in open(sys.argv[2], encoding="utf-8")]
table = read(sys.argv[1])
if sys.argv[3] == "order":
    last = objects.pop()
    if last["verdict"] != "pass" or last["order"] != 2 or last["expected"] != 2:
        bad("summary:", last)
if len(objects) != len(table):
    bad(len(objects), "objects,", len(table), "rows")
for i, (o, r) in enumerate(zip(objects, table)):
    if list(o) != list(r):
        bad("row", i + 1, "keys", list(o))
    for key, value in o.items():
        text = r[key]
        same = text == "nan" if value is None else text == value if isinstance(value, str) else float(text) == value
        if not same:
            bad("row", i + 1, key, "tsv", text, "json", value)
END
  finish "json: scallop $arguments"
  IFS='|'
done
unset IFS

{
  printf 'T\talpha\n'
  printf '%s\t0.5\n' 'say "no"\\' "$(printf '\303\251\303\251')" "$(printf '\377\302')" \
    "1$(awk 'BEGIN { for (i = 0; i < 60; i++) printf "\303\251" }')" "$(printf 'a\033b\177')"
} >odd.tsv
run 3 steady --points odd.tsv --format json
cp out json
python json <<'END'
try:
    lines = open(sys.argv[1], encoding="utf-8").read().splitlines()
    if len([json.loads(l) for l in lines]) != 5:
        bad(len(lines), "lines")
except ValueError as e:
    bad(e)
END
finish "json: valid whatever the cells hold"

# ---- numbers ----
run 0 steady
[ "$(cells out m1 m2 F1 F2 L T alpha gait froude v_start)" = '1 1 4 1 10 1 0.75 quadratic 4 3.016620657688953' ] \
  || note "$(rows out)"
[ "$(cells out regime status)" = 'sliding ok' ] || note "$(rows out)"
[ "$(rows out | cut -f 16)" = '++ -+ ++ | ++ +- ++' ] || note "modes: $(rows out)"
finish "the default point"
run 0 steady --points points.tsv
[ "$(cells out T alpha gait F1 | tr '\n' ';')" = '0.5 0.6 quadratic 2;2 0.7 sinusoidal 3;0.01 0.3 quadratic 8;' ] || note "$(rows out)"
cp out three
sed 1d points.tsv | while IFS='	' read -r _ T alpha gait F1; do
  "$tool" steady --T "$T" --alpha "$alpha" --gait "$gait" --F1 "$F1" | sed '/^#/d' | sed 1d
done >singly
rows three >together
cmp -s singly together || note "one by one gives something else"
finish "points: in order, other columns ignored, the same as one by one"
run 0 steady --points points.tsv --m1 3 --T 9
[ "$(cells out m1 T | tr '\n' ';')" = '3 0.5;3 2;3 0.01;' ] || note "$(cells out m1 T)"
finish "points: options fill what the file does not name"
run 0 steady --points points.tsv --digits 3
cp out short
python three short <<'END'
for full, short in zip(read(sys.argv[1]), read(sys.argv[2])):
    for key, text in full.items():
        try:
            text = "%.3g" % float(text)
        except ValueError:
            pass
        if short[key] != text:
            bad(key, short[key], "is not", text)
END
finish "--digits rounds"

python <<'END'
import random
random.seed(1303)
def spread(low, high):
    return math.exp(random.uniform(math.log(low), math.log(high)))
with open("random.tsv", "w") as f:
    print("m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", "v0", "phase", sep="\t", file=f)
    for i in range(1000):
        print(*(repr(spread(1e-2, 1e2)) for _ in range(5)), repr(spread(1e-4, 1e1)), repr(random.uniform(0.02, 0.98)),
              random.choice(["quadratic", "sinusoidal"]), repr(random.gauss(0, 10)),
              random.choice(["extension", "contraction"]), sep="\t", file=f)
END
run 0 steady --points random.tsv
cp out steady.tsv
python <<'END'
import re
points, table = read("random.tsv"), read("steady.tsv")
mode = "[-+0]{2}( [-+0]{2})*"
if len(table) != 1000:
    bad(len(table), "rows")
for i, (p, r) in enumerate(zip(points, table)):
    row = "row %d:" % (i + 1)
    for name in "m1 m2 F1 F2 L T alpha".split():
        if float(p[name]) != float(r[name]):
            bad(row, name, p[name], "became", r[name])
    if p["gait"] != r["gait"]:
        bad(row, "gait", r["gait"])
    if r["status"] != "ok" and not r["status"].startswith("interval of steady states: v_start from "):
        bad(row, r["status"])
    m1, m2, F1, F2, L, T, froude, u, v, d, mean, k = number(
        r, *"m1 m2 F1 F2 L T froude v_start v_mid displacement mean_velocity multiplier".split())
    if not near(froude, (m1 + m2) * L / (T * T * (F1 + F2)), 1e-14):
        bad(row, "froude", froude)
    if not near(mean, d / T, 1e-14):
        bad(row, "mean_velocity", mean)
    if not (0 <= k <= 1 and math.isfinite(u) and math.isfinite(v) and math.isfinite(d)):
        bad(row, r)
    if r["regime"] not in ("sliding", "stick-slip", "at-rest") or not re.fullmatch(mode + r" \| " + mode, r["modes"]):
        bad(row, r["regime"], r["modes"])
    if (r["regime"] == "sliding") != ("0" not in r["modes"]):
        bad(row, r["regime"], "with the modes", r["modes"])
    if r["regime"] == "at-rest" and (u, v, d) != (0, 0, 0):
        bad(row, "at rest and", u, v, d)
END
finish "steady: 1000 random points"
run 0 steady --points steady.tsv
cmp -s out steady.tsv || note "the printed parameters give another table"
finish "steady: what is printed reads back, 1000 points"
run 0 phase --points random.tsv
cp out phase.tsv
run 0 phase --points phase.tsv
cmp -s out phase.tsv || note "the printed parameters give another table"
python <<'END'
points, table = read("random.tsv"), read("phase.tsv")
for i, (p, r) in enumerate(zip(points, table)):
    row = "row %d:" % (i + 1)
    if float(p["v0"]) != float(r["v0"]) or p["phase"] != r["phase"] or r["status"] != "ok":
        bad(row, r)
    L, T, alpha, t1, dT, x1, x2, xC = number(r, *"L T alpha t1 dT dx1 dx2 dxC".split())
    tau = T * (alpha if r["phase"] == "extension" else 1 - alpha)
    grown = L if r["phase"] == "extension" else -L
    scale = max(L, abs(x1), abs(x2))
    if abs(x2 - x1 - grown) > 1e-13 * scale or abs(xC - (x1 + x2) / 2) > 1e-13 * scale:
        bad(row, "displacements", x1, x2, xC)
    if math.isnan(t1) != math.isnan(dT) or math.isnan(t1) != (" " not in r["modes"]):
        bad(row, "t1", t1, "dT", dT, "with the modes", r["modes"])
    if not math.isnan(t1) and not (0 <= t1 and 0 <= dT and t1 + dT <= tau * (1 + 1e-14)):
        bad(row, "t1", t1, "dT", dT, "in a phase of", tau)
END
finish "phase: 1000 random points, and they read back"
printf 'v0\tphase\n%s\textension\n' "$("$tool" steady | sed '/^#/d' | sed 1d | cut -f 10)" >start.tsv
run 0 phase --points start.tsv
v_mid=$(cells out v_end)
run 0 phase --phase contraction --v0 "$v_mid"
python "$(cells out v_end)" "$(sed -n 2p start.tsv | cut -f 1)" <<'END'
if not near(float(sys.argv[1]), float(sys.argv[2]), 1e-14):
    bad("from", sys.argv[2], "the two phases lead to", sys.argv[1])
END
finish "phase after phase closes the steady period"

# ---- trajectory ----
for gait in quadratic sinusoidal; do
  run 0 steady --gait $gait --T 2 --alpha 0.6
  cp out steady.tsv
  run 0 trajectory --gait $gait --T 2 --alpha 0.6 --start steady --periods 3 --samples 8
  cp out trajectory.tsv
  python <<'END'
s, t = read("steady.tsv")[0], read("trajectory.tsv")
v, d, L = number(s, "v_start", "displacement", "L")
if len(t) != 25 or number(t[0], "t", "x1", "x2", "xC", "l") != [0] * 5 or number(t[-1], "t") != 6:
    bad(len(t), "rows, from", t[0], "to", t[-1])
for k in (0, 8, 16, 24):
    r = t[k]
    if not (near(float(r["v1"]), v, 1e-13) and near(float(r["v2"]), v, 1e-13) and abs(float(r["l"])) <= 1e-13 * L):
        bad("after", k // 8, "periods:", r, "instead of v =", v)
    if abs(float(r["xC"]) - k // 8 * d) > 1e-12 * L:
        bad("after", k // 8, "periods:", r, "instead of xC =", k // 8 * d)
for r in t:
    x1, x2, xC, l = number(r, "x1", "x2", "xC", "l")
    if abs(x2 - x1 - l) > 1e-13 * L or abs(xC - (x1 + x2) / 2) > 1e-13 * L or not -1e-13 * L <= l <= L * (1 + 1e-13):
        bad("x2 - x1 is not l:", r)
END
  finish "trajectory: --start steady comes back, $gait"
done
run 0 trajectory --periods 4 --samples 5 --T 0.5
cp out rest
run 0 trajectory --periods 4 --samples 5 --T 0.5 --start 0
rows rest >a
rows out >b
cmp -s a b || note "--start 0 is not --start rest"
[ "$(wc -l <a)" -eq 21 ] || note "$(wc -l <a) rows"
[ "$(tail -n 1 a | cut -f 1)" = 2 ] || note "the last row is at $(tail -n 1 a | cut -f 1), not 2"
[ "$(head -n 1 a)" = "$(printf '0\t0\t0\t0\t0\t0\t0')" ] || note "the first row: $(head -n 1 a)"
finish "trajectory: from rest to the end of the last period"
run 0 trajectory --periods 300 --samples 1
cp out trajectory.tsv
python "$("$tool" steady | sed '/^#/d' | sed 1d | cut -f 10)" <<'END'
end = number(read("trajectory.tsv")[-1], "v1")
if not near(end, float(sys.argv[1]), 1e-12):
    bad("after 300 periods v =", end, "instead of", sys.argv[1])
END
finish "trajectory: from rest it tends to the steady state"

# ---- series ----
run 0 steady --T 1e-3
cp out steady.tsv
run 0 series --T 1e-3
cp out series.tsv
run 0 series --points points.tsv
cp out many.tsv
run 0 series --T 2 --alpha 0.7 --gait sinusoidal --F1 3
cp out second.tsv
python <<'END'
s, t = read("steady.tsv")[0], read("series.tsv")
if len(t) < 40:
    bad(len(t), "rows")
for r in t + read("second.tsv"):
    published, exact, error = number(r, "published", "exact", "error")
    if published - exact != error and not (math.isnan(error) and (math.isnan(exact) or math.isnan(published))):
        bad(r["formula"], "error", error, "is not", published - exact)
by = {(r["formula"], r["phase"]): r for r in t}
for formula, column in (("text_steady_velocity", "v_start"), ("text_steady_xC", "displacement")):
    r = by[formula, "period"]
    if r["exact"] != s[column]:
        bad(formula, "exact", r["exact"], "steady has", s[column])
    if not near(number(r, "published"), number(r, "exact"), 1e-5):
        bad(r)
for formula in ("rest_dT", "rest_x1_end", "rest_xC_end", "A_t1", "A_dT"):
    r = by[formula, "extension"]
    if not near(number(r, "published"), number(r, "exact"), 1e-3):
        bad(r)
END
finish "series: error = published - exact, small at T = 0.001"
python <<'END'
many, second = read("many.tsv"), read("second.tsv")
for r in second:
    name = r["formula"]
    column = name + ":contraction" if name.startswith("rest_") and r["phase"] == "contraction" else name
    if many[1][column] != r["published"]:
        bad(column, many[1][column], "with --points,", r["published"], "without")
if [r["status"] for r in many] != ["ok"] * 3:
    bad([r["status"] for r in many])
END
finish "series: --points gives the published values of the one point"

# ---- order ----
verdict() { # NAME VERDICT EXPECTED: of table.txt
  code=1
  [ "$2" != pass ] || code=0
  run $code order table.txt --expect "$3"
  [ "$(tail -n 1 out)" = "# expected $3 within 0.1: $2" ] || note "$(tail -n 2 out)"
  cp out table.out
  run $code order table.txt --expect "$3" --format json
  tail -n 1 out | grep -q -F "\"verdict\": \"$2\"" || note "json: $(tail -n 1 out)"
  finish "order: $1: $2"
}
used() { rows table.out | awk -F '\t' -v use="$1" '$4 == use { n++ } END { print n + 0 }'; }
table() { printf '%b' "$1" >table.txt; }
table "$square"
verdict "h^2" pass 2
verdict "h^2 where 3 is expected" too-low 3
verdict "h^2 where 1 is expected" too-high 1
run 0 order table.txt --expect 2.25 --tol 0.3
run 1 order table.txt --expect 2.25 --tol 0.2
run 0 order table.txt
grep -q 'expected' out && note "a verdict without --expect: $(tail -n 1 out)"
finish "order: --tol, and no verdict without --expect"
table "h err\n$square"
verdict "a header" pass 2
table "err what h\n1 a 1\n0.25 b 0.5\n0.0625 c 0.25\n0.015625 d 0.125\n"
verdict "columns in another order, one more" pass 2
table '0.25 0.0625\n1 1\n0.125 0.015625\n0.5 0.25\n'
verdict "unsorted" pass 2
[ "$(cells table.out h | tr '\n' ' ')" = '1 0.5 0.25 0.125 ' ] || note "not sorted: $(cells table.out h)"
finish "order: rows by falling h"
table '1 -1\n0.5 -0.25\n0.25 -0.0625\n0.125 -0.015625\n'
verdict "negative errors" pass 2
awk 'BEGIN { n = split("1 0.7 0.3 0.2 0.11 0.05 0.013 0.01", h, " "); for (i = 1; i <= n; i++) printf "%s %.17g\n", h[i], 3 * h[i] ^ 1.5 }' >table.txt
verdict "unequal refinement" pass 1.5
awk 'BEGIN { for (h = 1; h > 1e-5; h /= 2) printf "%.17g %.17g\n", h, h * h + h ^ 3 }' >table.txt
verdict "h^2 + h^3" pass 2
[ "$(used coarse)" -ge 1 ] || note "nothing is coarse"
finish "order: coarse points are left out"
awk 'BEGIN { for (i = 0; i < 9; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, i < 3 ? h : 4 * h * h } }' >table.txt
verdict "an early kink" pass 2
awk 'BEGIN { for (i = 0; i < 24; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, h * h + 1e-10 * (1 + i % 2) } }' >table.txt
verdict "a floor far down" pass 2
[ "$(used floor)" -ge 5 ] || note "only $(used floor) rows at the floor"
finish "order: rows at the floor are left out"
table '1 1\n0.5 0.25\n0.25 1.1e-16\n0.125 0.9e-16\n0.06 1e-16\n0.03 1.2e-16\n'
verdict "a floor high up" floor-limited 2
table 'h err noise\n1 1e-16 1e-16\n0.5 2e-16 1e-16\n0.25 1e-16 1e-16\n0.125 0 1e-16\n'
verdict "nothing above its noise" floor-limited 2
table '1 0\n0.5 0\n0.25 0\n0.125 0\n'
verdict "zeros" floor-limited 2
table '1 0\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n0.0625 0.00390625\n'
verdict "a zero among others" pass 2
[ "$(used zero)" -eq 1 ] || note "$(used zero) zeros"
finish "order: a zero is left out"
table '1 -0.3\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n0.0625 0.00390625\n'
verdict "a change of sign" pass 2
[ "$(used before-sign-change)" -eq 1 ] || note "$(used before-sign-change) before a change of sign"
finish "order: what is before a change of sign is left out"
table '1 1\n0.5 2\n0.25 4\n0.125 8\n'
verdict "growing errors" too-low 2
table '1 1\n0.5 1\n0.25 1\n0.125 1\n'
verdict "errors that do not fall" too-low 2
table '1 1\n0.5 0.9\n0.25 0.1\n0.125 0.09\n0.0625 0.001\n'
verdict "jagged errors" not-asymptotic 2
table '1 1\n0.5 0.25\n'
verdict "two points" insufficient 2
table '1 1\n'
verdict "one point" insufficient 2
for point in '0.5 nan' '0.5 inf' 'nan 1' 'inf 1' '0 1' '-0.5 1' '1 1'; do
  table "1 1\n$point\n0.25 0.0625\n0.125 0.015625\n0.0625 0.00390625\n"
  verdict "a point '$point'" invalid 2
done
awk 'BEGIN { print "h value"; for (i = 0; i < 7; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, 3 + h * h } }' >table.txt
verdict "values, by Richardson" pass 2
[ "$(rows table.out | wc -l)" -eq 6 ] || note "$(rows table.out | wc -l) differences of 7 values"
[ "$(cells table.out err | head -n 1)" = 1 ] || note "the first error: $(cells table.out err | head -n 1)"
finish "order: 7 values give 6 errors"
awk 'BEGIN { print "h value"; n = split("1 0.7 0.4 0.3 0.2 0.15 0.1 0.06", h, " "); for (i = 1; i <= n; i++) printf "%s %.17g\n", h[i], 3 - h[i] ^ 3 }' >table.txt
verdict "values at unequal refinement" pass 3
table 'h value\n1 2\n0.5 1.25\n'
verdict "two values" insufficient 2
table 'h value\n1 2\n1 1.25\n0.5 1.1\n0.25 1\n'
verdict "values at a repeated h" invalid 2
awk 'BEGIN { print "h value"; for (i = 0; i < 7; i++) { h = 2 ^ -i; printf "%.17g %.17g\n", h, 3 + h } }' >table.txt
verdict "values of order 1 where 2 is expected" too-low 2

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
python <<'END'
seen = {}
for i, r in enumerate(read("claims.tsv")):
    key = tuple(r[c] for c in ("claim", "equation", "quantity", "gait", "conditions"))
    if key in seen:
        bad("rows", seen[key] + 1, "and", i + 1, "test the same:", *key)
    seen[key] = i
END
finish "claims: no two rows say that they test the same"
for place in inside outside; do
  yes=yes
  [ $place = inside ] || yes=no
  counts=$(cells claims.tsv inside verdict | awk -v i=$yes '$1 == i { n[$2]++ }
    END { printf "%d hold, %d are sharper than claimed, %d refuted, %d undecided", n["holds"], n["sharper"], n["refuted"], n["undecided"] }')
  grep "^$place " summary | grep -q -F "$counts" || note "$place: $counts, but: $(cat summary)"
done
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
if len(at) != 1 or at[0]["v_start"] != "3.016620657688953":
    bad("the default point:", at)
END
finish "figure 5: signs, maxima, and the default point"
exit $failed
