#include "model/model.h"

#include <math.h>
#include <stddef.h>

#include "model/families.h"
#include "model/law.h"

#define PI 3.14159265358979323846

static double time_offset(const struct scallop_piece *p, double u) { return law_sense(p) * u; }

static double linear_length(const struct scallop_piece *p, double u)
{
  double t = time_offset(p, u), base = p->law ? p->law->base : 0;
  return (p->direction < 0 ? -base : base) + t * (p->velocity + 0.5 * p->acceleration * t);
}

static double linear_velocity(const struct scallop_piece *p, double u)
{
  return p->velocity + p->acceleration * time_offset(p, u);
}

static double linear_acceleration(const struct scallop_piece *p, double u)
{
  (void)u;
  return p->acceleration;
}

static double linear_when(const struct scallop_piece *p, double a) { return a == p->acceleration ? p->begin : NAN; }

const struct scallop_curve scallop_curve_linear = { linear_length, linear_velocity, linear_acceleration, linear_when,
                                                    NULL };

static const struct scallop_piece quadratic_extension[] = { SCALLOP_RAMP(0, 0.5, SCALLOP_FROM_START, 1, 4),
                                                            SCALLOP_RAMP(0.5, 0, SCALLOP_FROM_END, 1, -4) };
static const struct scallop_piece quadratic_contraction[] = { SCALLOP_RAMP(0, 0.5, SCALLOP_FROM_START, -1, -4),
                                                              SCALLOP_RAMP(0.5, 0, SCALLOP_FROM_END, -1, 4) };

const struct scallop_gait scallop_gait_quadratic = { "quadratic",
                                                     { { quadratic_extension, 2, 4, -4, 2, 1, true, true, false },
                                                       { quadratic_contraction, 2, -4, 4, 2, -1, true, true,
                                                         false } } };

/* Half a cosine: l'(u) = direction (pi/2) sin(pi u) from either end: both ends keep full relative accuracy. */

static double sine_length(const struct scallop_piece *p, double u)
{
  double h = sin(0.5 * PI * u);
  return law_sense(p) * p->direction * (h * h);
}

/* Returns whether sines and cosines are taken from u = 1/2: l'' is then exactly 0 at the join of the two pieces. */
static bool is_late(double u) { return u > 0.25; }

static double sine_velocity(const struct scallop_piece *p, double u)
{
  return p->velocity * (is_late(u) ? cos(PI * (0.5 - u)) : sin(PI * u));
}

static double sine_acceleration(const struct scallop_piece *p, double u)
{
  return p->acceleration * (is_late(u) ? sin(PI * (0.5 - u)) : cos(PI * u));
}

static void sine_rates(const struct scallop_piece *p, double u, double *velocity, double *acceleration)
{
  bool late = is_late(u);
  double angle = PI * (late ? 0.5 - u : u), s = sin(angle), c = cos(angle);
  *velocity = p->velocity * (late ? c : s);
  *acceleration = p->acceleration * (late ? s : c);
}

static double sine_when(const struct scallop_piece *p, double a)
{
  double cosine = a / p->acceleration;
  if (!(cosine >= 0 && cosine <= 1))
    return NAN;
  return cosine > 0.5 ? acos(cosine) / PI : 0.5 - asin(cosine) / PI;
}

static const struct scallop_curve sine = { sine_length, sine_velocity, sine_acceleration, sine_when, sine_rates };

static const struct scallop_law sine_law = { .kind = SCALLOP_LAW_SINE };

/* velocity and acceleration are the amplitudes of l' and l'' here */
#define SINE(from, to, anchored, sign) \
  { \
    .begin = (from), .end = (to), .anchor = (anchored), .direction = (sign), .velocity = (sign) * (0.5 * PI), \
    .acceleration = ((anchored) == SCALLOP_FROM_START ? (sign) : -(sign)) * (0.5 * PI * PI), .curve = &sine, \
    .law = &sine_law \
  }

