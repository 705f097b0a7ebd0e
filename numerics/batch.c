#include <float.h>
#include <math.h>
#include <stddef.h>

#include "numerics/digits.h"
#include "numerics/event/regular.h"
#include "numerics/event/stuck.h"
#include "numerics/threads.h"

/* Crawlers are solved in blocks. Within a block, a row collects the crawlers that may have the regular modes, and
 * another row the crawlers with a body that may stick to the end of a phase; vector instructions solve a row. All
 * others, and crawlers that prove to have other modes, are solved singly. Which thread solves a block changes
 * nothing. */
enum { BLOCK = 64 };

/* Twice as many crawlers an instruction if the processor can, with the same results: nothing is contracted or
 * reordered. */
#if defined VECTOR
#elif defined __x86_64__ && defined __gnu_linux__ && defined __GNUC__ && !defined __clang__ \
    && !defined __SANITIZE_ADDRESS__
#define VECTOR __attribute__((target_clones("avx2", "default")))
#else
#define VECTOR
#endif

#ifdef __wasm__ /* where size counts more */
enum { ROW_OF_SINES = false };
#else
enum { ROW_OF_SINES = true };
#endif

enum { NUMBERS = 8 };

/* Crawlers that are solved together, and their answers; flags and modes are doubles to fill a vector like the rest. */
struct row {
  const struct scallop_crawlers *of;
  int count;
  long index[BLOCK];
  double order[BLOCK];           /* as in stuck_steady; 0: the modes are the regular ones                    */
  double number[NUMBERS][BLOCK]; /* in the order of columns_of                                             */
  double course[2][BLOCK];       /* of each phase, if a body sticks                                          */
  double valid[BLOCK];
  /* of the sinusoidal gait: the four crossings, whether they are the last, and mu1 mu2 f1 f2 delta eps */
  double at[4][BLOCK], last[BLOCK], scaled[6][BLOCK];
};

/* Returns at the end of which phase, where |l'| falls to 0 with the given slope, a body can stick: +1 contraction, -1
 * extension only, 0 neither, nan if rounding could decide. Only speed depends on it. */
static double sticks(const struct scallop_crawlers *c, long i, double slope_e, double slope_c)
{
  static const double close = 1e-12;
  double a = c->alpha[i], b = 1 - a, strength = c->T[i] * c->T[i] * (c->F1[i] + c->F2[i]) / c->L[i];
  bool forward = (c->F1[i] > c->F2[i]) == (a > 0.5);
  double pull_e = slope_e * (forward ? c->m2[i] : c->m1[i]) - strength * (a * a);
  double pull_c = slope_c * (forward ? c->m1[i] : c->m2[i]) - strength * (b * b);
  if (fabs(pull_e) <= close * (strength * (a * a)) || fabs(pull_c) <= close * (strength * (b * b)))
    return NAN;
  return pull_c < 0 ? 1 : pull_e < 0 ? -1 : 0;
}

SCALLOP_INLINE int scale(const struct row *row, int i, struct scallop_scaled *s)
{
  const struct scallop_crawlers *c = row->of;
  const long at = row->index[i];
  return scaling_of(c->m1[at], c->m2[at], c->F1[at], c->F2[at], c->L[at], c->T[at], c->alpha[at], s);
}

/* Stores the numbers of a crawler. Returns whether no result over- or underflows. */
SCALLOP_INLINE int answer(struct row *row, int i, const struct scallop_scaled *s, double c_start, double c_mid,
                          double travel, double multiplier)
{
  double L = row->of->L[row->index[i]], T = row->of->T[row->index[i]], froude = 1 / s->eps;
  double displacement = scaling_back(travel, L), mean = displacement / T;
  double v_start = c_start * s->velocity, v_mid = c_mid * s->velocity;
  row->number[0][i] = froude;
  row->number[1][i] = row->number[6][i] = row->number[7][i] = v_start;
  row->number[2][i] = v_mid;
  row->number[3][i] = displacement;
  row->number[4][i] = mean;
  row->number[5][i] = multiplier;
  return scaling_keeps(1, froude) & scaling_keeps(c_start, v_start) & scaling_keeps(c_mid, v_mid)
         & scaling_keeps(travel, displacement) & scaling_keeps(travel, mean);
}

SCALLOP_INLINE void regular_of(struct row *row, int i, const struct scallop_gait *gait, const struct tangents ends[2],
                               const struct ramps *e, const struct ramps *c)
{
  struct scallop_scaled s;
  struct regular_system system;
  struct regular r;
  int valid = scale(row, i, &s);
  regular_system_of(&s, period_driven(gait, s.fraction[SCALLOP_EXTENSION]), 1, &system);
  valid &= regular_times(&system, &ends[0], &ends[1]) & regular_result(&system, &r);
  valid &= (system.e.t < e->top) & (system.e.u < e->rest) & (system.c.t < c->top) & (system.c.u < c->rest);
  valid &= answer(row, i, &s, r.c_start, r.c_mid, r.travel, r.multiplier);
  row->valid[i] = valid ? 1 : 0;
}

