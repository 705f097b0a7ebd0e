/* The claims "... + O(T^n)": the error of each published formula against the exact motion, as T falls. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asymptotics/asymptotics.h"
#include "compare/claims.h"
#include "compare/exact.h"
#include "numerics/numerics.h"

/* T = T0 2^(-k/4), T0 the duration at which the Froude number of the phase is 1 */
enum { STEPS = 96 };
/* An order within this of the claimed one is the claimed one. */
static const double TOLERANCE = 0.1;
/* Rounding errors of the exact and the published value, in ulp of the largest number in the comparison. */
static const double NOISE_ULP = 64;

struct condition {
  const char *text;
  bool inside;
  double v0; /* in units of sqrt(L (F1 + F2)/M)                                      */
  bool exchange_forces, mirror_alpha, light_1;
};

static const double SPEED = 0.37;

static const struct condition extension_from_rest[] = { { "extension from rest, F1 > F2", true, 0, false, false, false },
                                                        { "extension from rest, F1 < F2", false, 0, true, false, false },
                                                        { .text = NULL } };
static const struct condition contraction_from_rest[] = { /* the bodies exchanged */
                                                          { "contraction from rest, F2 > F1", true, 0, true, false, false },
                                                          { "contraction from rest, F2 < F1", false, 0, false, false,
                                                            false },
                                                          { .text = NULL }
};
static const struct condition moving[] = { { "v0 > 0 fixed, F1 > F2", true, SPEED, false, false, false },
                                           { "v0 > 0 fixed, F1 < F2", false, SPEED, true, false, false },
                                           { "v0 < 0 fixed, F1 > F2", false, -SPEED, false, false, false },
                                           { .text = NULL } };
static const struct condition steady[] = { { "alpha > 1/2, F1 > F2", true, 0, false, false, false },
                                           { "alpha < 1/2, F1 < F2", false, 0, true, true, false },
                                           { "alpha < 1/2, F1 > F2", false, 0, false, true, false },
                                           { "alpha > 1/2, F1 < F2", false, 0, true, false, false },
                                           { "alpha > 1/2, F1 > F2, m1 a hundredth", false, 0, false, false, true },
                                           { .text = NULL } };

const char *claim_verdict_text(enum claim_verdict verdict)
{
  static const char *const text[] = { "holds", "sharper", "refuted", "undecided" };
  return text[verdict];
}

/* ---- the error of one formula at one T ---- */

struct subject {
  const struct scallop_formula *formula;
  struct scallop_crawler crawler; /* T is set for each point                                       */
  enum scallop_phase_kind kind;
  double v0;
  bool magnitude;                /* the claim is quantity = O(T^n) itself, without a formula      */
  struct scallop_modes modes[2]; /* of the smallest T that was solved                             */
};

/* The series describes one sequence of modes, that of the smallest T: larger T with another are left out. */
static bool same_modes(struct scallop_modes *expected, const struct scallop_modes *modes)
{
  if (expected->count == 0)
    *expected = *modes;
  bool same = expected->count == modes->count;
  for (int i = 0; same && i < modes->count && i < SCALLOP_MODES_KEPT; i++)
    same = expected->kept[i].s1 == modes->kept[i].s1 && expected->kept[i].s2 == modes->kept[i].s2;
  return same;
}

static bool phase_error(struct subject *s, double T, struct order_point *point)
{
  struct scallop_crawler c = s->crawler;
  struct exact_phase e;
  c.T = T / (s->kind == SCALLOP_EXTENSION ? c.alpha : 1 - c.alpha);
  if (exact_phase_solve(&c, s->kind, s->v0, &e) != SCALLOP_OK || !same_modes(&s->modes[0], &e.phase.modes))
    return false;
  struct scallop_phase_point p = scallop_phase_point(&c, s->kind, s->v0);
  double exact = exact_quantity(&e, s->formula->quantity);
  double series = s->magnitude ? 0 : published_value(s->formula, &p, &e);
  bool position = s->formula->quantity >= SCALLOP_REAR_AT_LAST && s->formula->quantity <= SCALLOP_CENTRE_AT_END;
  double size = fmax(fabs(exact), fabs(series));
  if (position)
    size = fmax(size, c.L);
  if (s->formula->quantity == SCALLOP_VELOCITY_CHANGE || s->formula->quantity == SCALLOP_VELOCITY_AT_END)
    size = fmax(size, fabs(s->v0));
  *point = (struct order_point){ .h = T, .err = exact - series, .noise = NOISE_ULP * DBL_EPSILON * size };
  return isfinite(point->err);
}

