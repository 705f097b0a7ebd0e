/* Measured gaits: that curves through exact samples come near the gait, that a recording is understood however it is
 * given, and that the truth lies within the stated interval as often as docs/reference/gaits.md says. RECORDINGS=400
 * build/test_measured prints the table of that page. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/families.h"
#include "model/measured/curve_gait.h"
#include "model/measured/measured.h"
#include "numerics/numerics.h"
#include "tests/support/check.h"
#include "tests/support/random_crawler.h"

enum { MOST = 2600, GAITS = 8, NOISES = 3 };

struct rows {
  double t[MOST], l[MOST];
  int count;
};

static double length_at(const struct scallop_crawler *c, double t)
{
  double s = t / c->T - floor(t / c->T), l;
  if (s < c->alpha)
    scallop_gait_at(c->gait, SCALLOP_EXTENSION, s / c->alpha, &l, NULL, NULL);
  else
    scallop_gait_at(c->gait, SCALLOP_CONTRACTION, fmin((s - c->alpha) / (1 - c->alpha), 1), &l, NULL, NULL);
  return c->L * l;
}

static double normal(struct random *r)
{
  double u = random_between(r, 0x1p-50, 1), v = random_between(r, 0, 1);
  return sqrt(-2 * log(u)) * cos(6.283185307179586 * v);
}

/* count rows of so many periods, from a start in the period on; all in units of T and L */
struct recording {
  int count;
  double periods, start, jitter, noise, drift;
};

static void record(struct rows *rows, const struct scallop_crawler *c, const struct recording *how, struct random *r)
{
  rows->count = how->count;
  for (int i = 0; i < how->count; i++) {
    double part = (i + how->jitter * random_between(r, -0.5, 0.5)) / how->count, t = part * how->periods;
    rows->t[i] = t * c->T;
    rows->l[i] = length_at(c, (t + how->start) * c->T) + c->L * (how->noise * normal(r) + how->drift * (part - 0.5));
  }
}

static struct scallop_crawler with_gait(struct scallop_crawler c, struct scallop_measured_gait g)
{
  c.gait = g.gait;
  c.L = g.L;
  c.T = g.T;
  c.alpha = g.alpha;
  return c;
}

static double displacement(const struct scallop_crawler *c)
{
  struct scallop_steady_result s;
  return c->gait && scallop_steady(c, &s) >= 0 ? s.period.displacement : NAN;
}

static struct scallop_measured *measured_by(const struct rows *rows, enum scallop_fit fit, double sigma)
{
  const struct scallop_measured_options options = { .fit = fit, .sigma = sigma };
  const char *why = NULL;
  struct scallop_measured *m = scallop_measured_new(rows->t, rows->l, rows->count, &options, "x", &why);
  if (!m)
    fail_msg("%s", why);
  return m;
}
static struct scallop_measured *measured_with(const struct rows *rows, enum scallop_fit fit)
{
  return measured_by(rows, fit, 0);
}

/* The displacement with the measured gait; *error: what is said of it */
static double answer(const struct scallop_crawler *true_one, const struct rows *rows, double *error)
{
  double others[SCALLOP_MEASURED_OTHERS];
  struct scallop_measured *m = measured_with(rows, SCALLOP_FIT_CHOSEN);
  struct scallop_crawler c = with_gait(*true_one, scallop_measured_gait(m, SCALLOP_MEASURED_BEST));
  double value = displacement(&c);
  for (int i = 0; i < SCALLOP_MEASURED_OTHERS; i++) {
    c = with_gait(*true_one, scallop_measured_gait(m, i));
    others[i] = displacement(&c);
  }
  *error = scallop_measured_error(value, others);
  scallop_measured_free(m);
  return value;
}

static const struct scallop_gait *some_gait(union scallop_made_gait *made, int which)
{
  static const struct {
    const struct scallop_gait_family *family;
    double x[7];
    int count;
  } gaits[GAITS] = { { &scallop_family_quadratic, { 0 }, 0 },
                     { &scallop_family_sinusoidal, { 0 }, 0 },
                     { &scallop_family_polynomial, { 0, 0, 10, -15, 6 }, 5 },
                     { &scallop_family_trapezoidal, { 0.25, 0.25 }, 2 },
                     { &scallop_family_skewed, { 0.3 }, 1 },
                     { &scallop_family_constant, { 0.1 }, 1 },
                     { &scallop_family_trapezoidal, { 0.1, 0.4 }, 2 },
                     { &scallop_family_polynomial, { 0, 0, 0, 35, -84, 70, -20 }, 7 } };
  const struct scallop_gait_family *family = gaits[which].family;
  const char *why;
  if (!family->fixed)
    assert_int_equal(scallop_make_gait(made, family, "x", gaits[which].x, gaits[which].count, &why), SCALLOP_OK);
  return family->fixed ? family->fixed : &made->gait;
}

