/* What an exact answer costs, and what the general-purpose rival takes for the same one.
 *
 * A batch is a number of passes over a set of seeded crawlers, long enough for the clock; the methods of
 * a case take turns, batch by batch, so that a machine that slows down slows all of them; the table has
 * the median and the quartiles of the batches, in nanoseconds for one period (or one steady state). The
 * rival's memory is made beforehand. Its tolerance is the one that takes the fewest evaluations among
 * those that reach the wanted error on every crawler of the set: it is given its best. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "numerics/numerics.h"
#include "numerics/odeiv.h"

enum { CRAWLERS = 64, BATCHES = 61, METHODS = 5, STEADY_TIMES = 5 };

static const double batch_seconds = 2e-3;
static volatile double sink; /* results go here, so that no work can be left out */

struct crawlers {
  struct scallop_crawler crawler[CRAWLERS];
  double v0[CRAWLERS];
  struct scallop_period_result exact[CRAWLERS];
};

struct method {
  const char *name;
  double (*answer)(const struct method *method, int i); /* for crawler i; nan if there is none */
  const struct crawlers *set;
  struct scallop_odeiv *odeiv;
  double goal, tolerance, error;
  long passes;
  double ns[BATCHES];
};

static _Noreturn void give_up(const char *why)
{
  fprintf(stderr, "bench: %s\n", why);
  exit(3);
}

/* ---- the crawlers ---- */

static uint64_t seed = 1303266920130311;

