#!/bin/sh
# `make single-order`: the file compiles alone, without a warning, as C99 and as C++17, shows scallop_order and its texts only, and gives the
# verdicts of `scallop order`, word for word. Usage: sh tests/compare/command/cli_single_order.sh build/scallop. MAKE: the make that built it.
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

(cd "$root" && "${MAKE:-make}" --no-print-directory single-order B="$scratch/made") >said 2>&1 || note "$(tail -n 3 said)"
cp made/scallop_order.h . || note "no file"
cat >main.c <<'END'
#include <stdio.h>
#define SCALLOP_ORDER_IMPLEMENTATION
#include "scallop_order.h"
#include "scallop_order.h" /* twice is once */

static struct scallop_order_point points[2000];
int main(int count, char **arguments)
{
  for (int i = 1; i < count; i++) {
    FILE *file = fopen(arguments[i], "r");
    struct scallop_order_result result;
    struct scallop_order_wanted wanted = { 2, 0.1, false, false };
    int n = 0;
    if (!file)
      return 1;
    while (fscanf(file, "%lf %lf", &points[n].h, &points[n].err) == 2) {
      points[n].noise = 0;
      points[n++].row = 0;
    }
    fclose(file);
    scallop_order(points, &n, &wanted, &result);
    printf("%s %s %.4f %.4f %.4f %d %s\n", scallop_order_verdict_text(result.verdict), scallop_order_interval_text(result.interval),
           result.order, result.low, result.high, result.used, result.reason);
  }
  return 0;
}
END
# Tables of many kinds, so that most verdicts occur
awk 'BEGIN {
  srand(7)
  for (kind = 0; kind < 8; kind++)
    for (t = 0; t < 12; t++) {
      file = sprintf("table_%d_%02d.txt", kind, t)
      for (i = 0; i < 2 + t; i++) {
        h = 0.5 / 2 ^ i
        err = h ^ 2 * (1 + (rand() - 0.5) * (kind == 1 ? 0.1 : kind == 7 ? 0.6 : 0))
        if (kind == 2) err += 0.3 * h ^ 3
        if (kind == 3) err = t % 2 ? err + 0.02 * h : h * err
        if (kind == 4) err += 1e-4
        if (kind == 5) err += (t % 2 ? 1e-13 : 1e-3) * rand()
        if (kind == 6) err = h ^ 2 * log(1 / h)
        if (kind == 7 && t == 5 && i == 1) err = 0
        bad = kind == 7 && t == 6 && i == 1
        printf "%.17g %s\n", h, bad ? "nan" : sprintf("%.17g", err) >file
      }
      close(file)
    }
}'
"$tool" order table_*.txt --expect 2 --columns verdict,interval,order,order_low,order_high,points,reason 2>err >all
rows all | tr '\t' ' ' >want
[ "$(wc -l <want)" -eq 96 ] || note "$(wc -l <want) verdicts: $(cat err)"
[ "$(cut -d ' ' -f 1 want | sort -u | wc -l)" -ge 8 ] || note "verdicts: $(cut -d ' ' -f 1 want | sort | uniq -c | tr '\n' ' ')"
finish "the file, and verdicts of the tool to compare with"
agree() { # NAME COMPILER...
  name=$1
  shift
  "$@" -Wall -Wextra -pedantic -Werror -O2 -ffp-contract=off -o single main.c -lm >said 2>&1 || note "$(head -n 3 said)"
  ./single table_*.txt >got || note "exit code $?"
  cmp -s got want || note "$(diff got want | head -n 4)"
  finish "$name"
}
compiler=${CC:-cc}
agree "the same as C99" "${compiler%% *}" -std=c99
if command -v c++ >/dev/null 2>&1; then
  agree "the same as C++17" c++ -std=c++17 -x c++
fi
"${compiler%% *}" -std=c99 -DSCALLOP_ORDER_IMPLEMENTATION -x c -c -o alone.o scallop_order.h >said 2>&1 || note "$(head -n 3 said)"
others=$(nm -g --defined-only alone.o | awk '$3 !~ /^scallop_order/ { print $3 }')
[ -z "$others" ] || note "it shows $others"
finish "it shows scallop_order and its texts only"
exit $failed
