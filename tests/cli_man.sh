#!/bin/sh
# The pages of the manual and the completion of bash: that they tell of every command, option and value, and are well made.
# Usage: sh tests/cli_man.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/common.sh"

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
help_options() { sed -n 's/^  --\([A-Za-z0-9-]*\) .*/\1/p' "$1"; } # FILE: as --help prints it

run 0 --help
commands=$(sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p' out)
for command in $commands; do
  run 0 "$command" --help
  cp out "help_$command"
done

# ---- the pages ----
mkdir man1
run 0 --man list
cp out pages
{ echo scallop; for command in $commands; do echo "scallop-$command"; done; } >wanted
cmp -s pages wanted || note "--man list gives $(tr '\n' ' ' <pages)"
finish "--man list: a page for each command, and one for all"
while read -r page; do
  run 0 --man "$page"
  [ ! -s err ] || note "it prints to standard error: $(head -n 1 err)"
  cp out "man1/$page.1"
  for section in NAME SYNOPSIS DESCRIPTION OPTIONS EXAMPLE 'EXIT STATUS' 'SEE ALSO'; do
    says "^\\.SH \"$section\"" out
  done
done <pages
finish "every page has its sections"
run 0 --man=scallop-steady
cmp -s out man1/scallop-steady.1 || note "--man=PAGE is another page"
run 0 --man steady
cmp -s out man1/scallop-steady.1 || note "a command's name is another page"
finish "--man=PAGE, --man COMMAND"
for command in $commands; do
  [ -n "$(help_options "help_$command")" ] || note "no options in the help of $command"
  for option in $(help_options "help_$command"); do
    says "^\\\\fB\\\\-\\\\-$(printf %s "$option" | sed 's/-/\\\\-/g')\\\\fR" "man1/scallop-$command.1"
  done
  sed -n '1s/^Example: //p' "help_$command" | sed 's/-/\\-/g' >example
  [ -s example ] || note "$command has no example"
  grep -q -x -F -f example "man1/scallop-$command.1" || note "the example of $command is missing"
  says "scallop.-$command.fR(1)" man1/scallop.1
done
finish "what --help lists of a command is in its page"
run 0 --help
for request in $(help_options out); do says "^\\\\fB\\\\-\\\\-$request\\\\fR" man1/scallop.1; done
for code in 0 1 2 3 4; do
  meaning=$(sed -n "s/^$code  //p" out | cut -d ';' -f 1)
  [ -n "$meaning" ] || note "--help does not tell what exit code $code is"
  while read -r page; do says "^$meaning" "man1/$page.1"; done <pages
done
finish "what --help says of all is in the pages"

# Words, punctuation aside, so often as they are there
words_of_help() { sed '1,3d; /^Options/,$d; s/Columns://g' "$1" | tr -s ' ' '\n' | tr -d '`.,:;' | sed '/^$/d' | sort; }
words_of_page() {
  sed "s/\\\\f[BIR]//g; s/\\\\(aq/'/g; s/\\\\(ha/^/g; s/\\\\&//g; s/\\\\-/-/g" "$1" | tr -s ' ' '\n' | tr -d '`.,:;' | sort
}
for command in $commands; do
  words_of_help "help_$command" >told
  [ "$(wc -l <told)" -gt 40 ] || note "$(wc -l <told) words in the help of $command"
  words_of_page "man1/scallop-$command.1" | comm -23 told - >lost
  [ ! -s lost ] || note "$command: lost: $(head -n 5 lost | tr '\n' ' ')"
done
finish "no word of --help is lost in a page"

judged() { # NAME PROGRAM ARGUMENT...: complains of no page
  name=$1
  shift
  if command -v "$1" >/dev/null 2>&1; then
    while read -r page; do
      "$@" "man1/$page.1" >complaints 2>&1 </dev/null
      [ ! -s complaints ] || note "$page: $(head -n 2 complaints)"
    done <pages
    finish "$name"
  else
    echo "ok $name (skipped: there is no $1)"
  fi
}
judged "mandoc has nothing to complain of" mandoc -T lint -W all
judged "groff has nothing to complain of" groff -ww -man -Tutf8 -z
awk 'length > 80 && !/^\./ { print FILENAME ": " $0 }' man1/*.1 >long
[ ! -s long ] || note "$(head -n 1 long)"
finish "no line of text is longer than 80 bytes"
if [ "$(MANPATH="$scratch" man -w scallop-steady 2>/dev/null)" = "$scratch/man1/scallop-steady.1" ]; then
  found=$(MANPATH="$scratch" man -w scallop steady)
  [ "$found" = "$scratch/man1/scallop-steady.1" ] || note "man scallop steady finds '$found'"
  finish "man scallop steady"
else
  echo "ok man scallop steady (skipped: man does not look for pages here)"
fi

# ---- what is refused ----
refused "--man without a page" '--man needs a page.*list' --man
refused "--man: no such page" "no page 'nonsense' (see scallop --man list)" --man nonsense
refused "--man: a page with a near name" "no page 'scallop-stead': did you mean 'steady'" --man scallop-stead
refused "--man: no name" "no page ''" --man=
refused "--completion without a shell" 'needs a shell: bash' --completion
refused "--completion of another shell" "'zsh' is not allowed here: it takes bash" --completion zsh
refused "help: no such command" "unknown command 'stead': did you mean 'steady'" help stead
refused "--manual" "the command comes first" --manual
for command in $commands; do
  run 0 help "$command"
  cmp -s out "help_$command" || note "help $command prints something else"
done
finish "help COMMAND"
if [ -c /dev/full ]; then
  for arguments in '--man steady' '--man list' '--completion bash'; do
    "$tool" $arguments >/dev/full 2>err
    code=$?
    [ $code = 4 ] || note "scallop $arguments: exit code $code, not 4"
  done
  finish "a full device"
fi

# ---- completion ----
run 0 --completion bash
cp out completion.bash
run 0 --completion=bash
cmp -s out completion.bash || note "--completion=bash prints something else"
finish "--completion=bash"

# Values that are known, COMMAND OPTION VALUE..., as the script has them
sed -n "s/^    '\\([a-z][a-z]* --[A-Za-z0-9-]*\\)') count=[12] values='\\(..*\\)' ;;\$/\\1 \\2/p" completion.bash |
  grep -v ' --[a-z]* FILE$' >known
[ "$(wc -l <known)" -gt 20 ] || note "$(wc -l <known) options with known values"
while read -r command option values; do
  for value in $values; do
    case $value in *: | *FILE) continue ;; esac
    set -- "$command" "$option" "$value"
    [ "$option" != --map ] || set -- "$@" "$value"
    run 2 "$@" --format nonsense
    says '^scallop [a-z]*: --format' err
  done
done <known
grep 'gait .*measured' completion.bash | head -n 1 | grep -o '[a-z-]*:' | while read -r gait; do
  "$tool" steady --gait "${gait%:}:" 2>&1 | grep -q -e "it takes ${gait%:}:" -e 'a file name' || echo "$gait"
done >unknown
[ ! -s unknown ] || note "gaits that there are not: $(cat unknown)"
finish "values that are completed are allowed"
offered() { sed -n "s/^breakdown $1 //p" known | tr ' ' '\n' | sort; } # OPTION
listed() { sed 's/.* takes //; s/ or /, /' err | tr ',' '\n' | tr -d ' ' | sort; }
for kind in --only --map; do
  run 2 breakdown $kind nonsense T
  [ "$kind" = --map ] || run 2 breakdown $kind nonsense
  listed >allowed
  offered $kind >given
  cmp -s allowed given || note "$kind takes $(tr '\n' ' ' <allowed), not $(tr '\n' ' ' <given)"
done
run 2 breakdown --quantity nonsense
listed >allowed
run 2 breakdown --quantity nonsense --v0 1
listed | sort - allowed >both
offered --quantity | cmp -s - both || note "--quantity takes $(tr '\n' ' ' <both)"
finish "all values that breakdown lists are completed"

if command -v bash >/dev/null 2>&1; then
  mkdir files files/folder
  touch files/a.cfg files/b.tsv 'files/my file.txt' files/folder/inside
  cat >complete.bash <<'END'
set -u
eval "$(cat "$1")"
cd "$2" || exit 1
# WORD... : what is completed is the last one, as bash parts the line
while IFS= read -r line; do
  IFS='~' read -r -a COMP_WORDS <<<"$line~end"
  unset 'COMP_WORDS[${#COMP_WORDS[@]}-1]'
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  if [[ ${COMP_WORDS[1]} == scenes ]]; then
    # shellcheck disable=SC2034
    _scallop_command() { options='--into' operand='FILE.cfg' most=9999; }
  fi
  _scallop
  printf '%s\n' "${COMPREPLY[@]+"${COMPREPLY[@]}"}" | sort | tr '\n' '~'
  echo
done
END
  completes() { # LINE WANTED, whose words are separated by ~
    printf '%s\n' "$1" | bash complete.bash completion.bash files >got 2>&1
    printf '%s\n' "$2" | tr '~' '\n' | sort | tr '\n' '~' >want
    [ "$(cat got)" = "$(cat want)" ] || note "'$1' is completed to '$(cat got)', not to '$(cat want)'"
  }
  everything=$(ls -p files | tr '\n' '~')
  everything=${everything%\~}
  completes 'scallop~st' 'steady~stress'
  completes 'scallop~--m' '--man'
  completes 'scallop~help~st' 'steady~stress'
  completes 'scallop~--man~sc' 'scallop'
  completes 'scallop~--man~=~se' 'series'
  completes 'scallop~--completion~' 'bash'
  completes 'scallop~nonsense~' ''
  completes 'scallop~--version~' ''
  finish "completion: commands, and what stands in place of one"
  for command in $commands; do
    wanted=$(for option in $(help_options "help_$command"); do printf -- '--%s~' "$option"; done)
    completes "scallop~$command~--" "${wanted%\~}"
  done
  finish "completion: the options of every command"
  gaits='minimum-jerk~measured:~polynomial:~quadratic~sinusoidal~skewed:~trapezoidal:'
  completes 'scallop~steady~--gait~' "$gaits"
  completes 'scallop~steady~--gait~=' "$gaits"
  completes 'scallop~steady~--gait~=~mi' 'minimum-jerk'
  completes 'scallop~steady~--gait=mi' '--gait=minimum-jerk'
  completes 'scallop~steady~--T~1~--format~' 'json~tsv'
  completes 'scallop~phase~--v0~-1~--phase~c' 'contraction'
  completes 'scallop~trajectory~--start~' 'rest~steady'
  completes 'scallop~steady~--T~' ''
  finish "completion: values"
  completes 'scallop~breakdown~--map~m' 'm1/m2'
  completes 'scallop~breakdown~--map~F1/F2~al' 'alpha'
  completes 'scallop~breakdown~--map~=~F1/F2~al' 'alpha'
  completes 'scallop~breakdown~--map=F1/F2~al' 'alpha'
  completes 'scallop~breakdown~--map~F1/F2~alpha~--bound' '--boundaries'
  finish "completion: two values"
  completes 'scallop~order~' "$everything"
  completes 'scallop~order~b' 'b.tsv'
  completes 'scallop~order~b.tsv~--q' '--quiet'
  completes 'scallop~order~b.tsv~b' ''
  completes 'scallop~order~--expect~2~b' 'b.tsv'
  completes 'scallop~figure~' '2~3~4~5'
  completes 'scallop~scenes~' 'a.cfg~folder/'
  completes 'scallop~scenes~a.cfg~' 'a.cfg~folder/'
  completes 'scallop~scenes~b' 'b.tsv'
  for command in $commands; do
    if grep -q "^scallop $command [A-Z]*\.cfg\.\.\. " "help_$command"; then
      completes "scallop~$command~a.cfg~" 'a.cfg~folder/'
    fi
  done
  finish "completion: operands"
  completes 'scallop~steady~-o~' "$everything"
  completes 'scallop~steady~--output~=~fo' 'folder/'
  completes 'scallop~steady~--output=fo' '--output=folder/'
  completes 'scallop~steady~--points~folder/' 'folder/inside'
  completes 'scallop~steady~-o~my\ f' 'my file.txt'
  completes 'scallop~steady~-o~"my f' 'my file.txt'
  completes 'scallop~steady~--gait~measured~:' "$everything"
  completes 'scallop~steady~--gait~=~measured~:~b' 'b.tsv'
  completes 'scallop~steady~--gait=measured:b' '--gait=measured:b.tsv'
  finish "completion: files"
else
  echo "ok completion (skipped: there is no bash)"
fi
exit $failed
