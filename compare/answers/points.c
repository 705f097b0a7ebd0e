#include "compare/answers/points.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/points/gaits.h"
#include "compare/answers/sheet.h"
#include "compare/columns/columns.h"
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
  bool taken = *name == '\0';
  for (const char *const *own = of->columns; *own && !taken; own++) {
    int length;
    column_formula(*own, &length);
    taken = (int)strlen(name) == length && strncmp(*own, name, (size_t)length) == 0;
  }
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

/* A table of points that is being made */
struct making {
  const struct request *request;
  const struct point_table *of;
  struct reader *reader; /* of a file, or NULL */
  struct style style;
  struct table table;
  struct at *at; /* of a sheet, or NULL */
  long rows, unsolved;
  const char *why; /* the last point was not solved, or NULL */
};

static void write_row(struct making *m, const struct point *p, const char *refused)
{
  const struct reader *r = m->reader;
  const char *cells[TSV_CELLS];
  for (int i = 0; r && i < r->carries; i++)
    cells[i] = r->carried[i] < r->tsv.count ? r->tsv.cell[r->carried[i]] : "";
  if (m->at) {
    at_move(m->at, p, refused);
    m->at->carried = cells;
    sheet_row(m->of->sheet, &m->table, m->at);
    m->why = m->at->why[0] != '\0' ? m->at->why : NULL;
  } else {
    if (refused)
      write_refused(&m->table, m->of);
    else
      write_parameters(&m->table, m->of, p);
    for (int i = 0; r && i < r->carries; i++)
      table_carried(&m->table, cells[i]);
    m->why = m->of->row(&m->table, p, m->of->context, refused);
  }
  m->rows++;
  m->unsolved += m->why != NULL;
}

/* The bytes that are not read yet, of a regular file; else 0 */
static off_t bytes_left(FILE *in)
{
  struct stat of;
  const off_t read = ftello(in);
  return read >= 0 && fstat(fileno(in), &of) == 0 && S_ISREG(of.st_mode) ? of.st_size - read : 0;
}

static void rows_of_file(struct making *m)
{
  char status[POINT_STATUS];
  struct reader *r = m->reader;
  const off_t bytes = bytes_left(r->tsv.file);
  double read = 0;
  while (!table_failed(&m->table) && tsv_next(&r->tsv)) {
    struct point point = m->request->point;
    const char *wrong = read_row(r, &point, status);
    read += (double)(r->tsv.length + 1);
    /* about so many rows: no comments */
    progress_count(m->rows + 1, lround((double)(m->rows + 1) * (double)bytes / read));
    write_row(m, &point, wrong);
  }
}

static void rows_of_sweep(struct making *m)
{
  const struct sweep *sweep = &m->request->sweep;
  long index[SWEEP_GROUPS] = { 0 };
  struct swept swept = { .product = NULL };
  do {
    struct point point = m->request->point;
    sweep_move(&swept, &point, sweep->product, index, NULL, NULL);
    progress_count(m->rows + 1, sweep_points(sweep));
    write_row(m, &point, swept.why[0] != '\0' ? swept.why : NULL);
  } while (sweep_next(sweep->product, index) && !table_failed(&m->table));
}

/* The columns of the sheet: those that are chosen, or the parameters, what is carried along and the sheet's own */
static const char *add_columns(struct sheet *s, const struct making *m, const char *const *carried)
{
  const struct table_choice *choice = m->request->style.choice;
  const char *const *const lists[] = { crawler_parameters, m->of->extra, carried, m->of->columns };
  const char *wrong = NULL;
  for (int i = 0; choice && i < choice->count && !wrong; i++)
    wrong = sheet_add(s, choice->names[i]);
  for (int k = 0; !choice && k < 4; k++)
    for (const char *const *name = lists[k]; *name && !wrong; name++)
      wrong = sheet_add(s, *name);
  return wrong;
}

static enum exit_code begin_sheet(struct making *m, const char *const *carried)
{
  struct sheet *s = m->of->sheet;
  s->asked->quantities.carries = m->reader ? m->reader->carries : 0;
  s->asked->quantities.carried = carried;
  const char *wrong = add_columns(s, m, carried);
  if (wrong) {
    complain(m->style.command, "--columns: %s", wrong);
    return EXIT_USAGE;
  }
  m->style.choice = NULL;
  m->at = malloc(sizeof *m->at);
  if (!m->at || !at_init(m->at, s->asked)) {
    complain(m->style.command, "out of memory");
    return EXIT_UNSOLVED;
  }
  return EXIT_DONE;
}

static enum exit_code begin(struct making *m, const char *const *carried)
{
  enum exit_code code = m->of->sheet ? begin_sheet(m, carried) : EXIT_DONE;
  if (code != EXIT_DONE || !table_head(&m->table, &m->style, "%s", m->style.command))
    return code != EXIT_DONE ? code : EXIT_FILE;
  if (m->of->sheet)
    sheet_head(m->of->sheet, &m->table);
  else {
    table_columns(&m->table, crawler_parameters);
    table_columns(&m->table, m->of->extra);
    table_columns(&m->table, carried);
    table_columns(&m->table, m->of->columns);
  }
  table_begin_rows(&m->table);
  return EXIT_DONE;
}

static enum exit_code finish(struct making *m)
{
  const char *command = m->style.command;
  if (m->reader && tsv_error(&m->reader->tsv)) {
    complain(command, "%s", tsv_error(&m->reader->tsv));
    table_abandon(&m->table);
    return EXIT_FILE;
  }
  if (!table_close(&m->table))
    return EXIT_FILE;
  if (m->unsolved > 0 && has_many_points(m->request))
    complain(command, "%ld of %ld points could not be solved: the column 'status' says why", m->unsolved, m->rows);
  else if (m->unsolved > 0)
    complain(command, "this point could not be solved: %s", m->why);
  return m->unsolved > 0 ? EXIT_UNSOLVED : EXIT_DONE;
}

static enum exit_code make(struct making *m)
{
  const char *carried[TSV_CELLS + 1] = { NULL };
  for (int i = 0; m->reader && i < m->reader->carries; i++)
    carried[i] = m->reader->tsv.column[m->reader->carried[i]];
  enum exit_code code = begin(m, carried);
  if (code == EXIT_DONE) {
    if (m->reader)
      rows_of_file(m);
    else if (m->request->sweep.products > 0)
      rows_of_sweep(m);
    else
      write_row(m, &m->request->point, NULL);
    code = finish(m);
  }
  if (m->at)
    at_clear(m->at);
  free(m->at);
  return code;
}

bool has_many_points(const struct request *request) { return request->points || request->sweep.products > 0; }

enum exit_code for_each_point(const struct request *request, const struct point_table *of)
{
  struct making m = { .request = request, .of = of, .style = request->style };
  struct reader r = { .command = m.style.command, .quiet = m.style.quiet, .v0_may_be_nan = of->v0_may_be_nan };
  if (!request->points)
    return make(&m);
  enum exit_code code = EXIT_FILE;
  m.reader = &r;
  if (!tsv_open(&r.tsv, request->points, TSV_TABS))
    complain(r.command, "%s", tsv_error(&r.tsv));
  else
    code = read_header(&r, of);
  if (code == EXIT_DONE)
    code = make(&m);
  tsv_close(&r.tsv);
  return code;
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
