/* The formulas, and what they are off by. */
#include "explorer/core.h"

#include <math.h>
#include <stddef.h>

#include "asymptotics/published/read.h"
#include "numerics/digits.h"
#include "numerics/wide/wide.h"

/* Number i of the published formulas and then of the corrected ones; NULL after the last. */
static const struct scallop_formula *formula_at(int i)
{
  int published = 0;
  while (scallop_published[published].name)
    published++;
  const struct scallop_formula *f = i < published ? &scallop_published[i] : &scallop_corrected[i - published];
  return f->name ? f : NULL;
}

const char *formula_text(int i, int which)
{
  const struct scallop_formula *f = formula_at(i);
  if (!f)
    return NULL;
  const char *const texts[] = { f->name, f->equation, f->text, scallop_quantity_words[f->quantity], f->corrected };
  if (which < 5)
    return texts[which];
  const struct scallop_part *part = f->parts;
  for (int k = 5; part && part->name; k += 2, part++)
    if (k == which || k + 1 == which)
      return k == which ? part->name : part->text;
  return NULL;
}

int formula_number(int i, int which)
{
  const struct scallop_formula *f = formula_at(i);
  const int numbers[] = { (int)f->setting, (int)f->quantity, f->remainder, (int)f->turns };
  return numbers[which];
}

struct turning { /* positions of the rear body, from its start and in L, at the first and at the last change of mode */
  double mu_front, stroke, first, last;
  struct scallop_mode mode;
  bool started;
};

static void note_turning(void *context, const struct scallop_interval *i)
{
  struct turning *t = context;
  if (t->started && (i->mode.s1 != t->mode.s1 || i->mode.s2 != t->mode.s2)) {
    double way = i->piece->anchor == SCALLOP_FROM_END ? t->stroke : 0;
    t->last = i->x_begin - t->mu_front * t->stroke * (way + i->piece->curve->length(i->piece, i->u_begin));
    t->first = isnan(t->first) ? t->last : t->first;
  }
  t->mode = i->mode;
  t->started = true;
}

static const struct scallop_wide none = { NAN, 0 };

static struct scallop_wide plain(double x) { return (struct scallop_wide){ x, 0 }; }

static struct scallop_wide steady_number(const struct scallop_wide_steady *s, enum scallop_quantity quantity)
{
  switch (quantity) {
  case SCALLOP_STEADY_VELOCITY: return s->period.v_start;
  case SCALLOP_STEADY_V_MID: return s->period.v_mid;
  case SCALLOP_STEADY_DISPLACEMENT: return s->period.displacement;
  case SCALLOP_STEADY_MEAN_VELOCITY: return s->mean_velocity;
  default: return s->friction_work;
  }
}

static struct scallop_wide phase_number(const struct scallop_wide_phase *p, const struct turning *t,
                                        enum scallop_phase_kind kind, double v0, double L,
                                        enum scallop_quantity quantity)
{
  bool extension = kind == SCALLOP_EXTENSION;
  switch (quantity) {
  case SCALLOP_LAG: return p->dT;
  case SCALLOP_FIRST_SWITCH: return p->t1;
  case SCALLOP_REAR_AT_FIRST: return plain(t->first * L);
  case SCALLOP_REAR_AT_LAST: return plain(t->last * L);
  case SCALLOP_REAR_AT_END: return extension ? p->dx1 : p->dx2;
  case SCALLOP_FRONT_AT_END: return extension ? p->dx2 : p->dx1;
  case SCALLOP_CENTRE_AT_END: return p->dxC;
  case SCALLOP_VELOCITY_AT_END: return p->v_end;
  case SCALLOP_VELOCITY_CHANGE: return (struct scallop_wide){ p->v_end.high - v0, p->v_end.low };
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: return plain(isnan(p->dT.high) ? NAN : 0);
  default: return none;
  }
}

static double modes_number(const struct scallop_modes *modes, double number)
{
  int kept = modes->count < SCALLOP_MODES_KEPT ? modes->count : SCALLOP_MODES_KEPT;
  number = fmod(31 * number + modes->count, 1e12);
  for (int i = 0; i < kept; i++)
    number = fmod(31 * number + 3 * modes->kept[i].s1 + modes->kept[i].s2 + 5, 1e12);
  return number;
}

struct solved {
  struct scallop_wide exact;
  double modes, t1, dT, last; /* modes: equal where the modes are; nan: no answer */
};

static const struct solved unsolved = { { NAN, 0 }, NAN, NAN, NAN, NAN };

/* The steady state in double, its numbers as those of binary128 are given */
static enum scallop_status steady_in_double(const struct scallop_crawler *c, enum scallop_quantity quantity,
                                            struct scallop_wide_steady *out)
{
  struct scallop_steady_result s;
  enum scallop_status status = steady_in(c, WITHOUT_MULTIPLIER, &s);
  if (status < 0)
    return status;
  const struct scallop_period_result *p = &s.period;
  out->mean_velocity = plain(s.mean_velocity);
  out->period.v_start = plain(p->v_start);
  out->period.v_mid = plain(p->v_mid);
  out->period.displacement = plain(p->displacement);
  out->period.modes[0] = p->modes[0];
  out->period.modes[1] = p->modes[1];
  out->friction_work = none;
  if (quantity == SCALLOP_STEADY_FRICTION_WORK)
    scallop_friction_work(c, p->v_start, p->v_mid, &out->friction_work.high);
  return SCALLOP_OK;
}

