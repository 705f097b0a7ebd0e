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

struct table {
  struct scallop_order_point points[MOST];
  int count;
  double expected;
};

static struct random numbers;

static double uniform(double low, double high) { return random_between(&numbers, low, high); }
static int whole(int low, int high) { return low + random_below(&numbers, high - low + 1); }
static double sign(void) { return whole(0, 1) ? 1 : -1; }
/* Normal (Box & Muller) */
static double normal(void) { return sqrt(-2 * log(uniform(1e-300, 1))) * cos(6.283185307179586 * uniform(0, 1)); }

static double printed(double x, int digits)
{
  char text[40];
  snprintf(text, sizeof text, "%.*e", digits - 1, x);
  return strtod(text, NULL);
}

/* err = C h^order (1 + relative c h) from h0, each h the one before over ratio */
static void fill_by(struct table *t, int count, double h0, double order, double c, double ratio)
{
  double C = pow(10, uniform(-1, 1));
  t->count = count;
  for (int i = 0; i < count; i++) {
    double h = h0 / pow(ratio, i);
    t->points[i] = (struct scallop_order_point){ .h = h, .err = C * pow(h, order) * (1 + c * h) };
  }
}
static void fill(struct table *t, int count, double h0, double order, double c) { fill_by(t, count, h0, order, c, 2); }
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

