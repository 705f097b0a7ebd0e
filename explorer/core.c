#include "explorer/core.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/points/gait_file.h"

struct scallop_crawler explorer_crawler = { 1, 1, 4, 1, 10, 1, 0.75, &scallop_gait_quadratic };
double explorer_numbers[EXPLORER_NUMBERS], explorer_rows[EXPLORER_ROWS][EXPLORER_MOST];
char explorer_text[EXPLORER_TEXT];

static const struct scallop_gait *gait = &scallop_gait_quadratic;
static const struct gait_file *recorded; /* the chosen gait if it is measured */

double *numbers(void) { return explorer_numbers; }
double *row(int i) { return explorer_rows[i]; }
char *text(void) { return explorer_text; }
int most(void) { return EXPLORER_MOST; }
int text_size(void) { return EXPLORER_TEXT; }
const char *version(void) { return SCALLOP_VERSION; }

struct scallop_crawler explorer_row_crawler(int k)
{
  double(*x)[EXPLORER_MOST] = explorer_rows;
  return (
      struct scallop_crawler){ x[0][k], x[1][k], x[2][k], x[3][k], x[4][k], x[5][k], x[6][k], explorer_crawler.gait };
}

static int refuse(int status)
{
  snprintf(explorer_text, EXPLORER_TEXT, "%s", scallop_status_text((enum scallop_status)status));
  return status;
}

int describe_family(int i)
{
  const struct scallop_gait_family *f = scallop_gait_family(i);
  if (f)
    snprintf(explorer_text, EXPLORER_TEXT, "%s\n%s\n%s\n%s\n%s", f->name, f->numbers ? f->numbers : "",
             f->usual ? f->usual : "", f->allowed ? f->allowed : "", f->sentence ? f->sentence : "");
  return f != NULL;
}

int choose_gait(int i, int count)
{
  static union scallop_made_gait made[2];
  const struct scallop_gait_family *family = scallop_gait_family(i);
  const char *why = NULL;
  recorded = NULL;
  if (family->fixed) {
    gait = family->fixed;
    return SCALLOP_OK;
  }
  union scallop_made_gait *next = &made[explorer_crawler.gait == &made[0].gait];
  gait = explorer_crawler.gait;
  if (scallop_make_gait(next, family, family->name, explorer_numbers, count, &why) != SCALLOP_OK) {
    snprintf(explorer_text, EXPLORER_TEXT, "%s%sit takes %s", why ? why : "", why ? "; " : "", family->allowed);
    return SCALLOP_EDOMAIN;
  }
  gait = &next->gait;
  return SCALLOP_OK;
}

int choose_table(void)
{
  static struct gait_file files[2];
  struct gait_file *next = &files[explorer_crawler.gait == files[0].best.gait];
  char *table = strchr(explorer_text, '\n');
  if (!table)
    return SCALLOP_EDOMAIN;
  *table++ = '\0';
  gait = explorer_crawler.gait;
  gait_file_free(next);
  const char *wrong = gait_file_of_table(next, explorer_text, table, "measured");
  if (wrong) {
    snprintf(explorer_text, EXPLORER_TEXT, "%s", wrong);
    return SCALLOP_EDOMAIN;
  }
  gait = next->best.gait;
  recorded = next;
  const double own[] = { next->best.L, next->best.T, next->best.alpha };
  memcpy(explorer_numbers, own, sizeof own);
  return SCALLOP_OK;
}

int recording(int places)
{
  if (!recorded)
    return 0;
  const struct scallop_measured *m = recorded->measured;
  const double T = recorded->best.T, step = 1e-5 * T;
  int samples = scallop_measured_samples(m, NULL, NULL);
  if (samples > EXPLORER_MOST)
    return 0;
  scallop_measured_samples(m, explorer_rows[0], explorer_rows[1]);
  for (int i = 0; i < places; i++) {
    double t = explorer_rows[0][0] + T * i / (places - 1);
    explorer_rows[2][i] = t;
    explorer_rows[3][i] = scallop_measured_length(m, t);
    explorer_rows[4][i] = (scallop_measured_length(m, t + step) - scallop_measured_length(m, t - step)) / (2 * step);
  }
  scallop_measured_text(m, explorer_text, EXPLORER_TEXT);
  return samples;
}

