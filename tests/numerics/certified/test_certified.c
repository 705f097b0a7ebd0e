/* The certified solver: against the double one, against 50-digit values of a third program, and against itself
 * with more digits. */
#include <float.h>
#include <stdio.h>

#include "tests/support/certified_balls.h"
#include "tests/support/reference.h"

enum { PHASE = 6, STEADY = 4, ULPS = 8, CONDITION_DIGITS = 50, REFERENCE_DIGITS = 45 };

/* One phase, or the steady state, and what is certified of it */
struct problem {
  struct scallop_crawler crawler;
  bool steady;
  enum scallop_phase_kind kind;
  double v0;
};

struct answer {
  bool steady;
  struct scallop_certified_phase of_phase;
  struct scallop_certified_steady of_steady;
};
#define PARTS(of) of(scallop_certified_phase, &s->of_phase) of(scallop_certified_steady, &s->of_steady)
SCOPED_PARTS(answer, struct answer, PARTS)

static const char *const names[2][PHASE] = { { "t1", "dT", "v_end", "dx1", "dx2", "dxC" },
                                             { "v_start", "v_mid", "displacement", "multiplier" } };

static int numbers(const struct answer *a) { return a->steady ? STEADY : PHASE; }

/* Where nothing switches t1 and dT are nothing. */
static int first_number(const struct answer *a) { return a->steady || a->of_phase.switches ? 0 : 2; }

static arb_ptr number(struct answer *a, int i)
{
  struct scallop_certified_phase *p = &a->of_phase;
  struct scallop_certified_steady *s = &a->of_steady;
  arb_ptr of_phase[PHASE] = { p->t1, p->dT, p->v_end, p->dx1, p->dx2, p->dxC };
  arb_ptr of_steady[STEADY] = { s->v_start, s->v_mid, s->displacement, s->multiplier };
  return a->steady ? of_steady[i] : of_phase[i];
}

/* To so many digits, with the i-th input changed by 1e-30 of itself; none if i < 0 */
static bool certify(struct answer *a, const struct problem *p, long digits, int i, const char **why)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0, factor);
  fmpq *const inputs[] = { c.m1, c.m2, c.F1, c.F2, c.L, c.T, c.alpha, v0 };
  scallop_rational_of(&c, &p->crawler);
  scallop_rational_set_double(v0, p->v0);
  if (i >= 0) {
    assert_true(scallop_rational_parse(factor, "1.000000000000000000000000000001"));
    fmpq_mul(inputs[i], inputs[i], factor);
  }
  a->steady = p->steady;
  return (p->steady ? scallop_certified_steady(&c, digits, &a->of_steady, why)
                    : scallop_certified_phase(&c, p->kind, v0, digits, &a->of_phase, why))
         == SCALLOP_OK;
}

static bool same_sequences(const struct answer *a, const struct scallop_modes *modes)
{
  return a->steady ? modes_alike(&a->of_steady.modes[0], &modes[0]) && modes_alike(&a->of_steady.modes[1], &modes[1])
                   : modes_alike(&a->of_phase.modes, modes);
}

static void check_digits(const arb_t x, long digits, const char *what)
{
  if (!arb_contains_zero(x) && (double)arb_rel_accuracy_bits(x) < 3.3219 * (double)digits)
    fail_msg("%s: %ld bits, not %ld digits", what, (long)arb_rel_accuracy_bits(x), digits);
}

static struct {
  double ulps;
  char where[160];
} worst[2][PHASE];

static void note(bool steady, int q, double ulps, const struct scallop_crawler *c, double got)
{
  if (ulps <= worst[steady][q].ulps)
    return;
  worst[steady][q].ulps = ulps;
  snprintf(worst[steady][q].where, sizeof worst[steady][q].where,
           "%.17g; m %.3g %.3g F %.3g %.3g L %.3g T %.3g alpha %.3g %s", got, c->m1, c->m2, c->F1, c->F2, c->L, c->T,
           c->alpha, c->gait->name);
}

static void print_worst(bool steady)
{
  for (int i = 0; i < (steady ? STEADY : PHASE); i++)
    print_message("%-12s worst %.2f ulp: %s\n", names[steady][i], worst[steady][i].ulps, worst[steady][i].where);
}