static bool steady_error(struct subject *s, double T, struct order_point *point)
{
  struct scallop_crawler c = s->crawler;
  struct scallop_steady_result r;
  c.T = T;
  if (scallop_steady(&c, &r) != SCALLOP_OK || !same_modes(&s->modes[0], &r.period.modes[0])
      || !same_modes(&s->modes[1], &r.period.modes[1]))
    return false;
  bool velocity = s->formula->quantity == SCALLOP_STEADY_VELOCITY;
  double exact = velocity ? r.period.v_start : r.period.displacement, series = s->formula->steady(&c);
  double size = fmax(fmax(fabs(exact), fabs(series)), velocity ? c.L / c.T : c.L);
  *point = (struct order_point){ .h = T, .err = exact - series, .noise = NOISE_ULP * DBL_EPSILON * size };
  return isfinite(point->err);
}

/* l'(T - h) = -h l''(T) + O(h^2) and l(T - h) = h^2/2 l''(T) + O(h^3), in an extension with T = 1 */
static bool expansion_error(const struct subject *s, bool velocity, double h, struct order_point *point)
{
  const struct scallop_shape *shape = &s->crawler.gait->phase[SCALLOP_EXTENSION];
  const struct scallop_piece *last = &shape->pieces[shape->count - 1];
  double err = velocity ? last->curve->velocity(last, h) + h * shape->lT
                        : 1 + last->curve->length(last, h) - 0.5 * h * h * shape->lT;
  *point = (struct order_point){ .h = h, .err = err, .noise = NOISE_ULP * DBL_EPSILON * fmax(h, velocity ? 0 : 1) };
  return h <= last->begin;
}

/* 2^(-k/4), without a call whose last digit depends on the library */
static double grid(int k)
{
  static const double quarter[] = { 1, 0x1.ae89f995ad3adp-1, 0x1.6a09e667f3bcdp-1, 0x1.306fe0a31b715p-1 };
  return ldexp(quarter[k % 4], -(k / 4));
}

/* ---- verdicts ---- */

static void judge(struct claim_row *row)
{
  const struct order_fit *fit = &row->fit;
  double half_width = fit->hi - fit->order, off = fit->order - row->claimed_order;
  row->verdict = CLAIM_UNDECIDED;
  if (fit->state == ORDER_EXACT) {
    row->verdict = CLAIM_SHARPER;
    snprintf(row->reason, sizeof row->reason, "no error above rounding at any T");
  } else if (fit->state != ORDER_FITTED) {
    static const char *const why[] = {
      "", "no such switch in this motion", "too few points above rounding", "roundoff floor", "the orders do not settle", ""
    };
    snprintf(row->reason, sizeof row->reason, "%s", why[fit->state]);
  } else if (half_width > 0.25) {
    snprintf(row->reason, sizeof row->reason, "the interval is too wide");
  } else {
    row->verdict = fabs(off) <= TOLERANCE ? CLAIM_HOLDS : off > 0 ? CLAIM_SHARPER : CLAIM_REFUTED;
    if (row->verdict == CLAIM_REFUTED && fabs(fit->order) < TOLERANCE)
      snprintf(row->reason, sizeof row->reason, "the error does not fall");
    else if (row->verdict != CLAIM_HOLDS)
      snprintf(row->reason, sizeof row->reason, "the error goes as T^%.0f", fit->order);
  }
}