struct tally {
  int inside[NOISES][GAITS], all[NOISES][GAITS];
  double width[NOISES], error[NOISES]; /* sums of logarithms, in units of L */
};

static void one_recording(struct tally *tally, struct random *r, int most_rows)
{
  static struct rows rows;
  union scallop_made_gait made;
  int which = random_below(r, GAITS), loud = random_below(r, NOISES);
  const double low[NOISES] = { 0, 1e-4, 3e-3 }, high[NOISES] = { 0, 3e-3, 2e-2 };
  struct scallop_crawler c = { random_between(r, 0.5, 1.5),  random_between(r, 0.5, 1.5), random_between(r, 0.5, 4.5),
                               random_between(r, 0.5, 4.5),  random_between(r, 1, 10),    random_decades(r, 0.2, 3),
                               random_between(r, 0.3, 0.75), some_gait(&made, which) };
  struct recording how = { .count = (int)random_decades(r, 20, most_rows),
                           .periods = 1,
                           .start = random_between(r, 0, 1) };
  how.noise = loud > 0 ? random_decades(r, low[loud], high[loud]) : 0;
  how.jitter = random_below(r, 2) ? random_between(r, 0, 0.4) : 0;
  how.drift = random_below(r, 3) == 0 ? how.noise * random_between(r, 0, 1) : 0;
  record(&rows, &c, &how, r);
  double error = NAN, value = answer(&c, &rows, &error), off = fabs(value - displacement(&c));
  bool inside = off <= error;
  tally->inside[loud][which] += inside;
  tally->all[loud][which]++;
  tally->width[loud] += log(error / c.L);
  tally->error[loud] += log(off / c.L + 1e-14);
}

static void print_tally(const struct tally *tally)
{
  const char *const noises[NOISES] = { "0", "0.01 to 0.3 %", "0.3 to 2 %" };
  int inside[NOISES + GAITS] = { 0 }, all[NOISES + GAITS] = { 0 };
  for (int i = 0; i < NOISES * GAITS; i++)
    for (int row = 0; row < 2; row++) {
      inside[row ? NOISES + i % GAITS : i / GAITS] += tally->inside[i / GAITS][i % GAITS];
      all[row ? NOISES + i % GAITS : i / GAITS] += tally->all[i / GAITS][i % GAITS];
    }
  for (int i = 0; i < NOISES; i++)
    printf("| %s | %d | %.1f %% | %.1e | %.1e |\n", noises[i], all[i], 100. * inside[i] / all[i],
           exp(tally->error[i] / all[i]), exp(tally->width[i] / all[i]));
  for (int k = 0; k < GAITS; k++)
    printf("gait %d: %d of %d\n", k, inside[NOISES + k], all[NOISES + k]);
}

TEST(the_truth_lies_inside)
{
  const char *wanted = getenv("RECORDINGS");
  struct random r = { wanted ? 4 : 3 }; /* 3: those that the factors of the interval were chosen on */
  struct tally tally = { .width = { 0 } };
  int inside = 0, many = wanted ? atoi(wanted) : (int)check_cases(40);
  for (int i = 0; i < many; i++)
    one_recording(&tally, &r, wanted ? 2000 : 400); /* 2000 take ten times as long */
  for (int i = 0; i < NOISES * GAITS; i++)
    inside += tally.inside[i / GAITS][i % GAITS];
  if (wanted)
    print_tally(&tally);
  CHECK_AT_MOST(0.9 * many - 1, inside); /* one more where they are few */
}

static struct scallop_crawler issue_crawler(union scallop_made_gait *made)
{
  return (struct scallop_crawler){ 0.8, 1.7, 2.2, 0.9, 3, 0.5, 0.6, some_gait(made, 2) };
}

