#!/bin/sh
# --plot: every command's picture, what is refused, gnuplot that is missing, and texts that could be taken for commands.
. tests/support/common.sh
if ! command -v gnuplot >/dev/null 2>&1; then
  echo "ok skipped: gnuplot is not installed"
  exit 0
fi

printf 'T\tF1\n0.1\t2\n0.5\t2\n1\t2\n0.1\t4\n0.5\t4\n1\t4\n' >points.tsv
printf 'h first second\n0.1 1e-2 1e-1\n0.05 2.5e-3 5e-2\n0.025 6.25e-4 2.5e-2\n' >errors.txt

drawn() { # NAME TITLES ARGUMENT...: the table is the same without the picture, and the picture is a whole SVG with these axis titles, between ^
  name=$1 titles=$2
  shift 2
  rm -f picture.svg
  run 0 "$@" --quiet
  mv out plain
  run 0 "$@" --quiet --plot picture.svg
  case $1 in
    workprec) [ -s out ] || note "no table" ;; # its times differ
    *) cmp -s out plain || note "--plot changes the table" ;;
  esac
  [ ! -s err ] || note "on standard error: $(head -n 1 err)"
  shown_in picture.svg "$titles"
  [ -z "$(find . -name '*.scallop-*')" ] || note "files are left: $(find . -name '*.scallop-*')"
  finish "$name"
}
shown_in() { # FILE TITLES
  /usr/bin/python3 - "$1" "$2" >said 2>&1 <<'END' || note "$(tail -n 1 said)"
import sys, xml.etree.ElementTree as tree
texts = ["".join(t.itertext()).strip() for t in tree.parse(sys.argv[1]).iter("{http://www.w3.org/2000/svg}text")]
missing = [t for t in sys.argv[2].split("^") if t not in texts]
sys.exit(f"not in the picture: {missing} among {texts[:60]}" if missing else 0)
END
}

drawn "trajectory" "t (time)^x₁, x₂, x_C (length)^x₁^m1=1 m2=1 F1=4 F2=1 L=10 T=1 alpha=0.75 gait=quadratic" trajectory --periods 2
drawn "a sweep of steady states" "T (time)^mean velocity (length/time)^F₁ = 2^F₁ = 4" steady --points points.tsv
printf 'T\n0.01\n0.1\n0.5\n' >wide.tsv
run 0 steady --points wide.tsv --plot wide.svg
shown_in wide.svg '0.02^0.05^0.2'
finish "a wide axis is logarithmic"
drawn "a sweep of phases" "T (time)^Δx_C (length)^F₁ = 4" phase --points points.tsv --v0 0.5
drawn "the published formulas" "|error / exact|^text_steady_xC  period  displacement" series --gait sinusoidal
drawn "errors of formulas" "T (time)^|relative.text_steady_xC|^10-6" series --only '(28),(27)' --T 0.05:2:20:log
drawn "formulas of a sweep" "T (time)^text_steady_xC^F₁ = 2" series --points points.tsv
for n in 2 3 4 5; do
  case $n in
    2) titles='t / T^x / L' ;;
    3) titles='t / T^v T / L' ;;
    4) titles='duration T of the extension^change of position' ;;
    5) titles='mean velocity^alpha' ;;
  esac
  drawn "figure $n" "$titles" figure "$n"
