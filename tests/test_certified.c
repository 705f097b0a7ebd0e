/* The certified solver: against the double one, against 50-digit values of a third program, against itself with more digits,
 * and against laws of motion that it does not use. */
#include "tests/check.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "numerics/certified.h"
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

static double nearest(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

/* At least how far apart, seen from the outside: |x - y| with the radii of both. */
static double apart(const arb_t x, const arb_t y)
{
  arb_t d;
  arf_t most;
  arb_init(d);
  arf_init(most);
  arb_sub(d, x, y, 400);
  arb_get_abs_ubound_arf(most, d, 53);
  double far = arf_get_d(most, ARF_RND_UP);
  arb_clear(d);
  arf_clear(most);
  return far;
}

static double apart_from_double(const arb_t x, double y)
{
  arb_t ball;
  arb_init(ball);
  arb_set_d(ball, y);
  double far = apart(x, ball);
  arb_clear(ball);
  return far;
}

static void check_overlap(const arb_t x, const arb_t y, const char *what)
{
  if (!arb_overlaps(x, y)) {
    print_error("%s: %.17g and %.17g do not overlap\n", what, nearest(x), nearest(y));
    fail();
  }
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

static bool same_modes(const struct scallop_modes *a, const struct scallop_modes *b)
{
  char one[SCALLOP_MODES_TEXT], other[SCALLOP_MODES_TEXT];
  scallop_modes_text(a, one);
  scallop_modes_text(b, other);
  return strcmp(one, other) == 0;
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

/* ---- against 50-digit values of scripts/reference.py ---- */

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

/* ---- laws that it does not use ---- */

/* The impulse of friction, mode by mode, for phases of one to three modes without sticking. */
static void friction_impulse(arb_t impulse, const struct scallop_rational_crawler *c, enum scallop_phase_kind kind,
                             const struct scallop_certified_phase *p)
{
  arb_t duration, force;
  fmpq_t tau;
  arb_init(duration);
  arb_init(force);
  fmpq_init(tau);
  scallop_rational_duration(tau, c, kind);
  arb_zero(impulse);
  for (int i = 0; i < p->modes.count; i++) {
    arb_set_fmpq(duration, tau, 400);
    if (p->switches && (i == 0 || i == p->modes.count - 1))
      arb_set(duration, i == 0 ? p->t1 : p->dT);
    else if (p->switches) {
      arb_sub(duration, duration, p->t1, 400);
      arb_sub(duration, duration, p->dT, 400);
    }
    for (int body = 0; body < 2; body++) {
      arb_set_fmpq(force, body == 0 ? c->F1 : c->F2, 400);
      arb_mul_si(force, force, body == 0 ? -p->modes.kept[i].s1 : -p->modes.kept[i].s2, 400);
      arb_addmul(impulse, duration, force, 400);
    }
  }
  fmpq_clear(tau);
  arb_clear(force);
  arb_clear(duration);
}

/* v_end = v0 + impulse / M; dx2 - dx1 = +-L; dxC is their mean; d v_end / d v0 is what a change of v0 by 1e-40 makes of it. */
static void check_laws(const struct scallop_rational_crawler *c, enum scallop_phase_kind kind, const fmpq_t v0,
                       struct scallop_certified_phase *p, struct scallop_certified_phase *moved)
{
  arb_ptr t = _arb_vec_init(3);
  fmpq_t nearby, change, M;
  fmpq_init(nearby);
  fmpq_init(change);
  fmpq_init(M);
  if (p->regime == SCALLOP_SLIDING && p->modes.count <= 3) {
    friction_impulse(t, c, kind, p);
    fmpq_add(M, c->m1, c->m2);
    arb_set_fmpq(t + 1, M, 400);
    arb_div(t, t, t + 1, 400);
    arb_set_fmpq(t + 1, v0, 400);
    arb_add(t, t, t + 1, 400);
    check_overlap(t, p->v_end, "momentum");
  }
  arb_sub(t, p->dx2, p->dx1, 400);
  arb_set_fmpq(t + 1, c->L, 400);
  arb_mul_si(t + 1, t + 1, kind == SCALLOP_EXTENSION ? 1 : -1, 400);
  check_overlap(t, t + 1, "dx2 - dx1");
  arb_add(t, p->dx2, p->dx1, 400);
  arb_mul_2exp_si(t + 1, p->dxC, 1);
  check_overlap(t, t + 1, "dxC");
  assert_true(scallop_rational_parse(change, "1e-40"));
  fmpq_add(nearby, v0, change);
  if (scallop_certified_phase(c, kind, nearby, 80, moved, NULL) == SCALLOP_OK
      && (fmpq_is_zero(v0) || same_modes(&p->modes, &moved->modes))) {
    arb_sub(t, moved->v_end, p->v_end, 400);
    arb_set_fmpq(t + 1, change, 400);
    arb_div(t, t, t + 1, 400);
    CHECK_NEAR(apart(t, p->multiplier), 0, 1e-10);
  }
  fmpq_clear(M);
  fmpq_clear(change);
  fmpq_clear(nearby);
  _arb_vec_clear(t, 3);
}

static void phases_obey_laws(void **state)
{
  (void)state;
  struct random r = { 20260704 };
  struct scallop_certified_phase p, moved;
  struct scallop_rational_crawler exact;
  fmpq_t v0;
  scallop_certified_phase_init(&p);
  scallop_certified_phase_init(&moved);
  scallop_rational_init(&exact);
  fmpq_init(v0);
  int slid = 0;
  for (int i = 0; i < 60 * SMOOTH_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % SMOOTH_GAITS]);
    enum scallop_phase_kind kind = i / SMOOTH_GAITS % 2 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    scallop_rational_of(&exact, &c);
    scallop_rational_set_double(v0, random_start(&r, &c, kind));
    assert_int_equal(scallop_certified_phase(&exact, kind, v0, 80, &p, NULL), SCALLOP_OK);
    check_laws(&exact, kind, v0, &p, &moved);
    slid += p.regime == SCALLOP_SLIDING && p.modes.count == 3;
  }
  assert_true(slid > 30);
  fmpq_clear(v0);
  scallop_rational_clear(&exact);
  scallop_certified_phase_clear(&moved);
  scallop_certified_phase_clear(&p);
}

/* "++ -+ ++" in the quadratic gait of the default crawler: where body 1 is at its turns, from l = 2 L (t/tau)^2 at both ends. */
static void turning_places(void **state)
{
  (void)state;
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_rational_crawler exact;
  struct scallop_certified_phase p;
  char text[SCALLOP_MODES_TEXT];
  fmpq_t v0;
  fmpq_init(v0);
  scallop_rational_init(&exact);
  scallop_certified_phase_init(&p);
  scallop_rational_of(&exact, &c);
  fmpq_set_si(v0, 3, 1);
  assert_int_equal(scallop_certified_phase(&exact, SCALLOP_EXTENSION, v0, 20, &p, NULL), SCALLOP_OK);
  scallop_modes_text(&p.modes, text);
  assert_string_equal(text, "++ -+ ++");
  double t1 = nearest(p.t1), dT = nearest(p.dT), tau = 0.75, v_end = nearest(p.v_end), slowing = 2.5;
  double first = 3 * t1 - slowing / 2 * t1 * t1 - 0.5 * 2 * c.L * t1 * t1 / (tau * tau);
  double rest = v_end * dT + slowing / 2 * dT * dT - 0.5 * 2 * c.L * dT * dT / (tau * tau);
  CHECK_RELATIVE(nearest(p.at_first), first, 1e-13);
  CHECK_RELATIVE(nearest(p.at_last), nearest(p.dx1) - rest, 1e-13);
  scallop_certified_phase_clear(&p);
  scallop_rational_clear(&exact);
  fmpq_clear(v0);
}

/* ---- what is refused ---- */

/* l' = 6 u (1 - u) in one piece: a parabola, which a straight line can touch at a rational point. */
static const struct scallop_law parabola_law = { SCALLOP_LAW_POLYNOMIAL, 2, (const double[]){ 0, 6, -6 }, 1 };
static const struct scallop_piece parabola_extension[] = { { .end = 1, .direction = 1, .law = &parabola_law } };
static const struct scallop_piece parabola_contraction[] = { { .end = 1, .direction = -1, .law = &parabola_law } };
static const struct scallop_gait parabola_gait = {
  "parabola", { { parabola_extension, 1, 6, -6, 1.5, 1 }, { parabola_contraction, 1, -6, 6, 1.5, -1 } }
};

static void check_undecided(const struct scallop_crawler *c, const char *v0_text, const char *reason)
{
  struct scallop_rational_crawler exact;
  struct scallop_certified_phase p;
  const char *why = NULL;
  fmpq_t v0;
  fmpq_init(v0);
  scallop_rational_init(&exact);
  scallop_certified_phase_init(&p);
  scallop_rational_of(&exact, c);
  assert_true(scallop_rational_parse(v0, v0_text));
  arb_set_ui(p.v_end, 7);
  p.modes.count = 77;
  assert_int_equal(scallop_certified_phase(&exact, SCALLOP_EXTENSION, v0, 20, &p, &why), SCALLOP_EUNDECIDED);
  assert_non_null(why);
  if (!strstr(why, reason))
    fail_msg("%s, not %s", why, reason);
  assert_true(arb_equal_si(p.v_end, 7) && p.modes.count == 77);
  scallop_certified_phase_clear(&p);
  scallop_rational_clear(&exact);
  fmpq_clear(v0);
}

/* m1 = m2 = 1, tau = 1, L = 1: while both go forward v1 = v0 - (F1 + F2) t/2 - l'/2. */
static void exact_coincidences_are_said(void **state)
{
  (void)state;
  struct scallop_crawler c = { 1, 1, 2, 1, 1, 2, 0.5, &parabola_gait };
  check_undecided(&c, "1.6875", "body 1 touches"); /* v0 - 3 t/2 - 3 t (1 - t): 0 and least at t = 3/4 */
  c.gait = &scallop_gait_quadratic;
  c.F1 = 1;
  c.F2 = 0.5;
  check_undecided(&c, "1.375", "body 1 comes to rest just as"); /* v0 - 3 t/4 - 2 t until t = 1/2, where it is 0 */
  c.F1 = 5;
  c.F2 = 1;
  check_undecided(&c, "0", "force that holds body 1"); /* m2 l'' = 4 = F1 - F2 */
  c.F1 = 1;
  c.F2 = 5;
  check_undecided(&c, "0", "force that holds body 2");
}

static void check_domain(const struct scallop_rational_crawler *c, long digits)
{
  struct scallop_certified_phase p;
  struct scallop_certified_steady s;
  fmpq_t v0;
  fmpq_init(v0);
  scallop_certified_phase_init(&p);
  scallop_certified_steady_init(&s);
  arb_set_ui(p.t1, 7);
  arb_set_ui(s.v_start, 7);
  assert_int_equal(scallop_certified_phase(c, SCALLOP_EXTENSION, v0, digits, &p, NULL), SCALLOP_EDOMAIN);
  assert_int_equal(scallop_certified_steady(c, digits, &s, NULL), SCALLOP_EDOMAIN);
  assert_true(arb_equal_si(p.t1, 7) && arb_equal_si(s.v_start, 7));
  scallop_certified_steady_clear(&s);
  scallop_certified_phase_clear(&p);
  fmpq_clear(v0);
}

static void domain(void **state)
{
  (void)state;
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_rational_crawler exact;
  struct scallop_certified_steady s;
  scallop_rational_init(&exact);
  fmpq *inputs[] = { exact.m1, exact.m2, exact.F1, exact.F2, exact.L, exact.T, exact.alpha };
  for (int i = 0; i < 7; i++)
    for (int value = -1; value <= 0; value++) {
      scallop_rational_of(&exact, &c);
      fmpq_set_si(inputs[i], value, 1);
      check_domain(&exact, 20);
    }
  scallop_rational_of(&exact, &c);
  fmpq_one(exact.alpha);
  check_domain(&exact, 20);
  scallop_rational_of(&exact, &c);
  check_domain(&exact, 0);
  check_domain(&exact, SCALLOP_MOST_DIGITS + 1L);
  exact.gait = NULL;
  check_domain(&exact, 20);
  struct scallop_piece lawless = parabola_extension[0];
  lawless.law = NULL;
  struct scallop_gait unknown = parabola_gait;
  unknown.phase[0].pieces = &lawless;
  exact.gait = &unknown;
  check_domain(&exact, 20);
  scallop_certified_steady_init(&s);
  exact.gait = &sawtooth_gait;
  assert_int_equal(scallop_certified_steady(&exact, 20, &s, NULL), SCALLOP_EDOMAIN);
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&exact);
}

