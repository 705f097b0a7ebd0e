#!/bin/sh
# Large sweeps: on threads, as files of NumPy, sampled, in shards that are merged.
# Usage: sh tests/compare/command/cli_sweeps.sh build/scallop. One line for each check; non-zero if any failed.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

# ---- threads ----
while read -r arguments; do
  # shellcheck disable=SC2086
  "$tool" $arguments --threads 1 -o one.tsv 2>one.err
  code=$?
  [ $code = 0 ] || [ $code = 3 ] || note "$arguments gives exit code $code: $(cat one.err)"
  for threads in 2 3 7 64; do
    # shellcheck disable=SC2086
    run $code $arguments --threads $threads
    cmp -s out one.tsv || note "$threads threads: other rows of $arguments"
    cmp -s err one.err || note "$threads threads: $(cat err)"
  done
done <<'END'
steady --m1 0.5:2:70 --F1 2:6:71
steady --T 1e-3:1e3:2500:log --columns T,v_start,regime,modes,status,froude
steady --F1 1:3:1500 --gait quadratic,sinusoidal --alpha 0.5,0.7
steady --F1 1:3:700 --T 0.1:sticking_onset:5 --and --L 1e-300,1,2 --F1 1:3:600 --m1 1e300,1
steady --F1_over_F2 2,3 --froude 1:10:900 --label name=a
steady --F1 1:2:3000 --columns F1,c=F1*v_start --format json
steady --F1 1:2:3000 --columns F1,v_start --format table
steady --m1 1:2 --F1 1:3:log --sample sobol:3000 --T 0.1,1
steady --T 0.1,1 --m1 1:2 --F1 1:3:log --sample sobol:3000
steady --froude 1:2 --F1 1:3:log --sample random:3000:5
steady --T 0.1,0.2 --F1 1:4:9 --columns T,F1,certified.displacement --format markdown
phase --T 0.01:50:1500:log
trajectory --T 0.1:1:50 --start 0.3 --periods 2 --samples 7
series --T 1e-3:1:20 --columns T,eq27_v_start,derived_4.displacement
END
for threads in 0 -1 1.5 many 1025; do
  run 2 steady --threads $threads
  grep -q "^scallop steady: --threads: '$threads' is not allowed here: it takes a whole number from 1 to 1024" err || note "$(cat err)"
done
finish "rows and messages do not depend on the threads"

# ---- blocks ---- (with --stats points are computed one by one)
while read -r arguments; do
  # shellcheck disable=SC2086
  "$tool" steady $arguments --stats --threads 1 >one.tsv 2>one.err
  code=$?
  for threads in 1 2; do
    # shellcheck disable=SC2086
    run $code steady $arguments --threads $threads
    cmp -s out one.tsv || note "$arguments: $(diff out one.tsv | head -n 2)"
  done
done <<'END'
--m1 0.5:2:70 --F1 2:6:71
--T 1e-3:1e3:2500:log --alpha 0.5,0.3
--froude 0.01:100:2000:log --F1 1,2
--F1_over_F2 1:10:1500 --gait sinusoidal,quadratic
--gait quadratic,trapezoidal,minimum-jerk --F1 1:3:1100 --m2 2
--m1 1:2 --F1 1:100:log --T 0.01:10:log --alpha 0.1:0.9 --sample sobol:3000
--L 1e-300,1,2 --F1 1:3:600 --m1 1e300,1
--F1 1:9:1200 --F2 5 --alpha 0.5 --T 3
--T 0.1:sticking_onset:1100 --and --F1 1:2:7
END
finish "neighbours that are solved together give the rows that each gives alone"

