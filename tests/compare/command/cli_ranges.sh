#!/bin/sh
# Lists and ranges of parameters on the command line, columns that are chosen, and columns that are carried along.
# Usage: sh tests/compare/command/cli_ranges.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/../../support/common.sh"

refuse() { # MESSAGE ARGUMENT...: exit code 2, one line on standard error, nothing on standard output
  message=$1
  shift
  run 2 "$@"
  { grep -q -e "$message" err && [ "$(wc -l <err)" = 1 ]; } || note "scallop $*: $(cat err)"
  [ ! -s out ] || note "scallop $*: $(head -n 1 out)"
}

# ---- which points, in which order ----
run 0 steady --alpha 0.6,0.70 --F1 1:4:4 --gait quadratic,trapezoidal:0.1,0.2,sinusoidal
rows out | cut -f 3,7,8 >got
for alpha in 0.6 0.7; do for F1 in 1 2 3 4; do for gait in quadratic trapezoidal:0.1,0.2 sinusoidal; do
  printf '%s\t%s\t%s\n' $F1 $alpha $gait
done; done; done >wanted
cmp -s got wanted || note "$(diff got wanted | head -n 5)"
run 0 phase --phase extension,contraction --v0 -1:1:3
[ "$(cells out phase v0 | tr '\n' ';')" = 'extension -1;extension 0;extension 1;contraction -1;contraction 0;contraction 1;' ] ||
  note "$(cells out phase v0)"
finish "the product of what varies, the last option fastest"
run 0 steady --T 1:2:3 --F1 3,4 --T 0.5
[ "$(cells out F1 T | tr '\n' ';')" = '3 0.5;4 0.5;' ] || note "$(cells out F1 T)"
run 0 steady --T 0.5 --F1 3 --T 1,2
[ "$(cells out F1 T | tr '\n' ';')" = '3 1;3 2;' ] || note "$(cells out F1 T)"
finish "of an option that stands twice the second holds"

run 0 steady --F1 1:10:40 --T 1e-3:1:50:log
cp out swept.tsv
rows swept.tsv | cut -f 1-8 >points
{ header swept.tsv | cut -d ' ' -f 1-8 | tr ' ' '\t'; cat points; } >points.tsv
run 0 steady --points points.tsv
cmp -s out swept.tsv || note "$(diff out swept.tsv | head -n 4)"
cat >scene.cfg <<'END'
vary = ( { F1 = { from = 1; to = 10; count = 40; }; }, { T = { from = 1e-3; to = 1; count = 50; spacing = "log"; }; } );
want = ( { what = "steady"; file = "scene.tsv"; } );
END
run 0 run scene.cfg
rows scene.tsv | cut -f 1-8 >scene
[ "$(wc -l <scene)" = 2000 ] || note "$(wc -l <scene) points of the scene"
cmp -s points scene || note "$(diff points scene | head -n 4)"
finish "the points of a range are those of a scene, and the rows those of --points"
run 0 phase --v0 0,2.5 --T 0.1,1 --format json
run 0 series --T 0.1,1
[ "$(rows out | wc -l)" = 2 ] || note "$(rows out | wc -l) rows"
cp out series.tsv
printf 'T\n0.1\n1\n' >two.tsv
run 0 series --points two.tsv
cmp -s out series.tsv || note "series: other rows"
finish "series: the rows of --points"
run 0 series --T 0.1,1 --only '(28),rest_dT'
cp out chosen.tsv
printf 'vary = ( { T = [ 0.1, 1.0 ]; } );\nwant = ( { what = "steady"; columns = [ "(28)", "exact.(28)", "relative.text_steady_xC" ]; } );\n' >numbered.cfg
run 0 run numbered.cfg
python chosen.tsv out series.tsv <<'END'
mine, scene, all = (read(f) for f in sys.argv[1:])
formulas = ["rest_dT", "rest_dT:contraction", "text_steady_xC"]
if list(mine[0])[9:] != [p + f for f in formulas for p in ("", "exact.", "relative.")] + ["status"]:
    bad(list(mine[0]))
for m, s, a in zip(mine, scene, all):
    if any(m[f] != a[f] for f in formulas) or [m["text_steady_xC"], m["exact.text_steady_xC"]] != [s["(28)"], s["exact.(28)"]]:
        bad(m, s)
    if abs(number(m, "relative.text_steady_xC") - number(s, "relative.text_steady_xC")) > 4e-15:  # of doubles, and of more
        bad("relative", m, s)