VECTOR static void solve_regular(struct row *row, const struct scallop_gait *gait)
{
  const struct scallop_shape *phase = gait->phase;
  const struct tangents ends[2] = { regular_ends(&phase[0]), regular_ends(&phase[1]) };
  const struct ramps e = ramps_of(&phase[0]), c = ramps_of(&phase[1]);
#pragma omp simd
  for (int i = 0; i < row->count; i++) {
    regular_of(row, i, gait, ends, &e, &c);
  }
}

VECTOR static void sine_begin(struct row *row)
{
#pragma omp simd
  for (int i = 0; i < row->count; i++) {
    struct scallop_scaled s;
    row->valid[i] = scale(row, i, &s) ? 1 : 0;
    row->scaled[0][i] = s.mu1;
    row->scaled[1][i] = s.mu2;
    row->scaled[2][i] = s.f1;
    row->scaled[3][i] = s.f2;
    row->scaled[4][i] = s.delta;
    row->scaled[5][i] = s.eps;
    row->at[0][i] = row->at[1][i] = row->at[2][i] = row->at[3][i] = row->last[i] = 0;
  }
}

/* Solves crawler i with |l'| replaced by its tangents at the crossings. Returns whether it is regular so far. */
SCALLOP_INLINE int sine_times(const struct row *row, int i, struct regular_system *system)
{
  const double(*in)[BLOCK] = row->scaled, alpha = row->of->alpha[row->index[i]];
  const struct scallop_scaled s = { .mu1 = in[0][i],
                                    .mu2 = in[1][i],
                                    .f1 = in[2][i],
                                    .f2 = in[3][i],
                                    .delta = in[4][i],
                                    .eps = in[5][i],
                                    .fraction = { alpha, 1 - alpha } };
  const struct tangents e = { regular_sine(row->at[0][i]), regular_sine(row->at[1][i]) };
  const struct tangents c = { regular_sine(row->at[2][i]), regular_sine(row->at[3][i]) };
  regular_system_of(&s, period_driven(&scallop_gait_sinusoidal, alpha), 1, system);
  int valid = regular_times(system, &e, &c);
  return valid & (system->e.t < 0.5) & (system->e.u < 0.5) & (system->c.t < 0.5) & (system->c.u < 0.5);
}

/* A step of Newton's method for all four crossings, as in regular.c; of a crawler that has arrived nothing changes. */
SCALLOP_INLINE void sine_step_of(struct row *row, int i)
{
  struct regular_system system;
  int valid = sine_times(row, i, &system);
  const double x[4] = { system.e.t, system.e.u, system.c.t, system.c.u }, last = row->last[i];
  const double at[4] = { row->at[0][i], row->at[1][i], row->at[2][i], row->at[3][i] };
  int near = regular_is_near(x[0], at[0]) & regular_is_near(x[1], at[1]) & regular_is_near(x[2], at[2])
             & regular_is_near(x[3], at[3]);
  int settles = near & regular_settles(&system.e, at[0], at[1]) & regular_settles(&system.c, at[2], at[3]);
  row->at[0][i] = last > 0 ? at[0] : x[0];
  row->at[1][i] = last > 0 ? at[1] : x[1];
  row->at[2][i] = last > 0 ? at[2] : x[2];
  row->at[3][i] = last > 0 ? at[3] : x[3];
  row->last[i] = settles ? 1 : last;
  row->valid[i] = valid ? row->valid[i] : last * row->valid[i];
}

VECTOR static void sine_step(struct row *row)
{
#pragma omp simd
  for (int i = 0; i < row->count; i++)
    sine_step_of(row, i);
}

SCALLOP_INLINE void sine_end_of(struct row *row, int i)
{
  const double steep = scallop_gait_sinusoidal.phase[0].l0, L = row->of->L[row->index[i]],
               T = row->of->T[row->index[i]];
  const struct scallop_scaled s = { .eps = row->scaled[5][i], .velocity = L / T };
  struct regular_system system;
  struct regular r;
  int valid = sine_times(row, i, &system) & regular_result(&system, &r);
  valid &= answer(row, i, &s, r.c_start, r.c_mid, r.travel, r.multiplier);
  valid &= regular_delicate_margin(&system.e, steep, steep) >= 0;
  valid &= regular_delicate_margin(&system.c, steep, steep) >= 0;
  row->valid[i] = valid ? row->valid[i] * row->last[i] : 0;
}

