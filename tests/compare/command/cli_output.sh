#!/bin/sh
# What is left, said and returned where output fails or a run is killed: full disks, closed pipes, folders that cannot be written,
# signals. What fails below the command line has its tests in tests/compare/text/test_file.c.
# Usage: sh tests/compare/command/cli_output.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/../../support/common.sh"
keep_counts_apart

says() { # PATTERN FILE
  grep -q -e "$1" "$2" || note "no '$1' in: $(head -n 3 "$2")"
}
mkdir here # where tables go: nothing else is to be seen there
earlier() { # the folder as it was: one table
  rm -rf here/* && echo earlier >here/table
}
unchanged() { # WHAT: the folder is as it was
  [ "$(ls -A here)" = table ] || note "$1: in the folder: $(ls -A here | tr '\n' ' ')"
  [ "$(cat here/table)" = earlier ] || note "$1: the earlier file changed"
}
refuse() { # CODE PATTERN ARGUMENT...: one line on standard error, the folder as it was
  pattern=$2
  earlier
  code=$1
  shift 2
  run "$code" "$@"
  says "$pattern" err
  [ "$(wc -l <err)" -eq 1 ] || note "scallop $*: $(wc -l <err) lines on standard error"
  unchanged "scallop $*"
}
printf 'T\n0.5\n1\n' >points.tsv
awk 'BEGIN { print "T"; for (i = 0; i < 3000; i++) print 0.5 }' >many.tsv
printf '1 1\n0.5 0.25\n0.25 0.0625\n0.125 0.015625\n' >square.txt
# tables of more than a block of the disk
long='steady --points many.tsv|phase --points many.tsv|series --points many.tsv|trajectory --periods 100|figure 5'
each_long() { # FUNCTION: with the arguments of each
  IFS='|'
  for arguments in $long; do
    unset IFS
    # shellcheck disable=SC2086
    "$1" $arguments
    IFS='|'
  done
  unset IFS
}

# ---- names ----
run 0 steady
cp out want
for way in '-o -' '--output=-' '--output x -o -'; do
  run 0 steady $way
  cmp -s out want || note "'$way' prints something else"
done
[ ! -e - ] || note "there is a file called -"
run 0 steady -o ./-
cmp -s ./- want || note "./- is something else"
rm -f ./-
finish "-o -: standard output, and ./- is a file"
if [ -e /dev/stdout ]; then
  echo before >appended
  "$tool" steady -o /dev/stdout >>appended 2>err || note "exit code $?: $(cat err)"
  echo before | cat - want | cmp -s - appended || note "it holds $(head -n 2 appended)"
  finish "-o /dev/stdout adds to what standard output goes to"
fi
echo text >plain
refuse 4 'cannot write missing/x.tsv: No such file' trajectory --periods 10000 -o missing/x.tsv
refuse 4 'cannot write plain/x.tsv: Not a directory' trajectory --periods 10000 -o plain/x.tsv
refuse 4 'cannot write here: Is a directory' trajectory --periods 10000 -o here
refuse 4 'cannot write here/: Is a directory' trajectory --periods 10000 -o here/
finish "-o where there can be no file: refused before the work"
spared() { # FILE ARGUMENT...: reads FILE under the name both; both.svg is a link to it
  original=$1
  shift
  for output in '--output both' '-o ./both' '--plot both.svg'; do
    case $1$output in claims--plot* | order--plot* | run--plot*) continue ;; esac
    cp "$original" both
    timeout 20 "$tool" "$@" $output <both >out 2>err
    [ $? = 4 ] || note "scallop $* $output: not exit code 4"
    grep -q 'cannot write .*both.*: it is a file that this command reads: name another one$' err || note "scallop $* $output: $(cat err)"
    cmp -s both "$original" || note "scallop $* $output: the file is lost"
  done
  timeout 20 "$tool" "$@" <both >>both 2>err
  [ $? = 4 ] || note "scallop $* >>: not exit code 4"
  grep -q 'cannot write standard output: it is a file that this command reads' err || note "scallop $* >>: $(cat err)"
  cmp -s both "$original" || note "scallop $* >>: the file has grown"
}
ln -s both both.svg
printf '0 0\n1 1\n2 1.5\n4 0\n' >motion.txt
printf 'T gait\n1 measured:both\n' | tr ' ' '\t' >names.tsv
echo 'formulas = ( { name = "half"; start = "steady"; of = "v_start"; claimed = 1; text = "0"; } );' >mine.cfg
echo 'formulas = "both"; tables = ( { kind = "steady"; columns = [ "v_start", "half" ]; } );' >scene.cfg
echo 'tables = ( { kind = "steady"; columns = [ "v_start" ]; } );' >plain.cfg
spared many.tsv steady --points both
spared many.tsv steady --points -
spared points.tsv series --points both
spared square.txt order both
spared motion.txt trajectory --gait measured:both
spared mine.cfg run scene.cfg
spared plain.cfg run both
if [ "${WITH_FLINT:-1}" != 0 ]; then
  spared mine.cfg claims --formulas both
fi
cp motion.txt both
run 4 steady --points names.tsv -o both
grep -q 'cannot write both: it is a file that this command reads' err || note "a column of gaits: $(cat err)"
cmp -s both motion.txt || note "a column of gaits: the file is lost"
finish "a file that is read is not replaced or added to"

# ---- what is no plain file ----
mkfifo pipe
timeout 5 cat pipe >through &
run 0 steady -o pipe
wait $!
cmp -s through want || note "the reader got $(head -n 2 through)"
[ -p pipe ] || note "the pipe was replaced"
timeout 5 head -n 1 pipe >through &
run 4 trajectory --periods 10000 -o pipe
wait $!
says 'cannot write pipe: Broken pipe' err
finish "-o to a named pipe"
device() { # NAME MINOR: its path, of one of our own where the system's could be replaced, should that be what the tool does
  if [ ! -w /dev ]; then
    [ ! -c "/dev/$1" ] || echo "/dev/$1"
  elif mknod -m 666 "$1" c 1 "$2" && : >"$1"; then
    echo "$1"
  fi 2>err
}
null=$(device null 3) full=$(device full 7)
if [ -n "$null" ]; then
  run 0 steady -o "$null"
  [ -c "$null" ] || note "the device was replaced"
  finish "-o to a device"
fi
if [ -n "$full" ]; then
  onto_full() {
    "$tool" "$@" -o "$full" >out 2>err
    code=$?
    [ $code = 4 ] || note "scallop $*: exit code $code, not 4"
    says "cannot write $full: No space left on device" err
  }
  each_long onto_full
  onto_full steady
  onto_full order square.txt
  finish "-o to a full device"
fi

if [ -c /dev/full ]; then
  printf 'T\n-1\n1\n' >bad.tsv
  for arguments in phase steady trajectory series claims 'order square.txt' 'figure 2' 'steady --format json' 'steady --points bad.tsv' --help --version \
    'steady --help' '--completion bash'; do
    # shellcheck disable=SC2086
    "$tool" $arguments >/dev/full 2>err
    code=$?
    [ $code = 4 ] || note "scallop $arguments: exit code $code, not 4"
    case $arguments in *--help | --*) ;; *) says 'cannot write standard output: No space' err ;; esac
  done
  finish "standard output to a full device"
fi

# ---- a full disk: a limit to the size of files is one that everybody can have ----
too_large() {
  earlier
  (ulimit -f 1 && exec "$tool" "$@" -o here/table) >out 2>err
  code=$?
  [ $code = 4 ] || note "scallop $*: exit code $code, not 4"
  grep -q -x "scallop $1: cannot write here/table: File too large" err || note "scallop $*: $(cat err)"
  unchanged "scallop $*"
  rm -f here/table
  (ulimit -f 1 && exec "$tool" "$@" -o here/table) >out 2>err
  [ -z "$(ls -A here)" ] || note "scallop $*: left behind: $(ls -A here)"
}
each_long too_large
[ ! -f "$(dirname "$tool")/scallop-flint.so" ] || {
  too_large claims --errors all --gait quadratic --quiet
  too_large breakdown --map F1/F2 alpha --x 1.5:60:16 --y 0.55:0.9:16 --source published --quiet
}
(ulimit -f 1 && exec "$tool" trajectory) >grown 2>err
[ $? = 4 ] || note "to standard output: not exit code 4"
grep -q -x 'scallop trajectory: cannot write standard output: File too large' err || note "to standard output: $(cat err)"
finish "a disk that is full: the earlier table stays"

# ---- standard input, output and error ----
closed() {
  "$tool" "$@" >&- 2>err
  code=$?
  [ $code = 4 ] || note "scallop $*: exit code $code, not 4"
  says 'cannot write standard output: Bad file descriptor' err
}
each_long closed
closed steady
closed order square.txt
closed --version
finish "standard output that is closed"
broken() { # the reader is gone before the first line
  { sleep 0.05; "$tool" "$@" 2>err; echo $? >code; } | :
  [ "$(cat code)" = 4 ] || note "scallop $*: exit code $(cat code), not 4"
  [ "$(cat err)" = "scallop $1: cannot write standard output: Broken pipe" ] || note "scallop $*: $(cat err)"
}
broken steady
broken trajectory
broken steady --points many.tsv
{ "$tool" trajectory --periods 10000 --quiet 2>err; echo $? >code; } | head -n 1 >out
[ "$(wc -l <out)" -eq 1 ] || note "$(wc -l <out) lines"
[ "$(cat code)" = 4 ] || note "exit code $(cat code), not 4"
says 'Broken pipe' err
"$tool" --help | grep -q '^ *4 .*| head' || note "--help does not say so"
finish "a closed pipe is a failed write: exit code 4 and one line"
for arguments in 'steady --points -' 'order -'; do
  earlier
  # shellcheck disable=SC2086
  "$tool" $arguments -o here/table <&- >out 2>err
  code=$?
  [ $code = 4 ] || note "scallop $arguments: exit code $code, not 4"
  says 'cannot read standard input: Bad file descriptor' err
  case $arguments in
    order*) [ "$(cells here/table verdict)" = error ] || note "$(cat here/table)" ;; # a report names what could not be read
    *) unchanged "scallop $arguments" ;;
  esac
done
finish "standard input that is closed"
earlier
"$tool" steady -o here/table 2>&- || note "exit code $?"
cmp -s here/table want || note "another table"
earlier
(ulimit -f 1 && exec "$tool" trajectory -o here/table) 2>&-
[ $? = 4 ] || note "a full disk: not exit code 4"
unchanged "a full disk"
{ sleep 0.05; "$tool" steady -o missing/table 2>&1 >/dev/null; echo $? >code; } | :
[ "$(cat code)" = 4 ] || note "it is a closed pipe: exit code $(cat code), not 4"
finish "standard error that is closed"
python "$tool" <<'END'
# The table would get what is written there.
import os, subprocess, time
def close():
    os.close(1)
    os.close(2)
p = subprocess.Popen([sys.argv[1], "steady", "--points", "-", "-o", "here/table"], stdin=subprocess.PIPE, preexec_fn=close)
p.stdin.write(b"T\n" + b"1\n" * 3000)
p.stdin.flush()
time.sleep(0.1)
for place in 1, 2:
    try:
        found = os.readlink("/proc/%d/fd/%d" % (p.pid, place))
    except OSError as e:
        found = "closed" if os.path.exists("/proc/self") else "/"
    if found != "/":
        bad("descriptor", place, "is", found)
p.kill()
p.wait()
END
finish "no file takes the place of a closed standard output or error"

# ---- while the table is written ----
begins() { # starts a table onto here/table, which is begun when it returns; writing to descriptor 3 goes on with it
  earlier
  rm -f feed
  mkfifo feed
  env --default-signal=HUP "$tool" steady --points feed -o here/table >out 2>err & # under nohup HUP is ignored
  child=$!
  exec 3>feed
  cat many.tsv >&3
  sleep 0.1
}
begins
rm here/table && mkdir here/table
exec 3>&-
wait $child
[ $? = 4 ] || note "a folder in its place: not exit code 4"
says 'cannot write here/table: Is a directory' err
[ "$(ls -A here)" = table ] || note "in the folder: $(ls -A here)"
begins
rm -r here
exec 3>&-
wait $child
[ $? = 4 ] || note "the folder is removed: not exit code 4"
says 'cannot write here/table: No such file' err
mkdir here
finish "what happens to the folder meanwhile"
for s in HUP:129 TERM:143 KILL:137; do # what a script has in the background ignores SIGINT
  begins
  kill -s "${s%:*}" $child
  wait $child 2>/dev/null
  code=$?
  exec 3>&-
  [ $code = "${s#*:}" ] || note "$s: exit code $code"
  case $s in
    KILL*) rm here/table.scallop-?????? || note "SIGKILL leaves something else: $(ls -A here)" ;;
  esac
  unchanged "$s"
done
finish "a signal leaves the earlier table and nothing else; SIGKILL leaves table.scallop-XXXXXX"
timeout -s HUP 0.1 sh -c 'trap "" HUP; exec "$1" trajectory --periods 1500 -o hangup.tsv' sh "$tool" 2>err
[ -s hangup.tsv ] || note "it ended by a signal that was to be ignored"
finish "a run under nohup outlives the terminal"
begins
"$tool" steady -o here/table || note "exit code $?"
"$tool" steady | cmp -s - here/table || note "another table"
exec 3>&-
wait $child || note "exit code $?"
"$tool" steady --points many.tsv | cmp -s - here/table || note "another table at last"
[ "$(ls -A here)" = table ] || note "in the folder: $(ls -A here)"
finish "two programs that write one file: the last one's table, and whole"

# ---- the part that needs FLINT ----
mkdir bin
cp "$tool" bin/scallop
part=bin/scallop-flint.so
cannot() { # PATTERN
  earlier
  bin/scallop claims -o here/table >out 2>err
  code=$?
  [ $code = 3 ] || note "exit code $code, not 3"
  says "$1" err
  [ "$(wc -l <err)" -eq 1 ] || note "$(wc -l <err) lines on standard error"
  unchanged claims
}
echo 'no library' >$part
cannot 'the table of claims needs FLINT: .*/bin/scallop-flint.so: file too short'
rm $part
mkdir $part
cannot 'the table of claims needs FLINT: .*/bin/scallop-flint.so: cannot read file data: Is a directory'
rmdir $part
cannot 'the table of claims needs FLINT, and there is no scallop-flint.so in .*/bin/ or ../lib/scallop: '
for version in 'int other;' 'const char *const flint_part[] = { "0.1" };'; do
  echo "$version" | "${CC:-cc}" -shared -fPIC -x c -o $part - || note "no shared object is made of $version"
  case $version in
    int*) cannot 'the table of claims needs FLINT: .*/bin/scallop-flint.so: undefined symbol: flint_part' ;;
    *) cannot 'the table of claims needs FLINT, and .*/bin/scallop-flint.so belongs to scallop 0.1$' ;;
  esac
