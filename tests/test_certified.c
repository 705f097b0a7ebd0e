/* The certified solver: against the double one, against 50-digit values of a third program, and against itself
 * with more digits. */
#include "tests/check.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "numerics/certified.h"
#include "tests/certified_balls.h"
#include "tests/random_crawler.h"

enum { PHASE = 6, STEADY = 4, ULPS = 16, CONDITION_DIGITS = 50 };

/* ---- balls ---- */

static arb_ptr phase_quantity(struct scallop_certified_phase *r, int i)
{
  arb_ptr all[PHASE] = { r->t1, r->dT, r->v_end, r->dx1, r->dx2, r->dxC };
  return all[i];
}
static const char *const phase_names[PHASE] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC" };

static arb_ptr steady_quantity(struct scallop_certified_steady *r, int i)
{
  arb_ptr all[STEADY] = { r->v_start, r->v_mid, r->displacement, r->multiplier };
  return all[i];
}
static const char *const steady_names[STEADY] = { "v_start", "v_mid", "displacement", "multiplier" };

static double apart_from_double(const arb_t x, double y)
{
  arb_t ball;
  arb_init(ball);
  arb_set_d(ball, y);
  double far = apart(x, ball);
  arb_clear(ball);
  return far;
}

static void check_digits(const arb_t x, long digits, const char *what)
{
  if (!arb_contains_zero(x) && (double)arb_rel_accuracy_bits(x) < 3.3219 * (double)digits) {
    print_error("%s: %ld bits, not %ld digits\n", what, (long)arb_rel_accuracy_bits(x), digits);
    fail();
  }
}

/* ---- against the double solver ---- */

struct worst {
  double ulps;
  char where[160];
};

static void note(struct worst *w, double ulps, const struct scallop_crawler *c, double got)
{
  if (ulps <= w->ulps)
    return;
  w->ulps = ulps;
  snprintf(w->where, sizeof w->where, "%.17g; m %.3g %.3g F %.3g %.3g L %.3g T %.3g alpha %.3g %s", got, c->m1, c->m2, c->F1,
           c->F2, c->L, c->T, c->alpha, c->gait->name);
}

static void print_worst(const struct worst *w, const char *const *names, int count)
{
  for (int i = 0; i < count; i++)
    print_message("%-12s worst %.2f ulp: %s\n", names[i], w[i].ulps, w[i].where);
}

/* Changes the i-th input by 1e-30 of itself; false: there is none. */
static bool perturb(struct scallop_rational_crawler *c, fmpq_t v0, int i)
{
  fmpq *inputs[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha, v0 };
  if (i == 8)
    return false;
  fmpq_t factor;
  fmpq_init(factor);
  assert_true(scallop_rational_parse(factor, "1.000000000000000000000000000001"));
  fmpq_mul(inputs[i], inputs[i], factor);
  fmpq_clear(factor);
  return true;
}

static void check_same_modes(const struct scallop_modes *certified, const struct scallop_modes *other,
                             const struct scallop_crawler *c, double v0)
{
  char one[SCALLOP_MODES_TEXT], another[SCALLOP_MODES_TEXT];
  if (same_modes(certified, other))
    return;
  scallop_modes_text(certified, one);
  scallop_modes_text(other, another);
  print_crawler(c);
  print_error("v0=%.17g: %s certified, %s in doubles\n", v0, one, another);
  fail();
}

/* Sum over the inputs p of |p dq/dp| for every q, by certified differences; inf where a mode changes. */
static void phase_conditions(double *cond, const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0)
{
  struct scallop_certified_phase base, moved;
  struct scallop_rational_crawler exact;
  fmpq_t start;
  scallop_certified_phase_init(&base);
  scallop_certified_phase_init(&moved);
  scallop_rational_init(&exact);
  fmpq_init(start);
  memset(cond, 0, PHASE * sizeof *cond);
  for (int i = -1;; i++) {
    scallop_rational_of(&exact, c);
    scallop_rational_set_double(start, v0);
    if (i >= 0 && !perturb(&exact, start, i))
      break;
    struct scallop_certified_phase *r = i < 0 ? &base : &moved;
    bool known = scallop_certified_phase(&exact, kind, start, CONDITION_DIGITS, r, NULL) == SCALLOP_OK;
    for (int q = 0; q < PHASE && i >= 0; q++)
      cond[q] += known && same_modes(&base.modes, &moved.modes)
                     ? 1e30 * apart(phase_quantity(&base, q), phase_quantity(&moved, q))
                     : INFINITY;
  }
  fmpq_clear(start);
  scallop_rational_clear(&exact);
  scallop_certified_phase_clear(&moved);
  scallop_certified_phase_clear(&base);
}