static const struct scallop_piece sinusoidal_extension[] = { SINE(0, 0.5, SCALLOP_FROM_START, 1),
                                                             SINE(0.5, 0, SCALLOP_FROM_END, 1) };
static const struct scallop_piece sinusoidal_contraction[] = { SINE(0, 0.5, SCALLOP_FROM_START, -1),
                                                               SINE(0.5, 0, SCALLOP_FROM_END, -1) };

#define SINE_L0 (0.5 * PI * PI)

const struct scallop_gait scallop_gait_sinusoidal = {
  "sinusoidal",
  { { sinusoidal_extension, 2, SINE_L0, -SINE_L0, 0.5 * PI, 1, true, false, false },
    { sinusoidal_contraction, 2, -SINE_L0, SINE_L0, 0.5 * PI, -1, true, false, false } }
};

const struct scallop_gait_family scallop_family_quadratic = {
  .name = "quadratic",
  .sentence = "l'' is constant in either half of each phase: |l'| rises and falls along straight lines",
  .sample = "quadratic",
  .fixed = &scallop_gait_quadratic
};

const struct scallop_gait_family scallop_family_sinusoidal = { .name = "sinusoidal",
                                                               .sentence = "l is half a cosine in each phase",
                                                               .sample = "sinusoidal",
                                                               .fixed = &scallop_gait_sinusoidal };

/* Returns true if |l'| is the same function of the offset in both pieces. */
static bool same_law(const struct scallop_piece *a, const struct scallop_piece *b)
{
  if (a->exact != b->exact)
    return false;
  if (a->law || b->law)
    return a->law && b->law && law_same(a->law, b->law);
  int turned = a->anchor == b->anchor ? 1 : -1;
  return a->linear && b->linear && a->direction * a->velocity == b->direction * b->velocity
         && a->direction * a->acceleration == turned * b->direction * b->acceleration;
}

bool scallop_gait_is_exact(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < gait->phase[kind].count; i++)
      if (!gait->phase[kind].pieces[i].law && !gait->phase[kind].pieces[i].linear)
        return false;
  return true;
}

bool scallop_gait_mirrors(const struct scallop_gait *gait)
{
  const struct scallop_shape *e = &gait->phase[SCALLOP_EXTENSION], *c = &gait->phase[SCALLOP_CONTRACTION];
  if (e->count != c->count)
    return false;
  for (int i = 0; i < e->count; i++) {
    const struct scallop_piece *p = &e->pieces[i], *q = &c->pieces[i];
    if (p->anchor != q->anchor || p->begin != q->begin || p->end != q->end || !same_law(p, q))
      return false;
  }
  return true;
}

bool scallop_gait_is_reversible(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &gait->phase[kind];
    for (int i = 0; i < shape->count; i++) {
      const struct scallop_piece *p = &shape->pieces[i], *q = &shape->pieces[shape->count - 1 - i];
      if (p->anchor == q->anchor || p->begin != q->end || p->end != q->begin || !same_law(p, q))
        return false;
    }
  }
  return true;
}

/* Returns the piece that contains time s, and writes the offset of s from its anchor. */
static const struct scallop_piece *piece_at(const struct scallop_shape *shape, double s, double *u)
{
  for (int i = 0;; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    *u = p->anchor == SCALLOP_FROM_START ? s : 1 - s;
    if (i == shape->count - 1 || time_offset(p, *u) <= time_offset(p, p->end))
      return p;
  }
}

void scallop_gait_at(const struct scallop_gait *gait, enum scallop_phase_kind kind, double s, double *length,
                     double *velocity, double *acceleration)
{
  double u;
  const struct scallop_shape *shape = &gait->phase[kind];
  const struct scallop_piece *p = piece_at(shape, s, &u);
  bool at_full_length = (kind == SCALLOP_EXTENSION) == (p->anchor == SCALLOP_FROM_END);
  if (length)
    *length = (at_full_length ? 1 : 0) + p->curve->length(p, u);
  if (velocity)
    *velocity = p->curve->velocity(p, u);
  if (acceleration)
    *acceleration = p->curve->acceleration(p, u);
}
