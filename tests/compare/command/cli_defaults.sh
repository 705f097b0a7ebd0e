#!/bin/sh
# The defaults that --help shows are those in force: with them given, a command prints the same table as without.
# Usage: sh tests/compare/command/cli_defaults.sh build/scallop. One line for each check; non-zero if any failed.
# shellcheck disable=SC2154
. "$(dirname "$0")/../../support/common.sh"

shown() { # COMMAND OPTION: what stands in the last brackets of its line, or nothing
  help_of "$1" | sed -n "s/^  --$2 .* (\([^()]*\))\$/\1/p"
}
options_of() { help_of "$1" | sed -n 's/^  --\([A-Za-z0-9_-]*\) .*/\1/p'; }
is() { # COMMAND OPTION TEXT
  [ "$(shown "$1" "$2")" = "$3" ] || note "$1 --$2: '$(shown "$1" "$2")' is shown, not '$3'"
}
same() { # the last table, and that of these arguments
  cp out without
  run 0 "$@"
  cmp -s out without || note "'$*' gives another table: $(diff without out | head -n 2 | cut -c 1-200)"
}

# Values: all that are one word and that the command of this kind takes, but for some
values() { # COMMAND EXCEPT
  for option in $(options_of "$1"); do
    value=$(shown "$1" "$option")
    case "$value" in '' | all | *' '*) continue ;; esac
    case " $2 " in *" $option "*) continue ;; esac
    printf ' --%s %s' "$option" "$value"
  done
}
holds() { # LEAST EXCEPT COMMAND ARGUMENT...: at least so many values, and they change nothing
  least=$1 given=$(values "$3" "$2")
  shift 2
  [ "$(printf %s "$given" | wc -w)" -ge $((2 * least)) ] || note "only$given are shown"
  run 0 "$@"
  # shellcheck disable=SC2086
  same "$@" $given
  finish "scallop $*: the values that --help shows"
}
printf 'h err\n1 1\n0.5 0.26\n0.25 0.066\n0.125 0.0166\n' >errors.txt
holds 11 '' phase
holds 9 '' steady
holds 12 '' trajectory
holds 10 order series
holds 2 '' order errors.txt --expect 2.05
if [ "${WITH_FLINT:-1}" = 0 ]; then
  exit $failed
fi
holds 10 source series --source derived
holds 7 '' claims --gait quadratic --errors rest_dT
holds 8 order breakdown --only event
holds 8 '' breakdown --only reach --source derived --quantity displacement
holds 2 '' stress --family ordinary --cases 2
run 0 claims --gait quadratic --errors rest_dT
grep -q "^# parameters: m1=$(shown claims m1) m2=$(shown claims m2) F1=$(shown claims F1) F2=$(shown claims F2) L=$(shown claims L) alpha=$(shown claims alpha)\$" out ||
  note "the head says $(grep '^# parameters' out)"
finish "claims: the values are those of the head"

# Words
for command in phase steady; do
  is $command digits 'as many as read back exactly; with --certified 30'
  run 0 $command --certified
  same $command --certified --digits 30
done
finish "--certified: its digits"
is claims gait 'both of the paper: quadratic and sinusoidal'
run 0 claims --errors rest_dT
[ "$(cells out gait | uniq | tr '\n' ' ')" = 'quadratic sinusoidal ' ] || note "gaits: $(cells out gait | uniq | tr '\n' ' ')"
finish "claims: its gaits"
is series v0 'the steady velocity of the phase; with --source derived only phases from rest'
run 0 steady
v_start=$(cells out v_start)
run 0 series
rows out | awk -F '\t' '$3 == "extension" && $1 !~ /^rest_/' >steady_velocity
run 0 series --v0 "$v_start"
rows out | awk -F '\t' '$3 == "extension" && $1 !~ /^rest_/' | cmp -s - steady_velocity || note "other rows"
[ -s steady_velocity ] || note "no rows"
run 0 series --source derived
[ "$(cells out start | sort -u | tr '\n' ' ')" = "rest steady " ] || note "it starts from $(cells out start | sort -u | tr '\n' ' ')"
finish "series: its start velocities"
is figure T "that of the figure's scene"
is run T "that of the scene"
is run digits "that of the scene"
printf 'crawler = { F1 = 3.5; T = 0.25; };\nwant = ( { what = "steady"; digits = 6; } );\n' >mine.cfg
run 0 run mine.cfg
[ "$(cells out F1 T)" = '3.5 0.25' ] || [ "$(grep -c 'F1=3.5 .*T=0.25' out)" = 1 ] || note "another crawler: $(head -n 5 out)"
grep -v '^# parameters' out >without
run 0 run mine.cfg --F1 3.5 --T 0.25 --digits 6 --format tsv
grep -v -e '^# parameters' -e '^# in place of what the scene says' out | cmp -s - without || note "another table"
finish "run: the values of the scene"

