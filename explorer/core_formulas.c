/* The formulas, and their errors */
#include "explorer/core.h"

#include <math.h>
#include <stdio.h>

#include "asymptotics/published/read.h"
#include "numerics/digits.h"
#include "numerics/wide/wide.h"

/* Returns formula i of the published and then the corrected ones; NULL after the last. */
static const struct scallop_formula *formula_at(int i)
{
  int published = 0;
  while (scallop_published[published].name)
    published++;
  const struct scallop_formula *f = i < published ? &scallop_published[i] : &scallop_corrected[i - published];
  return f->name ? f : NULL;
}

int describe_formula(int i)
{
  const struct scallop_formula *f = formula_at(i);
  if (!f)
    return 0;
  int used = snprintf(explorer_text, EXPLORER_TEXT, "%s\n%s\n%s\n%s\n%d\n%d\n%d", f->name, f->equation, f->text,
                      scallop_quantity_words[f->quantity], (int)f->setting, f->remainder, (int)f->turns);
  for (const struct scallop_part *part = f->parts; part && part->name; part++)
    used += snprintf(explorer_text + used, EXPLORER_TEXT - (size_t)used, "\n%s\n%s", part->name, part->text);
  return 1;
}

struct turn_positions { /* positions of the rear body, from its start and in L, at the first and last change of mode */
  double mu_front, stroke, first, last;
  struct scallop_mode mode;
  bool started;
};

static void note_turning(void *context, const struct scallop_interval *i)
{
  struct turn_positions *t = context;
  if (t->started && (i->mode.s1 != t->mode.s1 || i->mode.s2 != t->mode.s2)) {
    double way = i->piece->anchor == SCALLOP_FROM_END ? t->stroke : 0;
    t->last = i->x_begin - t->mu_front * t->stroke * (way + i->piece->curve->length(i->piece, i->u_begin));
    t->first = isnan(t->first) ? t->last : t->first;
  }
  t->mode = i->mode;
  t->started = true;
}

static double modes_number(const struct scallop_modes *modes, double number)
{
  int kept = modes->count < SCALLOP_MODES_KEPT ? modes->count : SCALLOP_MODES_KEPT;
  number = fmod(31 * number + modes->count, 1e12);
  for (int i = 0; i < kept; i++)
    number = fmod(31 * number + 3 * modes->kept[i].s1 + modes->kept[i].s2 + 5, 1e12);
  return number;
}

/* The motion of formula f, solved in double or in binary128 */
struct solution {
  struct scallop_wide exact;
  double modes, t1, dT, last; /* modes: a number, equal for equal modes; nan: no solution */
};

static const struct solution unsolved = { { NAN, 0 }, NAN, NAN, NAN, NAN };

static struct solution solve_steady(const struct scallop_formula *f, const struct scallop_crawler *c, bool wide)
{
  struct scallop_wide_steady w;
  struct scallop_steady_result s;
  double work = NAN;
  if ((wide ? scallop_wide_steady(SCALLOP_BINARY128, c, &w) : steady_in(c, WITHOUT_MULTIPLIER, &s)) < 0)
    return unsolved;
  if (!wide) {
    const struct scallop_period_result *p = &s.period;
    if (f->quantity == SCALLOP_STEADY_FRICTION_WORK)
      scallop_friction_work(c, p->v_start, p->v_mid, &work);
    w = (struct scallop_wide_steady){ .mean_velocity = { s.mean_velocity, 0 },
                                      .friction_work = { work, 0 },
                                      .period = { .v_start = { p->v_start, 0 },
                                                  .v_mid = { p->v_mid, 0 },
                                                  .displacement = { p->displacement, 0 },
                                                  .modes = { p->modes[0], p->modes[1] } } };
  }
  const struct scallop_wide of[SCALLOP_QUANTITIES] = { [SCALLOP_STEADY_VELOCITY] = w.period.v_start,
                                                       [SCALLOP_STEADY_V_MID] = w.period.v_mid,
                                                       [SCALLOP_STEADY_DISPLACEMENT] = w.period.displacement,
                                                       [SCALLOP_STEADY_MEAN_VELOCITY] = w.mean_velocity,
                                                       [SCALLOP_STEADY_FRICTION_WORK] = w.friction_work };
  double modes = modes_number(&w.period.modes[1], modes_number(&w.period.modes[0], 0));
  return (struct solution){ of[f->quantity], modes, NAN, NAN, NAN };
}

