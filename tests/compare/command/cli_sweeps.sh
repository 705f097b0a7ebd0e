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

exit $failed
