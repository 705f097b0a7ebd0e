#!/bin/sh
# --gait: gaits with parameters and measured ones, on every command that takes one.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. tests/support/common.sh

refuse() { # CODE PATTERN ARGUMENT...: nothing on standard output, and this on standard error
  code_wanted=$1 pattern=$2
  shift 2
  run "$code_wanted" "$@"
  [ ! -s out ] || note "scallop $* prints a table"
  grep -q -e "$pattern" err || note "scallop $*: not '$pattern' but: $(head -n 1 err)"
}

# ---- names are printed so that they read back ----
for gait in quadratic trapezoidal trapezoidal:0.2,0.3 trapezoidal:0.2,0.3,0.1,0.9 constant:0.1 constant:0 constant:0,0.2 skewed:0.3 skewed:0.7,0.2 minimum-jerk polynomial:0,3,-2; do
  run 0 steady --gait "$gait"
  [ "$(cells out gait status)" = "$gait ok" ] || note "$gait: $(cells out gait status)"
  cp out first
  run 0 steady --gait "$(cells first gait)"
  cmp -s out first || note "$gait does not read back"
done
run 0 steady --gait trapezoidal:0.5,0.5
half=$(cells out v_start displacement multiplier modes)
run 0 steady
[ "$(cells out v_start displacement multiplier modes)" = "$half" ] || note "trapezoidal:0.5,0.5 is not quadratic: $half"
finish "gaits read back what they print"

# ---- the families that --help lists are those of docs/gaits.md ----
run 0 steady --help
families=$(sed -n '/^Gaits/,/^$/s/^  \([a-z-]*\).*/\1/p' out)
[ "$(echo "$families" | wc -l)" -ge 7 ] || note "families: $families"
for family in $families; do
  grep -q "\`$family" "$root/docs/gaits.md" || note "docs/gaits.md has no $family"
done
finish "docs/gaits.md has every gait of --help"

# ---- refused ----
refuse 2 "did you mean 'trapezoidal'" steady --gait trapezodal
refuse 2 "UP + DOWN at most 1" phase --gait trapezoidal:0.7,0.4
refuse 2 "below 1" steady --gait skewed:1
for R in 0.51 -0.1 1e-31 0,-1 0.1,0.2,0.3; do refuse 2 "2^-100 to 0.5" steady --gait constant:$R; done
refuse 2 "it takes constant:R" steady --gait constant
refuse 2 "'x' is not a number" trajectory --gait skewed:x
refuse 2 "l' not at the end" steady --gait polynomial:0,3,-2.1
refuse 2 "so near to 0" steady --gait polynomial:0,0.125,-0.4166666666666667,0.5,-0.2
refuse 4 "cannot read nowhere.tsv: No such file" steady --gait measured:nowhere.tsv
printf '0 0\n1 1\n2 2\n3 3\n4 5\n' >bad.tsv
refuse 2 "bad.tsv: not periodic" steady --gait measured:bad.tsv
refuse 4 "cannot read bad.tsv:spline" steady --gait measured:bad.tsv:spline
printf 't\tl\n0\t0\n1\t1\n2\tx\n3\t0\n' >bad.tsv
refuse 2 "bad.tsv:4: column 2, 'x', is not allowed: a finite number is wanted" steady --gait measured:bad.tsv
finish "gaits that are refused, with file and line"

