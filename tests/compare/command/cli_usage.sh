#!/bin/sh
# What the command line refuses, with which exit code and message, and what it leaves behind.
# Usage: sh tests/compare/command/cli_usage.sh build/scallop. One line for each check; non-zero if any failed.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"
keep_counts_apart
input=/dev/null

run() { # CODE ARGUMENT...
  wanted=$1
  shift
  "$tool" "$@" <"$input" >out 2>err
  code=$?
  [ "$code" = "$wanted" ] || note "scallop $* gives exit code $code, not $wanted"
}
says() { # PATTERN FILE
  grep -q -e "$1" "$2" || note "no '$1' in: $(head -n 3 "$2")"
}
# A refusal is one line on standard error that names the tool, and nothing on standard output.
refuse() { # CODE PATTERN ARGUMENT...
  pattern=$2 wanted=$1
  shift 2
  run "$wanted" "$@"
  says "$pattern" err
  says '^scallop' err
  [ "$(wc -l <err)" -eq 1 ] || note "scallop $*: $(wc -l <err) lines on standard error"
  [ ! -s out ] || note "scallop $* prints to standard output: $(head -n 1 out)"
}
refused() { # NAME CODE PATTERN ARGUMENT...
  name=$1
  shift
  refuse "$@"
  finish "$name"
}
row() { sed '/^#/d' "$1" | sed -n "$(($2 + 1))p"; } # FILE N: the Nth row after the header
status_of() { row "$1" "$2" | awk -F '\t' '{ print $NF }'; }

commands='phase steady trajectory series claims order figure workprec'
takes_crawler='phase steady trajectory series'

# ---- help and version ----
run 2
[ ! -s out ] || note "it prints to standard output"
for command in $commands; do says "^  $command " err; done
finish "no arguments: the help on standard error, exit code 2"
run 0 --help
[ ! -s err ] || note "it prints to standard error"
for command in $commands; do says "^  $command " out; done
finish "--help lists every command"
cp out help
for way in -h help; do
  run 0 $way
  cmp -s out help || note "$way prints something else"
done
finish "-h and help are --help"
run 0 --version
grep -q -x 'scallop [0-9][0-9.]*\(-dev\)*' out || note "it prints $(cat out)"
finish "--version"

mkdir bin examples
ln -s "$tool" bin/scallop
printf '%s\n' 'h err' '1 1' '0.5 0.25' '0.25 0.0625' '0.125 0.015625' >examples/errors.txt
example() { # NAME: the example on the first line of out
  line=$(sed -n '1s/^Example: //p' out)
  if [ -z "$line" ]; then
    note "the first line is not an example: $(head -n 1 out)"
  else
    (cd examples && PATH="$scratch/bin:$PATH" sh -c "$line" >../out 2>../err) || note "'$line' fails: $(cat err)"
    case $line in
      *' -o '*) [ -s "examples/${line##* -o }" ] || note "'$line' writes no file" ;;
      *) [ -s out ] || note "'$line' prints nothing" ;;
    esac
  fi
  finish "$1"
}
cp help out
example "the example of --help runs"
for command in $commands; do
  run 0 $command --help
  [ ! -s err ] || note "it prints to standard error"
  says "^scallop $command" out
  for option in --format --output --quiet --help; do says "^  $option" out; done
  ! grep -q "(null)\| ()$" out || note "a default that is no value"
  cp out "help_$command"
  run 0 $command -h
  cmp -s out "help_$command" || note "-h prints something else"
  awk 'length > 100' out >wide
  [ ! -s wide ] || note "wider than 100: $(head -n 1 wide)"
  finish "$command --help"
  cp "help_$command" out
  example "the example of $command --help runs"
  # every option that the help lists is taken, and asks for its value
  for option in $(sed -n 's/^  \(--[A-Za-z0-9]*\) [A-Z].*/\1/p' "help_$command"); do
    refuse 2 "$option needs a value" $command "$option"
  done
  finish "$command: options without their value"
done

