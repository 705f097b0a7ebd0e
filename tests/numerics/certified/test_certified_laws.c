/* The certified solver against laws of motion that it does not use. */
#include "compare/answers/answer.h"
#include "tests/support/certified_balls.h"

/* The impulse of friction, mode by mode, for phases of one to three modes without sticking. */
static void friction_impulse(arb_t impulse, const struct scallop_rational_crawler *c, enum scallop_phase_kind kind,
                             const struct scallop_certified_phase *p)
{
  SCOPED(arb, duration, force);
  SCOPED(fmpq, tau);
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
}

/* v_end = v0 + impulse / M; dx2 - dx1 = +-L; dxC is their mean; d v_end / d v0 is what a change of v0 by 1e-40 makes of
 * it. */
static void check_laws(const struct scallop_rational_crawler *c, enum scallop_phase_kind kind, const fmpq_t v0,
                       struct scallop_certified_phase *p, struct scallop_certified_phase *moved)
{
  SCOPED(arb, x, y);
  SCOPED(fmpq, nearby, change, M);
  if (p->regime == SCALLOP_SLIDING && p->modes.count <= 3) {
    friction_impulse(x, c, kind, p);
    fmpq_add(M, c->m1, c->m2);
    arb_set_fmpq(y, M, 400);
    arb_div(x, x, y, 400);
    arb_set_fmpq(y, v0, 400);
    arb_add(x, x, y, 400);
    check_overlap(x, p->v_end, "momentum");
  }
  arb_sub(x, p->dx2, p->dx1, 400);
  arb_set_fmpq(y, c->L, 400);
  arb_mul_si(y, y, kind == SCALLOP_EXTENSION ? 1 : -1, 400);
  check_overlap(x, y, "dx2 - dx1");
  arb_add(x, p->dx2, p->dx1, 400);
  arb_mul_2exp_si(y, p->dxC, 1);
  check_overlap(x, y, "dxC");
  assert_true(scallop_rational_parse(change, "1e-40"));
  fmpq_add(nearby, v0, change);
  if (scallop_certified_phase(c, kind, nearby, 80, moved, NULL) == SCALLOP_OK
      && (fmpq_is_zero(v0) || modes_alike(&p->modes, &moved->modes))) {
    arb_sub(x, moved->v_end, p->v_end, 400);
    arb_set_fmpq(y, change, 400);
    arb_div(x, x, y, 400);
    CHECK_NEAR(apart(x, p->multiplier), 0, 1e-10);
  }
}

TEST(phases_obey_laws)
{
  struct random r = { 20260704 };
  SCOPED(scallop_certified_phase, p, moved);
  SCOPED(scallop_rational, exact);
  SCOPED(fmpq, v0);
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
}

/* "++ -+ ++" in the quadratic gait of the default crawler: where body 1 is at its turns, from l = 2 L (t/tau)^2 at both
 * ends. */
TEST(turning_places)
{
  struct scallop_crawler c = scallop_crawler_default();
  SCOPED(scallop_certified_phase, p);
  certify_phase(&p, &c, SCALLOP_EXTENSION, 3, 20);
  modes_are(&p.modes, "++ -+ ++");
  double t1 = middle(p.t1), dT = middle(p.dT), tau = 0.75, v_end = middle(p.v_end), slowing = 2.5;
  double first = 3 * t1 - slowing / 2 * t1 * t1 - 0.5 * 2 * c.L * t1 * t1 / (tau * tau);
  double rest = v_end * dT + slowing / 2 * dT * dT - 0.5 * 2 * c.L * dT * dT / (tau * tau);
  CHECK_RELATIVE(middle(p.at_first), first, 1e-13);
  CHECK_RELATIVE(middle(p.at_last), middle(p.dx1) - rest, 1e-13);
}

/* Where the rear body is at the last change of mode, body 1 of an extension: whether it turns then, as from rest where
 * F1 > F2, or body 2 does. From there to the end both bodies go the same way, and l' falls along a straight line. */
TEST(the_rear_body_is_the_same_whichever_turns)
{
  static const double F1[] = { 4, 0.7 };
  static const char *const modes[] = { "-+ ++", "-+ --" };
  for (int i = 0; i < 2; i++) {
    struct motion m = { .of = OF_PHASE, .crawler = { 1.3, 0.8, F1[i], 1.9, 3, 1.1, 0.6, &scallop_gait_quadratic } };
    const struct scallop_crawler *c = &m.crawler;
    double tau = c->alpha * c->T, M = c->m1 + c->m2, slowing = (i == 0 ? -1 : 1) * (c->F1 + c->F2) / M;
    struct answer a;
    struct scallop_wide_phase wide;
    SCOPED(scallop_certified_phase, p);
    certify_phase(&p, c, SCALLOP_EXTENSION, 0, 20);
    modes_are(&p.modes, modes[i]);
    assert_true(answer_in_double(&a, &m) && answer_complete(&a, &m) >= 0);
    assert_int_equal(scallop_wide_phase(SCALLOP_BINARY128, c, SCALLOP_EXTENSION, 0, &wide), SCALLOP_OK);
    const double dT[] = { a.value[Q_DT].high, wide.dT.high, middle(p.dT) };
    const double v_end[] = { a.value[Q_V_END].high, wide.v_end.high, middle(p.v_end) };
    const double dx1[] = { a.value[Q_DX1].high, wide.dx1.high, middle(p.dx1) };
    for (int k = 0; k < 3; k++) {
      double last = v_end[k] * dT[k] - slowing / 2 * dT[k] * dT[k] - c->m2 / M * 2 * c->L * dT[k] * dT[k] / (tau * tau);
      CHECK_RELATIVE(a.value[Q_AT_LAST].high, dx1[k] - last, 1e-14);
      CHECK_RELATIVE(middle(p.at_last), dx1[k] - last, 1e-14);
    }
  }
}

/* A period that is its own mirror image, half of it late, leads nowhere: whatever the masses and the forces. */
TEST(mirrored_periods_lead_nowhere)
{
  struct random r = { 20260705 };
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_certified_steady, s);
  for (int i = 0; i < 5 * SMOOTH_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % SMOOTH_GAITS]);
    c.alpha = 0.5;
    scallop_rational_of(&exact, &c);
    assert_int_equal(scallop_certified_steady(&exact, 30, &s, NULL), SCALLOP_OK);
    assert_true(arb_is_zero(s.displacement) && arb_is_zero(s.mean_velocity));
    arb_neg(s.v_mid, s.v_mid);
    assert_true(arb_overlaps(s.v_start, s.v_mid));
    assert_true(fmpq_set_str(exact.alpha, "499999999999/1000000000000", 10) == 0);
    assert_int_equal(scallop_certified_steady(&exact, 30, &s, NULL), SCALLOP_OK);
    assert_true(arb_is_zero(s.displacement) == (s.regime == SCALLOP_AT_REST));
  }
}