/* Minimum jerk, whose l'' is 0 at the turns: what monotone slopes get wrong by a fifth. */
TEST(exact_samples)
{
  static struct rows rows;
  union scallop_made_gait made;
  struct scallop_crawler c = issue_crawler(&made);
  struct random r = { 1 };
  const struct recording how = { .count = 50, .periods = 1 };
  double error = NAN, value, wanted = displacement(&c);
  record(&rows, &c, &how, &r);
  value = answer(&c, &rows, &error);
  CHECK_RELATIVE(value, wanted, 0.02);
  CHECK_NEAR(value, wanted, error);
  struct scallop_measured *monotone = measured_with(&rows, SCALLOP_FIT_MONOTONE),
                          *cubic = measured_with(&rows, SCALLOP_FIT_CUBIC);
  for (int i = 0; i < rows.count; i++) {
    CHECK_NEAR(scallop_measured_length(monotone, rows.t[i]), rows.l[i], 1e-14 * c.L);
    CHECK_NEAR(scallop_measured_length(cubic, rows.t[i]), rows.l[i], 1e-14 * c.L);
  }
  static double t[MOST], l[MOST];
  assert_int_equal(scallop_measured_samples(cubic, NULL, NULL), rows.count);
  assert_int_equal(scallop_measured_samples(cubic, t, l), rows.count);
  for (int i = 0; i < rows.count; i++) {
    CHECK_NEAR(t[i], rows.t[i], 1e-15 * c.T);
    CHECK_NEAR(l[i], rows.l[i], 1e-15 * c.L);
  }
  struct scallop_crawler d = with_gait(c, scallop_measured_gait(cubic, SCALLOP_MEASURED_BEST));
  CHECK_RELATIVE(displacement(&d), wanted, 2e-3);
  scallop_measured_free(monotone);
  scallop_measured_free(cubic);
}

/* Four times as many samples: the cubic through them is off by less than a tenth of what it was. */
TEST(more_samples)
{
  static struct rows rows;
  struct random r = { 1 };
  struct scallop_crawler c = scallop_crawler_default();
  c.gait = &scallop_gait_sinusoidal;
  c.alpha = 0.5; /* l'' is continuous */
  double last = 0;
  for (int n = 25; n <= 400; n *= 4) {
    const struct recording how = { .count = n, .periods = 1, .start = 0.123 };
    record(&rows, &c, &how, &r);
    struct scallop_measured *m = measured_with(&rows, SCALLOP_FIT_CUBIC);
    double worst = 0;
    for (int i = 0; i < 1000; i++)
      worst = fmax(worst, fabs(scallop_measured_length(m, i * c.T / 1000) - length_at(&c, (i / 1000. + 0.123) * c.T)));
    if (last > 0)
      CHECK_AT_MOST(worst, 0.02 * last);
    last = worst;
    scallop_measured_free(m);
  }
}

/* How far the curve is from the recorded gait, at most and as a root mean square, in units of L */
static void distance(const struct scallop_measured *m, const struct scallop_crawler *c, double start, double *most,
                     double *mean)
{
  enum { PLACES = 2000 };
  *most = *mean = 0;
  for (int i = 0; i < PLACES; i++) {
    double t = (double)i / PLACES,
           off = (scallop_measured_length(m, t * c->T) - length_at(c, (t + start) * c->T)) / c->L;
    *most = fmax(*most, fabs(off));
    *mean += off * off / PLACES;
  }
  *mean = sqrt(*mean);
}

/* A cubic in each phase is among the splines of PHASES, and a long one that changes slowly costs few degrees of
 * freedom: of the noise little is left. */
TEST(least_squares)
{
  static struct rows rows;
  const double cubic[] = { 0, 0, 3, -2 };
  union scallop_made_gait made;
  struct random r = { 8 };
  struct scallop_crawler c = { 1, 1, 2, 1, 3, 0.5, 0.6, NULL };
  assert_int_equal(scallop_make_polynomial(&made.polynomial, "x", cubic, 3, NULL), SCALLOP_OK);
  c.gait = &made.gait;
  for (int noisy = 0; noisy < 2; noisy++) {
    const struct recording how = { .count = noisy ? 2000 : 97, .periods = 1, .start = 0.3, .noise = noisy ? 0.01 : 0 };
    record(&rows, &c, &how, &r);
    struct scallop_measured *m = measured_with(&rows, SCALLOP_FIT_PHASES);
    double most, mean;
    distance(m, &c, how.start, &most, &mean);
    CHECK_AT_MOST(noisy ? mean : most,
                  noisy ? 0.1 * how.noise : 1e-5); /* ten numbers through 2000 rows: sqrt(10/2000) */
    scallop_measured_free(m);
  }
}