# ---- measured: L, T and alpha are the file's own, wherever --gait stands and unless they are given ----
printf '# a walk\nt l\n0 3\n1 5\n2 2\n4 1\n5 2\n10 3\n' >walk.tsv
run 0 steady --gait measured:walk.tsv:monotone
[ "$(cells out L T alpha gait)" = '4 10 0.7 measured:walk.tsv:monotone' ] || note "$(cells out L T alpha gait)"
run 0 steady --T 2 --gait measured:walk.tsv:monotone --L 7
[ "$(cells out L T alpha)" = '7 2 0.7' ] || note "given: $(cells out L T alpha)"
run 0 steady --gait measured:walk.tsv:monotone --certified --digits 12
[ "$(cells out status)" = certified ] || note "certified: $(cells out status)"
printf 'T\tgait\n2\tmeasured:walk.tsv:monotone\n3\tquadratic\n4\tskewed:0.3\n5\tmeasured:bad.tsv\n' >points.tsv
run 3 steady --points points.tsv
[ "$(cells out L T alpha gait | tr '\n' ';')" = '4 2 0.7 measured:walk.tsv:monotone;10 3 0.75 quadratic;10 4 0.75 skewed:0.3;nan nan nan -;' ] ||
  note "points: $(cells out L T alpha gait | tr '\n' ';')"
cut -f 19 out >status
tail -n 1 out | grep -q 'line 5: gait: bad.tsv:4: column 2' || note "status: $(tail -n 1 out)"
run 3 steady --points points.tsv --gait measured:walk.tsv:monotone --alpha 0.25
[ "$(cells out L T alpha | sed '4d' | tr '\n' ';')" = '4 2 0.25;10 3 0.25;10 4 0.25;' ] || note "points, alpha given: $(cells out L T alpha | tr '\n' ';')"
finish "measured gaits bring their own L, T and alpha"

# ---- every command that takes one answers, or says why not ----
run 0 phase --gait skewed:0.3 --v0 1 --error
run 0 phase --gait trapezoidal:0.2,0.3 --v0 1 --certified
run 0 trajectory --gait measured:walk.tsv --periods 1 --samples 4
[ "$(rows out | wc -l)" -eq 5 ] || note "trajectory: $(rows out | wc -l) rows"
run 0 series --gait minimum-jerk
grep -q "l'' = 0 where a phase of this gait begins or ends" err || note "series with minimum-jerk does not say why formulas have no value"
cells out published | grep -q inf && note "series with minimum-jerk: an infinite value"
run 0 series --source derived --order 3 --gait trapezoidal
rows out | cut -f 5 | grep -qx 160/37 || note "series: 160/37 is missing"
run 3 claims --gait minimum-jerk
grep -q "l'' = 0" err || note "claims with minimum-jerk: $(head -n 1 err)"
run 0 claims --gait skewed:0.3 --quiet
[ "$(cells out gait | sort -u)" = skewed:0.3 ] || note "claims: $(cells out gait | sort -u)"
run 0 claims --gait skewed:0.3 --errors rest_dT
run 0 stress --gait skewed:0.3 --T 0.5
[ "$(cells out verdict | sort -u)" = holds ] || note "stress: $(cells out verdict | sort -u)"
run 0 stress --gait trapezoidal:0.2,0.3 --family ordinary --cases 10
[ "$(cells out gait verdict)" = 'trapezoidal:0.2,0.3 holds' ] || note "stress: $(cells out gait verdict)"
finish "commands with gaits of all kinds"

# ---- constant:R; with R = 0 l' jumps, and by hand: v_start = L (m2/(M alpha T) - (F1 - F2)(1 - alpha) T/(M L)), v_mid = m2 L/(M alpha T) ----
run 0 steady --gait constant:0.1
same=$(cells out v_start v_mid displacement multiplier modes)
run 0 steady --gait trapezoidal:0.1,0.1
[ "$(cells out v_start v_mid displacement multiplier modes)" = "$same" ] || note "constant:0.1: $same"
run 0 steady --gait constant:0 --certified --digits 12
[ "$(cells out v_start v_mid displacement modes status)" = '6.29166666667 6.66666666667 6.57291666667 -+ 0+ | +- certified' ] || note "certified: $(rows out)"
run 0 steady --gait constant:0 --error
cells out v_start_error | grep -q '^[0-9]' || note "no estimate of an error: $(rows out)"
run 0 steady --gait constant:0 --alpha 0.5
cells out status | grep -qx 'interval of steady states: v_start from -10 to 9.25' || note "interval: $(rows out)"
run 3 steady --gait constant:0 --alpha 0.5 --certified
cells out status | grep -q "l' jumps, and the steady states fill an interval" || note "certified: $(rows out)"
run 0 phase --gait constant:0 --certified
run 3 series --source derived --order 4 --gait constant:0 # but not of the steady state
rows out | grep -q '^extension.*dxC.2.3/4' || note "series: $(rows out)"
run 3 stress --gait constant:0 --alpha 0.5
run 0 stress --gait constant:0 --cases 10
[ "$(cells out verdict | sort -u)" = holds ] || note "stress: $(cells out verdict | sort -u)"
finish "constant speed out and back"

