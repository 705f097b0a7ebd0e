#include "compare/answers/gait_file.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_interp.h>

#include "compare/text/memory.h"
#include "compare/text/tsv.h"
#include "compare/text/values.h"

enum { MOST_ROWS = 100000, LEAST_ROWS = 4 };
static const double closes = 1e-9; /* of the range: how far the last l may be from the first */

static char message[480];

struct row {
  double t, l;
  long line; /* where it stands                                                             */
};
struct rows {
  struct row *at;
  struct gait_row *written;
  char *texts;
  size_t length, texts_room;
  long count;
};

static const char *at_line(const char *file, long line, const char *format, ...)
    __attribute__((format(printf, 3, 4), returns_nonnull));
static const char *at_line(const char *file, long line, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  int length = snprintf(message, sizeof message, line > 0 ? "%.200s:%ld: " : "%.200s: ", file, line);
  vsnprintf(message + length, sizeof message - (size_t)length, format, arguments);
  va_end(arguments);
  return message;
}

static const char *no_memory(void) { return "out of memory"; }

static bool make_room(struct rows *rows)
{
  struct row *at = with_room(rows->at, rows->count, sizeof *at);
  rows->at = at ? at : rows->at;
  struct gait_row *written = with_room(rows->written, rows->count, sizeof *written);
  rows->written = written ? written : rows->written;
  return at && written;
}

/* Keeps a word; *at: where */
static bool keep_word(struct rows *rows, const char *word, size_t *at)
{
  size_t size = strlen(word) + 1;
  if (!rows->texts || rows->length + size > rows->texts_room) {
    size_t room = 2 * (rows->length + size);
    char *more = realloc(rows->texts, room);
    if (!more)
      return false;
    rows->texts = more;
    rows->texts_room = room;
  }
  *at = rows->length;
  memcpy(rows->texts + rows->length, word, size);
  rows->length += size;
  return true;
}

static bool is_header(const struct tsv *t)
{
  return t->count == 2 && strcmp(t->cell[0], "t") == 0 && strcmp(t->cell[1], "l") == 0;
}

/* NULL, or what is wrong with the row */
static const char *read_row(struct rows *rows, const struct tsv *tsv)
{
  const char *file = tsv->name;
  long line = tsv->lines.number;
  double t, l;
  if (tsv->fault)
    return at_line(file, line, "%s", tsv->fault);
  if (tsv->count != 2)
    return at_line(file, line, "%d column%s: two are wanted, t and l", tsv->count, tsv->count == 1 ? "" : "s");
  for (int i = 0; i < 2; i++)
    if (!read_number(tsv->cell[i], i == 0 ? &t : &l))
      return at_line(file, line, "%s = '%.80s' is not allowed: a finite number is wanted", i == 0 ? "t" : "l", tsv->cell[i]);
  if (rows->count == MOST_ROWS)
    return at_line(file, line, "more than %d rows", MOST_ROWS);
  if (rows->count > 0 && !(t > rows->at[rows->count - 1].t))
    return at_line(file, line, "t = %.17g does not come after %.17g of line %ld: t must increase", t,
                   rows->at[rows->count - 1].t, rows->at[rows->count - 1].line);
  if (!make_room(rows) || !keep_word(rows, tsv->cell[0], &rows->written[rows->count].t)
      || !keep_word(rows, tsv->cell[1], &rows->written[rows->count].l))
    return no_memory();
  rows->at[rows->count++] = (struct row){ t, l, line };
  return NULL;
}

static const char *read_rows(struct rows *rows, const char *file, bool *unreadable)
{
  struct tsv tsv;
  const char *wrong = NULL;
  bool first = true;
  if (tsv_open(&tsv, strcmp(file, "-") == 0 ? "./-" : file, TSV_WORDS))
    for (; !wrong && tsv_next(&tsv); first = false)
      if (!first || !is_header(&tsv))
        wrong = read_row(rows, &tsv);
  *unreadable = tsv_error(&tsv) != NULL;
  if (!wrong && tsv_error(&tsv))
    wrong = at_line(file, 0, "cannot be read: %s", lines_error_text(&tsv.lines));
  tsv_close(&tsv);
  return wrong;
}

