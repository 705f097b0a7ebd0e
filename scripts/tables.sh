#!/bin/sh
# Writes every table of data/ into a folder: scripts/tables.sh SCALLOP FOLDER
set -eu
scallop=$1 folder=$2
mkdir -p "$folder"
for n in 2 3 4 5; do
  "$scallop" figure "$n" --digits 12 -o "$folder/figure$n.tsv"
done
"$scallop" claims --digits 12 --quiet -o "$folder/claims.tsv"
