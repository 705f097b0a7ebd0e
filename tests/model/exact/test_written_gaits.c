/* A gait's own numbers count as they were written: the same gait in other numbers is the same one to every digit. */
#include "compare/points/gaits.h"
#include "compare/points/point_flint.h"
#include "model/exact/fractions.h"
#include "tests/support/cases.h"
#include "tests/support/certified_balls.h"
#include "tests/support/scratch_folder.h"

enum { DIGITS = 50, WORD = 1200, TRIES = 24 };

static const struct scallop_gait *gait_of(const char *text)
{
  struct gait_result answer = gait_of_text(text);
  if (!answer.gait)
    fail_msg("%s", answer.wrong);
  return answer.gait;
}

static void solve(struct scallop_certified_steady *s, const struct scallop_crawler *c, const struct scallop_gait *gait)
{
  const char *why = "";
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, c);
  exact.gait = gait;
  if (scallop_certified_steady(&exact, DIGITS, s, &why) != SCALLOP_OK)
    fail_msg("%s: %s", gait->name, why);
}

/* Both gaits move a crawler alike to 50 digits; unlike: they differ, by less than rounding of their numbers can do. */
static void compare(struct random *r, const struct scallop_gait *one, const struct scallop_gait *other, bool alike)
{
  struct scallop_crawler c = random_crawler(r, random_below(r, 2) ? ORDINARY : STICK_SLIP, &scallop_gait_quadratic);
  SCOPED(scallop_certified_steady, a, b);
  solve(&a, &c, one);
  solve(&b, &c, other);
  double size = c.L / c.T, far = apart(a.v_mid, b.v_mid);
  if (alike ? !(far <= 1e-45 * size) : !(far <= 1e-9 * size && !arb_overlaps(a.v_mid, b.v_mid))) {
    print_crawler(&c);
    fail_msg("%s and %s: v_mid differs by %g", one->name, other->name, far);
  }
}

/* All digits of doubles: what the doubles themselves make, by another way. */
TEST(digits_of_doubles)
{
  struct random r = { 20261511 };
  for (int i = 0; i < TRIES; i++) {
    char text[2 * WORD];
    double x[4];
    for (int k = 0; k < 4; k++)
      x[k] = random_between(&r, 0.02, i % 3 == 0 && k % 2 == 0 ? 0.7 : 0.3);
    if (i % 2)
      snprintf(text, sizeof text, "trapezoidal:%.70g,%.70g,%.70g,%.70g", x[0], x[1], x[2], x[3]);
    else
      snprintf(text, sizeof text, "skewed:%.70g,%.70g", x[0], x[1] * 3);
    const struct scallop_gait *gait = gait_of(text), *written = written_gait(gait);
    assert_true(written != gait && written_gait(gait) == written);
    compare(&r, gait, written, true);
  }
}

/* Fractions that are no doubles, by hand: 1/5 and 3/10 */
TEST(fractions_by_hand)
{
  struct random r = { 20261512 };
  struct scallop_exact_gait by_hand;
  fmpq *x = _fmpq_vec_init(4);
  scallop_exact_init(&by_hand);
  for (int i = 0; i < 4; i++)
    fmpq_set_si(x + i, i % 2 ? 3 : 1, i % 2 ? 10 : 5);
  const struct scallop_gait *gait = gait_of("trapezoidal:0.2,0.3");
  const struct gait_source *source = gait_source_of(gait);
  assert_true(source && scallop_exact_made(&by_hand, source->family, gait, x, 4));
  compare(&r, &by_hand.gait, written_gait(gait), true);
  compare(&r, gait, written_gait(gait), false);
  scallop_exact_clear(&by_hand);
  _fmpq_vec_clear(x, 4);
}

