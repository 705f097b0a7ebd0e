/* What it takes to start a program. */
#ifndef SCALLOP_BENCH_START_H
#define SCALLOP_BENCH_START_H

#include <stdbool.h>

#include "compare/text/stopwatch.h"

enum { START_RUNS = 401 };

/* Seconds from making a process of each of count programs to its end, START_RUNS times in turns; arguments[k]: path and
 * arguments, NULL after the last. Standard output goes nowhere. False, with errno, if one of them cannot be started or
 * ends with another code than 0. */
bool start_measure(char *const *const *arguments, int count, struct stopwatch_spread *spread);

#endif
