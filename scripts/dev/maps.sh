#!/bin/sh
# Grids for plots, into MAPS: scripts/dev/maps.sh SCALLOP MAPS
set -eu
scallop=$1 maps=$2
mkdir -p "$maps"
# An even number of values: none at F1 = F2 or alpha = 1/2, where the modes are others. A region has the same number in all maps.
set --
for map in "froude_alpha froude alpha --x 0.01:100:90 --y 0.01:0.99:90" "ratio_froude F1/F2 froude --x 0.1:10:90 --y 0.003:100:90"; do
  name=${map%% *}
  # shellcheck disable=SC2086
  "$scallop" breakdown --map ${map#* } --source published --tol 1e-2 --digits 6 -o "$maps/map_${name}_grid.tsv"
  awk -f scripts/plots/map_labels.awk "$@" "$maps/map_${name}_grid.tsv" >"$maps/map_${name}_numbers.tsv"
  set -- "$@" "$maps/map_${name}_numbers.tsv"
done
