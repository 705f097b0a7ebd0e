#!/bin/sh
# steady --points in blocks: as row by row, whatever the number of rows, in constant memory.
# Usage: sh tests/compare/command/cli_points.sh build/scallop. One line for each check; non-zero if any failed.
. "$(dirname "$0")/../../support/common.sh"

python <<'END'
import random
random.seed(2024)
def spread(low, high):
    return math.exp(random.uniform(math.log(low), math.log(high)))
with open("points.tsv", "w") as f:
    print("m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", sep="\t", file=f)
    for i in range(5000):
        print(*("%.6g" % spread(1e-2, 1e2) for _ in range(5)), "%.*g" % (6 if i % 2 else 17, spread(1e-4, 1e1)),
              "%.6g" % random.uniform(0.02, 0.98), ("quadratic", "sinusoidal")[i % 2], sep="\t", file=f)
END
first() { head -n "$(($1 + 1))" points.tsv; } # N: the header and that many rows
all() { run 0 steady --points points.tsv "$@"; }
all
cp out table.tsv
rows table.tsv >rows.tsv
[ "$(wc -l <rows.tsv)" -eq 5000 ] || note "$(wc -l <rows.tsv) rows"
finish "5000 rows"

# ---- the same row by row ----
for n in 1 2 1023 1024 1025 2047 2048 2049 3333 5000; do
  sed "$((n + 1))!d" points.tsv >one.tsv
  read -r m1 m2 F1 F2 L T alpha gait <one.tsv
  run 0 steady --m1 "$m1" --m2 "$m2" --F1 "$F1" --F2 "$F2" --L "$L" --T "$T" --alpha "$alpha" --gait "$gait"
  rows out >single
  sed "$n!d" rows.tsv | cmp -s - single || note "row $n is $(sed "$n!d" rows.tsv), alone it is $(cat single)"
done
finish "rows are those of the options"
for n in 0 1 1023 1024 1025 2048; do
  first $n >some.tsv
  run 0 steady --points some.tsv
  rows out >some
  head -n $n rows.tsv | cmp -s - some || note "the first $n rows differ"
done
finish "0, 1, 1023, 1024, 1025 and 2048 rows"
for n in 1 2 1000 1023; do
  sed "2,$((n + 1))d" points.tsv >rest.tsv
  run 0 steady --points rest.tsv
  rows out >rest
  sed "1,${n}d" rows.tsv | cmp -s - rest || note "without the first $n rows the others differ"
done
finish "a row does not depend on its place"
[ "$(cut -f 8 rows.tsv | sort | uniq -c | tr -s ' \n' ' ')" = ' 2500 quadratic 2500 sinusoidal ' ] || note "$(cut -f 8 rows.tsv | sort | uniq -c)"
for gait in quadratic sinusoidal; do
  awk -v gait=$gait 'NR == 1 || $8 == gait' points.tsv | cut -f 1-7 >alike.tsv
  run 0 steady --points alike.tsv --gait $gait
  rows out >alike
  awk -v gait=$gait '$8 == gait' rows.tsv | cmp -s - alike || note "$gait: other rows"
done
finish "alternating gaits are those of two files"

# ---- rows without an answer ----
# The row's number among the points is its line - 1. All of the third block is refused.
awk -F '\t' -v OFS='\t' '
  NR == 1 { print; next }
  { row = NR - 1 }
  row == 1 || row == 1024 || row == 4999 { $6 = "-1" }
  row == 2 || row == 1025 || row == 5000 { $1 = "1e-300"; $6 = "1e200" }
  row == 700 { $8 = "walk" }
  row == 701 { print $1, $2; next }
  row == 702 { print $0, "more"; next }
  row == 703 { $7 = "1"; $2 = "x" }
  row == 704 { printf "%s\t%s\t", $1, $2; for (i = 0; i < 300; i++) printf "long"; print "\t1\t1\t1\t0.5\tquadratic"; next }
  row > 2048 && row <= 3072 { $5 = "inf" }
  { print }' points.tsv >broken.tsv
run 3 steady --points broken.tsv
cp out broken
grep -q -x 'scallop steady: 1035 of 5000 points could not be solved: the column .status. says why' err || note "$(cat err)"
rows broken >now
[ "$(wc -l <now)" -eq 5000 ] || note "$(wc -l <now) rows"
awk -F '\t' 'NR == FNR { whole[FNR] = $0; next } $17 == "ok" && $0 != whole[FNR] { print "row " FNR " changed"; exit }
  NF != 17 { print "row " FNR ": " NF " columns" }' rows.tsv now >changed
