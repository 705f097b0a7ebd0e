#!/bin/sh
# --stats: what is computed, and that it is no more than what the columns ask for.
scenes=$(cd "$(dirname "$0")/../../../data/scenes" && pwd)
. tests/support/common.sh

# counted SCENE STAGE: what was done; after `stats SCENE`
stats() { run "$1" run "$2" --stats --into . --quiet --no-plots; grep -P '^[a-zA-Z_]+\t[0-9]+$' err >counts; }
counted() { awk -F '\t' -v s="$1" '$1 == s { print $2 }' counts; }
is() { [ "$(counted "$1")" = "$2" ] || note "$1: $(counted "$1"), not $2"; }
cat >series.cfg <<'E2'
vary = ( { F1 = [ 2.0, 4.0 ]; }, { T = { from = 0.01; to = 1.0; count = 50; spacing = "log"; }; } );
want = ( { what = "series"; file = "series.tsv"; } );
E2
stats 0 series.cfg
is steady 0
is phases 0
is formulas 300
finish "a series-only scene solves no period"

cat >quadratic.cfg <<'E2'
vary = ( { F1 = [ 2.0, 4.0, 10.0 ]; }, { alpha = { from = 0.1; to = 0.9; count = 17; }; } );
want = ( { what = "steady"; file = "quadratic.tsv"; } );
E2
stats 0 quadratic.cfg
is steady 51
is root_iterations 0
is gait_evaluations 0
is samples 0
is trajectories 0
is certified 0
stats 0 "$scenes/figure4.cfg"
is root_iterations 0
is onsets 3
sed 's/^vary/crawler = { gait = "sinusoidal"; }; vary/' quadratic.cfg >curved.cfg
stats 0 curved.cfg
[ "$(counted root_iterations)" -gt 51 ] || note "a sinusoidal gait without root finding?"
finish "a quadratic scene does no root iteration, and a steady scene computes no samples"

cat >twice.cfg <<'E2'
vary = ( { F1 = [ 2.0, 4.0 ]; }, { T = { from = 0.1; to = 1.0; count = 10; spacing = "log"; }; } );
want = ( { what = "steady"; file = "a.tsv"; }, { what = "steady"; file = "b.tsv"; digits = 5; },
         { what = "error"; of = [ "text_steady_xC", "text_steady_velocity" ]; file = "c.tsv"; }, { what = "orders"; of = [ "text_steady_xC" ]; file = "d.tsv"; } );
E2
stats 0 twice.cfg
is steady 20
is formulas 40
is orders 2
is certified 0
finish "what is wanted twice is computed once"

cat >times.cfg <<'E2'
vary = ( { F1 = [ 2.0, 4.0, 8.0 ]; }, { T = { from = 0.01; to = 1.0; count = 40; spacing = "log"; }; } );
want = ( { what = "series"; source = "derived"; order = 12; file = "derived.tsv"; }, { what = "series"; source = "limit"; file = "limit.tsv"; } );
E2
stats 0 times.cfg
is expansions 3
is sums 960
is steady 0
sed 's/^vary.*/vary = ( { T = { from = 0.01; to = 1.0; count = 40; spacing = "log"; }; }, { F1 = [ 2.0, 4.0, 8.0 ]; } );/' times.cfg >turned.cfg
stats 0 turned.cfg
is expansions 3
[ "$(cells derived.tsv T F1 | head -n 2 | tr '\n' ';')" = "0.01 2;0.01 4;" ] || note "T is not outside: $(cells derived.tsv T F1 | head -n 2)"
cat >gaits.cfg <<'E2'
crawler = { gait = "trapezoidal:0.2,0.3"; };
vary = ( { T = { from = 0.1; to = 1.0; count = 100; }; } );
want = ( { what = "steady"; file = "gaits.tsv"; } );
E2
stats 0 gaits.cfg
is gaits 1
printf 'crawler = { gait = "minimum-jerk"; };\nvary = ( ( { gait = "quadratic"; } ), ( { T = [ 1.0, 9.0 ]; } ) );\nwant = ( { what = "steady"; file = "gaits.tsv"; } );\n' >some.cfg
stats 0 some.cfg
finish "what does not depend on T is not made anew for each T"

