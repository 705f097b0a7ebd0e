/* One period from a given start velocity in balls: two certified phases, the second from the middle of the ball that the first ends
 * in. Needs FLINT. */
#ifndef SCALLOP_STRESS_BALL_PERIOD_H
#define SCALLOP_STRESS_BALL_PERIOD_H

#include "compare/answers/answer_flint.h"

struct ball_period {
  fmpq_t v_mid; /* the start velocity of the contraction */
  arb_t v_end, displacement;
  struct scallop_modes modes[2];
};
void ball_period_init(struct ball_period *period);
void ball_period_clear(struct ball_period *period);
/* False: not certified to so many digits; *why is the reason. */
bool ball_period_solve(struct ball_period *period, const struct scallop_rational_crawler *crawler, const fmpq_t v_start,
                       long digits, const char **why);

/* The middle of a ball; 0 where the ball holds 0. */
struct scallop_wide ball_middle(const arb_t x);
void ball_middle_exact(fmpq_t middle, const arb_t x);

#endif
