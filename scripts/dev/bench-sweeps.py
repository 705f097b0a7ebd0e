"""What a row of a sweep costs, in turn with the C batch call on the same crawlers: processor time (user and system) and time
on the clock in nanoseconds a row, bytes a row, and what the rows cost beside the batch. bench-sweeps.py BUILD, as make
bench-sweeps calls it. Medians of five turns; what else the machine does disturbs the clock more than the processor time."""
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

BATCH = r"""
#include "scallop.h"
enum { N = 1024, ROWS = 5000000 };
static double m1[N], F1[N], one[N], L[N], alpha[N], of[3][N];
static const struct scallop_gait *gait[N];
int main(void)
{
  double sum = 0;
  for (long first = 0; first < ROWS; first += N) {
    for (long i = 0; i < N; i++) {
      m1[i] = 0.5 + 1.5 * (double)((first + i) / 5000) / 999;
      F1[i] = 2 + 4 * (double)((first + i) % 5000) / 4999;
      one[i] = 1, L[i] = 10, alpha[i] = 0.75, gait[i] = &scallop_gait_quadratic;
    }
    const struct scallop_crawlers c = { first + N > ROWS ? ROWS - first : N, m1, one, F1, one, L, one, alpha, gait };
    const struct scallop_steady_states s = { .v_start = of[0], .displacement = of[1], .mean_velocity = of[2] };
    sum += (double)scallop_steady_batch(&c, &s, 1) + of[0][0];
  }
  return sum == 0;
}
"""
build = sys.argv[1]
folder = tempfile.TemporaryDirectory()
program, out = folder.name + "/batch", folder.name + "/out"
subprocess.run([os.environ.get("CC", "cc"), "-O2", "-I.", "-x", "c", "-", "-x", "none", build + "/libscallop-core.a", "-lm", "-o", program],
               input=BATCH, text=True, check=True)
five, grid = "--columns m1,F1,v_start,displacement,mean_velocity", "steady --m1 0.5:2:1000 --F1 2:6:%d"
rows_of = [("the batch call alone, on one thread", 5000000, None),
           ("npy, five columns", 5000000, f"{grid % 5000} {five} --format npy --threads 1"),
           ("npy, five columns, two threads", 5000000, f"{grid % 5000} {five} --format npy --threads 2"),
           ("npy, five columns, Sobol", 1000000, f"steady --m1 0.5:2 --F1 2:6 --sample sobol:1000000 {five} --format npy --threads 1"),
           ("npy, all columns", 1000000, f"{grid % 1000} --format npy --threads 1"),
           ("tsv, five columns", 1000000, f"{grid % 1000} {five} --threads 1"),
           ("tsv, five columns, two threads", 1000000, f"{grid % 1000} {five} --threads 2"),
           ("tsv, all columns", 1000000, f"{grid % 1000} --threads 1"),
           ("tsv, with a formula", 1000000, f"{grid % 1000} --columns m1,F1,v_start,\"c=displacement/L\" --threads 1")]
taken = {name: [] for name, _, _ in rows_of}
for turn in range(5):
    for name, rows, arguments in rows_of:
        command = [program] if arguments is None else [build + "/scallop", *arguments.replace('"', "").split(), "-o", out]
        before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
        after, clock = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic() - begun
        used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        taken[name].append((used / rows * 1e9, clock / rows * 1e9, os.path.getsize(out) / rows if arguments else 0))
print("what\tprocessor_ns\tclock_ns\tbytes\ttimes_the_batch")
unit = statistics.median(t[0] for t in taken[rows_of[0][0]])
for name, times in taken.items():
    used, clock, size = (statistics.median(column) for column in zip(*times))
    print(f"{name}\t{used:.0f}\t{clock:.0f}\t{size:.0f}\t{used / unit:.2f}")
