/* The march in one mode, for march.c: its changes are there. Private to march.c. */
#ifndef SCALLOP_NUMERICS_CERTIFIED_MARCH_MODE_H
#define SCALLOP_NUMERICS_CERTIFIED_MARCH_MODE_H

#include "numerics/certified/enclose.h"
#include "numerics/certified/march.h"

static inline bool is_stuck(const struct scallop_march *m) { return m->s[0] == 0 || m->s[1] == 0; }
static inline int the_stuck(const struct scallop_march *m) { return m->s[0] == 0 ? 0 : 1; }

/* Both bodies at velocity v0, and nothing has happened yet. */
void march_reset(struct scallop_march *m, const struct scallop_forces *forces, const arb_t v0, slong precision);
/* n1 F1 + n2 F2 over M, rounded once: exactly 0 where it is. */
void march_friction_sum(arb_t sum, const struct scallop_march *m, int n1, int n2);

/* What becomes of a body at rest that would go in direction side. A force exactly at its limit holds it as long as it
 * is there. */
enum hold { HELD, PULLED, UNDECIDED };
enum hold march_hold_against(struct scallop_march *m, int body, int side);

/* A body turned from direction s: the flow is sheared by the ratio of its accelerations after and before. */
void march_shear(struct scallop_march *m, int body, int s);
/* Time goes on. Velocities and positions stay behind, until they are settled. */
void march_advance(struct scallop_march *m, const arb_t to);
/* Body at rest exactly; so the other one has all of l'. */
void march_rest(struct scallop_march *m, int body);
/* Brings velocities and positions up to date, where l' is rate now, or as the piece has it. */
void march_settle_at(struct scallop_march *m, const arb_t rate);
void march_settle(struct scallop_march *m);
/* Takes down the mode, if it is another one than before. Only after settling. */
void march_take_down(struct scallop_march *m);

#endif
