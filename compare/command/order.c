#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/commands.h"
#include "compare/text/memory.h"
#include "compare/text/tsv.h"
#include "asymptotics/observed/estimate.h"

struct order_options {
  struct request request;
  struct given_number expect, tolerance;
};

static const struct option options_of_order[] = {
  OPTION_NUMBER("expect", "P", "the order that is expected: gives a verdict, and exit code 1 unless it is met",
                "none, and no verdict", order_options, expect, FINITE),
  OPTION_NUMBER("tol", "D", "how far the order may be from --expect", NULL, order_options, tolerance, POSITIVE),
  OPTIONS_OF_DOUBLES,
};
static const struct order_options initial = { .tolerance = { 0.1, false } };
static const char *const series_column[] = { "series", NULL };
static const char *const columns[] = { "h", "err", "pairwise", "use", NULL };
static const char *const summary_columns[] = { "order",    "lo",        "hi",      "points", "state",
                                               "expected", "tolerance", "verdict", NULL };

/* The points whose texts left of h are the same */
struct series {
  char *name; /* these texts                                                                     */
  struct scallop_order_point *points;
  int count;
  struct order_fit fit;
  enum order_verdict verdict;
};

struct list {
  struct series *series;
  int count;
  long rows; /* of all of them                                                                  */
};

enum { NAME = 1024, MOST_SERIES = 4096, MOST_ROWS = 1000000 };

enum column { H, ERR, NOISE, WANTED };
struct layout {
  int place[WANTED]; /* of columns, -1: not there */
  bool values;       /* err holds values          */
  int columns;
};

static void list_clear(struct list *list)
{
  for (int i = 0; i < list->count; i++) {
    free(list->series[i].name);
    free(list->series[i].points);
  }
  free(list->series);
}

/* The series of that name, a new one if there is none; NULL: out of memory, or too many */
static struct series *series_named(struct list *list, const char *name)
{
  for (int i = list->count - 1; i >= 0; i--)
    if (strcmp(list->series[i].name, name) == 0)
      return &list->series[i];
  struct series *all = list->count < MOST_SERIES ? with_room(list->series, list->count, sizeof *all) : NULL;
  if (!all)
    return NULL;
  list->series = all;
  struct series *s = &all[list->count];
  *s = (struct series){ .name = strdup(name) };
  list->count += s->name != NULL;
  return s->name ? s : NULL;
}

static bool append(struct series *s, struct scallop_order_point point)
{
  struct scallop_order_point *points = with_room(s->points, s->count, sizeof point);
  if (!points)
    return false;
  s->points = points;
  s->points[s->count++] = point;
  return true;
}

/* Reads a number; unlike an option's, it may be nan or inf, which the estimator then refuses. */
static bool read_any(const char *text, double *value)
{
  char *end;
  *value = strtod(text, &end);
  return end != text && *end == '\0';
}

/* A header names h and err (or error, or value), and may name noise; without a header the columns are h and err. Takes the first row,
 * and returns NULL or what is wrong with it. */
static const char *read_layout(struct tsv *t, struct layout *layout)
{
  static const char *const names[] = { "h", "err", "noise", "error", "value" };
  static const enum column meant[] = { H, ERR, NOISE, ERR, ERR };
  int found[WANTED] = { 0 };
  double number;
  *layout = (struct layout){ .place = { 0, 1, -1 }, .columns = t->count };
  if (read_any(t->cell[0], &number))
    return t->count == 2 ? NULL : "without a header line there must be two columns, h and err";
  if (!tsv_take_header(t))
    return "out of memory";
  for (int i = 0; i < t->columns; i++)
    for (size_t name = 0; name < sizeof names / sizeof *names; name++)
      if (strcmp(t->column[i], names[name]) == 0) {
        found[meant[name]]++;
        layout->place[meant[name]] = i;
        layout->values |= *names[name] == 'v';
      }
  return found[H] > 1 || found[NOISE] > 1 ? "a column is there twice"
         : found[ERR] > 1                 ? "one column 'err' or 'value' is wanted, not two"
         : found[H] && found[ERR]
             ? NULL
             : "the header must name the columns 'h' and 'err' (or 'value'), separated by blanks or tabs";
}