END
run 0 series --only '(26)' --columns formula
[ "$(rows out)" = text_steady_velocity_l0_lT ] || note "(26): $(cat out)"
refuse "there is no formula 'text_steady_xc' here: did you mean 'text_steady_xC'" series --only '(28),text_steady_xc'
refuse "'(A.17)' here: of this equation there are A_x1_switch_from_times, A_x1_switch_collected" series --only '(A.17)'
refuse 'only is for the published formulas' series --only '(28)' --source derived
finish "series --only: formulas by name and by equation, with their exact values and errors"
run 3 steady --T 1e-170,1 --m1 1e300,1
[ "$(cells out status | grep -c '^ok$')" = 2 ] || note "$(cells out T m1 status)"
grep -q '2 of 4 points could not be solved' err || note "$(cat err)"
finish "a point without an answer keeps its row"
run 0 steady --certified --alpha 0.6,0.70 --T 0.1:0.3:3 --digits 20
[ "$(cells out alpha T froude | tr '\n' ';')" = "0.6 0.1 400.00000000000000000;0.6 0.2 100.00000000000000000;0.6 0.3 44.444444444444444444;\
0.70 0.1 400.00000000000000000;0.70 0.2 100.00000000000000000;0.70 0.3 44.444444444444444444;" ] || note "$(cells out alpha T froude)"
finish "certified: lists as they are written, ranges as they are printed"

# ---- what is refused ----
refuse "--F1: '1:10:0' is no range: FROM:TO:COUNT, .*COUNT is from 2 to 1000000000" steady --F1 1:10:0
refuse "--F1: '0' is not allowed here: it takes a finite number > 0" steady --F1 0:1:4:log
refuse "--v0: .*log spacing is > 0" phase --v0 0:1:4:log
refuse "--m2: 1e+16 points: more than 1e+15" steady --m1 1:2:100000000 --m2 1:2:100000000
refuse "--F1: a list or a range and --points exclude each other" steady --F1 1,2 --points points.tsv
for command in claims workprec stress breakdown 'figure 4' 'run scene.cfg'; do
  # shellcheck disable=SC2086
  refuse "--F1: this command takes one value: a list or a range is for steady, phase, series and trajectory" $command --F1 1,2
done
refuse "--T: this command takes one value" series --T 0.1,0.2 --symbolic
refuse "nothing varies in front of it" steady --and
refuse "orders need T to vary" series --orders --F1 1,2
refuse "is about rows of points" series --accuracy 1e-20
finish "what is no list and no range, and where none is taken"

# ---- columns that are chosen ----
run 0 steady --F1 1:10:40 --T 1e-3:1:50:log --columns 'status,T,ratio = F1/F2,v_start'
rows out >got
rows swept.tsv | awk -F '\t' -v OFS='\t' '{ print $17, $6, $3, $10 }' >wanted
[ "$(header swept.tsv | cut -d ' ' -f 10,17)" = 'v_start status' ] || note "$(header swept.tsv)"
cmp -s got wanted || note "$(diff got wanted | head -n 4)"
[ "$(header out)" = 'status T ratio v_start' ] || note "$(header out)"
sed '/^[^#]/,$d' out >heads
grep '^#' swept.tsv | cmp -s - heads || note "other '#' lines: $(cat heads)"
finish "steady: the columns that are asked for, and a formula"
chosen() { # HEADER ARGUMENT...
  wanted_header=$1
  shift
  run 0 "$@"
  [ "$(header out)" = "$wanted_header" ] || note "$*: $(header out)"
  [ "$(rows out | wc -l)" -gt 0 ] || note "$*: no rows"
}
chosen 'v0 w' phase --columns 'v0,w=v_end/v0' --v0 2
chosen 't d' trajectory --columns 't,d=x1-x2'
chosen 'formula relative' series --columns 'formula,relative=error/exact'
chosen 'power c' series --source derived --columns 'power,c=2*coefficient'
chosen 'claim verdict' claims --columns claim,verdict --gait quadratic --quiet
chosen 'T f' breakdown --only radius --columns 'T,f=froude/2'
chosen 'error gait' workprec --quick --limit 0.01 --columns error,gait --quiet
chosen 'certified quantity' stress --T 0.5 --columns certified,quantity
chosen 'dT F1_over_F2' figure 4 --columns 'dT=10*T,F1_over_F2'
printf 'h err\n0.1 0.01\n0.05 0.0025\n0.025 0.000625\n' >errors.txt
chosen 'verdict order' order errors.txt --columns verdict,order
run 0 order errors.txt --columns verdict --format json
[ "$(cat out)" = '{"verdict": "measured"}' ] || note "json: $(cat out)"
finish "every table of rows takes --columns"
for command in steady phase trajectory series 'series --source derived' 'breakdown --only radius' 'figure 4' 'order errors.txt' 'claims --quiet --gait quadratic'; do
  # shellcheck disable=SC2086
  refuse "^scallop [a-z]*: --columns: there is no \(column\|quantity\) 'nonsense_of_mine'" $command --columns nonsense_of_mine
