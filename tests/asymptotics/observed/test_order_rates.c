/* How often the verdict on tables of a known kind is right, beside least squares over all points and the mean of the
 * pairwise orders. Prints the table of docs/reference/order.md, and fails where that says something else. */
#include "tests/support/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "asymptotics/observed/order.h"
#include "tests/support/random_crawler.h"

enum { TABLES = 1000, MOST = 24 };
static int tables(void) { return (int)check_cases(TABLES); }
/* No constant of the estimator was chosen with the second one. */
enum { SEED = 20130314, SEED_OF_COVERAGE = 20260101 };
static const double TOLERANCE = 0.1, ROUNDING = 1e-9;

/* What is drawn: a number from low to high, or always the same one */
struct range {
  double low, high;
};

struct table {
  struct scallop_order_point points[MOST];
  int count;
  double expected;
};

/* err = C h^order (1 + c h) from h0, each h the one before over the ratio; then what is done to the errors, noise, and
 * rounding to digits. What the rates are follows from the order in which numbers are drawn. */
struct kind {
  const char *name;
  bool good;
  double least; /* share of right verdicts that is required, in percent */
  struct form {
    struct range rows, order, h0, ratio, c;
    bool off; /* by 0.4, the order */
  } form;
  void (*change)(struct table *t); /* leaves no point where another table is to be drawn */
  double noise;
  int digits, most_digits; /* 0: all of them */
};

static struct random numbers;

static double uniform(double low, double high) { return random_between(&numbers, low, high); }
static int whole(int low, int high) { return low + random_below(&numbers, high - low + 1); }
static double sign(void) { return whole(0, 1) ? 1 : -1; }
/* Normal (Box & Muller) */
static double normal(void) { return sqrt(-2 * log(uniform(1e-300, 1))) * cos(6.283185307179586 * uniform(0, 1)); }
static double coefficient(void) { return pow(10, uniform(-0.5, 1)) * normal(); }

static double any(struct range r) { return r.low == r.high ? r.low : uniform(r.low, r.high); }
static int any_whole(struct range r) { return r.low == r.high ? (int)r.low : whole((int)r.low, (int)r.high); }
/* A range is one of powers of ten. */
static double any_power(struct range r) { return r.low == r.high ? r.low : pow(10, uniform(r.low, r.high)); }

static double printed(double x, int digits)
{
  char text[40];
  snprintf(text, sizeof text, "%.*e", digits - 1, x);
  return strtod(text, NULL);
}

static void print(struct table *t, int digits)
{
  for (int i = 0; i < t->count; i++)
    t->points[i].err = printed(t->points[i].err, digits);
}

static void scatter(struct table *t, double part)
{
  for (int i = 0; i < t->count; i++)
    t->points[i].err *= exp(part * normal());
}

static void fill(struct table *t, int count, double h0, double order, double c, double ratio)
{
  double C = pow(10, uniform(-1, 1));
  t->count = count;
  for (int i = 0; i < count; i++) {
    double h = h0 / pow(ratio, i);
    t->points[i] = (struct scallop_order_point){ .h = h, .err = C * pow(h, order) * (1 + c * h) };
  }
}

static void draw(struct table *t, const struct form *f)
{
  double ratio = any(f->ratio), c, order;
  if (f->off) {
    t->expected = any_whole(f->order);
    c = any(f->c);
    order = t->expected + 0.4 * sign();
  } else {
    c = any(f->c);
    t->expected = order = any_whole(f->order);
  }
  double h0 = any_power(f->h0);
  fill(t, any_whole(f->rows), h0, order, c, ratio);
}

static void make(struct table *t, const struct kind *k)
{
  do {
    t->count = 0;
    if (k->form.rows.low > 0)
      draw(t, &k->form);
    if (k->change)
      k->change(t);
  } while (t->count == 0);
  if (k->noise > 0)
    scatter(t, k->noise);
  if (k->digits > 0)
    print(t, any_whole((struct range){ k->digits, k->most_digits }));
}

/* ---- what is done to the errors, or how a table comes about that is of no such form ---- */

/* What becomes of the errors of the first points, `many`, in terms of err, h and a level */
#define CHANGE(name, many, of_level, to) \
  static void name(struct table *t) \
  { \
    double level = of_level; \
    for (int i = 0; i < (many); i++) { \
      double h = t->points[i].h, err = t->points[i].err; \
      (void)h, (void)err, (void)level; \
      t->points[i].err = (to); \
    } \
  }
