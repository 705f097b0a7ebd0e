#!/bin/sh
# docs/reference/commands.md from what --help prints: commands.sh PROGRAM
set -eu
cat <<'END'
# Commands and options

`make docs` writes this page from `scallop --help` and `scallop COMMAND --help`.
[Examples](../guide/examples.md) shows each command in use.
END
for command in '' $("$1" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p'); do
  printf '\n## scallop%s\n\n```text\n' "${command:+ $command}"
  # shellcheck disable=SC2086
  "$1" --help $command
  printf '```\n'
done