/* ---- exact zeros ---- */

static void zeros_are_exact(void **state)
{
  (void)state;
  struct scallop_rational_crawler exact;
  struct scallop_certified_steady s;
  scallop_rational_init(&exact);
  scallop_certified_steady_init(&s);
  for (int g = 0; g < SMOOTH_GAITS; g++) {
    struct scallop_crawler c = { 0.3, 0.7, 1.1, 1.1, 3, 0.9, 0.3, every_gait[g] };
    scallop_rational_of(&exact, &c);
    assert_int_equal(scallop_certified_steady(&exact, 40, &s, NULL), SCALLOP_OK);
    assert_true(arb_is_zero(s.v_start) && arb_is_zero(s.v_mid) && arb_is_zero(s.displacement));
    assert_int_equal(s.regime, SCALLOP_SLIDING);
    c.F1 = 200;
    c.T = 30;
    scallop_rational_of(&exact, &c);
    assert_int_equal(scallop_certified_steady(&exact, 40, &s, NULL), SCALLOP_OK);
    assert_true(arb_is_zero(s.v_start) && arb_is_zero(s.v_mid) && arb_is_zero(s.displacement));
    assert_int_equal(s.regime, SCALLOP_AT_REST);
    assert_true(arb_is_zero(s.multiplier));
  }
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&exact);
}