CHANGE(roundoff, t->count, 1e-15, err + level * normal())
CHANGE(solver, t->count, 1e-9, fabs(err + level * t->points[0].err * normal()))
CHANGE(bad_start, 2, 0, exp(sign() * uniform(0.5, 1.5)) * err)
CHANGE(first_two, 2, 0, pow(uniform(1.5, 3), sign()) * err)
CHANGE(zeros, t->count, 0, 0 * err)
CHANGE(lower_term, t->count, 0, 2e-3 * h + h * h)
CHANGE(levels_off, t->count, pow(10, uniform(-5, -2)) * t->points[0].err, err + level)

/* Full digits but in the finest row, which is off by 0.1 to 4 % */
static void finest_off(struct table *t) { t->points[t->count - 1].err *= 1 + sign() * pow(10, uniform(-3, -1.4)); }
/* C h^p + D, the finest C h^p from 0.03 to 1 of D */
static void converges_elsewhere(struct table *t)
{
  double level = t->points[t->count - 1].err * pow(10, uniform(0, 1.5));
  for (int i = 0; i < t->count; i++)
    t->points[i].err += level;
  t->count = level >= 1e-9 ? t->count : 0;
}
/* C h^p + D h^s, s = 1 to p - 1, which takes over */
static void reduced(struct table *t)
{
  double finest = t->points[t->count - 1].err * pow(10, uniform(0, 3)), h = t->points[t->count - 1].h;
  double s = finest < 1e-9 ? 0 : whole(1, (int)t->expected - 1);
  t->count = finest < 1e-9 ? 0 : t->count;
  for (int i = 0; i < t->count; i++)
    t->points[i].err += finest * pow(t->points[i].h / h, s);
}

/* err = C h^p (1 + c[0] h^q + c[1] h^2q + c[2] h^3q), positive, and at the finest h the local order is within half the
 * tolerance of p. */
static void smooth(struct table *t, int least, double h0, double q, const double c[3])
{
  double far, C = pow(10, uniform(-1, 1));
  bool positive = true;
  t->expected = whole(1, 4);
  t->count = 0;
  do {
    double h = h0 / pow(2, t->count), u = pow(h, q), sum = 1 + u * (c[0] + u * (c[1] + u * c[2]));
    t->points[t->count++] = (struct scallop_order_point){ .h = h, .err = C * pow(h, t->expected) * sum };
    positive = positive && sum > 0.02;
    far = fabs(q * u * (c[0] + u * (2 * c[1] + u * 3 * c[2])) / sum);
  } while (positive && t->count < MOST && (far > TOLERANCE / 2 || t->count < least));
  if (!positive || far > TOLERANCE / 2)
    smooth(t, least, h0, q, (double[3]){ fabs(c[0]) });
}
static void two_terms(struct table *t)
{
  double c = pow(10, uniform(-1, 3));
  int q = whole(1, 2);
  smooth(t, whole(5, 9), 0.5, q, (double[3]){ c });
}
static void four_terms(struct table *t)
{
  double a = coefficient(), b = coefficient(), c = coefficient();
  int q = whole(1, 2);
  double h0 = pow(10, uniform(-1, 0));
  smooth(t, whole(5, 8), h0, q, (double[3]){ a, b, c });
}

