#!/bin/sh
# docs/reference/commands.md from the pages of help: commands.sh PROGRAM
set -eu
pages=$(mktemp -d)
trap 'rm -rf "$pages"' EXIT
files=
for group in Topics Commands; do
  for name in $("$1" --help | sed -n "/^$group:/,/^\$/s/^  \([a-z][a-z]*\) .*/\1/p"); do
    "$1" --help "$name" >"$pages/$name"
    files="$files $pages/$name"
  done
done
"$1" --help >"$pages/scallop"
cat <<'END'
# Commands and options

`make docs` writes this page from the pages of `scallop help`.
[Examples](../guide/examples.md) shows each command in use.
END
# shellcheck disable=SC2086
awk -f scripts/dev/commands.awk "$pages/scallop" $files