# ---- commands, options and operands ----
refused "unknown command with a near one" 2 "unknown command 'stead': did you mean 'steady'" stead
refused "unknown command, letters exchanged" 2 "did you mean 'trajectory'" trajectroy
refused "unknown command, nothing near" 2 "unknown command 'xyzzyqq'.*--help" xyzzyqq
grep -q 'did you mean' err && note "it suggests something: $(cat err)"
finish "no suggestion when nothing is near"
refused "empty command" 2 "unknown command ''" ''
refused "option before the command" 2 "the command comes first" --T 1
refused "unknown option with a near one" 2 "unknown option '--alfa': did you mean '--alpha'" steady --alfa 0.5
refused "unknown option with a near one, by =" 2 "did you mean '--points'" steady --poimts=x
for pair in stroke:L mass1:m1 mass2:m2 friction1:F1 friction2:F2 period:T; do
  refused "--${pair%:*}" 2 "unknown option '--${pair%:*}': did you mean '--${pair#*:}'" steady "--${pair%:*}" 1
done
refused "unknown option, nothing near" 2 "unknown option '--zzzzzzzzzz'.*steady --help" steady --zzzzzzzzzz 1
refused "option of another command: --phase" 2 "does not take the option '--phase'" steady --phase extension
refused "option of another command: --start" 2 "does not take the option '--start'" phase --start rest
refused "option of another command: --T of claims" 2 "does not take the option '--T'" claims --T 1
refused "option of another command: --tol" 2 "does not take the option '--tol'" figure 2 --tol 1
refused "one dash for two" 2 "'-T'" steady -T 1
refused "three dashes for two" 2 "---T" steady ---T 1
refused "-o without a file" 2 "needs a value" steady -o
refused "value for a flag" 2 "--quiet takes no value" steady --quiet=1
refused "value for a flag, empty" 2 "--quiet takes no value" steady --quiet=
for command in $takes_crawler claims; do
  refuse 2 "unexpected argument 'foo'" $command foo
done
refuse 2 "--expect and --at-least exclude each other" order a --expect 1 --at-least 1
refuse 2 "--rows: 'junit' is a format for verdicts" order a --rows --format junit
refuse 2 "--expect: '1/0'.*fraction" order a --expect 1/0
refuse 2 "--format: 'xml'.*tsv, json, csv, markdown, table, npy or junit" order a --format xml
refuse 2 "unexpected argument '3'" figure 2 3
refuse 2 "unexpected argument '-'" steady -
finish "unexpected operands"
refused "order without a file" 2 "argument is missing: scallop order FILE" order
refused "figure without a number" 2 "missing" figure
refused "figure 1 is a sketch" 2 "figure '1'.*2, 3, 4 or 5.*sketch" figure 1
refused "figure x" 2 "figure 'x'.*2, 3, 4 or 5" figure x
refused "figure ''" 2 "figure ''.*2, 3, 4 or 5" figure ''

for file in figure4.svg f.png ./f.pdf; do
  refuse 2 "--output: '$file' is not allowed here: .*the name of a table, not of a picture, which --plot draws" figure 4 -o "$file"
  refuse 2 "the name of a table, not of a picture" steady --output="$file"
  refuse 2 "the name of a table, not of a picture" run figure4 -o "$file"
  [ ! -e "$file" ] || note "$file is there"
done
finish "a table is not written under the name of a picture"

# ---- values ----
for command in $takes_crawler claims; do
  for name in m1 m2 F1 F2 L T alpha; do
    [ "$command $name" != "claims T" ] || continue
    allowed='> 0'
    [ $name != alpha ] || allowed='between 0 and 1'
    for value in nan inf -inf 0 -0 -1 '' text 1x '1 ' 1e999 1e-400 '1;5'; do
      refuse 2 "--$name: '$value'.*$allowed" $command --$name "$value"
      [ "$command" = steady ] || [ "$value" != inf ] || break # every value on one command, two on the others
    done
    refuse 2 "--$name: '0'.*$allowed" $command --$name=0
    finish "$command --$name: values that are not allowed"
  done
done
for value in ' 1' '1 ' "$(printf '1\t')" ' '; do
  refuse 2 'without blanks' steady --T "$value"
  refuse 2 'without blanks' phase --v0 "$value"
  refuse 2 'without blanks' trajectory --start "$value"