/* The pairwise orders fall from 0.15 or more above the order that is expected to 0.1 or more below it. */
static double pair(const struct table *t, int i)
{
  return log(t->points[i].err / t->points[i + 1].err) / log(t->points[i].h / t->points[i + 1].h);
}
static void falls_through(struct table *t)
{
  double order = whole(1, 3), q = whole(1, 2), c = pow(10, uniform(-2, 0)), ratio = whole(0, 1) ? 2 : 1.5;
  t->expected = order + 0.5 * q;
  fill(t, whole(4, 7), 1, order, 0, ratio);
  for (int i = 0; i < t->count; i++)
    t->points[i].err *= c + pow(t->points[i].h, q);
  print(t, 4);
  if (pair(t, 0) < t->expected + 0.15 || pair(t, t->count - 2) > t->expected - 0.1)
    t->count = 0;
}
static void logarithm(struct table *t)
{
  double h = pow(10, uniform(-4, -1)), ratio = whole(0, 1) ? 2 : 10;
  t->expected = 2;
  t->count = whole(4, 8);
  for (int i = 0; i < t->count; i++, h /= ratio)
    t->points[i] = (struct scallop_order_point){ .h = h, .err = h * h * log(1 / h) };
}
/* Normal errors of this size come on top. */
static void add_floor(struct table *t, double level)
{
  for (int i = 0; i < t->count; i++)
    t->points[i].err = fabs(t->points[i].err + level * normal());
}
/* Rows of slope p, and behind them rows of a rough floor: the level, |normal| times it */
static void on_floor(struct table *t, double ratio)
{
  int rows = whole(2, 8), good = whole(7, 10);
  t->expected = whole(1, 4);
  double h0 = pow(10, uniform(-1, 0));
  fill(t, good + rows, h0, t->expected, 0, ratio);
  add_floor(t, t->points[good - 1].err * pow(ratio, -t->expected * uniform(0, 1)));
}
static void rough_floor(struct table *t) { on_floor(t, 2); }
static void rough_floor_any(struct table *t) { on_floor(t, uniform(1.5, 4)); }
static void long_roundoff(struct table *t)
{
  int good = whole(7, 10);
  double ratio = uniform(2, 4);
  t->expected = whole(3, 4);
  fill(t, good + whole(2, 12), 0.5, t->expected, 0, ratio);
  add_floor(t, t->points[good - 1].err / 30);
}
/* C h^p (1 + c h^-q), q = 1 or 2, the finest local order 0.15 to q below p */
static void lower_term_noisy(struct table *t)
{
  double share = uniform(0.2, 0.9);
  t->expected = whole(2, 4);
  fill(t, whole(5, 9), 0.5, t->expected, 0, 2);
  double q = whole(1, 2), finest = t->points[t->count - 1].h;
  share = 0.15 / q + (1 - 0.15 / q) * share; /* of the lower term at the finest h */
  for (int i = 0; i < t->count; i++)
    t->points[i].err *= 1 + share / (1 - share) * pow(finest / t->points[i].h, q);
}

/* C h^p (1 + c h^q) with noise that may hide the second term */
static void hidden(struct table *t, double c, double q, double noise)
{
  double ratio = whole(0, 1) ? 2 : 1.5;
  t->expected = whole(1, 4);
  fill(t, whole(5, 10), 1, t->expected, 0, ratio);
  for (int i = 0; i < t->count; i++)
    t->points[i].err *= 1 + c * pow(t->points[i].h, q);
  scatter(t, noise);
}
static void hidden_3(struct table *t) { hidden(t, 0.3, 1, 0.01); }
static void hidden_any(struct table *t)
{
  double noise = pow(10, uniform(-3, -1.3)), q = whole(1, 2);
  hidden(t, uniform(-0.5, 1), q, noise);
}
static void straight(struct table *t) { hidden(t, 0, 1, pow(10, uniform(-3, -1.3))); }

/* Rows, p and h0 from and to; then c, or the ratio of h. WRONG: p from 1 to 4. OWN: the table comes about otherwise. */
#define ANY(rows, most, p, high, h0, last, ratio, widest, c, up, off) \
  { \
    { rows, most }, { p, high }, { h0, last }, { ratio, widest }, { c, up }, off \
  }
#define BENT(rows, most, p, high, h0, last, c, up) ANY(rows, most, p, high, h0, last, 2, 2, c, up, false)
#define FORM(rows, most, p, high, h0, last) ANY(rows, most, p, high, h0, last, 2, 2, 0, 0, false)
#define FORM_BY(rows, most, p, high, h0, last, ratio, widest) \
  ANY(rows, most, p, high, h0, last, ratio, widest, 0, 0, false)