static struct subject subject_of(const struct scallop_crawler *crawler, const struct scallop_formula *formula,
                                 enum scallop_phase_kind kind, const struct condition *condition)
{
  struct subject s = { .formula = formula, .crawler = *crawler, .kind = kind };
  double M = crawler->m1 + crawler->m2;
  if (condition->exchange_forces) {
    s.crawler.F1 = crawler->F2;
    s.crawler.F2 = crawler->F1;
  }
  if (condition->light_1)
    s.crawler.m1 = crawler->m1 / 100;
  if (condition->mirror_alpha)
    s.crawler.alpha = 1 - crawler->alpha;
  s.v0 = condition->v0 * sqrt(crawler->L * (crawler->F1 + crawler->F2) / M);
  return s;
}

static void measure(struct claim_row *row, struct subject *s, struct order_point points[STEPS])
{
  double T0 = sqrt((s->crawler.m1 + s->crawler.m2) * s->crawler.L / (s->crawler.F1 + s->crawler.F2));
  int count = 0;
  for (int k = STEPS - 1; k >= 0; k--) {
    double T = T0 * grid(k);
    if ((s->formula->setting == SCALLOP_STEADY ? steady_error : phase_error)(s, T, &points[count]))
      count++;
  }
  row->fit = order_estimate(points, count);
  row->points = points;
  row->count = count;
  judge(row);
}

static void claims_of_formula(const struct scallop_crawler *crawler, const struct scallop_formula *f, bool magnitude,
                              claim_sink *sink, void *context)
{
  int first = f->setting == SCALLOP_MOVING_CONTRACTION, last = f->setting == SCALLOP_AT_REST_START ? 1 : first;
  for (int kind = first; kind <= last; kind++) {
    const struct condition *conditions = f->setting == SCALLOP_STEADY          ? steady
                                         : f->setting != SCALLOP_AT_REST_START ? moving
                                         : kind == SCALLOP_EXTENSION           ? extension_from_rest
                                                                               : contraction_from_rest;
    for (const struct condition *condition = conditions; condition->text; condition++) {
      struct order_point points[STEPS];
      struct subject s = subject_of(crawler, f, (enum scallop_phase_kind)kind, condition);
      struct claim_row row = { .claim = f->name,
                               .equation = f->equation,
                               .gait = crawler->gait->name,
                               .quantity = formula_quantity_text(f, s.kind),
                               .conditions = condition->text,
                               .inside = condition->inside,
                               .claimed_order = magnitude ? 2 : f->remainder };
      s.magnitude = magnitude;
      if (magnitude)
        row.claim = "A_x1_first_switch_size";
      measure(&row, &s, points);
      sink(context, &row);
    }
  }
}

static void claims_of_expansion(const struct scallop_crawler *crawler, claim_sink *sink, void *context)
{
  for (int velocity = 1; velocity >= 0; velocity--) {
    struct order_point points[STEPS];
    struct subject s = { .crawler = *crawler };
    struct claim_row row = { .claim = velocity ? "A_dl_near_end" : "A_l_near_end",
                             .equation = velocity ? "(A.11)" : "(A.12)",
                             .quantity = velocity ? "l'(T-h)" : "l(T-h)",
                             .gait = crawler->gait->name,
                             .conditions = "h -> 0 at T = 1",
                             .inside = true,
                             .claimed_order = velocity ? 2 : 3 };
    int count = 0;
    for (int k = 8; k < STEPS; k++)
      count += expansion_error(&s, velocity, grid(k), &points[count]);
    row.fit = order_estimate(points, count);
    row.points = points;
    row.count = count;
    judge(&row);
    sink(context, &row);
  }
}

void claims_of_order(const struct scallop_crawler *crawler, const struct scallop_gait *gait, claim_sink *sink, void *context)
{
  struct scallop_crawler c = *crawler;
  for (int g = 0; scallop_gait_name(g); g++) {
    c.gait = scallop_gait_named(scallop_gait_name(g));
    if (gait && c.gait != gait)
      continue;
    for (const struct scallop_formula *f = scallop_published; f->name; f++) {
      if (f->remainder > 0)
        claims_of_formula(&c, f, false, sink, context);
      if (f->phase == A_x1_first_switch)
        claims_of_formula(&c, f, true, sink, context);
    }
    claims_of_expansion(&c, sink, context);
  }
}