# ---- files of NumPy ----
run 0 steady --m1 0.5:2:70 --F1 2:6:71 --gait quadratic,sinusoidal -o all.tsv
run 0 steady --m1 0.5:2:70 --F1 2:6:71 --gait quadratic,sinusoidal --format npy -o all.npy
run 0 steady --T 1e-3:1e3:2500:log --columns T,v_start,displacement,multiplier -o numbers.tsv
run 0 steady --T 1e-3:1e3:2500:log --columns T,v_start,displacement,multiplier --format npy --threads 1 -o numbers.npy
run 0 steady --T 1e-3:1e3:2500:log --columns T,v_start,displacement,multiplier --format npy --threads 3 -o again.npy
cmp -s numbers.npy again.npy || note "depends on the threads"
run 3 steady --L 1e-300,1,1e300 --m1 1e300,1 -o failed.tsv
run 3 steady --L 1e-300,1,1e300 --m1 1e300,1 --format npy -o failed.npy
run 0 steady --F1 1:2:2 --certified --digits 40 -o certified.tsv
run 0 steady --F1 1:2:2 --certified --digits 40 --format npy -o certified.npy
run 0 steady --F1 1:2:5 --digits 3 --columns F1,v_start -o digits.tsv
run 0 steady --F1 1:2:5 --digits 3 --columns F1,v_start --format npy -o digits.npy
python <<'END'
import numpy
for name in ("all", "numbers", "failed", "certified", "digits"):
    rows, records = read(name + ".tsv"), numpy.load(name + ".npy", mmap_mode="r")
    if records.shape != (len(rows),) or records.dtype.names != tuple(rows[0]):
        bad(name, records.shape, records.dtype)
    for row, record in zip(rows, records):
        for column, text in row.items():
            is_text = record.dtype[column].kind == "S"
            if is_text and record[column].decode() != text or not is_text and repr(float(text)) != repr(float(record[column])):
                bad(name, column, text, record[column])
if open("all.npy", "rb").read(600).count(b"# command: steady") != 1:
    bad("the head does not say of what command it is")
END
run 2 steady --format npy
[ ! -s out ] && grep -q -- '--format npy needs -o FILE' err || note "to a pipe: $(cat err)"
finish "--format npy: the same rows, which numpy.load opens"

# ---- points from a file of NumPy ----
python <<'END'
import numpy as np
kinds = [("m1", "<f8"), ("F1", ">f4"), ("T", "<i2"), ("gait", "U12"), ("note", "S7"), ("n", "<u8")]
rows = np.array([(1, 4, 1, "quadratic", b"a", 2**63), (0.1, 0.25, 3, "sinusoidal", b"", 7), (2, 3, -4, "quadratic", b"1234567", 0)], kinds)
np.save("points.npy", rows)
np.save("other-end.npy", rows.astype([(name, np.dtype(kind).newbyteorder(">")) for name, kind in kinds]))
np.save("padded.npy", rows.astype(np.dtype(kinds, align=True)))
open("points.tsv", "w").write("m1\tF1\tT\tgait\tnote\tn\n" + "".join("%r\t%r\t%d\t%s\t%s\t%d\n" %
    (float(a), float(b), c, d, e.decode(), f) for a, b, c, d, e, f in rows.tolist()))
np.save("matrix.npy", np.zeros((3, 2)))
np.save("plain.npy", np.zeros(3))
np.save("deep.npy", rows.reshape(3, 1))
np.save("nested.npy", np.zeros(3, [("m1", "f8", (2,))]))
np.save("complex.npy", np.zeros(3, [("m1", "c16")]))
np.save("pickled.npy", np.array([(1, None)], [("m1", "f8"), ("x", "O")]), allow_pickle=True)
whole = open("points.npy", "rb").read()
for name, size in ("row", len(whole) - 1), ("head", 50), ("front", 5):
    open("cut-%s.npy" % name, "wb").write(whole[:size])
open("nothing.npy", "wb").write(whole.replace(b"(3,)", b"(0,)")[:-3 * rows.dtype.itemsize])
END
run 3 steady --points points.tsv -o wanted
sed 's/line 4/line 3/' wanted >of-rows # which are counted from the first
for name in points other-end padded; do
  run 3 steady --points $name.npy
  cmp -s out of-rows || note "$name.npy: $(diff out of-rows | head -n 3)"