#define WRONG(rows, most, h0, last, c, up) ANY(rows, most, 1, 4, h0, last, 2, 2, c, up, true)
#define OWN ANY(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, false)
static const struct kind kinds[] = {
  { "C h^p, 4 or 5 rows, 2 digits", true, 99.8, FORM(4, 5, 1, 4, -2, 0), NULL, 0, 2, 2 },
  { "as above, 3 digits", true, 99.8, FORM(4, 5, 1, 4, -2, 0), NULL, 0, 3, 3 },
  { "as above, 4 digits", true, 99.8, FORM(4, 5, 1, 4, -2, 0), NULL, 0, 4, 4 },
  { "C h^2 (1 + h) from 1/2 to 1/32, 2 to 4 digits", true, 95, BENT(5, 5, 2, 2, 0.5, 0.5, 1, 1), NULL, 0, 2, 4 },
  { "C h^p (1 + c h), -1/2 < c < 1, 5 to 8 rows from 1/2, 4 digits", true, 99.8, BENT(5, 8, 1, 4, 0.5, 0.5, -0.5, 1),
    NULL, 0, 4, 4 },
  { "C h^p (1 + c h^q), q = 1 or 2, c to 1000, finest local order within 0.05 of p", true, 99.8, OWN, two_terms, 0, 0,
    0 },
  { "C h^p (1 + a h^q + b h^2q + c h^3q), as above", true, 95, OWN, four_terms, 0, 0, 0 },
  { "C h^p, 12 rows, 5 % noise", true, 95, FORM(12, 12, 1, 4, 0.5, 0.5), NULL, 0.05, 0, 0 },
  { "as above, h over 1.3 from row to row", true, 95, FORM_BY(12, 12, 1, 4, 0.5, 0.5, 1.3, 1.3), NULL, 0.05, 0, 0 },
  { "C h^p, 8 rows, 5 % noise", true, 95, FORM(8, 8, 1, 4, 0.5, 0.5), NULL, 0.05, 0, 0 },
  { "C h^p, 5 rows, 5 % noise", true, 0, FORM(5, 5, 1, 4, 0.5, 0.5), NULL, 0.05, 0, 0 },
  { "C h^p, 4 rows, 5 % noise", true, 0, FORM(4, 4, 1, 4, 0.5, 0.5), NULL, 0.05, 0, 0 },
  { "C h^p (1 + c h), 20 rows, roundoff 1e-15", true, 99.8, BENT(20, 20, 2, 4, 0.5, 0.5, -0.5, 1), roundoff, 0, 0, 0 },
  { "C h^p (1 + c h), 14 rows, noise of 1e-9 of the first error", true, 95, BENT(14, 14, 2, 4, 0.5, 0.5, -0.5, 1),
    solver, 0, 0, 0 },
  { "C h^p, 10 rows, the first two wrong by 1.6 to 4.5, 1 % noise", true, 95, FORM(10, 10, 1, 4, 0.5, 0.5), bad_start,
    0.01, 0, 0 },
  { "C h^p, 5 to 7 rows, 1 % noise", true, 98, FORM(5, 7, 1, 4, 0.5, 0.5), NULL, 0.01, 0, 0 },
  { "C h^p, 5 to 8 rows, full digits, the finest off by 0.1 to 4 %", true, 99.8, FORM(5, 8, 1, 4, -1, 0), finest_off, 0,
    0, 0 },
  { "C h^p, 5 to 10 rows, full digits, the first two off by a factor 1.5 to 3", true, 98, FORM(5, 10, 1, 4, 0.5, 0.5),
    first_two, 0, 17, 17 },
  { "as above, 3 digits", true, 98, FORM(5, 10, 1, 4, 0.5, 0.5), first_two, 0, 3, 3 },
  { "C h^p, 7 to 10 rows, and 2 to 8 rows at a rough floor", true, 90, OWN, rough_floor, 0, 0, 0 },
  { "as above, h over 1.5 to 4 from row to row, 3 digits", true, 93, OWN, rough_floor_any, 0, 3, 3 },
  { "C h^p, 7 to 10 rows, 2 to 12 rows of noise 1/30 of the finest of these", true, 97, OWN, long_roundoff, 0, 0, 0 },
  { "all errors 0", true, 100, FORM(3, 8, 1, 4, 1, 1), zeros, 0, 0, 0 },
  { "C h^(p +- 0.4), 4 to 8 rows, 2 to 4 digits", false, 100, WRONG(4, 8, -2, 0, 0, 0), NULL, 0, 2, 4 },
  { "C h^(p +- 0.4), 4 to 12 rows, 5 % noise", false, 100, WRONG(4, 12, 0.5, 0.5, 0, 0), NULL, 0.05, 0, 0 },
  { "C h^(p +- 0.4) (1 + c h), 4 to 8 rows from 1/2", false, 100, WRONG(4, 8, 0.5, 0.5, -0.5, 1), NULL, 0, 2, 4 },
  { "h^2 + 2e-3 h, 5 to 10 rows from 0.1 to 1", false, 100, FORM(5, 10, 2, 2, -1, 0), lower_term, 0, 17, 17 },
  { "as above, 3 digits", false, 95, FORM(5, 10, 2, 2, -1, 0), lower_term, 0, 3, 3 },
  { "C h^p (c + h^q), q = 1 or 2, 4 digits, pairwise orders fall through the expected p + q/2", false, 99, OWN,
    falls_through, 0, 0, 0 },
  { "h^2 log(1/h), 4 to 8 rows", false, 100, OWN, logarithm, 0, 17, 17 },
  { "as above, 4 digits", false, 85, OWN, logarithm, 0, 4, 4 },
  { "C h^p + a plateau at 1e-5 to 1e-2 of the first error, 10 rows", false, 100, FORM(10, 10, 1, 4, 0.5, 0.5),
    levels_off, 0, 0, 0 },
  { "C h^p + D, 6 to 12 rows, the finest C h^p 0.03 to 1 of D", false, 99.8, FORM_BY(6, 12, 1, 4, 0.5, 0.5, 1.8, 4),
    converges_elsewhere, 0, 17, 17 },
  { "as above, 3 digits", false, 99.8, FORM_BY(6, 12, 1, 4, 0.5, 0.5, 1.8, 4), converges_elsewhere, 0, 3, 3 },
  { "C h^p (1 + c h^-q), q = 1 or 2, 1 % noise, 5 to 9 rows", false, 97, OWN, lower_term_noisy, 0.01, 0, 0 },
  { "C h^p + D h^s, s = 1 to p - 1, which takes over, 6 to 12 rows", false, 99.8,
    FORM_BY(6, 12, 2, 5, 0.5, 0.5, 1.8, 4), reduced, 0, 17, 17 },
  { "as above, 3 digits", false, 99.8, FORM_BY(6, 12, 2, 5, 0.5, 0.5, 1.8, 4), reduced, 0, 3, 3 },
};
/* good: errors scatter, which is what confidence-95 is about. */
static const struct kind covered[] = {
  { "C h^p, 5 to 10 rows, 0.1 to 5 % noise", true, 0, OWN, straight, 0, 0, 0 },
  { "C h^p, 12 to 24 rows, 5 % noise", true, 0, FORM_BY(12, MOST, 1, 4, 1, 1, 1.2, 2), NULL, 0.05, 0, 0 },
  { "C h^p, 4 to 8 rows, 2 to 4 digits", true, 0, FORM(4, 8, 1, 4, -2, 0), NULL, 0, 2, 4 },
  { "C h^p, 7 to 10 rows, and 2 to 8 rows at a rough floor", true, 0, OWN, rough_floor, 0, 0, 0 },
  { "C h^p, 10 rows, the first two wrong by 1.6 to 4.5, 1 % noise", true, 0, FORM(10, 10, 1, 4, 0.5, 0.5), bad_start,
    0.01, 0, 0 },
  { "C h^p (1 + 0.3 h), 5 to 10 rows from 1, 1 % noise", true, 0, OWN, hidden_3, 0, 0, 0 },
  { "C h^p (1 + c h^q), q = 1 or 2, -1/2 < c < 1, 5 to 10 rows from 1, 0.1 to 5 % noise", true, 0, OWN, hidden_any, 0,
    0, 0 },
  { "C h^p (1 + c h), -1/2 < c < 1, 5 to 8 rows from 1/2, 4 digits", false, 0, BENT(5, 8, 1, 4, 0.5, 0.5, -0.5, 1),
    NULL, 0, 4, 4 },
  { "C h^p (1 + c h^q), q = 1 or 2, c to 1000", false, 0, OWN, two_terms, 0, 0, 0 },
  { "C h^p (1 + a h^q + b h^2q + c h^3q)", false, 0, OWN, four_terms, 0, 0, 0 },
};

