#include "compare/answers/points.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/answers/gaits.h"
#include "compare/text/tsv.h"
#include "compare/text/values.h"
#include "compare/text/progress.h"

enum { COLUMN_NAME = 40, MESSAGE = 240 };
_Static_assert(TABLE_COLUMNS >= TSV_CELLS + 128, "a table has room for all that is carried along");

struct reader {
  struct tsv tsv;
  const char *command;
  const char *parameter[TSV_CELLS]; /* of each column; NULL: it is none           */
  int place[TSV_CELLS];             /* of it among the crawler's numbers        */
  int carried[TSV_CELLS];           /* columns that are no parameters             */
  int carries, others;              /* those that are carried along, and all */
  bool quiet, v0_may_be_nan;
  long rows, unsolved;
};

const char *name_among(const char *const *names, const char *name)
{
  while (names && *names && strcmp(*names, name) != 0)
    names++;
  return names ? *names : NULL;
}

static const char *known_parameter(const char *name, const char *const *extra)
{
  const char *own = name_among(crawler_parameters, name);
  return own ? own : name_among(extra, name);
}

/* What other programs call a parameter */
static const struct {
  const char *word, *parameter;
} synonyms[] = { { "period", "T" }, { "stroke", "L" },     { "mass1", "m1" },
                 { "mass2", "m2" }, { "friction1", "F1" }, { "friction2", "F2" } };

/* The letters and digits of a name */
static void squeeze(char plain[COLUMN_NAME], const char *name)
{
  size_t n = 0;
  for (; *name && n + 1 < COLUMN_NAME; name++)
    if (isalnum((unsigned char)*name))
      plain[n++] = *name;
  plain[n] = '\0';
}

/* A word like a longer one (alpha, phase): with the same first letter and few others */
static bool resembles(const char *plain, const char *parameter)
{
  const char *const names[] = { parameter, NULL };
  return strlen(plain) >= 4 && strlen(parameter) >= 5
         && tolower((unsigned char)*plain) == tolower((unsigned char)*parameter) && nearest(plain, names);
}

/* The known parameter that this name, which is none, was probably meant to be, or NULL. Of one letter only what stands
 * around it is judged: `t` is a time. */
static const char *meant(const char *name, const char *const *extra)
{
  char plain[COLUMN_NAME];
  squeeze(plain, name);
  const char *known = known_parameter(plain, extra);
  for (int list = 0; !known && list < 2; list++)
    for (const char *const *p = list == 0 ? crawler_parameters : extra; !known && *p; p++)
      if ((strlen(*p) > 1 && likely(plain, *p)) || resembles(plain, *p))
        known = *p;
  for (size_t i = 0; !known && i < sizeof synonyms / sizeof *synonyms; i++)
    if (likely(plain, synonyms[i].word))
      known = synonyms[i].parameter;
  return known;
}

/* Names with commas between; of many the first ones */
static void add_name(char names[MESSAGE], const char *name, int before)
{
  enum { SHOWN = 4 };
  size_t used = strlen(names);
  if (before < SHOWN)
    snprintf(names + used, MESSAGE - used, "%s%.40s", before ? ", " : "", *name ? name : "''");
  else if (before == SHOWN)
    snprintf(names + used, MESSAGE - used, " and others");
}

/* NULL, or what is wrong with the column */
static const char *read_column(struct reader *r, int i, const char *const *extra)
{
  const char *name = r->tsv.column[i], *parameter = known_parameter(name, extra);
  const char *near = parameter ? NULL : meant(name, extra);
  for (int k = 0; k < i; k++)
    if (parameter && r->parameter[k] == parameter)
      return tsv_at(&r->tsv, "the column '%s' is there twice", parameter);
  if (near)
    return tsv_at(&r->tsv, "unknown column '%.80s'%s", name, did_you_mean(near));
  r->parameter[i] = parameter;
  r->place[i] = parameter ? crawler_place(parameter) : CRAWLER_NUMBERS;
  return NULL;
}

/* Is the name of a column that is no parameter still free in the table? */
static bool is_free(const struct reader *r, const char *name, const struct point_table *of)
{
  bool taken = *name == '\0' || name_among(of->columns, name);
  for (int i = 0; i < r->carries && !taken; i++)
    taken = strcmp(r->tsv.column[r->carried[i]], name) == 0;
  return !taken;
}

/* NULL, or what is wrong with the header */
static const char *read_columns(struct reader *r, const struct point_table *of)
{
  char unused[MESSAGE] = "";
  if (r->tsv.fault)
    return tsv_at(&r->tsv, "%s", r->tsv.fault);
  if (!tsv_take_header(&r->tsv))
    return "out of memory";
  for (int i = 0; i < r->tsv.columns; i++) {
    const char *wrong = read_column(r, i, of->extra);
    if (wrong)
      return wrong;
    r->others += !r->parameter[i];
    if (!r->parameter[i] && is_free(r, r->tsv.column[i], of))
      r->carried[r->carries++] = i;
    else if (!r->parameter[i])
      add_name(unused, r->tsv.column[i], r->others - r->carries - 1);
  }
  if (r->others == r->tsv.columns)
    return tsv_at(&r->tsv, "no column is a parameter: name some of m1 m2 F1 F2 L T alpha gait, separated by tabs");
  if (*unused && !r->quiet)
    complain(r->command, "note: %s",
             tsv_at(&r->tsv, "these columns are not carried along, as their names are taken or empty: %s", unused));
  return NULL;
}

