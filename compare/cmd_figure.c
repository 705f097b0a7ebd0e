/* The tables behind the paper's figures. Only + - * / and square roots are used, and gaits whose l' is
 * linear, so that the tables have the same bytes on every machine. */
#include <stdbool.h>
#include <string.h>

#include "asymptotics/asymptotics.h"
#include "compare/compare.h"

static const char *const accepts[] = { "format", "digits", "output", "quiet", NULL };

/* What the captions and the text say of all figures: m1 = m2 = 1, F2 = 1, piecewise quadratic. */
static struct scallop_crawler paper_crawler(double F1, double T, double alpha)
{
  struct scallop_crawler c = scallop_crawler_default();
  c.F1 = F1;
  c.T = T;
  c.alpha = alpha;
  return c;
}

static void begin_rows(struct table *t, const char *const *columns)
{
  table_columns(t, columns);
  table_begin_rows(t);
}

/* ---- figure 2: positions from rest, symmetric and asymmetric ---- */

struct curve {
  struct table *table;
  const char *panel;
  struct scallop_crawler crawler;
  double until;
};

static bool position_row(void *context, const struct scallop_sample *s)
{
  struct curve *curve = context;
  double L = curve->crawler.L, T = curve->crawler.T;
  table_text(curve->table, curve->panel);
  table_number(curve->table, s->t / T);
  table_number(curve->table, s->x1 / L);
  table_number(curve->table, s->x2 / L);
  table_number(curve->table, s->xC / L);
  table_number(curve->table, s->l / L);
  return true;
}

static enum scallop_status figure_2(struct table *t)
{
  static const char *const columns[] = { "kinematics", "t_over_T", "x1_over_L", "x2_over_L", "xC_over_L", "l_over_L", NULL };
  table_note(t, "figure 2: positions from rest; kinematics symmetric (A, B) and asymmetric (C, D)");
  table_note(t, "m1 = m2 = 1, F1 = 4, F2 = 1, quadratic");
  table_note(t, "assumed: L = 10, T = 2, alpha = 3/4 where asymmetric, 8 periods");
  begin_rows(t, columns);
  struct curve symmetric = { t, "symmetric", paper_crawler(4, 2, 0.5), 0 };
  struct curve asymmetric = { t, "asymmetric", paper_crawler(4, 2, 0.75), 0 };
  enum scallop_status status = scallop_trajectory(&symmetric.crawler, 0, 8, 40, position_row, &symmetric);
  return status < 0 ? status : scallop_trajectory(&asymmetric.crawler, 0, 8, 40, position_row, &asymmetric);
}

/* ---- figure 3: one extension from rest ---- */

static bool extension_row(void *context, const struct scallop_sample *s)
{
  struct curve *curve = context;
  double L = curve->crawler.L, T = curve->until;
  if (s->t > T)
    return false;
  const double numbers[] = { s->t / T, s->x1 / L, s->x2 / L, s->v1 * T / L, s->v2 * T / L };
  for (int i = 0; i < 5; i++)
    table_number(curve->table, numbers[i]);
  return true;
}

static enum scallop_status figure_3(struct table *t)
{
  static const char *const columns[] = { "t_over_T", "x1_over_L", "x2_over_L", "v1_T_over_L", "v2_T_over_L", NULL };
  table_note(t, "figure 3: positions (A) and velocities (B) of both bodies in an extension from rest, of duration T");
  table_note(t, "assumed: m1 = m2 = 1, F1 = 4, F2 = 1, L = 10, T = 2, quadratic");
  begin_rows(t, columns);
  struct curve curve = { t, NULL, paper_crawler(4, 4, 0.5), 2 };
  return scallop_trajectory(&curve.crawler, 0, 1, 400, extension_row, &curve);
}

/* ---- figure 4: change of position and velocity over an extension from rest ---- */

/* An extension of duration T is half of a symmetric period 2 T. */
static enum scallop_status extension_from_rest(double F1, double T, struct scallop_crawler *crawler,
                                               struct scallop_phase_result *result)
{
  *crawler = paper_crawler(F1, 2 * T, 0.5);
  return scallop_phase(crawler, SCALLOP_EXTENSION, 0, result);
}

static bool slides(double F1, double T)
{
  struct scallop_crawler c;
  struct scallop_phase_result r;
  return extension_from_rest(F1, T, &c, &r) == SCALLOP_OK && r.regime == SCALLOP_SLIDING;
}

/* The longest extension from rest in which no body sticks. */
static double onset_of_sticking(double F1)
{
  double sliding = 0, sticking = 1;
  while (slides(F1, sticking))
    sticking *= 2;
  for (double mid; (mid = sliding + (sticking - sliding) / 2) > sliding && mid < sticking;)
    *(slides(F1, mid) ? &sliding : &sticking) = mid;
  return sliding;
}

