#!/bin/sh
# scallop summary and the page of scallop breakdown: what they say is what steady, claims and breakdown say.
# Usage: sh tests/compare/command/cli_summary.sh build/scallop. One line for each check; non-zero if any failed.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

printf '0 0\n1 2\n3 3\n4 1\n6 0\n' | sed '1i t l' >gait.txt
agrees() { # ARGUMENTS...
  run 0 summary "$@" --format json
  mv out summary.json
  python "$tool" "$@" <<'END'
import json, subprocess
tool, arguments = sys.argv[1], sys.argv[2:]
without_T = [a for i, a in enumerate(arguments) if "--T" not in (a, arguments[i - 1] if i else "")]
def rows(*command):
    of = without_T if command[0] == "breakdown" else arguments
    text = subprocess.run([tool, *command, *of], capture_output=True, text=True).stdout
    lines = [l.split("\t") for l in text.splitlines() if not l.startswith("#")]
    return [dict(zip(lines[0], l)) for l in lines[1:]] if lines else []
def same(name, mine, other):
    other = float(other)
    if mine != other and not (mine is None and other != other) and not (other != other and mine != mine):
        bad(name, mine, other)
s = json.load(open("summary.json"))
steady = rows("steady")[0]
for name in ("froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier"):
    same(name, s[name], steady[name])
if (s["regime"], s["modes"], s["status"]) != (steady["regime"], steady["modes"], steady["status"]):
    bad("regime, modes or status")
if len(s["motion"].split(" | ")[0].split("; ")) < len(steady["modes"].split(" | ")[0].split()):
    bad("fewer stretches than modes:", s["motion"])
events = [r for r in rows("breakdown", "--only", "event") if r["T"] != "0"]
same("first_event_T", s["first_event_T"], events[0]["T"] if events else "nan")
if s["first_event"] != (events[0]["note"] if events else "-"):
    bad("first event", s["first_event"])
reversals = [r["T"] for r in rows("breakdown", "--only", "reversal")]
if s["reversals"] != (" ".join(reversals) or "-"):
    bad("reversals", s["reversals"], reversals)
for T in map(float, reversals):  # the crawler turns back there, and nowhere beside it
    other = [a for i, a in enumerate(arguments) if "--T" not in (a, arguments[i - 1] if i else "")]
    text = subprocess.run([tool, "steady", *other, "--T", f"{T * 0.999!r},{T * 1.001!r}"], capture_output=True, text=True).stdout
    table = [l.split("\t") for l in text.splitlines() if not l.startswith("#")]
    way = [float(l[table[0].index("displacement")]) for l in table[1:]]
    if not way[0] * way[1] < 0:
        bad("no reversal at", T, way)
formulas = [k[:-6] for k in s if k.endswith("_error") and k != "best_error"]
if "text_steady_xC" not in formulas:
    bad("no (28)", formulas)
for percent, tolerance in ((1, "0.01"), (5, "0.05")):
    reaches = {(r["series"], r["quantity"]): r["T"] for r in rows("breakdown", "--only", "reach", "--tol", tolerance)}
    for f in formulas:
        quantity = "displacement" if "xC" in f else "v_start"
        if (f, quantity) in reaches:
            same(f"{f}_reach_{percent}", s[f"{f}_reach_{percent}"], reaches[f, quantity])
for f in formulas:  # the published table, and the same formula as one of one's own
    published = [r for r in rows("series") if r["formula"] == f]
    limits = [float(r["error"]) for r in rows("breakdown", "--only", "reach", "--tol", "1e-6") if r["series"] == f and r["T"] == "0"]
    if (s[f"{f}_limit"] is None) == bool(limits) or (limits and abs(s[f"{f}_limit"] - limits[0]) > 1e-3 * limits[0]):
        bad(f, s[f"{f}_limit"], limits)
    if published and s[f] is not None:
        value, exact = float(published[0]["published"]), float(published[0]["exact"])
        if abs(s[f] - value) > 4e-16 * abs(value):
            bad(f, s[f], value)
        if s[f"{f}_error"] is not None and exact != 0 and abs(s[f"{f}_error"] - (value / exact - 1)) > 1e-14 * abs(value / exact):
            bad(f, s[f"{f}_error"], value / exact - 1)
END
  finish "summary $*: the numbers of steady, series and breakdown"
}
agrees
agrees --gait sinusoidal --F1 1.5 --T 4
agrees --alpha 0.3
agrees --alpha 0.6 --T 5
agrees --T 8
agrees --T 20
agrees --gait constant:0
agrees --gait measured:gait.txt

verdicts() { # ARGUMENTS...: those of claims --book for the same crawler
  for name in text_steady_velocity_l0_lT text_steady_velocity text_steady_xC; do
    "$tool" summary "$@" --format tsv --columns "${name}_verdict,${name}_order" >mine 2>err
    "$tool" claims --book "$root/asymptotics/published/paper.cfg" --m1 1 "$@" --quiet --columns claim,verdict,derived_order >all 2>>err
    theirs=$(sed -n "s/^$name	//p" all | sed 's/none$/inf/')
    [ "$(tail -n 1 mine)" = "$theirs" ] || note "$name: $(tail -n 1 mine) is not $theirs"
  done
  finish "the verdicts of claims $*"
}
verdicts --gait quadratic
verdicts --gait sinusoidal
verdicts --gait quadratic --alpha 0.3
verdicts --gait trapezoidal:0.2,0.3

# By mpmath: the root of the equation that series --source limit prints, with 40 digits
run 0 summary --gait sinusoidal --format tsv --columns text_steady_velocity_limit
awk 'END { exit !($1 - 0.0241823189774923608 < 2e-15 && 0.0241823189774923608 - $1 < 2e-15) }' out || note "$(tail -n 1 out)"
finish "the limit of the relative error, to all digits"