done
run 2 steady --T "$(printf '\n1')"
refuse 2 'whole number' trajectory --periods ' 3'
refuse 2 '> 0; .*too small: below 2.2e-308' steady --T 1e-310
refuse 2 'excluded; .*too small: below 2.2e-308' steady --alpha 1e-400
refuse 2 '> 0; .*too large: no double is above 1.8e308' steady --T 1e309
refuse 2 "'1x' is not allowed here: it takes a finite number > 0\$" steady --T 1x
finish "blanks around a number, numbers beyond the doubles: the message says so"
for value in 0 1 -1 2 -0.5 1.0000000000000002; do
  refuse 2 "--alpha: '$value'.*between 0 and 1" steady --alpha $value
done
finish "--alpha outside of (0,1)"
for value in nan inf '' text 1x 1e999; do
  refuse 2 "--v0: '$value'.*finite number" phase --v0 "$value"
  refuse 2 "--v0: '$value'.*finite number" series --v0 "$value"
  refuse 2 "--start: '$value'.*rest, steady or a velocity" trajectory --start "$value"
  refuse 2 "--expect: '$value'.*finite number" order x --expect "$value"
  refuse 2 "--tol: '$value'.*finite number > 0" order x --tol "$value"
done
refuse 2 "--tol: '0'.*> 0" order x --tol 0
refuse 2 "--tol: '-1'.*> 0" order x --tol -1
finish "--v0, --start, --expect, --tol: values that are not allowed"
for value in foo Quadratic quad '' 1; do
  refuse 2 "--gait: '$value'.*quadratic, sinusoidal" steady --gait "$value"
  refuse 2 "--phase: '$value'.*extension or contraction" phase --phase "$value"
  refuse 2 "--format: '$value'.*tsv, json, csv, markdown, table or npy" steady --format "$value"
done
finish "--gait, --phase, --format: unknown words"
for name in periods samples; do
  for value in 0 -3 1.5 1e3 '' text 3x 1000000001 99999999999999999999; do
    refuse 2 "--$name: '$value'.*whole number from 1 to" trajectory --$name "$value"
  done
done
finish "--periods, --samples: values that are not allowed"
for value in 0 18 -1 2.5 '' all; do
  refuse 2 "--digits: '$value'.*whole number from 1 to 17" trajectory --digits "$value"
done
finish "--digits: values that are not allowed"
refused "--output without a name" 2 "--output: ''.*a file name" steady --output=
refused "--points without a name" 2 "--points: ''.*a file name" steady --points=
refused "claims wants F1 > F2" 2 "F1 > F2" claims --F1 1 --F2 1
refused "claims wants alpha > 1/2" 2 "alpha > 1/2" claims --alpha 0.5
for way in '--T=0.5' '--T 0.5' '--T 5e-1' '--T 0x1p-1' '--T +.5' '--T 7 --T 0.5'; do
  run 0 steady $way
  row out 1 >got
  [ -e first ] || cp got first
  cmp -s got first || note "'$way' gives $(cat got)"
done
finish "ways to write a value"
run 0 phase --v0 -1
cp out minus
run 0 phase --v0=-1
cmp -s out minus || note "--v0=-1 is not --v0 -1"
finish "a negative velocity is a value, not an option"

# ---- scaling and overflow ----
run 3 steady --T 1e200 --m1 1e-300
says 'out of range' out
says 'could not be solved' err
finish "steady: scaling overflows"
run 3 phase --T 1e200 --m1 1e-300
says 'out of range' out
finish "phase: scaling overflows"
for command in trajectory series; do
  refuse 3 'out of range' $command --T 1e200 --m1 1e-300
done
finish "trajectory, series: scaling overflows"
run 3 steady --L 1e300 --T 1e-10
says 'out of range' out
finish "steady: L/T^2 overflows"
run 3 phase --v0 1.7e308 --T 2
says 'out of range' out
finish "phase: the displacement overflows"
run 3 trajectory --start 1e308 --periods 3 --samples 1
finish "trajectory: the position overflows"

