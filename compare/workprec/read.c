/* The summary of a table that was written before. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/compare.h"
#include "compare/answers/gaits.h"
#include "compare/text/lines.h"
#include "compare/workprec/workprec.h"

enum { MOST_CELLS = 64 };
enum column { METHOD, SETTING, GAIT, PERIOD, QUANTITY, ERROR, TIME, STATUS, COLUMNS };
static const char *const wanted_columns[COLUMNS] = { "method",   "setting", "gait",        "T",
                                                     "quantity", "error",   "time_median", "status" };

struct reading {
  const char *name;
  struct lines lines;
  struct table *table; /* NULL: the file is only looked through, for anything wrong                  */
  int cells, at[COLUMNS];
  struct ways ways; /* of the point that is being read                                            */
  struct trial point;
  long rows;
};

static bool refuse(const struct reading *r, const char *what, const char *cell)
{
  complain("workprec", "%s:%ld: %s '%.60s': `scallop workprec` writes such a table, as TSV", r->name, r->lines.number, what,
           cell);
  return false;
}

static bool read_header(struct reading *r, char **cells, int count)
{
  r->cells = count;
  for (int i = 0; i < COLUMNS; i++) {
    int k = 0;
    while (k < count && strcmp(cells[k], wanted_columns[i]) != 0)
      k++;
    if (k == count)
      return refuse(r, "there is no column", wanted_columns[i]);
    r->at[i] = k;
  }
  if (r->table) {
    table_columns(r->table, summary_columns);
    table_begin_rows(r->table);
  }
  return true;
}

static bool ends_with(const char *text, const char *end)
{
  size_t a = strlen(text), b = strlen(end);
  return a >= b && strcmp(text + a - b, end) == 0;
}

static enum way_kind kind_of(const char *method)
{
  return ends_with(method, ", simulated")                                   ? WAY_SIMULATION
         : ends_with(method, ", root")                                      ? WAY_ROOT
         : strstr(method, ", ")                                             ? WAY_ASIDE
         : strcmp(method, "exact") == 0 || strcmp(method, "certified") == 0 ? WAY_EXACT
                                                                            : WAY_FORMULA;
}

static void end_point(struct reading *r)
{
  if (r->table && r->ways.count > 0)
    summary_write(r->table, &r->ways);
  ways_clear(&r->ways);
}

/* The way of a row: the last one, where this is its other quantity, or a new one; NULL if there are too many. */
static struct way *way_of(struct reading *r, const char *method, const char *setting)
{
  struct way *last = r->ways.count > 0 ? &r->ways.list[r->ways.count - 1] : NULL;
  if (last && strcmp(last->method, method) == 0 && strcmp(last->setting, setting) == 0)
    return last;
  char *name = r->ways.count < MOST_WAYS ? strdup(method) : NULL;
  if (!name)
    return NULL;
  struct way *way = ways_add(&r->ways, &r->point, name, kind_of(method), "%s", setting);
  way->memory = name;
  way->release = free;
  for (int i = 0; i < WAY_QUANTITIES; i++)
    way->error_log10[i] = NAN;
  return way;
}