static void clean(struct table *t, int digits)
{
  fill(t, whole(4, 5), pow(10, uniform(-2, 0)), t->expected = whole(1, 4), 0);
  print(t, digits);
}
static void clean_2(struct table *t) { clean(t, 2); }
static void clean_3(struct table *t) { clean(t, 3); }
static void clean_4(struct table *t) { clean(t, 4); }
static void corrected(struct table *t)
{
  fill(t, whole(5, 8), 0.5, t->expected = whole(1, 4), uniform(-0.5, 1));
  print(t, 4);
}
static void corrected_2(struct table *t)
{
  fill(t, 5, 0.5, t->expected = 2, 1);
  print(t, whole(2, 4));
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
  smooth(t, whole(5, 9), 0.5, whole(1, 2), (double[3]){ pow(10, uniform(-1, 3)) });
}
static double coefficient(void) { return pow(10, uniform(-0.5, 1)) * normal(); }
static void four_terms(struct table *t)
{
  smooth(t, whole(5, 8), pow(10, uniform(-1, 0)), whole(1, 2),
         (double[3]){ coefficient(), coefficient(), coefficient() });
}
static void noisy(struct table *t, int count, double order)
{
  fill(t, count, 0.5, order, 0);
  scatter(t, 0.05);
}
static void noisy_close(struct table *t)
{
  fill_by(t, 12, 0.5, t->expected = whole(1, 4), 0, 1.3);
  scatter(t, 0.05);
}
static void noisy_12(struct table *t) { noisy(t, 12, t->expected = whole(1, 4)); }
static void noisy_8(struct table *t) { noisy(t, 8, t->expected = whole(1, 4)); }
static void noisy_4(struct table *t) { noisy(t, 4, t->expected = whole(1, 4)); }
static void noisy_5(struct table *t) { noisy(t, 5, t->expected = whole(1, 4)); }
static void roundoff(struct table *t)
{
  fill(t, 20, 0.5, t->expected = whole(2, 4), uniform(-0.5, 1));
  for (int i = 0; i < t->count; i++)
    t->points[i].err += 1e-15 * normal();
}
static void solver(struct table *t)
{
  fill(t, 14, 0.5, t->expected = whole(2, 4), uniform(-0.5, 1));
  for (int i = 0; i < t->count; i++)
    t->points[i].err = fabs(t->points[i].err + 1e-9 * t->points[0].err * normal());
}
static void bad_start(struct table *t)
{
  fill(t, 10, 0.5, t->expected = whole(1, 4), 0);
  for (int i = 0; i < 2; i++)
    t->points[i].err *= exp(sign() * uniform(0.5, 1.5));
  scatter(t, 0.01);
}
static void zeros(struct table *t)
{
  fill(t, whole(3, 8), 1, t->expected = whole(1, 4), 0);
  for (int i = 0; i < t->count; i++)
    t->points[i].err = 0;
}
static void wrong_clean(struct table *t)
{
  t->expected = whole(1, 4);
  fill(t, whole(4, 8), pow(10, uniform(-2, 0)), t->expected + 0.4 * sign(), 0);
  print(t, whole(2, 4));
}
static void wrong_noisy(struct table *t)
{
  t->expected = whole(1, 4);
  noisy(t, whole(4, 12), t->expected + 0.4 * sign());
}
static void wrong_bent(struct table *t)
{
  t->expected = whole(1, 4);
  fill(t, whole(4, 8), 0.5, t->expected + 0.4 * sign(), uniform(-0.5, 1));
  print(t, whole(2, 4));
}
static void lower_term(struct table *t, int digits)
{
  double h0 = pow(10, uniform(-1, 0));
  fill(t, whole(5, 10), h0, 2, 0);
  for (int i = 0; i < t->count; i++) {
    double h = t->points[i].h;
    t->points[i].err = printed(h * h + 2e-3 * h, digits);
  }
  t->expected = 2;
}
static void lower_term_exact(struct table *t) { lower_term(t, 17); }
static void lower_term_3(struct table *t) { lower_term(t, 3); }
/* The pairwise orders fall from 0.15 or more above the order that is expected to 0.1 or more below it. */
static double pair(const struct table *t, int i)
{
  return log(t->points[i].err / t->points[i + 1].err) / log(t->points[i].h / t->points[i + 1].h);
}
static void falls_through(struct table *t)
{
  do {
    double order = whole(1, 3), q = whole(1, 2), c = pow(10, uniform(-2, 0));
    t->expected = order + 0.5 * q;
    fill_by(t, whole(4, 7), 1, order, 0, whole(0, 1) ? 2 : 1.5);
    for (int i = 0; i < t->count; i++)
      t->points[i].err *= c + pow(t->points[i].h, q);
    print(t, 4);
  } while (pair(t, 0) < t->expected + 0.15 || pair(t, t->count - 2) > t->expected - 0.1);
}
static void logarithm(struct table *t, int digits)
{
  double h0 = pow(10, uniform(-4, -1)), ratio = whole(0, 1) ? 2 : 10;
  t->count = whole(4, 8);
  for (int i = 0; i < t->count; i++, h0 /= ratio)
    t->points[i] = (struct scallop_order_point){ .h = h0, .err = printed(h0 * h0 * log(1 / h0), digits) };
  t->expected = 2;
}
static void logarithm_exact(struct table *t) { logarithm(t, 17); }
static void logarithm_4(struct table *t) { logarithm(t, 4); }
static void levels_off(struct table *t)
{
  fill(t, 10, 0.5, t->expected = whole(1, 4), 0);
  double level = t->points[0].err * pow(10, uniform(-5, -2));
  for (int i = 0; i < t->count; i++)
    t->points[i].err += level;
}

