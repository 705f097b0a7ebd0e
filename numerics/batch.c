#include <float.h>
#include <math.h>
#include <stddef.h>

#include "numerics/event/held.h"
#include "numerics/event/period.h"
#include "numerics/event/regular.h"
#include "numerics/threads.h"

/* Crawlers are solved in blocks. In a block those that may have the regular modes, and those of which a body may be
 * held to the end of a phase, are put in a row each and solved by vector instructions; the rest, and what turns out to
 * be something else, one by one. A block is the same work whichever thread does it. `make instructions` counts what
 * that saves. */
enum { BLOCK = 64 };

/* Twice as many crawlers an instruction where the processor can, with the same results: nothing is contracted or
 * reordered. */
#if defined VECTOR
#elif defined __x86_64__ && defined __gnu_linux__ && defined __GNUC__ && !defined __clang__ \
    && !defined __SANITIZE_ADDRESS__
#define VECTOR __attribute__((target_clones("avx2", "default")))
#else
#define VECTOR
#endif

struct row {
  int count;
  long index[BLOCK];
  double order[BLOCK]; /* held: +1 begins with the extension, -1 with the contraction                */
  double m1[BLOCK], m2[BLOCK], F1[BLOCK], F2[BLOCK], L[BLOCK], T[BLOCK], alpha[BLOCK];
};

struct answers { /* the last ones are doubles so that they fill a vector like the rest                     */
  double froude[BLOCK], v_start[BLOCK], v_mid[BLOCK], displacement[BLOCK], mean_velocity[BLOCK], multiplier[BLOCK];
  double valid[BLOCK];
  double starts[2][BLOCK], ends[2][BLOCK], grip[2][BLOCK],
      stuck[2][BLOCK]; /* of each phase, as in struct held_phase              */
};

static void collect(struct row *row, const struct scallop_crawlers *c, long i, double order)
{
  int at = row->count++;
  row->index[at] = i;
  row->order[at] = order;
  row->m1[at] = c->m1[i];
  row->m2[at] = c->m2[i];
  row->F1[at] = c->F1[i];
  row->F2[at] = c->F2[i];
  row->L[at] = c->L[i];
  row->T[at] = c->T[i];
  row->alpha[at] = c->alpha[i];
}

/* The phase at whose end, where |l'| falls to 0 with that slope, friction can hold a body: +1 the contraction, -1 the
 * extension only, 0 none. Roughly, as nothing depends on it but speed: nan where it is too close to call, which is left
 * to the call for one. */
static double holds(const struct scallop_crawlers *c, long i, double slope_e, double slope_c)
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

/* True: no result over- or underflows. */
SCALLOP_INLINE int answer(struct answers *out, int i, const struct row *row, const struct scaling *s, double c_start,
                          double c_mid, double travel, double multiplier)
{
  double displacement = scaling_back(travel, row->L[i]), mean = displacement / row->T[i];
  out->froude[i] = 1 / s->eps;
  out->v_start[i] = c_start * s->velocity;
  out->v_mid[i] = c_mid * s->velocity;
  out->displacement[i] = displacement;
  out->mean_velocity[i] = mean;
  out->multiplier[i] = multiplier;
  return scaling_keeps(1, 1 / s->eps) & scaling_keeps(c_start, c_start * s->velocity)
         & scaling_keeps(c_mid, c_mid * s->velocity) & scaling_keeps(travel, displacement)
         & scaling_keeps(travel, mean);
}

VECTOR static void solve_regular(const struct row *row, const struct scallop_gait *gait, struct answers *out)
{
  const struct scallop_shape *phase = gait->phase;
  const struct tangents extension = regular_ends(&phase[0]), contraction = regular_ends(&phase[1]);
  const struct ramps e = ramps_of(&phase[0]), c = ramps_of(&phase[1]);
#pragma omp simd
  for (int i = 0; i < row->count; i++) {
    struct scaling s;
    struct regular r;
    double alpha = row->alpha[i];
    int valid = scaling_of(row->m1[i], row->m2[i], row->F1[i], row->F2[i], row->L[i], row->T[i], alpha, &s);
    valid &= regular_steady(&s, alpha, period_driven(gait, alpha), &extension, &contraction, &r);
    valid &= (r.t[0] < e.top) & (r.u[0] < e.rest) & (r.t[1] < c.top) & (r.u[1] < c.rest);
    valid &= answer(out, i, row, &s, r.c_start, r.c_mid, r.travel, r.multiplier);
    out->valid[i] = valid ? 1 : 0;
  }
}

