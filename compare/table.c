#include "compare/table.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/compare.h"

static const char *where(const struct table *t) { return t->options->output ? t->options->output : "standard output"; }

/* The unfinished file, for a signal that ends the process. */
static const char *volatile unfinished;

static void give_up(int signal_number)
{
  if (unfinished)
    unlink(unfinished);
  signal(signal_number, SIG_DFL);
  raise(signal_number);
}

static void watch(const char *aside)
{
  static const int signals[] = { SIGINT, SIGTERM, SIGHUP };
  struct sigaction before, ours = { .sa_handler = give_up };
  sigfillset(&ours.sa_mask); /* a second signal waits until the file is gone */
  unfinished = aside;
  for (int i = 0; aside && i < 3; i++)
    if (sigaction(signals[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN) /* under nohup the terminal may go */
      sigaction(signals[i], &ours, NULL);
}

static void forget_names(struct table *t)
{
  free(t->aside);
  free(t->target);
  t->aside = t->target = NULL;
}

/* Opens a file beside the one it will become. The target is found through any link. */
static bool open_aside(struct table *t, const char *output)
{
  enum { ENDING = 32 };
  struct stat there;
  t->target = realpath(output, NULL);
  if (!t->target && lstat(output, &there) == 0) /* a link to nothing */
    return false;
  if (!t->target)
    t->target = strdup(output);
  if (!t->target)
    return false;
  size_t size = strlen(t->target) + ENDING;
  t->aside = malloc(size);
  if (!t->aside)
    return false;
  snprintf(t->aside, size, "%s.%ld.part", t->target, (long)getpid());
  watch(t->aside); /* before the file is there */
  t->file = fopen(t->aside, "w");
  if (t->file && stat(t->target, &there) == 0)
    (void)fchmod(fileno(t->file), there.st_mode & 07777); /* what the file replaces could be read by the same people */
  return t->file != NULL;
}

bool table_open(struct table *t, const struct options *options)
{
  struct stat there;
  *t = (struct table){ .file = stdout, .options = options };
  if (!options->output)
    return true;
  bool plain = stat(options->output, &there) != 0 || S_ISREG(there.st_mode);
  if (!plain) /* a pipe or a device: nothing to rename onto */
    t->file = fopen(options->output, "w");
  if (plain ? !open_aside(t, options->output) : !t->file) {
    complain(options->command->name, "cannot write %s: %s", options->output, strerror(errno));
    watch(NULL);
    forget_names(t);
    return false;
  }
  return true;
}

void table_note(struct table *t, const char *format, ...)
{
  va_list arguments;
  if (t->options->format == FORMAT_JSON)
    return;
  va_start(arguments, format);
  fputs("# ", t->file);
  vfprintf(t->file, format, arguments);
  fputc('\n', t->file);
  va_end(arguments);
}

void number_text(char text[NUMBER_TEXT], double x, long digits)
{
  for (int precision = digits > 0 ? (int)digits : 15;; precision++) {
    snprintf(text, NUMBER_TEXT, "%.*g", precision, x);
    if (digits > 0 || precision == 17 || strtod(text, NULL) == x || isnan(x))
      break;
  }
  if (isnan(x)) /* of either sign */
    memcpy(text, "nan", 4);
}

static void print_number(FILE *file, double x, long digits)
{
  char text[NUMBER_TEXT];
  number_text(text, x, digits);
  fputs(text, file);
}

void table_parameters(struct table *t, const struct options *o)
{
  if (o->format == FORMAT_JSON)
    return;
  fputs("# parameters:", t->file);
  for (const char *const *name = crawler_parameters; *name; name++) {
    fprintf(t->file, " %s=", *name);
    if (strcmp(*name, "gait") == 0)
      fputs(o->crawler.gait->name, t->file);
    else
      print_number(t->file, crawler_parameter(&o->crawler, *name), 0);
  }
  fputc('\n', t->file);
}

void table_columns(struct table *t, const char *const *names)
{
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

void table_begin_rows(struct table *t)
{
  if (t->options->format == FORMAT_JSON)
    return;
  for (int i = 0; i < t->count; i++)
    fprintf(t->file, "%s%s", i > 0 ? "\t" : "", t->columns[i]);
  fputc('\n', t->file);
}

static void begin_cell(struct table *t)
{
  if (t->options->format == FORMAT_JSON)
    fprintf(t->file, "%s\"%s\": ", t->at == 0 ? "{" : ", ", t->columns[t->at]);
  else if (t->at > 0)
    fputc('\t', t->file);
}

static void end_cell(struct table *t)
{
  if (++t->at < t->count)
    return;
  fputs(t->options->format == FORMAT_JSON ? "}\n" : "\n", t->file);
  t->at = 0;
}

void table_number(struct table *t, double value)
{
  begin_cell(t);
  if (t->options->format == FORMAT_JSON && !isfinite(value))
    fputs(isnan(value) ? "null" : value > 0 ? "1e999" : "-1e999", t->file);
  else
    print_number(t->file, value, t->options->digits > DBL_DECIMAL_DIG ? 0 : t->options->digits);
  end_cell(t);
}

void table_digits(struct table *t, const char *number)
{
  begin_cell(t);
  fputs(number, t->file);
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
    fputs("null", t->file);
  else
    fputs(isnan(value) ? "nan" : text, t->file);
  end_cell(t);
}

void table_text(struct table *t, const char *text)
{
  begin_cell(t);
  bool json = t->options->format == FORMAT_JSON;
  if (json)
    fputc('"', t->file);
  for (; *text; text++) {
    unsigned char c = (unsigned char)*text;
    if (json && (c == '"' || c == '\\'))
      fprintf(t->file, "\\%c", c);
    else if (c < 0x20)
      fputc(' ', t->file);
    else if (c > 0x7e) /* somebody's bytes in a message: not to make the table unreadable */
      fputc('?', t->file);
    else
      fputc(c, t->file);
  }
  if (json)
    fputc('"', t->file);
  end_cell(t);
}

bool table_close(struct table *t)
{
  bool written = fflush(t->file) == 0 && !ferror(t->file);
  int error = errno;
  if (t->file != stdout && fclose(t->file) != 0 && written) {
    written = false;
    error = errno;
  }
  if (t->aside) {
    if (written && rename(t->aside, t->target) != 0) {
      written = false;
      error = errno;
    }
    if (!written)
      remove(t->aside);
  }
  if (!written)
    complain(t->options->command->name, "cannot write %s: %s", where(t), strerror(error));
  watch(NULL);
  forget_names(t);
  return written;
}

void table_abandon(struct table *t)
{
  if (t->file != stdout)
    fclose(t->file);
  if (t->aside) {
    remove(t->aside);
    watch(NULL);
    forget_names(t);
  }
}