printf '0 0\n1 2\n1.5 1.9\n2 3\n4 0\n' >noisy.txt
run 0 steady --gait measured:noisy.txt:monotone
grep -q "noisy.txt:monotone: columns between blanks: t is column 1, l column 2; 5 rows, one period of 4; a monotone" err || note "what was understood: $(cat err)"
grep -q "changes its sign 2 times" err || note "noise: $(cat err)"
run 0 steady --gait measured:noisy.txt --quiet
[ ! -s err ] || note "a note in spite of --quiet"
finish "a recording: what was understood, and that it has noise"

# ---- recordings: the issue's, of the minimum-jerk gait, and noise ----
awk 'BEGIN { for (i = 0; i <= 50; i++) { t = i / 50; s = t < .6 ? t / .6 : (1 - t) / .4; print t / 2, 3 * s^3 * (10 - 15 * s + 6 * s^2) } }' >jerk.txt
crawler='--m1 .8 --m2 1.7 --F1 2.2 --F2 .9'
# shellcheck disable=SC2086
run 0 steady --gait measured:jerk.txt $crawler
# the exact gait's: 0.13222413
cells out displacement low.displacement high.displacement | awk '{ exit !($1 > .130 && $1 < .1345 && $2 < .13222413 && $3 > .13222413 && $3 - $2 < .02) }' ||
  note "$(cells out low.displacement displacement high.displacement)"
# shellcheck disable=SC2086
run 0 phase --gait measured:jerk.txt $crawler --columns dxC,low.dxC,high.dxC
cells out dxC low.dxC high.dxC | awk '{ exit !($2 < $1 && $1 < $3) }' || note "phase: $(rows out)"
# shellcheck disable=SC2086
run 0 breakdown --gait measured:jerk.txt:cubic $crawler --only event
grep -q 'changes are left out that other curves' out || note "breakdown does not say what it left out"
cells out note | grep -q piece && note "pieces of a spline are events"
cells out T low high | awk 'NR > 1 && !($2 <= $1 && $1 <= $3) { exit 1 }' || note "T is not between low and high: $(rows out)"
run 0 steady --columns low.displacement,high.v_start
[ "$(rows out)" = "nan	nan" ] || note "an interval without a recording: $(rows out)"
refuse 2 "did you mean 'modes'" steady --columns low.modes
finish "recordings have intervals, and no events of their pieces"

# ---- people are shown the digits that the recording leaves, and the page of summary the intervals ----
awk 'BEGIN { for (i = 0; i < 100; i++) print i / 100, 3 - cos(i * atan2(0, -1) / 50) / 2 + 0.002 * sin(77 * i * i) }' >shaky.txt
run 0 steady --gait measured:shaky.txt --columns v_start,low.v_start,high.v_start,froude
cells out v_start low.v_start high.v_start froude >exact
run 0 steady --gait measured:shaky.txt --columns v_start,low.v_start,high.v_start,froude --format table
awk '$1 ~ /^(v_start|low.v_start|high.v_start|froude)$/ { printf "%s ", $2 }' out >shown
python exact shown <<'END'
exact, shown = (open(f).read().split() for f in sys.argv[1:3])
half = (float(exact[2]) - float(exact[1])) / 2
for e, s in zip(exact[:3], shown[:3]):
    place = 10.0 ** (math.floor(math.log10(half)) - 1)
    if abs(float(s) - float(e)) > 0.501 * place or len(s.split(".")[1]) > -math.floor(math.log10(place)) or len(s) > len(e) - 5:
        bad("shown", s, "of", e, "with half of the interval", half)
