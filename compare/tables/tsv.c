#include "compare/tables/tsv.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "compare/text/file.h"
#include "compare/tables/json.h"
#include "compare/text/message.h"
#include "compare/tables/npy.h"

static const char too_many[] = "this line has more than 256 columns";

/* Reads a line without its end: LF, CR or CRLF. Because a terminal may send CR alone and then wait, the LF of CRLF ends
 * another, empty line that does not count. Returns false at the end of the file, or after an error. */
static bool read_line(struct tsv *tsv)
{
  const bool after_return = tsv->ended_by_return;
  int c = 0;
  char *to = tsv->buffer, *const stop = to + LONGEST_LINE;
  if (tsv->length == LONGEST_LINE) /* the rest of that line follows */
    tsv->error = EFBIG;
  while (tsv->error == 0 && to < stop && (c = getc_unlocked(tsv->file)) != EOF && c != '\n' && c != '\r')
    *to++ = (char)c;
  if (c == EOF && ferror(tsv->file))
    tsv->error = errno;
  tsv->ended_by_return = c == '\r';
  tsv->length = (size_t)(to - tsv->buffer);
  *to = '\0';
  bool found = tsv->error == 0 && (c != EOF || tsv->length > 0);
  tsv->number += found && !(after_return && c == '\n' && tsv->length == 0);
  return found;
}

static char *trimmed(char *text, const char *around)
{
  text += strspn(text, around);
  for (size_t n = strlen(text); n > 0 && strchr(around, text[n - 1]);)
    text[--n] = '\0';
  return text;
}

/* Returns true if commas are decimal: the line has several words, and each comma is between two digits. */
static bool has_decimal_commas(const char *line)
{
  for (const char *c = line; (c = strchr(c, ',')); c++)
    if (c == line || !isdigit((unsigned char)c[-1]) || !isdigit((unsigned char)c[1]))
      return false;
  return strpbrk(line, " \t") != NULL;
}

static char separator_of(const char *line)
{
  if (strchr(line, '\t'))
    return '\t';
  if (*line == '{')
    return '{';
  const char *found = *line == '|' || strstr(line, " | ") ? strchr(line, '|') : strchr(line, ';');
  found = found || has_decimal_commas(line) ? found : strchr(line, ',');
  return found ? *found : ' ';
}

/* Removes the quotes of a cell that begins with one, in which two quotes mean one. Returns the rest of the line. */
static char *unquote(char *cell)
{
  char *from = cell + 1, *to = cell;
  for (; *from && (*from != '"' || from[1] == '"'); from++)
    from += (*to++ = *from) == '"';
  char *rest = *from ? from + 1 : from;
  *to = '\0';
  return rest;
}

/* Returns the next cell and moves *rest behind it, NULL behind the last cell. */
static char *take_cell(const struct tsv *tsv, char **rest)
{
  const char stop[] = { tsv->separator, tsv->separator == ' ' ? '\t' : '\0', '\0' };
  const bool is_exact = tsv->style == TSV_POINTS && tsv->separator == '\t';
  char *cell = is_exact ? *rest : *rest + strspn(*rest, " "), *end = cell;
  bool is_quoted = *cell == '"' && !is_exact;
  if (is_quoted)
    end = unquote(cell);
  while (*(end += strcspn(end, stop)) == '|' && end > cell && end[-1] == '\\')
    memmove(end - 1, end, strlen(end) + 1);
  *rest = *end ? end + 1 : NULL;
  *end = '\0';
  return is_exact || is_quoted ? cell : trimmed(cell, " ");
}

static void split(struct tsv *tsv, char *line)
{
  const char separator = tsv->separator;
  if (separator == '\t' && tsv->style == TSV_ANY && !strchr(line, '\t')) /* blanks separate the cells of this line */
    tsv->separator = ' ';
  if (tsv->separator == '|') {
    line += *line == '|';
    size_t n = strlen(line);
    if (n > 0 && line[n - 1] == '|' && (n < 2 || line[n - 2] != '\\'))
      line[n - 1] = '\0';
  }
  for (char *rest = line; rest;) {
    const char *at = rest;
    char *cell = take_cell(tsv, &rest);
    if (*cell == '\0' && *at != '"'
        && (tsv->runs || tsv->separator == ' ' || (tsv->style == TSV_ANY && !rest && tsv->count >= tsv->columns)))
      continue;
    if (tsv->count == TSV_CELLS)
      tsv->fault = too_many;
    else
      tsv->cell[tsv->count++] = cell;
  }
  tsv->separator = separator;
}

