/* Many crawlers at once against one at a time: the same bits, for any number of threads and any mixture of gaits and modes. */
#include "tests/check.h"

#include <float.h>
#include <string.h>

#include "numerics/numerics.h"
#include "tests/random_crawler.h"
#include "tests/solved.h"

enum { MOST = 4000 };

static long most(void) { return check_cases(MOST); }

struct columns {
  double m1[MOST], m2[MOST], F1[MOST], F2[MOST], L[MOST], T[MOST], alpha[MOST];
  const struct scallop_gait *gait[MOST];
};
struct results {
  double froude[MOST], v_start[MOST], v_mid[MOST], displacement[MOST], mean_velocity[MOST], multiplier[MOST], v_low[MOST],
      v_high[MOST];
  enum scallop_regime regime[MOST];
  struct scallop_modes modes[MOST][2];
  enum scallop_status status[MOST];
};

struct phases {
  double t1[MOST], dT[MOST], v_end[MOST], dx1[MOST], dx2[MOST], dxC[MOST];
  enum scallop_regime regime[MOST];
  struct scallop_modes modes[MOST];
  enum scallop_status status[MOST];
};

static struct columns in;
static double v0[MOST];
static struct results out, again;
static struct phases phase_out, phase_again;

static struct scallop_crawlers crawlers(long count)
{
  return (struct scallop_crawlers){ count, in.m1, in.m2, in.F1, in.F2, in.L, in.T, in.alpha, in.gait };
}

static struct scallop_steady_states everything(struct results *r)
{
  return (struct scallop_steady_states){ r->froude, r->v_start, r->v_mid,  r->displacement, r->mean_velocity, r->multiplier,
                                         r->v_low,  r->v_high,  r->regime, r->modes,        r->status };
}

static struct scallop_phases every_column(struct phases *p)
{
  return (struct scallop_phases){ p->t1, p->dT, p->v_end, p->dx1, p->dx2, p->dxC, p->regime, p->modes, p->status };
}

static struct scallop_crawler crawler(long i)
{
  return (struct scallop_crawler){ in.m1[i], in.m2[i], in.F1[i], in.F2[i], in.L[i], in.T[i], in.alpha[i], in.gait[i] };
}

static void put(long i, const struct scallop_crawler *c)
{
  in.m1[i] = c->m1;
  in.m2[i] = c->m2;
  in.F1[i] = c->F1;
  in.F2[i] = c->F2;
  in.L[i] = c->L;
  in.T[i] = c->T;
  in.alpha[i] = c->alpha;
  in.gait[i] = c->gait;
}

static bool same(double a, double b)
{
  return (check_relative(a, b, SAME_BITS) && !signbit(a) == !signbit(b)) || (isnan(a) && isnan(b));
}

static void check_modes(const struct scallop_modes *got, const struct scallop_modes *wanted)
{
  int kept = wanted->count < SCALLOP_MODES_KEPT ? wanted->count : SCALLOP_MODES_KEPT;
  assert_int_equal(got->count, wanted->count);
  assert_memory_equal(got->kept, wanted->kept, (size_t)kept * sizeof *got->kept);
}

static void check_one(long i)
{
  struct scallop_crawler c = crawler(i);
  struct scallop_steady_result r;
  enum scallop_status status = scallop_steady(&c, &r);
  assert_int_equal(out.status[i], status);
  if (status < 0) {
    assert_true(isnan(out.froude[i]) && isnan(out.v_start[i]) && isnan(out.v_mid[i]) && isnan(out.displacement[i])
                && isnan(out.mean_velocity[i]) && isnan(out.multiplier[i]) && isnan(out.v_low[i]) && isnan(out.v_high[i]));
    assert_int_equal(out.modes[i][0].count + out.modes[i][1].count, 0);
    return;
  }
  if (!same(out.v_start[i], r.period.v_start) || !same(out.displacement[i], r.period.displacement))
    print_error("m1=%.17g m2=%.17g F1=%.17g F2=%.17g L=%.17g T=%.17g alpha=%.17g %s: %.17g %.17g\n", c.m1, c.m2, c.F1, c.F2,
                c.L, c.T, c.alpha, c.gait->name, out.v_start[i], r.period.v_start);
  assert_true(same(out.froude[i], r.froude) && same(out.v_start[i], r.period.v_start) && same(out.v_mid[i], r.period.v_mid));
  assert_true(same(out.displacement[i], r.period.displacement) && same(out.mean_velocity[i], r.mean_velocity));
  assert_true(same(out.multiplier[i], r.period.multiplier) && same(out.v_low[i], r.v_low) && same(out.v_high[i], r.v_high));
  assert_int_equal(out.regime[i], r.period.regime);
  for (int phase = 0; phase < 2; phase++)
    check_modes(&out.modes[i][phase], &r.period.modes[phase]);
}