# ---- files ----
: >empty.tsv
mkdir folder
printf 'T\nab\000c\n' >nul_row.tsv
printf 'T\000\n1\n' >nul_header.tsv
printf '1 1\n0.5 0.\00025\n' >nul.txt
dd if="$tool" of=binary bs=2000 count=1 2>/dev/null
printf 'foo\tbar\n1\t2\n' >unknown.tsv
printf 'T\talpha\tT\n1\t0.5\t2\n' >twice.tsv
printf '# only\n\n# comments\n' >comments.tsv
for command in phase steady series; do
  refuse 4 "cannot read nowhere.tsv: No such file" $command --points nowhere.tsv
  refuse 4 "folder.*[Dd]irectory" $command --points folder
  finish "$command --points: a file that cannot be read"
  refuse 2 "empty.tsv.*no header" $command --points empty.tsv
  refuse 2 "comments.tsv.*no header" $command --points comments.tsv
  finish "$command --points: an empty file"
  refuse 2 "nul_header.tsv:1:.*not a text file" $command --points nul_header.tsv
  refuse 2 "binary:1:.*not a text file" $command --points binary
  finish "$command --points: a binary file"
  refuse 2 "unknown.tsv:1:.*m1 m2 F1 F2 L T alpha gait" $command --points unknown.tsv
  finish "$command --points: no known column"
  refuse 2 "twice.tsv:1:.*'T'.*twice" $command --points twice.tsv
  finish "$command --points: a column that is there twice"
  printf 'T\n' | "$tool" $command --points - >out 2>err || note "exit code $?: $(cat err)"
  [ "$(sed '/^#/d' out | wc -l)" -eq 1 ] || note "not only a header: $(cat out)"
  finish "$command --points: only a header"
done
unread() { # NAME CODE PATTERN ARGUMENT...: one line on standard error, and a row of the table
  name=$1 wanted=$2 pattern=$3
  shift 3
  run "$wanted" "$@"
  says "$pattern" err
  [ "$(wc -l <err)" -eq 1 ] || note "scallop $*: $(wc -l <err) lines on standard error"
  [ "$(cells out verdict)" = error ] || note "scallop $*: $(tail -n 2 out)"
  finish "$name"
}
unread "order: no such file" 4 "cannot read nowhere.txt: No such file" order nowhere.txt
refused "a word that is nearly right" 2 "tsv, json, csv, markdown, table or npy: did you mean 'json'" steady --format jsn
unread "order: a directory" 4 "cannot read folder: Is a directory" order folder
unread "order: a binary file" 2 "binary:1:.*not a text file" order binary
unread "order: NUL in a row" 2 "nul.txt:2:.*not a text file" order nul.txt
unread "order: an empty file" 2 "empty.tsv: no data" order empty.tsv
unread "order: only comments" 2 "comments.tsv: no data" order comments.tsv
table() { printf '%b' "$1" >table.txt; }
table 'h err\n'
unread "order: only a header" 2 "table.txt.*no data" order table.txt
table 'a b\n1 1\n'
unread "order: no such column" 2 "table.txt:2:.*--y: there is no column 'err'" order table.txt --y err
unread "order: no such x" 2 "table.txt:2:.*--x: there is no column '3'" order table.txt --x 3
unread "order: x as y" 2 "table.txt:2:.*--y: this column is x" order table.txt --x b --y b
table 'a b\n1 x\n'
unread "order: no column of numbers" 2 "table.txt:2:.*no column of numbers" order table.txt
table 'h err value\n1 1 1\n'
unread "order: err and value" 2 "table.txt:2:.*not two" order table.txt
table 'h h err\n1 2 1\n'
unread "order: h twice" 2 "table.txt:2:.*'h' is there twice" order table.txt
table '1 1\n0.5\n'
unread "order: a truncated row" 2 "table.txt:2:.*columns" order table.txt
table '# c\nh err\n1 1\n0.5 1 1\n'
unread "order: a row too long" 2 "table.txt:4:.*columns" order table.txt
table 'h err\n0,1 0,011\n'
unread "order: decimal commas" 2 "table.txt:2: 3 columns, and 2 above: .* decimal points" order table.txt
table 'h;err\n0.1;0.011\n'
unread "order: semicolons" 2 "table.txt:2: ';' separates no columns" order table.txt
table 'h err\n1.0D-1 1.1D-2\n'
unread "order: exponents of Fortran" 2 "column 1: '1.0D-1' is not a number: an exponent begins with e" order table.txt
table 'h L2 H1\n1 1 1\n'
unread "order: no column of that name" 2 "there is no column 'L3': there are h L2 H1\|did you mean 'L2'" order table.txt --y L3
table '1 1\n0.5 x\n'
unread "order: a cell that is no number" 2 "table.txt:2:.*not a number" order table.txt
table '1 1\n0.5 0.25z\n'
unread "order: a number with something behind" 2 "table.txt:2:.*not a number" order table.txt

