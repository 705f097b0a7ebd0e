#!/bin/sh
# The pictures of the pages that show no table of data/: docs/model.png; docs/reference/gaits.png, l' of each family of gaits;
# docs/background/phase.png, the line and the curves of docs/background/theory.md in a steady state that slides and in one that sticks.
#     scripts/plots/pages.sh SCALLOP
set -eu
scallop=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
gnuplot -d -e "file='docs/model.png'" scripts/plots/model.gp

printf 't l\n0 0\n1 1.1\n2 3.4\n3 4.1\n4 5.9\n5 8.2\n6 10\n7 7.4\n8 3.1\n9 0.6\n10 0\n' >"$work/recording"
number=0
for gait in quadratic sinusoidal trapezoidal:0.2,0.3 skewed:0.25 constant:0.05 polynomial:0,3,-2 minimum-jerk "measured:$work/recording"; do
  number=$((number + 1))
  "$scallop" trajectory --gait "$gait" --L 1 --T 1 --alpha 0.6 --start rest --periods 1 --samples 2000 --columns t,speed=v2-v1 --quiet >"$work/gait$number"
done
gnuplot -d -e "work='$work'" scripts/plots/gaits.gp

curves() { # NAME T: time, c and the two curves in the steady state; and c at the changes of mode within a phase
  "$scallop" trajectory --T "$2" --start steady --periods 1 --samples 4000 \
    --columns "part=t/T,c=(m1*v1+m2*v2)/(m1+m2),of_1=m2*(v2-v1)/(m1+m2),of_2=-m1*(v2-v1)/(m1+m2)" --quiet >"$work/$1"
  "$scallop" steady --T "$2" --columns motion --quiet | grep -o ' to [0-9.]*' | cut -d ' ' -f 3 |
    awk -v T="$2" -F '\t' 'FNR == NR { if ($1 != 0.75*T && $1 != T) at[++n] = $1/T; next } $1 !~ /^[#a-z]/ { while (i < n && $1 >= at[i + 1]) { i++; print $1 "\t" $2 } }' - "$work/$1" >"$work/$1.changes"
}
curves slides 1
curves sticks 5
gnuplot -d -e "work='$work'" scripts/plots/phase.gp
