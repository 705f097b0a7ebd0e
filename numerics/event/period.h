/* A phase, a period and the search for the steady state, in units of L, T and F1 + F2 and in the type `real`: their
 * data and the functions that solve them (solve.h). motion.h includes it for double. No header in the usual sense, and
 * not public. Before including it define
 *
 *     real       the type
 *     ROUNDING   2^-bits of it: half of the distance from 1 to the next number
 *     SMALL_STEP a relative step with its square below rounding
 *     SOLVE      how the functions are declared: static inline, or nothing if another file defines them
 */
#include "model/scaling.h"
#include "numerics/numerics.h"

static inline real magnitude(real x) { return x < 0 ? -x : x; }

/* A sum that keeps what rounding drops (Neumaier's variant of Kahan's) */
struct sum {
  real total, lost;
};
/* Returns what rounding dropped of x + y, given the rounded sum. */
static inline real sum_dropped(real sum, real x, real y)
{
  return magnitude(x) >= magnitude(y) ? (x - sum) + y : (y - sum) + x;
}
static inline void sum_add(struct sum *s, real x)
{
  real total = s->total + x;
  s->lost += sum_dropped(total, s->total, x);
  s->total = total;
}
static inline real sum_value(const struct sum *s) { return s->total + s->lost; }

/* Newton's method for the crossings of a line with a curve ends by these two. Returns how far two slopes that meet are
 * from being the same, in parts of their size. */
static inline real step_margin(real steep, real slope)
{
  return magnitude(steep - slope) / (magnitude(steep) + magnitude(slope));
}

/* Returns true for a step so small beside the root x, at least one inflection or end of x away, that the next would
 * show only rounding: the error is then about step^2/(margin x), or step^3/(margin x)^2, and rounding adds the rounding
 * of x over margin. */
static inline int step_is_last(real step, real x, real margin, real least)
{
  const real small = least * margin, rounding = 16 * ROUNDING / margin;
  return magnitude(step) <= (small > rounding ? small : rounding) * x;
}

/* The modes of a phase as one number, for rows of crawlers. Both bodies move in direction `starts` first (0: the phase
 * begins at rest), then, if one turns, in opposite directions, and at last in direction `ends`, or one does and the
 * other is stuck, to the end or until it is released and moves in direction `ends` too. */
enum { COURSE_STARTS = 3, COURSE_ENDS = 4, COURSE_TURNS = 8, COURSE_STUCK = 16, COURSE_RELEASED = 32 };
SCALLOP_INLINE double course_of(double starts, double ends, double turns, int stuck)
{
  return starts + 1 + (ends > 0 ? COURSE_ENDS : 0) + turns * COURSE_TURNS + (stuck ? COURSE_STUCK : 0);
}
static inline bool course_turns(double course) { return (int)course & COURSE_TURNS; }
void course_modes(enum scallop_phase_kind kind, double course, struct scallop_modes *modes);
enum scallop_regime course_regime(const double course[2]);

struct phase_input { /* units: the phase's duration, L and F1 + F2                                         */
  const struct scallop_shape *shape;
  real mu1, mu2, f1, f2, delta, eps; /* as in struct scallop_scaled; eps of this phase                           */
  real base; /* what velocities c at the start and at the end are counted from: 0, or see walk_level               */
};

/* The curves of a phase with concave |l'|, in units of the phase: curve 0 is c = q0 |l'|, curve 1 is c = -q1 |l'|. */
struct line {
  real q0, q1, eps, between; /* c' is -eps, between, eps in regions 0, 1, 2                            */
  real f_first, f_second;    /* of the body that turns first, and of the other, over F1 + F2           */
};

/* Returns the line; plain: body 1 turns first. */
SCALLOP_INLINE struct line line_of(const struct phase_input *in, int plain)
{
  return (struct line){ .q0 = plain ? in->mu2 : in->mu1,
                        .q1 = plain ? in->mu1 : in->mu2,
                        .eps = in->eps,
                        .between = in->eps * (plain ? in->delta : -in->delta),
                        .f_first = plain ? in->f1 : in->f2,
                        .f_second = plain ? in->f2 : in->f1 };
}

/* -1: seen in a mirror. direction: of l', +1 or -1 */
SCALLOP_INLINE real mirror_of(real direction, real delta, real c)
{
  real drive = c != 0 ? c : direction * delta;
  return drive >= 0 ? 1 : -1;
}

/* A phase that concave.h solves, reflected if c would start below 0. Offsets t are from the start of the phase, u back
 * from its end, and x from the start if it is `early`, before |l'| is largest, else back from the end. */
struct passage {
  real sign;                            /* -1: seen in a mirror                                                   */
  real c, t, y, steep;                  /* c at the start; where c meets curve 0, c there, and the slope of the curve */
  real side;                            /* +1: curve 0 comes next, -1: curve 1                                    */
  real x, z, fall;                      /* where c leaves region 1, |c| there, and the slope of the curve, downwards */
  real at_top;                          /* c at the end of the first piece, in region 1                           */
  real u, w, end;                       /* entry to the last region, |c| there and at the end                     */
  real t_covered, x_covered, u_covered; /* what |l'| covers between each and its end of the phase      */
  bool turns, early, in_middle, sticks, released;
};

