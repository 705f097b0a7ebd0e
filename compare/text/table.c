#include "compare/text/table.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/command/compare.h"
#include "compare/answers/gaits.h"

static const char *where(const struct table *t) { return t->output ? t->output : "standard output"; }

/* The one that has the file, or, when its columns were refused, a place from which nothing is written */
static struct table *base(struct table *t) { return t->into && !t->refused ? t->into : t; }

/* The spline goes through every point of a table, noise and all. */
static void tell_noise(const struct options *o)
{
  const struct scallop_gait *gait = o->crawler.gait;
  int reversals = strncmp(gait->name, "measured:", 9) == 0 ? gait_reversals(gait) : 0;
  if (reversals > 0 && !o->quiet)
    fprintf(
        stderr,
        "scallop %s: note: in %.200s l' changes its sign %d times within the phases. If that is noise, smooth the table: "
        "the spline goes through every point\n",
        o->command->name, gait->name + 9, reversals);
}

bool table_open_at(struct table *t, const struct options *options, const char *output)
{
  *t = (struct table){ .options = options, .output = output };
  int error = file_open(&t->out, output);
  if (error != 0) {
    complain(options->command->name, "cannot write %s: %s", output, strerror(error));
    return false;
  }
  t->file = t->out.stream;
  t->watched = isatty(fileno(t->file));
  return true;
}

static bool go_on_in(struct table *t, const struct options *options, struct table *into)
{
  *t = (struct table){ .file = into->file,
                       .options = options,
                       .output = into->output,
                       .watched = into->watched,
                       .into = into,
                       .is_later = into->is_continued };
  into->is_continued = true;
  return true;
}

bool table_open(struct table *t, const struct options *options)
{
  struct table *into = options->into;
  if (!into || !into->is_continued)
    tell_noise(options);
  return into ? go_on_in(t, options, into) : table_open_at(t, options, options->output);
}

/* The first error is the one to tell of. */
static void note_error(struct table *t, bool failed)
{
  if (failed && t->error == 0)
    t->error = errno;
}

static void flush_text(struct table *t)
{
  if (t->used > 0 && !t->refused)
    note_error(t, fwrite(t->text, 1, t->used, t->file) < t->used);
  t->used = 0;
}

/* Where the next size <= TABLE_TEXT bytes go; what is written there is then counted in t->used. */
static char *room(struct table *t, size_t size)
{
  if (t->used + size > TABLE_TEXT)
    flush_text(t);
  return t->text + t->used;
}

static void put(struct table *table, const char *text, size_t length)
{
  struct table *t = base(table);
  while (length > 0) {
    size_t part = length < TABLE_TEXT ? length : TABLE_TEXT;
    memcpy(room(t, part), text, part);
    t->used += part;
    text += part;
    length -= part;
  }
}

static void put_char(struct table *table, char c)
{
  struct table *t = base(table);
  *room(t, 1) = c;
  t->used++;
}

static void put_text(struct table *t, const char *text) { put(t, text, strlen(text)); }

static void end_line(struct table *t)
{
  put_char(t, '\n');
  if (t->watched)
    flush_text(base(t));
}

/* In JSON there are none. Those before the rows of a later continuation are not said again. */
static bool takes_notes(const struct table *t)
{
  return t->options->format != FORMAT_JSON && !t->refused && (!t->is_later || t->in_rows);
}

void table_note(struct table *t, const char *format, ...)
{
  va_list arguments;
  if (!takes_notes(t))
    return;
  put(t, "# ", 2);
  flush_text(base(t));
  va_start(arguments, format);
  note_error(base(t), vfprintf(t->file, format, arguments) < 0);
  va_end(arguments);
  end_line(t);
}

size_t number_text(char text[NUMBER_TEXT], double x, long digits)
{
  if (digits == 0 || isnan(x))
    return digits_write(text, x);
  return (size_t)snprintf(text, NUMBER_TEXT, "%.*g", (int)digits, x);
}

static void put_number(struct table *table, double x, long digits)
{
  struct table *t = base(table);
  t->used += number_text(room(t, NUMBER_TEXT), x, digits);
}

