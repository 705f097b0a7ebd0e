#include "compare/points.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/lines.h"

enum { COLUMNS = 256 };

struct reader {
  struct lines lines;
  const char *name;               /* of the file, for messages                                       */
  const char *parameter[COLUMNS]; /* of each column; NULL: a column to ignore                        */
  int place[COLUMNS];             /* of it among the crawler's numbers                               */
  int columns;
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
  point_crawler(table, &point->crawler, refused);
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

/* A known parameter that this name, which is none, was probably meant to be; names of one letter are not judged. */
static const char *meant(const char *name, const char *const *extra)
{
  for (int list = 0; list < 2; list++)
    for (const char *const *p = list == 0 ? crawler_parameters : extra; *p; p++)
      if (strlen(*p) > 1 && likely(name, *p))
        return *p;
  return NULL;
}

static enum exit_code read_header(struct reader *r, const char *command, const char *const *extra)
{
  bool useful = false;
  if (!next_data(&r->lines)) {
    if (ferror(r->lines.file)) {
      complain(command, "cannot read %s: %s", r->name, strerror(r->lines.error));
      return EXIT_FILE;
    }
    complain(command, "%s: no header line: a TSV file with the names of its columns is wanted", r->name);
    return EXIT_USAGE;
  }
  if (is_binary(&r->lines)) {
    complain(command, "%s:%ld: this is not a text file", r->name, r->lines.number);
    return EXIT_USAGE;
  }
  for (char *cell = r->lines.line; cell;) {
    char *tab = strchr(cell, '\t');
    if (tab)
      *tab = '\0';
    if (r->columns == COLUMNS) {
      complain(command, "%s:%ld: more than %d columns", r->name, r->lines.number, COLUMNS);
      return EXIT_USAGE;
    }
    const char *parameter = known_parameter(cell, extra);
    for (int i = 0; parameter && i < r->columns; i++)
      if (r->parameter[i] && strcmp(r->parameter[i], parameter) == 0) {
        complain(command, "%s:%ld: the column '%s' is there twice", r->name, r->lines.number, parameter);
        return EXIT_USAGE;
      }
    const char *near = parameter ? NULL : meant(cell, extra);
    if (near) {
      complain(command, "%s:%ld: unknown column '%.80s': did you mean '%s'?", r->name, r->lines.number, cell, near);
      return EXIT_USAGE;
    }
    r->parameter[r->columns] = parameter;
    r->place[r->columns++] = parameter ? crawler_place(parameter) : CRAWLER_NUMBERS;
    useful |= parameter != NULL;
    cell = tab ? tab + 1 : NULL;
  }
  if (!useful) {
    complain(command, "%s:%ld: no column is a parameter: name some of m1 m2 F1 F2 L T alpha gait, separated by tabs",
             r->name, r->lines.number);
    return EXIT_USAGE;
  }
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
    return options_set_crawler_number(point, r->place[column], cell);
  return options_set_parameter(point, r->parameter[column], cell);
}

/* Reads a row into point. Returns NULL, or in status what is wrong with it. */
static const char *read_row(struct reader *r, struct options *point, char *status)
{
  int column = 0;
  if (is_binary(&r->lines)) {
    snprintf(status, POINT_STATUS, "line %ld: not text", r->lines.number);
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
  options_complete(point);
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
    set_row(b, n++, wrong ? &options->crawler : &point.crawler);
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
  if (ferror(r->lines.file)) {
    complain(options->command->name, "cannot read %s: %s", r->name, strerror(r->lines.error));
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

/* The points of a file, by row or by rows: one of them is NULL. */
static enum exit_code each(const struct options *options, const char *const *extra, const char *const *columns,
                           point_row *row, block_rows *rows)
{
  bool standard = strcmp(options->points, "-") == 0;
  struct reader r = { .lines = { .file = standard ? stdin : fopen(options->points, "r") },
                      .name = standard ? "standard input" : options->points };
  struct table table;
  if (!r.lines.file) {
    complain(options->command->name, "cannot read %s: %s", r.name, strerror(errno));
    return EXIT_FILE;
  }
  enum exit_code code = read_header(&r, options->command->name, extra);
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
  free(r.lines.line);
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