static void solve_and_check(long count, int threads)
{
  struct scallop_crawlers c = crawlers(count);
  struct scallop_steady_states s = everything(&out);
  long failed = 0;
  assert_int_equal(scallop_steady_batch(&c, &s, threads), 0);
  for (long i = 0; i < count; i++) {
    check_one(i);
    failed += out.status[i] < 0;
  }
  assert_int_equal(failed, 0);
}

TEST(every_family)
{
  struct random r = { 20261121 };
  long counts[3] = { 0 };
  for (int which = 0; which < FAMILIES; which++)
    for (int gait = -1; gait < ALL_GAITS; gait++) {
      long n = gait == 0 ? most() : check_cases(500);
      for (long i = 0; i < n; i++) {
        struct scallop_crawler c = random_crawler(&r, (enum family)which, every_gait[gait < 0 ? i % ALL_GAITS : gait]);
        put(i, &c);
      }
      struct scallop_crawlers c = crawlers(n);
      struct scallop_steady_states s = everything(&out);
      (void)scallop_steady_batch(&c, &s, 1);
      for (long i = 0; i < n; i++) {
        check_one(i);
        if (out.status[i] >= 0)
          counts[out.regime[i]]++;
      }
    }
  assert_true(counts[SCALLOP_SLIDING] > check_cases(1000) && counts[SCALLOP_STICK_SLIP] > check_cases(1000)
              && counts[SCALLOP_AT_REST] > 10);
}

/* Blocks that end anywhere, and no crawler at all. */
TEST(every_length)
{
  struct random r = { 7 };
  for (long i = 0; i < 300; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 3 ? ORDINARY : STICK_SLIP, &scallop_gait_quadratic);
    put(i, &c);
  }
  for (long n = 0; n < 300; n = n < 140 ? n + 1 : n + 37)
    solve_and_check(n, 1);
}

/* The last is more than OpenMP can start. */
static const int numbers_of_threads[] = { 1, 2, 3, 4, 5, 100000000, 0 };

TEST(threads_do_not_matter)
{
  struct random r = { 11 };
  for (long i = 0; i < most(); i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % ALL_GAITS]);
    put(i, &c);
  }
  for (int k = 0; numbers_of_threads[k]; k++) {
    int threads = numbers_of_threads[k];
    struct scallop_crawlers c = crawlers(most());
    struct scallop_steady_states s = everything(threads == 1 ? &out : &again);
    memset(threads == 1 ? &out : &again, 0, sizeof out);
    assert_int_equal(scallop_steady_batch(&c, &s, threads), 0);
    if (threads > 1)
      assert_memory_equal(&out, &again, sizeof out);
  }
}

