#!/bin/sh
# Draws the figures from their tables, as SVG and PNG: scripts/plots.sh TABLES PLOTS
set -eu
tables=$1 plots=$2
mkdir -p "$plots"
for n in 2 3 4 5; do
  for terminal in svg png; do
    gnuplot -e "table='$tables/figure$n.tsv'; output_file='$plots/figure$n.$terminal'; kind='$terminal'" \
      scripts/plot_common.gp "scripts/plot_figure$n.gp"
  done
done