done
"$tool" steady --points - <points.npy 2>err | cmp -s - of-rows || note "standard input"
head -c -10 points.npy | "$tool" steady --points - >out 2>err && note "half of it is read"
grep -q 'cannot read standard input: it ends before its last row' err || note "half of it: $(cat err)"
run 0 steady --points nothing.npy
[ "$(rows out | wc -l)" = 0 ] || note "no rows become some"
while IFS='|' read -r name message; do
  run 2 steady --points "$name.npy"
  grep -qF "scallop steady: $name.npy: $message" err || note "$name: $(cat err)"
done <<'END'
matrix|this array does not have one dimension
deep|this array does not have one dimension
plain|this array has no named columns
nested|column 'm1' is neither a number nor a text
complex|column 'm1' is of a type that is not read
pickled|column 'x' holds pickled objects
cut-row|the file is cut off: its head states 3 rows
cut-head|the file ends within its head
cut-front|this is not a file of numpy.save
END
finish "--points: files of NumPy, of any byte order; others are refused"

# ---- samples ----
run 0 steady --m1 0.5:2 --T 0.1,0.2 --F1 1:10:log --sample sobol:8 --columns m1,F1,T,v_start -o sobol.tsv
run 0 steady --m1 0.5:2 --F1 1:10:log --alpha 0.2:0.8 --sample random:3:1303 --columns m1,F1,alpha,v_start -o random.tsv
python <<'END'
def splitmix(seed):
    while True:
        seed = (seed + 0x9e3779b97f4a7c15) % 2**64
        z = (seed ^ seed >> 30) * 0xbf58476d1ce4e5b9 % 2**64
        z = (z ^ z >> 27) * 0x94d049bb133111eb % 2**64
        yield ((z ^ z >> 31) >> 11) / 2**53
def is_at(row, **shares):
    ends = {"m1": (0.5, 2), "F1": (1, 10), "alpha": (0.2, 0.8)}
    for name, u in shares.items():
        low, high = ends[name]
        x = low * (high / low) ** u if name == "F1" else low + u * (high - low)
        if not near(number(row, name), x, 1e-11):
            bad(row, name, x)
u = splitmix(1303)
for row in read("random.tsv"):
    is_at(row, m1=next(u), F1=next(u), alpha=next(u))
# the first of Sobol's points in two dimensions, in Gray code
points = (1/2, 1/2), (3/4, 1/4), (1/4, 3/4), (3/8, 3/8), (7/8, 7/8), (5/8, 1/8), (1/8, 5/8), (3/16, 5/16)
rows = read("sobol.tsv")
if len(rows) != 16:
    bad(len(rows), "rows")
