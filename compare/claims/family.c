#include "compare/claims/family.h"

#include <math.h>

#include "compare/answers/point_flint.h"
#include "compare/text/table.h"

/* Slopes over 2^-40 lose 12 digits of these; 2^-60 is 18 digits. */
enum { DIGITS = 32, BITS = 160, NEAR = 40 };

struct scallop_crawler family_member(const struct scallop_crawler *crawler, enum varied varied, double x)
{
  struct scallop_crawler c = *crawler;
  if (varied == VARY_PERIOD)
    c.T = x;
  else if (varied == VARY_RATIO)
    c.F1 = x * c.F2;
  else {
    c.F1 = x * (c.F1 / c.F2);
    c.F2 = x;
  }
  return c;
}

static struct place place_at(const struct family *f, double x)
{
  struct scallop_crawler c = family_member(&f->crawler, f->varied, x);
  struct scallop_steady_result r = steady_state(&c);
  return (struct place){ .x = x,
                         .speed = r.mean_velocity * f->crawler.T / f->crawler.L,
                         .v_start = r.period.v_start,
                         .sliding = isfinite(r.mean_velocity) && r.period.regime == SCALLOP_SLIDING };
}

/* In doubles */

static double speed_of(const void *family, double x) { return place_at(family, x).speed; }
static double start_of(const void *family, double x) { return place_at(family, x).v_start; }

static double rough_boundary(const struct family *f)
{
  for (int i = 1; i < f->count; i++)
    if (f->scan[i - 1].v_start > 0 && f->scan[i].v_start <= 0)
      return last_positive(start_of, f, f->scan[i - 1].x, f->scan[i].x);
  return NAN;
}

static void keep_maximum(struct family *f, struct place at)
{
  if (at.speed > f->maximum[f->highest].speed)
    f->highest = f->maxima;
  f->maximum[f->maxima++] = at;
}

static void find_maxima(struct family *f)
{
  for (int i = 1; i + 1 < f->count && f->maxima < PEAKS_MOST; i++)
    if (f->scan[i].speed > f->scan[i - 1].speed && f->scan[i].speed > f->scan[i + 1].speed)
      keep_maximum(f, place_at(f, highest_between(speed_of, f, f->scan[i - 1].x, f->scan[i + 1].x)));
}

void family_scan(struct family *f, const struct scallop_crawler *c, enum varied varied, bool coarse)
{
  double x = 1.01, factor = coarse ? 1.04 : 1.01;
  *f = (struct family){ .crawler = *c, .varied = varied, .count = coarse ? 229 : 900, .before = NAN, .after = NAN };
  if (varied == VARY_FORCES) {
    x = 1e-3 * (c->m1 + c->m2) * c->L / (c->T * c->T) / (1 + c->F1 / c->F2);
    f->count = SCAN_MOST;
  } else if (varied == VARY_PERIOD) {
    x = sqrt(1e-3 * (c->m1 + c->m2) * c->L / (c->F1 + c->F2));
    f->count = SCAN_MOST / 2;
  }
  for (int i = 0; i < f->count; i++, x *= factor)
    f->scan[i] = place_at(f, x);
  f->boundary = rough_boundary(f);
  find_maxima(f);
}

bool family_peaks_at_boundary(const struct family *f)
{
  return f->maxima > 0 && fabs(f->maximum[f->highest].x / f->boundary - 1) < 1e-5;
}

/* Proven */

/* A member; the family's numbers are the shortest decimals that read back, x is exactly what it is. */
struct member {
  arb_t v_start, speed;
  bool solved;
};

static void exact_member(struct scallop_rational_crawler *c, const struct family *f, const fmpq_t x)
{
  rational_crawler(c, &f->crawler);
  if (f->varied == VARY_PERIOD)
    fmpq_set(c->T, x);
  else if (f->varied == VARY_RATIO)
    fmpq_mul(c->F1, c->F2, x);
  else {
    fmpq_div(c->F1, c->F1, c->F2);
    fmpq_mul(c->F1, c->F1, x);
    fmpq_set(c->F2, x);
  }
}

static void member_solve(struct member *m, const struct family *f, const fmpq_t x)
{
  struct scallop_rational_crawler c;
  struct scallop_certified_steady s;
  scallop_rational_init(&c);
  scallop_certified_steady_init(&s);
  exact_member(&c, f, x);
  m->solved = scallop_certified_steady(&c, DIGITS, &s, NULL) == SCALLOP_OK;
  rational_crawler(&c, &f->crawler);
  fmpq_div(c.T, c.T, c.L);
  arb_set(m->v_start, s.v_start);
  arb_set_fmpq(m->speed, c.T, BITS);
  arb_mul(m->speed, m->speed, s.mean_velocity, BITS);
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&c);
}