VECTOR static void solve_held(const struct row *row, const struct scallop_gait *gait, struct answers *out)
{
  const struct ramps e = ramps_of(&gait->phase[0]), c = ramps_of(&gait->phase[1]);
#pragma omp simd
  for (int i = 0; i < row->count; i++) {
    struct scaling s;
    struct held h;
    double alpha = row->alpha[i];
    int valid = scaling_of(row->m1[i], row->m2[i], row->F1[i], row->F2[i], row->L[i], row->T[i], alpha, &s);
    held_steady(&s, alpha, row->order[i], &e, &c, &h);
    for (int phase = 0; phase < 2; phase++) {
      out->starts[phase][i] = h.starts[phase];
      out->ends[phase][i] = h.ends[phase];
      out->stuck[phase][i] = h.stuck[phase];
      out->grip[phase][i] = h.grip[phase];
    }
    valid &= answer(out, i, row, &s, h.c_start, h.c_mid, h.travel, 0);
    valid &= !period_cancels(h.travel, h.size, 0);
    out->valid[i] = (valid & (h.margin > 0)) ? 1 : 0;
  }
}

static void put(double *column, long i, double value)
{
  if (column)
    column[i] = value;
}

static void put_answer(const struct scallop_steady_states *states, long i, const struct answers *a, int j)
{
  put(states->froude, i, a->froude[j]);
  put(states->v_start, i, a->v_start[j]);
  put(states->v_mid, i, a->v_mid[j]);
  put(states->displacement, i, a->displacement[j]);
  put(states->mean_velocity, i, a->mean_velocity[j]);
  put(states->multiplier, i, a->multiplier[j]);
  put(states->v_low, i, a->v_start[j]);
  put(states->v_high, i, a->v_start[j]);
  if (states->status)
    states->status[i] = SCALLOP_OK;
}

static void put_regular(const struct scallop_steady_states *states, long i, const struct answers *a, int j)
{
  put_answer(states, i, a, j);
  if (states->regime)
    states->regime[i] = SCALLOP_SLIDING;
  if (states->modes)
    regular_modes(a->v_start[j] > 0, states->modes[i]);
}

static void put_held(const struct scallop_steady_states *states, long i, const struct answers *a, int j)
{
  const double starts[2] = { a->starts[0][j], a->starts[1][j] }, ends[2] = { a->ends[0][j], a->ends[1][j] };
  const double stuck[2] = { a->stuck[0][j], a->stuck[1][j] }, grip[2] = { a->grip[0][j], a->grip[1][j] };
  put_answer(states, i, a, j);
  if (states->regime)
    states->regime[i] = held_regime(starts, ends, stuck);
  if (states->modes)
    held_modes(starts, ends, stuck, grip, states->modes[i]);
}

static void put_modes(struct scallop_modes *to, const struct scallop_modes *from)
{
  to->count = from->count;
  for (int i = 0; i < from->count && i < SCALLOP_MODES_KEPT; i++)
    to->kept[i] = from->kept[i];
}

static void store(const struct scallop_steady_states *states, long i, enum scallop_status status,
                  const struct scallop_steady_result *r)
{
  put(states->froude, i, r->froude);
  put(states->v_start, i, r->period.v_start);
  put(states->v_mid, i, r->period.v_mid);
  put(states->displacement, i, r->period.displacement);
  put(states->mean_velocity, i, r->mean_velocity);
  put(states->multiplier, i, r->period.multiplier);
  put(states->v_low, i, r->v_low);
  put(states->v_high, i, r->v_high);
  if (states->regime && status >= 0)
    states->regime[i] = r->period.regime;
  for (int phase = 0; states->modes && phase < 2; phase++)
    put_modes(&states->modes[i][phase], &r->period.modes[phase]);
  if (states->status)
    states->status[i] = status;
}

static struct scallop_crawler crawler_at(const struct scallop_crawlers *c, long i)
{
  return (struct scallop_crawler){ c->m1[i], c->m2[i], c->F1[i], c->F2[i], c->L[i], c->T[i], c->alpha[i], c->gait[i] };
}

/* True: there is an answer. */
static bool solve_one(const struct scallop_crawlers *c, const struct scallop_steady_states *states, long i)
{
  static const struct scallop_steady_result none = {
    .froude = NAN,
    .mean_velocity = NAN,
    .period = { .v_start = NAN, .v_mid = NAN, .displacement = NAN, .multiplier = NAN },
    .v_low = NAN,
    .v_high = NAN
  };
  const struct scallop_crawler one = crawler_at(c, i);
  struct scallop_steady_result result;
  enum scallop_status status = scallop_steady(&one, &result);
  store(states, i, status, status < 0 ? &none : &result);
  return status >= 0;
}

