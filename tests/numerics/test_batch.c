/* Many crawlers at once against one at a time: the same bits, for any number of threads and any mixture of gaits and
 * modes. */
#include <float.h>

#include "model/gaits.h"
#include "tests/support/columns.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/solved.h"

enum { MOST = MOST_ROWS, NUMBERS = 8 };
enum { STEADY = 2, KINDS = 3 }; /* what is solved: an extension, a contraction, the steady state */

static long most(void) { return check_cases(MOST); }

static struct columns in;
static double start[MOST];

/* Of a steady state or of a phase, which has fewer numbers, and one sequence of modes */
static struct results {
  double number[NUMBERS][MOST];
  enum scallop_regime regime[MOST];
  struct scallop_modes modes[MOST][2];
  enum scallop_status status[MOST];
} out, again;

static struct scallop_modes *modes_of(struct results *r, int kind, long i)
{
  return kind == STEADY ? r->modes[i] : &r->modes[0][0] + i;
}

static void fill(struct random *r, long count, enum family one, enum family other, int kind)
{
  for (long i = 0; i < count; i++) {
    struct scallop_crawler c = random_crawler(r, i % 2 ? one : other, every_gait[i % ALL_GAITS]);
    columns_put(&in, i, &c);
    start[i] = random_start(r, &c, kind == STEADY ? SCALLOP_EXTENSION : (enum scallop_phase_kind)kind);
  }
}

static long solve(int kind, long count, struct results *r, int threads)
{
  double(*n)[MOST] = r->number;
  const struct scallop_crawlers c = columns_all(&in, count);
  const struct scallop_steady_states states = { n[0], n[1], n[2],      n[3],     n[4],     n[5],
                                                n[6], n[7], r->regime, r->modes, r->status };
  const struct scallop_phases phases = { n[0], n[1], n[2], n[3], n[4], n[5], r->regime, &r->modes[0][0], r->status };
  return kind == STEADY ? scallop_steady_batch(&c, &states, threads)
                        : scallop_phase_batch(&c, (enum scallop_phase_kind)kind, start, &phases, threads);
}

/* The same crawler alone, or, of one that fails, nan, no mode and a regime that is as it was */
static enum scallop_status alone(int kind, long i, double number[NUMBERS], enum scallop_regime *regime,
                                 struct scallop_modes modes[2])
{
  const struct scallop_crawler c = columns_row(&in, i);
  struct scallop_steady_result s = { .period.regime = (enum scallop_regime) - 1 };
  struct scallop_phase_result p = { .regime = (enum scallop_regime) - 1 };
  const struct scallop_period_result *q = &s.period;
  enum scallop_status status = kind == STEADY ? scallop_steady(&c, &s)
                                              : scallop_phase(&c, (enum scallop_phase_kind)kind, start[i], &p);
  const double of_steady[NUMBERS] = { s.froude,        q->v_start,    q->v_mid, q->displacement,
                                      s.mean_velocity, q->multiplier, s.v_low,  s.v_high },
               of_phase[NUMBERS] = { p.t1, p.dT, p.v_end, p.dx1, p.dx2, p.dxC };
  for (int k = 0; k < NUMBERS; k++)
    number[k] = status < 0 ? NAN : kind == STEADY ? of_steady[k] : of_phase[k];
  *regime = kind == STEADY ? q->regime : p.regime;
  modes[0] = kind == STEADY ? q->modes[0] : p.modes;
  modes[1] = q->modes[1];
  return status;
}

/* True: it failed, alone and among the others. */
static bool check_one(int kind, long i)
{
  struct scallop_modes wanted[2], *got = modes_of(&out, kind, i);
  double number[NUMBERS];
  enum scallop_regime regime;
  enum scallop_status status = alone(kind, i, number, &regime, wanted);
  assert_int_equal(out.status[i], status);
  assert_int_equal(out.regime[i], regime);
  for (int k = 0; k < (kind == STEADY ? NUMBERS : 6); k++)
    if (!check_relative(out.number[k][i], number[k], SAME_BITS)
        || (!isnan(number[k]) && !signbit(out.number[k][i]) != !signbit(number[k])))
      fail_msg("kind %d, crawler %ld, number %d: %.17g, not %.17g", kind, i, k, out.number[k][i], number[k]);
  for (int phase = 0; phase < (kind == STEADY ? 2 : 1); phase++) {
    int count = wanted[phase].count, kept = count < SCALLOP_MODES_KEPT ? count : SCALLOP_MODES_KEPT;
    assert_int_equal(got[phase].count, count);
    assert_memory_equal(got[phase].kept, wanted[phase].kept, (size_t)kept * sizeof *wanted[phase].kept);
  }
  return status < 0;
}

static long solve_and_check(int kind, long count, int threads)
{
  memset(&out, 0xff, sizeof out);
  long failed = solve(kind, count, &out, threads), counted = 0;
  for (long i = 0; i < count; i++)
    counted += check_one(kind, i);
  assert_int_equal(failed, counted);
  return failed;
}

static void every_family(uint64_t seed, int first_kind, int last_kind)
{
  struct random r = { seed };
  long counts[3] = { 0 };
  for (int which = 0; which < FAMILIES; which++)
    for (int kind = first_kind; kind <= last_kind; kind++)
      for (int gait = -1; gait < (kind == STEADY ? ALL_GAITS : 0); gait++) {
        long n = kind != STEADY || gait == 0 ? most() : check_cases(500);
        fill(&r, n, (enum family)which, (enum family)which, kind);
        for (long i = 0; i < n && gait >= 0; i++)
          in.gait[i] = every_gait[gait];
        solve_and_check(kind, n, 1);
        for (long i = 0; i < n; i++)
          if (out.status[i] >= 0)
            counts[out.regime[i]]++;
      }
  assert_true(counts[SCALLOP_SLIDING] > check_cases(1000) && counts[SCALLOP_STICK_SLIP] > check_cases(1000)
              && counts[SCALLOP_AT_REST] > 10);
}

