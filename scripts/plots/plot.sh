#!/bin/sh
# Draws a table of the tool, in TSV, with gnuplot. plot/request.awk says what is in the environment. Exit code 2 where what is asked is not in the
# table, else 4, with a message. No text of the table or of the request is run by sh, awk or gnuplot.
[ -n "${PLOT_request-}" ] || for file in "${0%/*}"/plot/*.awk "${0%/*}"/common.gp "${0%/*}"/figure*.gp; do # the tool hands them over
  part=${file##*/}
  export "PLOT_${part%.*}=$(cat "$file")"
done
say() { printf 'scallop %s: %s\n' "${PLOT_command-plot.sh}" "$1" | LC_ALL=C command -p tr '\001-\011\013-\037\177' '[?*]' >&2; }
fail() {
  say "cannot draw $PLOT_file: $2"
  exit "$1"
}
command -v gnuplot >/dev/null || fail 4 "gnuplot is not installed (Debian: gnuplot-nox); the tables are written"
[ -r "$PLOT_table" ] || fail 4 "cannot read the table $PLOT_table"
program=$(LC_ALL=C awk "$PLOT_request
  $PLOT_gnuplot
  $PLOT_panels
  $PLOT_curves
  $PLOT_dots
  $PLOT_order
  $PLOT_reach
  $PLOT_workprec
  $PLOT_map
  $PLOT_boundaries" <"$PLOT_table" 2>&1) || fail $? "$(printf '%s\n' "$program" | tail -n 1)"
export LC_ALL=C.UTF-8 # in another locale gnuplot complains of the UTF-8 in texts
code=0
said=$(printf '%s\n' "$program" | gnuplot -d 2>&1) || code=$?
# A script of the user is told of what gnuplot warns of, too.
[ $code = 0 ] && [ -z "${PLOT_script-}" ] || printf '%s\n' "$said" | sed -n 's/^[ ^]*\([^ ^]\)/gnuplot: \1/p' | head -n 20 | while read -r text; do say "$text"; done
[ $code = 0 ] || fail 4 "gnuplot has failed"
[ -s "$PLOT_output" ] || fail 4 "gnuplot has drawn nothing"
