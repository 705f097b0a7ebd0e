/* The judge of `stress`: cases that once broke a bound keep it now, and it sees what is wrong. */
#include <float.h>

#include "tests/support/agree.h"

#define QUADRATIC &scallop_gait_quadratic
#define SINUSOIDAL &scallop_gait_sinusoidal
enum { PAST_FAILURES = 75 };

static struct stress_case judged(const struct stress_case *made)
{
  struct stress_case stressed = *made;
  stress_judge(&stressed);
  return stressed;
}

static void check_bounds(const struct stress_case *c)
{
  enum stress_outcome outcome = bound_is_kept(&c->motion, 0, false);
  assert_true(outcome == STRESS_SOLVED || outcome == STRESS_UNDECIDED);
}

/* tests/compare/stress/past.txt says by how much each broke its bound. */
TEST(past_failures)
{
  FILE *file = fopen("tests/compare/stress/past.txt", "r");
  char line[400], of[12], gait[100];
  const long step = PAST_FAILURES / check_cases(PAST_FAILURES);
  long count = 0;
  assert_non_null(file);
  while (fgets(line, sizeof line, file)) {
    struct motion m = { .of = OF_STEADY };
    struct scallop_crawler *c = &m.crawler;
    int at = 0;
    if (line[0] == '#' || count++ % step != 0)
      continue;
    assert_int_equal(sscanf(line, "%11s %99s%n", of, gait, &at), 2);
    if (of[0] != 's') {
      char *end;
      m.of = OF_PHASE;
      m.phase = of[0] == 'e' ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
      m.v0 = strtod(line + at, &end);
      at = (int)(end - line);
    }
    assert_int_equal(
        sscanf(line + at, "%lf %lf %lf %lf %lf %lf %lf", &c->m1, &c->m2, &c->F1, &c->F2, &c->L, &c->T, &c->alpha), 7);
    c->gait = gait_of_text(gait).gait;
    check_bounds(&(struct stress_case){ .motion = m });
  }
  fclose(file);
  assert_int_equal(count, PAST_FAILURES);
}

/* The velocity is that of a plateau, or of both where alpha is m2/M, and friction does next to nothing in a period: it
 * slides or is held there. */
TEST(on_a_plateau)
{
  static const char *const gaits[] = { "trapezoidal:0.0625,0.03125", "trapezoidal:0.1,0.1", "trapezoidal:0.03125,0.125",
                                       "trapezoidal:0.2,0.3" };
  struct random r = { 20261122 };
  int held = 0, turned = 0;
  for (int i = 0; i < 60; i++) {
    struct stress_case s = { .motion.crawler = { .m1 = random_decades(&r, 0.03, 30),
                                                 .m2 = 1,
                                                 .F1 = random_decades(&r, 0.1, 10),
                                                 .F2 = 1,
                                                 .L = random_decades(&r, 0.1, 10),
                                                 .alpha = random_between(&r, 0.05, 0.95),
                                                 .gait = gait_of_text(gaits[i % 4]).gait } };
    if (i % 3 == 0) {
      s.motion.crawler.m1 = 1 + random_below(&r, 15);
      s.motion.crawler.m2 = 16 - s.motion.crawler.m1;
      s.motion.crawler.alpha = s.motion.crawler.m2 / 16;
    }
    s.motion.crawler.T = random_decades(&r, 1e-90, 1e-4);
    check_bounds(&s);
    struct scallop_steady_result result = steady_of(&s.motion.crawler);
    held += result.period.regime == SCALLOP_STICK_SLIP;
    turned += result.period.multiplier > 0 && result.period.multiplier < 0.99;
  }
  assert_true(held >= 10 && turned >= 2);
}