/* The cells left of h that are no numbers, joined */
static void read_name(char name[NAME], char *const *cells, const struct layout *layout)
{
  size_t used = 0;
  double number;
  *name = '\0';
  for (int i = 0; i < layout->place[H] && used < NAME; i++)
    if (i != layout->place[ERR] && i != layout->place[NOISE] && !read_any(cells[i], &number))
      used += (size_t)snprintf(name + used, NAME - used, "%s%s", used ? "; " : "", cells[i]);
}

/* Takes a row in. Returns NULL, or what is wrong with it. */
static const char *read_row(struct tsv *t, struct list *list, const struct layout *layout)
{
  if (t->count != layout->columns)
    return "the number of columns changes";
  struct scallop_order_point point = { .noise = 0 };
  double *const numbers[WANTED] = { &point.h, &point.err, &point.noise };
  static char message[120];
  for (int i = 0; i < WANTED; i++) {
    const char *text = layout->place[i] < 0 ? NULL : t->cell[layout->place[i]];
    if (text && !read_any(text, numbers[i])) {
      snprintf(message, sizeof message, "column %d: '%.60s' is not a number", layout->place[i] + 1, text);
      return message;
    }
  }
  if (list->rows++ == MOST_ROWS)
    return "more than a million rows";
  char name[NAME];
  read_name(name, t->cell, layout);
  struct series *s = series_named(list, name);
  if (!s)
    return list->count == MOST_SERIES ? "more than 4096 series: rows with the same text left of h are one" : "out of memory";
  return append(s, point) ? NULL : "out of memory";
}

/* Texts that are different in each row name no series: all rows are one. False: out of memory */
static bool join_single_points(struct list *list)
{
  for (int i = 0; i < list->count; i++)
    if (list->series[i].count > 1)
      return true;
  bool joined = true;
  for (int i = 1; i < list->count; i++) {
    joined &= append(&list->series[0], list->series[i].points[0]);
    free(list->series[i].points);
    free(list->series[i].name);
  }
  list->count = list->count > 0;
  return joined;
}

static enum exit_code read_file(const char *file, struct list *list, bool *values)
{
  struct tsv t;
  struct layout layout = { .columns = 0 };
  const char *wrong = NULL;
  if (tsv_open(&t, file, TSV_WORDS))
    while (!wrong && tsv_next(&t)) {
      bool first = layout.columns == 0;
      wrong = t.fault ? t.fault : first ? read_layout(&t, &layout) : NULL;
      if (!wrong && (!first || t.columns == 0))
        wrong = read_row(&t, list, &layout);
    }
  if (!wrong && !join_single_points(list))
    wrong = "out of memory";
  bool failed = tsv_error(&t) != NULL;
  if (wrong || failed)
    complain("order", "%s", wrong ? tsv_at(&t, "%s", wrong) : tsv_error(&t));
  else if (list->count == 0)
    complain("order", "%s: no data: lines of 'h err' are wanted", t.name);
  tsv_close(&t);
  *values = layout.values;
  return failed ? EXIT_FILE : wrong || list->count == 0 ? EXIT_USAGE : EXIT_DONE;
}

static void write_points(struct table *table, const struct list *list)
{
  bool named = list->count > 1;
  table_columns(table, named ? series_column : series_column + 1);
  table_columns(table, columns);
  table_begin_rows(table);
  for (const struct series *s = list->series; s < list->series + list->count; s++)
    for (const struct scallop_order_point *p = s->points; p < s->points + s->count; p++) {
      bool judged = s->fit.state != ORDER_INVALID;
      if (named)
        table_text(table, s->name);
      table_number(table, p->h);
      table_number(table, p->err);
      table_rounded(table, judged ? p->pairwise : NAN, "%.4f");
      table_text(table, judged ? scallop_order_use_text(p->use) : "-");
    }
}

/* In TSV: the series and its order in notes */
static void note_summary(struct table *table, const struct series *s, const struct order_options *o)
{
  table_note(table, "order %.4f, 95 %% interval %.4f to %.4f, from %d points: %s", s->fit.order, s->fit.lo, s->fit.hi,
             s->fit.used, order_state_text(s->fit.state));
  if (o->expect.given)
    table_note(table, "expected %g within %g: %s", o->expect.value, o->tolerance.value, order_verdict_text(s->verdict));
}