/* The solution of a phase that begins with velocity c_0 of the centre of mass. */
struct period_motion {
  real c_end;
  real extra_impulse;       /* integral of c'/eps - (its value with the bodies in opposite motion, delta sgn l'): zero
                         if only the stronger driving body matters; meaningless if it forgets */
  real slope;               /* (d c_end / d c_0 - 1)/eps, from the right; meaningless if it forgets           */
  real stretch;             /* d c_end / d c_0, a product without cancellation; meaningless if it forgets     */
  real first_switch;        /* from the start; nan if no mode changes                                         */
  real last_switch;         /* back from the end; nan if no mode changes                                      */
  real way[3];              /* how far the centre of mass, body 1 and body 2 come                             */
  real size[3];             /* sums of the magnitudes of the parts of way: the scale of rounding              */
  real path[2];             /* of body 1 and body 2: how far each slides, one way and the other               */
  real furthest;            /* the largest |c| since a body was stuck, in a phase of many pieces; else 0      */
  bool short_cut;           /* of the ways only way[0] and size[0] are known, and no path                     */
  struct passage passage;   /* if so                                                                       */
  bool forgets;             /* c was glued to a curve, if only for an instant: d c_end / d c_0 = 0            */
  bool delicate;            /* slope and stretch depend on the last digit of c_0: see is_delicate             */
  bool sticks;              /* a body is stuck for some time                                                  */
  bool never_moved[2];      /* body 1, body 2 stuck throughout                                          */
  struct scallop_work work; /* periods: 0                                                               */
  struct scallop_modes modes;
};

struct period {
  real c_start, c_mid, c_end; /* in L/T, from the base of the phase                                     */
  real travel, size;          /* displacement, in L, and the size of its parts, as in struct period_motion     */
  real balance;               /* (c_end - c_start)/eps, formed without that subtraction                 */
  real noise;                 /* what rounding can do to balance                                        */
  real slope;                 /* d balance / d c_start <= 0, unless it forgets                          */
  bool forgets;               /* a body was stuck: c_end does not depend on c_start                     */
  bool continues;             /* phase[1] is the contraction from c_mid                                 */
  struct period_motion phase[2];
};

/* A scaled crawler */
struct walker {
  struct phase_input phase[2];
  real fraction[2], eps; /* as in struct scallop_scaled                                                 */
  real driven;           /* the mean of sgn l' over the period: 2 alpha - 1 for the usual gaits         */
  const struct scallop_gait *gait;
  bool walks; /* event by event, without short cuts                                           */
};

/* Returns a margin for a line, with slopes `before` and `after`, that crosses a curve of slope `along`, at most
 * `steep`. The crossing is delicate if it is nearly tangent or the curve is nearly level: the last digit of its place
 * then decides its effect on the derivative of the motion. */
SCALLOP_INLINE real delicate_margin(real along, real before, real after, real steep) /* < 0: it is */
{
  const int small = 32;
  real level = magnitude(along), least = small * level - magnitude(steep);
  real by_before = small * magnitude(along - before) - (level + magnitude(before));
  real by_after = small * magnitude(along - after) - (level + magnitude(after));
  least = by_before < least ? by_before : least;
  return by_after < least ? by_after : least;
}
SCALLOP_INLINE int is_delicate(real along, real before, real after, real steep)
{
  return delicate_margin(along, before, after, steep) < 0;
}

/* Returns whether a displacement needs wider arithmetic because the sum of its parts cancels: rounding errs by up to an
 * ulp of size, and the displacement may be determined to an ulp of its own. The parts of straight pieces are products,
 * and exact to a few ulp of their own. */
SCALLOP_INLINE int period_cancels(real travel, real size, int ramps)
{
  return (travel < 0 ? -travel : travel) * (ramps ? 64 : 8) < size;
}

/* Returns the level of a curve over a plateau of l' within `near` of c; 0: no such level. */
SOLVE real walk_level(const struct phase_input *in, real c, real near);
/* Event by event; visit may be NULL. */
SOLVE void motion_walk(const struct phase_input *in, real c_0, scallop_visitor *visit, void *context,
                       struct period_motion *m);
/* The ways of body 1, of body 2 and of the middle between them, and the sizes of their parts */
SOLVE void motion_bodies(const struct phase_input *in, enum scallop_phase_kind kind, real mu_difference,
                         const struct period_motion *motion, real way[3], real size[3]);
SOLVE enum scallop_regime motion_regime(const struct period_motion *motion);

/* Solves one phase from velocity c in L/T, by a short cut if possible. Returns the velocity at its end. */
SOLVE real period_phase(const struct walker *walker, enum scallop_phase_kind kind, real c,
                        struct period_motion *motion);
SOLVE void period_solve(const struct walker *walker, real c_start, struct period *period);
/* Combines two solved phases. */
SOLVE void period_conclude(const struct walker *walker, struct period *period);
/* Sets travel as accurately as the type allows; needed only for the displacement. */
SOLVE void period_sum_up(const struct walker *walker, struct period *period);
SOLVE real period_multiplier(const struct walker *walker, const struct period *period);
SOLVE enum scallop_regime period_regime(const struct period *period);

/* Above this velocity both bodies always move forward, below its negative always backward. */
SOLVE real steady_bound(const struct walker *walker);
/* Solves the contraction alone, for a steady state with rest at the end of the extension. Returns the velocity at its
 * end, to begin the search at. */
SOLVE real steady_from_rest(const struct walker *walker, struct period *period);
/* Finds the root of the balance between -bound and bound, from guess on. Adds the numbers of iterations and of their
 * parts to *work. */
SOLVE void steady_find(const struct walker *walker, real guess, real bound, struct period *period,
                       struct scallop_work *work);
/* If the root is near the level of a curve over a plateau of l', finds it once more with velocities counted from that
 * level: friction may change c by less than an ulp of c, but this change decides where on the plateau c meets the
 * curve, and so the modes and the multiplier. Returns false if no such level exists, or c leaves its vicinity. */
SOLVE bool steady_find_from_level(const struct walker *walker, struct period *period, struct scallop_work *work);
