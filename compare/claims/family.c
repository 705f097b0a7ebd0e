#include "compare/claims/family.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/answers/rational.h"
#include "compare/text/table.h"
#include "numerics/certified.h"

/* Slopes over 2^-40 lose 12 digits of these; 2^-60 is 18 digits. */
enum { DIGITS = 32, BITS = 160, NEAR = 40, AT = 60 };

const char *family_name(const struct family *f)
{
  static const char *const name[] = { "F1/F2", "F2", "T" };
  return name[f->varied];
}

struct scallop_crawler family_member(const struct family *f, double x)
{
  struct scallop_crawler c = f->crawler;
  if (f->varied == VARY_PERIOD)
    c.T = x;
  else if (f->varied == VARY_RATIO)
    c.F1 = x * c.F2;
  else {
    c.F1 = x * (c.F1 / c.F2);
    c.F2 = x;
  }
  return c;
}

static double speed_of(const struct family *f, const struct scallop_steady_result *r)
{
  return r->mean_velocity * f->crawler.T / f->crawler.L;
}

double family_speed(const struct family *f, double x)
{
  struct scallop_crawler c = family_member(f, x);
  struct scallop_steady_result r;
  return scallop_steady(&c, &r) < 0 ? NAN : speed_of(f, &r);
}

/* ---- proven ---- */

void member_init(struct member *m)
{
  arb_init(m->v_start);
  arb_init(m->speed);
  m->solved = false;
}

void member_clear(struct member *m)
{
  arb_clear(m->v_start);
  arb_clear(m->speed);
}

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

void member_solve(struct member *m, const struct family *f, const fmpq_t x)
{
  struct scallop_rational_crawler c, base;
  struct scallop_certified_steady s;
  scallop_rational_init(&c);
  scallop_rational_init(&base);
  scallop_certified_steady_init(&s);
  exact_member(&c, f, x);
  rational_crawler(&base, &f->crawler);
  m->solved = scallop_certified_steady(&c, DIGITS, &s, NULL) == SCALLOP_OK;
  m->sliding = s.regime == SCALLOP_SLIDING;
  fmpq_div(base.T, base.T, base.L);
  arb_set(m->v_start, s.v_start);
  arb_set_fmpq(m->speed, base.T, BITS);
  arb_mul(m->speed, m->speed, s.mean_velocity, BITS);
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&base);
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

bool family_rises(const struct family *f, double x, double y)
{
  struct member low, high;
  member_init(&low);
  member_init(&high);
  solve_decimal(&low, f, x);
  solve_decimal(&high, f, y);
  bool rises = low.solved && high.solved && arb_lt(low.speed, high.speed);
  member_clear(&low);
  member_clear(&high);
  return rises;
}

/* ---- the scan ---- */

void family_scan(struct scan *scan, const struct family *f, bool coarse)
{
  const struct scallop_crawler *c = &f->crawler;
  double x = 1.01, factor = coarse ? 1.04 : 1.01;
  scan->count = coarse ? 229 : 900;
  if (f->varied == VARY_FORCES) {
    x = 1e-3 * (c->m1 + c->m2) * c->L / (c->T * c->T) / (1 + c->F1 / c->F2);
    scan->count = SCAN_MOST;
  } else if (f->varied == VARY_PERIOD) {
    x = sqrt(1e-3 * (c->m1 + c->m2) * c->L / (c->F1 + c->F2));
    scan->count = SCAN_MOST / 2;
  }
  for (int i = 0; i < scan->count; i++, x *= factor) {
    struct scallop_crawler member = family_member(f, x);
    struct scallop_steady_result r;
    bool solved = scallop_steady(&member, &r) >= 0;
    scan->x[i] = x;
    scan->speed[i] = solved ? speed_of(f, &r) : NAN;
    scan->v_start[i] = solved ? r.period.v_start : NAN;
    scan->sliding[i] = solved && r.period.regime == SCALLOP_SLIDING;
  }
}

/* ---- the boundary ---- */

