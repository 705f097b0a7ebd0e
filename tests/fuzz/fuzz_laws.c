/* The laws of motion, tests/support/laws.h, of whatever crawler the fuzzer thinks of. */
#include "tests/fuzz/crawler.h"
#include "tests/fuzz/target.h"
#include "tests/support/laws.h"

enum { ROUNDINGS = 64, KEPT = 256 };

static struct fuzz_case input;
static struct scallop_interval kept[KEPT];
static int count;

static void law_is_broken(const struct law_phase *p, const struct scallop_interval *i, const char *what, double got,
                          double wanted, double tolerance, int line)
{
  fuzz_fail("line %d: %s is %.17g, not %.17g within %.3g: interval %d of %d, %s, %s", line, what, got, wanted,
            tolerance, i ? 1 + (int)(i - kept) : 0, count, p->kind == SCALLOP_EXTENSION ? "extension" : "contraction",
            fuzz_describe(&input));
}

static void keep(void *context, const struct scallop_interval *interval)
{
  (void)context;
  if (count < KEPT)
    kept[count] = *interval;
  count++;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  input = fuzz_case_of(data, size);
  for (int kind = 0; kind < 2; kind++) {
    const enum scallop_phase_kind k = (enum scallop_phase_kind)kind;
    struct scallop_phase_result r;
    count = 0;
    enum scallop_status status = scallop_phase_intervals(&input.crawler, k, input.v0, keep, NULL);
    enum scallop_status of_phase = scallop_phase(&input.crawler, k, input.v0, &r);
    if (status < 0 ? count != 0 : count < 1 || count > KEPT)
      fuzz_fail("%d intervals of phase %d, status %d, for %s", count, kind, (int)status, fuzz_describe(&input));
    if (status != of_phase && of_phase != SCALLOP_ERANGE) /* whose results are in the user's units */
      fuzz_fail("status %d and %d for %s", (int)status, (int)of_phase, fuzz_describe(&input));
    if (of_phase < 0)
      continue;
    const struct law_phase p = law_phase_of(&input.crawler, k, input.v0, ROUNDINGS, kept, count);
    laws_hold(&p, &r);
  }
  return 0;
}
