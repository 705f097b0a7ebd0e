#!/bin/sh
# What the tables of the command line hold: columns, header lines, numbers that read back, JSON.
# Usage: sh tests/compare/command/cli_tables.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/../../support/common.sh"

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
columns "$parameters name ${steady#"$parameters "}" steady --points points.tsv
columns "$phase" phase
columns "$parameters phase v0 name ${phase#"$parameters phase v0 "}" phase --points points.tsv
columns 't x1 x2 xC v1 v2 l' trajectory
columns 'formula equation phase quantity remainder published exact error' series
columns 'file series y order low high interval points test expected tolerance verdict reason' order square.txt
columns 'kinematics t_over_T x1_over_L x2_over_L xC_over_L l_over_L' figure 2
columns 't_over_T x1_over_L x2_over_L v1_T_over_L v2_T_over_L' figure 3
columns 'F1_over_F2 T dxC_over_L series_dxC_over_L dvC_T_over_L series_dvC_T_over_L onset' figure 4
columns 'panel alpha F2 F1_over_F2 mean_velocity series_mean_velocity v_start regime' figure 5

# ---- a terminal gets what people read, anything else TSV ----
python "$tool" <<'END'
import os, pty, subprocess, threading
def on_terminal(*arguments):
    try:
        master, slave = pty.openpty()
    except OSError:  # a container without /dev/pts
        sys.exit(0)
    run = subprocess.Popen([sys.argv[1], *arguments], stdout=slave, stderr=subprocess.DEVNULL)
    seen, end = b"", b"\0"  # written when the tool has ended: what a terminal still holds when its last writer closes it may be lost
    threading.Thread(target=lambda: (run.wait(), os.write(slave, end))).start()
    while not seen.endswith(end):
        seen += os.read(master, 65536)
    os.close(slave)
    os.close(master)
    if run.wait() != 0:
        bad("exit code", run.returncode, arguments)
    return seen[:-1].decode().replace("\r\n", "\n")
if "\ndisplacement   3.24121 length " not in on_terminal("steady"):
    bad("not upright:", on_terminal("steady"))
if "\ndisplacement   3.2412122 length " not in on_terminal("steady", "--digits", "8"):
    bad("--digits:", on_terminal("steady", "--digits", "8"))
if on_terminal("steady", "--format", "tsv") != subprocess.run([sys.argv[1], "steady"], capture_output=True, text=True).stdout:
    bad("--format tsv is not what a pipe gets")
lines = on_terminal("steady", "--points", "points.tsv").splitlines()
names = [l for l in lines if not l.startswith("#")][0]
if "  v_start" not in names or "length/time" not in lines[lines.index(names) + 1]:
    bad("no names and units:", lines)
END
run 2 steady --pager
grep -q 'less -S' err || note "it is not said what takes the place of --pager: $(cat err)"
finish "a terminal gets an aligned table"

