#!/bin/sh
# The manual from what --help prints, a page for each command and one for all: man.sh PROGRAM VERSION FOLDER
set -eu
rm -rf "$3" "$3.part"
mkdir -p "$3.part"
for command in '' $("$1" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p'); do
  page=scallop${command:+-$command}
  # shellcheck disable=SC2086
  "$1" --help $command | awk -v page="$page" -v version="scallop $2" -f scripts/dev/man.awk >"$3.part/$page.1"
done
mv "$3.part" "$3"