# ---- rows of points ----
printf 'T\talpha\n0.5\t0.6\n2\t0.7\n' >plain.tsv
"$tool" steady --points plain.tsv >plain.out
same() { # NAME FILE: gives what plain.tsv gives
  run 0 steady --points "$2"
  cmp -s out plain.out || note "another table: $(row out 1)"
  finish "$1"
}
printf 'T\talpha\r\n0.5\t0.6\r\n2\t0.7\r\n' >other.tsv
same "points: CRLF" other.tsv
printf '# a\n\nT\talpha\n# b\n0.5\t0.6\n\n#c\n2\t0.7\n# d\n' >other.tsv
same "points: comments and empty lines" other.tsv
printf 'T\talpha\n0.5\t0.6\n2\t0.7' >other.tsv
same "points: no newline at the end" other.tsv
printf 'name\talpha\tstatus\tT\n\303\251\t0.6\tok\t0.5\n\t0.7\tx\t2\n' >other.tsv
run 0 steady --points other.tsv
cut -f 1-8,10- out >kept
cmp -s kept plain.out || note "another table: $(row kept 1)"
finish "points: other columns, another order"
printf '\357\273\277T\talpha\n0.5\t0.6\n2\t0.7\n' >other.tsv
same "points: a byte order mark" other.tsv
input=plain.tsv
run 0 steady --points -
cmp -s out plain.out || note "another table: $(row out 1)"
input=/dev/null
finish "points: standard input"
printf '1 1\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n' >square.txt
"$tool" order --rows square.txt | cut -f 2- >square.out
input=square.txt
run 0 order - --expect 2
says 'pass' out
input=/dev/null
finish "order: standard input"
printf '1\t1\r\n0.5\t0.25\r\n0.25\t0.0625\r\n0.125\t0.015625\r\n' >other.txt
run 0 order --rows other.txt
cut -f 2- out | cmp -s - square.out || note "another table: $(cat out)"
printf '# c\n\n 1   1\n0.5 0.25\n# d\n0.25\t0.0625\n0.125 0.015625' >other.txt
run 0 order --rows other.txt
cut -f 2- out | cmp -s - square.out || note "another table: $(cat out)"
finish "order: CRLF, tabs, comments, no newline at the end"

printf 'T\tgait\n0.5\tsinusoidal\n1\tfoo\n1\tquadratic\n' >gaits.tsv
run 3 steady --points gaits.tsv
says '1 of 3 points' err
[ "$(row out 1 | cut -f 8)" = sinusoidal ] || note "gait of row 1: $(row out 1)"
[ "$(row out 3 | cut -f 8)" = quadratic ] || note "gait of row 3: $(row out 3)"
[ "$(status_of out 1)$(status_of out 3)" = okok ] || note "rows 1 and 3 are not ok"
status_of out 2 >status
says "line 3: gait: 'foo'.*quadratic, sinusoidal" status
finish "points: the gait column"

{
  printf 'T\talpha\tF1\n'
  printf '%s\t%s\t%s\n' 0.5 0.6 3 -1 0.6 3 0.5 1 3 0.5 0.6 nan 0.5 0.6 '' 0.5 0.6 2
  printf '0.5\n0.5\t0.6\t3\t9\nab\000c\t1\t1\n0.5\t0.6\t1e999\n0.5\t0.6\t2\n'
} >bad.tsv
for command in phase steady series; do
  run 3 $command --points bad.tsv
  says '8 of 11 points' err
  [ "$(sed '/^#/d' out | wc -l)" -eq 12 ] || note "$(sed '/^#/d' out | wc -l) lines"
  sed '/^#/d' out | awk -F '\t' 'NR == 1 { n = NF } NF != n { print "line " NR " has " NF " columns, not " n }' >uneven
  [ ! -s uneven ] || note "$(cat uneven)"
  n=0
  for expected in '^ok$' "^line 3: T: '-1'.*> 0" "^line 4: alpha: '1'.*between 0 and 1" "^line 5: F1: 'nan'.*finite" \
    "^line 6: F1: ''.*finite" '^ok$' '^line 8: 1 column.* 3' '^line 9: 4 columns.* 3' '^line 10: this is not a text file' \
    "^line 11: F1: '1e999'.*finite" '^ok$'; do
    n=$((n + 1))
    status_of out $n >status
    says "$expected" status
  done
  finish "$command: bad rows are named, the others go on"