# ---- header lines, and the same bytes ----
all='steady|steady --gait sinusoidal|steady --points points.tsv|phase|phase --phase contraction --v0 2|trajectory --start steady|
trajectory --start 1.5 --periods 2|series|series --points points.tsv|figure 2|figure 3|figure 4|figure 5|claims'
version=$("$tool" --version)
# The other formats have the cells of the TSV table, which is in `first`; aligned ones have 6 digits
other_formats() { # COMMAND...
  for format in csv markdown table; do
    "$tool" "$@" --format $format >$format 2>err || note "$format: exit code $?"
  done
  python first csv markdown table <<'END'
import csv, re
names, *rows = list(csv.reader(open(sys.argv[2], encoding="utf-8")))
table = read(sys.argv[1])
if rows != [list(r.values()) for r in table] or names != list(table[0]):
    bad("csv differs")
lines = [l.rstrip("\n") for l in open(sys.argv[3], encoding="utf-8")]
cells = [re.split(r" (?<!\\)\| ", l[2:-2]) for l in lines]
if cells[1] != ["---"] * len(names) or [[c.replace("\\|", "|") for c in r] for r in cells[2:]] != rows or cells[0] != names:
    bad("markdown differs")
kept = [l.rstrip("\n") for l in open(sys.argv[4], encoding="utf-8") if not l.startswith("#")]
# What is the same in every row stands in the head, to 6 digits
head = " ".join(l[1:].strip() for l in open(sys.argv[4], encoding="utf-8") if l.startswith("#"))
gathered = dict(re.findall(r"(?:: |, )(\S+) = (.*?)(?=, \S+ = | modes: |$)", head[head.index("in every row: ") + 12:] if "in every row" in head else ""))
for name, text in gathered.items():
    for cell in {r[names.index(name)] for r in rows}:
        if cell != text and "%.6g" % float(cell) != text.split(" ")[0]:
            bad("in every row", name, "is", text, "but", cell)
same = [n for n in names if len({r[names.index(n)] for r in rows}) == 1]
if len(rows) > 1 and [n for n in same if n not in gathered]:
    bad("not in the head:", [n for n in same if n not in gathered])
legend = [l for l in kept[1:] if l.startswith("modes: ")] if len(rows) > 1 else []
if len(legend) != (len(rows) > 1 and "modes" in names and "modes" not in gathered) or legend != kept[len(kept) - len(legend):]:
    bad("legend of the modes:", kept)
kept = kept[:len(kept) - len(legend)]
if len(rows) == 1:
    upright = [l for l in kept if not l.startswith(" ")]  # a long text goes on in lines that begin with blanks
    kept = [l for l in upright if l.split()[0] != "motion"]
    if len(upright) - len(kept) != ("regime" in names and "modes" in names):
        bad("no modes in words:", upright)
    kept = [list(c) for c in zip(*(l.split(None, 1) for l in kept))]
    values = [v.split("  ")[0] for v in kept[1]]
    if kept[0] != names or [v for v, w in zip(values, rows[0]) if v.split(" ")[0] != w.split(" ")[0]
                            and "%.6g" % float(w) != v.split(" ")[0]]:
        bad("table:", kept)
elif len(kept) not in (len(rows) + 1, len(rows) + 2) or kept[0].split() != [n for n in names if n not in gathered]:
    bad("table of", len(kept), "lines for", len(rows), "rows")
END
  finish "csv, markdown, table: scallop $arguments"
}
IFS='|'
for arguments in $(printf '%s' "$all" | tr -d '\n'); do
  unset IFS
  # shellcheck disable=SC2086
  set -- $arguments
  run 0 "$@"
  cp out first
  [ "$(sed -n 1p out)" = "# $version" ] || note "line 1: $(sed -n 1p out)"
  case $(sed -n 2p out) in "# command: $1"* | "# command: run $1"*) ;; *) note "line 2: $(sed -n 2p out)" ;; esac
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
  esac
  (cd / && TZ=Asia/Tokyo in_german "$tool" "$@" --quiet) >out 2>err || note "elsewhere: exit code $?"
  cmp -s first out || note "another folder, time zone and locale: differs"
  finish "same bytes: scallop $arguments"
  # JSON: every line an object with the same columns and values as the TSV table
  "$tool" "$@" --format json >json 2>err || note "json: exit code $?"
  python first json "$1" <<'END'
def constant(text):
    raise ValueError(text + " is not JSON")
objects = [json.loads(l, parse_constant=constant) for l in open(sys.argv[2], encoding="utf-8")]
table = read(sys.argv[1])
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
  [ "$1" = claims ] || other_formats "$@" # seconds each
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
[ "$(cells out m1 m2 F1 F2 L T alpha gait froude v_start)" = '1 1 4 1 10 1 0.75 quadratic 4 3.0166206576889527' ] \
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
rows three | cut -f 1-8,10- >together
cmp -s singly together || note "one by one gives something else"
finish "points: in order, but for other columns the same as one by one"
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

exit $failed
