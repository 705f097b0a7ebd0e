#!/bin/sh
# Draws the figures from their tables, as SVG and PNG: scripts/plots.sh TABLES PLOTS
set -eu
tables=$1 plots=$2
mkdir -p "$plots"
for name in figure2 figure3 figure4 figure5 errors; do
  for terminal in svg png; do
    gnuplot -e "table='$tables/$name.tsv'; output_file='$plots/$name.$terminal'; kind='$terminal'" \
      scripts/plot_common.gp "scripts/plot_$name.gp"
  done
done