/* Splits a JSON object. The first one names the columns; others may lack some. Returns NULL or the error. */
static const char *split_object(struct tsv *tsv, char *line)
{
  static char nothing[] = "";
  struct json_member members[TSV_CELLS];
  int count;
  const char *wrong = json_split(line, members, &count, TSV_CELLS);
  const bool is_first = tsv->columns == 0;
  for (int i = 0; i < count && !wrong && is_first; i++)
    tsv->column[tsv->columns++] = members[i].name;
  for (tsv->count = 0; tsv->count < tsv->columns; tsv->count++)
    tsv->cell[tsv->count] = nothing;
  for (int i = 0; i < count && !wrong; i++) {
    int place = word_place(members[i].name, tsv->column);
    if (place < 0)
      return "this object has a member that the first one lacks";
    tsv->cell[place] = members[i].value;
  }
  return wrong;
}

/* Returns true for a line of dashes, as below the names in a Markdown table. */
static bool is_rule(const struct tsv *tsv, const char *line)
{
  return tsv->separator == '|' && strchr(line, '-') && line[strspn(line, "|-+:= ")] == '\0';
}

/* Returns the current line, trimmed; NULL: it is not a row. */
static char *row_of(struct tsv *tsv)
{
  char *line = tsv->buffer;
  if (tsv->number == 1 && strncmp(line, "\xef\xbb\xbf", 3) == 0) /* byte order mark */
    line += 3;
  tsv->fault = strlen(tsv->buffer) < tsv->length ? "this is not a text file"
               : tsv->length == LONGEST_LINE     ? "this line is too long: more than a million characters"
                                                 : NULL;
  if (!tsv->fault && (tsv->style == TSV_ANY || (tsv->separator && tsv->separator != '\t')))
    line = trimmed(line, tsv->separator == '\t' ? " " : " \t");
  if ((*line == '#' || *line == '%') && tsv->columns == 0) {
    free(tsv->comment);
    tsv->comment = strdup(trimmed(line, "#% \t"));
  }
  return *line == '#' || *line == '%' || (*line == '\0' && !tsv->fault) || is_rule(tsv, line) ? NULL : line;
}

static bool next_record(struct tsv *tsv)
{
  tsv->count = 0;
  if (tsv->number == tsv->npy->rows)
    return false;
  tsv->length = tsv->npy->size - 1;
  tsv->count = npy_next(tsv->npy, tsv->buffer, LONGEST_LINE, tsv->cell);
  if (tsv->count < 0)
    return tsv->error = EPIPE, false;
  tsv->number++;
  return true;
}

void tsv_skip(struct tsv *tsv, long rows)
{
  if (!tsv->npy || fseeko(tsv->file, (off_t)rows * (off_t)tsv->npy->size, SEEK_CUR) != 0)
    while (rows-- > 0 && tsv_next(tsv))
      continue;
  else
    tsv->number += rows;
}

bool tsv_next(struct tsv *tsv)
{
  char *line = NULL;
  if (tsv->waits) {
    tsv->waits = false;
    return true;
  }
  if (tsv->next_record)
    return tsv->next_record(tsv);
  while (!line && read_line(tsv))
    line = row_of(tsv);
  if (!line)
    return false;
  tsv->count = 0;
  if (tsv->commas)
    memset(tsv->had_comma, 0, sizeof tsv->had_comma);
  if (!tsv->separator) {
    tsv->separator = separator_of(line);
    if (tsv->separator == ' ' && tsv->style == TSV_POINTS && !strchr(line, ' '))
      tsv->separator = '\t'; /* one column */
    tsv->runs = (tsv->style == TSV_ANY && tsv->separator == '\t' && strstr(line, "\t\t"));
  }
  if (tsv->fault)
    return true;
  if (tsv->separator == '{')
    tsv->fault = split_object(tsv, line);
  else
    split(tsv, line);
  if (tsv->style == TSV_ANY && tsv->columns > 0 && tsv->columns < TSV_CELLS && tsv->count == tsv->columns + 1
      && !tsv->after_first) { /* the index without a name of R, or of pandas between blanks */
    memmove(tsv->column + 1, tsv->column, (size_t)++tsv->columns * sizeof *tsv->column);
    *tsv->column = "";
  }
  tsv->after_first |= tsv->columns > 0;
  return true;
}

/* Returns the name without quotes around it. */
static char *unwrapped(char *name)
{
  const size_t n = strlen(name);
  bool is_quoted = n > 1 && strchr("'\"", *name) && name[n - 1] == *name;
  if (is_quoted)
    name[n - 1] = '\0';
  return name + is_quoted;
}