/* Bad crawlers among good ones, at every place of a block: each keeps its own status. */
TEST(failures_stay_where_they_are)
{
  struct random r = { 13 };
  long bad = 0;
  for (long i = 0; i < 1000; i++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, &scallop_gait_quadratic);
    c.F1 = i % 7 == 3 ? -1 : c.F1;
    c.T = i % 11 == 5 ? NAN : c.T;
    c.alpha = i % 13 == 7 ? 1 : c.alpha;
    c.L = i % 17 == 9 ? 1e300 : c.L;
    c.gait = i % 19 == 2 ? NULL : c.gait;
    put(i, &c);
  }
  struct scallop_crawlers c = crawlers(1000);
  struct scallop_steady_states s = everything(&out);
  long failed = scallop_steady_batch(&c, &s, 1);
  for (long i = 0; i < 1000; i++) {
    check_one(i);
    bad += out.status[i] < 0;
  }
  assert_int_equal(failed, bad);
  assert_true(bad > 200);
}

/* What is not wanted is not touched. */
TEST(only_what_is_wanted)
{
  struct random r = { 17 };
  double displacement[200];
  for (long i = 0; i < 200; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % 2]);
    put(i, &c);
  }
  struct scallop_crawlers c = crawlers(200);
  struct scallop_steady_states nothing = { .status = NULL }, one = { .displacement = displacement };
  assert_int_equal(scallop_steady_batch(&c, &nothing, 2), 0);
  assert_int_equal(scallop_steady_batch(&c, &one, 2), 0);
  struct scallop_steady_states s = everything(&out);
  assert_int_equal(scallop_steady_batch(&c, &s, 1), 0);
  assert_memory_equal(displacement, out.displacement, sizeof displacement);
}

static void check_phase(long i, enum scallop_phase_kind kind)
{
  const struct scallop_crawler c = crawler(i);
  const struct phases *p = &phase_out;
  struct scallop_phase_result r;
  enum scallop_status status = scallop_phase(&c, kind, v0[i], &r);
  assert_int_equal(p->status[i], status);
  if (status < 0) {
    assert_true(isnan(p->t1[i]) && isnan(p->dT[i]) && isnan(p->v_end[i]));
    assert_true(isnan(p->dx1[i]) && isnan(p->dx2[i]) && isnan(p->dxC[i]));
    assert_int_equal(p->modes[i].count, 0);
    return;
  }
  assert_true(same(p->t1[i], r.t1) && same(p->dT[i], r.dT) && same(p->v_end[i], r.v_end));
  assert_true(same(p->dx1[i], r.dx1) && same(p->dx2[i], r.dx2) && same(p->dxC[i], r.dxC));
  assert_int_equal(p->regime[i], r.regime);
  check_modes(&p->modes[i], &r.modes);
}

TEST(every_family_of_phases)
{
  struct random r = { 20261122 };
  long counts[3] = { 0 };
  for (int which = 0; which < FAMILIES; which++)
    for (int kind = SCALLOP_EXTENSION; kind <= SCALLOP_CONTRACTION; kind++) {
      for (long i = 0; i < most(); i++) {
        struct scallop_crawler c = random_crawler(&r, (enum family)which, every_gait[i % ALL_GAITS]);
        put(i, &c);
        v0[i] = random_start(&r, &c, (enum scallop_phase_kind)kind);
      }
      struct scallop_crawlers c = crawlers(most());
      struct scallop_phases p = every_column(&phase_out);
      (void)scallop_phase_batch(&c, (enum scallop_phase_kind)kind, v0, &p, 1);
      for (long i = 0; i < most(); i++) {
        check_phase(i, (enum scallop_phase_kind)kind);
        if (phase_out.status[i] >= 0)
          counts[phase_out.regime[i]]++;
      }
    }
  assert_true(counts[SCALLOP_SLIDING] > check_cases(1000) && counts[SCALLOP_STICK_SLIP] > check_cases(1000)
              && counts[SCALLOP_AT_REST] > 10);
}