static void solve_decimal(struct member *m, const struct family *f, double x)
{
  char text[NUMBER_TEXT];
  fmpq_t exact;
  fmpq_init(exact);
  number_text(text, x, 0);
  if (!scallop_rational_parse(exact, text))
    scallop_rational_set_double(exact, x);
  member_solve(m, f, exact);
  fmpq_clear(exact);
}

static void members_init(struct member *m, int count)
{
  for (int i = 0; i < count; i++) {
    arb_init(m[i].v_start);
    arb_init(m[i].speed);
  }
}

static void members_clear(struct member *m, int count)
{
  for (int i = 0; i < count; i++) {
    arb_clear(m[i].v_start);
    arb_clear(m[i].speed);
  }
}

static bool family_rises(const struct family *f, double x, double y)
{
  struct member m[2];
  members_init(m, 2);
  solve_decimal(&m[0], f, x);
  solve_decimal(&m[1], f, y);
  bool rises = m[0].solved && m[1].solved && arb_lt(m[0].speed, m[1].speed);
  members_clear(m, 2);
  return rises;
}

void family_prove_maxima(struct family *f)
{
  int count = f->maxima;
  f->maxima = f->highest = 0;
  for (int i = 0; i < count; i++) {
    struct place at = f->maximum[i];
    if (family_rises(f, 0.99 * at.x, at.x) && family_rises(f, 1.01 * at.x, at.x))
      keep_maximum(f, at);
  }
}

/* y = x (1 + sign 2^-bits) */
static void beside(fmpq_t y, const fmpq_t x, int sign, int bits)
{
  fmpq_div_2exp(y, x, (flint_bitcnt_t)bits);
  if (sign < 0)
    fmpq_neg(y, y);
  fmpq_add(y, x, y);
}

/* The mean velocity from one to the other, over 2^-40. Returns the sign that is proven, or 0. */
static int slope(double *value, const struct member *from, const struct member *to)
{
  arb_t rise;
  arb_init(rise);
  arb_sub(rise, to->speed, from->speed, BITS);
  arb_mul_2exp_si(rise, rise, NEAR);
  *value = middle(rise);
  int sign = !from->solved || !to->solved ? 0 : arb_is_positive(rise) - arb_is_negative(rise);
  arb_clear(rise);
  return sign;
}

/* x, which is good to 2^-48 or so, becomes the zero of the line through the two members to the left of it. */
static bool refine(fmpq_t x, const struct member *far, const struct member *near)
{
  arb_t step;
  fmpq_t exact;
  arb_init(step);
  fmpq_init(exact);
  bool apart = near->solved && far->solved && !arb_overlaps(near->v_start, far->v_start);
  if (apart) {
    arb_sub(step, far->v_start, near->v_start, BITS);
    arb_div(step, near->v_start, step, BITS); /* from near on, in x 2^-40 */
    arf_get_fmpq(exact, arb_midref(step));
    fmpq_sub_si(exact, exact, 1);
    fmpq_div_2exp(exact, exact, NEAR);
    fmpq_mul(exact, exact, x);
    fmpq_add(x, x, exact);
  }
  arb_clear(step);
  fmpq_clear(exact);
  return apart;
}

void family_prove_boundary(struct family *f)
{
  enum { MEMBERS = 6 };
  static const int bits[MEMBERS] = { NEAR - 1, NEAR, 60, 60, NEAR, NEAR - 1 };
  struct member m[MEMBERS];
  fmpq_t x, at;
  if (isnan(f->boundary))
    return;
  fmpq_init(x);
  fmpq_init(at);
  members_init(m, MEMBERS);
  scallop_rational_set_double(x, f->boundary);
  for (int i = 0; i < MEMBERS; i++) {
    f->found = i == 2 ? refine(x, &m[0], &m[1]) : f->found;
    beside(at, x, i < 3 ? -1 : 1, bits[i]);
    member_solve(&m[i], f, at);
  }
  f->found = f->found && m[2].solved && m[3].solved && arb_is_positive(m[2].v_start) && arb_is_nonpositive(m[3].v_start);
  f->rises_before = slope(&f->before, &m[0], &m[1]) > 0;
  f->falls_after = slope(&f->after, &m[4], &m[5]) < 0;
  f->boundary_speed = middle(m[4].speed);
  f->boundary = fmpq_get_d(x);
  members_clear(m, MEMBERS);
  fmpq_clear(x);
  fmpq_clear(at);
}

bool family_peak_is_proven(const struct family *f)
{
  return f->found && f->rises_before && f->falls_after && family_peaks_at_boundary(f);
}