static void compare_phase(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0, struct worst *worst)
{
  struct scallop_phase_result d;
  struct scallop_certified_phase r;
  struct scallop_rational_crawler exact;
  fmpq_t start;
  const char *why = "";
  double cond[PHASE];
  scallop_certified_phase_init(&r);
  scallop_rational_init(&exact);
  fmpq_init(start);
  scallop_rational_of(&exact, c);
  scallop_rational_set_double(start, v0);
  assert_int_equal(scallop_phase(c, kind, v0, &d), SCALLOP_OK);
  if (scallop_certified_phase(&exact, kind, start, 25, &r, &why) != SCALLOP_OK) {
    print_crawler(c);
    fail_msg("v0=%.17g: %s", v0, why);
  }
  check_same_modes(&r.modes, &d.modes, c, v0);
  assert_int_equal(r.regime, d.regime);
  assert_int_equal(r.switches, !isnan(d.t1));
  const double doubles[PHASE] = { d.t1, d.dT, d.v_end, d.dx1, d.dx2, d.dxC };
  phase_conditions(cond, c, kind, v0);
  cond[3] = fmax(cond[3], c->L); /* the double solver has dx1 and dx2 from dxC and half of L: of a body that hardly */
  cond[4] = fmax(cond[4], c->L); /* moves only the digits that are left                                            */
  for (int q = r.switches ? 0 : 2; q < PHASE; q++) {
    arb_ptr ball = phase_quantity(&r, q);
    double unit = DBL_EPSILON * fmax(fabs(nearest(ball)), cond[q]), error = apart_from_double(ball, doubles[q]);
    if (!(error <= ULPS * unit)) {
      print_crawler(c);
      print_error("v0=%.17g, %s: cond %g, %.3g ulp\n", v0, phase_names[q], cond[q], error / unit);
      CHECK_NEAR(doubles[q], nearest(ball), ULPS * unit);
    }
    note(&worst[q], unit > 0 && isfinite(unit) ? error / unit : 0, c, doubles[q]);
  }
  fmpq_clear(start);
  scallop_rational_clear(&exact);
  scallop_certified_phase_clear(&r);
}

static void phases_agree_with_doubles(void **state)
{
  (void)state;
  struct random r = { 20260701 };
  static struct worst worst[PHASE];
  for (int i = 0; i < 140 * ALL_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i / ALL_GAITS % FAMILIES), every_gait[i % ALL_GAITS]);
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    compare_phase(&c, kind, random_start(&r, &c, kind), worst);
  }
  print_worst(worst, phase_names, PHASE);
}

static void steady_conditions(double *cond, struct scallop_certified_steady *base, const struct scallop_crawler *c)
{
  struct scallop_certified_steady moved;
  struct scallop_rational_crawler exact;
  scallop_certified_steady_init(&moved);
  scallop_rational_init(&exact);
  memset(cond, 0, STEADY * sizeof *cond);
  for (int i = 0; i < 7; i++) {
    scallop_rational_of(&exact, c);
    perturb(&exact, NULL, i);
    bool known = scallop_certified_steady(&exact, CONDITION_DIGITS, &moved, NULL) == SCALLOP_OK;
    known = known && same_modes(&base->modes[0], &moved.modes[0]) && same_modes(&base->modes[1], &moved.modes[1]);
    for (int q = 0; q < STEADY; q++)
      cond[q] += known ? 1e30 * apart(steady_quantity(base, q), steady_quantity(&moved, q)) : INFINITY;
  }
  scallop_rational_clear(&exact);
  scallop_certified_steady_clear(&moved);
}

static void compare_steady(const struct scallop_crawler *c, struct worst *worst)
{
  struct scallop_steady_result d;
  struct scallop_certified_steady r;
  struct scallop_rational_crawler exact;
  const char *why = "";
  double cond[STEADY];
  scallop_certified_steady_init(&r);
  scallop_rational_init(&exact);
  scallop_rational_of(&exact, c);
  assert_int_equal(scallop_steady(c, &d), SCALLOP_OK);
  if (scallop_certified_steady(&exact, CONDITION_DIGITS, &r, &why) != SCALLOP_OK) {
    print_crawler(c);
    fail_msg("%s", why);
  }
  for (int kind = 0; kind < 2; kind++)
    check_same_modes(&r.modes[kind], &d.period.modes[kind], c, nearest(r.v_start));
  assert_int_equal(r.regime, d.period.regime);
  CHECK_RELATIVE(d.froude, nearest(r.froude), 8 * DBL_EPSILON);
  const double doubles[STEADY] = { d.period.v_start, d.period.v_mid, d.period.displacement, d.period.multiplier };
  steady_conditions(cond, &r, c);
  for (int q = 0; q < STEADY; q++) {
    arb_ptr ball = steady_quantity(&r, q);
    double unit = DBL_EPSILON * fmax(fabs(nearest(ball)), cond[q]), error = apart_from_double(ball, doubles[q]);
    if (!(error <= ULPS * unit)) {
      print_crawler(c);
      print_error("%s: cond %g, %.3g ulp\n", steady_names[q], cond[q], error / unit);
      CHECK_NEAR(doubles[q], nearest(ball), ULPS * unit);
    }
    note(&worst[q], unit > 0 && isfinite(unit) ? error / unit : 0, c, doubles[q]);
  }
  scallop_rational_clear(&exact);
  scallop_certified_steady_clear(&r);
}