/* In doubles: the modes and the regime are those that are certified. */
static void in_doubles(double got[PHASE], const struct problem *p, const struct answer *a)
{
  bool same;
  if (p->steady) {
    struct scallop_steady_result s = steady_of(&p->crawler);
    const double all[STEADY] = { s.period.v_start, s.period.v_mid, s.period.displacement, s.period.multiplier };
    memcpy(got, all, sizeof all);
    same = same_sequences(a, s.period.modes) && a->of_steady.regime == s.period.regime;
    CHECK_RELATIVE(s.froude, middle(a->of_steady.froude), 8 * DBL_EPSILON);
  } else {
    struct scallop_phase_result r = phase_of(&p->crawler, p->kind, p->v0);
    const double all[PHASE] = { r.t1, r.dT, r.v_end, r.dx1, r.dx2, r.dxC };
    memcpy(got, all, sizeof all);
    same = same_sequences(a, &r.modes) && a->of_phase.regime == r.regime && a->of_phase.switches == !isnan(r.t1);
  }
  if (!same) {
    print_crawler(&p->crawler);
    fail_msg("v0=%.17g: other modes are certified", p->v0);
  }
}

/* Within ULPS of the larger of the number and its condition: the sum over the inputs p of |p dq/dp|, by certified
 * differences; inf where a mode changes. */
static void compare(const struct problem *p)
{
  SCOPED(answer, a, moved);
  const char *why = "";
  double cond[PHASE] = { 0 }, got[PHASE];
  if (!certify(&a, p, CONDITION_DIGITS, -1, &why)) {
    print_crawler(&p->crawler);
    fail_msg("v0=%.17g: %s", p->v0, why);
  }
  in_doubles(got, p, &a);
  for (int i = 0; i < (p->steady ? 7 : 8); i++) {
    bool known = certify(&moved, p, CONDITION_DIGITS, i, NULL)
                 && same_sequences(&a, p->steady ? moved.of_steady.modes : &moved.of_phase.modes);
    for (int q = 0; q < numbers(&a); q++)
      cond[q] += known ? 1e30 * apart(number(&a, q), number(&moved, q)) : INFINITY;
  }
  for (int q = 3; q < 5 && !p->steady; q++)
    cond[q] = fmax(cond[q],
                   p->crawler.L); /* the double solver has dx1 and dx2 from dxC and half of L: of a body that hardly
                                              moves only the digits that are left */
  for (int q = first_number(&a); q < numbers(&a); q++) {
    SCOPED(arb, ball);
    arb_set_d(ball, got[q]);
    double wanted = middle(number(&a, q)), unit = DBL_EPSILON * fmax(fabs(wanted), cond[q]);
    double error = apart(number(&a, q), ball);
    if (!(error <= ULPS * unit)) {
      print_crawler(&p->crawler);
      print_error("v0=%.17g, %s: cond %g, %.3g ulp\n", p->v0, names[p->steady][q], cond[q], error / unit);
      CHECK_NEAR(got[q], wanted, ULPS * unit);
    }
    note(p->steady, q, unit > 0 && isfinite(unit) ? error / unit : 0, &p->crawler, got[q]);
  }
}

TEST(phases_agree_with_doubles)
{
  struct random r = { 20260701 };
  for (int i = 0; i < 140 * ALL_GAITS; i++) {
    struct problem p = { .crawler = random_crawler(&r, (enum family)(i / ALL_GAITS % FAMILIES),
                                                   every_gait[i % ALL_GAITS]) };
    p.kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    p.v0 = random_start(&r, &p.crawler, p.kind);
    compare(&p);
  }
  print_worst(false);
}

/* Of every family and every gait with a certified steady state in turn */
static struct scallop_crawler draw(struct random *r, int i)
{
  return random_crawler(r, (enum family)(i / SMOOTH_GAITS % FAMILIES), every_gait[i % SMOOTH_GAITS]);
}

TEST(steady_states_agree_with_doubles)
{
  struct random r = { 20260702 };
  for (int i = 0; i < 28 * SMOOTH_GAITS; i++)
    compare(&(struct problem){ .crawler = draw(&r, i), .steady = true });
  print_worst(true);
}

