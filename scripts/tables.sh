#!/bin/sh
# Writes every table of data/ into a folder: scripts/tables.sh SCALLOP FOLDER
set -eu
scallop=$1 folder=$2
mkdir -p "$folder"
for n in 2 3 4 5; do
  "$scallop" figure "$n" --digits 12 -o "$folder/figure$n.tsv"
done
"$scallop" claims --digits 12 --quiet -o "$folder/claims.tsv"
# The quadratic gait only: its numbers do not depend on the library's sines.
"$scallop" claims --errors rest_dT,rest_v1_end,rest_xC_end,text_extension_xC_end,A_xC_end,text_steady_velocity,text_steady_xC \
  --gait quadratic --digits 12 -o "$folder/errors.tsv"
# Boundaries between regions of the same modes, and the mean velocity along a line that crosses them. Ten digits: to 12 the tables would
# depend on the library's logarithms.
"$scallop" breakdown --map froude alpha --boundaries --digits 10 --quiet -o "$folder/map_froude_alpha.tsv"
"$scallop" breakdown --map F1/F2 froude --x 0.1:10:41 --y 0.003:100:41 --boundaries --digits 10 --quiet -o "$folder/map_ratio_froude.tsv"
for F2 in 0.5 1 2; do
  "$scallop" breakdown --map F1/F2 T --F2 $F2 --x 1:10000:201 --y 1:1:1 --source published --tol 1e-2 --digits 8 --quiet -o "$folder/map_velocity_$F2.tsv"
  "$scallop" breakdown --map F1/F2 T --F2 $F2 --x 1:10000:51 --y 1:1.1:2 --boundaries --digits 10 --quiet -o "$folder/map_changes_$F2.tsv"
done
