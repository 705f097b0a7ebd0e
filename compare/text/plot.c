#include "compare/text/plot.h"

#include <ctype.h>
#include <errno.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compare/text/file.h"
#include "compare/text/message.h"
#include "compare/text/shipped.h"

extern char **environ;

const char *plot_kind(const char *file)
{
  static const char *const kinds[] = { "svg", "png", "pdf" };
  const char *point = strrchr(file, '.');
  for (int i = 0; point && i < 3; i++)
    if (strcmp(point + 1, kinds[i]) == 0)
      return kinds[i];
  return NULL;
}

/* In double quotes a backslash, 0 and three octal digits are a byte, whatever digit follows; all but the plainest
 * characters are written so. */
static void put_quoted(FILE *to, const char *begin, const char *text)
{
  fprintf(to, "\"%s", begin);
  for (const unsigned char *c = (const unsigned char *)text; *c; c++)
    if (*c < 0x80 && (isalnum(*c) || strchr(" _./:+-=,()", *c)))
      fputc(*c, to);
    else
      fprintf(to, "\\0%03o", *c);
  fputc('"', to);
}

static void put_text(FILE *to, const char *name, const char *text)
{
  fprintf(to, "%s = ", name);
  put_quoted(to, "", text ? text : "");
  fputc('\n', to);
}

/* "./" keeps '<', '|', '-' and whatever else means no file to gnuplot off the first place. */
static void put_path(FILE *to, const char *before, const char *path)
{
  fputs(before, to);
  put_quoted(to, *path == '/' ? "" : "./", path);
  fputc('\n', to);
}

static void put_columns(FILE *to, const char *name, const char *const *columns)
{
  int count = 0;
  fprintf(to, "array %s_columns[%d]\n", name, PLOT_COLUMNS);
  for (; columns[count]; count++) {
    fprintf(to, "%s_columns[%d] = ", name, count + 1);
    put_quoted(to, "", columns[count]);
    fputc('\n', to);
  }
  fprintf(to, "%ss = %d\n", name, count);
}

/* A function of gnuplot that knows the units of the columns that are drawn */
static void put_units(FILE *to, const struct plot *p)
{
  fputs("unit(name) = ", to);
  for (int i = -1; p->meaning && i < PLOT_COLUMNS && (i < 0 || p->y[i]); i++) {
    const char *name = i < 0 ? p->x : p->y[i];
    const struct column_meaning *m = name ? p->meaning(name) : NULL;
    if (!m)
      continue;
    fputs("name eq ", to);
    put_quoted(to, "", name);
    fputs(" ? ", to);
    put_quoted(to, "", m->unit);
    fputs(" : ", to);
  }
  fputs("\"\"\n", to);
}

static void put_range(FILE *to, const char *name, const struct plot_range *range)
{
  fprintf(to, "has_%s_range = %d\n", name, range->is_given);
  if (range->is_given)
    fprintf(to, "low_%s = %.17g\nhigh_%s = %.17g\n", name, range->low, name, range->high);
}

static void put_script(FILE *to, const struct plot *p, const char *picture)
{
  put_path(to, "table = ", p->table);
  put_path(to, "output_file = ", picture);
  put_text(to, "kind", plot_kind(p->file));
  put_text(to, "title", p->title);
  put_text(to, "x_column", p->x);
  put_columns(to, "y", p->y);
  put_columns(to, "by", p->by);
  fprintf(to, "log_x = %d\nlog_y = %d\nwidth = %ld\nheight = %ld\n", p->log_x, p->log_y, p->width, p->height);
  fprintf(to, "abs_y = %d\n", p->magnitudes);
  if (p->limit - p->limit == 0 && p->limit > 0)
    fprintf(to, "limit = %.17g\n", p->limit);
  put_text(to, "over_column", p->over);
  put_range(to, "x", &p->x_range);
  put_range(to, "y", &p->y_range);
  put_units(to, p);
  fputs(shipped_text(shipped_scripts, "common"), to);
  if (p->script)
    put_path(to, "load ", p->script);
  else
    fputs(p->program ? p->program : shipped_text(shipped_scripts, "curves"), to);
  fputs("unset output\n", to);
}

