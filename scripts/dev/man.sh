#!/bin/sh
# The manual from what --help prints, a page for each command and one for all: man.sh PROGRAM VERSION FOLDER
# The page of a command ends with the topics that its help names.
set -eu
rm -rf "$3" "$3.part"
mkdir -p "$3.part"
for command in scallop $("$1" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p'); do
  page=scallop-$command
  [ "$command" != scallop ] || page=scallop
  pages=
  for name in "$command" $("$1" --help "$command" | grep -o 'scallop help [a-z][a-z]*' | sort -u | sed 's/.* //'); do
    "$1" --help "$name" >"$3.part/$name.help"
    pages="$pages $3.part/$name.help"
  done
  # shellcheck disable=SC2086
  awk -v page="$page" -v version="scallop $2" -f scripts/dev/man.awk $pages >"$3.part/$page.1"
done
rm "$3.part"/*.help
mv "$3.part" "$3"