/* Below 1e-289 of L/tau of the shorter phase, the extension here, digits of v_mid may be lost; above they may not. */
TEST(units_far_below_the_natural_one)
{
  const struct stress_case lost = { .motion.crawler = { 80, 40, 6, 1.8, 10, 12000, 1e-152, SINUSOIDAL } };
  const struct stress_case kept = { .motion.crawler = { 80, 40, 6, 1.8, 10, 12000, 1e-130, SINUSOIDAL } };
  struct stress_case j;
  check_bounds(&lost);
  check_bounds(&kept);
  j = judged(&lost);
  assert_true(isnan(j.number[Q_V_MID].ulp) && j.number[Q_V_MID].error > 0);
  j = judged(&kept);
  assert_true(j.number[Q_V_MID].ulp > 0);
}

/* What over- or underflows is refused, and nothing else is. */
TEST(refusals)
{
  static const struct stress_case refused[] = {
    { .motion.crawler = { 1, 1, 4, 1, 1e-300, 1e10, 0.75, QUADRATIC } },                        /* L/T underflows */
    { .motion.crawler = { 1, 1, 4e300, 1e300, 1e-5, 1e3, 0.75, QUADRATIC } },                   /* eps overflows */
    { .motion.crawler = { 80, 40, 6, 1.8, 10, 12000, 1e-156, SINUSOIDAL } },                    /* alpha^2 underflows */
    { .motion = { .of = OF_PHASE, .crawler = { 1, 1, 4, 1, 1e300, 1e-10, 0.75, QUADRATIC } } }, /* L/tau overflows */
  };
  for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
    const struct stress_case j = judged(&refused[i]);
    assert_int_equal(j.outcome, STRESS_REFUSED);
    for (int q = 0; q < QUANTITIES; q++)
      assert_true(!j.number[q].judged && !j.number[q].broken);
  }
}

/* Each broken bound is reported. */
TEST(sees_what_is_wrong)
{
  struct stress_case c = { .motion.crawler = { 1.37, 0.85, 3.9, 1.21, 9.3, 0.71, 0.63, QUADRATIC } };
  struct stress_case right = judged(&c), j = right;
  for (int q = Q_FROUDE; q <= Q_MULTIPLIER; q++)
    assert_true(right.number[q].judged && !right.number[q].broken && !stress_broken(&right.number[q]));
  j.number[Q_V_START].error = 8.01 * j.number[Q_V_START].unit;
  j.number[Q_V_START].estimate = j.number[Q_V_START].error;
  assert_string_equal(stress_broken(&j.number[Q_V_START]), "error");
  /* froude = M L/(T^2 (F1 + F2)) has sum |x_i d ln y/d x_i| = 1 + 1 + 2 + 1 = 5; ulps are 1 to 2 roundings each */
  double condition = right.number[Q_FROUDE].unit / right.number[Q_FROUDE].ulp;
  assert_true(condition > 2.5 && condition < 10);
  CHECK_AT_MOST(right.number[Q_FROUDE].error, 2 * right.number[Q_FROUDE].ulp);
  const struct {
    int number;
    double *changed, value;
    const char *says;
  } broken[] = {
    { Q_V_MID, &j.number[Q_V_MID].error, NAN, "error" },
    { Q_DISPLACEMENT, &j.number[Q_DISPLACEMENT].rounding, 32.1 * right.number[Q_DISPLACEMENT].unit,
      "spread over the rounding modes" },
    { Q_DISPLACEMENT, &j.number[Q_DISPLACEMENT].perturbed, 17.1 * right.number[Q_DISPLACEMENT].unit,
      "spread over parameters an ulp apart" },
    { Q_MEAN_VELOCITY, &j.number[Q_MEAN_VELOCITY].estimate, 0.99 * right.number[Q_MEAN_VELOCITY].error,
      "estimate of the error too small" },
    { Q_MEAN_VELOCITY, &j.number[Q_MEAN_VELOCITY].estimate, 200 * right.number[Q_MEAN_VELOCITY].ulp,
      "estimate of the error too large" },
  };
  for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
    j = right;
    *broken[i].changed = broken[i].value;
    assert_string_equal(stress_broken(&j.number[broken[i].number]), broken[i].says);
  }
  j.number[Q_FROUDE] = right.number[Q_FROUDE];
  j.number[Q_FROUDE].rounding = NAN; /* of a trajectory there is but the error */
  assert_null(stress_broken(&j.number[Q_FROUDE]));
  c.motion.crawler.T = -1; /* and a case may be broken as a whole */
  j = judged(&c);
  assert_int_equal(j.outcome, STRESS_BROKEN);
  for (int q = 0; q < QUANTITIES; q++) {
    assert_string_equal(j.number[q].broken, scallop_status_text(SCALLOP_EDOMAIN));
    assert_false(j.number[q].judged);
  }
}

