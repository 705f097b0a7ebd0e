#include "compare/answers/points.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/text/lines.h"

enum { COLUMNS = 256, COLUMN_NAME = 40, MESSAGE = 240 };

struct reader {
  struct lines lines;
  const char *command, *name;     /* the latter of the file, for messages                                       */
  const char *parameter[COLUMNS]; /* of each column; NULL: a column to ignore                        */
  int place[COLUMNS];             /* of it among the crawler's numbers                               */
  int columns, unused;
  bool quiet;
  long rows, unsolved;
};

void point_crawler(struct table *table, const struct scallop_crawler *crawler, const char *refused)
{
  double numbers[CRAWLER_NUMBERS];
  crawler_numbers(crawler, numbers);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    table_number(table, refused ? NAN : numbers[i]);
  table_text(table, refused ? "-" : crawler->gait->name);
}

void point_parameters(struct table *table, const struct options *point, const char *refused)
{
  point_crawler(table, &point->point.crawler, refused);
}

void point_blank(struct table *table, int count)
{
  while (count-- > 0)
    table_number(table, NAN);
}

/* The next line that is no comment and not empty. */
static bool next_data(struct lines *lines)
{
  while (next_line(lines))
    if (lines->length > 0 && lines->line[0] != '#')
      return true;
  return false;
}

static const char *known_parameter(const char *name, const char *const *extra)
{
  for (const char *const *p = crawler_parameters; *p; p++)
    if (strcmp(name, *p) == 0)
      return *p;
  for (; *extra; extra++)
    if (strcmp(name, *extra) == 0)
      return *extra;
  return NULL;
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
  return strlen(plain) >= 4 && strlen(parameter) >= 5 && tolower((unsigned char)*plain) == tolower((unsigned char)*parameter)
         && nearest(plain, names);
}

/* The known parameter that this name, which is none, was probably meant to be, or NULL. Of one letter only what stands around it is
 * judged: `t` is a time. */
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

/* Takes a name out of the blanks and the quotes around it. */
static char *trimmed(char *name)
{
  static const char around[] = " '\"";
  name += strspn(name, around);
  for (size_t n = strlen(name); n > 0 && strchr(around, name[n - 1]);)
    name[--n] = '\0';
  return name;
}