done
run 0 steady --T 0.1:5:9 --columns T,displacement --plot few.svg --plot-y displacement
[ -s few.svg ] || note "no picture of a table of two columns"
run 0 figure 4 --plot columns.svg --plot-x T --plot-y dxC_over_L --plot-by F1_over_F2
shown_in columns.svg "T (time)^dxC_over_L^F₁/F₂ = 40"
finish "a figure's columns"
drawn "orders" "h^|error|^first: order 2.0000 (2.0000 to 2.0000), measured" order errors.txt --quiet
if [ "${WITH_FLINT:-1}" != 0 ]; then
  drawn "certified states" "T (time)^mean velocity (length/time)^F₁ = 4" steady --points points.tsv --certified
  drawn "a derived series" "power^period, v_start" series --source derived --order 8
  drawn "events alone" "T (time)^1  T = 2.789: start velocity changes sign" breakdown --only event
  run 2 series --symbolic --emit python --plot no.svg
  grep -q 'with --emit it is of no use' err || note "$(cat err)"
  finish "no picture of a program"
  drawn "bounds" "bound^displacement" series --bound
  drawn "reaches" "T (time)^relative error^displacement^v_start^derived, best order at T" breakdown --tol 0.01
  of_map() { # NAME TEXTS X,Y ARGUMENT...
    name=$1 texts=$2 axes=$3
    shift 3
    # shellcheck disable=SC2086
    run 0 breakdown --map ${axes%,*} ${axes#*,} $grid --quiet --plot map.svg "$@"
    shown_in map.svg "$texts"
    finish "$name"
  }
  grid='--x 0.1:10:7 --y 0.1:0.9:5 --plot-y modes'
  of_map "a map" 'F₁/F₂^α^2^3  -- -+ -- | -- +- --  sliding' F1/F2,alpha
  # F1 = F2 is a line: what has its colour, that of the second region, is the box in the list and narrow cells
  # shellcheck disable=SC2086
  run 0 breakdown --map F1/F2 alpha $grid --quiet --plot line.svg
  /usr/bin/python3 - >said 2>&1 <<'END' || note "$(tail -n 1 said)"
import re
shapes = re.findall(r"fill = 'rgb\(251, 224, 174\)'[^>]*points = '([^']*)'", open("line.svg").read())
widths = [max(across) - min(across) for across in ([float(p.split(",")[0]) for p in s.split()] for s in shapes)]
assert len(widths) > 3 and sum(w > 8 for w in widths) == 1, widths
END
  finish "a region that is a line"
  grid="$grid --columns modes,regime,alpha,F1/F2"
  of_map "a map of few columns" 'F₁/F₂^α^2^3  -- -+ -- | -- +- --  sliding' F1/F2,alpha
  # What is drawn need not be written, and is all that is computed; without a choice it is the three regimes.
  grid='--x 0.1:100:7 --y 0.1:0.9:5 --columns displacement,F1_over_F2'
  of_map "a map without a column that it draws" 'F₁/F₂^α^1  sliding^2  stick-slip' F1/F2,alpha
  [ "$(header out)" = "displacement F1_over_F2" ] || note "written is: $(header out)"
  of_map "the same with modes" 'F₁/F₂^α^2^3  -- -+ -- | -- +- --' F1/F2,alpha --plot-y modes
  # shellcheck disable=SC2086
  run 2 breakdown --map F1/F2 alpha $grid --plot no.svg --plot-y regimes
  grep -q "no quantity 'regimes': did you mean 'regime'" err || note "$(cat err)"
  [ ! -s out ] || note "something is written before a column is refused"
  run 0 breakdown --map F1/F2 alpha --x 0.1:100:7 --y 0.1:0.9:5 --plot regimes.svg
  shown_in regimes.svg 'F₁/F₂^α^1  sliding^2  stick-slip'
  grep -q T_1e out && note "a series is computed that is not drawn"
  finish "what a map draws"
  grid='--x 0.1:0.9:5 --y 0.3:10:4 --gait sinusoidal --plot-y modes'
  of_map "a map over other axes" 'α^T (time)^1' alpha,T
  grid='--x 0.1:0.9:5 --y 0.3:10:4 --boundaries'
  of_map "boundaries" 'α^T (time)^1' alpha,T
  grid='--x 0.1:10:7 --y 0.1:0.9:5 --plot-y displacement'
  # shellcheck disable=SC2086
  run 0 breakdown --map F1/F2 alpha $grid --plot heat.svg
  shown_in heat.svg 'F₁/F₂^α^displacement (length)'
  finish "a heat map of a quantity"
  # A map is one whatever its columns are called, of numbers and of words, and computes no series that is not drawn.
  run 0 breakdown --map F1/F2 T --x 0.1:10:9 --y 0.5:8:7 --columns F1/F2,T,mean_velocity,modes --plot-y mean_velocity --plot f.svg
  shown_in f.svg 'F₁/F₂^T (time)^mean velocity (length/time)'
  run 0 breakdown --map F1/F2 T --x 0.1:10:9 --y 0.5:8:7 --columns F1/F2,T,mean_velocity --plot-y mean_velocity --plot f.svg
  shown_in f.svg 'F₁/F₂^T (time)^mean velocity (length/time)'
  run 0 breakdown --map F1/F2 T --x 0.1:10:9 --y 0.5:8:7 --columns F1/F2,T,regime --plot-y regime --plot f.svg
  shown_in f.svg 'F₁/F₂^T (time)^1  sliding^2  stick-slip'
  run 0 breakdown --map F1/F2 T --x 0.1:10:9 --y 0.5:8:7 --plot-y mean_velocity --plot f.svg
  grep -q 'T_1e-2_derived_8' out && note "a series is computed that is not drawn"
  grep -q "$(printf '\tmean_velocity\t')" out || note "no mean velocity"
  run 0 breakdown --map F1/F2 alpha --x 2:20:3 --y 0.6:0.9:3 --plot-y T_1e-2_derived_8 --plot f.svg
  [ "$(grep -c 'T_1e-2_published' out)" = 0 ] || note "another series is computed"
  shown_in f.svg 'F₁/F₂^α^T_1e-2_derived_8'
  run 2 breakdown --map F1/F2 T --x 0.1:10:9 --y 0.5:8:7 --plot-y mean_velocity,regime --plot f.svg
  grep -q 'a map shows one column' err || note "$(cat err)"
  # Of a noisy gait there are more regions than the list takes: every text stays on the canvas.
  /usr/bin/python3 -c "
import math
print('t l')
for i in range(61):
    x = i / 60
    print(4 * x, 2 + (x / 0.7 if x < 0.7 else (1 - x) / 0.3) + 0.03 * math.sin(7 * i * i) * (0 < i < 60))" >noisy.txt
  run 0 breakdown --map F1/F2 froude --gait measured:noisy.txt:monotone --x 0.1:10:31 --y 0.05:50:31 --plot-y modes --plot many.svg --quiet
  run 0 breakdown --map F1/F2 froude --gait measured:noisy.txt:monotone --x 0.1:10:31 --y 0.05:50:31 --plot-y modes --plot small.svg --plot-size 800x500 --quiet
  /usr/bin/python3 - >said 2>&1 <<'END' || note "$(cat said)"
import re, sys
for name in "many.svg", "small.svg":
    text = open(name).read()
    width, height = map(float, re.search(r'<svg[^>]* width="(\d+)" height="(\d+)"', text).groups())
    labels = re.findall(r'translate\(([-0-9.]+),([-0-9.]+)\)"[^>]*Sans Mono"[^>]*>\s*<text[^>]*>(.*?)</text>', text)
    if len(labels) < (60 if name == "many.svg" else 5):
        sys.exit(f"{name}: only {len(labels)} entries")
    for x, y, entry in labels:
        if not (0 < float(x) and float(x) + 6.1 * len(entry) < width and 0 < float(y) < height):
            sys.exit(f"{name}: off the canvas: {x} {y} {entry}")
END
  finish "maps of any column, and of many regions"
  drawn "families of stress" 'units, rounding, perturbed^masses  quadratic^promised for units: 8' stress --family masses --cases 2
  drawn "stress of a point" 'units, rounding, perturbed^v_start' stress --F1 3
  drawn "work-precision" 'seconds for one steady state, on one machine^relative error of the displacement^quadratic gait, T = 0.5^exact^Pareto front' \
    workprec --quick --gait quadratic --T 0.5
fi

# ---- options of the picture ----
run 0 steady --points points.tsv --plot options.svg --plot-x T --plot-y v_start,v_mid --plot-by F1 --plot-title 'A title' --plot-size 640x420 \
  --plot-x-range 0.1:2:log --plot-y-range -10:120
shown_in options.svg 'A title^v_start, v_mid (length/time)^v_mid, F₁ = 4^120^0.2'
grep -q 'width="640" height="420"' options.svg || note "$(grep -m 1 -o '<svg.*' options.svg)"
finish "title, size, ranges and columns"
for kind in png pdf; do
  run 0 steady --points points.tsv --plot "picture.$kind" --format json -o table.json
  [ -s "picture.$kind" ] || note "no picture.$kind"
  "$tool" steady --points points.tsv --format json | cmp -s - table.json || note "another table"
done
head -c 4 picture.png | grep -q PNG || note "no PNG"
head -c 4 picture.pdf | grep -q '%PDF' || note "no PDF"
finish "PNG and PDF, beside a table in another format"

scene() { printf 'vary = ( { T = [ 0.1, 0.5, 1.0 ]; } );\nwant = ( { what = "steady"; file = "scene.tsv"; plot = { file = "scene.svg"; x = "T"; y = "v_start"; %s }; } );\n' "$1" >scene.cfg; }
scene 'title = "Of a scene"; size = "640x420"; x_range = "0.01:10:log"; y_range = "-5:45";'
run 0 run scene.cfg --quiet
shown_in scene.svg 'Of a scene^T (time)^v_start (length/time)^40'
grep -q 'width="640" height="420"' scene.svg || note "another size"
printf 'want = ( { what = "breakdown"; map = [ "F1/F2", "alpha" ]; x = "0.1:10:7"; y = "0.1:0.9:5"; source = "published"; file = "m.tsv"; plot = { file = "m.svg"; }; } );\n' >map.cfg
run 0 run map.cfg --quiet
shown_in m.svg 'F₁/F₂^α'
printf 'vary = ( { T = [ 0.1, 0.5, 1.0 ]; } );\nwant = ( { what = "steady"; file = "s.tsv"; plot = { file = "s.svg"; y = "cost_of_transport"; }; } );\n' >few.cfg
run 0 run few.cfg --quiet
shown_in s.svg 'T (time)^cost of transport'
scene 'size = "640";'
run 2 run scene.cfg
grep -q "size: '640' is not allowed here" err || note "$(cat err)"
scene 'x_range = "1";'
run 2 run scene.cfg
grep -q "x_range: '1' is not allowed here" err || note "$(cat err)"
finish "the plot of a scene takes the same"

# ---- refusals: nothing is computed, no picture, no table ----
refused() { # CODE WORDS ARGUMENT...
  wanted=$1 words=$2
  shift 2
  rm -f no.svg
  run "$wanted" "$@"
  grep -q -e "$words" err || note "$*: '$words' is not said: $(cat err)"
  [ ! -e no.svg ] || note "$*: a picture"
}
refused 2 '--plot draws' steady -o no.svg
refused 2 '--plot draws' trajectory -o no.pdf
refused 2 "'no.jpg' is not allowed here: it takes a file name that ends in .svg, .png or .pdf" steady --plot no.jpg
refused 2 '--plot-title has nothing to do without --plot' steady --plot-title x
refused 2 'WIDTHxHEIGHT' steady --plot no.svg --plot-size 10x10
refused 2 'WIDTHxHEIGHT' steady --plot no.svg --plot-size 800
refused 2 'FROM:TO' steady --plot no.svg --plot-x-range 2:1
refused 2 'FROM:TO' steady --plot no.svg --plot-y-range 0:1:log
refused 2 'FROM:TO' steady --plot no.svg --plot-y-range 1:2:lin
refused 2 'one to eight columns' steady --plot no.svg --plot-y v_start,,v_mid
refused 2 'one to eight columns' steady --plot no.svg --plot-y 1,2,3,4,5,6,7,8,9
refused 2 'control characters' steady --plot no.svg --plot-title "$(printf 'a\nb')"
refused 2 'does not take the option' claims --plot no.svg
refused 4 'No such file' steady --points points.tsv --plot missing/no.svg
[ ! -s out ] || note "a table, though its picture has no place"
refused 2 "--plot-y: there is no quantity 'speed'" steady --points points.tsv --plot no.svg --plot-y speed
refused 2 'no parameter varies' steady --plot no.svg
[ "$(rows out | wc -l)" = 1 ] || note "no table where there is no picture"
refused 2 'no parameter varies' steady --T 0.1:5:9 --columns displacement --plot no.svg --plot-y displacement
finish "refusals"

# ---- the table comes without gnuplot ----
mkdir bin
"$tool" trajectory >want
PATH=$scratch/bin "$tool" trajectory --plot no.svg >out 2>err
[ $? = 4 ] || note "no exit code 4"
cmp -s out want || note "another table"
grep -q 'gnuplot is not installed (Debian: gnuplot-nox); the tables are written' err || note "$(cat err)"
[ ! -e no.svg ] || note "a picture"
[ -z "$(find . -name '*.scallop-*')" ] || note "files are left"
finish "without gnuplot"

# ---- what ends the tool ends gnuplot, and leaves nothing ----
cat >bin/gnuplot <<'END'
#!/bin/sh
echo $$ >started
exec sleep 1000
END
chmod +x bin/gnuplot
lives() { kill -0 "$1" 2>/dev/null && ! grep -q ') Z ' "/proc/$1/stat" 2>/dev/null; } # it has not only not been waited for
for signal in TERM HUP; do
  rm -f started
  (PATH=$scratch/bin:$PATH && export PATH && keep_counts_apart && exec "$tool" trajectory --plot z.svg >/dev/null 2>&1) &
  child=$!
  until [ -s started ]; do kill -0 $child 2>/dev/null || break; done
  kill -$signal $child
  wait $child 2>/dev/null
  ! lives "$(cat started)" || { note "SIG$signal leaves gnuplot"; kill -9 "$(cat started)"; }
  [ -z "$(find . -name 'z.svg*')" ] || note "SIG$signal leaves $(find . -name 'z.svg*')"
done
rm -f bin/gnuplot
finish "a signal ends gnuplot too"

# ---- texts that could be taken for commands ----
nasty() { # TEXT
  rm -f hacked
  run 0 steady --points points.tsv --plot nasty.svg --plot-title "$1"
  grep -q '</svg>' nasty.svg || note "no picture with the title $1"
  printf 'h\t%s\n0.1\t1e-2\n0.05\t2.5e-3\n0.025\t6.25e-4\n' "$1" >"$1"
  run 0 order "$1" --plot nasty.svg
  grep -q '</svg>' nasty.svg || note "no picture of the file $1"
  rm -f "./$1"
  run 0 trajectory --plot "./$1.svg"
  grep -q '</svg>' "./$1.svg" || note "no picture $1.svg"
  rm -f "./$1.svg"
  [ ! -e hacked ] || note "$1 is executed"
}
# shellcheck disable=SC2016
nasty '`touch hacked`'
nasty '"; system("touch hacked"); "'
nasty "'; !touch hacked #"
nasty '@hacked'
# shellcheck disable=SC2016
nasty '$(touch hacked)'
nasty '\"; !touch hacked'
finish "no text runs anything"

# ---- texts that could be taken for markup: the picture is XML, and shows them ----
mark='a ]]> <b> & "q" \n\134 &#x1; F#1'
run 0 steady --points points.tsv --plot mark.svg --plot-title "$mark"
shown_in mark.svg "$mark"
printf '0 3\n1 5\n2 2\n4 1\n5 2\n10 3\n' >"$mark"
run 0 steady --gait "measured:$mark:monotone" --F1 1:5:3 --plot mark.svg
shown_in mark.svg "m1=1 m2=1 F2=1 L=4 T=10 alpha=0.7 gait=measured:$mark:monotone"
printf 'h err\n0.1 1e-2\n0.05 2.5e-3\n0.025 6.25e-4\n' | tee "$mark" >"$(printf 'b\nc\033')"
run 0 order "$mark" "$(printf 'b\nc\033')" --plot mark.svg
shown_in mark.svg "$mark: order 2.0000 (2.0000 to 2.0000), measured^b c : order 2.0000 (2.0000 to 2.0000), measured"
printf 'T\tx\n0.1\td\001\377\303\274]]>\n0.5\td\001\377\303\274]]>\n0.1\te\n0.5\te\n' >carried.tsv
run 0 steady --points carried.tsv --plot mark.svg --plot-x T --plot-y v_start --plot-by x
shown_in mark.svg 'd??ü]]>^e'
cat >mark.cfg <<'END'
title = "a ]]> <b> & \"q\" \\n\\134 &#x1; F#1";
vary = ( { T = [ 0.1, 0.5, 1.0 ]; }, { label = { which = [ "a ]]> <b> & \"q\" \\n\\134 &#x1; F#1", "e" ]; }; } );
want = ( { what = "steady"; file = "mark.tsv"; columns = [ "T", "which", "v_start" ];
  plot = { file = "mark.svg"; x = "T"; y = "v_start"; by = "which"; }; } );
END
run 0 run mark.cfg
shown_in mark.svg "$mark^$mark^e"
[ -z "$(find . -name '*.scallop-*')" ] || note "files are left: $(find . -name '*.scallop-*')"
echo 'set terminal svg mouse; set output output_file; set label 1 title at 0,0 noenhanced; plot table using 1:3' >own.gp
sed 's/x = "T";.*/script = ".\/own.gp"; }; } );/; s/&#x1;//g' mark.cfg >own.cfg
run 0 run own.cfg
grep -q CDATA mark.svg || note "no script for the mouse"
/usr/bin/python3 -c 'import xml.etree.ElementTree as tree; tree.parse("mark.svg")' 2>said || note "a script of one's own: $(tail -n 1 said)"
finish "a picture is XML, whatever it shows"
mkdir -p planted/scripts/plots planted/plot && cd planted || exit 1
for script in common curves map reach dots plot request; do echo 'system("touch hacked")' | tee "$script.gp" "$script.awk" plot/"$script.awk" >"scripts/plots/$script.gp"; done
cp common.gp .gnuplot
HOME=$(pwd) run 0 trajectory --plot t.svg
[ ! -e hacked ] || note "a script of the current folder is executed"
finish "nothing in the current folder is executed"
exit $failed
