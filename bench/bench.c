/* The benchmark: times of the solver, beside the arithmetic floor and general-purpose methods, and the start-up time.
 *
 * A batch is a number of passes over a set of seeded crawlers, long enough for the clock. All rows take turns, batch by
 * batch: a machine that slows down slows all of them. The table has the median and the quartiles of the batches. A new
 * row is a line of add_rows, a new method a line of methods. */
#include <libgen.h>
#include <limits.h>
#include <math.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "bench/floor.h"
#include "compare/text/message.h"
#include "compare/text/stopwatch.h"
#include "model/gaits.h"
#include "numerics/numerics.h"
#include "numerics/integrators/integrator.h"

enum { MANY = 1024, FEW = 64, BATCHES = 61, PARAMETERS = 7, MOST_ROWS = 64 };

static const double batch_seconds = 2e-3;

/* The crawlers of a set. eps = T^2 (F1 + F2)/(M L) decides the regime: small slides, large sticks. */
enum choice { REGULAR, STICK_SLIP, ANY, CHOICES };
static const char *const choice_text[] = { "regular", "stick-slip", "any", NULL };

struct set {
  enum choice choice;
  int count;
  struct scallop_crawler crawler[MANY];
  double v0[MANY];                    /* near the steady velocity                             */
  double v_end[MANY], way[MANY];      /* after one period from there: velocity, displacement  */
  double parameter[PARAMETERS][MANY]; /* m1 m2 F1 F2 L T alpha, as scallop_steady_batch takes */
  const struct scallop_gait *gait[MANY];
};

struct method {
  const char *name;
  stopwatch_task *body; /* an answer for each crawler of the set, or one start; context is the row */
  enum scallop_odeiv_stepper stepper;
  double goal; /* the error that a general-purpose method has to reach; else 0 */
};

struct row {
  const struct method *method;
  const struct set *set;
  const struct row *unit; /* the row that the ratio is to */
  struct scallop_integrator *integrator;
  double tolerance, error, ns[BATCHES];
  long passes;
  struct stopwatch_spread spread;
};
static struct row rows[MOST_ROWS];
static int row_count;

static const char *folder; /* of this program and those that are started */
extern char **environ;

static _Noreturn void give_up(const char *why)
{
  fprintf(stderr, "bench: %s\n", why);
  exit(3);
}

static uint64_t seed = 1303266920130311;