[ ! -s changed ] || note "$(head -n 3 changed)"
says() { # ROW STATUS
  [ "$(sed "$1!d" now | cut -f 17)" = "$2" ] || note "row $1: $(sed "$1!d" now | cut -f 17)"
}
for row in 1 1024 4999; do says $row "line $((row + 1)): T: '-1' is not allowed here: it takes a finite number > 0"; done
for row in 2 1025 5000; do says $row 'out of range: a scaled quantity overflows or underflows'; done
says 700 "line 701: gait: 'walk' is not allowed here: it takes quadratic, sinusoidal, trapezoidal, skewed, constant:R, minimum-jerk, polynomial:C1,C2,... or measured:FILE"
says 701 'line 702: 2 columns where the header has 8'
says 702 'line 703: 9 columns where the header has 8'
says 703 "line 704: m2: 'x' is not allowed here: it takes a finite number > 0"
says 704 "line 705: F1: '$(awk 'BEGIN { for (i = 0; i < 20; i++) printf "long" }')' is not allowed here: it takes a finite number > 0"
for row in 2049 2500 3072; do says $row "line $((row + 1)): L: 'inf' is not allowed here: it takes a finite number > 0"; done
for row in 3 1023 1026 2048 3073 4998; do says $row ok; done
[ "$(sed '1!d' now | cut -f 1-16)" = "$(printf 'nan\tnan\tnan\tnan\tnan\tnan\tnan\t-\tnan\tnan\tnan\tnan\tnan\tnan\t-\t-')" ] || note "$(sed '1!d' now)"
[ "$(sed '2!d' now | cut -f 1,6,8,9)" = "$(printf '1e-300\t1e+200\tsinusoidal\tnan')" ] || note "$(sed '2!d' now)"
finish "rows without an answer keep their place and their reason"

# ---- ways to write a file ----
same() { # NAME FILE
  run 0 steady --points "$2"
  cmp -s out table.tsv || note "another table"
  finish "$1"
}
sed 's/$/\r/' points.tsv >other.tsv
same "CRLF" other.tsv
awk 'NR % 7 == 1 { print "# a comment" } NR % 11 == 1 { print "" } { print }' points.tsv >other.tsv
same "comments and empty lines between blocks" other.tsv
printf '%s' "$(cat points.tsv)" >other.tsv
same "no newline at the end" other.tsv
"$tool" steady --points - <points.tsv >out 2>err || note "$(cat err)"
cmp -s out table.tsv || note "another table"
# shellcheck disable=SC2002
cat points.tsv | "$tool" steady --points - -o written.tsv 2>err || note "$(cat err)"
cmp -s written.tsv table.tsv || note "-o: another table"
finish "standard input, and -o"

tr '\n' '\r' <points.tsv >other.tsv
same "CR alone ends lines" other.tsv
sed '1s/m1\tm2/ m1\t"m2" /; 1s/alpha/alpha /' points.tsv >other.tsv
same "blanks and quotes around the names of columns" other.tsv

# ---- names of columns ----
misspelt() { # NAME PARAMETER
  printf '%s\tL\n0.5\t1\n' "$1" >named.tsv
  run 2 steady --points named.tsv
  grep -q "named.tsv:1: unknown column '$1': did you mean '$2'?" err || note "$1: $(cat err)"
}
misspelt alfa alpha
misspelt F_1 F1
misspelt M-2 m2
misspelt T_ T
misspelt GAIT gait
finish "names that nearly are a parameter's are refused"
printf 'T\tcase\tt\tt1\tmean_velocity\n0.5\t1\t2\t3\t4\n' >named.tsv
run 0 steady --points named.tsv
grep -q -x 'scallop steady: note: named.tsv:1: these columns are not carried along, as their names are taken or empty: mean_velocity' err || note "$(cat err)"
[ "$(header out | cut -d ' ' -f 8-12)" = 'gait case t t1 froude' ] || note "$(header out)"
run 0 steady --points named.tsv --quiet
[ ! -s err ] || note "--quiet: $(cat err)"
for table in steady phase trajectory series claims breakdown; do
  "$tool" $table >named.tsv 2>err
  "$tool" steady --points named.tsv >out 2>err
  ! grep 'did you mean' err >found || note "$table: $(cat found)"
done
finish "columns whose names are taken are named on standard error"