static bool fail(const struct plot *p, const char *command, const char *what, int error)
{
  complain(command, "cannot draw %s: %s%s%s", p->file, what, error != 0 ? ": " : "",
           error != 0 ? file_error(error) : "");
  return false;
}

/* Starts gnuplot with these for input and output, in a locale with UTF-8, which the scripts are in: in another gnuplot
 * complains. Returns an error, or 0. The script was opened first: said is not descriptor 0. */
static int start(pid_t *process, FILE *script, FILE *said)
{
  static char name[] = "gnuplot", plain[] = "-d"; /* without the settings of the user */
  char *const arguments[] = { name, plain, NULL };
  posix_spawn_file_actions_t places;
  if (setenv("LC_ALL", "C.UTF-8", 1) != 0)
    return ENOMEM;
  int error = posix_spawn_file_actions_init(&places);
  if (error != 0)
    return error;
  for (int to = 0; error == 0 && to < 3; to++)
    error = posix_spawn_file_actions_adddup2(&places, fileno(to == 0 ? script : said), to);
  posix_spawnattr_t attributes;
  sigset_t all, before;
  sigfillset(&all);
  if (error == 0 && (error = posix_spawnattr_init(&attributes)) == 0) {
    pthread_sigmask(SIG_BLOCK, &all, &before); /* no signal comes between its start and the note of it */
    posix_spawnattr_setsigmask(&attributes, &before);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    error = posix_spawnp(process, name, &places, &attributes, arguments, environ);
    if (error == 0)
      file_written_by(*process);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    posix_spawnattr_destroy(&attributes);
  }
  posix_spawn_file_actions_destroy(&places);
  return error;
}

static bool ends_well(pid_t process)
{
  int status;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR)
      return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* Passes on what gnuplot said, line by line, without blank lines and those that point at a place in another. */
static void pass_on(FILE *said, const char *command)
{
  enum { MOST_LINES = 20 };
  char line[400];
  rewind(said);
  for (int count = 0; count < MOST_LINES && fgets(line, sizeof line, said);) {
    line[strcspn(line, "\r\n")] = '\0';
    for (char *c = line; *c; c++)
      if ((unsigned char)*c < 0x20 || *c == 0x7f)
        *c = *c == '\t' ? ' ' : '?';
    if (line[strspn(line, " ^")] == '\0')
      continue;
    complain(command, "gnuplot: %s", line + strspn(line, " "));
    count++;
  }
}

static bool run(const struct plot *p, const char *command, FILE *script, FILE *said, const struct file *picture)
{
  pid_t process;
  struct stat there;
  put_script(script, p, picture->temporary);
  if (fflush(script) != 0 || ferror(script) || fseek(script, 0, SEEK_SET) != 0)
    return fail(p, command, "cannot write a temporary file", errno);
  int error = start(&process, script, said);
  if (error == ENOENT)
    return fail(p, command, "gnuplot is not installed (Debian: gnuplot-nox); the tables are written", 0);
  if (error != 0)
    return fail(p, command, "cannot run gnuplot", error);
  bool well = ends_well(process);
  file_written_by(0);
  if (!well || p->script)
    pass_on(said, command);
  if (!well)
    return fail(p, command, "gnuplot has failed", 0);
  return (fstat(fileno(picture->stream), &there) == 0 && there.st_size > 0)
         || fail(p, command, "gnuplot has drawn nothing", 0);
}

/* What gnuplot leaves in the texts of an SVG and XML does not take for text: "]]>" outside of CDATA, bytes that are no
 * characters, and, but for a script of the user's own, references such as "&#x1;". */