/* The text has 50 digits: half a unit of the last one, and what counts as 0 there, is left to it. */
static void check_reference(const arb_t ball, const char *text, double unit)
{
  SCOPED(arb, wanted);
  assert_int_equal(arb_set_str(wanted, text, 400), 0);
  check_digits(ball, REFERENCE_DIGITS, text);
  CHECK_NEAR(apart(ball, wanted), 0, 1e-44 * fabs(middle(wanted)) + 1e-60 * unit);
}

static void check_reference_row(const struct row *r)
{
  static const char *const inputs[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha" };
  char both[BOTH_MODES_TEXT];
  SCOPED(scallop_rational, c);
  SCOPED(answer, a);
  SCOPED(fmpq, v0);
  fmpq *const to[] = { c.m1, c.m2, c.F1, c.F2, c.L, c.T, c.alpha };
  for (int i = 0; i < 7; i++)
    assert_true(scallop_rational_parse(to[i], cell(r, "", inputs[i])));
  c.gait = scallop_gait_named(cell(r, "", "gait"));
  a.steady = of_steady_state(r);
  if (a.steady) {
    assert_int_equal(scallop_certified_steady(&c, REFERENCE_DIGITS, &a.of_steady, NULL), SCALLOP_OK);
    both_modes(a.of_steady.modes, both);
  } else {
    assert_true(scallop_rational_parse(v0, cell(r, "", "v0")));
    assert_int_equal(scallop_certified_phase(&c, phase_in(r), v0, REFERENCE_DIGITS, &a.of_phase, NULL), SCALLOP_OK);
    assert_int_equal(a.of_phase.switches, strcmp(cell(r, "", "t1"), "nan") != 0);
    scallop_modes_text(&a.of_phase.modes, both);
  }
  double unit = number_in(r, "", "L") * (1 + 1 / number_in(r, "", "T"));
  for (int q = first_number(&a); q < numbers(&a); q++)
    if (a.steady ? q < 3 : q < 3 || q == 5) /* the table has no multiplier, dx1 and dx2 */
      check_reference(number(&a, q), cell(r, "", names[a.steady][q]), unit);
  assert_string_equal(both, cell(r, "", "modes"));
}

TEST(every_reference_row) { for_reference_rows(check_reference_row); }

/* With more digits, the same; and as many as were wanted. */
static void check_longer(const struct problem *p, long digits, long more)
{
  SCOPED(answer, few, many);
  assert_true(certify(&few, p, digits, -1, NULL) && certify(&many, p, more, -1, NULL));
  for (int q = 0; q < numbers(&few); q++) {
    check_overlap(number(&few, q), number(&many, q), names[p->steady][q]);
    if (p->steady)
      check_digits(number(&few, q), digits, names[p->steady][q]);
    check_digits(number(&many, q), more, names[p->steady][q]);
  }
}

TEST(more_digits_agree)
{
  struct random r = { 20260703 };
  for (int i = 0; i < 20 * SMOOTH_GAITS; i++) {
    struct problem p = { .crawler = draw(&r, i), .steady = true, .kind = SCALLOP_CONTRACTION };
    check_longer(&p, 30, 300);
    p.steady = false;
    p.v0 = random_start(&r, &p.crawler, SCALLOP_CONTRACTION);
    check_longer(&p, 30, 300);
  }
}

/* A thousand digits where a double has none: T = 1e-30. The displacement of the default crawler tends to (F1 - F2)(2
 * alpha - 1) L m / (alpha^2 F1 m1 + (1 - alpha)^2 F2 m2), m = m1 m2/M, with an error of order T^4: 120/37. */
TEST(a_thousand_digits_of_a_small_period)
{
  struct problem p = { .crawler = scallop_crawler_default(), .steady = true };
  SCOPED(answer, a);
  SCOPED(arb, limit);
  p.crawler.T = 1e-30;
  p.crawler.gait = &scallop_gait_sinusoidal;
  check_longer(&p, 1000, 1100);
  p.crawler.gait = &scallop_gait_quadratic;
  check_longer(&p, 1000, 1100);
  assert_true(certify(&a, &p, 1000, -1, NULL));
  arb_set_ui(limit, 120);
  arb_div_ui(limit, limit, 37, 4000);
  CHECK_NEAR(apart(a.of_steady.displacement, limit), 0, 10 * 1e-119);
  assert_false(arb_overlaps(a.of_steady.displacement, limit));
}