/* Full digits but in the finest row, which is off by 0.1 to 4 % */
static void finest_off(struct table *t)
{
  fill(t, whole(5, 8), pow(10, uniform(-1, 0)), t->expected = whole(1, 4), 0);
  t->points[t->count - 1].err *= 1 + sign() * pow(10, uniform(-3, -1.4));
}
/* Rows of slope p, and behind them rows of a rough floor: the level, |normal| times it */
static void on_floor(struct table *t, int good, int rows, double ratio)
{
  fill_by(t, good + rows, pow(10, uniform(-1, 0)), t->expected = whole(1, 4), 0, ratio);
  double level = t->points[good - 1].err * pow(ratio, -t->expected * uniform(0, 1));
  for (int i = 0; i < t->count; i++)
    t->points[i].err = fabs(t->points[i].err + level * normal());
}
static void rough_floor(struct table *t) { on_floor(t, whole(7, 10), whole(2, 8), 2); }
static void rough_floor_printed(struct table *t)
{
  on_floor(t, whole(7, 10), whole(2, 8), uniform(1.5, 4));
  print(t, 3);
}
static void long_roundoff(struct table *t)
{
  int good = whole(7, 10);
  fill_by(t, good + whole(2, 12), 0.5, t->expected = whole(3, 4), 0, uniform(2, 4));
  double level = t->points[good - 1].err / 30;
  for (int i = 0; i < t->count; i++)
    t->points[i].err = fabs(t->points[i].err + level * normal());
}
static void noisy_1(struct table *t)
{
  fill(t, whole(5, 7), 0.5, t->expected = whole(1, 4), 0);
  scatter(t, 0.01);
}
static void first_two(struct table *t, int digits)
{
  fill(t, whole(5, 10), 0.5, t->expected = whole(1, 4), 0);
  for (int i = 0; i < 2; i++)
    t->points[i].err *= pow(uniform(1.5, 3), sign());
  print(t, digits);
}
static void first_two_full(struct table *t) { first_two(t, 17); }
static void first_two_3(struct table *t) { first_two(t, 3); }
/* C h^p + D, the finest C h^p from 0.03 to 1 of D */
static void converges_elsewhere(struct table *t, int digits)
{
  double level;
  do {
    fill_by(t, whole(6, 12), 0.5, t->expected = whole(1, 4), 0, uniform(1.8, 4));
    level = t->points[t->count - 1].err * pow(10, uniform(0, 1.5));
  } while (level < 1e-9);
  for (int i = 0; i < t->count; i++)
    t->points[i].err += level;
  print(t, digits);
}
static void plateau_full(struct table *t) { converges_elsewhere(t, 17); }
static void plateau_3(struct table *t) { converges_elsewhere(t, 3); }
/* C h^p (1 + c h^-q), q = 1 or 2, the finest local order 0.15 to q below p */
static void lower_term_noisy(struct table *t)
{
  double q, share = uniform(0.2, 0.9);
  fill(t, whole(5, 9), 0.5, t->expected = whole(2, 4), 0);
  q = whole(1, 2);
  share = 0.15 / q + (1 - 0.15 / q) * share; /* of the lower term at the finest h */
  double finest = t->points[t->count - 1].h;
  for (int i = 0; i < t->count; i++)
    t->points[i].err *= 1 + share / (1 - share) * pow(finest / t->points[i].h, q);
  scatter(t, 0.01);
}

/* C h^p + D h^s, s = 1 to p - 1, which takes over */
static void reduced(struct table *t, int digits)
{
  double finest;
  do {
    fill_by(t, whole(6, 12), 0.5, t->expected = whole(2, 5), 0, uniform(1.8, 4));
    finest = t->points[t->count - 1].err * pow(10, uniform(0, 3));
  } while (finest < 1e-9);
  double s = whole(1, (int)t->expected - 1), h = t->points[t->count - 1].h;
  for (int i = 0; i < t->count; i++)
    t->points[i].err += finest * pow(t->points[i].h / h, s);
  print(t, digits);
}
static void reduced_full(struct table *t) { reduced(t, 17); }
static void reduced_3(struct table *t) { reduced(t, 3); }