static void put_svg(FILE *to, const char *text, bool has_references)
{
  bool in_data = false;
  for (size_t length; *text; text += length) {
    const char *instead = NULL;
    length = strchr("\n\t\r", *text) ? 1 : shown_character(text);
    bool ends = strncmp(text, "]]>", 3) == 0;
    if (length == 0)
      instead = "?", length = 1;
    else if (ends && !in_data)
      instead = "]]&gt;", length = 3;
    else if (!has_references && strncmp(text, "&#", 2) == 0)
      instead = "&amp;#", length = 2;
    in_data = (in_data && !ends) || strncmp(text, "<![CDATA[", 9) == 0;
    fwrite(instead ? instead : text, 1, instead ? strlen(instead) : length, to);
  }
}

static bool make_readable(const struct plot *p, const char *command, const struct file *picture)
{
  char *text = NULL;
  size_t room = 0;
  FILE *drawn = fopen(picture->temporary, "r");
  bool read = drawn && getdelim(&text, &room, '\0', drawn) > 0;
  if (drawn)
    fclose(drawn);
  if (read && ftruncate(fileno(picture->stream), 0) == 0)
    put_svg(picture->stream, text, p->script != NULL);
  free(text);
  return read || fail(p, command, "cannot read it", errno);
}

/* gnuplot ends a cell at a plain quotation mark, and looks for escapes behind a backslash. */
static bool is_mistaken(int c) { return c == '"' || c == '\\'; }

static bool has_mistaken(const char *table)
{
  int c = EOF;
  FILE *rows = fopen(table, "r");
  while (rows && (c = getc(rows)) != EOF && !is_mistaken(c))
    ;
  if (rows)
    fclose(rows);
  return is_mistaken(c);
}

/* For gnuplot: with another quotation mark, and two backslashes for one */
static bool copy_rows(const struct plot *p, FILE *copy)
{
  FILE *rows = fopen(p->table, "r");
  for (int c; rows && (c = getc(rows)) != EOF;)
    if (is_mistaken(c))
      fputs(c == '"' ? "\xe2\x80\x9d" : "\\\\", copy);
    else
      putc(c, copy);
  if (rows)
    fclose(rows);
  return rows && fflush(copy) == 0;
}

static bool draw(const struct plot *p, const char *command, FILE *script, FILE *said)
{
  struct file picture;
  int error = file_open(&picture, p->file);
  if (error != 0)
    return fail(p, command, "cannot write it", error);
  bool drawn = run(p, command, script, said, &picture)
               && (strcmp(plot_kind(p->file), "svg") != 0 || make_readable(p, command, &picture));
  error = file_close(&picture, drawn);
  return drawn && (error == 0 || fail(p, command, "cannot write it", error));
}

bool plot_may_replace(const struct plot *p, const char *command)
{
  struct stat there;
  return stat(p->file, &there) != 0 || S_ISREG(there.st_mode)
         || fail(p, command, "there is something of this name that is no file", 0);
}

/* Through files that have no name: a pipe could wait for a reader that waits itself. */
static bool draw_rows(const struct plot *p, const char *command)
{
  FILE *script = tmpfile(), *said = script ? tmpfile() : NULL;
  bool drawn = said ? draw(p, command, script, said) : fail(p, command, "no temporary file", errno);
  if (script)
    fclose(script);
  if (said)
    fclose(said);
  return drawn;
}

bool plot_draw(const struct plot *p, const char *command)
{
  struct plot of_copy = *p;
  struct file copy;
  if (!plot_may_replace(p, command))
    return false;
  if (p->script || !has_mistaken(p->table))
    return draw_rows(p, command);
  int error = file_open(&copy, p->file);
  if (error != 0)
    return fail(p, command, "cannot write it", error);
  of_copy.table = copy.temporary;
  bool drawn = copy_rows(p, copy.stream) ? draw_rows(&of_copy, command)
                                         : fail(p, command, "cannot copy its rows", errno);
  file_close(&copy, false);
  return drawn;
}