/* R = 0 is a limit of R to more digits than doubles have. */
TEST(constant_speeds)
{
  struct scallop_crawler c = { 1, 2, 4, 1, 10, 1, 0.75, &scallop_gait_quadratic };
  SCOPED(scallop_certified_steady, s, near);
  solve(&s, &c, written_gait(gait_of("constant:0")));
  solve(&near, &c, written_gait(gait_of("constant:1e-30")));
  assert_true(apart(s.v_mid, near.v_mid) < 1e-28 && !arb_overlaps(s.v_mid, near.v_mid));
}

/* A family without numbers: the doubles stand for it, as for any without a law. */
TEST(without_a_law)
{
  struct scallop_exact_gait exact;
  scallop_exact_init(&exact);
  assert_null(exact.pieces);
  assert_false(scallop_exact_made(&exact, gait_family(0), gait_family(0)->fixed, NULL, 0));
  assert_int_equal(exact.count, 4);
  scallop_exact_clear(&exact);
}

/* The same gait in other decimals: coefficients times one decimal; ramps of a decimal are those of the trapezoid;
 * UP + DOWN = 1 of decimals, as of the doubles nearest to them or only nearly so. */
TEST(the_same_decimals)
{
  static const int shapes[4][5] = { { 0, 3, -2 }, { 0, 0, 10, -15, 6 }, { 0, 6, -8, 3 }, { 0, 0, 4, -3 } };
  struct random r = { 20261513 };
  for (int i = 0; i < TRIES; i++) {
    char text[2][WORD] = { "polynomial:", "polynomial:" };
    int scale = 1 + random_below(&r, 99999);
    for (int k = 0; k < 5 && (k < 3 || shapes[i % 4][k] != 0); k++)
      for (int j = 0; j < 2; j++)
        snprintf(text[j] + strlen(text[j]), WORD - strlen(text[j]), j ? "%s%d" : "%s%de-5", k ? "," : "",
                 shapes[i % 4][k] * (j ? 1 : scale));
    compare(&r, written_gait(gait_of(text[0])), written_gait(gait_of(text[1])), true);
    double up = random_between(&r, 0.1, 0.9);
    snprintf(text[0], WORD, "trapezoidal:%.6f,%.6f", up, 1 - up);
    snprintf(text[1], WORD, "skewed:%.6f", up);
    compare(&r, written_gait(gait_of(text[0])), written_gait(gait_of(text[1])), true);
  }
  for (int i = 0; i < 6; i++) {
    compare(&r, written_gait(gait_of("constant:0.1")), written_gait(gait_of("trapezoidal:0.1,0.1")), true);
    compare(&r, written_gait(gait_of("constant:0.1,0.3")), written_gait(gait_of("trapezoidal:0.1,0.1,0.3,0.3")), true);
  }
}

/* Whose doubles stand for them. The third length differs from the second in the decimals only: a rest in doubles, and
 * in the fractions none. */
TEST(as_doubles)
{
  write_text("level.txt", "0 0\n1 0.5\n2 0.50000000000000000001\n3 1\n4 0\n");
  write_text("level-back.txt", "0 0\n1 1\n2 0.50000000000000000001\n3 0.5\n4 0\n");
  FOR_CASES (text, "quadratic|sinusoidal|polynomial:0,1.5,-1.0000000000000000001|polynomial:0,-0.5,2,-1.25|"
                   "measured:level.txt|measured:level-back.txt")
    assert_true(written_gait(gait_of(text)) == gait_of(text));
}

/* Of decimals, not of doubles */
TEST(symmetries)
{
  const struct scallop_gait *alike = gait_of("skewed:0.3,0.3"), *nearly = gait_of("skewed:0.3,0.30000000000000000001");
  assert_true(scallop_gait_mirrors(written_gait(alike)) && scallop_gait_mirrors(nearly));
  assert_false(scallop_gait_mirrors(written_gait(nearly)));
  assert_true(scallop_gait_is_reversible(written_gait(gait_of("trapezoidal:0.2,0.2"))));
  assert_false(scallop_gait_is_reversible(written_gait(gait_of("trapezoidal:0.2,0.20000000000000000001"))));
}

int main(void) { return check_run(scratch_begin, scratch_end); }