static const struct kind {
  const char *name;
  void (*make)(struct table *t);
  bool good;
  double least; /* share of right verdicts that is required, in percent */
} kinds[] = {
  { "C h^p, 4 or 5 rows, 2 digits", clean_2, true, 99.8 },
  { "as above, 3 digits", clean_3, true, 99.8 },
  { "as above, 4 digits", clean_4, true, 99.8 },
  { "C h^2 (1 + h) from 1/2 to 1/32, 2 to 4 digits", corrected_2, true, 95 },
  { "C h^p (1 + c h), -1/2 < c < 1, 5 to 8 rows from 1/2, 4 digits", corrected, true, 99.8 },
  { "C h^p (1 + c h^q), q = 1 or 2, c to 1000, finest local order within 0.05 of p", two_terms, true, 99.8 },
  { "C h^p (1 + a h^q + b h^2q + c h^3q), as above", four_terms, true, 95 },
  { "C h^p, 12 rows, 5 % noise", noisy_12, true, 95 },
  { "as above, h over 1.3 from row to row", noisy_close, true, 95 },
  { "C h^p, 8 rows, 5 % noise", noisy_8, true, 95 },
  { "C h^p, 5 rows, 5 % noise", noisy_5, true, 0 },
  { "C h^p, 4 rows, 5 % noise", noisy_4, true, 0 },
  { "C h^p (1 + c h), 20 rows, roundoff 1e-15", roundoff, true, 99.8 },
  { "C h^p (1 + c h), 14 rows, noise of 1e-9 of the first error", solver, true, 95 },
  { "C h^p, 10 rows, the first two wrong by 1.6 to 4.5, 1 % noise", bad_start, true, 95 },
  { "C h^p, 5 to 7 rows, 1 % noise", noisy_1, true, 98 },
  { "C h^p, 5 to 8 rows, full digits, the finest off by 0.1 to 4 %", finest_off, true, 99.8 },
  { "C h^p, 5 to 10 rows, full digits, the first two off by a factor 1.5 to 3", first_two_full, true, 98 },
  { "as above, 3 digits", first_two_3, true, 98 },
  { "C h^p, 7 to 10 rows, and 2 to 8 rows at a rough floor", rough_floor, true, 90 },
  { "as above, h over 1.5 to 4 from row to row, 3 digits", rough_floor_printed, true, 93 },
  { "C h^p, 7 to 10 rows, 2 to 12 rows of noise 1/30 of the finest of these", long_roundoff, true, 97 },
  { "all errors 0", zeros, true, 100 },
  { "C h^(p +- 0.4), 4 to 8 rows, 2 to 4 digits", wrong_clean, false, 100 },
  { "C h^(p +- 0.4), 4 to 12 rows, 5 % noise", wrong_noisy, false, 100 },
  { "C h^(p +- 0.4) (1 + c h), 4 to 8 rows from 1/2", wrong_bent, false, 100 },
  { "h^2 + 2e-3 h, 5 to 10 rows from 0.1 to 1", lower_term_exact, false, 100 },
  { "as above, 3 digits", lower_term_3, false, 95 },
  { "C h^p (c + h^q), q = 1 or 2, 4 digits, pairwise orders fall through the expected p + q/2", falls_through, false,
    99 },
  { "h^2 log(1/h), 4 to 8 rows", logarithm_exact, false, 100 },
  { "as above, 4 digits", logarithm_4, false, 85 },
  { "C h^p + a plateau at 1e-5 to 1e-2 of the first error, 10 rows", levels_off, false, 100 },
  { "C h^p + D, 6 to 12 rows, the finest C h^p 0.03 to 1 of D", plateau_full, false, 99.8 },
  { "as above, 3 digits", plateau_3, false, 99.8 },
  { "C h^p (1 + c h^-q), q = 1 or 2, 1 % noise, 5 to 9 rows", lower_term_noisy, false, 97 },
  { "C h^p + D h^s, s = 1 to p - 1, which takes over, 6 to 12 rows", reduced_full, false, 99.8 },
  { "as above, 3 digits", reduced_3, false, 99.8 },
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
    k->make(&t);
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
    if ((k->make == noisy_12 || k->make == noisy_close) && all_used < 0.99 * tables()) {
      print_error("all points used in %g %%\n", 100.0 * all_used / tables());
      kept = false;
    }
  }
  assert_true(kept);
}