/* Names the columns by the cells of the current row, or of a comment. */
static void name_columns(struct tsv *tsv)
{
  for (tsv->columns = 0; tsv->columns < tsv->count; tsv->columns++)
    tsv->column[tsv->columns] = unwrapped(trimmed(tsv->cell[tsv->columns], " "));
  for (int i = 0, n = 0; tsv->separator == ' ' && i < tsv->count; i++) /* a cell in brackets is a unit */
    if (i == 0 || !strchr("[(", *tsv->column[i])) {
      tsv->column[n++] = tsv->column[i];
      tsv->columns = n;
    }
  tsv->column[tsv->columns] = NULL;
}

/* Changes "T [s]" and "T (s)" to T, unless another column is T. */
static void remove_units(struct tsv *tsv)
{
  for (int i = 0; i < tsv->columns; i++) {
    char *name = (char *)tsv->column[i], *unit = strpbrk(name, "[(");
    size_t length = unit ? (size_t)(unit - name) : 0;
    bool is_unit = unit > name && strchr("])", name[strlen(name) - 1]);
    while (length > 0 && name[length - 1] == ' ')
      length--;
    for (int k = 0; k < tsv->columns && is_unit; k++)
      is_unit = k == i || strncmp(tsv->column[k], name, length) != 0 || !strchr(" [(", tsv->column[k][length]);
    if (is_unit && length > 0)
      name[length] = '\0';
  }
}

static bool is_number(struct tsv *tsv, int column)
{
  const char *text = tsv_number(tsv, column);
  char *end;
  strtod(text, &end);
  return end != text && *end == '\0';
}

/* Keeps the buffer with the names, and allocates another one. */
static bool keep_names(struct tsv *tsv)
{
  tsv->header = tsv->buffer;
  tsv->buffer = calloc(1, LONGEST_LINE + 1);
  tsv->error = tsv->buffer ? tsv->error : ENOMEM;
  return tsv->buffer != NULL;
}

/* Names the columns by the comment above the first row of data, if it has a word for each cell. */
static void name_by_comment(struct tsv *tsv)
{
  struct tsv of_comment = { .style = TSV_ANY };
  if (!tsv->comment)
    return;
  of_comment.separator = strchr(tsv->comment, tsv->separator) ? tsv->separator : separator_of(tsv->comment);
  split(&of_comment, tsv->comment);
  name_columns(&of_comment);
  for (int i = 0; i < of_comment.columns; i++)
    if (!isalpha((unsigned char)*of_comment.column[i]) || strpbrk(of_comment.column[i], "=:"))
      return;
  if (of_comment.columns != tsv->count || tsv->count < 2)
    return;
  tsv->columns = of_comment.columns;
  memcpy(tsv->column, of_comment.column, sizeof tsv->column);
}

/* Returns true if the current row has names: its first cell is not a number (of points: any cell). Empty cells do not
 * count, because pandas gives the index no name. */
static bool is_of_names(struct tsv *tsv)
{
  int i = 0;
  while (i + 1 < tsv->count && (*tsv->cell[i] == '\0' || (tsv->style == TSV_POINTS && is_number(tsv, i))))
    i++;
  return i < tsv->count && !is_number(tsv, i);
}

/* Opens an array of NumPy; its head names the columns. */
static bool begin_npy(struct tsv *tsv, const char *name, enum tsv_style style, FILE *file)
{
  *tsv = (struct tsv){ .name = name, .style = style, .file = file, .buffer = calloc(1, LONGEST_LINE + 1) };
  if (!tsv->buffer)
    return tsv->error = ENOMEM, false;
  tsv->next_record = next_record;
  tsv->close_npy = npy_close;
  const char *wrong = (tsv->npy = malloc(sizeof *tsv->npy)) ? npy_open(tsv->npy, tsv->file, true) : "out of memory";
  tsv->fault = wrong ? wrong : tsv->npy->columns > TSV_CELLS ? too_many : NULL;
  tsv->waits = tsv->fault != NULL;
  for (int i = 0; !tsv->fault && i < tsv->npy->columns; i++)
    if (tsv->npy->column[i].kind != 'V')
      tsv->column[tsv->columns++] = tsv->npy->column[i].name;
  return true;
}