static void steady_states_agree_with_doubles(void **state)
{
  (void)state;
  struct random r = { 20260702 };
  static struct worst worst[STEADY];
  for (int i = 0; i < 28 * SMOOTH_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i / SMOOTH_GAITS % FAMILIES), every_gait[i % SMOOTH_GAITS]);
    compare_steady(&c, worst);
  }
  print_worst(worst, steady_names, STEADY);
}

/* ---- against 50-digit values of scripts/python/reference.py ---- */

enum { COLUMNS = 27, LINE = 4096, FIRST_INPUT = 3, V0 = 11, MODES = 19, REFERENCE_DIGITS = 45 };

/* The text has 50 digits: half a unit of the last one, and what counts as 0 there, is left to it. */
static void check_reference(const arb_t ball, const char *text, double unit, const char *what)
{
  arb_t wanted;
  arb_init(wanted);
  assert_int_equal(arb_set_str(wanted, text, 400), 0);
  check_digits(ball, REFERENCE_DIGITS, what);
  CHECK_NEAR(apart(ball, wanted), 0, 1e-44 * fabs(nearest(wanted)) + 1e-60 * unit);
  arb_clear(wanted);
}

static void check_reference_row(char *const *cell)
{
  struct scallop_rational_crawler c;
  struct scallop_certified_phase p;
  struct scallop_certified_steady s;
  char modes[2][SCALLOP_MODES_TEXT], both[2 * SCALLOP_MODES_TEXT + 4];
  fmpq_t v0;
  fmpq_init(v0);
  scallop_rational_init(&c);
  scallop_certified_phase_init(&p);
  scallop_certified_steady_init(&s);
  fmpq *inputs[] = { c.m1, c.m2, c.F1, c.F2, c.L, c.T, c.alpha };
  for (int i = 0; i < 7; i++)
    assert_true(scallop_rational_parse(inputs[i], cell[FIRST_INPUT + i]));
  c.gait = scallop_gait_named(cell[2]);
  double unit = strtod(cell[FIRST_INPUT + 4], NULL) * (1 + 1 / strtod(cell[FIRST_INPUT + 5], NULL));
  if (strcmp(cell[1], "steady") == 0) {
    assert_int_equal(scallop_certified_steady(&c, REFERENCE_DIGITS, &s, NULL), SCALLOP_OK);
    for (int q = 0; q < 3; q++)
      check_reference(steady_quantity(&s, q), cell[V0 + 5 + q], unit, steady_names[q]);
    scallop_modes_text(&s.modes[0], modes[0]);
    scallop_modes_text(&s.modes[1], modes[1]);
    snprintf(both, sizeof both, "%s | %s", modes[0], modes[1]);
  } else {
    enum scallop_phase_kind kind = cell[V0 - 1][0] == 'e' ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    arb_ptr balls[] = { p.t1, p.dT, p.v_end, p.dxC };
    assert_true(scallop_rational_parse(v0, cell[V0]));
    assert_int_equal(scallop_certified_phase(&c, kind, v0, REFERENCE_DIGITS, &p, NULL), SCALLOP_OK);
    assert_int_equal(p.switches, strcmp(cell[V0 + 1], "nan") != 0);
    for (int q = p.switches ? 0 : 2; q < 4; q++)
      check_reference(balls[q], cell[V0 + 1 + q], unit, "a phase");
    scallop_modes_text(&p.modes, both);
  }
  assert_string_equal(both, cell[MODES]);
  scallop_certified_steady_clear(&s);
  scallop_certified_phase_clear(&p);
  scallop_rational_clear(&c);
  fmpq_clear(v0);
}