VECTOR static void sine_end(struct row *row)
{
#pragma omp simd
  for (int i = 0; i < row->count; i++)
    sine_end_of(row, i);
}

static void solve_sine(struct row *row, const struct scallop_gait *gait)
{
  enum { STEPS = 7 };
  (void)gait;
  sine_begin(row);
  for (int step = 0, left = 1; step < STEPS && left; step++) {
    sine_step(row);
    left = 0;
    for (int i = 0; i < row->count; i++)
      left |= row->valid[i] > 0 && row->last[i] == 0;
  }
  sine_end(row);
}

VECTOR static void solve_stuck(struct row *row, const struct scallop_gait *gait)
{
  const struct ramps e = ramps_of(&gait->phase[0]), c = ramps_of(&gait->phase[1]);
#pragma omp simd
  for (int i = 0; i < row->count; i++) {
    struct scallop_scaled s;
    struct stuck h;
    int valid = scale(row, i, &s);
    stuck_steady(&s, row->order[i], &e, &c, &h);
    row->course[0][i] = h.course[0];
    row->course[1][i] = h.course[1];
    valid &= answer(row, i, &s, h.c_start, h.c_mid, h.travel, 0);
    valid &= !period_cancels(h.travel, h.size, 1);
    row->valid[i] = (valid & (h.margin > 0)) ? 1 : 0;
  }
}

/* states are for solve_states, phases, v0 and kind for solve_phases; solve returns how many of count have no answer. */
struct job {
  long (*solve)(const struct job *job, long first, int count);
  const struct scallop_crawlers *crawlers;
  const struct scallop_steady_states *states;
  enum digits digits;
  const struct scallop_phases *phases;
  const double *v0;
  enum scallop_phase_kind kind;
};

struct columns {
  double *of[NUMBERS];
};

static struct columns columns_of(const struct scallop_steady_states *to)
{
  return (struct columns){ { to->froude, to->v_start, to->v_mid, to->displacement, to->mean_velocity, to->multiplier,
                             to->v_low, to->v_high } };
}

/* Stores one crawler's numbers, status and regime; a column that is not requested is NULL. */
static void put(struct columns columns, long i, const double numbers[NUMBERS], enum scallop_status status,
                enum scallop_regime regime, enum scallop_status *statuses, enum scallop_regime *regimes)
{
  for (int k = 0; k < NUMBERS; k++)
    if (columns.of[k])
      columns.of[k][i] = numbers[k];
  if (statuses)
    statuses[i] = status;
  if (regimes && status >= 0)
    regimes[i] = regime;
}

static void put_modes(struct scallop_modes *to, const struct scallop_modes *from)
{
  to->count = from->count;
  for (int i = 0; i < from->count && i < SCALLOP_MODES_KEPT; i++)
    to->kept[i] = from->kept[i];
}

static struct scallop_crawler crawler_at(const struct scallop_crawlers *c, long i)
{
  return (struct scallop_crawler){ c->m1[i], c->m2[i], c->F1[i], c->F2[i], c->L[i], c->T[i], c->alpha[i], c->gait[i] };
}

/* Returns 1 if the status is negative, else 0. */
static int solve_one(const struct job *job, long i)
{
  const struct scallop_steady_states *to = job->states;
  const struct scallop_crawler one = crawler_at(job->crawlers, i);
  struct scallop_steady_result r = { NAN, NAN, { NAN, NAN, NAN, NAN, NAN, .modes = { { 0 } } }, NAN, NAN, { 0 } };
  const struct scallop_period_result *p = &r.period;
  enum scallop_status status = steady_in(&one, job->digits, &r);
  const double numbers[NUMBERS] = { r.froude,        p->v_start,    p->v_mid, p->displacement,
                                    r.mean_velocity, p->multiplier, r.v_low,  r.v_high };
  put(columns_of(to), i, numbers, status, p->regime, to->status, to->regime);
  for (int kind = 0; to->modes && kind < 2; kind++)
    put_modes(&to->modes[i][kind], &p->modes[kind]);
  return status < 0;
}

/* All but its numbers */
static void put_state(const struct scallop_steady_states *to, const struct row *row, int j)
{
  const long i = row->index[j];
  bool held = row->order[j] != 0;
  const double course[2] = { held ? row->course[0][j] : 0, held ? row->course[1][j] : 0 };
  if (to->status)
    to->status[i] = SCALLOP_OK;
  if (to->regime)
    to->regime[i] = held ? course_regime(course) : SCALLOP_SLIDING;
  if (to->modes && !held)
    regular_modes(row->number[1][j] > 0, 1, to->modes[i]);
  for (int kind = 0; to->modes && held && kind < 2; kind++)
    course_modes((enum scallop_phase_kind)kind, course[kind], &to->modes[i][kind]);
}