/* C h^p (1 + c h^q) with noise that may hide the second term */
static void hidden(struct table *t, double c, double q, double noise)
{
  fill_by(t, whole(5, 10), 1, t->expected = whole(1, 4), 0, whole(0, 1) ? 2 : 1.5);
  for (int i = 0; i < t->count; i++)
    t->points[i].err *= 1 + c * pow(t->points[i].h, q);
  scatter(t, noise);
}
static void hidden_3(struct table *t) { hidden(t, 0.3, 1, 0.01); }
static void hidden_any(struct table *t) { hidden(t, uniform(-0.5, 1), whole(1, 2), pow(10, uniform(-3, -1.3))); }
static void straight(struct table *t) { hidden(t, 0, 1, pow(10, uniform(-3, -1.3))); }
static void straight_long(struct table *t)
{
  fill_by(t, whole(12, MOST), 1, t->expected = whole(1, 4), 0, uniform(1.2, 2));
  scatter(t, 0.05);
}
static void clean_any(struct table *t)
{
  fill(t, whole(4, 8), pow(10, uniform(-2, 0)), t->expected = whole(1, 4), 0);
  print(t, whole(2, 4));
}

static const struct {
  const char *name;
  void (*make)(struct table *t);
  bool scatters; /* what confidence-95 is about */
} covered[] = {
  { "C h^p, 5 to 10 rows, 0.1 to 5 % noise", straight, true },
  { "C h^p, 12 to 24 rows, 5 % noise", straight_long, true },
  { "C h^p, 4 to 8 rows, 2 to 4 digits", clean_any, true },
  { "C h^p, 7 to 10 rows, and 2 to 8 rows at a rough floor", rough_floor, true },
  { "C h^p, 10 rows, the first two wrong by 1.6 to 4.5, 1 % noise", bad_start, true },
  { "C h^p (1 + 0.3 h), 5 to 10 rows from 1, 1 % noise", hidden_3, true },
  { "C h^p (1 + c h^q), q = 1 or 2, -1/2 < c < 1, 5 to 10 rows from 1, 0.1 to 5 % noise", hidden_any, true },
  { "C h^p (1 + c h), -1/2 < c < 1, 5 to 8 rows from 1/2, 4 digits", corrected, false },
  { "C h^p (1 + c h^q), q = 1 or 2, c to 1000", two_terms, false },
  { "C h^p (1 + a h^q + b h^2q + c h^3q)", four_terms, false },
};
enum { NAMES = SCALLOP_ORDER_PAIRWISE, FEW_GIVEN = 10 };

static void count_held(void (*make)(struct table *t), int given[NAMES + 1], int held[NAMES + 1])
{
  numbers.state = SEED_OF_COVERAGE;
  for (int i = 0; i < tables(); i++) {
    struct table t;
    make(&t);
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
    count_held(covered[k].make, given, held);
    char row[400];
    int used = snprintf(row, sizeof row, "| %s |", covered[k].name);
    for (int n = SCALLOP_ORDER_CONFIDENCE; n < NAMES; n++)
      used += given[n] < FEW_GIVEN ? snprintf(row + used, sizeof row - (size_t)used, " - |")
                                   : snprintf(row + used, sizeof row - (size_t)used, " %.1f %% of %d |",
                                              100.0 * held[n] / given[n], given[n]);
    snprintf(row + used, sizeof row - (size_t)used, "\n");
    fputs(row, stdout);
    double n = given[SCALLOP_ORDER_CONFIDENCE], least = 0.95 * n - 3 * sqrt(0.95 * 0.05 * n);
    if (!says(row) || (covered[k].scatters && held[SCALLOP_ORDER_CONFIDENCE] < least)) {
      print_error("docs/reference/order.md does not have this row, or fewer than %g hold the order\n", least);
      kept = false;
    }
  }
  assert_true(kept);
}