static enum scallop_status phase_in_double(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0,
                                           struct scallop_wide_phase *out)
{
  struct scallop_phase_result p;
  enum scallop_status status = scallop_phase(c, kind, v0, &p);
  if (status == SCALLOP_OK)
    *out = (struct scallop_wide_phase){ .t1 = plain(p.t1),
                                        .dT = plain(p.dT),
                                        .v_end = plain(p.v_end),
                                        .dx1 = plain(p.dx1),
                                        .dx2 = plain(p.dx2),
                                        .dxC = plain(p.dxC),
                                        .modes = p.modes };
  return status;
}

/* What formula f is about, in double or in binary128 */
static struct solved solve(const struct scallop_formula *f, const struct scallop_crawler *c,
                           enum scallop_phase_kind kind, double v0, bool wide)
{
  struct scallop_wide_steady s;
  struct scallop_wide_phase p;
  if (f->setting == SCALLOP_STEADY) {
    bool known = wide ? f->quantity != SCALLOP_STEADY_FRICTION_WORK
                            && scallop_wide_steady(SCALLOP_BINARY128, c, &s) == SCALLOP_OK
                      : steady_in_double(c, f->quantity, &s) == SCALLOP_OK;
    double modes = known ? modes_number(&s.period.modes[1], modes_number(&s.period.modes[0], 0)) : NAN;
    return known ? (struct solved){ steady_number(&s, f->quantity), modes, NAN, NAN, NAN } : unsolved;
  }
  bool extension = kind == SCALLOP_EXTENSION;
  struct turning t = {
    .mu_front = (extension ? c->m2 : c->m1) / (c->m1 + c->m2), .stroke = extension ? 1 : -1, .first = NAN, .last = NAN
  };
  if ((wide ? scallop_wide_phase(SCALLOP_BINARY128, c, kind, v0, &p) : phase_in_double(c, kind, v0, &p)) != SCALLOP_OK)
    return unsolved;
  if (!wide)
    scallop_phase_intervals(c, kind, v0, note_turning, &t);
  return (struct solved){ phase_number(&p, &t, kind, v0, c->L, f->quantity), modes_number(&p.modes, 0), p.t1.high,
                          p.dT.high, t.last * c->L };
}

int formula_is_claimed(int i)
{
  struct scallop_values values = scallop_steady_values(&explorer_crawler);
  return scallop_formula_is_claimed(formula_at(i), &values);
}

void formulas_along(int formulas, int kind, double v0, int count)
{
  char message[SCALLOP_FORMULA_MESSAGE];
  struct scallop_read_formula *read[EXPLORER_FORMULAS];
  struct scallop_crawler c = explorer_crawler;
  const struct scallop_formula *f = formula_at((int)explorer_numbers[0]);
  bool is_steady = f->setting == SCALLOP_STEADY;
  enum scallop_phase_kind phase = is_steady ? SCALLOP_EXTENSION : (enum scallop_phase_kind)kind;
  for (int j = 0; j < formulas; j++)
    read[j] = scallop_formula_read(formula_at((int)explorer_numbers[j]), message);
  for (int k = 0; k < count; k++) {
    c.T = explorer_rows[0][k];
    const struct solved s = solve(f, &c, phase, v0, false);
    explorer_rows[1][k] = s.exact.high;
    explorer_rows[2][k] = s.modes;
    for (int j = 0; j < formulas; j++)
      explorer_rows[3 + j][k] =
          isnan(s.modes) ? NAN : scallop_formula_double(read[j], &c, phase, is_steady ? 0 : v0, s.t1, s.dT, s.last);
  }
  for (int j = 0; j < formulas; j++)
    scallop_formula_free(read[j]);
}

/* The coefficients of the polynomial through the values y[0], ..., y[count - 1] at x: Newton's divided differences,
 * expanded in their place. */
static void interpolate(int count, const long double *x, long double *y)
{
  for (int k = 1; k < count; k++)
    for (int j = count - 1; j >= k; j--)
      y[j] = (y[j] - y[j - 1]) / (x[j] - x[j - k]);
  for (int k = count - 2; k >= 0; k--)
    for (int j = k; j < count - 1; j++)
      y[j] -= x[k] * y[j + 1];
}

int series_of(int i, int kind, double v0, double unit, int step, int shift, int k, int count)
{
  static long double x[EXPLORER_NUMBERS], y[EXPLORER_NUMBERS];
  static double first_modes;
  const struct scallop_formula *f = formula_at(i);
  struct scallop_crawler c = explorer_crawler;
  c.T = explorer_rows[0][k];
  long double T = (long double)c.T / unit;
  x[k] = step == 2 ? T * T : T;
  const struct solved s = solve(f, &c, (enum scallop_phase_kind)kind, v0, true);
  y[k] = (long double)s.exact.high + s.exact.low;
  if (isnan(y[k]) || (k > 0 && s.modes != first_modes))
    return 0;
  y[k] *= shift ? T : 1;
  first_modes = s.modes;
  if (k < count - 1)
    return 1;
  interpolate(count, x, y);
  for (int j = 0; j < count; j++)
    explorer_rows[1][j] = (double)y[j];
  return 1;
}

void formula_over(int i, int count)
{
  char message[SCALLOP_FORMULA_MESSAGE];
  struct scallop_read_formula *read = scallop_formula_read(formula_at(i), message);
  for (int k = 0; k < count; k++) {
    const struct scallop_crawler c = { explorer_rows[0][k], explorer_rows[1][k],  explorer_rows[2][k],
                                       explorer_rows[3][k], explorer_rows[4][k],  explorer_rows[5][k],
                                       explorer_rows[6][k], explorer_crawler.gait };
    explorer_rows[15][k] = scallop_formula_double(read, &c, SCALLOP_EXTENSION, 0, NAN, NAN, NAN);
  }
  scallop_formula_free(read);
}