int choose_crawler(void)
{
  const double *x = explorer_numbers;
  const struct scallop_crawler chosen = { x[0], x[1], x[2], x[3], x[4], x[5], x[6], gait };
  struct scallop_complaint complaint;
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_crawler_check(&chosen, &complaint);
  if (status == SCALLOP_EDOMAIN) {
    snprintf(explorer_text, EXPLORER_TEXT, "%s: %s", complaint.name, complaint.allowed);
    return status;
  }
  status = scallop_scale(&chosen, &scaled);
  if (status < 0)
    return refuse(status);
  explorer_crawler = chosen;
  return SCALLOP_OK;
}

static void write_modes(const struct scallop_modes modes[2])
{
  char phases[2][SCALLOP_MODES_TEXT];
  for (int i = 0; i < 2; i++)
    scallop_modes_text(&modes[i], phases[i]);
  snprintf(explorer_text, EXPLORER_TEXT, "%s | %s", phases[0], phases[1]);
}

int steady(void)
{
  struct scallop_steady_result s;
  double work = NAN;
  enum scallop_status status = scallop_steady(&explorer_crawler, &s);
  if (status < 0)
    return refuse(status);
  const struct scallop_period_result *p = &s.period;
  scallop_friction_work(&explorer_crawler, p->v_start, p->v_mid, &work);
  const double out[] = { s.froude,      p->v_start, p->v_mid, p->displacement, s.mean_velocity,
                         p->multiplier, s.v_low,    s.v_high, p->regime,       work };
  memcpy(explorer_numbers, out, sizeof out);
  write_modes(p->modes);
  return status;
}

int period(double v0)
{
  struct scallop_period_result p;
  enum scallop_status status = scallop_period(&explorer_crawler, v0, &p);
  if (status < 0)
    return refuse(status);
  const double out[] = { p.v_mid, p.v_end, p.displacement, p.multiplier, p.regime };
  memcpy(explorer_numbers, out, sizeof out);
  write_modes(p.modes);
  return status;
}

struct motion_walk {
  enum scallop_phase_kind kind;
  double begin; /* of the phase */
  int count;
};

static void note_interval(void *context, const struct scallop_interval *interval)
{
  struct motion_walk *w = context;
  struct scallop_span s = scallop_interval_span(interval, &explorer_crawler, w->kind);
  const double out[] = { w->begin + s.t_begin, w->begin + s.t_end, s.mode.s1, s.mode.s2 };
  if (w->count == EXPLORER_MOST)
    return;
  for (int i = 0; i < 4; i++)
    explorer_rows[i][w->count] = out[i];
  w->count++;
}

int walk(double v0, int periods)
{
  struct motion_walk w = { .count = 0 };
  for (int n = 0; n < periods && w.count < EXPLORER_MOST; n++) {
    struct scallop_period_result p;
    enum scallop_status status = scallop_period(&explorer_crawler, v0, &p);
    if (status < 0)
      return refuse(status);
    w.kind = SCALLOP_EXTENSION;
    w.begin = n * explorer_crawler.T;
    scallop_phase_intervals(&explorer_crawler, w.kind, v0, note_interval, &w);
    w.kind = SCALLOP_CONTRACTION;
    w.begin += scallop_phase_duration(&explorer_crawler, SCALLOP_EXTENSION);
    scallop_phase_intervals(&explorer_crawler, w.kind, p.v_mid, note_interval, &w);
    v0 = p.v_end;
  }
  return w.count;
}

static bool note_sample(void *context, const struct scallop_sample *s)
{
  int *count = context;
  const double out[] = { s->t, s->x1, s->x2, s->xC, s->v1, s->v2, s->l };
  for (int i = 0; i < 7; i++)
    explorer_rows[i][*count] = out[i];
  return ++*count < EXPLORER_MOST;
}

int trajectory(double v0, int periods, int samples)
{
  int count = 0;
  enum scallop_status status = scallop_trajectory(&explorer_crawler, v0, periods, samples, note_sample, &count);
  return status < 0 ? refuse(status) : count;
}