/* Same seed, same cases; another one, others. Families make what they say. */
TEST(families)
{
  enum { COUNT = 40 };
  static struct stress_case made[3][COUNT];
  int n = 0;
  for (const struct stress_family *f = stress_families; f->name; f++, n++) {
    char text[3][STRESS_ARGUMENTS];
    int others = 0;
    for (int k = 0; k < 3; k++)
      assert_int_equal(stress_make(f, SINUSOIDAL, k < 2 ? 1 : 2, COUNT, made[k]), COUNT);
    for (int i = 0; i < COUNT; i++) {
      for (int k = 0; k < 3; k++)
        stress_arguments(&made[k][i], text[k]);
      assert_string_equal(text[0], text[1]);
      others += strcmp(text[0], text[2]) != 0;
      assert_int_equal(made[0][i].motion.of, f->kind == STRESS_STEADY ? OF_STEADY : OF_PHASE);
      assert_int_equal(made[0][i].periods > 0, f->kind == STRESS_TRAJECTORY);
      assert_int_equal(scallop_crawler_check(&made[0][i].motion.crawler, NULL), SCALLOP_OK);
    }
    assert_int_not_equal(others, 0);
  }
  assert_int_equal(n, 28);
}

/* "near-" families: within 2e-3 of where the modes change. */
TEST(boundaries_are_near)
{
  enum { COUNT = 30 };
  static const char *const names[] = { "near-start-velocity-zero", "near-sticking", "near-grazing" };
  for (int k = 0; k < 3; k++) {
    struct stress_case cases[COUNT];
    const struct stress_family *f = stress_families;
    while (strcmp(f->name, names[k]) != 0)
      f++;
    assert_int_equal(stress_make(f, QUADRATIC, 5, COUNT, cases), COUNT);
    for (int i = 0; i < COUNT; i++) {
      const struct scallop_steady_result here = steady_of(&cases[i].motion.crawler);
      struct scallop_steady_result there;
      bool differs = false;
      for (int p = 0; p < 8 && !differs; p++) {
        struct scallop_crawler c = cases[i].motion.crawler;
        double *const moved[] = { &c.T, &c.F1, &c.m2, &c.alpha };
        *moved[p / 2] *= p % 2 ? 1.002 : 0.998;
        if (scallop_steady(&c, &there) < 0)
          continue;
        for (int phase = 0; phase < 2; phase++)
          differs |= !modes_alike(&here.period.modes[phase], &there.period.modes[phase]);
      }
      assert_true(differs);
    }
  }
}

/* A trajectory against its closed form, and one whose start is a little off against the wrong one. */
TEST(trajectories)
{
  struct stress_case c = { .motion = { OF_PHASE, { 1.37, 0.85, 3.9, 1.21, 9.3, 0.31, 0.63, QUADRATIC } },
                           .periods = 500 };
  struct stress_case j;
  struct scallop_steady_result s = steady_of(&c.motion.crawler);
  for (int k = 0; k < 3; k++) {
    c.motion.v0 = s.period.v_start * (1 + 0.02 * k);
    j = judged(&c);
    assert_int_equal(j.outcome, STRESS_SOLVED);
    CHECK_AT_MOST(j.number[Q_DXC].error, 8 * j.number[Q_DXC].unit);
    CHECK_AT_MOST(j.number[Q_V_END].error, 8 * j.number[Q_V_END].unit);
    CHECK_RELATIVE(j.number[Q_DXC].exact, 500 * s.period.displacement, 0.01);
  }
  c.motion.v0 = 0; /* starts from rest: other modes at first */
  j = judged(&c);
  assert_int_equal(j.outcome, STRESS_REFUSED);
}