/* Blocks that end anywhere, and no crawler at all; what lies behind the last one is not touched. */
TEST(every_length_of_phases)
{
  struct random r = { 19 };
  for (long i = 0; i < 300; i++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, every_gait[i % ALL_GAITS]);
    put(i, &c);
    v0[i] = random_start(&r, &c, SCALLOP_CONTRACTION);
  }
  for (long n = 0; n < 300; n = n < 140 ? n + 1 : n + 37) {
    struct scallop_crawlers c = crawlers(n);
    struct scallop_phases p = every_column(&phase_out);
    memset(&phase_out, 0xff, sizeof phase_out);
    assert_int_equal(scallop_phase_batch(&c, SCALLOP_CONTRACTION, v0, &p, 1), 0);
    for (long i = 0; i < n; i++)
      check_phase(i, SCALLOP_CONTRACTION);
    assert_true(isnan(phase_out.t1[n]) && isnan(phase_out.dxC[n]) && phase_out.modes[n].count == -1);
    assert_true((int)phase_out.status[n] == -1 && (int)phase_out.regime[n] == -1);
  }
}

TEST(threads_do_not_matter_to_phases)
{
  struct random r = { 23 };
  for (long i = 0; i < most(); i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % ALL_GAITS]);
    put(i, &c);
    v0[i] = random_start(&r, &c, SCALLOP_EXTENSION);
  }
  for (int k = 0; numbers_of_threads[k]; k++) {
    int threads = numbers_of_threads[k];
    struct scallop_crawlers c = crawlers(most());
    struct phases *to = threads == 1 ? &phase_out : &phase_again;
    struct scallop_phases p = every_column(to);
    memset(to, 0, sizeof *to);
    assert_int_equal(scallop_phase_batch(&c, SCALLOP_EXTENSION, v0, &p, threads), 0);
    if (threads > 1)
      assert_memory_equal(&phase_out, &phase_again, sizeof phase_out);
  }
}

/* Bad crawlers and bad start velocities among good ones: each keeps its own status, and its regime is not touched. */
TEST(failures_of_phases_stay_where_they_are)
{
  struct random r = { 29 };
  long bad = 0, out_of_range = 0;
  for (long i = 0; i < 1000; i++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, &scallop_gait_quadratic);
    v0[i] = random_start(&r, &c, SCALLOP_EXTENSION);
    v0[i] = i % 13 == 7 ? NAN : v0[i];
    c.m2 = i % 7 == 3 ? 0 : c.m2;
    c.T = i % 11 == 5 ? INFINITY : c.T;
    c.L = i % 17 == 9 ? DBL_MIN : c.L;
    c.gait = i % 19 == 2 ? NULL : c.gait;
    put(i, &c);
  }
  struct scallop_crawlers c = crawlers(1000);
  struct scallop_phases p = every_column(&phase_out);
  memset(phase_out.regime, 0xff, sizeof phase_out.regime);
  long failed = scallop_phase_batch(&c, SCALLOP_EXTENSION, v0, &p, 1);
  for (long i = 0; i < 1000; i++) {
    check_phase(i, SCALLOP_EXTENSION);
    bad += phase_out.status[i] < 0;
    out_of_range += phase_out.status[i] == SCALLOP_ERANGE;
    assert_true((phase_out.status[i] < 0) == ((int)phase_out.regime[i] == -1));
  }
  assert_int_equal(failed, bad);
  assert_true(bad > 300 && out_of_range > 30);
}

/* What is not wanted is not touched. */
TEST(only_the_columns_that_are_wanted)
{
  struct random r = { 31 };
  double dxC[200];
  for (long i = 0; i < 200; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % ALL_GAITS]);
    put(i, &c);
    v0[i] = random_start(&r, &c, SCALLOP_EXTENSION);
  }
  in.T[100] = -1;
  struct scallop_crawlers c = crawlers(200);
  struct scallop_phases nothing = { .status = NULL }, one = { .dxC = dxC }, all = every_column(&phase_out);
  assert_int_equal(scallop_phase_batch(&c, SCALLOP_EXTENSION, v0, &nothing, 2), 1);
  assert_int_equal(scallop_phase_batch(&c, SCALLOP_EXTENSION, v0, &one, 2), 1);
  assert_int_equal(scallop_phase_batch(&c, SCALLOP_EXTENSION, v0, &all, 1), 1);
  assert_memory_equal(dxC, phase_out.dxC, sizeof dxC);
}