/* Solves a row, and one by one the crawlers that have other modes. Returns how many have no answer. */
static long solve_row(const struct job *job, struct row *row, const struct scallop_gait *gait,
                      void (*solve)(struct row *, const struct scallop_gait *))
{
  const struct columns columns = columns_of(job->states);
  long failed = 0;
  if (row->count > 0)
    solve(row, gait);
  for (int k = 0; k < NUMBERS; k++)
    for (int j = 0; columns.of[k] && j < row->count; j++)
      columns.of[k][row->index[j]] = row->number[k][j];
  for (int j = 0; j < row->count; j++)
    if (row->valid[j] > 0)
      put_state(job->states, row, j);
    else
      failed += solve_one(job, row->index[j]);
  return failed;
}

static long solve_states(const struct job *job, long first, int count)
{
  const struct scallop_crawlers *c = job->crawlers;
  const struct scallop_gait *gait = c->gait[first];
  bool ramps = gait && gait->phase[0].ramps && gait->phase[1].ramps,
       sine = ROW_OF_SINES && gait == &scallop_gait_sinusoidal;
  struct row regular, held;
  regular.of = held.of = c;
  regular.count = held.count = 0;
  long failed = 0;
  for (long i = first; i < first + count; i++) {
    bool alike = (ramps || sine) && c->gait[i] == gait;
    double order = alike ? sticks(c, i, fabs(gait->phase[0].lT), fabs(gait->phase[1].lT)) : NAN;
    if (!alike || isnan(order) || (order != 0 && sine)
        || (order != 0 && period_undoes(period_driven(gait, c->alpha[i])))) {
      failed += solve_one(job, i);
      continue;
    }
    struct row *row = order == 0 ? &regular : &held;
    row->index[row->count] = i;
    row->order[row->count++] = order;
  }
  if (sine)
    failed += solve_row(job, &regular, gait, solve_sine);
  if (ramps)
    failed += solve_row(job, &regular, gait, solve_regular) + solve_row(job, &held, gait, solve_stuck);
  return failed;
}

static long solve_phases(const struct job *job, long first, int count)
{
  const struct scallop_phases *to = job->phases;
  const struct columns columns = { { to->t1, to->dT, to->v_end, to->dx1, to->dx2, to->dxC } };
  long failed = 0;
  for (long i = first; i < first + count; i++) {
    const struct scallop_crawler one = crawler_at(job->crawlers, i);
    struct scallop_phase_result r = { NAN, NAN, NAN, NAN, NAN, NAN, .modes = { .count = 0 } };
    enum scallop_status status = scallop_phase(&one, job->kind, job->v0[i], &r);
    const double numbers[NUMBERS] = { r.t1, r.dT, r.v_end, r.dx1, r.dx2, r.dxC };
    put(columns, i, numbers, status, r.regime, to->status, to->regime);
    if (to->modes)
      put_modes(&to->modes[i], &r.modes);
    failed += status < 0;
  }
  return failed;
}

/* The block that begins at first: of BLOCK crawlers, or of those that are left. */
static long solve_next(const struct job *job, long first)
{
  long left = job->crawlers->count - first;
  return job->solve(job, first, left < BLOCK ? (int)left : BLOCK);
}

static long solve_all(const struct job *job, int threads)
{
  const long count = job->crawlers->count;
  long failed = 0;
#ifdef _OPENMP
  if (threads > 1)
    threads = threads_for(threads, (count + BLOCK - 1) / BLOCK);
  if (threads > 1) { /* else without the runtime of OpenMP: it may allocate */
#pragma omp parallel for schedule(dynamic) num_threads(threads) reduction(+ : failed)
    for (long first = 0; first < count; first += BLOCK)
      failed += solve_next(job, first);
    return failed;
  }
#else
  (void)threads;
#endif
  for (long first = 0; first < count; first += BLOCK)
    failed += solve_next(job, first);
  return failed;
}

long steady_batch_in(const struct scallop_crawlers *crawlers, const struct scallop_steady_states *states,
                     enum digits digits, int threads)
{
  const struct job job = { .solve = solve_states, .crawlers = crawlers, .states = states, .digits = digits };
  return solve_all(&job, threads);
}

long scallop_steady_batch(const struct scallop_crawlers *crawlers, const struct scallop_steady_states *states,
                          int threads)
{
  return steady_batch_in(crawlers, states, ALL_DIGITS, threads);
}

long scallop_phase_batch(const struct scallop_crawlers *crawlers, enum scallop_phase_kind kind, const double *v0,
                         const struct scallop_phases *phases, int threads)
{
  const struct job job = { .solve = solve_phases, .crawlers = crawlers, .phases = phases, .v0 = v0, .kind = kind };
  return solve_all(&job, threads);
}