static enum scallop_status figure_4(struct table *t)
{
  static const char *const columns[] = { "F1_over_F2",          "T", "dxC_over_L", "series_dxC_over_L", "dvC_T_over_L",
                                         "series_dvC_T_over_L", NULL };
  static const double ratios[] = { 2, 10, 40 };
  enum { STEPS = 200 };
  table_note(t, "figure 4: change of position (A) and velocity (B) of the centre over an extension from rest of duration T");
  table_note(t, "m1 = m2 = 1, F2 = 1, l(T) = L = 10, quadratic; exact, and the series (21) and (18) of the text");
  for (int i = 0; i < 3; i++)
    table_note(t, "onset of sticking at F1/F2 = %g: T = %.12g", ratios[i], onset_of_sticking(ratios[i]));
  begin_rows(t, columns);
  for (int i = 0; i < 3; i++) {
    double onset = onset_of_sticking(ratios[i]);
    for (int j = 1; j <= STEPS; j++) {
      struct scallop_crawler c;
      double T = onset * j / STEPS;
      struct scallop_phase_result r;
      enum scallop_status status = extension_from_rest(ratios[i], T, &c, &r);
      if (status < 0)
        return status;
      struct scallop_phase_point p = scallop_phase_point(&c, SCALLOP_EXTENSION, 0);
      const double numbers[] = { ratios[i],         T,
                                 r.dxC / c.L,       rest_xC_end(&p) / c.L,
                                 r.v_end * T / c.L, rest_v1_end(&p) * T / c.L };
      for (int k = 0; k < 6; k++)
        table_number(t, numbers[k]);
    }
  }
  return SCALLOP_OK;
}

/* ---- figure 5: mean velocity ---- */

static enum scallop_status velocity_row(struct table *t, const char *panel, const struct scallop_crawler *c)
{
  struct scallop_steady_result r;
  enum scallop_status status = scallop_steady(c, &r);
  if (status < 0)
    return status;
  table_text(t, panel);
  table_number(t, c->alpha);
  table_number(t, c->F2);
  table_number(t, c->F1 / c->F2);
  table_number(t, r.mean_velocity);
  table_number(t, text_steady_xC(c) / c->T);
  table_number(t, r.period.v_start);
  table_text(t, scallop_regime_text(r.period.regime));
  return SCALLOP_OK;
}

static enum scallop_status figure_5(struct table *t)
{
  static const char *const columns[] = { "panel",   "alpha",  "F2", "F1_over_F2", "mean_velocity", "series_mean_velocity",
                                         "v_start", "regime", NULL };
  static const double F1[] = { 2, 4, 10 }, F2[] = { 0.5, 1, 2 };
  enum scallop_status status = SCALLOP_OK;
  table_note(t, "figure 5: mean velocity in the steady state over alpha (A) and over F1/F2 at alpha = 3/4 (B)");
  table_note(t, "m1 = m2 = 1, L = 10, quadratic, F2 = 1 in A; exact, and the series (28) divided by T");
  table_note(t, "assumed: T = 1; F1 = 2, 4, 10 in A; F2 = 1/2, 1, 2 in B");
  begin_rows(t, columns);
  for (int i = 0; i < 3; i++)
    for (int j = 1; j < 100; j++) {
      struct scallop_crawler c = paper_crawler(F1[i], 1, j / 100.0);
      status = status < 0 ? status : velocity_row(t, "A", &c);
    }
  for (int i = 0; i < 3; i++) {
    double ratio = 1;
    for (int j = 0; j <= 349; j++, ratio *= 1.02) { /* up to about 1000 */
      struct scallop_crawler c = paper_crawler(F2[i] * ratio, 1, 0.75);
      c.F2 = F2[i];
      status = status < 0 ? status : velocity_row(t, "B", &c);
    }
  }
  return status;
}

static enum exit_code run(const struct options *options)
{
  static const struct {
    const char *name;
    enum scallop_status (*write)(struct table *);
  } figures[] = { { "2", figure_2 }, { "3", figure_3 }, { "4", figure_4 }, { "5", figure_5 } };
  struct table table;
  for (int i = 0; i < 4; i++)
    if (strcmp(options->operand, figures[i].name) == 0) {
      if (!table_open(&table, options))
        return EXIT_FILE;
      table_note(&table, "scallop " SCALLOP_VERSION);
      table_note(&table, "command: figure %s", figures[i].name);
      enum scallop_status status = figures[i].write(&table);
      if (status < 0) {
        table_abandon(&table);
        complain("figure", "%s", scallop_status_text(status));
        return EXIT_UNSOLVED;
      }
      return table_close(&table) ? EXIT_DONE : EXIT_FILE;
    }
  complain("figure", "there is no table for figure '%s': 2, 3, 4 or 5 (figure 1 is a sketch)", options->operand);
  return EXIT_USAGE;
}

const struct command command_figure = {
  .name = "figure",
  .summary = "the table behind a figure of the paper: 2, 3, 4 or 5",
  .example = "scallop figure 4 -o figure4.tsv",
  .operand = "2|3|4|5",
  .accepts = accepts,
  .about = "2: positions in time from rest, with symmetric and asymmetric kinematics. 3: one extension from rest.\n"
           "4: change of position and velocity over an extension from rest, against its duration up to the onset of\n"
           "sticking, exact and by the series. 5: mean velocity over alpha and over F1/F2. Normalised as in the paper.\n"
           "What a caption leaves out is chosen, and the table's header says so after 'assumed'.",
  .run = run,
};