static void write_summary_row(struct table *table, const struct series *s, const struct order_options *o)
{
  const double interval[] = { s->fit.order, s->fit.lo, s->fit.hi };
  for (int i = 0; i < 3; i++)
    table_number(table, interval[i]);
  table_rounded(table, s->fit.used, "%.0f");
  table_text(table, order_state_text(s->fit.state));
  table_number(table, o->expect.given ? o->expect.value : NAN);
  table_number(table, o->expect.given ? o->tolerance.value : NAN);
  table_text(table, o->expect.given ? order_verdict_text(s->verdict) : "none asked for");
}

static void write_summary(struct table *table, const struct list *list, const struct order_options *o)
{
  bool named = list->count > 1, json = o->request.style.format != FORMAT_TSV;
  table->count = 0;
  table_columns(table, named ? series_column : series_column + 1);
  table_columns(table, summary_columns);
  for (const struct series *s = list->series; s < list->series + list->count; s++) {
    if (named && json)
      table_text(table, s->name);
    else if (named)
      table_note(table, "series: %s", s->name);
    (json ? write_summary_row : note_summary)(table, s, o);
  }
}

/* Estimates and judges all, and returns the exit code that they give. */
static enum exit_code judge(struct list *list, const struct order_options *o, bool values)
{
  bool passed = true, valid = true;
  for (struct series *s = list->series; s < list->series + list->count; s++) {
    s->fit = values ? order_estimate_values(s->points, &s->count) : order_estimate(s->points, s->count);
    s->verdict = order_judge(&s->fit, o->expect.value, o->tolerance.value);
    passed &= s->verdict == ORDER_PASS;
    valid &= s->fit.state != ORDER_INVALID;
  }
  return o->expect.given ? (passed ? EXIT_DONE : EXIT_CHECK_FAILED) : valid ? EXIT_DONE : EXIT_UNSOLVED;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct order_options *o = options;
  struct list list = { 0 };
  struct table table;
  bool values = false;
  enum exit_code code = read_file(arguments->operands[0], &list, &values);
  if (code == EXIT_DONE && !table_open(&table, &o->request.style))
    code = EXIT_FILE;
  if (code == EXIT_DONE) {
    code = judge(&list, o, values);
    table_note(&table, "scallop " SCALLOP_VERSION);
    table_note(&table, "command: order");
    if (values)
      table_note(&table, "err: differences of successive values, v(h_i) - v(h_i+1), rescaled to C h^p");
    write_points(&table, &list);
    write_summary(&table, &list, o);
    if (!table_close(&table))
      code = EXIT_FILE;
    if (code == EXIT_UNSOLVED)
      complain("order",
               "the table cannot be judged: h must be positive and different in each row, and no number nan or inf");
  }
  list_clear(&list);
  return code;
}

const struct command command_order = {
  .name = "order",
  .summary = "the observed order of a table of h and err, from any code",
  .example = "scallop order errors.txt --expect 2",
  .operand = "FILE",
  .options = options_of_order,
  .size = sizeof(struct order_options),
  .initial = &initial,
  .about =
      "FILE ('-': standard input) has two columns, h and err, separated by blanks or tabs; or a header line that\n"
      "names 'h' and 'err', and perhaps 'noise' (the rounding error of err); or 'h' and 'value', and the order then\n"
      "comes from three successive refinements each (Richardson). Lines that begin with # are passed over.\n"
      "Columns left of h that hold text name a series: rows with the same texts are judged by themselves, so that\n"
      "`scallop claims --errors rest_dT | scallop order -` gives one order for each gait and set of conditions. Texts that\n"
      "are different in each row name nothing.\n"
      "Prints each point with its pairwise order, whether it was used and why not (zero, floor: roundoff,\n"
      "coarse: not yet asymptotic, before-sign-change), then the fitted order with its 95 % interval. With\n"
      "--expect the verdict: pass, too-low, too-high, floor-limited, not-asymptotic, insufficient or invalid; errors\n"
      "that are all 0, or within their noise, pass (state exact). Of several series each has to pass.",
  .run = run,
};
