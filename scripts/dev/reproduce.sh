#!/bin/sh
# The main job: tables into data/, plots into BUILD/plots, and a summary. scripts/dev/reproduce.sh BUILD
# What is there is not made again: of each step BUILD/reproduced has a checksum of the programs, of what they read and of what they wrote, and the
# seconds that it took. On a terminal a line says which step is at work, and how long all of them will take.
set -eu
build=$1
scallop=$build/scallop made=$1/reproduced
mkdir -p "$made"
programs=$(cat "$scallop" "$build"/*.so 2>/dev/null | cksum)
[ -t 2 ] && quiet='' || quiet=--quiet

steps='' # that stress and workprec are none of: they take minutes, or are times
for scene in data/scenes/*.cfg; do
  name=${scene##*/} name=${name%.cfg}
  case $name in stress | workprec) ;; *) steps="$steps $name" ;; esac
done
files_of() { # STEP: what it reads, and what it writes
  case $1 in
    maps) echo scripts/dev/maps.sh scripts/plots/map_labels.awk "$build"/maps/* ;;
    plots) echo scripts/plots/*.* scripts/plots/plot/* data/*.tsv "$build"/maps/* "$build"/plots/* ;;
    report) echo scripts/report/* data/scenes/* data/*.tsv "$build"/plots/* "$build"/report/* ;;
    *) echo "data/scenes/$1.cfg" "data/$1.tsv" ;;
  esac
}
perform() { # STEP
  case $1 in
    maps) sh scripts/dev/maps.sh "$scallop" "$build/maps" ;;
    plots) sh scripts/plots/draw.sh data "$build/plots" "$build/maps" ;;
    report) /usr/bin/python3 scripts/report/report.py --tables data --plots "$build/plots" --scenes data/scenes --output "$build/report/index.html" ;;
    *) "$scallop" run "data/scenes/$1.cfg" --into data --no-plots ${quiet:+"$quiet"} ;;
  esac
}
# shellcheck disable=SC2046
checksum() { { echo "$programs" && cat $(files_of "$1") 2>&1; } | cksum; }
is_made() { [ "$(sed -n 1p "$made/$1" 2>/dev/null)" = "$(checksum "$1")" ]; }

# The seconds that the steps that are left took the last time; of those that never ran as many as the steps of this run did
seconds_left() { # SECONDS-SO-FAR STEPS-SO-FAR STEP...
  so_far=$1 count=$2
  shift 2
  for step in "$@"; do sed -n 2p "$made/$step" 2>/dev/null | grep . || echo new; done |
    awk -v mean="$((count > 0 ? so_far / count : -1))" '/new/ { if (mean < 0) unknown = 1; $1 = mean } { s += $1 } END { if (!unknown) print int(s + 0.5) }'
}
begun=$(date +%s) count=0 left=''
for step in $steps maps plots report; do # of which the last ones read what those before them write
  [ -z "$left" ] && is_made "$step" || left="$left $step"
done
# shellcheck disable=SC2086
set -- $left
all=$#
while [ $# -gt 0 ]; do
  step=$1 now=$(date +%s)
  about=$(seconds_left $((now - begun)) $count "$@")
  [ ! -t 2 ] || printf '\rreproduce: %d of %d: %s, %d s%s\033[K\n' $((count + 1)) $all "$step" $((now - begun)) "${about:+, about $about s left}" >&2
  is_made "$step" || perform "$step"
  { checksum "$step"; echo $(($(date +%s) - now)); } >"$made/$step"
  count=$((count + 1))
  shift
done

# Rows of the table of claims by the names of its columns: claims 'PROGRAM of awk, with the cells as c["claim"]'
claims() {
  grep -v '^#' data/claims.tsv | awk -F '\t' '
    NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
    { for (i = 1; i <= NF; i++) c[name[i]] = $i } '"$1"
}
echo
echo "Tables in data/, plots in $build/plots/, all of it on a page: $build/report/index.html"
echo
echo "The paper's claims (data/claims.tsv has their rows, and how each verdict is known; \`scallop claims --summary\` where each fails):"
"$scallop" claims --summary 2>&1 >/dev/null | sed 's/^/  /'
echo
echo "How the error of the steady-state series scales with T (alpha > 1/2, F1 > F2):"
claims 'c["paper_conditions"] == "yes" && (c["claim"] == "eq27_v_start" || c["claim"] == "eq28_displacement") {
  printf "  %-13s %-6s %-11s claimed O(T^%s), derived T^%s: %s (%s)\n", c["quantity"], c["equation"], c["gait"], c["claimed_order"],
    c["derived_order"], c["verdict"], c["evidence"] }'
echo
echo "Error against run time (data/workprec.tsv, from one run of \`scallop workprec\`; displacement): how many times as long as the"
echo "exact solver the cheapest general-purpose method takes, and the cheapest simulation; - where no setting got there"
awk -f scripts/plots/cheapest.awk data/workprec.tsv | awk -F '\t' '
  function times(x) { return x == "nan" ? "-" : x }
  BEGIN { printf "  %-11s %7s %10s %10s %10s %18s\n", "gait", "T", "to 1e-2", "to 1e-6", "to 1e-12", "simulation to 1e-2" }
  $3 == "displacement" && $4 == "1e-2" { first = times($16); simulated = times($19) }
  $3 == "displacement" && $4 == "1e-6" { second = times($16) }
  $3 == "displacement" && $4 == "1e-12" { printf "  %-11s %7s %10s %10s %10s %18s\n", $1, $2, first, second, times($16), simulated }'
echo
echo "Refuted under the paper's own conditions:"
claims 'c["paper_conditions"] == "yes" && c["verdict"] == "refuted" && c["derived_order"] != "-" {
  printf "  %-24s %-7s %-13s %-11s claimed %s, derived T^%s (%s); right: %s\n", c["claim"], c["equation"], c["quantity"], c["gait"],
    c["claimed_order"] == "inf" ? "equality" : "O(T^" c["claimed_order"] ")", c["derived_order"], c["evidence"], c["corrected"] }
  c["paper_conditions"] == "yes" && c["verdict"] == "refuted" && c["derived_order"] == "-" {
  printf "  %s (%s%s), %s, %s:\n      %s\n", c["claim"], c["equation"] ~ /^\(/ ? "" : "section ", c["equation"], c["gait"], c["conditions"], c["summary"] }'