static double uniform(double low, double high) /* splitmix64 */
{
  uint64_t z = seed += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* T = 1 */
static struct scallop_crawler any_crawler(const struct scallop_gait *gait, enum choice choice)
{
  double log_eps = choice == REGULAR ? uniform(-4, -1) : choice == STICK_SLIP ? uniform(0, 3) : uniform(-9, 7);
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

/* The regular case of the paper: each phase begins and ends with both bodies moving forward, and in between they move
 * apart or together, turning while the separation speeds up and while it slows down. Where the floor, which is for the
 * quadratic gait, is off, the turning point of l' lies outside of the opposite motion. */
static bool is_regular(const struct scallop_crawler *c, const struct scallop_period_result *r)
{
  struct floor_result f;
  floor_steady(c, &f);
  return r->regime == SCALLOP_SLIDING && r->modes[0].count == 3 && r->modes[1].count == 3 && r->v_start > 0
         && (c->gait != &scallop_gait_quadratic
             || (fabs(f.v_start / r->v_start - 1) <= 1e-10 && fabs(f.displacement / r->displacement - 1) <= 1e-10));
}

/* Relative errors mean something only where the answer is not a small difference. */
static bool sizeable(const struct scallop_crawler *c, const struct scallop_period_result *r)
{
  return fabs(r->v_end) > 0.05 * c->L / c->T && fabs(r->displacement) > 0.05 * c->L;
}

static void put(struct set *set, int i, const struct scallop_crawler *c)
{
  const double parameter[PARAMETERS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  set->crawler[i] = *c;
  set->gait[i] = c->gait;
  for (int k = 0; k < PARAMETERS; k++)
    set->parameter[k][i] = parameter[k];
}

/* Fills a set with crawlers of the requested kind, with T = 1, each with a velocity within a fifth of the steady one.
 * starts: a period from there has the same regime, and its results are not small. */
static const struct set *fill(struct set *set, int count, const struct scallop_gait *gait, enum choice choice,
                              bool starts)
{
  struct scallop_steady_result steady;
  struct scallop_period_result r;
  set->choice = choice;
  set->count = count;
  for (int i = 0, tries = 0; i < count; tries++) {
    struct scallop_crawler c = any_crawler(gait, choice);
    if (tries > 1000 * count || scallop_steady(&c, &steady) < 0)
      give_up("no crawlers of the wanted regime");
    if ((choice == REGULAR && !is_regular(&c, &steady.period))
        || (choice == STICK_SLIP && steady.period.regime != SCALLOP_STICK_SLIP))
      continue;
    set->v0[i] = steady.period.v_start * uniform(0.8, 1.2);
    if (scallop_period(&c, set->v0[i], &r) != SCALLOP_OK)
      give_up("a crawler has no period");
    if (starts && (!sizeable(&c, &r) || r.regime != steady.period.regime))
      continue;
    set->v_end[i] = r.v_end;
    set->way[i] = r.displacement;
    put(set, i++, &c);
  }
  return set;
}

/* The same crawlers with another T */
static const struct set *with_T(struct set *set, const struct set *from, double T)
{
  *set = *from;
  for (int i = 0; i < set->count; i++) {
    struct scallop_crawler c = from->crawler[i];
    c.T = T;
    put(set, i, &c);
  }
  return set;
}

static double exact_periods(void *context)
{
  const struct set *set = ((const struct row *)context)->set;
  double sum = 0;
  for (int i = 0; i < set->count; i++) {
    struct scallop_period_result r;
    enum scallop_status status = scallop_period(&set->crawler[i], set->v0[i], &r);
    sum += status == SCALLOP_OK ? r.v_end + r.displacement : NAN;
  }
  return sum;
}

static double integrator_periods(void *context)
{
  const struct row *row = context;
  double sum = 0;
  for (int i = 0; i < row->set->count; i++) {
    struct scallop_integrator_period r;
    enum scallop_status status = row->integrator->period(row->integrator, &row->set->crawler[i], row->set->v0[i], NULL,
                                                         &r);
    sum += status == SCALLOP_OK ? r.v_end + r.displacement : NAN;
  }
  return sum;
}

static double steady_states(void *context)
{
  const struct set *set = ((const struct row *)context)->set;
  double sum = 0;
  for (int i = 0; i < set->count; i++) {
    struct scallop_steady_result r;
    sum += scallop_steady(&set->crawler[i], &r) >= 0 ? r.mean_velocity : NAN;
  }
  return sum;
}

static double floors(void *context)
{
  const struct set *set = ((const struct row *)context)->set;
  double sum = 0;
  for (int i = 0; i < set->count; i++) {
    struct floor_result r;
    floor_steady(&set->crawler[i], &r);
    sum += r.mean_velocity + r.multiplier;
  }
  return sum;
}

static double batches(void *context)
{
  const struct set *set = ((const struct row *)context)->set;
  static double out[6][MANY];
  const double(*in)[MANY] = set->parameter;
  const struct scallop_crawlers crawlers = { set->count, in[0], in[1], in[2], in[3], in[4], in[5], in[6], set->gait };
  const struct scallop_steady_states wanted = { out[0], out[1], out[2], out[3], out[4], out[5],
                                                NULL,   NULL,   NULL,   NULL,   NULL };
  double sum = scallop_steady_batch(&crawlers, &wanted, 1) == 0 ? 0 : NAN;
  for (int i = 0; i < set->count; i++)
    sum += wanted.mean_velocity[i];
  return sum;
}

/* Of a program in the folder, from being made a process to its end */
static double one_start(void *context)
{
  char path[PATH_MAX], command[] = "steady", option[] = "-o", output[] = "/dev/null";
  pid_t process;
  int ended = 0;
  snprintf(path, sizeof path, "%s/%s", folder, ((const struct row *)context)->method->name);
  if (posix_spawn(&process, path, NULL, NULL, (char *[]){ path, command, option, output, NULL }, environ) != 0
      || waitpid(process, &ended, 0) != process || ended != 0)
    give_up("a program cannot be started");
  return 0;
}

/* The larger error, where nan is larger than all. */
static double larger(double worst, double error) { return isnan(worst) || error <= worst ? worst : error; }

/* Largest relative error in v_end and displacement over the set */
static double integrator_error(const struct row *row)
{
  double worst = 0;
  for (int i = 0; i < row->set->count; i++) {
    struct scallop_integrator_period r;
    if (row->integrator->period(row->integrator, &row->set->crawler[i], row->set->v0[i], NULL, &r) != SCALLOP_OK)
      return INFINITY;
    worst = larger(worst, fabs(r.v_end / row->set->v_end[i] - 1));
    worst = larger(worst, fabs(r.displacement / row->set->way[i] - 1));
  }
  return worst;
}

/* Gives a general-purpose method its best tolerance: the largest that reaches the goal in v_end and displacement on
 * every crawler of the set. */
static double loosest_integrator(struct row *row)
{
  for (int i = 4; i <= 30; i++) { /* half decades: 1e-2 to 1e-15 */
    row->tolerance = pow(10, -0.5 * i);
    row->integrator = scallop_odeiv_integrator(row->method->stepper, row->tolerance);
    double error = row->integrator ? integrator_error(row) : INFINITY;
    if (error <= row->method->goal)
      return error;
    scallop_integrator_destroy(row->integrator);
  }
  give_up("no tolerance reaches the wanted error");
}

enum { FLOOR, STEADY, BATCH, PERIOD, INTEGRATORS, NOTHING = INTEGRATORS + 4, SCALLOP };
static const struct method methods[] = {
  { .name = "floor", .body = floors },
  { .name = "steady", .body = steady_states },
  { .name = "batch", .body = batches },
  { .name = "period", .body = exact_periods },
  { "gsl rkf45", integrator_periods, SCALLOP_ODEIV_RKF45, 1e-12 },
  { "gsl rk8pd", integrator_periods, SCALLOP_ODEIV_RK8PD, 1e-12 },
  { "gsl rkf45 to 1e-6", integrator_periods, SCALLOP_ODEIV_RKF45, 1e-6 },
  { "gsl rk8pd to 1e-6", integrator_periods, SCALLOP_ODEIV_RK8PD, 1e-6 },
  { .name = "nothing", .body = one_start },
  { .name = "scallop", .body = one_start },
};

/* unit: NULL: its own. */
static const struct row *add(int of, const struct set *set, const struct row *unit)
{
  const struct method *method = &methods[of];
  struct row *row = &rows[row_count++];
  *row = (struct row){ method, set, unit ? unit : row, .tolerance = NAN, .error = NAN };
  if (method->goal > 0)
    row->error = loosest_integrator(row);
  if (isnan(method->body(row)))
    give_up("a method failed");
  row->passes = stopwatch_passes(method->body, row, batch_seconds);
  return row;
}

/* Returns the gait of that name, one of the tables, or NULL. */
static const struct scallop_gait *gait_named(const char *name)
{
  static const double c[] = { 0, 0, 0, 10, -15, 6 };
  static struct scallop_polynomial minimum_jerk;
  if (strcmp(name, "minimum-jerk") != 0)
    return scallop_gait_named(name);
  scallop_make_polynomial(&minimum_jerk, name, c, 5, NULL);
  return &minimum_jerk.gait;
}

static void add_rows(void)
{
  enum { GAITS = 2, ALL_GAITS, TIMES = 4 }; /* the integrators, and small T, with the first two */
  const struct scallop_gait *const gaits[ALL_GAITS] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                                        gait_named("minimum-jerk") };
  static struct set many[CHOICES][ALL_GAITS], few[ANY][GAITS], small_T[GAITS][TIMES], one;
  const struct row *unit = NULL;
  for (int choice = REGULAR; choice <= ANY; choice++)
    for (int g = 0; g < ALL_GAITS; g++) {
      const struct set *set = fill(&many[choice][g], MANY, gaits[g], (enum choice)choice, false);
      unit = unit ? unit : add(FLOOR, set, NULL);
      add(STEADY, set, unit);
      add(BATCH, set, unit);
    }
  for (int g = 0; g < GAITS; g++)
    for (int i = 0; i < TIMES; i++) /* it must not cost more */
      add(STEADY, with_T(&small_T[g][i], &many[REGULAR][g], pow(10, -2 * (i + 1))), unit);
  for (int choice = REGULAR; choice <= STICK_SLIP; choice++)
    for (int g = 0; g < GAITS; g++) {
      const struct set *set = fill(&few[choice][g], FEW, gaits[g], (enum choice)choice, true);
      unit = add(PERIOD, set, NULL);
      for (int integrator = INTEGRATORS; integrator < NOTHING; integrator++)
        add(integrator, set, unit);
    }
  one.count = 1;
  add(SCALLOP, &one, add(NOTHING, &one, NULL));
}

static void measure(void)
{
  for (int i = 0; i < BATCHES; i++)
    for (struct row *row = rows; row < rows + row_count; row++) {
      double seconds = stopwatch_batch(row->method->body, row, row->passes);
      row->ns[i] = 1e9 * seconds / ((double)row->passes * row->set->count);
    }
  for (struct row *row = rows; row < rows + row_count; row++)
    row->spread = stopwatch_spread(row->ns, BATCHES);
}

static void print(void)
{
  printf(
      "# scallop %s: nanoseconds for one answer, median and quartiles of %d batches of at least %g ms\n"
      "# one thread; rows take turns; a reading of the clock takes %.0f ns\n"
      "# sets of %d crawlers, for periods %d; any: T^2 (F1 + F2)/(M L) from e^-9 to e^7\n"
      "# floor: the closed form of the regular modes written out by hand, which checks nothing; within 1e-10 of exact\n"
      "# error: GSL's, the largest relative one of v_end and displacement\n"
      "# ratio: of the medians, to the floor; GSL: to an exact period; scallop (a steady state, from the start of the\n"
      "#        process to its end): to a program that does nothing\n"
      "# tolerance: GSL's, the largest of 1e-2, 3e-3 ... 1e-15 with error <= 1e-12, or 1e-6 as said\n"
      "# quadratic: x1'' is constant in a mode, so Runge-Kutta steps of any length are exact\n"
      "method\tcrawlers\tgait\tT\tns_median\tns_q1\tns_q3\terror\tratio\ttolerance\n",
      SCALLOP_VERSION, BATCHES, 1e3 * batch_seconds, 1e9 * stopwatch_clock().cost, MANY, FEW);
  for (const struct row *row = rows; row < rows + row_count; row++) {
    const struct stopwatch_spread *s = &row->spread;
    const struct scallop_gait *gait = row->set->gait[0];
    printf("%s\t%s\t%s\t%g\t%.4g\t%.4g\t%.4g\t%.2g\t%.3g\t%.2g\n", row->method->name,
           gait ? choice_text[row->set->choice] : "-", gait ? gait->name : "-", row->set->crawler[0].T, s->median,
           s->q1, s->q3, row->error, s->median / row->unit->spread.median, row->tolerance);
  }
}

/* Makes passes over one set, for counts of instructions (scripts/dev/instructions.sh). */
static void repeat(const char *name, const char *choice_name, const char *gait_name, long passes)
{
  static struct set set;
  struct row row = { .set = &set };
  const struct scallop_gait *gait = gait_named(gait_name);
  int method = 0, choice = word_place(choice_name, choice_text);
  while (method < INTEGRATORS && strcmp(name, methods[method].name) != 0)
    method++;
  if (!gait || method == INTEGRATORS || choice < 0 || passes < 0)
    give_up("usage: scallop-bench [floor|steady|batch|period regular|stick-slip|any quadratic|sinusoidal|minimum-jerk "
            "PASSES]");
  fill(&set, FEW, gait, (enum choice)choice, false);
  double sum = 0;
  for (long i = 0; i < passes; i++)
    sum += methods[method].body(&row);
  printf("%ld answers, sum %.17g\n", passes * set.count, sum);
}

int main(int count, char **arguments)
{
  if (count == 5) {
    repeat(arguments[1], arguments[2], arguments[3], strtol(arguments[4], NULL, 10));
    return 0;
  }
  folder = dirname(arguments[0]);
  add_rows();
  measure();
  print();
  return 0;
}
