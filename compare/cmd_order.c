#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/compare.h"
#include "compare/lines.h"
#include "compare/order.h"

static const char *const accepts[] = { "expect", "tol", "format", "digits", "output", "quiet", NULL };
static const char *const columns[] = { "h", "err", "pairwise", "use", NULL };
static const char *const summary_columns[] = { "order",    "lo",        "hi",      "points", "state",
                                               "expected", "tolerance", "verdict", NULL };

struct list {
  struct order_point *points;
  int count, room;
};

enum { MESSAGE = 120, MOST_ROWS = 1000000 };

struct layout {
  int h, value, noise, columns;
  bool values;
};

static const char *append(struct list *list, struct order_point point)
{
  if (list->count == MOST_ROWS)
    return "more than a million rows";
  if (list->count == list->room) {
    int room = list->room ? 2 * list->room : 64;
    struct order_point *grown = realloc(list->points, (size_t)room * sizeof *grown);
    if (!grown)
      return "out of memory";
    list->points = grown;
    list->room = room;
  }
  list->points[list->count++] = point;
  return NULL;
}

/* Reads a number; unlike an option's, it may be nan or inf, which the estimator then refuses. */
static bool read_any(const char *text, double *value)
{
  char *end;
  *value = strtod(text, &end);
  return end != text && *end == '\0';
}

/* At tabs if there are any, since a cell may then hold blanks; else at blanks. */
static int split(char *line, char **cells, int most)
{
  int n = 0;
  const char *ends = strchr(line, '\t') ? "\t" : " ";
  for (char *cell = strtok(line, ends); cell && n < most; cell = strtok(NULL, ends))
    cells[n++] = cell;
  return n;
}

/* A header names h and err (or value), and may name noise; without a header the columns are h and err. */
static const char *read_layout(char **cells, int count, struct layout *layout, bool *header)
{
  double number;
  *layout = (struct layout){ .h = 0, .value = 1, .noise = -1, .columns = count };
  *header = false;
  if (read_any(cells[0], &number))
    return count == 2 ? NULL : "without a header line there must be two columns, h and err";
  *header = true;
  layout->h = layout->value = -1;
  for (int i = 0; i < count; i++) {
    bool err = strcmp(cells[i], "err") == 0 || strcmp(cells[i], "error") == 0, value = strcmp(cells[i], "value") == 0;
    if ((err || value) && layout->value >= 0)
      return "one column 'err' or 'value' is wanted, not two";
    if (err || value)
      layout->value = i;
    layout->values |= value;
    bool h = strcmp(cells[i], "h") == 0, noise = strcmp(cells[i], "noise") == 0;
    if ((h && layout->h >= 0) || (noise && layout->noise >= 0))
      return "a column is there twice";
    if (h)
      layout->h = i;
    if (noise)
      layout->noise = i;
  }
  return layout->h >= 0 && layout->value >= 0
             ? NULL
             : "the header must name the columns 'h' and 'err' (or 'value'), separated by blanks or tabs";
}

/* Takes a line in. Returns NULL, or what is wrong with it, for which message has room. */
static const char *read_line(char *line, struct list *list, struct layout *layout, bool *started, char message[MESSAGE])
{
  enum { MOST = 64 };
  char *cells[MOST];
  bool header = false;
  int count = split(line, cells, MOST);
  if (count == 0 || cells[0][0] == '#')
    return NULL;
  if (!*started) {
    const char *wrong = read_layout(cells, count, layout, &header);
    *started = true;
    if (wrong || header)
      return wrong;
  }
  if (count != layout->columns)
    return "the number of columns changes";
  struct order_point point = { .noise = 0 };
  const struct {
    int column;
    double *value;
  } wanted[] = { { layout->h, &point.h }, { layout->value, &point.err }, { layout->noise, &point.noise } };
  for (int i = 0; i < 3; i++)
    if (wanted[i].column >= 0 && !read_any(cells[wanted[i].column], wanted[i].value)) {
      snprintf(message, MESSAGE, "column %d: '%.60s' is not a number", wanted[i].column + 1, cells[wanted[i].column]);
      return message;
    }
  return append(list, point);
}

