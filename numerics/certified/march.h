/* One phase marched in ball arithmetic at one precision: the inside of the certified solver. Private to
 * numerics/certified/. Unit of time: the phase; of length: L. */
#ifndef SCALLOP_NUMERICS_CERTIFIED_MARCH_H
#define SCALLOP_NUMERICS_CERTIFIED_MARCH_H

#include "model/exact/fractions.h"
#include "numerics/certified/enclose.h"
#include "numerics/numerics.h"

/* The parameters of the motion of a phase, exactly. */
struct scallop_forces {
  enum scallop_phase_kind kind;
  struct scallop_exact_gait exact; /* the gait, its laws worked out in fractions once */
  fmpq_t share[2];                 /* x_i'' has share_i l'' in it: -m2/M, m1/M */
  fmpq_t friction[2];              /* F_i tau^2 / (M L)                        */
};
#define FORCES_PARTS(of) \
  of(scallop_exact, &s->exact) of(fmpq, s->share[0]) of(fmpq, s->share[1]) of(fmpq, s->friction[0]) \
      of(fmpq, s->friction[1])
SCOPED_PARTS(scallop_forces, struct scallop_forces, FORCES_PARTS)
void scallop_forces_of(struct scallop_forces *forces, const struct scallop_rational_crawler *crawler,
                       enum scallop_phase_kind kind);

struct scallop_march {
  const struct scallop_forces *forces;
  const struct scallop_piece *piece;
  bool even;   /* l'' is constant over the piece and rational: */
  fmpq_t bend; /* this                                         */
  slong precision;

  arb_t now;            /* how far it has come                                                   */
  arb_t since, rate;    /* when velocities and positions were last brought up to date, and l' then */
  arb_t v[2], x[2];     /* the bodies then                                                       */
  arb_t path[2];        /* how far they have slid, one way and the other                         */
  arb_t l_since, l_now; /* length gained from the start until since, from since until now        */
  arb_t share[2];       /* as in forces                                                          */
  int s[2];             /* the mode                                                              */
  int departure[2];     /* of each body's velocity, at now: enum scallop_departure               */

  arb_t first, last;       /* times of the first and the last change of mode, if it switches        */
  arb_t at_first, at_last; /* the rear body's position then                                         */
  arb_t multiplier, v_end;
  bool switches, sticks, moves[2];
  struct scallop_modes modes;
  const char *why; /* what could not be decided                                             */
};
#define MARCH_PARTS(of) \
  of(fmpq, s->bend) of(arb, s->now) of(arb, s->since) of(arb, s->rate) of(arb, s->v[0]) of(arb, s->v[1]) \
      of(arb, s->x[0]) of(arb, s->x[1]) of(arb, s->path[0]) of(arb, s->path[1]) of(arb, s->l_since) of(arb, s->l_now) \
          of(arb, s->share[0]) of(arb, s->share[1]) of(arb, s->first) of(arb, s->last) of(arb, s->at_first) \
              of(arb, s->at_last) of(arb, s->multiplier) of(arb, s->v_end)
SCOPED_PARTS(scallop_march, struct scallop_march, MARCH_PARTS)

/* Marches from both bodies at velocity v0, over all of that ball, to the end of the phase: x1, x2, v_end and the
 * members after it hold then. False: not decided at this precision; why names the cause. */
bool scallop_march_phase(struct scallop_march *march, const struct scallop_forces *forces, const arb_t v0,
                         slong precision);

/* The march in one mode (march_mode.c); march.c has the changes of mode. */
static inline bool is_stuck(const struct scallop_march *m) { return m->s[0] == 0 || m->s[1] == 0; }
static inline int the_stuck(const struct scallop_march *m) { return m->s[0] == 0 ? 0 : 1; }

/* Both bodies at velocity v0, and nothing has happened yet. */
void march_reset(struct scallop_march *m, const struct scallop_forces *forces, const arb_t v0, slong precision);
/* Sets sum to n1 F1 + n2 F2 over M, rounded once: an exact 0 stays 0. */
void march_friction_sum(arb_t sum, const struct scallop_march *m, int n1, int n2);

/* Returns the fate of a body at rest that would go in direction side. A constant force exactly at its limit holds
 * it. */
enum hold { HELD, PULLED, UNDECIDED };
enum hold march_hold_against(struct scallop_march *m, int body, int side);

/* A body turned from direction s: the flow is sheared by the ratio of its accelerations after and before. */
void march_shear(struct scallop_march *m, int body, int s);
/* Advances the time. Velocities and positions stay behind, until they are settled. */
void march_advance(struct scallop_march *m, const arb_t to);
/* Sets body exactly to rest; the other body then has all of l'. */
void march_rest(struct scallop_march *m, int body);
/* Brings velocities and positions up to date; l' is rate now, or the value of the piece. */
void march_settle_at(struct scallop_march *m, const arb_t rate);
void march_settle(struct scallop_march *m);
/* Takes down the mode, if it is another one than before. Only after settling. */
void march_take_down(struct scallop_march *m);

#endif