bool table_varies(const struct table *t, const char *name)
{
  static const char *const derived[][2] = { { "F1", "F1_over_F2" }, { "m1", "m1_over_m2" }, { "T", "froude" } };
  const struct table *first = t->into ? t->into : t;
  for (int i = 0; i < first->leads; i++) {
    if (strcmp(first->lead_names[i], name) == 0)
      return true;
    for (int k = 0; k < 3; k++)
      if (strcmp(derived[k][0], name) == 0 && strcmp(derived[k][1], first->lead_names[i]) == 0)
        return true;
  }
  return false;
}

static bool is_among(const char *name, const char *const *names)
{
  while (names && *names && strcmp(*names, name) != 0)
    names++;
  return names && *names;
}

void table_parameters(struct table *t, const struct options *o, const char *const *not_held, bool as_written)
{
  bool begun = false;
  if (!takes_notes(t))
    return;
  for (int i = 0; crawler_parameters[i]; i++) {
    const char *name = crawler_parameters[i], *written = as_written && i < CRAWLER_NUMBERS ? o->written[i] : NULL;
    if (table_varies(t, name) || is_among(name, not_held))
      continue;
    put_text(t, begun ? " " : "# parameters: ");
    put_text(t, name);
    put_char(t, '=');
    if (written || i == CRAWLER_NUMBERS)
      put_text(t, written ? written : o->crawler.gait->name);
    else
      put_number(t, crawler_parameter(&o->crawler, name), 0);
    begun = true;
  }
  if (begun)
    end_line(t);
}

