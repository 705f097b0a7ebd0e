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
