#!/bin/sh
# Every quantity is a column of every command that has rows, with the same value, and varies in the same ways as in a scene.
# Usage: sh tests/compare/command/cli_quantities.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/../../support/common.sh"

# ---- one row of many kinds, each as the command that is about it has it ----
kinds='T,displacement,cost_of_transport,error.text_steady_xC,derived_8.displacement,reach_1e-2.text_steady_xC,certified.v_start'
run 0 steady --columns "$kinds" --F1 2:10:3
cp out mixed
[ "$(header out)" = "$(echo $kinds | tr , ' ')" ] || note "$(header out)"
run 0 steady --F1 2:10:3
cp out plain
run 0 steady --F1 2:10:3 --certified
cp out certified
run 0 series --rows --only text_steady_xC --F1 2:10:3
cp out published
: >reach
for F1 in 2 6 10; do
  run 0 breakdown --only reach --quantity displacement --F1 $F1 --tol 1e-2
  awk -F '\t' '$3 == "text_steady_xC" { print $6 }' out >>reach
done
run 0 series --source derived --order 8 --F1 2 --format tsv
cp out terms
python mixed plain certified published reach terms <<'E2'
mixed, plain, certified, published = [read(name) for name in sys.argv[1:5]]
reaches = [float(line) for line in open(sys.argv[5])]
if not len(mixed) == len(plain) == len(reaches) == 3:
    bad("rows", len(mixed), len(reaches))
for m, p, c, s, reach in zip(mixed, plain, certified, published, reaches):
    if m["displacement"] != p["displacement"]:
        bad("displacement", m, p)
    if m["certified.v_start"] != c["v_start"]:
        bad("certified", m, c)
    error = number(s, "text_steady_xC") - number(m, "displacement")
    if abs(number(m, "error.text_steady_xC") - error) > 1e-14 * number(m, "displacement"):
        bad("error", m, s)
    if number(m, "reach_1e-2.text_steady_xC") != reach:
        bad("reach", m, reach)
terms = [r for r in read(sys.argv[6]) if r["quantity"] == "displacement"]
if not near(number(terms[-1], "sum"), number(mixed[0], "derived_8.displacement"), 1e-14):
    bad("derived", terms[-1], mixed[0])
E2
finish "one row of many kinds of quantities, each with the value of its own command"

# ---- the same cells in every command with rows ----
some='cost_of_transport,mean_power,relative.text_steady_xC,verdict.text_steady_xC,order.text_steady_xC,first_event_T,best_order'
of_last() { cells out $(echo "$some" | tr , ' ') | tail -n 1; }
run 0 steady --F1 3 --columns "$some"
cells_wanted=$(of_last)
case $cells_wanted in *nan* | '') note "steady: $cells_wanted" ;; esac
for command in phase 'trajectory --periods 1 --samples 2' 'series --rows' 'summary --format tsv' \
  'breakdown --map F1/F2 alpha --x 2:3:2 --y 0.65:0.75:2'; do
  given='--F1 3'
  case $command in breakdown*) given='' ;; esac
  run 0 $command $given --columns "$some"
  [ "$(of_last)" = "$cells_wanted" ] || note "$command: $(of_last), not $cells_wanted"
done
printf 'want = ( { what = "steady"; columns = [ "%s" ]; } );\n' "$(echo $some | sed 's/,/", "/g')" >some.cfg
run 0 run some.cfg --F1 3
[ "$(of_last)" = "$cells_wanted" ] || note "a scene: $(of_last)"
run 0 steady --F1 3 --T 0.4 --columns friction_work,T
mean=$(cells out friction_work T | awk '{ printf "%.15g", $1 / $2 }')
run 0 steady --F1 3 --T 0.4 --columns mean_power
[ "$(cells out mean_power | awk '{ printf "%.15g", $1 }')" = "$mean" ] || note "mean_power: $(cells out mean_power), not $mean"
finish "the same cells in steady, phase, trajectory, series, summary, a map and a scene"
for command in steady phase trajectory 'summary --format tsv' 'series --rows'; do
  for name in cost_of_transport mean_power reach_1e-2.S certified.displacement first_event_T relative.S; do
    "$tool" ${command%% *} --help | grep -q -F -e "$name" || note "$command --help does not list $name"
  done
  run 2 $command --columns T,cost_of_transprt
  grep -q "cost_of_transprt.*did you mean 'cost_of_transport'" err || note "$command: $(cat err)"
done
finish "--help lists them, and a misspelt one is answered with the nearest"
if command -v gnuplot >/dev/null; then
  run 0 breakdown --map F1/F2 alpha --x 2:4:3 --y 0.6:0.8:3 --plot-y mean_power --plot map.svg -o map.tsv
  grep -q mean_power map.svg || note "the map of mean_power"
  run 0 steady --F1 2:4:3 --columns F1,mean_power --plot curve.svg -o curve.tsv
  grep -q mean_power curve.svg || note "the curve of mean_power"
  finish "mean_power is drawn, as a curve and on a map"
fi

# ---- what varies ----
cat >vary.cfg <<'END2'
crawler = { F2 = 0.7; };
vary = ( ( { F1_over_F2 = { from = 2; to = 8; count = 3; spacing = "log"; }; label = { part = "a"; }; } ),
         ( { T = { from = 0.1; to = "0.5*sticking_onset"; count = 3; spacing = "linear"; }; label = { part = "b"; }; }, { m1_over_m2 = [ 2.0, 3.0 ]; } ),
         ( { froude = [ 3.0, 10.0 ]; label = { part = "c"; }; } ) );
want = ( { what = "steady"; columns = [ "part", "F1", "F2", "m1", "T", "froude", "displacement" ]; } );
END2
run 0 run vary.cfg
cp out scene.tsv
run 0 steady --F1_over_F2 2:8:3:log --F2 0.7 --label part=a --and --T '0.1:0.5*sticking_onset:3' --m1_over_m2 2,3 --label part=b \
  --and --froude 3,10 --label part=c --columns part,F1,F2,m1,T,froude,displacement
[ "$(rows out | wc -l)" = 11 ] || note "$(rows out | wc -l) rows"
rows out >got
rows scene.tsv | cmp -s - got || note "$(rows scene.tsv | diff - got | head -n 4)"
run 0 phase --F1 2,3 --and --gait sinusoidal,skewed --phase contraction,extension --v0 1,2 --columns F1,gait,phase,v0
[ "$(cells out F1 gait phase v0 | sed -n '1p;2p;3p' | tr '\n' ';')" = '2 quadratic extension 0;3 quadratic extension 0;4 sinusoidal contraction 1;' ] ||
  note "what varies behind --and does not hold in front of it: $(cells out F1 gait phase v0 | head -n 3)"
finish "ratios, Froude numbers, labels, blocks and formulas as ends are the same in options and in scenes"

# ---- threads ----
for columns in F1,certified.displacement,reach_1e-2.text_steady_xC F1,derived_12.displacement,status; do
  OMP_NUM_THREADS=1 run 0 steady --F1 1:10:41 --T 0.3,0.9 --columns "$columns"
  cp out one
  for threads in 2 3 64; do
    OMP_NUM_THREADS=$threads run 0 steady --F1 1:10:41 --T 0.3,0.9 --columns "$columns"
    cmp -s out one || note "$columns: $threads threads give other bytes"
  done
done
OMP_NUM_THREADS=3 run 0 steady --F1 1:10:41 --T 0.3,0.9 --columns F1,certified.displacement --stats
grep -q 'certified' err || note "--stats: $(cat err)"
finish "the same bytes for any number of threads"
exit $failed