done
refuse "there is no quantity 'statu': did you mean 'status'" steady --columns statu -o none.tsv
[ ! -e none.tsv ] || note "none.tsv is there"
refuse "'F1/': character" steady --columns 'r=F1/'
refuse "'' is not allowed here: it takes names of columns" steady --columns F1,,F2
refuse "is there twice" steady --columns F1,F1
refuse "columns is for tables" series --source derived --emit python --columns power
refuse "columns is for tables" order errors.txt --format junit --columns verdict
finish "columns that are not there are refused, and nothing is written"

# ---- columns that are carried along ----
printf 'case\tT\tnote\t\tcase\tstatus\tF1\n' >marked.tsv
printf '007\t0.5\tna\303\257ve, "so" \\ x|y\t1\tagain\told\t3\n' >>marked.tsv
printf '1e400\t-1\t\t1\tagain\told\t3\n-0.50\t1\t#2\n' >>marked.tsv
run 3 steady --points marked.tsv
[ "$(header out | cut -d ' ' -f 6-11)" = 'T alpha gait case note froude' ] || note "$(header out)"
rows out | cut -f 9,10 >got
printf '007\tna\303\257ve, "so" \\ x|y\n1e400\t\n-0.50\t#2\n' >wanted
cmp -s got wanted || note "$(cat got)"
grep -q "not carried along, as their names are taken or empty: '', case, status\$" err || note "$(cat err)"
[ "$(rows out | cut -f 19 | cut -c 1-10 | tr '\n' ';')" = 'ok;line 3: T:;line 4: 3 ;' ] || note "$(rows out | cut -f 19)"
finish "columns that are no parameters are carried along byte for byte, also in rows without an answer"
run 3 steady --points marked.tsv --format json --quiet
python <<'END'
rows = [json.loads(line) for line in open("out", encoding="utf-8")]
if [(r["case"], r["note"]) for r in rows] != [("007", 'naïve, "so" \\ x|y'), ("1e400", ""), (-0.5, "#2")]:
    bad(rows)
END
grep -q '"case": -0.50, ' out || note "$(cat out)"
run 3 steady --points marked.tsv --format csv --quiet
python <<'END'
import csv
rows = list(csv.DictReader(line for line in open("out", encoding="utf-8")))
if rows[0]["note"] != 'naïve, "so" \\ x|y':
    bad(rows[0])