for accuracy in 1e-10 1e-12 1e-60 1e-200; do
  cat >digits.cfg <<E2
vary = ( { T = [ 0.1, 0.2, 0.3 ]; } );
want = ( { what = "error"; of = [ "derived_8.displacement" ]; accuracy = $accuracy; file = "digits.tsv"; } );
E2
  stats 0 digits.cfg
  echo "$accuracy $(counted certified) $(counted certified_digits)" >>costs
done
[ "$(cut -d ' ' -f 2 costs | tr '\n' ' ')" = "0 3 3 3 " ] || note "certified solutions: $(cat costs)"
cut -d ' ' -f 3 costs | sort -n -u -c >/dev/null 2>&1
[ "$(cut -d ' ' -f 3 costs)" = "$(cut -d ' ' -f 3 costs | sort -n -u)" ] || note "fewer digits do not cost less: $(cat costs)"
for digits in 17 18 40; do
  printf 'want = ( { what = "steady"; digits = %s; file = "digits.tsv"; } );\n' $digits >digits.cfg
  stats 0 digits.cfg
  [ "$(counted certified) $(counted steady)" = "$([ $digits -gt 17 ] && echo '1 0' || echo '0 1')" ] || note "$digits digits: $(cat counts)"
done
finish "fewer digits cost less, and doubles no certified arithmetic"

printf 'start = "steady";\nwant = ( { what = "trajectory"; file = "t.tsv"; periods = 3; samples = 10; }, { what = "phase"; file = "p.tsv"; } );\n' >start.cfg
stats 0 start.cfg
is steady 1
is phases 1
is samples 31
printf 'start = 1.0;\nwant = ( { what = "phase"; columns = [ "A_dT", "error.A_x1_switch", "A_x1_end_from_dT", "exact.A_x1_first_switch" ]; file = "p.tsv"; } );\n' >given.cfg
stats 0 given.cfg
is phases 2
printf 'want = ( { what = "breakdown"; only = "event"; file = "b.tsv"; } );\n' >command.cfg
stats 0 command.cfg
is commands 1
is steady 0
printf 'vary = ( { T = { from = "sticking_onset/4"; to = "sticking_onset"; count = 3; }; }, { F1 = [ 3.0, 5.0 ]; } );\nwant = ( { what = "phase"; columns = [ "sticking_onset" ]; file = "o.tsv"; } );\n' >onsets.cfg
stats 0 onsets.cfg
finish "starts, given switching times, onsets and commands"

memory() { # POINTS
  printf 'vary = ( { F1 = { from = 1.1; to = 9.0; count = %s; }; } );\nwant = ( { what = "steady"; file = "many.tsv"; }, { what = "trajectory"; periods = 1; samples = 1; file = "t.tsv"; } );\n' "$1" >many.cfg
  stats 0 many.cfg
  counted peak_memory_kB
}
few=$(memory 200) many=$(memory 20000)
[ "$many" -lt $((few + 600)) ] || note "200 points: $few kB, 20000: $many kB"
finish "memory does not grow with the number of points"

if [ -r /proc/self/maps ]; then
  printf 'want = ( { what = "steady"; } );\n' >light.cfg
  run 0 run light.cfg
  # the other program is not there: nothing that it is needed for
  cp "$tool" alone
  ./alone run light.cfg >out 2>err || note "a steady scene needs more than scallop: $(cat err)"
  printf 'want = ( { what = "steady"; digits = 30; } );\n' >heavy.cfg
  ./alone run heavy.cfg >out 2>err && note "certified digits without FLINT"
  grep -q '^scallop run: certified.froude needs FLINT' err || note "$(cat err)"
  finish "only what needs FLINT loads it"
fi
for columns in T froude,m1 displacement text_steady_xC error.text_steady_xC friction_work; do
  run 0 steady --F1 2:4:3 --columns $columns --stats
  cp err counts
  is points 3
  is rows 3
  case $columns in T | froude* | text*) is steady 0 ;; *) is steady 3 ;; esac
done
finish "steady computes what its columns ask for"
exit $failed
