#!/bin/sh
# Draws the pictures of the tables in TABLES, and of the grids that scripts/dev/maps.sh wrote to MAPS, as SVG and PNG in PLOTS:
# scripts/plots/draw.sh TABLES PLOTS MAPS
set -eu
tables=$1 plots=$2 maps=$3
mkdir -p "$plots"
for name in figure2 figure3 figure4 figure5 errors workprec stress map_regimes map_reach map_velocity \
  found_order found_zero found_peak found_froude found_alpha found_sign; do
  for kind in svg png; do
    [ "$name" != workprec ] || {
      PLOT_of=workprec PLOT_table=$tables/workprec.tsv PLOT_file=workprec.$kind PLOT_output=$plots/workprec.$kind sh scripts/plots/plot.sh
      continue
    }
    code=0
    gnuplot -d -e "table='$tables/$name.tsv'; tables='$tables'; work='$maps'; output_file='$plots/$name.$kind'; kind='$kind'" \
      scripts/plots/common.gp "scripts/plots/$name.gp" 2>"$plots/said" || code=$?
    grep -v -e '^$' -e 'no valid points' "$plots/said" >&2 || true # a method that has no answer in a panel is no news
    rm -f "$plots/said"
    [ $code = 0 ]
  done
done