/* Several periods, with and without noise, from anywhere in the period on */
TEST(periods_are_folded)
{
  static struct rows rows;
  union scallop_made_gait made;
  struct random r = { 5 };
  for (int i = 0; i < GAITS; i++) {
    struct scallop_crawler c = issue_crawler(&made);
    const struct recording how = {
      .count = 250 + 30 * i, .periods = 1.7 + 0.9 * i, .start = random_between(&r, 0, 1), .noise = i % 2 ? 0.005 : 0
    };
    c.gait = some_gait(&made, i);
    record(&rows, &c, &how, &r);
    struct scallop_measured *m = measured_with(&rows, SCALLOP_FIT_CHOSEN);
    struct scallop_measured_gait g = scallop_measured_gait(m, SCALLOP_MEASURED_BEST);
    char text[400];
    scallop_measured_text(m, text, sizeof text);
    CHECK_RELATIVE(g.T, c.T, how.noise > 0 ? 3e-3 : 3e-4);
    CHECK_RELATIVE(g.L, c.L, 0.02);
    assert_non_null(strstr(text, "folded into one"));
    scallop_measured_free(m);
  }
}

/* Units do not matter, however large or small they are, nor does the order of the rows. */
TEST(units)
{
  static struct rows rows, other;
  union scallop_made_gait made;
  struct random r = { 6 };
  struct scallop_crawler c = issue_crawler(&made);
  const struct recording how = { .count = 97, .periods = 1, .start = 0.3, .jitter = 0.2, .noise = 1e-3 };
  record(&rows, &c, &how, &r);
  struct scallop_measured *m = measured_with(&rows, SCALLOP_FIT_CHOSEN);
  struct scallop_measured_gait g = scallop_measured_gait(m, SCALLOP_MEASURED_BEST), h;
  const double scales[] = { 0x1p-600, 0x1p-3, 0x1p20, 0x1p900 };
  for (size_t k = 0; k < sizeof scales / sizeof *scales; k++) {
    other.count = rows.count;
    for (int i = 0; i < rows.count; i++) {
      other.t[i] = rows.t[rows.count - 1 - i] / scales[k];
      other.l[i] = rows.l[rows.count - 1 - i] * scales[k];
    }
    struct scallop_measured *n = measured_with(&other, SCALLOP_FIT_CHOSEN);
    h = scallop_measured_gait(n, SCALLOP_MEASURED_BEST);
    CHECK_EQUAL(h.L, g.L * scales[k]);
    CHECK_EQUAL(h.T, g.T / scales[k]);
    CHECK_EQUAL(h.alpha, g.alpha);
    scallop_measured_free(n);
  }
  scallop_measured_free(m);
}

/* The residuals are what sigma says; without it, the noise is found. */
TEST(noise)
{
  static struct rows rows;
  struct random r = { 7 };
  struct scallop_crawler c = scallop_crawler_default();
  const struct recording how = { .count = 1500, .periods = 1, .start = 0.3, .noise = 0.01 };
  record(&rows, &c, &how, &r);
  for (double sigma = 0; sigma < 0.03 * c.L; sigma += 0.0125 * c.L) {
    double squares = 0;
    struct scallop_measured *m = measured_by(&rows, SCALLOP_FIT_PHASES, sigma);
    for (int i = 0; i < rows.count; i++)
      squares += pow(rows.l[i] - scallop_measured_length(m, rows.t[i]), 2) / rows.count;
    CHECK_RELATIVE(sqrt(squares), sigma > 0 ? sigma : 0.01 * c.L, sigma > 0 ? 1e-3 : 0.05);
    scallop_measured_free(m);
  }
}

TEST(what_is_no_recording)
{
  static const double t[] = { 0, 1, 2, 3, 4, 5 }, rest[6] = { 1, 1, 1, 1, 1, 1 },
                      huge[] = { -1e308, 1e308, 0, 0, 0, 0 };
  static const struct {
    const double *t, *l;
    int count;
    const char *why;
  } refused[] = { { t, t, 3, "fewer than four" },
                  { rest, t, 6, "fewer than four" },
                  { t, rest, 6, "the same throughout" },
                  { t, t, 6, "not periodic" },
                  { t, huge, 6, "overflow" } };
  for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
    const char *why = "";
    assert_null(scallop_measured_new(refused[i].t, refused[i].l, refused[i].count, NULL, "x", &why));
    if (!strstr(why, refused[i].why))
      fail_msg("%s, and not %s", why, refused[i].why);
  }
}