static void every_reference_row(void **state)
{
  (void)state;
  static char line[LINE];
  FILE *file = fopen("tests/reference.tsv", "r");
  assert_non_null(file);
  int rows = 0;
  while (fgets(line, LINE, file)) {
    char *cell[COLUMNS], *at = line;
    if (line[0] == '#' || strncmp(line, "family", 6) == 0)
      continue;
    for (int i = 0; i < COLUMNS; i++) {
      cell[i] = at;
      at += strcspn(at, "\t\n");
      *at++ = '\0';
    }
    check_reference_row(cell);
    rows++;
  }
  fclose(file);
  assert_int_equal(rows, 896);
}

/* ---- against itself, with more digits ---- */

static void more_digits_agree(void **state)
{
  (void)state;
  struct random r = { 20260703 };
  struct scallop_certified_steady few, many;
  struct scallop_certified_phase short_phase, long_phase;
  struct scallop_rational_crawler exact;
  fmpq_t v0;
  scallop_certified_steady_init(&few);
  scallop_certified_steady_init(&many);
  scallop_certified_phase_init(&short_phase);
  scallop_certified_phase_init(&long_phase);
  scallop_rational_init(&exact);
  fmpq_init(v0);
  for (int i = 0; i < 20 * SMOOTH_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i / SMOOTH_GAITS % FAMILIES), every_gait[i % SMOOTH_GAITS]);
    scallop_rational_of(&exact, &c);
    assert_int_equal(scallop_certified_steady(&exact, 30, &few, NULL), SCALLOP_OK);
    assert_int_equal(scallop_certified_steady(&exact, 300, &many, NULL), SCALLOP_OK);
    for (int q = 0; q < STEADY; q++) {
      check_overlap(steady_quantity(&few, q), steady_quantity(&many, q), steady_names[q]);
      check_digits(steady_quantity(&few, q), 30, steady_names[q]);
      check_digits(steady_quantity(&many, q), 300, steady_names[q]);
    }
    scallop_rational_set_double(v0, random_start(&r, &c, SCALLOP_CONTRACTION));
    assert_int_equal(scallop_certified_phase(&exact, SCALLOP_CONTRACTION, v0, 30, &short_phase, NULL), SCALLOP_OK);
    assert_int_equal(scallop_certified_phase(&exact, SCALLOP_CONTRACTION, v0, 300, &long_phase, NULL), SCALLOP_OK);
    for (int q = 0; q < PHASE; q++) {
      check_overlap(phase_quantity(&short_phase, q), phase_quantity(&long_phase, q), phase_names[q]);
      check_digits(phase_quantity(&long_phase, q), 300, phase_names[q]);
    }
  }
  fmpq_clear(v0);
  scallop_rational_clear(&exact);
  scallop_certified_phase_clear(&long_phase);
  scallop_certified_phase_clear(&short_phase);
  scallop_certified_steady_clear(&many);
  scallop_certified_steady_clear(&few);
}

/* A thousand digits where a double has none: T = 1e-30. The displacement of the default crawler tends to
 * (F1 - F2)(2 alpha - 1) L m / (alpha^2 F1 m1 + (1 - alpha)^2 F2 m2), m = m1 m2/M, with an error of order T^4: 120/37. */
static void a_thousand_digits_of_a_small_period(void **state)
{
  (void)state;
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_rational_crawler exact;
  struct scallop_certified_steady s, more;
  arb_t limit;
  arb_init(limit);
  scallop_rational_init(&exact);
  scallop_certified_steady_init(&s);
  scallop_certified_steady_init(&more);
  for (int g = 0; g < 2; g++) {
    c.gait = every_gait[g];
    scallop_rational_of(&exact, &c);
    assert_true(scallop_rational_parse(exact.T, "1e-30"));
    assert_int_equal(scallop_certified_steady(&exact, 1000, &s, NULL), SCALLOP_OK);
    assert_int_equal(scallop_certified_steady(&exact, 1100, &more, NULL), SCALLOP_OK);
    for (int q = 0; q < STEADY; q++) {
      check_overlap(steady_quantity(&s, q), steady_quantity(&more, q), steady_names[q]);
      check_digits(steady_quantity(&s, q), 1000, steady_names[q]);
    }
    arb_set_ui(limit, 120);
    arb_div_ui(limit, limit, 37, 4000);
    if (g == 0) {
      CHECK_NEAR(apart(s.displacement, limit), 0, 10 * 1e-119);
      assert_false(arb_overlaps(s.displacement, limit));
    }
  }
  scallop_certified_steady_clear(&more);
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&exact);
  arb_clear(limit);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(phases_agree_with_doubles),
    cmocka_unit_test(steady_states_agree_with_doubles),
    cmocka_unit_test(every_reference_row),
    cmocka_unit_test(more_digits_agree),
    cmocka_unit_test(a_thousand_digits_of_a_small_period),
  };
  return cmocka_run_group_tests_name("certified", tests, NULL, NULL);
}
