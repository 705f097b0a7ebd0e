#include "compare/points/point_file.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

enum { COLUMN_NAME = 40, MESSAGE = 240 };

/* A word like a longer one (alpha, phase): with the same first letter and few others */
static bool resembles(const char *plain, const char *parameter)
{
  const char *const names[] = { parameter, NULL };
  return strlen(plain) >= 4 && strlen(parameter) >= 5
         && tolower((unsigned char)*plain) == tolower((unsigned char)*parameter) && nearest(plain, names);
}

/* The parameter that this name, which is none, was probably meant to be by its letters and digits, or NULL. Of one
 * letter only what stands around it is judged: `t` is a time. */
static const char *meant(const char *name, const char *const *parameters)
{
  char plain[COLUMN_NAME];
  size_t n = 0;
  for (; *name && n + 1 < COLUMN_NAME; name++)
    if (isalnum((unsigned char)*name))
      plain[n++] = *name;
  plain[n] = '\0';
  for (const char *const *p = parameters; *p; p++)
    if (strcmp(plain, *p) == 0 || (strlen(*p) > 1 && strcasecmp(plain, *p) == 0) || resembles(plain, *p))
      return *p;
  return NULL;
}

/* Is the name of a column that is no parameter still free in the table? */
static bool is_free(const struct point_file *r, const char *name, const char *const *columns)
{
  const size_t length = strlen(name);
  bool taken = length == 0;
  for (const char *const *own = columns; *own && !taken; own++)
    taken = strncmp(*own, name, length) == 0 && strchr("=", (*own + length)[strspn(*own + length, " ")]);
  for (int i = 0; i < r->carries && !taken; i++)
    taken = strcmp(r->carried[i], name) == 0;
  return !taken;
}

/* NULL, or what is wrong with the column */
static const char *read_column(struct point_file *r, int i, const char *const *parameters)
{
  const char *name = r->tsv.column[i], *parameter = r->parameter[i] = name_among(parameters, name);
  const char *near = parameter ? NULL : meant(name, parameters);
  r->place[i] = parameter ? crawler_place(parameter) : CRAWLER_NUMBERS;
  for (int k = 0; k < i; k++)
    if (parameter && r->parameter[k] == parameter)
      return tsv_at(&r->tsv, "the column '%s' is there twice", parameter);
  return near ? tsv_at(&r->tsv, "unknown column '%.80s'%s", name, did_you_mean(near)) : NULL;
}

/* NULL, or what is wrong with the header. What is neither a parameter nor carried along goes into a note. */
static const char *read_columns(struct point_file *r, bool quiet, const char *const *parameters,
                                const char *const *columns)
{
  const char *unused[TSV_CELLS + 1] = { NULL };
  char names[MESSAGE];
  int others = 0, not_carried = 0;
  if (r->tsv.fault)
    return tsv_at(&r->tsv, "%s", r->tsv.fault);
  if (!tsv_take_header(&r->tsv))
    return "out of memory";
  for (int i = 0; i < r->tsv.columns; i++) {
    const char *name = r->tsv.column[i], *wrong = read_column(r, i, parameters);
    if (wrong)
      return wrong;
    others += !r->parameter[i];
    if (!r->parameter[i] && is_free(r, name, columns)) {
      r->carried[r->carries] = name;
      r->column[r->carries++] = i;
    } else if (!r->parameter[i])
      unused[not_carried++] = *name ? name : "''";
  }
  if (others == r->tsv.columns)
    return tsv_at(&r->tsv, "no column is a parameter: name some of m1 m2 F1 F2 L T alpha gait, separated by tabs");
  if (not_carried > 0 && !quiet)
    complain(r->command, "note: %s",
             tsv_at(&r->tsv, "these columns are not carried along, as their names are taken or empty: %s",
                    joined(names, sizeof names, unused, ", ")));
  return NULL;
}

/* Returns NULL, or what is wrong with the cell. */
static const char *set_cell(const struct point_file *r, struct point *point, int column, const char *cell)
{
  const char *name = column < r->tsv.columns ? r->parameter[column] : NULL;
  bool unset = name && r->v0_may_be_nan && strcmp(name, "v0") == 0 && strcmp(cell, "nan") == 0;
  if (!name || unset)
    return NULL;
  if (r->place[column] < CRAWLER_NUMBERS)
    return point_set_number(point, r->place[column], cell);
  return point_set(point, name, cell);
}

/* Reads the current row into point. False: status says what is wrong with it. */
static bool read_row(struct point_file *r, struct point *point, char *status)
{
  const struct tsv *t = &r->tsv;
  const char *wrong = t->fault;
  int i = 0;
  for (; i < t->count && !wrong; i++)
    wrong = set_cell(r, point, i, t->cell[i]);
  if (!wrong)
    point_complete(point);
  if (!wrong && t->count == t->columns)
    return true;
  int used = snprintf(status, POINT_STATUS, "line %ld: ", t->number);
  if (!wrong)
    snprintf(status + used, POINT_STATUS - (size_t)used, "%d columns where the header has %d", t->count, t->columns);
  else
    snprintf(status + used, POINT_STATUS - (size_t)used, "%s%s%s", i > 0 ? r->parameter[i - 1] : "", i > 0 ? ": " : "",
             wrong);
  return false;
}

/* The bytes that are not read yet, of a regular file; else 0 */
static double bytes_left(FILE *in)
{
  struct stat of;
  const off_t read = ftello(in);
  return read >= 0 && fstat(fileno(in), &of) == 0 && S_ISREG(of.st_mode) ? (double)(of.st_size - read) : 0;
}

enum exit_code point_file_open(struct point_file *r, const char *name, const char *command, bool quiet,
                               const char *const *extra, const char *const *columns)
{
  const char *parameters[CRAWLER_NUMBERS + 8];
  int count = 0;
  for (const char *const *own = crawler_parameters; *own; own++)
    parameters[count++] = *own;
  while (*extra && count < CRAWLER_NUMBERS + 7)
    parameters[count++] = *extra++;
  parameters[count] = NULL;
  r->command = command;
  if (!tsv_open(&r->tsv, name, TSV_TABS)) {
    complain(command, "%s", tsv_error(&r->tsv));
    return EXIT_FILE;
  }
  bool found = tsv_next(&r->tsv);
  const char *wrong = found ? read_columns(r, quiet, parameters, columns) : tsv_error(&r->tsv);
  if (wrong)
    complain(command, "%s", wrong);
  else if (!found)
    complain(command, "%s: no header line: a TSV file with the names of its columns is wanted", r->tsv.name);
  else
    r->bytes = bytes_left(r->tsv.file);
  return found && !wrong ? EXIT_DONE : r->tsv.error ? EXIT_FILE : EXIT_USAGE;
}

void point_file_close(struct point_file *r) { tsv_close(&r->tsv); }

bool point_file_next(struct point_file *r, struct sweep_place *place, const struct point *base)
{
  const struct tsv *t = &r->tsv;
  sweep_place_set(place, base);
  if (!tsv_next(&r->tsv))
    return false;
  place->is_unread = !read_row(r, &place->point, place->why);
  for (int i = 0; i < r->carries; i++)
    r->cell[i] = r->column[i] < t->count ? t->cell[r->column[i]] : "";
  place->carried = r->cell;
  r->read += (double)(t->length + 1);
  return true;
}

long point_file_rows(const struct point_file *r, long read)
{
  return lround((double)read * r->bytes / r->read); /* no comments */
}