is breakdown phase 'with --v0 extension, else the steady state'
run 0 breakdown --v0 1 --only event
same breakdown --v0 1 --only event --phase extension
is breakdown v0 'with --phase 0'
run 0 breakdown --phase contraction --only event
same breakdown --phase contraction --only event --v0 0
run 0 breakdown --only reach --quantity displacement --source limit
[ "$(shown breakdown tol)" = "$(cells out tolerance | sed 's/^0\.1$/1e-1/; s/^0\.01$/1e-2/; s/^0\.001$/1e-3/; s/^0\.0001$/1e-4/; s/e-0/e-/' |
  tr '\n' ',' | sed 's/,$//; s/,/, /g'); with --map 1e-2, 1e-6" ] ||
  note "tolerances: $(shown breakdown tol), and $(cells out tolerance | tr '\n' ' ')"
few='--source limit --y 1:1:1'
# shellcheck disable=SC2086
run 0 breakdown --map alpha T $few
[ "$(header out | tr ' ' '\n' | sed -n 's/^T_\([0-9.e-]*\)_.*/\1/p' | tr '\n' ' ')" = '1e-2 1e-6 ' ] || note "columns: $(header out)"
x=$(shown breakdown x)
# shellcheck disable=SC2086
same breakdown --map alpha T $few --x "${x#*of alpha }"
# shellcheck disable=SC2086
same breakdown --map alpha T $few --quantity displacement
# shellcheck disable=SC2086
run 0 breakdown --map F1/F2 T $few
# shellcheck disable=SC2086
same breakdown --map F1/F2 T $few --x "${x%%;*}"
is breakdown T 'with --map 1'
run 0 breakdown --map alpha F1/F2 --x 0.6:0.6:1 --y 3:3:1 --source limit
same breakdown --map alpha F1/F2 --x 0.6:0.6:1 --y 3:3:1 --source limit --T 1
finish "breakdown: what is said of its phase, tolerances and maps"

is stress cases '1000; with --check 4, of phases 30, with --full 5000'
run 0 stress --family units --check
[ "$(cells out cases | sort -u)" = 4 ] || note "--check, steady states: $(cells out cases | sort -u)"
run 0 stress --family phase-boundaries --check
[ "$(cells out cases | sort -u)" = 30 ] || note "--check, phases: $(cells out cases | sort -u)"
[ "$(rows out | wc -l)" -gt 1 ] || note "one gait"
is stress T '1 where another parameter is given, else those of the cases'
is stress gait 'each in turn; of a single point quadratic'
run 0 stress --F1 3
same stress --F1 3 --T 1 --m1 "$(shown stress m1 | cut -d ' ' -f 1)" --alpha "$(shown stress alpha | cut -d ' ' -f 1)" --gait quadratic
is stress phase 'with --v0 extension, else the steady state'
run 0 stress --v0 1
same stress --v0 1 --phase extension
finish "stress: what is said of its cases and points"

is workprec T '1, 0.1, 0.01, 1e-3, 1e-4; with --quick 0.5, 0.01'
is workprec limit '1; with --quick 0.05'
run 0 workprec --quick --limit 0.001
[ "$(cells out T | uniq | tr '\n' ' ')" = '0.5 0.01 0.5 0.01 ' ] || note "T: $(cells out T | uniq | tr '\n' ' ')"
[ "$(cells out gait | uniq | tr '\n' ' ')" = 'quadratic sinusoidal ' ] || note "gaits: $(cells out gait | uniq | tr '\n' ' ')"
finish "workprec: its periods and gaits"
exit $failed