struct period {
  long least, most;        /* the first row with the smallest l, the first one after it with the largest */
  double T, L, until_most; /* the time between them                                                */
};

/* Of row i, which may be beyond the last: the first rows come again a period later, the last one is the first */
static double length_of(const struct rows *rows, long i) { return rows->at[i % (rows->count - 1)].l; }
static double time_of(const struct rows *rows, const struct period *p, long i)
{
  long n = rows->count - 1;
  return i < n ? rows->at[i].t - rows->at[p->least].t
               : (rows->at[n].t - rows->at[p->least].t) + (rows->at[i - n].t - rows->at[0].t);
}

static const char *look(const struct rows *rows, const char *file, struct period *p)
{
  long n = rows->count - 1, last = rows->count > 0 ? rows->at[n].line : 0;
  if (rows->count < LEAST_ROWS)
    return at_line(file, last,
                   "%ld row%s: at least %d are wanted, three points of the period and the first one again a period later; "
                   "through fewer every curve would be the same",
                   rows->count, rows->count == 1 ? "" : "s", LEAST_ROWS);
  p->least = 0;
  for (long i = 1; i < n; i++)
    if (rows->at[i].l < rows->at[p->least].l)
      p->least = i;
  p->most = p->least;
  for (long i = p->least + 1; i < p->least + n; i++)
    if (length_of(rows, i) > length_of(rows, p->most))
      p->most = i;
  p->L = length_of(rows, p->most) - rows->at[p->least].l;
  p->T = rows->at[n].t - rows->at[0].t;
  p->until_most = time_of(rows, p, p->most);
  if (!(p->L > 0) && rows->at[n].l == rows->at[0].l)
    return at_line(file, last, "l is the same throughout: there is no gait in that");
  if (!(fabs(rows->at[n].l - rows->at[0].l) <= closes * p->L))
    return at_line(
        file, last,
        "not periodic: l = %.17g in the last row, %.17g in the first one, on line %ld: they are wanted to be equal to 1e-9 "
        "of the range",
        rows->at[n].l, rows->at[0].l, rows->at[0].line);
  if (!isfinite(p->L) || !isfinite(p->T))
    return at_line(file, last, "the range of t and that of l must not overflow");
  if (!(p->until_most / p->T > 0 && p->until_most / p->T < 1))
    return at_line(file, last, "the part of the period in which l grows must be between 0 and 1: it is %.17g",
                   p->until_most / p->T);
  return NULL;
}

/* Rows first to last as the knots of a phase. False: two of them are at one time, in units of 2^-53 of the phase: row *bad. */
static bool set_knots(struct scallop_knot *knots, const struct rows *rows, const struct period *p, long first, long last,
                      long *bad)
{
  double begin = time_of(rows, p, first), duration = time_of(rows, p, last) - begin;
  for (long i = first; i <= last; i++) {
    struct scallop_knot *k = &knots[i - first];
    k->time = i == last ? 1 : scallop_knot_round((time_of(rows, p, i) - begin) / duration);
    k->length = scallop_knot_round((length_of(rows, i) - rows->at[p->least].l) / p->L);
    k->slope = 0;
    *bad = i;
    if (i > first && !(k->time > knots[i - first - 1].time))
      return false;
  }
  return true;
}

/* Steffen's slopes. At the ends of a phase, a minimum and a maximum, they are 0; that is what comes out with the points beyond, too: l
 * turns there. So each phase stands alone, between its own first and last point seen in a mirror. */
