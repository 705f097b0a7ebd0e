/* Gaits by their text, and measured ones by their file: what comes back is refused with a reason, or is a gait with
 * which a period can be solved. The first byte tells which. */
#include "compare/points/gait_file.h"
#include "compare/points/gaits.h"

#include <math.h>
#include <stdlib.h>

#include "tests/fuzz/target.h"
#include "tests/support/solved.h"

/* The pieces follow each other from 0 to 1, with finite l', and l gains the amplitude. */
static void judge_phase(const struct scallop_gait *gait, int kind)
{
  const struct scallop_shape *shape = &gait->phase[kind];
  double begin, end;
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i], *q = p + 1;
    if (!isfinite(p->curve->velocity(p, p->begin)) || !isfinite(p->curve->acceleration(p, p->end)))
      fuzz_fail("phase %d, piece %d: l' or l'' is not finite", kind, i);
    if (i + 1 < shape->count && q->begin != (p->anchor == q->anchor ? p->end : 1 - p->end))
      fuzz_fail("phase %d: piece %d does not follow the one before", kind, i + 1);
  }
  scallop_gait_at(gait, (enum scallop_phase_kind)kind, 0, &begin, NULL, NULL);
  scallop_gait_at(gait, (enum scallop_phase_kind)kind, 1, &end, NULL, NULL);
  if (!(fabs(begin - kind) <= 1e-12) || !(fabs(end - (1 - kind)) <= 1e-12 * fmax(1, shape->peak)))
    fuzz_fail("phase %d goes from %.17g to %.17g", kind, begin, end);
}

static void judge(const struct scallop_gait *gait)
{
  const struct scallop_crawler c = with_gait(gait);
  struct scallop_period_result r;
  judge_phase(gait, SCALLOP_EXTENSION);
  judge_phase(gait, SCALLOP_CONTRACTION);
  if (scallop_period(&c, 0.5, &r) == SCALLOP_OK && !(isfinite(r.v_end) && isfinite(r.displacement)))
    fuzz_fail("v_end = %g, displacement = %g", r.v_end, r.displacement);
}

static void read_file(const uint8_t *data, size_t size)
{
  struct gait_file gait;
  bool unreadable;
  const char *wrong = gait_file_read(&gait, fuzz_file(data, size), "measured", &unreadable);
  if (unreadable || (wrong && *wrong == '\0'))
    fuzz_fail("it cannot be read: %s", wrong);
  if (wrong)
    return;
  for (int i = SCALLOP_MEASURED_BEST; i < SCALLOP_MEASURED_OTHERS; i++) {
    struct scallop_measured_gait g = scallop_measured_gait(gait.measured, i);
    if (g.gait)
      judge(g.gait);
    if ((i < 0 || g.gait) && !(g.T > 0 && g.L > 0 && g.alpha > 0 && g.alpha < 1))
      fuzz_fail("T = %g, L = %g, alpha = %g", g.T, g.L, g.alpha);
  }
  gait_file_free(&gait);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  if (size == 0)
    return 0;
  if (data[0] != ':') {
    read_file(data, size);
    return 0;
  }
  char *text = fuzz_text(data + 1, size - 1);
  struct gait_result a = { .wrong = "a file, which is not for this" };
  if (strncmp(text, "measured:", 9) != 0)
    a = gait_of_text(text);
  if (!a.gait == !a.wrong || (a.wrong && *a.wrong == '\0'))
    fuzz_fail("'%s': neither a gait nor a reason, or both", text);
  if (a.gait && strcmp(a.gait->name, text) != 0)
    fuzz_fail("'%s' is called '%s'", text, a.gait->name);
  if (a.gait)
    judge(a.gait);
  free(text);
  return 0;
}