done
finish "a scallop-flint.so that cannot be loaded"
real=$(dirname "$tool")/scallop-flint.so
if [ -f "$real" ]; then
  mkdir -p root place/bin place/lib/scallop
  cp "$real" place/lib/scallop
  cp "$tool" place/bin
  ln -s ../place/bin/scallop bin/link
  bin/link steady --certified >out 2>err || note "exit code $?: $(cat err)"
  says 'ok$' out
  finish "scallop-flint.so is found in ../lib/scallop, through a link"
  for file in "$tool" "$real"; do
    cp "$file" root/
    for library in $(ldd "$file" 2>/dev/null | sed -n 's|^[^/]*\(/[^ ]*\) (0x.*|\1|p'); do
      mkdir -p "root${library%/*}" && cp -L "$library" "root$library"
    done
  done
  if chroot root "/$(basename "$tool")" --version >out 2>err; then
    chroot root "/$(basename "$tool")" phase --certified >out 2>err || note "exit code $?: $(cat err)"
    says 'ok$' out
  fi
  finish "scallop-flint.so is found without /proc"
  for arguments in claims 'workprec --quick' 'steady --certified --digits 10000 --T 1e-30 --gait sinusoidal'; do
    earlier
    # shellcheck disable=SC2086
    timeout -s INT 0.1 "$tool" $arguments -o here/table 2>err
    code=$?
    [ $code = 124 ] || note "scallop $arguments: exit code $code"
    unchanged "scallop $arguments"
  done
  finish "Ctrl-C in what needs FLINT leaves nothing"
fi
exit $failed
