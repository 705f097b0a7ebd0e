#!/bin/sh
# The main job: tables into data/, plots into BUILD/plots, and a summary. scripts/reproduce.sh BUILD
set -eu
build=$1
scallop=$build/scallop
sh scripts/tables.sh "$scallop" data
sh scripts/plots.sh data "$build/plots"

tab=$(printf '\t')
count() { # verdict inside
  grep -v '^#' data/claims.tsv | awk -F "$tab" -v v="$1" -v i="$2" '$10 == v && $12 == i' | wc -l
}
echo
echo "Tables in data/, plots in $build/plots/."
echo
echo "The paper's claims, each for both gaits (data/claims.tsv has them all):"
echo "  holds: the error falls as claimed; sharper: faster; refuted: slower, or not at all"
printf '  %-34s %6s %8s %8s %10s\n' "" holds sharper refuted undecided
for inside in yes no; do
  label="under the paper's conditions"
  [ $inside = yes ] || label="outside of them"
  printf '  %-34s %6d %8d %8d %10d\n' "$label" "$(count holds $inside)" "$(count sharper $inside)" \
    "$(count refuted $inside)" "$(count undecided $inside)"
done
echo
echo "How the error of the steady-state series scales with T (alpha > 1/2, F1 > F2):"
awk -F "$tab" '$12 == "yes" && ($1 == "text_steady_velocity" || $1 == "text_steady_xC") {
  printf "  %-13s %-6s %-11s claimed O(T^%s), measured T^%s: %s\n", $3, $2, $4, $5, $6, $10 }' data/claims.tsv
echo
echo "Refuted under the paper's own conditions:"
awk -F "$tab" '$12 == "yes" && $10 == "refuted" && $5 != "nan" && $5 > 0 {
  printf "  %-24s %-7s %-13s %-11s claimed O(T^%s), measured T^%s\n", $1, $2, $3, $4, $5, $6 }
  $12 == "yes" && $10 == "refuted" && $5 == "nan" { printf "  %s (section %s), %s:\n      %s\n", $1, $2, $4, $13 }' data/claims.tsv
