/* What it takes to start a program. */
#ifndef SCALLOP_BENCH_START_H
#define SCALLOP_BENCH_START_H

/* How often each program is started, in turns with the others */
enum { START_RUNS = 401 };

/* Prints what `scallop steady` takes from being made a process to its end, beside a program that does nothing; both are
 * in the folder of own_path. Exits with 3 and a message if one of them cannot be started or ends with another code than
 * 0. */
void bench_start(const char *own_path);

#endif
