#include "compare/stress/ball_period.h"

#include <math.h>

void ball_period_init(struct ball_period *p)
{
  fmpq_init(p->v_mid);
  arb_init(p->v_end);
  arb_init(p->displacement);
}

void ball_period_clear(struct ball_period *p)
{
  fmpq_clear(p->v_mid);
  arb_clear(p->v_end);
  arb_clear(p->displacement);
}

bool ball_period_solve(struct ball_period *p, const struct scallop_rational_crawler *c, const fmpq_t v_start, long digits,
                       const char **why)
{
  struct ball_answer phase;
  bool solved = true;
  ball_answer_init(&phase);
  arb_zero(p->displacement);
  for (int kind = SCALLOP_EXTENSION; solved && kind <= SCALLOP_CONTRACTION; kind++) {
    bool first = kind == SCALLOP_EXTENSION;
    solved = answer_in_balls(&phase, c, OF_PHASE, (enum scallop_phase_kind)kind, first ? v_start : p->v_mid, digits);
    if (!solved)
      break;
    arb_add(p->displacement, p->displacement, phase.value[Q_DXC], 4 * digits);
    arb_set(p->v_end, phase.value[Q_V_END]);
    p->modes[kind] = phase.modes[0];
    if (first)
      ball_middle_exact(p->v_mid, p->v_end);
  }
  *why = phase.why ? phase.why : scallop_status_text(phase.status);
  ball_answer_clear(&phase);
  return solved;
}

struct scallop_wide ball_middle(const arb_t x)
{
  struct scallop_wide w = { 0, 0 };
  arf_t low;
  if (arb_contains_zero(x))
    return w;
  arf_init(low);
  w.high = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  arf_set_d(low, w.high);
  arf_sub(low, arb_midref(x), low, ARF_PREC_EXACT, ARF_RND_NEAR);
  if (isfinite(w.high))
    w.low = arf_get_d(low, ARF_RND_NEAR);
  arf_clear(low);
  return w;
}

void ball_middle_exact(fmpq_t middle, const arb_t x)
{
  if (arb_contains_zero(x))
    fmpq_zero(middle);
  else
    arf_get_fmpq(middle, arb_midref(x));
}