void table_columns(struct table *t, const char *const *names)
{
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

void table_lead(struct table *t, const char *const *names, int count)
{
  t->lead_names = names;
  t->leads = count;
}

void table_lead_values(struct table *t, const double *numbers, const char *const *texts)
{
  t->lead_numbers = numbers;
  t->lead_texts = texts;
}

/* The names of the columns, each with a tab after it, to be freed; NULL: out of memory */
static char *joined_names(const struct table *t)
{
  size_t length = 1;
  for (int i = 0; i < t->count; i++)
    length += strlen(t->columns[i]) + 1;
  char *names = malloc(length), *end = names;
  for (int i = 0; names && i < t->count; i++)
    end += sprintf(end, "%s\t", t->columns[i]);
  if (names)
    *end = '\0';
  return names;
}

enum { SHOWN_NAME = 80 };

/* The first of joined names, for a message */
static void show_name(char text[SHOWN_NAME], const char *names)
{
  int length = (int)strcspn(names, "\t");
  snprintf(text, SHOWN_NAME, length > 0 ? "'%.*s'" : "missing", length, names);
}

static void complain_of_columns(const struct table *t, const char *names, const char *earlier)
{
  char name[SHOWN_NAME], earlier_name[SHOWN_NAME];
  int column = 1;
  for (size_t length; length = strcspn(names, "\t") + 1, strncmp(names, earlier, length) == 0; column++) {
    names += length;
    earlier += length;
  }
  show_name(name, names);
  show_name(earlier_name, earlier);
  complain(t->options->command->name,
           "cannot write %s: column %d is %s, and %s in the rows before: a table has the same columns throughout", where(t),
           column, name, earlier_name);
}

/* The first continuation of a table says what its columns are, later ones have the same or are refused. True: it is the
 * first. */
static bool sets_columns(struct table *t)
{
  char *names = joined_names(t), *earlier = t->into->names;
  if (names && !earlier) {
    t->into->names = names;
    return true;
  }
  if (names && strcmp(names, earlier) != 0) {
    complain_of_columns(t, names, earlier);
    t->refused = true;
  }
  errno = ENOMEM;
  note_error(t->into, !names);
  free(names);
  return false;
}

static void put_heading(struct table *t, const char *name, bool is_first)
{
  if (!is_first)
    put_char(t, '\t');
  put_text(t, name);
}

void table_begin_rows(struct table *t)
{
  bool has_heading = !t->into || sets_columns(t);
  t->in_rows = true;
  if (!has_heading || t->options->format == FORMAT_JSON)
    return;
  const struct table *lead = base(t);
  for (int i = 0; i < lead->leads; i++)
    put_heading(t, lead->lead_names[i], i == 0);
  for (int i = 0; i < t->count; i++)
    put_heading(t, t->columns[i], lead->leads + i == 0);
  end_line(t);
}

/* What comes before the value of a cell */
static void introduce(struct table *t, const char *name, bool is_first)
{
  if (t->options->format == FORMAT_JSON) {
    put_text(t, is_first ? "{\"" : ", \"");
    put_text(t, name);
    put(t, "\": ", 3);
  } else if (!is_first)
    put_char(t, '\t');
}

static void put_value(struct table *t, double value)
{
  if (t->options->format == FORMAT_JSON && !isfinite(value))
    put_text(t, isnan(value) ? "null" : value > 0 ? "1e999" : "-1e999");
  else
    put_number(t, value, t->options->digits > DBL_DECIMAL_DIG ? 0 : t->options->digits);
}

/* How many characters at the head of text stand for themselves */
static size_t plain_length(const char *text, bool json)
{
  size_t n = 0;
  while (text[n] >= 0x20 && text[n] <= 0x7e && !(json && (text[n] == '"' || text[n] == '\\')))
    n++;
  return n;
}

static void put_string(struct table *t, const char *text)
{
  bool json = t->options->format == FORMAT_JSON;
  if (json)
    put_char(t, '"');
  for (;;) {
    size_t plain = plain_length(text, json);
    put(t, text, plain);
    text += plain;
    if (*text == '\0')
      break;
    unsigned char c = (unsigned char)*text++;
    char quoted[] = { '\\', (char)c };
    if (c < 0x20)
      put_char(t, ' ');
    else if (c > 0x7e) /* somebody's bytes in a message: not to make the table unreadable */
      put_char(t, '?');
    else
      put(t, quoted, 2);
  }
  if (json)
    put_char(t, '"');
}

static void put_lead(struct table *t, const struct table *lead)
{
  for (int i = 0; i < lead->leads; i++) {
    introduce(t, lead->lead_names[i], i == 0);
    if (lead->lead_texts && lead->lead_texts[i])
      put_string(t, lead->lead_texts[i]);
    else
      put_value(t, lead->lead_numbers[i]);
  }
}

static void begin_cell(struct table *t)
{
  const struct table *lead = base(t);
  if (t->at == 0)
    put_lead(t, lead);
  introduce(t, t->columns[t->at], lead->leads + t->at == 0);
}

static void end_cell(struct table *t)
{
  if (++t->at < t->count)
    return;
  if (t->options->format == FORMAT_JSON)
    put_char(t, '}');
  end_line(t);
  t->at = 0;
}

void table_number(struct table *t, double value)
{
  begin_cell(t);
  put_value(t, value);
  end_cell(t);
}

void table_digits(struct table *t, const char *number)
{
  begin_cell(t);
  put_text(t, number);
  end_cell(t);
}

void table_rounded(struct table *t, double value, const char *format)
{
  char text[40];
  snprintf(text, sizeof text, format, value);
  if (text[0] == '-' && text[1 + strspn(text + 1, "0.")] == '\0') /* -0.00 */
    memmove(text, text + 1, strlen(text));
  begin_cell(t);
  if (t->options->format == FORMAT_JSON && !isfinite(value))
    put_text(t, "null");
  else
    put_text(t, isnan(value) ? "nan" : text);
  end_cell(t);
}

void table_text(struct table *t, const char *text)
{
  begin_cell(t);
  put_string(t, text);
  end_cell(t);
}

bool table_failed(const struct table *t) { return t->refused || (t->into ? t->into : t)->error != 0; }

bool table_flush(struct table *t)
{
  flush_text(t);
  int error = file_flush(&t->out);
  t->error = t->error != 0 ? t->error : error;
  return !table_failed(t);
}

bool table_close(struct table *t)
{
  if (t->into)
    return !table_failed(t);
  free(t->names);
  flush_text(t);
  bool lost = t->out.target && gait_is_from(t->output); /* of a gait that a column of points names */
  if (lost)
    complain(t->options->command->name, "%s is the file of a gait and is not replaced: name another file", t->output);
  int error = file_close(&t->out, t->error == 0 && !lost);
  t->error = t->error != 0 ? t->error : error;
  if (t->error != 0)
    complain(t->options->command->name, "cannot write %s: %s", where(t), strerror(t->error));
  return t->error == 0 && !lost;
}

void table_abandon(struct table *t)
{
  if (t->into)
    return;
  free(t->names);
  if (!t->out.target)
    flush_text(t);
  file_close(&t->out, false);
}