static enum exit_code read_header(struct reader *r, const struct point_table *of)
{
  bool found = tsv_next(&r->tsv);
  const char *wrong = found ? read_columns(r, of) : tsv_error(&r->tsv);
  if (wrong)
    complain(r->command, "%s", wrong);
  else if (!found)
    complain(r->command, "%s: no header line: a TSV file with the names of its columns is wanted", r->tsv.name);
  return found && !wrong ? EXIT_DONE : r->tsv.error ? EXIT_FILE : EXIT_USAGE;
}

/* Returns NULL, or what is wrong with the cell. */
static const char *set_cell(const struct reader *r, struct point *point, int column, const char *cell)
{
  const char *name = column < r->tsv.columns ? r->parameter[column] : NULL;
  bool unset = name && r->v0_may_be_nan && strcmp(name, "v0") == 0 && strcmp(cell, "nan") == 0;
  if (!name || unset)
    return NULL;
  if (r->place[column] < CRAWLER_NUMBERS)
    return point_set_number(point, r->place[column], cell);
  return point_set(point, name, cell);
}

/* Reads the current row into point. Returns NULL, or in status what is wrong with it. */
static const char *read_row(struct reader *r, struct point *point, char *status)
{
  const struct tsv *t = &r->tsv;
  const char *wrong = t->fault;
  int i = 0;
  for (; i < t->count && !wrong; i++)
    wrong = set_cell(r, point, i, t->cell[i]);
  if (!wrong)
    point_complete(point);
  if (!wrong && t->count == t->columns)
    return NULL;
  int used = snprintf(status, POINT_STATUS, "line %ld: ", t->number);
  if (!wrong)
    snprintf(status + used, POINT_STATUS - (size_t)used, "%d columns where the header has %d", t->count, t->columns);
  else
    snprintf(status + used, POINT_STATUS - (size_t)used, "%s%s%s", i > 0 ? r->parameter[i - 1] : "", i > 0 ? ": " : "",
             wrong);
  return status;
}

static void write_number(struct table *t, const struct point_table *of, const char *written, double value)
{
  char text[NUMBER_TEXT];
  if (!of->as_written) {
    table_number(t, value);
    return;
  }
  number_text(text, value, 0); /* --digits is of what is proven */
  table_carried(t, written ? written : text);
}

static void write_parameters(struct table *t, const struct point_table *of, const struct point *p)
{
  double numbers[CRAWLER_NUMBERS];
  crawler_numbers(&p->crawler, numbers);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    write_number(t, of, p->written[i], numbers[i]);
  table_text(t, p->crawler.gait->name);
  for (const char *const *name = of->extra; *name; name++)
    if (strcmp(*name, "phase") == 0)
      table_text(t, p->phase == SCALLOP_EXTENSION ? "extension" : "contraction");
    else
      write_number(t, of, p->written_v0, of->v0_may_be_nan && !p->has_v0 ? NAN : p->v0);
}

/* Of a point that was refused: nan, and - for texts */
static void write_refused(struct table *t, const struct point_table *of)
{
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    table_number(t, NAN);
  table_text(t, "-");
  for (const char *const *name = of->extra; *name; name++)
    if (strcmp(*name, "phase") == 0)
      table_text(t, "-");
    else
      table_number(t, NAN);
}

/* r: of a file, or NULL. Returns whether the point was solved. */
static const char *write_row(struct table *t, const struct point_table *of, const struct reader *r,
                             const struct point *p, const char *refused)
{
  if (refused)
    write_refused(t, of);
  else
    write_parameters(t, of, p);
  for (int i = 0; r && i < r->carries; i++)
    table_carried(t, r->carried[i] < r->tsv.count ? r->tsv.cell[r->carried[i]] : "");
  return of->row(t, p, of->context, refused);
}

/* The bytes that are not read yet, of a regular file; else 0 */
static off_t bytes_left(FILE *in)
{
  struct stat of;
  const off_t read = ftello(in);
  return read >= 0 && fstat(fileno(in), &of) == 0 && S_ISREG(of.st_mode) ? of.st_size - read : 0;
}

static void solve_rows(struct reader *r, struct table *table, const struct request *request,
                       const struct point_table *of)
{
  char status[POINT_STATUS];
  const off_t bytes = bytes_left(r->tsv.file);
  double read = 0;
  while (!table_failed(table) && tsv_next(&r->tsv)) {
    struct point point = request->point;
    const char *wrong = read_row(r, &point, status);
    r->rows++;
    read += (double)(r->tsv.end - r->tsv.begin + 1);
    progress_count(r->rows, lround((double)r->rows * (double)bytes / read)); /* about so many rows: no comments */
    if (write_row(table, of, r, &point, wrong))
      r->unsolved++;
  }
}