static bool begin(struct tsv *tsv, const char *name, enum tsv_style style, FILE *file)
{
  *tsv = (struct tsv){ .name = name, .style = style, .file = file, .error = file ? 0 : errno };
  tsv->buffer = file ? calloc(1, LONGEST_LINE + 1) : NULL;
  if (file && !tsv->buffer)
    tsv->error = ENOMEM;
  if (!tsv->buffer || !tsv_next(tsv) || tsv->fault) {
    tsv->waits = tsv->fault != NULL;
    return tsv->error == 0;
  }
  bool names_itself = tsv->columns > 0, has_names = !names_itself && is_of_names(tsv);
  if (has_names)
    name_columns(tsv);
  else if (!names_itself)
    name_by_comment(tsv);
  if (!names_itself)
    remove_units(tsv);
  if ((has_names || names_itself) && !keep_names(tsv))
    return false;
  tsv->waits = !has_names || (style == TSV_ANY && tsv_next(tsv));
  return tsv->error == 0;
}

bool tsv_open(struct tsv *tsv, const char *file, enum tsv_style style)
{
  const char *name = strcmp(file, "-") == 0 ? "standard input" : file;
  FILE *stream = file_read(file);
  const int first = stream ? getc(stream) : EOF;
  if (first == 0x93)
    return begin_npy(tsv, name, style, stream);
  if (first != EOF)
    ungetc(first, stream);
  return begin(tsv, name, style, stream);
}

bool tsv_open_text(struct tsv *tsv, const char *name, const char *text)
{
  const char *some = *text ? text : "\n"; /* fmemopen may refuse size 0 */
  return begin(tsv, name, TSV_ANY, fmemopen((void *)some, strlen(some), "r"));
}

void tsv_close(struct tsv *tsv)
{
  if (tsv->file && tsv->file != stdin)
    fclose(tsv->file);
  if (tsv->npy)
    tsv->close_npy(tsv->npy);
  free(tsv->npy);
  free(tsv->buffer);
  free(tsv->header);
  free(tsv->comment);
  tsv->buffer = tsv->header = tsv->comment = NULL;
}

const char *tsv_error(struct tsv *tsv)
{
  if (!tsv->error)
    return NULL;
  return wrong_text("cannot read %.300s: %s", tsv->name,
                    tsv->error == EFBIG   ? "a line has more than a million characters"
                    : tsv->error == EPIPE ? "it ends before its last row"
                                          : strerror(tsv->error));
}

const char *tsv_number(struct tsv *tsv, int column)
{
  char *cell = tsv->cell[column], *at = cell + strspn(cell, "+-"), *mark = at + strspn(at, "0123456789");
  const bool has_comma = *mark == ',' && tsv->separator != ',', has_point = *mark == '.';
  char *exponent = mark + (has_comma || has_point);
  exponent += strspn(exponent, "0123456789");
  bool has_exponent = *exponent && strchr("dDeE", *exponent);
  const char *end = exponent + has_exponent;
  end += has_exponent && strchr("+-", *end);
  if (*at == '\0' || end[has_exponent ? strspn(end, "0123456789") : 0] != '\0' || at > cell + 1)
    return cell;
  if (has_comma) {
    *mark = '.';
    tsv->had_comma[column] = true;
  }
  if (has_exponent)
    *exponent = 'e';
  tsv->commas |= has_comma;
  tsv->points |= has_point && !tsv->had_comma[column];
  if (tsv->commas && tsv->points)
    tsv->fault = "this table has decimal commas and decimal points";
  return cell;
}

bool tsv_is_missing(const char *cell)
{
  static const char *const missing[] = { "-", "na", "n/a", "null", NULL };
  int i = 0;
  while (*cell && missing[i] && strcasecmp(cell, missing[i]) != 0)
    i++;
  return missing[i] != NULL;
}

const char *tsv_format_text(const struct tsv *tsv, char text[80])
{
  static const char separators[] = "\t,; |{", *const names[] = { "tabs", "commas", "semicolons", "blanks", "|" };
  const char *at = tsv->separator ? strchr(separators, tsv->separator) : NULL;
  if (!at || *at == '{')
    snprintf(text, 80, tsv->npy ? "an array of NumPy" : at ? "JSON" : "no rows");
  else
    snprintf(text, 80, "columns between %s%s", names[at - separators], tsv->commas ? ", decimal commas" : "");
  return text;
}

const char *tsv_at_line(struct tsv *tsv, long line, const char *format, ...)
{
  char text[TSV_MESSAGE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return line > 0 ? wrong_text("%.200s:%ld: %s", tsv->name, line, text) : wrong_text("%.200s: %s", tsv->name, text);
}