# ---- files without an end, and files that would be lost ----
ends() { # CODE MESSAGE ARGUMENT...: within the time, and with the message
  wanted=$1 message=$2
  shift 2
  timeout 20 "$tool" "$@" >out 2>err </dev/null
  code=$?
  [ $code = "$wanted" ] || note "scallop $*: exit code $code: $(head -n 1 err)"
  grep -q "$message" err || note "scallop $*: $(head -n 1 err)"
}
ends 2 '/dev/zero:1: this is not a text file' steady --points /dev/zero
ends 2 '/dev/zero:1: this is not a text file' order /dev/zero
ends 2 '/dev/zero:1: this is not a text file' steady --gait measured:/dev/zero
{ printf 'T\n'; head -c 3000000 /dev/zero | tr '\0' 1; } >long.tsv
ends 4 'cannot read long.tsv: a line has more than a million characters' steady --points long.tsv
grep -q 'line 2: this line is too long: more than a million characters' out || note "$(tail -n 1 out)"
{ printf '\357\273\277T\t'; head -c 3000000 /dev/zero | tr '\0' x; } >long.tsv
ends 2 'long.tsv:1: this line is too long' steady --points long.tsv
{ printf 'T\n'; head -c 20000 /dev/zero | tr '\0' 0; echo 1; } >long.tsv
ends 3 '1 of 1 points' steady --certified --points long.tsv
grep -q 'this one has more than 10100 characters' out || note "$(tail -n 1 out | cut -c 1-300)"
yes '1 1' | timeout 20 "$tool" order - >out 2>err
grep -q 'standard input:1000001: more than a million rows' err || note "order: $(cat err)"
finish "input without an end is refused"
# ---- JSON, digits ----
run 3 steady --points broken.tsv --format json
cp out json
python <<'END'
objects, table = [json.loads(l) for l in open("json")], read("broken")
if len(objects) != len(table):
    bad(len(objects), "objects")
for i, (o, r) in enumerate(zip(objects, table)):
    if list(o) != list(r):
        bad("row", i + 1, "keys", list(o))
    for key, value in o.items():
        text = r[key]
        if not (text == "nan" if value is None else text == value if isinstance(value, str) else float(text) == value):
            bad("row", i + 1, key, "tsv", text, "json", value)
END
finish "json: the same values"
all --digits 6
rows out >short
python <<'END'
for i, (full, short) in enumerate(zip(open("rows.tsv"), open("short"))):
    for a, b in zip(full.rstrip("\n").split("\t"), short.rstrip("\n").split("\t")):
        try:
            a = "%.6g" % float(a)
        except ValueError:
            pass
        if a != b:
            bad("row", i + 1, a, "with 6 digits:", b)
END
finish "--digits rounds"

# ---- what a stream needs ----
python "$tool" <<'END'
import resource, subprocess
row = "1.76118\t3.04491\t3.89392\t7.67186\t3.01854\t1.92624\t0.0761047\n"
def kilobytes(rows, text): # the peak of all children so far
    with open("many.tsv", "w") as f:
        f.write("m1\tm2\tF1\tF2\tL\tT\talpha\n")
        f.writelines(text for _ in range(rows))
    subprocess.run([sys.argv[1], "steady", "--points", "many.tsv"],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
for text in row, "-" + row:
    few, many = kilobytes(3000, text), kilobytes(300000, text)
    if not many < few + 2000:
        bad("3000 rows:", few, "kB; 300000 rows:", many, "kB")
END
finish "memory does not grow with the rows"
(timeout 20 sh -c 'printf "T\n"; yes 0.5' 2>/dev/null | (timeout 20 "$tool" steady --points - 2>err; echo $? >code)) | head -n 5 >out
[ "$(wc -l <out)" -eq 5 ] || note "$(wc -l <out) lines"
[ "$(cat code)" = 4 ] || note "exit code $(cat code), not 4"
grep -q 'cannot write standard output: Broken pipe' err || note "$(cat err)"
finish "a closed pipe ends an endless input"
if [ -c /dev/full ]; then
  "$tool" steady --points points.tsv >/dev/full 2>err
  [ $? = 4 ] || note "not exit code 4"
  grep -q 'cannot write standard output: No space' err || note "$(cat err)"
  finish "a full device"
fi
python "$tool" <<'END'
import os, pty, select, subprocess, time
try:
    master, slave = pty.openpty()
except OSError: # a container without /dev/pts
    sys.exit(0)
p = subprocess.Popen([sys.argv[1], "steady", "--points", "-"], stdin=subprocess.PIPE, stdout=slave, stderr=subprocess.DEVNULL)
os.close(slave)
seen = b""
def wait_for(lines):
    global seen
    end = time.time() + 20
    while seen.count(b"\n") < lines and time.time() < end and select.select([master], [], [], 20)[0]:
        seen += os.read(master, 65536)
    if seen.count(b"\n") != lines:
        bad(seen.count(b"\n"), "lines where", lines, "are due")
for i, text in enumerate(("T\n", "0.5\n", "2\n", "-1\n", "1\n")):
    p.stdin.write(text.encode())
    p.stdin.flush()
    wait_for(3 + i)
p.stdin.close()
if p.wait() != 3:
    bad("exit code", p.returncode)
END
finish "on a terminal each row appears when it is there"
exit $failed