# ---- modes in words, in steady and phase ----
words() { # COMMAND ARGUMENTS...: the column in each format, and not where nothing asks for it
  run 0 "$@"
  ! grep -q motion out || note "a column of modes in words that nothing asked for"
  run 0 "$@" --columns motion
  mv out words
  run 0 "$@" --format table
  sed -n '/^motion /,/^status /s/^[a-z]* *//p' out | sed '$d' | tr '\n' ' ' | sed 's/ $//' >upright
  [ "$(tail -n 1 words)" = "$(cat upright)" ] || note "upright: $(cat upright), else: $(tail -n 1 words)"
  finish "$*: the modes in words"
}
words steady
words steady --gait sinusoidal --T 3 --alpha 0.4
words steady --T 20
words steady --certified
words phase --phase contraction --v0 1
run 0 steady --gait sinusoidal --T 3 --F1 2 --columns motion
tail -n 1 out >words
run 0 summary --gait sinusoidal --T 3 --F1 2 --format tsv --columns motion
[ "$(tail -n 1 out)" = "$(cat words)" ] || note "summary: $(tail -n 1 out), steady: $(cat words)"
run 0 steady --F1 1,2 --format table
[ "$(grep -c '^modes: .*+ forward, - backward, 0 stuck' out)" -eq 1 ] || note "no legend"
! grep -q 'both bodies' out || note "words in a table of many rows"
run 0 phase --format table
grep -q 'modes .*+ forward, - backward, 0 stuck$' out || note "phase: $(grep modes out)"
run 0 trajectory --format table
! grep -q 'forward, - backward' out || note "a legend without modes"
printf 'T\n-1\n1\n' >refused.tsv
run 3 steady --points refused.tsv --columns motion
[ "$(sed -n 4p out)" = - ] || note "refused: $(sed -n 4p out)"
finish "modes in words agree, and symbols have a legend"

# ---- the page ----
says() { # TEXT...: the page holds each
  for text in "$@"; do
    grep -qF -- "$text" out || note "it does not say: $text"
  done
}
run 0 summary
says 'It crawls forward (towards body 2), by 3.24121' 'body 1 backward, body 2 forward from 0.0792689 to 0.646789' \
  '(28) displacement = 3.24324, exact 3.24121, 0.0627 % off' 'proven: the error is O(T^4), as claimed' \
  'by 1 % at T = 1.98596 (Froude 1.01)' 'T = 2.78894 (Froude 0.514): start velocity changes sign' 'T = 1 is below the first event'
[ "$(awk 'length > 130' out | wc -l)" -eq 0 ] || note "long lines"
finish "the page of the default crawler"
run 0 summary --gait sinusoidal
says 'refuted: O(T^4) is claimed, but the relative error tends to 2.42 % as T -> 0'
run 0 summary --gait sinusoidal --F1 1.5
says 'the relative error tends to 0.415 % as T -> 0' 'off by 1 % at T = 2.27257' '(26), (27) v_start = 1.70166, exact 1.65678, 2.71 % off'
[ "$(grep -c '^  (2[678])' out)" -eq 2 ] || note "(26) and (27), which are the same, are not on one line"
run 0 summary --alpha 0.6 --T 4.6
says '(28) displacement = 1.875, exact -0.338202, wrong sign' 'The direction of crawling reverses at T = 4.35979, T = 5.38074.' \
  'body 1 stops in the extension during piece 1 of the gait, no longer during piece 2'
! grep -q 'of itself [[]' out || note "errors in other units than percent"
run 0 summary --alpha 0.3
says 'It crawls backward (towards body 1), by 2.925 in each period'
run 0 summary --T 4
says 'Started with a velocity near this one, it moves like this from the next period on.'
run 0 trajectory --T 4 --start 100 --periods 4 --samples 1 # and not with any: 10 less in each period
[ "$(cells out v1 | tail -n 1 | cut -c 1-5)" = 59.99 ] || note "after four periods from 100: $(cells out v1 | tail -n 1)"
run 0 summary --gait constant:0 --m1 1.8 --m2 0.105 --F1 0.006 --F2 0.15 --L 1.6 --alpha 0.52 --T 1.4
says 'one of many steady motions: interval of steady states: v_start from -2.0216335727264862 to -0.1312335958005'
! grep -q 'shrinks' out || note "a deviation shrinks where there are many steady motions"
run 0 summary --T 20
says 'one body never moves' 'exact 0 [' 'from there on the series does not describe the motion'
run 0 summary --gait constant:0
says 'it divides by l'"''"', which is 0 at an end of a phase' 'There is no derived series'
run 0 summary --F1 1
says 'is where it was after each period' 'proven: it is exact'
finish "pages of other crawlers"
printf 'T\n0.5\n-1\n2\n' >points.tsv
run 3 summary --points points.tsv
[ "$(grep -c '^What it does' out)" -eq 2 ] || note "not two pages"
says "This crawler has no page: line 3: T: '-1'"
run 3 summary --points points.tsv --format tsv
[ "$(grep -vc '^#' out)" -eq 4 ] || note "not three rows"
finish "a page or a row for each point"
run 0 breakdown
[ "$(grep -vc "^#" out)" -le 25 ] || note "more than 25 lines"
says 'T = 2.78894' '(28) text_steady_xC, displacement' 'off by 1 % at T = 1.98596'
run 0 breakdown --gait sinusoidal --m1 3 --alpha 0.6
[ "$(grep -vc "^#" out)" -le 25 ] || note "more than 25 lines"
run 4 breakdown -o no/such/folder
run 4 summary -o no/such/folder
run 2 breakdown --all --map F1/F2 alpha
finish "breakdown without more is a page"
exit $failed