if len(shown[3]) < 7:
    bad("froude is no number that the recording limits here, but", shown[3])
END
run 0 steady --gait measured:shaky.txt --columns v_start --format table --digits 9
grep -q '^-[0-9.]*$' out && [ "$(tail -n 1 out | tr -d -- '-. ' | wc -c)" -ge 10 ] || note "--digits 9: $(tail -n 1 out)"
run 0 summary --gait measured:shaky.txt
low=$(sed -n 's/^  displacement  *from \([^ ]*\) to .*/\1/p' out) high=$(sed -n 's/^  displacement  *from [^ ]* to //p' out)
run 0 summary --gait measured:shaky.txt --format tsv --columns low.displacement,displacement,high.displacement,low.multiplier
cells out low.displacement high.displacement | awk -v low="$low" -v high="$high" '{ w = $2 - $1; exit !($1 < $2 && (low - $1)^2 + (high - $2)^2 < (w / 10)^2) }' ||
  note "the page has $low to $high, the row $(cells out low.displacement high.displacement)"
run 0 summary --gait measured:shaky.txt
grep -q '^  T = [0-9.]*, from [0-9.]* to [0-9.]* (Froude' out || note "events have no interval: $(grep 'T = ' out | head -n 3)"
run 0 summary
grep -q -e ' recording' -e ', from' out && note "intervals without a recording"
finish "the digits that a recording leaves"

run 0 steady --gait measured:shaky.txt:smooth=0.002
cp out suffix
run 0 steady --smooth 0.002 --gait measured:shaky.txt
[ "$(rows out | sed 's/:smooth=0.002//')" = "$(rows suffix | sed 's/:smooth=0.002//')" ] || note "--smooth is another curve than the suffix"
"$tool" steady --gait measured:/dev/stdin --smooth=0.002 <shaky.txt >out 2>err || note "a pipe with --smooth: $(cat err)"
[ "$(cells out displacement)" = "$(cells suffix displacement)" ] || note "a pipe with --smooth is another curve"
refuse 2 "without --gait" steady --smooth 0.1
refuse 2 "noise of one recording" steady --smooth 0.1 --gait sinusoidal
refuse 2 "noise of one recording" steady --smooth 0.1 --gait measured:shaky.txt,measured:jerk.txt
refuse 2 "'-1' is not allowed here" steady --smooth -1 --gait measured:shaky.txt
finish "--smooth is the suffix smooth="

# ---- what a reviewer broke: a stroke next to a long dwell, and rows a millionth apart, where |l'| has a spike ----
printf '0 1\n5 0\n9.9 0\n10 1\n' >dwell.txt
for T in 0.001 0.02; do
  run 0 stress --F1 1 --F2 4 --T $T --L 1 --alpha 0.05 --gait measured:dwell.txt
done
printf '0 0\n1 1\n2 2\n2.000001 3.5\n3.000001 4.5\n5.000001 5.5\n6.000001 7\n9.000001 0\n' >spike.txt
spike='phase --v0 1 --F1 4 --F2 1.5 --m1 0.05 --T 20 --gait measured:spike.txt'
# shellcheck disable=SC2086
run 0 $spike
cells out modes >double
# shellcheck disable=SC2086
run 0 $spike --certified
cells out modes | cmp -s - double || note "modes: $(cat double), certified $(cells out modes)"
finish "a short stroke beside a dwell, and rows a millionth apart"

exit $failed
