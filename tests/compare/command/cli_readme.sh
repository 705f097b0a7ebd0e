#!/bin/sh
# Every example of README.md and docs/ gives the output that they show. Usage: sh tests/compare/command/cli_readme.sh build/scallop
set -u
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# One numbered pair of files for each example: the command, and the output that is shown.
awk -v dir="$scratch" '
  /^```console$/ { inside = 1; next }
  /^```$/        { inside = 0 }
  inside && /^\$ / { n++; print substr($0, 3) > (dir "/" n ".cmd"); printf "" > (dir "/" n ".shown"); next }
  inside         { print > (dir "/" n ".shown") }' README.md docs/*.md docs/*/*.md
failed=0 count=0
for command in "$scratch"/*.cmd; do
  count=$((count + 1))
  sed "s|\bbuild/|$(dirname "$1")/|g" "$command" >"$scratch/run.sh" # outputs of examples go to the build, too
  sh "$scratch/run.sh" >"$scratch/got" 2>"$scratch/errors"
  if diff "${command%.cmd}.shown" "$scratch/got" >"$scratch/difference"; then
    printf 'ok readme: %s\n' "$(cat "$command")"
  else
    printf 'FAIL readme: %s\n' "$(cat "$command")"
    cat "$scratch/difference" "$scratch/errors"
    failed=1
  fi
done
[ "$count" -ge 35 ] || { echo "FAIL readme: only $count examples found"; failed=1; }
exit $failed