static enum exit_code refuse_header(const struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));
static enum exit_code refuse_header(const struct reader *r, const char *format, ...)
{
  char text[MESSAGE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  complain(r->command, "%s:%ld: %s", r->name, r->lines.number, text);
  return EXIT_USAGE;
}

static bool is_there(const struct reader *r, const char *parameter)
{
  for (int i = 0; i < r->columns; i++)
    if (r->parameter[i] && strcmp(r->parameter[i], parameter) == 0)
      return true;
  return false;
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

static enum exit_code read_column(struct reader *r, const char *name, const char *const *extra)
{
  const char *parameter = known_parameter(name, extra), *near = parameter ? NULL : meant(name, extra);
  if (r->columns == COLUMNS)
    return refuse_header(r, "more than %d columns", COLUMNS);
  if (parameter && is_there(r, parameter))
    return refuse_header(r, "the column '%s' is there twice", parameter);
  if (near)
    return refuse_header(r, "unknown column '%.80s': did you mean '%s'?", name, near);
  if (!parameter)
    r->unused++;
  r->parameter[r->columns] = parameter;
  r->place[r->columns++] = parameter ? crawler_place(parameter) : CRAWLER_NUMBERS;
  return EXIT_DONE;
}

static enum exit_code read_header(struct reader *r, const char *const *extra)
{
  if (!next_data(&r->lines) && r->lines.error) {
    complain(r->command, "cannot read %s: %s", r->name, lines_error_text(&r->lines));
    return EXIT_FILE;
  }
  if (r->lines.length == 0) {
    complain(r->command, "%s: no header line: a TSV file with the names of its columns is wanted", r->name);
    return EXIT_USAGE;
  }
  if (line_fault(&r->lines))
    return refuse_header(r, "%s", line_fault(&r->lines));
  char unused[MESSAGE] = "";
  for (char *cell = r->lines.line; cell;) {
    char *tab = strchr(cell, '\t');
    if (tab)
      *tab = '\0';
    const char *name = trimmed(cell);
    enum exit_code code = read_column(r, name, extra);
    if (code != EXIT_DONE)
      return code;
    if (!r->parameter[r->columns - 1])
      add_name(unused, name, r->unused - 1);
    cell = tab ? tab + 1 : NULL;
  }
  if (r->unused == r->columns)
    return refuse_header(r, "no column is a parameter: name some of m1 m2 F1 F2 L T alpha gait, separated by tabs");
  if (*unused && !r->quiet)
    complain(r->command, "note: %s:%ld: these columns are no parameters and are not used: %s", r->name, r->lines.number,
             unused);
  return EXIT_DONE;
}

/* nan is what `series` writes as v0 where none was given. */
static bool is_unset(const struct options *point, const char *parameter, const char *cell)
{
  return point->command == &command_series && strcmp(parameter, "v0") == 0 && strcmp(cell, "nan") == 0;
}

/* Returns NULL, or what is wrong with the cell. */
static const char *set_cell(const struct reader *r, struct options *point, int column, const char *cell)
{
  if (column >= r->columns || !r->parameter[column] || is_unset(point, r->parameter[column], cell))
    return NULL;
  if (r->place[column] < CRAWLER_NUMBERS)
    return point_set_number(&point->point, r->place[column], cell);
  return point_set(&point->point, r->parameter[column], cell);
}

/* Reads a row into point. Returns NULL, or in status what is wrong with it. */
static const char *read_row(struct reader *r, struct options *point, char *status)
{
  int column = 0;
  if (line_fault(&r->lines)) {
    snprintf(status, POINT_STATUS, "line %ld: %s", r->lines.number, line_fault(&r->lines));
    return status;
  }
  for (char *cell = r->lines.line; cell; column++) {
    char *tab = strchr(cell, '\t');
    if (tab)
      *tab = '\0';
    const char *wrong = set_cell(r, point, column, cell);
    if (wrong) {
      snprintf(status, POINT_STATUS, "line %ld: %s: %s", r->lines.number, r->parameter[column], wrong);
      return status;
    }
    cell = tab ? tab + 1 : NULL;
  }
  point_complete(&point->point);
  if (column == r->columns)
    return NULL;
  snprintf(status, POINT_STATUS, "line %ld: %d columns where the header has %d", r->lines.number, column, r->columns);
  return status;
}

static void solve_rows(struct reader *r, struct table *table, const struct options *options, point_row *row)
{
  char status[POINT_STATUS];
  while (!table_failed(table) && next_data(&r->lines)) {
    struct options point = *options;
    const char *wrong = read_row(r, &point, status);
    r->rows++;
    if (row(table, &point, wrong))
      r->unsolved++;
  }
}

static void set_row(struct point_block *b, long i, const struct scallop_crawler *crawler)
{
  double numbers[CRAWLER_NUMBERS];
  crawler_numbers(crawler, numbers);
  for (int k = 0; k < CRAWLER_NUMBERS; k++)
    b->numbers[k][i] = numbers[k];
  b->gaits[i] = crawler->gait;
}

/* Up to most rows. False: there is nothing after them. */
static bool read_block(struct reader *r, const struct options *options, long most, struct point_block *b)
{
  long n = 0;
  bool more = true;
  while (n < most && (more = next_data(&r->lines))) {
    struct options point = *options;
    bool wrong = read_row(r, &point, b->refused[n]) != NULL;
    if (!wrong)
      b->refused[n][0] = '\0';
    set_row(b, n++, wrong ? &options->point.crawler : &point.point.crawler);
  }
  b->crawlers = (struct scallop_crawlers){ .count = n,
                                           .m1 = b->numbers[0],
                                           .m2 = b->numbers[1],
                                           .F1 = b->numbers[2],
                                           .F2 = b->numbers[3],
                                           .L = b->numbers[4],
                                           .T = b->numbers[5],
                                           .alpha = b->numbers[6],
                                           .gait = b->gaits };
  return more;
}

static void solve_blocks(struct reader *r, struct table *table, const struct options *options, block_rows *rows)
{
  struct point_block block;
  for (bool more = true; more && !table_failed(table);) {
    more = read_block(r, options, table->watched ? 1 : POINT_BLOCK, &block);
    r->rows += block.crawlers.count;
    r->unsolved += rows(table, options, &block);
  }
}

static enum exit_code finish(struct reader *r, struct table *table, const struct options *options)
{
  if (r->lines.error) {
    complain(options->command->name, "cannot read %s: %s", r->name, lines_error_text(&r->lines));
    table_abandon(table);
    return EXIT_FILE;
  }
  if (!table_close(table))
    return EXIT_FILE;
  if (r->unsolved > 0)
    complain(options->command->name, "%ld of %ld points could not be solved: the column 'status' says why", r->unsolved,
             r->rows);
  return r->unsolved > 0 ? EXIT_UNSOLVED : EXIT_DONE;
}

static bool begin(struct table *table, const struct options *options, const char *const *extra, const char *const *columns)
{
  if (!table_open(table, options))
    return false;
  table_note(table, "scallop " SCALLOP_VERSION);
  table_note(table, "command: %s", options->command->name);
  table_columns(table, crawler_parameters);
  table_columns(table, extra);
  table_columns(table, columns);
  table_begin_rows(table);
  return true;
}

static enum exit_code one_point(const struct options *options, const char *const *extra, const char *const *columns,
                                point_row *row)
{
  struct table table;
  if (!begin(&table, options, extra, columns))
    return EXIT_FILE;
  const char *why = row(&table, options, NULL);
  if (!table_close(&table))
    return EXIT_FILE;
  if (why)
    complain(options->command->name, "this point could not be solved: %s", why);
  return why ? EXIT_UNSOLVED : EXIT_DONE;
}

/* Is the file that is read the one that standard output is added to? Then it would never end. */
static bool feeds_itself(const struct reader *r, const struct options *options)
{
  struct stat in, out;
  bool same = !options->output && fstat(fileno(r->lines.file), &in) == 0 && fstat(STDOUT_FILENO, &out) == 0
              && S_ISREG(in.st_mode) && in.st_dev == out.st_dev && in.st_ino == out.st_ino;
  if (same)
    complain(r->command, "standard output goes to %s, which is read at the same time: use -o for another file", r->name);
  return same;
}

/* The points of a file, by row or by rows: one of them is NULL. */
static enum exit_code each(const struct options *options, const char *const *extra, const char *const *columns,
                           point_row *row, block_rows *rows)
{
  bool standard = strcmp(options->points, "-") == 0;
  struct reader r = { .lines = { .file = standard ? stdin : fopen(options->points, "r") },
                      .command = options->command->name,
                      .quiet = options->quiet,
                      .name = standard ? "standard input" : options->points };
  struct table table;
  if (!r.lines.file) {
    complain(options->command->name, "cannot read %s: %s", r.name, strerror(errno));
    return EXIT_FILE;
  }
  enum exit_code code = feeds_itself(&r, options) ? EXIT_USAGE : read_header(&r, extra);
  if (code == EXIT_DONE && !begin(&table, options, extra, columns))
    code = EXIT_FILE;
  if (code == EXIT_DONE) {
    if (row)
      solve_rows(&r, &table, options, row);
    else
      solve_blocks(&r, &table, options, rows);
    code = finish(&r, &table, options);
  }
  if (!standard)
    fclose(r.lines.file);
  lines_free(&r.lines);
  return code;
}

enum exit_code for_each_point(const struct options *options, const char *const *extra, const char *const *columns,
                              point_row *row)
{
  return options->points ? each(options, extra, columns, row, NULL) : one_point(options, extra, columns, row);
}

enum exit_code for_each_block(const struct options *options, const char *const *columns, block_rows *rows)
{
  static const char *const none[] = { NULL };
  return each(options, none, columns, NULL, rows);
}