static double pairwise_mean(const struct table *t)
{
  double sum = 0;
  for (int i = 1; i < t->count; i++)
    sum += log(t->points[i - 1].err / t->points[i].err) / log(t->points[i - 1].h / t->points[i].h) / (t->count - 1);
  return sum;
}

static double least_squares(const struct table *t)
{
  double n = t->count, x = 0, y = 0, xx = 0, xy = 0;
  for (int i = 0; i < t->count; i++) {
    double lx = log(t->points[i].h), ly = log(fabs(t->points[i].err));
    x += lx;
    y += ly;
    xx += lx * lx;
    xy += lx * ly;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

enum { VERDICT, SQUARES, MEAN, RULES };

static void count_passes(const struct kind *k, double share[RULES], int *all_used)
{
  int passes[RULES] = { 0 };
  numbers.state = SEED;
  *all_used = 0;
  for (int i = 0; i < tables(); i++) {
    struct table t;
    make(&t, k);
    passes[SQUARES] += fabs(least_squares(&t) - t.expected) <= TOLERANCE;
    passes[MEAN] += fabs(pairwise_mean(&t) - t.expected) <= TOLERANCE;
    struct scallop_order_wanted wanted = { .order = t.expected, .tolerance = TOLERANCE };
    struct scallop_order_result result;
    scallop_order(t.points, &t.count, &wanted, &result);
    passes[VERDICT] += result.verdict == SCALLOP_ORDER_PASS;
    *all_used += result.used == t.count;
  }
  for (int r = 0; r < RULES; r++)
    share[r] = 100.0 * passes[r] / tables();
}

/* Does the page have this row? */
static bool says(const char *row)
{
  char line[400];
  bool found = false;
  FILE *page = fopen("docs/reference/order.md", "r");
  assert_non_null(page);
  while (!found && fgets(line, sizeof line, page))
    found = strcmp(line, row) == 0;
  fclose(page);
  return found;
}

TEST(rates)
{
  bool kept = true;
  int all_used;
  puts("| tables | should pass | `scallop order` | least squares | mean of pairs |\n|---|---|---|---|---|");
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
    const struct kind *k = &kinds[i];
    double share[RULES];
    count_passes(k, share, &all_used);
    char row[400];
    snprintf(row, sizeof row, "| %s | %s | %.1f %% | %.1f %% | %.1f %% |\n", k->name, k->good ? "yes" : "no",
             share[VERDICT], share[SQUARES], share[MEAN]);
    fputs(row, stdout);
    if (!says(row)) {
      print_error("docs/reference/order.md does not have this row\n");
      kept = false;
    }
    double right = k->good ? share[VERDICT] : 100 - share[VERDICT];
    if (right < k->least) {
      print_error("%s: right in %g %%, required %g %%\n", k->name, right, k->least);
      kept = false;
    }
    if (k->noise == 0.05 && k->form.rows.low == 12 && all_used < 0.99 * tables()) {
      print_error("all points used in %g %%\n", 100.0 * all_used / tables());
      kept = false;
    }
  }
  assert_true(kept);
}

enum { NAMES = SCALLOP_ORDER_PAIRWISE, FEW_GIVEN = 10 };

static void count_held(const struct kind *k, int given[NAMES + 1], int held[NAMES + 1])
{
  numbers.state = SEED_OF_COVERAGE;
  for (int i = 0; i < tables(); i++) {
    struct table t;
    make(&t, k);
    struct scallop_order_wanted wanted = { .order = NAN, .tolerance = TOLERANCE };
    struct scallop_order_result r;
    scallop_order(t.points, &t.count, &wanted, &r);
    given[r.interval]++;
    held[r.interval] += r.low - ROUNDING <= t.expected && t.expected <= r.high + ROUNDING;
  }
}

/* How often an interval holds the order, where none is expected: confidence-95 in 95 % or more, within three standard
 * deviations of the count, wherever errors scatter, though a second term may hide in the scatter. */
TEST(coverage)
{
  bool kept = true;
  puts("| tables | `confidence-95` | `slope-95` | `limit` |\n|---|---|---|---|");
  for (size_t k = 0; k < sizeof covered / sizeof *covered; k++) {
    int given[NAMES + 1] = { 0 }, held[NAMES + 1] = { 0 };
    count_held(&covered[k], given, held);
    char row[400];
    int used = snprintf(row, sizeof row, "| %s |", covered[k].name);
    for (int n = SCALLOP_ORDER_CONFIDENCE; n < NAMES; n++)
      used += given[n] < FEW_GIVEN ? snprintf(row + used, sizeof row - (size_t)used, " - |")
                                   : snprintf(row + used, sizeof row - (size_t)used, " %.1f %% of %d |",
                                              100.0 * held[n] / given[n], given[n]);
    snprintf(row + used, sizeof row - (size_t)used, "\n");
    fputs(row, stdout);
    double n = given[SCALLOP_ORDER_CONFIDENCE], least = 0.95 * n - 3 * sqrt(0.95 * 0.05 * n);
    if (!says(row) || (covered[k].good && held[SCALLOP_ORDER_CONFIDENCE] < least)) {
      print_error("docs/reference/order.md does not have this row, or fewer than %g hold the order\n", least);
      kept = false;
    }
  }
  assert_true(kept);
}
