#include <float.h>
#include <math.h>
#include <stddef.h>

#include "numerics/period.h"
#include "numerics/regular.h"

/* Crawlers are solved in blocks: first all of a block as if they had the regular modes, by vector instructions; then one by
 * one those that turn out to have others. A block is the same work whichever thread does it. */
enum { BLOCK = 32 };

struct block {
  double froude[BLOCK], v_start[BLOCK], v_mid[BLOCK], displacement[BLOCK], mean_velocity[BLOCK], multiplier[BLOCK];
  double regular[BLOCK]; /* 1 or 0 */
};

/* Needs ramps in both phases. */
static void solve_as_regular(const struct scallop_crawlers *all, long first, int count, const struct scallop_gait *gait,
                             struct block *block)
{
  const struct scallop_shape *phase = gait->phase;
  const struct tangents extension = regular_ends(&phase[0]), contraction = regular_ends(&phase[1]);
  const double top_e = phase[0].pieces[0].end, rest_e = phase[0].pieces[1].begin;
  const double top_c = phase[1].pieces[0].end, rest_c = phase[1].pieces[1].begin;
  const double *m1 = all->m1 + first, *m2 = all->m2 + first, *F1 = all->F1 + first, *F2 = all->F2 + first;
  const double *L = all->L + first, *T = all->T + first, *alpha = all->alpha + first;
#pragma omp simd
  for (int i = 0; i < count; i++) {
    struct scaling s;
    struct regular r;
    int valid = scaling_of(m1[i], m2[i], F1[i], F2[i], L[i], T[i], alpha[i], &s);
    valid &= regular_steady(&s, alpha[i], period_driven(gait, alpha[i]), &extension, &contraction, &r);
    valid &= (r.t[0] < top_e) & (r.u[0] < rest_e) & (r.t[1] < top_c) & (r.u[1] < rest_c);
    double displacement = r.travel * L[i], mean = displacement / T[i];
    valid &= fabs(mean) <= DBL_MAX;
    block->froude[i] = 1 / s.eps;
    block->v_start[i] = r.c_start * s.velocity;
    block->v_mid[i] = r.c_mid * s.velocity;
    block->displacement[i] = displacement;
    block->mean_velocity[i] = mean;
    block->multiplier[i] = r.multiplier;
    block->regular[i] = valid ? 1 : 0;
  }
}

static void put(double *column, long i, double value)
{
  if (column)
    column[i] = value;
}

static void store_regular(const struct scallop_steady_states *states, long i, const struct block *b, int j)
{
  put(states->froude, i, b->froude[j]);
  put(states->v_start, i, b->v_start[j]);
  put(states->v_mid, i, b->v_mid[j]);
  put(states->displacement, i, b->displacement[j]);
  put(states->mean_velocity, i, b->mean_velocity[j]);
  put(states->multiplier, i, b->multiplier[j]);
  put(states->v_low, i, b->v_start[j]);
  put(states->v_high, i, b->v_start[j]);
  if (states->regime)
    states->regime[i] = SCALLOP_SLIDING;
  if (states->modes)
    regular_modes(b->v_start[j] > 0, states->modes[i]);
  if (states->status)
    states->status[i] = SCALLOP_OK;
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
    states->modes[i][phase] = r->period.modes[phase];
  if (states->status)
    states->status[i] = status;
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
  const struct scallop_crawler one = { c->m1[i], c->m2[i], c->F1[i], c->F2[i], c->L[i], c->T[i], c->alpha[i], c->gait[i] };
  struct scallop_steady_result result;
  enum scallop_status status = scallop_steady(&one, &result);
  store(states, i, status, status < 0 ? &none : &result);
  return status >= 0;
}

/* Returns how many have no answer. */
static long solve_block(const struct scallop_crawlers *c, const struct scallop_steady_states *states, long first, int count)
{
  struct block block;
  const struct scallop_gait *gait = c->gait[first];
  bool ramps = gait && gait->phase[0].ramps && gait->phase[1].ramps;
  long failed = 0;
  if (ramps)
    solve_as_regular(c, first, count, gait, &block);
  for (int j = 0; j < count; j++)
    if (ramps && block.regular[j] > 0 && c->gait[first + j] == gait)
      store_regular(states, first + j, &block, j);
    else if (!solve_one(c, states, first + j))
      failed++;
  return failed;
}

long scallop_steady_batch(const struct scallop_crawlers *crawlers, const struct scallop_steady_states *states, int threads)
{
  long count = crawlers->count, failed = 0;
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads) if (threads > 1) reduction(+ : failed)
  for (long first = 0; first < count; first += BLOCK)
    failed += solve_block(crawlers, states, first, count - first < BLOCK ? (int)(count - first) : BLOCK);
  (void)threads;
  return failed;
}