/* What is not of the row's kind after all is solved alone. Returns how many have no answer. */
static long store_row(const struct scallop_crawlers *c, const struct scallop_steady_states *states,
                      const struct row *row, const struct answers *answers,
                      void (*put_one)(const struct scallop_steady_states *, long, const struct answers *, int))
{
  long failed = 0;
  for (int j = 0; j < row->count; j++)
    if (answers->valid[j] > 0)
      put_one(states, row->index[j], answers, j);
    else
      failed += !solve_one(c, states, row->index[j]);
  return failed;
}

/* Returns how many of count have no answer. */
static long solve_block(const struct scallop_crawlers *c, const struct scallop_steady_states *states, long first,
                        int count)
{
  struct row regular = { .count = 0 }, held = { .count = 0 };
  struct answers answers;
  const struct scallop_gait *gait = c->gait[first];
  bool ramps = gait && gait->phase[0].ramps && gait->phase[1].ramps;
  long failed = 0;
  for (long i = first; i < first + count; i++)
    if (ramps && c->gait[i] == gait) {
      double order = holds(c, i, fabs(gait->phase[0].lT), fabs(gait->phase[1].lT));
      if (isnan(order) || (order != 0 && period_undoes(period_driven(gait, c->alpha[i]))))
        failed += !solve_one(c, states, i);
      else
        collect(order == 0 ? &regular : &held, c, i, order);
    } else {
      failed += !solve_one(c, states, i);
    }
  if (regular.count > 0)
    solve_regular(&regular, gait, &answers);
  failed += store_row(c, states, &regular, &answers, put_regular);
  if (held.count > 0)
    solve_held(&held, gait, &answers);
  return failed + store_row(c, states, &held, &answers, put_held);
}

static void store_phase(const struct scallop_phases *phases, long i, enum scallop_status status,
                        const struct scallop_phase_result *r)
{
  put(phases->t1, i, r->t1);
  put(phases->dT, i, r->dT);
  put(phases->v_end, i, r->v_end);
  put(phases->dx1, i, r->dx1);
  put(phases->dx2, i, r->dx2);
  put(phases->dxC, i, r->dxC);
  if (phases->regime && status >= 0)
    phases->regime[i] = r->regime;
  if (phases->modes)
    put_modes(&phases->modes[i], &r->modes);
  if (phases->status)
    phases->status[i] = status;
}

/* states are for solve_states, phases, v0 and kind for solve_phases; solve returns how many of count have no answer. */
struct job {
  long (*solve)(const struct job *job, long first, int count);
  const struct scallop_crawlers *crawlers;
  const struct scallop_steady_states *states;
  const struct scallop_phases *phases;
  const double *v0;
  enum scallop_phase_kind kind;
};

static long solve_states(const struct job *job, long first, int count)
{
  return solve_block(job->crawlers, job->states, first, count);
}

static long solve_phases(const struct job *job, long first, int count)
{
  static const struct scallop_phase_result none = {
    .t1 = NAN, .dT = NAN, .v_end = NAN, .dx1 = NAN, .dx2 = NAN, .dxC = NAN
  };
  long failed = 0;
  for (long i = first; i < first + count; i++) {
    const struct scallop_crawler one = crawler_at(job->crawlers, i);
    struct scallop_phase_result result;
    enum scallop_status status = scallop_phase(&one, job->kind, job->v0[i], &result);
    store_phase(job->phases, i, status, status < 0 ? &none : &result);
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
  long count = job->crawlers->count, failed = 0;
#ifdef _OPENMP
  if (threads > 1)
    threads = threads_for(threads, (count + BLOCK - 1) / BLOCK);
  if (threads > 1) { /* else without the runtime of OpenMP, which may allocate */
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

long scallop_steady_batch(const struct scallop_crawlers *crawlers, const struct scallop_steady_states *states,
                          int threads)
{
  const struct job job = { .solve = solve_states, .crawlers = crawlers, .states = states };
  return solve_all(&job, threads);
}

long scallop_phase_batch(const struct scallop_crawlers *crawlers, enum scallop_phase_kind kind, const double *v0,
                         const struct scallop_phases *phases, int threads)
{
  const struct job job = { .solve = solve_phases, .crawlers = crawlers, .phases = phases, .v0 = v0, .kind = kind };
  return solve_all(&job, threads);
}