TEST(an_interval)
{
  double others[SCALLOP_MEASURED_OTHERS];
  for (int i = 0; i < SCALLOP_MEASURED_OTHERS; i++)
    others[i] = NAN;
  CHECK_EQUAL(scallop_measured_error(1, others), NAN);
  others[1] = 1.25;
  others[4] = 0.5;
  CHECK_EQUAL(scallop_measured_error(1, others), 0.5);
  others[SCALLOP_MEASURED_MODELS] = 2;
  others[SCALLOP_MEASURED_OTHERS - 1] = 0;
  CHECK_NEAR(scallop_measured_error(1, others), sqrt(4.25), 1e-15);
}

/* ---- the gait of a curve ---- */

enum { KNOTS = 4 };

static const char *made(struct curve_gait *gait, struct scallop_knot knots[KNOTS])
{
  const struct curve curve = { knots, KNOTS, 1 };
  return gait_of_curve(gait, &curve, "x");
}

/* l' keeps its sign within each piece, and is 0 at the ends of the phases. */
static void check_gait(const struct curve_gait *g)
{
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &g->spline.gait.phase[kind];
    for (int i = 0; i < shape->count; i++) {
      const struct scallop_piece *p = &shape->pieces[i];
      for (int k = 1; k < 8; k++)
        assert_true(p->direction * p->curve->velocity(p, p->begin + k * (p->end - p->begin) / 8) >= 0);
    }
    CHECK_EQUAL(shape->pieces[0].curve->velocity(&shape->pieces[0], shape->pieces[0].begin), 0);
  }
}

/* Turns that lie almost on a knot, by a slope there; at three times the mean slope, and an ulp more, l' is 0 at the
 * other end of the piece; two turns between two knots, where l goes back in between, in either phase. */
TEST(gaits_of_curves)
{
  static const struct {
    double slope[3], L, alpha; /* at the first, second and fourth knot; how far L may be from 1, and alpha from 1/2 */
    int back;                  /* the phase in which l goes back; -1: none */
    bool upside_down;
  } curves[] = {
    { { 1e-9, 3, -3 }, 1e-9, 1e-7, -1, false },      { { -1e-9, 3, -3 }, 1e-9, 1e-7, -1, false },
    { { 0, 3, -3 }, 1e-9, 1e-7, -1, false },         { { 0.5, 3, -3 }, 0.05, 0.05, -1, false },
    { { -0.5, 3, -3 }, 0.05, 0.05, -1, false },      { { 0, 6 * (1 + 0x1p-52), -6 }, 0, INFINITY, -1, false },
    { { 0, -4, -3 }, INFINITY, INFINITY, 0, false }, { { 0, -4, -3 }, INFINITY, INFINITY, 1, true }
  };
  for (size_t i = 0; i < sizeof curves / sizeof *curves; i++) {
    const double *slope = curves[i].slope;
    struct scallop_knot knots[KNOTS] = {
      { 0, 0, slope[0] }, { 0.25, 0.5, slope[1] }, { 0.5, 1, 0 }, { 0.75, 0.5, slope[2] }
    };
    struct curve_gait g;
    for (int k = 0; curves[i].upside_down && k < KNOTS; k++)
      knots[k] = (struct scallop_knot){ knots[k].time, 1 - knots[k].length, -knots[k].slope };
    assert_null(made(&g, knots));
    check_gait(&g);
    CHECK_NEAR(g.L, 1, curves[i].L);
    CHECK_NEAR(g.alpha, 0.5, curves[i].alpha);
    assert_true(curves[i].back < 0 || fabs(g.spline.gait.phase[curves[i].back].net) < 1);
    curve_gait_free(&g);
  }
}

TEST(curves_that_are_no_gait)
{
  struct scallop_knot rest[KNOTS] = { { 0, 1, 0 }, { 0.25, 1, 0 }, { 0.5, 1, 0 }, { 0.75, 1, 0 } },
                      near[KNOTS] = { { 0.25 - 0x1p-54, 0.9, 0 }, { 0.25, 1, 0 }, { 0.5, 0.5, -2 }, { 0.75, 0, 0 } };
  struct curve_gait g;
  assert_string_equal(made(&g, rest), "l is the same throughout: there is no gait in that");
  curve_gait_free(&g);
  assert_non_null(made(&g, near));
  curve_gait_free(&g);
}