static struct solution solve_phase(const struct scallop_formula *f, const struct scallop_crawler *c,
                                   enum scallop_phase_kind kind, double v0, bool wide)
{
  bool extension = kind == SCALLOP_EXTENSION;
  struct scallop_wide_phase w;
  struct scallop_phase_result p;
  struct turn_positions t = {
    .mu_front = (extension ? c->m2 : c->m1) / (c->m1 + c->m2), .stroke = extension ? 1 : -1, .first = NAN, .last = NAN
  };
  if ((wide ? scallop_wide_phase(SCALLOP_BINARY128, c, kind, v0, &w) : scallop_phase(c, kind, v0, &p)) < 0)
    return unsolved;
  if (!wide) {
    w = (struct scallop_wide_phase){ { p.t1, 0 },  { p.dT, 0 },  { p.v_end, 0 },  { p.dx1, 0 },
                                     { p.dx2, 0 }, { p.dxC, 0 }, .modes = p.modes };
    scallop_phase_intervals(c, kind, v0, note_turning, &t);
  }
  const struct scallop_wide at_turn = { isnan(w.dT.high) ? NAN : 0, 0 };
  const struct scallop_wide of[SCALLOP_QUANTITIES] = {
    [SCALLOP_LAG] = w.dT,
    [SCALLOP_FIRST_SWITCH] = w.t1,
    [SCALLOP_REAR_AT_FIRST] = { t.first * c->L, 0 },
    [SCALLOP_REAR_AT_LAST] = { t.last * c->L, 0 },
    [SCALLOP_REAR_AT_END] = extension ? w.dx1 : w.dx2,
    [SCALLOP_FRONT_AT_END] = extension ? w.dx2 : w.dx1,
    [SCALLOP_CENTRE_AT_END] = w.dxC,
    [SCALLOP_VELOCITY_AT_END] = w.v_end,
    [SCALLOP_VELOCITY_CHANGE] = { w.v_end.high - v0, w.v_end.low },
    [SCALLOP_VELOCITY_AT_FIRST] = at_turn,
    [SCALLOP_VELOCITY_AT_LAST] = at_turn,
  };
  return (struct solution){ of[f->quantity], modes_number(&w.modes, 0), w.t1.high, w.dT.high, t.last * c->L };
}

static struct solution solve(const struct scallop_formula *f, const struct scallop_crawler *c,
                             enum scallop_phase_kind kind, double v0, bool wide)
{
  return f->setting == SCALLOP_STEADY ? solve_steady(f, c, wide) : solve_phase(f, c, kind, v0, wide);
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
    const struct solution s = solve(f, &c, phase, v0, false);
    explorer_rows[1][k] = s.exact.high;
    explorer_rows[2][k] = s.modes;
    for (int j = 0; j < formulas; j++)
      explorer_rows[3 + j][k] =
          isnan(s.modes) ? NAN : scallop_formula_double(read[j], &c, phase, is_steady ? 0 : v0, s.t1, s.dT, s.last);
  }
  for (int j = 0; j < formulas; j++)
    scallop_formula_free(read[j]);
}

/* Replaces the values y[0], ..., y[count - 1] at x by the coefficients of the polynomial through them: Newton's divided
 * differences, expanded in place. */
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
  const struct solution s = solve(f, &c, (enum scallop_phase_kind)kind, v0, true);
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
    const struct scallop_crawler c = explorer_row_crawler(k);
    explorer_rows[15][k] = scallop_formula_double(read, &c, SCALLOP_EXTENSION, 0, NAN, NAN, NAN);
  }
  scallop_formula_free(read);
}