static enum exit_code read_file(const struct options *options, struct list *list, bool *values)
{
  bool standard = strcmp(options->operand, "-") == 0, started = false;
  const char *name = standard ? "standard input" : options->operand, *wrong = NULL;
  struct lines lines = { .file = standard ? stdin : fopen(name, "r") };
  struct layout layout = { .values = false };
  char message[MESSAGE];
  if (!lines.file) {
    complain("order", "cannot read %s: %s", name, strerror(errno));
    return EXIT_FILE;
  }
  while (!wrong && next_line(&lines))
    wrong = line_fault(&lines) ? line_fault(&lines) : read_line(lines.line, list, &layout, &started, message);
  bool failed = lines.error != 0;
  if (wrong)
    complain("order", "%s:%ld: %s", name, lines.number, wrong);
  else if (failed)
    complain("order", "cannot read %s: %s", name, strerror(lines.error));
  else if (list->count == 0)
    complain("order", "%s: no data: lines of 'h err' are wanted", name);
  lines_free(&lines);
  if (!standard)
    fclose(lines.file);
  *values = layout.values;
  return failed ? EXIT_FILE : wrong || list->count == 0 ? EXIT_USAGE : EXIT_DONE;
}

static void write_points(struct table *table, const struct list *list, const struct order_fit *fit)
{
  table_columns(table, columns);
  table_begin_rows(table);
  for (int i = 0; i < list->count; i++) {
    const struct order_point *p = &list->points[i];
    table_number(table, p->h);
    table_number(table, p->err);
    table_rounded(table, fit->state == ORDER_INVALID ? NAN : p->pairwise, "%.4f");
    table_text(table, fit->state == ORDER_INVALID ? "-" : order_use_text(p->use));
  }
}

static void write_summary(struct table *table, const struct order_fit *fit, const struct options *o, const char *verdict)
{
  if (o->format == FORMAT_TSV) {
    table_note(table, "order %.4f, 95 %% interval %.4f to %.4f, from %d points: %s", fit->order, fit->lo, fit->hi, fit->used,
               order_state_text(fit->state));
    if (o->has_expect)
      table_note(table, "expected %g within %g: %s", o->expect, o->tolerance, verdict);
    return;
  }
  table->count = 0;
  table_columns(table, summary_columns);
  table_number(table, fit->order);
  table_number(table, fit->lo);
  table_number(table, fit->hi);
  table_rounded(table, fit->used, "%.0f");
  table_text(table, order_state_text(fit->state));
  table_number(table, o->has_expect ? o->expect : NAN);
  table_number(table, o->has_expect ? o->tolerance : NAN);
  table_text(table, verdict);
}

static enum exit_code run(const struct options *options)
{
  struct list list = { 0 };
  struct table table;
  bool values = false;
  enum exit_code code = read_file(options, &list, &values);
  if (code == EXIT_DONE && !table_open(&table, options))
    code = EXIT_FILE;
  if (code != EXIT_DONE) {
    free(list.points);
    return code;
  }
  if (values)
    list.count = order_from_values(list.points, list.count);
  struct order_fit fit = order_estimate(list.points, list.count);
  enum order_verdict verdict = order_judge(&fit, options->expect, options->tolerance);
  table_note(&table, "scallop " SCALLOP_VERSION);
  table_note(&table, "command: order");
  if (values)
    table_note(&table, "err: differences of successive values, v(h_i) - v(h_i+1), rescaled to C h^p");
  write_points(&table, &list, &fit);
  write_summary(&table, &fit, options, options->has_expect ? order_verdict_text(verdict) : "none asked for");
  free(list.points);
  if (!table_close(&table))
    return EXIT_FILE;
  if (fit.state == ORDER_INVALID && !options->has_expect) {
    complain("order", "the table cannot be judged: h must be positive and different in each row, and no number nan or inf");
    return EXIT_UNSOLVED;
  }
  return options->has_expect && verdict != ORDER_PASS ? EXIT_CHECK_FAILED : EXIT_DONE;
}

static const struct unless_given unless_given[] = {
  { "expect", "none, and no verdict" },
  { NULL, NULL },
};

const struct command command_order = {
  .name = "order",
  .summary = "the observed order of a table of h and err, from any code",
  .example = "scallop order errors.txt --expect 2",
  .operand = "FILE",
  .accepts = accepts,
  .about = "FILE ('-': standard input) has two columns, h and err, separated by blanks or tabs; or a header line that\n"
           "names 'h' and 'err', and perhaps 'noise' (the rounding error of err); or 'h' and 'value', and the order then\n"
           "comes from three successive refinements each (Richardson). Lines that begin with # are passed over.\n"
           "Prints each point with its pairwise order, whether it was used and why not (zero, floor: roundoff,\n"
           "coarse: not yet asymptotic, before-sign-change), then the fitted order with its 95 % interval. With\n"
           "--expect the verdict: pass, too-low, too-high, floor-limited, not-asymptotic, insufficient or invalid.",
  .unless_given = unless_given,
  .run = run,
};
