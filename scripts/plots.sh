#!/bin/sh
# Draws the figures from their tables, as SVG and PNG: scripts/plots.sh TABLES PLOTS MAPS, the last with what scripts/maps.sh wrote
set -eu
tables=$1 plots=$2 maps=$3
mkdir -p "$plots"
for name in figure2 figure3 figure4 figure5 errors workprec map_regimes map_reach map_velocity; do
  for terminal in svg png; do
    code=0
    gnuplot -e "table='$tables/$name.tsv'; tables='$tables'; work='$maps'; output_file='$plots/$name.$terminal'; kind='$terminal'" \
      scripts/plot_common.gp "scripts/plot_$name.gp" 2>"$plots/said" || code=$?
    grep -v -e '^$' -e 'no valid points' "$plots/said" >&2 || true # a method that has no answer in a panel is no news
    rm -f "$plots/said"
    [ $code = 0 ]
  done
done