done
run 3 steady --points bad.tsv --quiet
says '8 of 11 points' err
finish "--quiet keeps errors"
printf 'phase\tv0\nextension\t1\nsideways\t1\ncontraction\tx\ncontraction\t2\n' >phases.tsv
run 3 phase --points phases.tsv
status_of out 2 >status
says "line 3: phase: 'sideways'.*extension or contraction" status
status_of out 3 >status
says "line 4: v0: 'x'.*finite number" status
[ "$(status_of out 1)$(status_of out 4)" = okok ] || note "rows 1 and 4 are not ok"
finish "points: the columns phase and v0"
printf 'T\tm1\n1e200\t1e-300\n1\t1\n' >overflow.tsv
run 3 steady --points overflow.tsv
status_of out 1 >status
says 'out of range' status
[ "$(status_of out 2)" = ok ] || note "row 2 is not ok"
finish "points: a row that overflows"
run 4 steady --points nowhere.tsv -o folder/new.tsv
run 2 steady --points twice.tsv -o folder/new.tsv
run 2 steady --T bad -o folder/new.tsv
[ -z "$(ls folder)" ] || note "left behind: $(ls folder)"
finish "a run that is refused writes nothing"

# ---- output ----
refused "-o into a missing folder" 4 "cannot write nowhere/x.tsv: No such file" steady -o nowhere/x.tsv
refused "-o onto a directory" 4 "cannot write folder: Is a directory" steady -o folder
echo keep >kept
cp kept original
untouched() { # NAME CODE ARGUMENT...
  name=$1
  shift
  run "$@" -o kept
  cmp -s kept original || note "the output changed"
  cp original kept
  finish "the output stays: $name"
}
untouched "a bad value" 2 steady --T bad
untouched "a bad option after -o" 2 steady -o kept --bogus
untouched "no such file" 4 steady --points nowhere.tsv
untouched "a bad header" 2 steady --points twice.tsv
untouched "trajectory overflows" 3 trajectory --T 1e200 --m1 1e-300
untouched "series overflows" 3 series --T 1e200 --m1 1e-300
untouched "no such figure" 2 figure 1
untouched "claims of a wrong crawler" 2 claims --F1 1 --F2 1
cp original kept
(trap '' XFSZ && ulimit -f 1 && exec "$tool" trajectory --periods 100 -o kept) 2>err
[ $? = 4 ] || note "not exit code 4"
says 'cannot write kept' err
cmp -s kept original || note "the output changed"
finish "the output stays: the disk is full"
cp original kept
timeout -s TERM 0.2 "$tool" trajectory --periods 20000 -o kept 2>err
[ $? = 124 ] || note "it ended before it could be killed"
cmp -s kept original || note "the output changed"
for left in kept.*; do
  [ ! -e "$left" ] || note "left behind: $left"
  rm -f "$left"
done
finish "a killed run leaves nothing behind"
timeout -s HUP 0.1 sh -c 'trap "" HUP; exec "$1" trajectory --periods 1500 -o hangup.tsv' sh "$tool" 2>err
[ -s hangup.tsv ] || note "it ended by a signal that was to be ignored"
finish "a run under nohup outlives the terminal"
mkfifo pipe
(timeout 2 cat pipe >/dev/null &)
timeout 2 "$tool" steady -o pipe 2>err
[ -p pipe ] || note "the named pipe was replaced by a file"
finish "-o does not replace what is no plain file"
find . -name '*.part' >parts
[ ! -s parts ] || note "left behind: $(cat parts)"
finish "no *.part file is left"