static double uniform(double low, double high) /* splitmix64 */
{
  uint64_t z = seed += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* T = 1; eps decides the regime: small slides, large sticks. */
static struct scallop_crawler any_crawler(const struct scallop_gait *gait, enum scallop_regime regime)
{
  double log_eps = regime == SCALLOP_SLIDING ? uniform(-4, -1) : uniform(0, 3);
  struct scallop_crawler c = { .m1 = exp(uniform(-1, 1)),
                               .m2 = exp(uniform(-1, 1)),
                               .F1 = exp(uniform(-1, 1)),
                               .F2 = exp(uniform(-1, 1)),
                               .T = 1,
                               .alpha = uniform(0.2, 0.8),
                               .gait = gait };
  c.L = (c.F1 + c.F2) / (c.m1 + c.m2) / exp(log_eps);
  return c;
}

/* The regular case of the paper: each phase begins and ends with both bodies moving the same way, and
 * in between they move apart or together. */
static bool regular(const struct scallop_period_result *r)
{
  return r->regime == SCALLOP_SLIDING && r->modes[0].count == 3 && r->modes[1].count == 3;
}

/* Relative errors mean something only where the answer is not a small difference. */
static bool sizeable(const struct scallop_crawler *c, const struct scallop_period_result *r)
{
  return fabs(r->v_end) > 0.05 * c->L / c->T && fabs(r->displacement) > 0.05 * c->L;
}

/* Crawlers within a fifth of their steady velocity, all of the wanted regime. */
static void fill(struct crawlers *set, const struct scallop_gait *gait, enum scallop_regime regime)
{
  struct scallop_steady_result steady;
  for (int i = 0, tries = 0; i < CRAWLERS; tries++) {
    struct scallop_crawler c = any_crawler(gait, regime);
    struct scallop_period_result *r = &set->exact[i];
    if (tries > 1000 * CRAWLERS || scallop_steady(&c, &steady) < 0)
      give_up("no crawlers of the wanted regime");
    double v0 = steady.period.v_start * uniform(0.8, 1.2);
    if (scallop_period(&c, v0, r) != SCALLOP_OK)
      give_up("a crawler has no period");
    if (!sizeable(&c, r) || (regime == SCALLOP_SLIDING ? !regular(r) : r->regime != regime))
      continue;
    set->crawler[i] = c;
    set->v0[i++] = v0;
  }
}

/* ---- the methods ---- */

static double exact_period(const struct method *m, int i)
{
  struct scallop_period_result r;
  enum scallop_status status = scallop_period(&m->set->crawler[i], m->set->v0[i], &r);
  return status == SCALLOP_OK ? r.v_end + r.displacement : NAN;
}

static double odeiv_period(const struct method *m, int i)
{
  struct scallop_rival_period r;
  const struct crawlers *set = m->set;
  enum scallop_status status = scallop_odeiv_run(m->odeiv, &set->crawler[i], set->v0[i], m->tolerance, &r);
  return status == SCALLOP_OK ? r.v_end + r.displacement : NAN;
}

static double exact_steady(const struct method *m, int i)
{
  struct scallop_steady_result r;
  return scallop_steady(&m->set->crawler[i], &r) >= 0 ? r.mean_velocity : NAN;
}

static double clock_alone(const struct method *m, int i)
{
  (void)m;
  (void)i;
  struct timespec t;
  return clock_gettime(CLOCK_MONOTONIC, &t) == 0 ? (double)t.tv_nsec : NAN;
}

/* The larger error, where nan is larger than all. */
static double larger(double worst, double error) { return isnan(worst) || error <= worst ? worst : error; }

/* Largest relative error in v_end and displacement over the set, and the evaluations it took. */
static double odeiv_error(const struct method *m, double tolerance, long *evaluations)
{
  double worst = 0;
  *evaluations = 0;
  for (int i = 0; i < CRAWLERS; i++) {
    const struct scallop_period_result *exact = &m->set->exact[i];
    struct scallop_rival_period r;
    if (scallop_odeiv_run(m->odeiv, &m->set->crawler[i], m->set->v0[i], tolerance, &r) != SCALLOP_OK)
      return INFINITY;
    worst = larger(worst, fabs(r.v_end / exact->v_end - 1));
    worst = larger(worst, fabs(r.displacement / exact->displacement - 1));
    *evaluations += r.evaluations;
  }
  return worst;
}

/* The cheapest tolerance that reaches the goal. */
static void choose_tolerance(struct method *m)
{
  long fewest = 0, evaluations;
  m->error = INFINITY;
  for (int i = 4; i <= 30; i++) { /* half decades: 1e-2 to 1e-15 */
    double tolerance = pow(10, -0.5 * i), error = odeiv_error(m, tolerance, &evaluations);
    if (error <= m->goal && (fewest == 0 || evaluations < fewest)) {
      fewest = evaluations;
      m->tolerance = tolerance;
      m->error = error;
    }
  }
  if (fewest == 0)
    give_up("no tolerance reaches the wanted error");
}

/* How far a period moves the steady state: it should not. */
static double steady_error(const struct crawlers *set)
{
  double worst = 0;
  struct scallop_steady_result r;
  for (int i = 0; i < CRAWLERS; i++) {
    if (scallop_steady(&set->crawler[i], &r) != SCALLOP_OK)
      give_up("no steady state");
    worst = larger(worst, fabs(r.period.v_end / r.period.v_start - 1));
  }
  return worst;
}

/* ---- timing ---- */

static double now(void)
{
  struct timespec t;
  if (clock_gettime(CLOCK_MONOTONIC, &t) != 0)
    give_up("no monotonic clock");
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double seconds(const struct method *m, long passes)
{
  double sum = 0, start = now();
  for (long pass = 0; pass < passes; pass++)
    for (int i = 0; i < CRAWLERS; i++)
      sum += m->answer(m, i);
  double end = now();
  sink = sum;
  if (isnan(sum))
    give_up("a method failed");
  return end - start;
}

/* Doubles the passes until a batch is long enough, which also warms everything up. */
static void calibrate(struct method *m)
{
  for (m->passes = 1; seconds(m, m->passes) < batch_seconds; m->passes *= 2)
    ;
}

static int ascending(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void measure(struct method *methods, int count)
{
  for (int k = 0; k < count; k++)
    calibrate(&methods[k]);
  for (int batch = 0; batch < BATCHES; batch++)
    for (int k = 0; k < count; k++) {
      struct method *m = &methods[k];
      m->ns[batch] = 1e9 * seconds(m, m->passes) / ((double)m->passes * CRAWLERS);
    }
  for (int k = 0; k < count; k++)
    qsort(methods[k].ns, BATCHES, sizeof *methods[k].ns, ascending);
}

static double median(const struct method *m) { return m->ns[BATCHES / 2]; }

/* ---- the table ---- */

static void print_row(const char *name, const char *gait, const struct method *m, const struct method *reference)
{
  double q1 = m->ns[BATCHES / 4], q3 = m->ns[BATCHES - 1 - BATCHES / 4];
  printf("%s\t%s\t%s\t%.4g\t%.4g\t%.4g\t%.2g\t%.3g\t%.2g\n", name, gait, m->name, median(m), q1, q3, m->error,
         median(m) / median(reference), m->tolerance);
  fflush(stdout);
}

static void summary(const char *name, const char *gait, const struct method *m)
{
  const struct method *best = median(&m[1]) < median(&m[2]) ? &m[1] : &m[2];
  printf("# %s %s: the best GSL at error <= %g is %s: %.1f times the exact solver's time", name, gait, best->goal,
         best->name, median(best) / median(m));
  printf("\n");
}

static void bench_period(const char *name, const struct crawlers *set)
{
  const char *gait = set->crawler[0].gait->name;
  struct scallop_odeiv *rkf45 = scallop_odeiv_make(SCALLOP_ODEIV_RKF45);
  struct scallop_odeiv *rk8pd = scallop_odeiv_make(SCALLOP_ODEIV_RK8PD);
  if (!rkf45 || !rk8pd)
    give_up("out of memory");
  struct method m[METHODS] = {
    { .name = "exact", .answer = exact_period, .set = set, .tolerance = NAN },
    { .name = "gsl rkf45", .answer = odeiv_period, .set = set, .odeiv = rkf45, .goal = 1e-12 },
    { .name = "gsl rk8pd", .answer = odeiv_period, .set = set, .odeiv = rk8pd, .goal = 1e-12 },
    { .name = "gsl rkf45 to 1e-6", .answer = odeiv_period, .set = set, .odeiv = rkf45, .goal = 1e-6 },
    { .name = "gsl rk8pd to 1e-6", .answer = odeiv_period, .set = set, .odeiv = rk8pd, .goal = 1e-6 },
  };
  for (int k = 1; k < METHODS; k++)
    choose_tolerance(&m[k]);
  measure(m, METHODS);
  for (int k = 0; k < METHODS; k++)
    print_row(name, gait, &m[k], m);
  summary(name, gait, m);
  scallop_odeiv_destroy(rkf45);
  scallop_odeiv_destroy(rk8pd);
}

static void bench_steady(const struct crawlers *set)
{
  static const double T[STEADY_TIMES] = { 1, 1e-2, 1e-4, 1e-6, 1e-8 };
  static const char *const name[STEADY_TIMES] = { "steady T=1", "steady T=1e-2", "steady T=1e-4", "steady T=1e-6",
                                                  "steady T=1e-8" };
  static struct crawlers sets[STEADY_TIMES];
  struct method m[STEADY_TIMES];
  for (int k = 0; k < STEADY_TIMES; k++) {
    sets[k] = *set;
    for (int i = 0; i < CRAWLERS; i++)
      sets[k].crawler[i].T = T[k];
    m[k] = (struct method){
      .name = "exact", .answer = exact_steady, .set = &sets[k], .tolerance = NAN, .error = steady_error(&sets[k])
    };
  }
  measure(m, STEADY_TIMES);
  for (int k = 0; k < STEADY_TIMES; k++)
    print_row(name[k], set->crawler[0].gait->name, &m[k], m);
}

static void bench_clock(void)
{
  struct method m = { .name = "clock_gettime", .answer = clock_alone, .tolerance = NAN };
  measure(&m, 1);
  print_row("clock", "-", &m, &m);
}

static void print_head(void)
{
  printf("# scallop %s: time for one period and for one steady state\n", SCALLOP_VERSION);
  printf("# %d batches of at least %g ms, methods in turn; sets of %d crawlers\n", BATCHES, 1e3 * batch_seconds, CRAWLERS);
  printf("# ns: median and quartiles over the batches, for one answer\n");
  printf("# error: largest relative difference of v_end and displacement from exact (itself 0);\n");
  printf("#        steady: how far one period moves the steady velocity, relative\n");
  printf("# ratio: of the medians, to exact in the same case and gait; steady: to T=1, and must not grow\n");
  printf("# tolerance: GSL's, the cheapest of 1e-2, 3e-3 ... 1e-15 with error <= 1e-12, or 1e-6 as said\n");
  printf("# quadratic: x1'' is constant in a mode, so Runge-Kutta steps of any length are exact\n");
  printf("case\tgait\tmethod\tns_median\tns_q1\tns_q3\terror\tratio\ttolerance\n");
}

int main(void)
{
  static struct crawlers set;
  static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal };
  print_head();
  bench_clock();
  for (int i = 0; i < 2; i++) {
    fill(&set, gaits[i], SCALLOP_SLIDING);
    bench_period("regular", &set);
    bench_steady(&set);
    fill(&set, gaits[i], SCALLOP_STICK_SLIP);
    bench_period("stick-slip", &set);
  }
  return 0;
}