for i, row in enumerate(rows):
    is_at(row, m1=points[i // 2][0], F1=points[i // 2][1])
    if row["T"] != ("0.1", "0.2")[i % 2]:
        bad(row, "T does not vary fastest")
END
while IFS='|' read -r message arguments; do
  # shellcheck disable=SC2086
  run 2 steady $arguments
  grep -qF -- "scallop steady: $message" err || note "$arguments: $(cat err)"
done <<'END'
--sample: no parameter has a range FROM:TO or FROM:TO:log|--sample sobol:3 --m1 1:2:3
--m1: a range without a COUNT needs --sample|--m1 1:2
--sample: 'sobol' is not allowed here: it takes sobol:N|--m1 1:2 --sample sobol
--sample: 'sobol:0' is not allowed here|--m1 1:2 --sample sobol:0
--sample: 'sobol:2000000000' is not allowed here|--m1 1:2 --sample sobol:2000000000
--sample: 'random:5' is not allowed here|--m1 1:2 --sample random:5
--sample: 'random:5:-1' is not allowed here|--m1 1:2 --sample random:5:-1
--m1: 'nan' is neither a number|--m1 nan:2 --sample sobol:4
--alpha: '1' is not allowed here|--alpha 0.5:1 --sample sobol:4
END
finish "--sample: points of ranges by Sobol and at random"

# ---- shards ----
shards() { # N KIND ARGUMENT...: writes part-I.KIND of N and merges them into merged.KIND
  n=$1 kind=$2
  shift 2
  rm -f part-*
  for i in $(seq "$n" -1 1); do
    "$tool" "$@" --shard "$i/$n" --format "$kind" -o "part-$i.$kind" 2>/dev/null
    [ -f "part-$i.$kind" ] || note "there is no shard $i/$n of $*"
  done
  run 0 merge part-*."$kind" -o "merged.$kind"
}
while read -r arguments; do
  for kind in tsv npy; do
    # shellcheck disable=SC2086
    "$tool" $arguments --format $kind -o whole.$kind 2>/dev/null
    for n in 1 2 7 16; do
      # shellcheck disable=SC2086
      shards $n $kind $arguments
      cmp -s merged.$kind whole.$kind || note "$n shards in $kind: other bytes of $arguments"
    done
  done
done <<'END'
steady --m1 0.5:2:70 --F1 2:6:71
steady --F1 1:3:11
steady --m1 1:2 --F1 1:10:log --sample sobol:1000 --T 0.1,1 --columns m1,F1,T,v_start
steady --L 1e-300,1,2 --F1 1:3:5 --m1 1e300,1
steady --points points.tsv
steady --points points.npy
trajectory --T 0.1:1:9 --periods 1 --samples 3
series --T 0.1:1:9
END
finish "scallop merge: shards give the bytes of the whole, also where there are more of them than points"

shards 16 tsv steady --m1 0.5:2:100 --F1 2:6:100
run 0 steady --m1 0.5:2:100 --F1 2:6:100 -o whole.tsv
bounds=$(for i in $(seq 16); do rows "part-$i.tsv" | wc -l; done | sort -u | tr '\n' ' ')
[ "$bounds" = "625 " ] || note "10000 points in 16 shards: $bounds"
refused() { # MESSAGE FILE...
  message=$1
  shift
  run 2 merge "$@" -o refused.tsv
  grep -q "^scallop merge: $message" err || note "merge $*: $(cat err)"
  [ ! -e refused.tsv ] || note "merge $* writes a file"
}
mv part-5.tsv five.tsv && mv part-12.tsv twelve.tsv
refused 'of the 16 shards of this sweep 2 are missing: 5 12$' part-*.tsv
refused 'part-1.tsv and part-1.tsv are both shard 1 of 16$' part-1.tsv part-1.tsv
"$tool" steady --m1 0.5:2:100 --F1 2:7:100 --shard 5/16 -o part-5.tsv
refused 'part-1.tsv and part-5.tsv are of different sweeps' part-*.tsv
"$tool" steady --m1 0.5:2:100 --F1 2:6:100 --shard 5/17 -o part-5.tsv
refused 'part-1.tsv and part-5.tsv are of different sweeps, of different numbers of shards' part-*.tsv
head -c 5000 five.tsv >part-5.tsv
refused 'part-5.tsv: it is cut off' part-*.tsv
refused 'whole.tsv: it is not a shard' whole.tsv
refused 'nothing.tsv: No such file' nothing.tsv
"$tool" steady --m1 0.5:2:100 --F1 2:6:100 --shard 5/16 --format npy -o part-5.npy
refused 'part-5.npy and part-1.tsv are of different' part-5.npy part-1.tsv
head -c 5000 part-5.npy >cut.npy
refused 'cut.npy: the file is cut off' cut.npy
run 4 merge five.tsv twelve.tsv part-[12346789].tsv part-1[013456].tsv -o five.tsv
grep -q 'a file that this command reads' err || note "onto a shard: $(cat err)"
cp five.tsv part-5.tsv && mv twelve.tsv part-12.tsv
"$tool" merge part-*.tsv | cmp -s - whole.tsv || note "to standard output"
finish "missing, doubled, foreign and cut shards are named, and nothing is written"

again() { "$tool" steady --m1 0.5:2:100 --F1 2:6:100 --shard 5/16 --format tsv --skip-complete -o part-5.tsv "$@" --threads 1; }
touch -d 2001-01-01 part-5.tsv
again --quiet
[ "$(date -r part-5.tsv +%Y)" = 2001 ] || note "a shard that is there is computed again"
"$tool" steady --m1 0.5:2:100 --F1 2:7:100 --shard 5/16 --format tsv -o foreign.tsv
for other in whole.tsv part-6.tsv cut.npy foreign.tsv; do
  cp $other part-5.tsv
  again
  cmp -s part-5.tsv five.tsv || note "$other stays in place of the shard"
done
head -c -1 five.tsv >part-5.tsv
again
cmp -s part-5.tsv five.tsv || note "a shard without its last byte stays"
rm part-5.tsv
again & again & again
wait
cmp -s part-5.tsv five.tsv || note "three at once: another file"
[ "$(find . -name '*.scallop-*' | wc -l)" = 0 ] || note "temporary files are left"
cp points.npy changing.npy
"$tool" steady --points changing.npy --shard 1/2 -o part-1 2>/dev/null
sed 's/1234567/7654321/' changing.npy >changed.npy && mv changed.npy changing.npy
"$tool" steady --points changing.npy --shard 2/2 -o part-2 2>/dev/null
refused 'part-1 and part-2 are of different sweeps' part-1 part-2
(keep_counts_apart && trap '' XFSZ && ulimit -f 20 && exec "$tool" steady --m1 0.5:2:100 --F1 2:6:100 --shard 5/16 -o full.tsv >out 2>err)
[ $? = 4 ] && [ ! -e full.tsv ] || note "a file that may not grow: $(cat err)"
(keep_counts_apart && trap '' XFSZ && ulimit -f 20 && exec "$tool" steady --m1 0.5:2:100 --F1 2:6:100 --shard 5/16 --format npy -o full.npy >out 2>err)
[ $? = 4 ] && [ ! -e full.npy ] || note "an array that may not grow: $(cat err)"
(keep_counts_apart && trap '' XFSZ && ulimit -f 1000 && exec "$tool" merge part-*.tsv -o full.tsv >out 2>err)
[ $? = 4 ] && [ ! -e full.tsv ] || note "merge into a file that may not grow: $(cat err)"
finish "a shard is computed again where it is not whole, and is whole or absent"

while IFS='|' read -r message arguments; do
  # shellcheck disable=SC2086
  run 2 $arguments
  grep -qF -- "$message" err || note "$arguments: $(cat err)"
done <<'END'
--shard: '0/4' is not allowed here: it takes I/N|steady --shard 0/4
--shard: '5/4' is not allowed here|steady --shard 5/4
--shard: '1/0' is not allowed here|steady --shard 1/0
--shard: '1' is not allowed here|steady --shard 1
--shard: '-1/4' is not allowed here|steady --shard -1/4
--shard: '1/4/2' is not allowed here|steady --shard 1/4/2
--shard: a shard is of the format tsv or npy|steady --shard 1/4 --format csv
--shard: standard input has no parts|steady --shard 1/4 --points -
--shard: this table has no row for each point|trajectory --shard 1/2
--shard: this table has no row for each point|series --T 0.1:1:9 --orders --shard 1/2
--skip-complete has nothing to do without --shard|steady --skip-complete -o x
--skip-complete needs -o FILE|steady --skip-complete --shard 1/2
END
finish "--shard: what is no shard is refused"

# ---- the documents ----
sed -n '/^```$/,/^```$/s/^scallop //p' "$root/docs/guide/sweeps.md" >commands
[ "$(wc -l <commands)" = 3 ] || note "$(wc -l <commands) commands in docs/guide/sweeps.md"
while read -r command; do
  # shellcheck disable=SC2086
  run 0 $command
done <commands
python <<'END'
import numpy
a, b = numpy.load("sweep.npy", mmap_mode="r"), numpy.load("samples.npy", mmap_mode="r")
if a.shape != (10**6,) or not (a["status"] == b"ok").all() or b.shape != (10**6,) or not (b["alpha"] < 0.8).all():
    bad(a.shape, b.shape)
END
finish "the examples of docs/guide/sweeps.md"

exit $failed
