#!/bin/sh
# Large sweeps: on threads, as files of NumPy, sampled, in shards that are merged.
# Usage: sh tests/compare/command/cli_sweeps.sh build/scallop. One line for each check; non-zero if any failed.
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
series --T 1e-3:1:20 --columns T,text_steady_velocity,derived_4.displacement
END
for threads in 0 -1 1.5 many 1025; do
  run 2 steady --threads $threads
  grep -q "^scallop steady: --threads: '$threads' is not allowed here: it takes a whole number from 1 to 1024" err || note "$(cat err)"
done
finish "rows and messages do not depend on the threads"

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
matrix|this array has not one dimension
deep|this array has not one dimension
plain|this array has no named columns
nested|column 'm1' is no number and no text
complex|column 'm1' is of a type that is not read
pickled|column 'x' holds pickled objects
cut-row|the file is cut off: its head tells of 3 rows
cut-head|the file is cut off within its head
cut-front|this is no file of numpy.save
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
--m1: 'nan' is no number|--m1 nan:2 --sample sobol:4
--alpha: '1' is not allowed here|--alpha 0.5:1 --sample sobol:4
END
finish "--sample: points of ranges by Sobol and at random"

exit $failed