END
run 3 steady --points marked.tsv --format markdown --quiet --columns note,case
sed -n 3p out | grep -q -F -x "$(printf '| na\303\257ve, "so" \\\\ x\\|y | 007 |')" || note "$(cat out)"
printf 'T\ta\001b\tbad\n1\tc\002d\t\377\n' >odd.tsv
run 0 steady --points odd.tsv
[ "$(rows out | cut -f 9,10)" = "$(printf 'c\002d\t\377')" ] || note "$(rows out | cut -f 9,10)"
run 0 steady --points odd.tsv --format json
/usr/bin/python3 -c 'import json; json.load(open("out", encoding="utf-8"))' 2>said || note "json: $(tail -n 1 said)"
finish "carried cells in every format"
"$tool" steady --T 0.1,0.2 --error >first.tsv
"$tool" steady --points first.tsv --error --quiet | cmp -s - first.tsv || note "another table"
"$tool" steady --T 0.1,0.2 | "$tool" phase --points - --quiet >out
[ "$(header out | cut -d ' ' -f 9-12)" = 'phase v0 froude v_start' ] || note "$(header out)"
"$tool" steady --points out --quiet >again
[ "$(header again | cut -d ' ' -f 8-11)" = 'gait phase v0 t1' ] || note "$(header again)"
"$tool" series --points first.tsv --quiet >series.tsv
[ "$(header series.tsv | cut -d ' ' -f 8-11)" = 'gait v0 froude v_start' ] || note "$(header series.tsv)"
[ "$(awk -F '\t' '!/^#/ && NF != n { if (n) print NF; n = NF }' series.tsv)" = '' ] || note "series: rows of other lengths"
"$tool" series --points series.tsv --quiet | cmp -s - series.tsv || note "series: another table"
finish "a table goes through its own command, and through others"
{ printf 'T'; for i in $(seq 255); do printf '\tc%d' "$i"; done; printf '\n1'; for i in $(seq 255); do printf '\t%d' "$i"; done; echo; } >wide.tsv
run 0 steady --points wide.tsv
[ "$(header out | wc -w) $(cells out c255 status)" = '272 255 ok' ] || note "$(header out | wc -w) columns"
finish "as many columns as a table may have"
# ---- values as people write them: fractions, decimal commas, coefficients of friction ----
run 0 steady --alpha 3/5,0.6 --columns alpha,displacement
[ "$(rows out | sort -u | wc -l)" = 1 ] && [ "$(cells out alpha | head -n 1)" = 0.6 ] || note "3/5 is not 0.6: $(rows out)"
[ ! -s err ] || note "a note about 3/5,0.6: $(cat err)"
run 2 steady --alpha 3/0
grep -q "'3/0' is not allowed here" err || note "$(cat err)"
if [ "${WITH_FLINT:-1}" != 0 ]; then
  run 0 steady --alpha 1/3 --certified --columns alpha,certified.displacement --digits 40
  third=$(cells out certified.displacement)
  [ "$(cells out alpha)" = 1/3 ] || note "alpha is written $(cells out alpha)"
  run 0 steady --alpha 0.33333333333333333333333333333333333333333333333333 --certified --columns certified.displacement --digits 40
  [ "$(cells out certified.displacement)" = "$third" ] || note "1/3 is not exactly a third: $third"
  run 0 steady --alpha 1/3 --m1 .5 --certified --format json
  grep -q '"m1": 0.5, .*"alpha": 0.3333333333333333, ' out || note "in JSON they are no numbers: $(cat out)"
  run 0 claims --format json --quiet --verdict refuted
  grep -q '"derived_order": [0-9]' out && ! grep -q '"derived_order": "[-0-9]*[0-9]"' out || note "derived_order is no number in JSON"
fi
finish "fractions are values, and numbers are numbers in JSON"
run 0 steady --T 1,5 --columns T
[ "$(cat err)" = "scallop steady: note: --T 1,5 is two values, 1 and 5; a number has a decimal point: 1.5" ] || note "$(cat err)"
[ "$(cells out T | tr '\n' ' ')" = "1 5 " ] || note "$(rows out)"
for list in 1,5,7 1.0,5 1,5.5 1/2,5; do
  run 0 steady --T $list
  [ ! -s err ] || note "--T $list: $(cat err)"
done
run 0 steady --T 1,5 --quiet
[ ! -s err ] || note "with --quiet: $(cat err)"
finish "a decimal comma is two values, which is said"
run 0 steady --mu1 0.4,0.2 --mu2 0.1 --m1 2 --m2 3 --g 10 --columns F1,F2,mu1,mu2
[ "$(rows out | tr '\t\n' '  ')" = "8 3 0.4 0.1 4 3 0.2 0.1 " ] || note "$(rows out)"
run 0 steady --mu1 0.4 --m1_over_m2 2 --m2 3 --columns F1,m1
[ "$(cells out F1 m1)" = "23.544 6" ] || note "F1 = 0.4 6 9.81: $(rows out)"
run 0 steady --F1 3 --m1 2 --columns mu1
[ "$(cells out mu1)" = 0.1529051987767584 ] || note "mu1 of F1 = 3, m1 = 2: $(rows out)"
run 2 steady --g 10
run 2 steady --mu1 0.3 --F1 2
run 2 steady --mu2 0.3 --F2 2,3
run 2 steady --mu1 0.3 --F1_over_F2 2
finish "coefficients of friction"
exit $failed