static bool read_row(struct reading *r, char *const *cells)
{
  const char *cell[COLUMNS];
  for (int i = 0; i < COLUMNS; i++)
    cell[i] = cells[r->at[i]];
  const struct scallop_gait *gait = gait_of_text(cell[GAIT]).gait;
  double T, seconds = NAN, error = way_error_log10(cell[ERROR]);
  bool solved = strcmp(cell[STATUS], "ok") == 0;
  int quantity = 0;
  while (way_quantities[quantity] && strcmp(cell[QUANTITY], way_quantities[quantity]) != 0)
    quantity++;
  if (!gait)
    return refuse(r, "unknown gait", cell[GAIT]);
  if (!read_number(cell[PERIOD], &T) || !(T > 0))
    return refuse(r, "T is not a number > 0:", cell[PERIOD]);
  if (!way_quantities[quantity])
    return refuse(r, "unknown quantity", cell[QUANTITY]);
  if (solved && (!read_number(cell[TIME], &seconds) || !(seconds > 0)))
    return refuse(r, "time_median is not a number > 0:", cell[TIME]);
  if (solved && isnan(error))
    return refuse(r, "error is not a number >= 0:", cell[ERROR]);
  if (strlen(cell[SETTING]) >= WAY_TEXT || strlen(cell[ERROR]) >= WAY_TEXT)
    return refuse(r, "this is too long:", cell[strlen(cell[SETTING]) >= WAY_TEXT ? SETTING : ERROR]);
  if (r->ways.count > 0 && (gait != r->point.crawler.gait || T != r->point.crawler.T))
    end_point(r);
  r->point.crawler.gait = gait;
  r->point.crawler.T = T;
  struct way *way = way_of(r, cell[METHOD], cell[SETTING]);
  if (!way)
    return refuse(r, "one row too many of one gait and T:", cell[METHOD]);
  way->solved = solved;
  way->time.median = seconds;
  way->error_log10[quantity] = error;
  snprintf(way->error[quantity], WAY_TEXT, "%s", cell[ERROR]);
  r->rows++;
  return true;
}

/* A '#' line of the file as a note: other people's bytes are not to make the table unreadable. */
static void pass_on(struct table *table, const char *note)
{
  char *clean = strdup(note);
  for (char *c = clean; c && *c; c++)
    if (*c < 0x20 || *c > 0x7e)
      *c = *c == '\t' ? ' ' : '?';
  if (clean)
    table_note(table, "%s", clean);
  free(clean);
}

static bool read_line(struct reading *r)
{
  char *cells[MOST_CELLS];
  char *line = r->lines.line;
  if (line_fault(&r->lines))
    return refuse(r, line_fault(&r->lines), line);
  if (r->table && strncmp(line, "# parameters: ", 14) == 0)
    pass_on(r->table, line + 2);
  if (line[0] == '#' || line[0] == '\0')
    return true;
  int count = lines_cells(line, cells, MOST_CELLS);
  if (r->cells == 0)
    return read_header(r, cells, count);
  if (count != r->cells)
    return refuse(r, "not as many columns as in the header:", cells[0]);
  return read_row(r, cells);
}

/* Looks through the file, or, with a table, writes its summary there. */
static enum exit_code read_file(const char *name, struct table *table)
{
  struct reading *r = calloc(1, sizeof *r);
  enum exit_code code = r ? EXIT_DONE : EXIT_UNSOLVED;
  if (!r) {
    complain("workprec", "out of memory");
    return code;
  }
  *r = (struct reading){ .name = name, .table = table, .lines = { .file = fopen(name, "r") } };
  while (r->lines.file && code == EXIT_DONE && next_line(&r->lines))
    code = read_line(r) ? EXIT_DONE : EXIT_USAGE;
  if (!r->lines.file || r->lines.error) {
    complain("workprec", "cannot read %s: %s", name, r->lines.file ? lines_error_text(&r->lines) : strerror(errno));
    code = EXIT_FILE;
  } else if (code == EXIT_DONE && r->rows == 0) {
    complain("workprec", "%s: no rows: `scallop workprec` writes such a table, as TSV", name);
    code = EXIT_USAGE;
  }
  end_point(r);
  if (r->lines.file)
    fclose(r->lines.file);
  lines_free(&r->lines);
  free(r);
  return code;
}

int summary_from_file(const struct options *options)
{
  struct table table;
  enum exit_code code = read_file(options->from, NULL); /* before anything is written */
  if (code != EXIT_DONE)
    return code;
  if (!table_open(&table, options))
    return EXIT_FILE;
  table_note(&table, "scallop " SCALLOP_VERSION);
  table_note(&table, "command: workprec --from");
  table_note(&table, "ratios: of median times of one run on one machine");
  code = read_file(options->from, &table);
  if (code != EXIT_DONE)
    table_abandon(&table);
  else if (!table_close(&table))
    code = EXIT_FILE;
  return code;
}
