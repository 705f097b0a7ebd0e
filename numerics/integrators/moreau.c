#include "numerics/integrators/integrator.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "numerics/integrators/integrator_phases.h"

enum { STEPS_PER_QUESTION = 256 }; /* to patience */

struct moreau {
  struct scallop_integrator integrator; /* first member: a pointer to it is one to the struct */
  long steps;
};

struct moreau_run {
  struct integrator_phases phases; /* first member: a pointer to it is one to the struct */
  long steps;
};

/* One line on the c axis where friction jumps: the velocity of the centre of mass at which a body is at rest, and half
 * the jump. */
struct jump {
  double at, half;
};

/* The c with c + sum of half Sgn(c - at) over both jumps containing b, Sgn(0) = [-1, 1]; lo.at <= hi.at; difference =
 * lo.half - hi.half. The left side is c + constant between the jumps and rises by 2 half at each, so one of five
 * pieces holds b. A body at rest is at rest to the last bit: its `at` comes back. */
static double solve(struct jump lo, struct jump hi, double difference, double b)
{
  double sum = lo.half + hi.half;
  if (b > hi.at + sum)
    return b - sum;
  if (b >= hi.at + difference)
    return hi.at;
  if (b > lo.at + difference)
    return b - difference;
  if (b >= lo.at - sum)
    return lo.at;
  return b + sum;
}

static double gait_velocity(const struct scallop_piece *p, double from_start, double from_end)
{
  double u = p->anchor == SCALLOP_FROM_START ? from_start : from_end;
  if (!p->linear)
    return p->curve->velocity(p, u);
  return p->velocity + p->acceleration * (p->anchor == SCALLOP_FROM_START ? u : -u);
}

/* Takes steps begin + 1 to end, all in one piece. The path by the theta rule, theta = 1/2. */
static void take_steps(struct moreau_run *run, const struct scallop_piece *piece, long begin, long end)
{
  struct integrator_phases *r = &run->phases;
  double h = 1 / (double)run->steps, impulse = h * r->eps, difference = impulse * r->f_difference, c = r->c, sum = 0;
  struct jump body1 = { 0, impulse * r->f[0] }, body2 = { 0, impulse * r->f[1] };
  for (long k = begin + 1; k <= end; k++) {
    double l1 = gait_velocity(piece, (double)k * h, (double)(run->steps - k) * h), before = c;
    body1.at = r->mu[1] * l1;
    body2.at = -r->mu[0] * l1;
    c = l1 >= 0 ? solve(body2, body1, -difference, c) : solve(body1, body2, difference, c);
    sum += before + c;
  }
  r->c = c;
  r->x += 0.5 * h * sum;
  r->steps += end - begin;
  r->evaluations += end - begin;
}

static enum scallop_status run_piece(struct moreau_run *run, const struct scallop_piece *piece, long begin, long end)
{
  for (long k = begin; k < end; k += STEPS_PER_QUESTION) {
    if (!integrator_patience_lasts(run->phases.patience))
      return SCALLOP_ESTOPPED;
    take_steps(run, piece, k, end - k < STEPS_PER_QUESTION ? end : k + STEPS_PER_QUESTION);
  }
  return SCALLOP_OK;
}

static enum scallop_status run_phase(struct integrator_phases *phases, const struct scallop_shape *shape)
{
  struct moreau_run *run = (struct moreau_run *)phases;
  enum scallop_status status = SCALLOP_OK;
  long done = 0;
  for (int i = 0; i < shape->count && status == SCALLOP_OK; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    bool last = i == shape->count - 1;
    long end = last ? run->steps : (long)floor(integrator_flip(p, p->end) * (double)run->steps);
    status = run_piece(run, p, done, end);
    done = end;
  }
  return status;
}

static enum scallop_status moreau_period(struct scallop_integrator *self, const struct scallop_crawler *crawler,
                                         double v0, const struct scallop_patience *patience,
                                         struct scallop_integrator_period *period)
{
  struct moreau_run run = { .phases = { .phase = run_phase, .patience = patience },
                            .steps = ((const struct moreau *)self)->steps };
  return integrator_period(&run.phases, crawler, v0, period);
}

static void moreau_destroy(struct scallop_integrator *self) { free(self); }

struct scallop_integrator *scallop_moreau_integrator(long steps)
{
  bool good = steps >= 1 && (double)steps <= 0x1p53;
  struct moreau *m = good ? malloc(sizeof *m) : NULL;
  if (!m)
    return NULL;
  *m = (struct moreau){ { moreau_period, moreau_destroy }, steps };
  return &m->integrator;
}
