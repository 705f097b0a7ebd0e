#!/bin/sh
# The main job: tables into data/, plots into BUILD/plots, and a summary. scripts/dev/reproduce.sh BUILD
set -eu
build=$1
scallop=$build/scallop
sh scripts/dev/tables.sh "$scallop" data
sh scripts/dev/maps.sh "$scallop" data "$build/maps"
sh scripts/plots/draw.sh data "$build/plots" "$build/maps"
/usr/bin/python3 scripts/report/report.py --tables data --plots "$build/plots" --scenes data/scenes \
  --output "$build/report/index.html"

# Rows of the ledger by the names of its columns: ledger 'PROGRAM of awk, with the cells as c["claim"]'
ledger() {
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
ledger 'c["inside"] == "yes" && (c["claim"] == "text_steady_velocity" || c["claim"] == "text_steady_xC") {
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
ledger 'c["inside"] == "yes" && c["verdict"] == "refuted" && c["derived_order"] != "-" {
  printf "  %-24s %-7s %-13s %-11s claimed %s, derived T^%s (%s); right: %s\n", c["claim"], c["equation"], c["quantity"], c["gait"],
    c["claimed_order"] == "inf" ? "equality" : "O(T^" c["claimed_order"] ")", c["derived_order"], c["evidence"], c["corrected"] }
  c["inside"] == "yes" && c["verdict"] == "refuted" && c["derived_order"] == "-" {
  printf "  %s (%s%s), %s, %s:\n      %s\n", c["claim"], c["equation"] ~ /^\(/ ? "" : "section ", c["equation"], c["gait"], c["conditions"], c["measured"] }'