static bool set_slopes(struct scallop_knot *knots, int count)
{
  int n = count + 2;
  double *x = calloc((size_t)n, sizeof *x), *y = calloc((size_t)n, sizeof *y);
  gsl_interp *spline = gsl_interp_alloc(gsl_interp_steffen, (size_t)n);
  bool made = x && y && spline;
  if (made) {
    for (int i = 0; i < count; i++) {
      x[i + 1] = knots[i].time;
      y[i + 1] = knots[i].length;
    }
    x[0] = -knots[1].time;
    y[0] = knots[1].length;
    x[n - 1] = 2 - knots[count - 2].time;
    y[n - 1] = knots[count - 2].length;
    made = gsl_interp_init(spline, x, y, (size_t)n) == GSL_SUCCESS;
  }
  for (int i = 1; made && i + 1 < count; i++)
    made = gsl_interp_eval_deriv_e(spline, x, y, knots[i].time, NULL, &knots[i].slope) == GSL_SUCCESS;
  if (spline)
    gsl_interp_free(spline);
  free(x);
  free(y);
  return made;
}

static bool make_memory(struct scallop_spline *s, const int count[2])
{
  size_t pieces = (size_t)scallop_spline_pieces(count);
  s->pieces = malloc(pieces * sizeof *s->pieces);
  s->laws = malloc(pieces * sizeof *s->laws);
  return s->pieces && s->laws;
}

static const char *lay_spline(struct gait_file *gait, const struct rows *rows, const struct period *p, const char *file,
                              const char *text)
{
  const long first[2] = { p->least, p->most }, last[2] = { p->most, p->least + rows->count - 1 };
  const int count[2] = { (int)(last[0] - first[0]) + 1, (int)(last[1] - first[1]) + 1 };
  struct scallop_knot *knots = calloc((size_t)count[0] + (size_t)count[1], sizeof *knots);
  const struct scallop_knot *const phases[2] = { knots, knots + count[0] };
  const char *wrong = knots && make_memory(&gait->spline, count) ? NULL : no_memory();
  for (int kind = 0; !wrong && kind < 2; kind++) {
    long bad;
    struct scallop_knot *phase = knots + (kind == 0 ? 0 : count[0]);
    if (!set_knots(phase, rows, p, first[kind], last[kind], &bad))
      wrong = at_line(file, rows->at[bad < rows->count ? bad : bad - rows->count + 1].line,
                      "too near in time to the row before: 1e-16 of a phase");
    else if (!set_slopes(phase, count[kind]))
      wrong = no_memory();
  }
  if (!wrong)
    gait->checksum = checksum_after(CHECKSUM_OF_NOTHING, knots, ((size_t)count[0] + (size_t)count[1]) * sizeof *knots);
  if (!wrong && scallop_make_spline(&gait->spline, text, phases, count) != SCALLOP_OK)
    wrong = at_line(file, 0, "no monotone spline goes through these rows: some differ in l by 1e-16 of the range only");
  free(knots);
  return wrong;
}

const char *gait_file_read(struct gait_file *gait, const char *name, const char *text, bool *unreadable)
{
  struct rows rows = { .count = 0 };
  struct period period = { .least = 0 };
  *gait = (struct gait_file){ .L = 0 };
  const char *wrong = read_rows(&rows, name, unreadable);
  if (!wrong)
    wrong = look(&rows, name, &period);
  if (!wrong && rows.at && rows.count >= LEAST_ROWS) /* as clang's analyzer cannot know */
    wrong = lay_spline(gait, &rows, &period, name, text);
  if (!wrong) {
    gait->L = period.L;
    gait->T = period.T;
    gait->alpha = period.until_most / period.T;
    gait->texts = rows.texts;
    gait->rows = rows.written;
    gait->last = rows.count - 1;
    gait->least = period.least;
    gait->most = period.most;
  } else {
    gait_file_free(gait);
    free(rows.texts);
    free(rows.written);
  }
  free(rows.at);
  return wrong;
}

void gait_file_free(struct gait_file *gait)
{
  free(gait->spline.pieces);
  free(gait->spline.laws);
  free(gait->texts);
  free(gait->rows);
  *gait = (struct gait_file){ .L = 0 };
}
