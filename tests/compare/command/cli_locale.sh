#!/bin/sh
# The language of the user changes nothing: the command, the tests and make, without a locale and in one with a decimal comma.
# Usage: sh tests/compare/command/cli_locale.sh build/scallop
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"
build=$(dirname "$tool")
in_none() { env -u LC_ALL -u LANG "$@"; }
[ "$(in_german awk 'BEGIN { printf "%.1f", 0.5 }')" = 0,5 ] || note "there is no comma to find"
finish "a locale with a decimal comma"

cp "$root/scripts/plots/figure5.gp" own.gp # what gnuplot says of a script of the user is passed on
sed 's/script = "figure5"/script = "own.gp"/' "$root/data/scenes/figure5.cfg" >own.cfg
printf 'h error\n0.1 1e-2\n0.05 2.5e-3\n0.025 6.25e-4\n' >errors
everything() { # FOLDER COMMAND...: what scallop prints and draws, started by COMMAND
  mkdir "$1" && folder=$1
  shift
  {
    "$@" "$tool" order errors --expect 2 --format table
    "$@" "$tool" claims --formulas "$root/docs/short-formulas.cfg" --gait quadratic --quiet
    "$@" "$tool" steady --T 0.5,1,1.5 --plot "$folder/plot.svg"
    (cd "$folder" && "$@" "$tool" run ../own.cfg)
  } >"$folder/out" 2>&1
}
everything wanted env
[ "$(grep -c . wanted/out)" -gt 20 ] || note "it prints $(cat wanted/out)"
for language in none german; do
  everything $language in_$language
  diff -r wanted $language >difference || note "it differs: $(head -n 5 difference)"
  finish "scallop, $language: same bytes, same pictures"
  printf '#!/bin/sh\nexec env -u LC_ALL "%s" "$@"\n' "$tool" >scallop
  chmod +x scallop
  (cd "$root" && "in_$language" sh tests/compare/command/cli_order.sh "$scratch/scallop") >said || note "$(grep '^FAIL' said)"
  finish "cli_order.sh, $language"
  if [ -x "$build/test_plot" ]; then
    in_$language "$build/test_plot" >said 2>&1 || note "$(grep -m 1 FAILED said)"
    finish "test_plot, $language"
  fi
  half=$(cd "$root" && "in_$language" "${MAKE:-make}" -s B="$build" --eval 'half: ; @awk "BEGIN { printf \"%.1f\", 0.5 }"' half)
  [ "$half" = 0.5 ] || note "a half is $half"
  finish "recipes of make, $language"
done
exit $failed