/* F1 - F2 exceeds m2 l'' = 4 by 1e-60: too little to see in the first rough steps, which must not keep it from the exact answer. */
static void barely_held(void **state)
{
  (void)state;
  struct scallop_crawler c = { 1, 1, 1, 1, 1, 2, 0.5, &scallop_gait_quadratic };
  struct scallop_rational_crawler exact;
  struct scallop_certified_steady s;
  scallop_rational_init(&exact);
  scallop_certified_steady_init(&s);
  scallop_rational_of(&exact, &c);
  assert_true(scallop_rational_parse(exact.F1, "5.000000000000000000000000000000000000000000000000000000000001"));
  assert_int_equal(scallop_certified_steady(&exact, 100, &s, NULL), SCALLOP_OK);
  assert_true(arb_is_zero(s.v_start));
  assert_int_equal(s.regime, SCALLOP_AT_REST);
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&exact);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(phases_agree_with_doubles),
    cmocka_unit_test(steady_states_agree_with_doubles),
    cmocka_unit_test(every_reference_row),
    cmocka_unit_test(more_digits_agree),
    cmocka_unit_test(a_thousand_digits_of_a_small_period),
    cmocka_unit_test(phases_obey_laws),
    cmocka_unit_test(turning_places),
    cmocka_unit_test(exact_coincidences_are_said),
    cmocka_unit_test(domain),
    cmocka_unit_test(zeros_are_exact),
    cmocka_unit_test(barely_held),
  };
  return cmocka_run_group_tests_name("certified", tests, NULL, NULL);
}
