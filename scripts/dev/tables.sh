#!/bin/sh
# Writes the tables of data/ that take seconds into a folder, from their scenes: scripts/dev/tables.sh SCALLOP FOLDER
# map_reach, stress and workprec take minutes: `scallop run data/scenes/NAME.cfg --into data`.
set -eu
scallop=$1 folder=$2
mkdir -p "$folder"
set --
for scene in data/scenes/*.cfg; do
  case ${scene##*/} in
    map_reach.cfg | stress.cfg | workprec.cfg) ;;
    *) set -- "$@" "$scene" ;;
  esac
done
"$scallop" run "$@" --into "$folder" --no-plots --quiet
