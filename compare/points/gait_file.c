#include "compare/points/gait_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/memory.h"
#include "compare/text/tsv.h"
#include "compare/text/values.h"

enum { MOST_ROWS = 100000, LEAST_ROWS = 4 };
static const double closes = 1e-9; /* of the range: how far the last l may be from the first */
static const char no_memory[] = "out of memory";

static bool is_header(const struct tsv *t)
{
  return t->count == 2 && strcmp(t->cell[0], "t") == 0 && strcmp(t->cell[1], "l") == 0;
}

/* NULL, or what is wrong with the row */
static const char *read_row(struct gait_file *g, struct tsv *tsv)
{
  struct gait_row row = { .line = tsv->number };
  const struct gait_row *before = g->last >= 0 ? &g->rows[g->last] : NULL;
  if (tsv->fault)
    return tsv_at(tsv, "%s", tsv->fault);
  if (tsv->count != 2)
    return tsv_at(tsv, "%d column%s: two are wanted, t and l", tsv->count, tsv->count == 1 ? "" : "s");
  for (int i = 0; i < 2; i++)
    if (!read_number(tsv->cell[i], i == 0 ? &row.t : &row.l))
      return tsv_at(tsv, "%s = '%.80s' is not allowed: a finite number is wanted", i == 0 ? "t" : "l", tsv->cell[i]);
  if (g->last + 1 == MOST_ROWS)
    return tsv_at(tsv, "more than %d rows", MOST_ROWS);
  if (before && !(row.t > before->t))
    return tsv_at(tsv, "t = %.80s does not come after %g of line %ld: t must increase", tsv->cell[0], before->t,
                  before->line);
  struct gait_row *rows = with_room(g->rows, g->last + 1, sizeof *rows);
  if (!rows)
    return no_memory;
  g->rows = rows;
  rows[++g->last] = row;
  return NULL;
}

static const char *read_rows(struct gait_file *g, struct tsv *tsv)
{
  const char *wrong = NULL;
  for (bool first = true; !wrong && tsv_next(tsv); first = false)
    if (!first || !is_header(tsv))
      wrong = read_row(g, tsv);
  return wrong ? wrong : tsv_error(tsv);
}

/* Of row i, which may be beyond the last: the first rows come again a period later, the last one is the first */
static double length_of(const struct gait_file *g, long i) { return g->rows[i % g->last].l; }
static double time_of(const struct gait_file *g, long i)
{
  double least = g->rows[g->least].t;
  return i < g->last ? g->rows[i].t - least : (g->rows[g->last].t - least) + (g->rows[i - g->last].t - g->rows[0].t);
}

/* Finds the period. NULL, or what is wrong with it */
static const char *look(struct gait_file *g, struct tsv *tsv)
{
  long n = g->last;
  if (n + 1 < LEAST_ROWS)
    return tsv_at_line(tsv, n < 0 ? 0 : g->rows[n].line,
                       "%ld row%s: at least %d are wanted, three points of the period and the first one again a period "
                       "later; through fewer every curve would be the same",
                       n + 1, n == 0 ? "" : "s", LEAST_ROWS);
  const struct gait_row *first = &g->rows[0], *last = &g->rows[n];
  for (long i = 1; i < n; i++)
    if (g->rows[i].l < g->rows[g->least].l)
      g->least = i;
  g->most = g->least;
  for (long i = g->least + 1; i < g->least + n; i++)
    if (length_of(g, i) > length_of(g, g->most))
      g->most = i;
  g->L = length_of(g, g->most) - g->rows[g->least].l;
  g->T = last->t - first->t;
  g->alpha = time_of(g, g->most) / g->T;
  if (!(g->L > 0) && last->l == first->l)
    return tsv_at_line(tsv, last->line, "l is the same throughout: there is no gait in that");
  if (!(fabs(last->l - first->l) <= closes * g->L))
    return tsv_at_line(
        tsv, last->line,
        "not periodic: l = %.15g in the last row, %.15g in the first one, on line %ld: they must be equal to "
        "1e-9 of the range",
        last->l, first->l, first->line);
  if (!isfinite(g->L) || !isfinite(g->T))
    return tsv_at_line(tsv, last->line, "the range of t and that of l must not overflow");
  if (!(g->alpha > 0 && g->alpha < 1))
    return tsv_at_line(tsv, last->line, "the part of the period in which l grows must be between 0 and 1: it is %.17g",
                       g->alpha);
  return NULL;
}