static double start_velocity(const struct family *f, double x)
{
  struct scallop_crawler c = family_member(f, x);
  struct scallop_steady_result r;
  return scallop_steady(&c, &r) < 0 ? NAN : r.period.v_start;
}

double rough_boundary(const struct family *f, const struct scan *scan)
{
  int i = 1;
  while (i < scan->count && !(scan->v_start[i - 1] > 0 && scan->v_start[i] <= 0))
    i++;
  if (i == scan->count)
    return NAN;
  double low = scan->x[i - 1], high = scan->x[i];
  for (double mid; (mid = 0.5 * (low + high)) > low && mid < high;)
    *(start_velocity(f, mid) > 0 ? &low : &high) = mid;
  return low;
}

/* y = x (1 + sign 2^-bits) */
static void beside(fmpq_t y, const fmpq_t x, int sign, int bits)
{
  fmpq_div_2exp(y, x, (flint_bitcnt_t)bits);
  if (sign < 0)
    fmpq_neg(y, y);
  fmpq_add(y, x, y);
}

/* The mean velocity from one to the other, over 2^-40 */
static void slope(arb_t rise, const struct member *from, const struct member *to)
{
  arb_sub(rise, to->speed, from->speed, BITS);
  arb_mul_2exp_si(rise, rise, NEAR);
}

static double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

/* x, which is good to 2^-48 or so, becomes the zero of the line through the two members to the left of it. */
static void refine(fmpq_t x, const struct member *near, const struct member *far)
{
  arb_t step, difference;
  fmpq_t exact;
  arb_init(step);
  arb_init(difference);
  fmpq_init(exact);
  arb_sub(difference, far->v_start, near->v_start, BITS);
  arb_div(step, near->v_start, difference, BITS); /* from near on, in x 2^-40 */
  arf_get_fmpq(exact, arb_midref(step));
  fmpq_sub_si(exact, exact, 1);
  fmpq_div_2exp(exact, exact, NEAR);
  fmpq_mul(exact, exact, x);
  fmpq_add(x, x, exact);
  arb_clear(step);
  arb_clear(difference);
  fmpq_clear(exact);
}

static struct boundary prove_boundary(const struct family *f, fmpq_t x)
{
  struct boundary b = { .found = false };
  struct member far, near, here, next, after;
  struct member *const all[] = { &far, &near, &here, &next, &after };
  fmpq_t at;
  arb_t rise;
  fmpq_init(at);
  arb_init(rise);
  for (int i = 0; i < 5; i++)
    member_init(all[i]);
  beside(at, x, -1, NEAR - 1);
  member_solve(&far, f, at);
  beside(at, x, -1, NEAR);
  member_solve(&near, f, at);
  slope(rise, &far, &near);
  b.before = middle(rise);
  b.rises_before = far.solved && near.solved && arb_is_positive(rise);
  if (near.solved && far.solved && !arb_overlaps(near.v_start, far.v_start)) {
    refine(x, &near, &far);
    beside(at, x, -1, AT);
    member_solve(&here, f, at);
    beside(at, x, 1, AT);
    member_solve(&next, f, at);
    b.found = here.solved && next.solved && arb_is_positive(here.v_start) && arb_is_nonpositive(next.v_start);
  }
  beside(at, x, 1, NEAR);
  member_solve(&next, f, at);
  beside(at, x, 1, NEAR - 1);
  member_solve(&after, f, at);
  slope(rise, &next, &after);
  b.after = middle(rise);
  b.falls_after = next.solved && after.solved && arb_is_negative(rise);
  b.speed = middle(next.speed);
  b.at = fmpq_get_d(x);
  for (int i = 0; i < 5; i++)
    member_clear(all[i]);
  arb_clear(rise);
  fmpq_clear(at);
  return b;
}

struct boundary family_boundary(const struct family *f, const struct scan *scan)
{
  double rough = rough_boundary(f, scan);
  if (isnan(rough))
    return (struct boundary){ .at = NAN, .before = NAN, .after = NAN };
  fmpq_t x;
  fmpq_init(x);
  scallop_rational_set_double(x, rough);
  struct boundary b = prove_boundary(f, x);
  fmpq_clear(x);
  return b;
}

