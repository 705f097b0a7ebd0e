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