/* Rows first to last as the knots of a phase. False: two of them are at one time, in units of 2^-53 of the phase: row
 * *bad. */
static bool set_knots(struct scallop_knot *knots, const struct gait_file *g, long first, long last, long *bad)
{
  double begin = time_of(g, first), duration = time_of(g, last) - begin;
  for (long i = first; i <= last; i++) {
    struct scallop_knot *k = &knots[i - first];
    k->time = i == last ? 1 : scallop_knot_round((time_of(g, i) - begin) / duration);
    k->length = scallop_knot_round((length_of(g, i) - g->rows[g->least].l) / g->L);
    k->slope = 0;
    *bad = i;
    if (i > first && !(k->time > knots[i - first - 1].time))
      return false;
  }
  return true;
}

static double sign(double x) { return x < 0 ? -1 : 1; }

/* Steffen's slopes (Astron. Astrophys. 239, 1990, p. 443). At the ends of a phase, a minimum and a maximum, they are 0,
 * as they are there with the points beyond, too: l turns. So each phase stands alone. */
static void set_slopes(struct scallop_knot *k, int count)
{
  for (int i = 1; i + 1 < count; i++) {
    double before = k[i].time - k[i - 1].time, after = k[i + 1].time - k[i].time;
    double from = (k[i].length - k[i - 1].length) / before, to = (k[i + 1].length - k[i].length) / after;
    double parabola = (from * after + to * before) / (before + after);
    k[i].slope = (sign(from) + sign(to)) * fmin(fabs(from), fmin(fabs(to), 0.5 * fabs(parabola)));
  }
}

static bool make_memory(struct scallop_spline *s, const int count[2])
{
  size_t pieces = (size_t)scallop_spline_pieces(count);
  s->pieces = malloc(pieces * sizeof *s->pieces);
  s->laws = malloc(pieces * sizeof *s->laws);
  return s->pieces && s->laws;
}

static const char *lay_spline(struct gait_file *g, struct tsv *tsv, const char *text)
{
  const long first[2] = { g->least, g->most }, last[2] = { g->most, g->least + g->last };
  const int count[2] = { (int)(last[0] - first[0]) + 1, (int)(last[1] - first[1]) + 1 };
  size_t all = (size_t)count[0] + (size_t)count[1];
  struct scallop_knot *knots = calloc(all, sizeof *knots);
  const struct scallop_knot *const phases[2] = { knots, knots + count[0] };
  const char *wrong = knots && make_memory(&g->spline, count) ? NULL : no_memory;
  for (int kind = 0; !wrong && kind < 2; kind++) {
    long bad;
    struct scallop_knot *phase = knots + (kind == 0 ? 0 : count[0]);
    if (set_knots(phase, g, first[kind], last[kind], &bad))
      set_slopes(phase, count[kind]);
    else
      wrong = tsv_at_line(tsv, g->rows[bad <= g->last ? bad : bad - g->last].line,
                          "too near in time to the row before: 1e-16 of a phase");
  }
  if (!wrong && scallop_make_spline(&g->spline, text, phases, count) != SCALLOP_OK)
    wrong = tsv_at_line(tsv, 0,
                        "no monotone spline goes through these rows: some differ in l by 1e-16 of the range only");
  free(knots);
  return wrong;
}

static struct tsv reader; /* has the message */

/* Of the open table, which is closed. */
static const char *read_table(struct gait_file *gait, bool open, const char *text)
{
  *gait = (struct gait_file){ .last = -1 };
  reader.style = TSV_WORDS;
  const char *wrong = open ? read_rows(gait, &reader) : tsv_error(&reader);
  wrong = wrong ? wrong : look(gait, &reader);
  wrong = wrong ? wrong : lay_spline(gait, &reader, text);
  tsv_close(&reader);
  if (wrong)
    gait_file_free(gait);
  return wrong;
}

const char *gait_file_read(struct gait_file *gait, const char *name, const char *text, bool *unreadable)
{
  const char *wrong = read_table(gait, tsv_open(&reader, strcmp(name, "-") == 0 ? "./-" : name, TSV_WORDS), text);
  *unreadable = reader.error != 0;
  return wrong;
}

const char *gait_file_of_table(struct gait_file *gait, const char *name, const char *table, const char *text)
{
  return read_table(gait, tsv_open_text(&reader, name, table), text);
}

void gait_file_free(struct gait_file *gait)
{
  free(gait->spline.pieces);
  free(gait->spline.laws);
  free(gait->rows);
  *gait = (struct gait_file){ .last = -1 };
}