("$tool" trajectory --periods 10000 2>err; echo $? >code) | head -n 1 >/dev/null
[ "$(cat code)" = 4 ] || note "exit code $(cat code), not 4"
says 'cannot write standard output: Broken pipe' err
finish "a closed pipe"
"$tool" steady >&- 2>err
[ $? = 4 ] || note "not exit code 4"
says 'cannot write standard output' err
finish "closed standard output"
if [ -c /dev/full ]; then
  for arguments in phase steady trajectory series claims 'order square.txt' 'figure 2' \
    'steady --format json' 'steady --points bad.tsv'; do
    "$tool" $arguments >/dev/full 2>err
    code=$?
    [ $code = 4 ] || note "scallop $arguments: exit code $code, not 4"
    says 'cannot write standard output: No space' err
  done
  finish "a full device"
  for arguments in --help --version 'steady --help'; do
    "$tool" $arguments >/dev/full 2>err
    code=$?
    [ $code = 4 ] || note "scallop $arguments: exit code $code, not 4"
  done
  finish "a full device: --help and --version"
fi

# ---- found by reviewers ----
ln -s nowhere.tsv dangling
run 4 steady -o dangling
says 'dangling' err
[ -L dangling ] || note "the link was replaced"
[ ! -e nowhere.tsv ] || note "a file appeared behind the link"
finish "-o through a link to nothing"
# One table of quantities: what --help prints of them stands in the documents and in the Python module word for word
quantities() { help_of "$1" | sed -n '/^Quantities/,/^$/s/^  \([A-Za-z0-9_]*\)  *\(.*\) \[\(.*\)\]$/\1\t\2\t\3/p'; }
tab=$(printf '\t')
quantities run >all
[ "$(wc -l <all)" -ge 15 ] || note "run --help lists $(wc -l <all) quantities"
while IFS=$tab read -r name is unit; do
  grep -q -F -e "| \`$name\` | $is | $unit |" "$root/docs/scenes.md" || note "docs/scenes.md has no row for: $name $is [$unit]"
done <all
for command in steady phase; do
  quantities $command >some
  [ "$(wc -l <some)" -eq 6 ] || note "$command --help lists $(wc -l <some) quantities"
  while IFS=$tab read -r name is unit; do
    grep -q -e "^        $name  *$is \[$unit\]\$" "$root/scripts/python/scallop.py" || note "scallop.py says nothing like: $name $is [$unit]"
    grep -q -F -x -e "$name$tab$is$tab$unit" all || note "$command --help and run --help differ in $name"
  done <some
done
finish "quantities are described in the same words everywhere"
printf 'T\n0.1\n0.2\n' >points_of_series.tsv
run 0 series --points points_of_series.tsv
cp out series.tsv
run 0 series --points series.tsv
cmp -s out series.tsv || note "reading its own table gives another"
finish "series --points reads back what it printed"
printf 'T\tgain\twait\n0.5\t1\t2\n' >others.tsv
run 0 steady --points others.tsv
[ ! -s err ] || note "$(cat err)"
[ "$(cells out gain wait)" = '1 2' ] || note "$(cells out gain wait)"
finish "columns with names of their own are carried along"
printf 'T\tGait\n0.5\tquadratic\n' >slip.tsv
refused "a column that differs by case" 2 "did you mean 'gait'" steady --points slip.tsv
refused "claims --errors of nothing" 2 'no claim about an order' claims --errors nonsense
run 0 claims --errors rest_dT --gait quadratic
[ "$(sed '/^#/d' out | sed 1d | cut -f 1,4 | sort -u)" = "$(printf 'rest_dT\tquadratic')" ] || note "other rows: $(head -n 5 out)"
finish "claims --errors rest_dT --gait quadratic"
cp out named
run 0 claims --errors '(14)' --gait quadratic
[ "$(rows out)" = "$(rows named)" ] || note "(14) is not rest_dT: $(head -n 5 out)"
refuse 2 'of this equation there are A_x1_switch_from_times, A_x1_switch_collected' claims --errors '(A.17)'
finish "claims --errors of an equation"
run 3 claims --m1 1e-300 --m2 1e300
says 'out of range' err
finish "claims of a crawler that cannot be scaled"
run 4 steady --points "$(printf 'no\033[31mfile')"
grep -q 'no?\[31mfile' err || note "$(cat err)"
finish "no control character of a name reaches the terminal"
exit $failed
