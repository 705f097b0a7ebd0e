#include "model/measured/measured.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/measured/curve_gait.h"
#include "model/measured/recording.h"

enum { MODELS = SCALLOP_MEASURED_MODELS, OTHERS = SCALLOP_MEASURED_OTHERS };

struct scallop_measured {
  const char *name;
  struct recording recording;
  struct fit fit;
  struct curve curve;
  struct curve_gait best, others[OTHERS];
  bool has_others;
};

const char *const scallop_fit_names[] = { "chosen", "monotone", "cubic", "smooth", "phases", NULL };

static const char *make_curve(struct curve_gait *made, struct curve *curve, struct fit *fit, const struct samples *s,
                              const char *name)
{
  return curve_through(curve, fit, s) ? gait_of_curve(made, curve, name) : "out of memory";
}

struct scallop_measured *scallop_measured_new(const double *t, const double *l, int count,
                                              const struct scallop_measured_options *options, const char *name,
                                              const char **why)
{
  struct scallop_measured *m = calloc(1, sizeof *m);
  *why = "out of memory";
  if (!m)
    return NULL; /* GCOVR_EXCL_LINE */
  m->name = name;
  m->fit.kind = options ? options->fit : SCALLOP_FIT_CHOSEN;
  *why = recording_of(&m->recording, t, l, count, options ? options->period : 0);
  if (!*why && options)
    m->fit.sigma = options->sigma / m->recording.range;
  if (!*why)
    *why = make_curve(&m->best, &m->curve, &m->fit, &m->recording.samples, name);
  if (!*why)
    return m;
  scallop_measured_free(m);
  return NULL;
}

void scallop_measured_free(struct scallop_measured *m)
{
  for (int i = 0; m && i < OTHERS; i++)
    curve_gait_free(&m->others[i]);
  if (m) {
    curve_gait_free(&m->best);
    free(m->curve.knots);
    free(m->recording.samples.at);
  }
  free(m);
}

double scallop_measured_length(const struct scallop_measured *m, double t)
{
  const struct recording *r = &m->recording;
  return r->low + r->range * curve_at(&m->curve, (t - r->start) / r->period);
}

int scallop_measured_samples(const struct scallop_measured *m, double *t, double *l)
{
  const struct recording *r = &m->recording;
  for (int i = 0; t && l && i < r->samples.count; i++) {
    t[i] = r->start + r->period * r->samples.at[i].t;
    l[i] = r->low + r->range * r->samples.at[i].l;
  }
  return r->samples.count;
}

static bool interpolates(const struct fit *fit)
{
  return fit->kind == SCALLOP_FIT_CUBIC || fit->kind == SCALLOP_FIT_MONOTONE;
}

void scallop_measured_text(const struct scallop_measured *m, char *text, size_t size)
{
  const char *const kinds[] = { "", "a monotone cubic spline through every row", "a cubic spline through every row",
                                "a smooth least-squares spline", "a least-squares spline for each phase" };
  int used = snprintf(text, size, "%s; %s, %d segments", m->recording.understood, kinds[m->fit.kind], m->curve.count);
  if (!interpolates(&m->fit) && used >= 0 && (size_t)used < size)
    snprintf(text + used, size - (size_t)used, ", noise %.2g of L", m->fit.noise / m->best.L);
}

/* Makes another curve, if it exists and its estimated error at a sample that is left out is at most `error`. */
static void add_other(struct curve_gait *other, struct fit fit, const struct samples *s, double error, const char *name)
{
  struct curve curve = { .knots = NULL };
  if (!s->at || make_curve(other, &curve, &fit, s, name) || fit.score > error)
    curve_gait_free(other);
  free(curve.knots);
}

/* Returns normally distributed numbers, always in the same sequence (Marsaglia's xorshift, Box & Muller). */
static double normal(uint64_t *state)
{
  double uniform[2];
  for (int i = 0; i < 2; i++) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    uniform[i] = ((double)(*state >> 11) + 0.5) * 0x1p-53;
  }
  return sqrt(-2 * log(uniform[0])) * cos(6.283185307179586 * uniform[1]);
}

/* Adds the other kinds, if their estimated errors are similar, without CUBIC if the rows have noise; then the same kind
 * through every other sample. */
static void add_models(struct scallop_measured *m)
{
  const struct samples *s = &m->recording.samples;
  const double comparable = 10;
  bool is_clean = interpolates(&m->fit);
  double most = m->fit.score > 0 ? comparable * m->fit.score : INFINITY;
  struct curve_gait *next = m->others;
  for (enum scallop_fit kind = SCALLOP_FIT_CUBIC; kind <= SCALLOP_FIT_PHASES; kind++, next += next->L > 0)
    if (kind != m->fit.kind && (kind == SCALLOP_FIT_CUBIC ? is_clean : s->count >= FIT_LEAST))
      add_other(next, (struct fit){ .kind = kind, .sigma = m->fit.sigma }, s, most, m->name);
  for (int i = 0; i < 2 && s->count >= 8; i++) {
    struct samples half = samples_every_other(s, i);
    enum scallop_fit kind = half.count < FIT_LEAST ? SCALLOP_FIT_CUBIC : m->fit.kind;
    add_other(&m->others[MODELS - 1 - i], (struct fit){ .kind = kind, .sigma = m->fit.sigma }, &half, INFINITY,
              m->name);
    free(half.at);
  }
}

static void add_resampled(struct scallop_measured *m)
{
  const struct samples *s = &m->recording.samples;
  struct fit again = m->fit;
  again.moves = true;
  double noise = m->fit.sigma > 0 ? m->fit.sigma : m->fit.noise;
  uint64_t state = 88172645463325252u;
  for (int i = MODELS; i < OTHERS; i++) {
    struct samples noisy = { .at = malloc((size_t)s->count * sizeof *noisy.at), .period = s->period };
    for (; noisy.at && noisy.count < s->count; noisy.count++) {
      double t = s->at[noisy.count].t;
      noisy.at[noisy.count] = (struct sample){ t, curve_at(&m->curve, t) + noise * normal(&state) };
    }
    add_other(&m->others[i], again, &noisy, INFINITY, m->name);
    free(noisy.at);
  }
}

struct scallop_measured_gait scallop_measured_gait(struct scallop_measured *m, int i)
{
  if (i >= 0 && !m->has_others) {
    m->has_others = true;
    add_models(m);
    if (!interpolates(&m->fit))
      add_resampled(m);
  }
  const struct curve_gait *g = i < 0 ? &m->best : &m->others[i];
  return (struct scallop_measured_gait){ g->spline.pieces ? &g->spline.gait : NULL, g->L * m->recording.range,
                                         m->recording.period, g->alpha };
}

double scallop_measured_error(double value, const double others[OTHERS])
{
  double worst = NAN, squares = 0;
  int count = 0;
  for (int i = 0; i < MODELS; i++)
    worst = fmax(worst, fabs(others[i] - value));
  for (int i = MODELS; i < OTHERS; i++)
    if (!isnan(others[i])) {
      squares += (others[i] - value) * (others[i] - value);
      count++;
    }
  if (isnan(worst) && count == 0)
    return NAN;
  double deviation = count > 0 ? sqrt(squares / count) : 0;
  return hypot(2 * deviation, isnan(worst) ? 0 : worst);
}