TEST(every_family_of_steady_states) { every_family(20261121, STEADY, STEADY); }
TEST(every_family_of_phases) { every_family(20261122, SCALLOP_EXTENSION, SCALLOP_CONTRACTION); }

/* The library's own gaits have two ramps of one slope in both phases. And more modes than are kept, and phases of two
 * kinds. */
TEST(other_gaits)
{
  struct random r = { 5 };
  struct scallop_straight skewed;
  static struct teeth teeth;
  const struct scallop_gait mixed = mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal), *const gaits[] = {
    &skewed.gait, &skewed.gait, &skewed.gait, &teeth.gait, &mixed
  };
  int many = 0;
  assert_int_equal(scallop_make_skewed(&skewed, "skewed", (const double[]){ 0.25, 0.625 }), SCALLOP_OK);
  assert_true(skewed.gait.phase[0].ramps && skewed.gait.phase[1].ramps);
  grow_teeth(&teeth);
  for (int family = 0; family < FAMILIES; family++) {
    fill(&r, 200, (enum family)family, (enum family)family, STEADY);
    for (int i = 0; i < 200; i++)
      in.gait[i] = gaits[i % 5];
    assert_int_equal(solve_and_check(STEADY, 200, 1), 0);
    for (int i = 3; i < 200; i += 5)
      many += out.modes[i][0].count > SCALLOP_MODES_KEPT;
  }
  assert_true(many > 10);
}

/* Blocks that end anywhere, and no crawler at all; what lies behind the last one is not touched. */
TEST(every_length)
{
  struct random r = { 7 };
  for (int kind = 0; kind < KINDS; kind++) {
    fill(&r, 300, ORDINARY, STICK_SLIP, kind);
    for (long n = 0; n < 300; n = n < 140 ? n + 1 : n + 37) {
      assert_int_equal(solve_and_check(kind, n, 1), 0);
      assert_true(isnan(out.number[0][n]) && isnan(out.number[5][n]) && modes_of(&out, kind, n)->count == -1);
      assert_true((int)out.status[n] == -1 && (int)out.regime[n] == -1);
    }
  }
}

TEST(threads_do_not_matter)
{
  static const int threads[] = { 2, 3, 4, 5, 100000000 }; /* the last is more than OpenMP can start */
  struct random r = { 11 };
  for (int kind = 0; kind < KINDS; kind++) {
    fill(&r, most(), ORDINARY, STICK_SLIP, kind);
    memset(&out, 0, sizeof out);
    assert_int_equal(solve(kind, most(), &out, 1), 0);
    for (int k = 0; k < 5; k++) {
      memset(&again, 0, sizeof again);
      assert_int_equal(solve(kind, most(), &again, threads[k]), 0);
      assert_memory_equal(&out, &again, sizeof out);
    }
  }
}

/* Bad crawlers and bad start velocities among good ones, at every place of a block: each keeps its own status. */
TEST(failures_stay_where_they_are)
{
  struct random r = { 13 };
  for (int kind = 0; kind < KINDS; kind++) {
    long out_of_range = 0;
    fill(&r, 1000, ORDINARY, ORDINARY, kind);
    for (long i = 0; i < 1000; i++) {
      in.F1[i] = i % 7 == 3 ? -1 : in.F1[i];
      in.m2[i] = i % 29 == 3 ? 0 : in.m2[i];
      in.T[i] = i % 11 == 5 ? (i % 2 ? NAN : INFINITY) : in.T[i];
      in.alpha[i] = i % 13 == 7 ? 1 : in.alpha[i];
      start[i] = i % 23 == 7 ? NAN : start[i];
      in.L[i] = i % 17 == 9 ? (kind == STEADY ? 1e300 : DBL_MIN) : in.L[i];
      in.gait[i] = i % 19 == 2 ? NULL : &scallop_gait_quadratic;
    }
    assert_true(solve_and_check(kind, 1000, 1) > (kind == STEADY ? 200 : 300));
    for (long i = 0; i < 1000; i++)
      out_of_range += out.status[i] == SCALLOP_ERANGE;
    assert_true(kind == STEADY || out_of_range > 30);
  }
}

/* What is not wanted is not touched. */
TEST(only_what_is_wanted)
{
  struct random r = { 17 };
  double one[200];
  for (int kind = 0; kind < KINDS; kind++) {
    fill(&r, 200, ORDINARY, STICK_SLIP, kind);
    in.T[100] = -1;
    const struct scallop_crawlers c = columns_all(&in, 200);
    for (int wanted = 0; wanted < 2; wanted++) {
      const struct scallop_steady_states states = { .displacement = wanted ? one : NULL };
      const struct scallop_phases phases = { .dx1 = wanted ? one : NULL };
      assert_int_equal(kind == STEADY ? scallop_steady_batch(&c, &states, 2)
                                      : scallop_phase_batch(&c, (enum scallop_phase_kind)kind, start, &phases, 2),
                       1);
    }
    assert_int_equal(solve(kind, 200, &out, 1), 1);
    assert_memory_equal(one, out.number[3], sizeof one); /* displacement, dx1 */
  }
}
