#include "compare/points/point_file.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

/* Returns true if a name that is not a parameter is probably a misspelling of one. Only letters and digits count; a
 * parameter of one letter must agree in case: `t` is a time; a longer one (alpha, phase) may differ in a few letters
 * other than the first. */
static bool is_misspelling(const char *name, const char *parameter)
{
  const char *const names[] = { parameter, NULL };
  char plain[40];
  size_t n = 0;
  for (; *name && n + 1 < sizeof plain; name++)
    if (isalnum((unsigned char)*name))
      plain[n++] = *name;
  plain[n] = '\0';
  bool is_like = n >= 4 && strlen(parameter) >= 5
                 && tolower((unsigned char)*plain) == tolower((unsigned char)*parameter) && nearest(plain, names);
  return is_like || strcmp(plain, parameter) == 0 || (strlen(parameter) > 1 && strcasecmp(plain, parameter) == 0);
}

/* Returns true if no column of the table has the name. */
static bool is_free(const struct point_file *r, const char *name, const char *const *columns)
{
  const size_t length = strlen(name);
  bool taken = length == 0;
  for (const char *const *own = columns; *own && !taken; own++)
    taken = strncmp(*own, name, length) == 0 && strchr("=", (*own + length)[strspn(*own + length, " ")]);
  return !taken && !name_among(r->carried, name);
}

/* Finds the parameter of column i among the crawler's and extra. Returns NULL or the error. */
static const char *read_column(struct point_file *r, int i, const char *name, const char *const *extra)
{
  for (int k = 0; k < POINT_PARAMETERS; k++) {
    const struct parameter *p = &point_parameters[k];
    if (!name_among(crawler_parameters, p->name) && !name_among(extra, p->name))
      continue;
    if (strcmp(name, p->name) == 0)
      r->parameter[i] = p;
    else if (!name_among(crawler_parameters, name) && !name_among(extra, name) && is_misspelling(name, p->name))
      return tsv_at(&r->tsv, "unknown column '%.80s'%s", name, did_you_mean(p->name));
  }
  for (int k = 0; k < i && r->parameter[i]; k++)
    if (r->parameter[k] == r->parameter[i])
      return tsv_at(&r->tsv, "the column '%s' is there twice", name);
  return NULL;
}

/* Reads the header; prints a note of the columns that are ignored. Returns NULL or the error. */
static const char *read_columns(struct point_file *r, const char *noted_by, const char *const *extra,
                                const char *const *columns)
{
  const char *unused[TSV_CELLS + 1] = { NULL };
  char names[240];
  int others = 0, not_carried = 0;
  if (r->tsv.fault)
    return tsv_at(&r->tsv, "%s", r->tsv.fault);
  for (int i = 0; i < r->tsv.columns; i++) {
    const char *name = r->tsv.column[i], *wrong = read_column(r, i, name, extra);
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
    return tsv_at(&r->tsv, "no column is a parameter: name some of m1 m2 F1 F2 L T alpha gait");
  if (not_carried > 0 && noted_by)
    complain(noted_by, "note: %s",
             tsv_at(&r->tsv, "these columns are not copied to the output, because their names are taken or empty: %s",
                    joined(names, sizeof names, unused, ", ")));
  return NULL;
}

/* Sets the parameter from the cell. Returns NULL or the error. */
static const char *set_cell(const struct point_file *r, struct point *point, const struct parameter *p,
                            const char *cell)
{
  if (!p || (r->v0_may_be_nan && p->target == TARGET_V0 && strcmp(cell, "nan") == 0))
    return NULL;
  return p < point_parameters + POINT_NUMBERS ? point_set_number(point, (int)(p - point_parameters), cell)
                                              : point_set(point, p->name, cell);
}

/* Reads the current row into point. Returns false after writing the error to status. */
static bool read_row(struct point_file *r, struct point *point, char *status)
{
  struct tsv *t = &r->tsv;
  const char *wrong = t->fault, *in = "";
  for (int i = 0; i < t->count && !wrong; i++)
    if ((wrong = set_cell(r, point, r->parameter[i], r->parameter[i] ? tsv_number(t, i) : t->cell[i])))
      in = r->parameter[i]->name;
  wrong = wrong ? wrong : t->fault;
  if (wrong)
    snprintf(status, POINT_STATUS, "line %ld: %s%s%s", t->number, in, *in ? ": " : "", wrong);
  else if (t->count != t->columns)
    snprintf(status, POINT_STATUS, "line %ld: %d columns where the header has %d", t->number, t->count, t->columns);
  if (!wrong)
    point_complete(point);
  return !wrong && t->count == t->columns;
}

/* Returns the unread bytes of a regular file; else 0. */
static double bytes_left(FILE *in)
{
  struct stat of;
  const off_t read = ftello(in);
  return read >= 0 && fstat(fileno(in), &of) == 0 && S_ISREG(of.st_mode) ? (double)(of.st_size - read) : 0;
}

enum exit_code point_file_open(struct point_file *r, const char *name, const char *command, bool quiet,
                               const char *const *extra, const char *const *columns)
{
  const char *wrong = NULL;
  if (tsv_open(&r->tsv, name, TSV_POINTS) && (r->tsv.columns > 0 || r->tsv.fault))
    wrong = read_columns(r, quiet ? NULL : command, extra, columns);
  else if (!(wrong = tsv_error(&r->tsv)))
    wrong = tsv_at_line(&r->tsv, 0, "no header line: the first row must name the columns");
  if (wrong)
    complain(command, "%s", wrong);
  else
    r->bytes = bytes_left(r->tsv.file);
  return !wrong ? EXIT_DONE : r->tsv.error ? EXIT_FILE : EXIT_USAGE;
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

long point_file_count(const char *name)
{
  struct tsv tsv;
  long rows = 0;
  for (bool more = tsv_open(&tsv, name, TSV_POINTS); more && tsv_next(&tsv); rows++)
    continue;
  tsv_close(&tsv);
  return rows;
}

long point_file_rows(const struct point_file *r, long read)
{
  return lround((double)read * r->bytes / r->read); /* ignores comments */
}
