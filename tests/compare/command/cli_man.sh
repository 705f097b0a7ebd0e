#!/bin/sh
# The pages of the manual, which scripts/dev/man.awk makes from --help, and the completion of bash, which asks --help.
# Usage: sh tests/compare/command/cli_man.sh build/scallop. One line for each check; non-zero if any failed.
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

says() { # PATTERN FILE
  grep -q -e "$1" "$2" || note "no '$1' in: $(head -n 3 "$2")"
}
refused() { # NAME PATTERN ARGUMENT...
  name=$1 pattern=$2
  shift 2
  run 2 "$@"
  says "$pattern" err
  [ "$(wc -l <err)" -eq 1 ] || note "scallop $*: $(wc -l <err) lines on standard error"
  [ ! -s out ] || note "scallop $* prints to standard output: $(head -n 1 out)"
  finish "$name"
}
help_options() { # FILE, as --help prints it: in "  --m1 M, --m2 M  masses" those before the text, without dashes
  awk '/^  --/ { sub(/^  /, ""); sub(/  .*/, ""); n = split($0, word, /,? /); for (i = 1; i <= n; i++) if (sub(/^--/, "", word[i])) print word[i] }' "$1"
}

# ---- the pages ----
run 0 --help
commands=$(sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p' out)
[ "$(echo "$commands" | wc -w)" -gt 8 ] || note "commands: $commands"
(cd "$root" && sh scripts/dev/man.sh "$tool" 1.0 "$scratch/pages") || note "man.sh fails"
for command in '' $commands; do
  page=scallop${command:+-$command}
  # shellcheck disable=SC2086
  run 0 --help $command
  mv out "$page"
  mv "pages/$page.1" .
  for section in NAME SYNOPSIS ${command:+DESCRIPTION OPTIONS} EXAMPLE '"SEE ALSO"'; do says "^\\.SH $section" "$page.1"; done
  [ -n "$(help_options "$page")" ] || note "no options in the help of $page"
  for option in $(help_options "$page"); do
    sed -n '/^\.TP$/{n;p}' "$page.1" | grep -q -F -e "\\fB\\-\\-$(printf %s "$option" | sed 's/-/\\-/g')\\fR" || note "$page.1 does not explain --$option"
  done
done
for command in $commands; do says "^\\\\fBscallop\\\\-$command.fR(1)" scallop.1; done
for code in 0 1 2 3 4; do says "^\\\\fB$code\\\\fR" scallop.1; done
finish "every page has its sections and options"

# Words, punctuation aside, so often as they are there
words() { tr -s ' ' '\n' | tr -d '`.,:;"' | tr '[:upper:]' '[:lower:]' | sed '/^$/d' | sort; }
for page in scallop*.1; do
  sed '1,2d; s/^Exit codes://' "${page%.1}" | words >told
  [ "$(wc -l <told)" -gt 80 ] || note "$(wc -l <told) words in the help of ${page%.1}"
  sed "s/\\\\f[BR]//g; s/\\\\(aq/'/g; s/\\\\(ha/^/g; s/\\\\(ti/~/g; s/\\\\&//g; s/\\\\-/-/g" "$page" | words | comm -23 told - >lost
  [ ! -s lost ] || note "$page: lost: $(head -n 5 lost | tr '\n' ' ')"
done
finish "no word of --help is lost in a page"

judged() { # NAME PROGRAM ARGUMENT...: complains of no page, but that it has no date
  name=$1
  shift
  if command -v "$1" >/dev/null 2>&1; then
    for page in scallop*.1; do
      "$@" "$page" 2>&1 </dev/null | grep -v 'missing date' >complaints
      [ ! -s complaints ] || note "$page: $(head -n 2 complaints)"
    done
    finish "$name"
  else
    echo "ok $name (skipped: there is no $1)"
  fi
}
judged "mandoc has nothing to complain of" mandoc -T lint -W warning
judged "groff has nothing to complain of" groff -ww -man -Tutf8 -z

# ---- what stands in place of a command ----
refused "--man says where the manual is" 'make install.*man scallop' --man steady
refused "--man=PAGE does so too" 'make install.*man scallop' --man=list
refused "--completion without a shell" 'takes .*bash' --completion
refused "--completion of another shell" "takes .*bash, and not 'zsh'" --completion zsh
refused "help: no such command or topic" "unknown command or topic 'stead': did you mean 'steady'" help stead
refused "help: a misspelt topic" "unknown command or topic 'colunms': did you mean 'columns'" --help colunms
refused "a topic in place of a command" "unknown command 'gaits': did you mean 'help gaits'" gaits
refused "--manual" "the command comes first" --manual
for command in $commands; do
  run 0 "$command" --help
  cmp -s out "scallop-$command" || note "help $command prints something else"
done
finish "help COMMAND"
if [ -c /dev/full ]; then
  "$tool" --completion bash >/dev/full 2>err
  code=$?
  [ $code = 4 ] || note "scallop --completion bash: exit code $code, not 4"
  finish "a full device"
fi

# ---- completion ----
run 0 --completion=bash
cp out completion.bash
cmp -s out "$root/scripts/dev/completion.bash" || note "--completion=bash prints something else than the file"
if command -v bash >/dev/null 2>&1; then
  cat >complete.bash <<'END'
eval "$(cat completion.bash)"
complete -p scallop | grep -q -e '-o default' || echo "no names of files"
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_scallop "$1" "${!#}"
echo "${COMPREPLY[*]-}"
END
  completes() { # WANTED WORD...: the last word is completed to these
    want=$1
    shift
    got=$(bash -u complete.bash "$tool" "$@" 2>&1)
    [ "$got" = "$want" ] || note "'$*' is completed to '$got', not to '$want'"
  }
  completes 'steady stress' st
  completes '--version' --v
  completes 'steady stress' help st
  completes 'order options' help o
  completes 'order' o
  completes '' help steady st
  completes '' nonsense --
  completes quadratic steady --gait q
  completes quadratic steady --gait = q
  completes 'quadratic sinusoidal trapezoidal skewed constant: minimum-jerk polynomial: measured:' steady --gait =
  completes 'tsv table' steady --T 1 --format t
  completes 'json junit' order errors.txt --format j
  completes 'm1/m2' breakdown --map m
  completes 'T' breakdown --map F1/F2 T
  completes 'dx1 dx2 dxC' claims --formula 1 --of dx
  completes '' steady --T 1
  completes '' steady --output s
  completes '' steady --certified s
  [ ! -e s ] || note "completion writes a file"
  completes '--gait' steady --T 1 --ga
  for command in $commands; do
    options=$(help_options "scallop-$command" | sed 's/^/--/' | tr '\n' ' ')
    completes "${options% }" "$command" --
  done
  finish "completion: commands and options; the rest is left to the names of files"
else
  echo "ok completion (skipped: there is no bash)"
fi
exit $failed