/* ---- the maxima ---- */

static double highest_between(const struct family *f, double a, double b)
{
  const double golden = 0.6180339887498949;
  while (b - a > 1e-7 * a) {
    double left = b - golden * (b - a), right = a + golden * (b - a);
    if (family_speed(f, left) > family_speed(f, right))
      b = right;
    else
      a = left;
  }
  return 0.5 * (a + b);
}

struct peaks family_peaks(const struct family *f, const struct scan *scan, bool prove)
{
  struct peaks p = { .count = 0 };
  for (int i = 1; i + 1 < scan->count && p.count < PEAKS_MOST; i++) {
    if (!(scan->speed[i] > scan->speed[i - 1] && scan->speed[i] > scan->speed[i + 1]))
      continue;
    double at = highest_between(f, scan->x[i - 1], scan->x[i + 1]);
    if (prove && !(family_rises(f, 0.99 * at, at) && family_rises(f, 1.01 * at, at)))
      continue;
    p.at[p.count] = at;
    p.speed[p.count] = family_speed(f, at);
    if (p.speed[p.count] > p.speed[p.highest])
      p.highest = p.count;
    p.count++;
  }
  return p;
}

bool peaks_at(const struct peaks *p, double x) { return p->count > 0 && fabs(p->at[p->highest] / x - 1) < 1e-5; }

/* ---- commands ---- */

double short_number(double x, int digits)
{
  char text[NUMBER_TEXT];
  snprintf(text, sizeof text, "%.*g", digits, x);
  return strtod(text, NULL);
}

void crawler_options(char *text, size_t size, const struct scallop_crawler *c, const bool left_out[7])
{
  static const char *const names[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha" };
  const struct scallop_crawler d = scallop_crawler_default();
  const double defaults[] = { d.m1, d.m2, d.F1, d.F2, d.L, d.T, d.alpha };
  const double values[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  char number[NUMBER_TEXT];
  *text = '\0';
  for (int i = 0; i < 7; i++)
    if (!(left_out && left_out[i]) && values[i] != defaults[i]) {
      number_text(number, values[i], 0);
      snprintf(text + strlen(text), size - strlen(text), " --%s %s", names[i], number);
    }
  if (c->gait != d.gait)
    snprintf(text + strlen(text), size - strlen(text), " --gait %s", c->gait->name);
}

void crawler_command(char *text, size_t size, const char *before, const char *command, const struct scallop_crawler *c,
                     const char *after)
{
  char options[160];
  crawler_options(options, sizeof options, c, NULL);
  snprintf(text, size, "%sscallop %s%s%s", before, command, options, after);
}

void family_points(char *text, size_t size, const struct family *f, const double *x, int count)
{
  static const char *const head[] = { "F1", "F1\\tF2", "T" };
  static const bool in_table[][7] = {
    [VARY_RATIO] = { [2] = true }, [VARY_FORCES] = { [2] = true, [3] = true }, [VARY_PERIOD] = { [5] = true }
  };
  char options[160];
  snprintf(text, size, "printf '%s\\n", head[f->varied]);
  for (int i = 0; i < count; i++) {
    struct scallop_crawler c = family_member(f, x[i]);
    double first = f->varied == VARY_PERIOD ? c.T : c.F1;
    snprintf(text + strlen(text), size - strlen(text), "%.10g", first);
    if (f->varied == VARY_FORCES)
      snprintf(text + strlen(text), size - strlen(text), "\\t%.10g", c.F2);
    snprintf(text + strlen(text), size - strlen(text), "\\n");
  }
  crawler_options(options, sizeof options, &f->crawler, in_table[f->varied]);
  snprintf(text + strlen(text), size - strlen(text), "' | scallop steady --points -%s", options);
}

void family_command(char *text, size_t size, const struct family *f, const double *x, int count)
{
  static const char *const cut[] = { "3,13", "3,4,13", "6,12,13" };
  family_points(text, size, f, x, count);
  snprintf(text + strlen(text), size - strlen(text), " | cut -f %s", cut[f->varied]);
}