static enum exit_code finish(struct table *table, long rows, long unsolved)
{
  if (!table_close(table))
    return EXIT_FILE;
  if (unsolved > 0)
    complain(table->style->command, "%ld of %ld points could not be solved: the column 'status' says why", unsolved,
             rows);
  return unsolved > 0 ? EXIT_UNSOLVED : EXIT_DONE;
}

static bool begin(struct table *table, const struct style *style, const struct point_table *of, const struct reader *r)
{
  const char *carried[TSV_CELLS + 1] = { NULL };
  for (int i = 0; r && i < r->carries; i++)
    carried[i] = r->tsv.column[r->carried[i]];
  if (!table_head(table, style, "%s", style->command))
    return false;
  table_columns(table, crawler_parameters);
  table_columns(table, of->extra);
  table_columns(table, carried);
  table_columns(table, of->columns);
  table_begin_rows(table);
  return true;
}

static enum exit_code one_point(const struct request *request, const struct point_table *of)
{
  struct table table;
  if (!begin(&table, &request->style, of, NULL))
    return EXIT_FILE;
  const char *why = write_row(&table, of, NULL, &request->point, NULL);
  if (!table_close(&table))
    return EXIT_FILE;
  if (why)
    complain(request->style.command, "this point could not be solved: %s", why);
  return why ? EXIT_UNSOLVED : EXIT_DONE;
}

static enum exit_code points_of_sweep(const struct request *request, const struct point_table *of)
{
  const struct sweep_product *product = request->sweep.product;
  long index[SWEEP_GROUPS] = { 0 }, rows = 0, unsolved = 0;
  struct swept swept = { .product = NULL };
  struct table table;
  if (!begin(&table, &request->style, of, NULL))
    return EXIT_FILE;
  do {
    struct point point = request->point;
    sweep_move(&swept, &point, product, index, NULL, NULL);
    progress_count(++rows, sweep_points(&request->sweep));
    unsolved += write_row(&table, of, NULL, &point, swept.why[0] != '\0' ? swept.why : NULL) != NULL;
  } while (sweep_next(product, index) && !table_failed(&table));
  return finish(&table, rows, unsolved);
}

static enum exit_code points_of_file(const struct request *request, const struct point_table *of)
{
  const struct style *style = &request->style;
  struct reader r = { .command = style->command, .quiet = style->quiet, .v0_may_be_nan = of->v0_may_be_nan };
  struct table table;
  enum exit_code code = EXIT_FILE;
  if (!tsv_open(&r.tsv, request->points, TSV_TABS))
    complain(r.command, "%s", tsv_error(&r.tsv));
  else
    code = read_header(&r, of);
  if (code == EXIT_DONE && !begin(&table, style, of, &r))
    code = EXIT_FILE;
  if (code == EXIT_DONE) {
    solve_rows(&r, &table, request, of);
    code = tsv_error(&r.tsv) ? EXIT_FILE : finish(&table, r.rows, r.unsolved);
    if (tsv_error(&r.tsv)) {
      complain(r.command, "%s", tsv_error(&r.tsv));
      table_abandon(&table);
    }
  }
  tsv_close(&r.tsv);
  return code;
}

bool has_many_points(const struct request *request) { return request->points || request->sweep.products > 0; }

enum exit_code for_each_point(const struct request *request, const struct point_table *of)
{
  return (request->points ? points_of_file : request->sweep.products > 0 ? points_of_sweep : one_point)(request, of);
}

void parameters_text(char text[PARAMETERS_TEXT], const struct point *p, const char *const *not_held, bool as_written)
{
  size_t used = 0;
  *text = '\0';
  for (int i = 0; crawler_parameters[i]; i++) {
    const char *name = crawler_parameters[i], *written = as_written && i < CRAWLER_NUMBERS ? p->written[i] : NULL;
    char number[NUMBER_TEXT];
    if (name_among(not_held, name))
      continue;
    if (i < CRAWLER_NUMBERS)
      number_text(number, crawler_parameter(&p->crawler, name), 0);
    used += (size_t)snprintf(text + used, PARAMETERS_TEXT - used, " %s=%s", name,
                             written               ? written
                             : i < CRAWLER_NUMBERS ? number
                                                   : p->crawler.gait->name);
  }
}

void note_parameters(struct table *t, const struct point *p, const char *const *not_held, bool as_written)
{
  char line[PARAMETERS_TEXT];
  parameters_text(line, p, not_held, as_written);
  if (*line)
    table_note(t, "parameters:%s", line);
}

void point_tell_noise(const struct point *p, const struct style *style)
{
  const struct scallop_gait *gait = p->crawler.gait;
  int reversals = strncmp(gait->name, "measured:", 9) == 0 ? gait_reversals(gait) : 0;
  if (reversals > 0 && !style->quiet)
    fprintf(stderr,
            "scallop %s: note: in %.200s l' changes its sign %d times within the phases. If that is noise, smooth the "
            "table: "
            "the spline goes through every point\n",
            style->command, gait->name + 9, reversals);
}
