#include "compare/command/plot_script.h"

#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "compare/text/message.h"
#include "compare/text/shipped.h"

static const char style[] = "set border 3\n"
                            "set tics nomirror\n"
                            "set grid lc rgb '#dddddd' lt 1\n"
                            "set xzeroaxis lt 1 lc rgb '#999999'\n";

/* Colours that stay apart for colour-blind readers and in grey: the first three are those of the figures. */
static const char *const colours[] = {
  "#0b3c8c", "#c8102e", "#2a9d4a", "#b8860b", "#7b3fa0", "#1b9aaa", "#000000", "#888888"
};
enum { COLOURS = sizeof colours / sizeof *colours, FEW_POINTS = 40, SHORT_TITLE = 26 };

/* ---- text ---- */

/* In double quotes, where a backslash and three octal digits are a byte: all but the plainest characters are written so. No
 * quote, backslash, newline or backquote of the text is seen by gnuplot as one. */
static void put_byte(FILE *to, unsigned char c)
{
  if (c < 0x80 && (isalnum(c) || strchr(" _./:+-=,()", c)))
    fputc(c, to);
  else
    fprintf(to, "\\%03o", c);
}

/* Text to be shown: a question mark for each byte that cannot be. */
static void put_escaped(FILE *to, const char *text)
{
  while (*text) {
    size_t length = shown_character(text);
    if (length == 0)
      put_byte(to, '?');
    for (size_t i = 0; i < length; i++)
      put_byte(to, (unsigned char)text[i]);
    text += length > 0 ? length : 1;
  }
}

static void put_quoted(FILE *to, const char *text)
{
  fputc('"', to);
  put_escaped(to, text);
  fputc('"', to);
}

/* "./" keeps '<', '-' and whatever else means no file to gnuplot off the first place. */
static void put_path(FILE *to, const char *path)
{
  fputs(*path == '/' ? "\"" : "\"./", to);
  while (*path)
    put_byte(to, (unsigned char)*path++);
  fputc('"', to);
}

static void put_terminal(FILE *to, const char *kind, const char *output)
{
  fputs("set encoding utf8\n", to);
  if (strcmp(kind, "svg") == 0)
    fputs("set terminal svg size 800,500 font 'DejaVu Sans,12' background rgb 'white'\n", to);
  else if (strcmp(kind, "png") == 0)
    fputs("set terminal pngcairo size 1200,750 font 'DejaVu Sans,14' background rgb 'white'\n", to);
  else
    fputs("set terminal pdfcairo size 8in,5in font 'DejaVu Sans,12' background rgb 'white'\n", to);
  fprintf(to, "set output '%s'\n", output);
}

/* ---- axes ---- */

/* One of a list of tics; count: those before it */
static void put_tic(FILE *to, double at, int *count) { fprintf(to, "%s%.12g", (*count)++ > 0 ? ", " : "", at); }

/* Multiples of the step, 1, 2 or 5 times a power of ten, of which there are some five from least to most */
static void put_even_tics(FILE *to, double least, double most, int *count)
{
  double power = pow(10, floor(log10((most - least) / 5))), ratio = (most - least) / 5 / power;
  double step = power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  for (double n = ceil(least / step); n * step <= most; n++)
    put_tic(to, n * step, count);
}

/* 1, 2 and 5 times powers of ten */
static void put_decade_tics(FILE *to, double least, double most, int *count)
{
  static const double heads[] = { 1, 2, 5 };
  for (double power = floor(log10(least)); power <= log10(most); power++)
    for (int i = 0; i < 3; i++) {
      double at = heads[i] * pow(10, power);
      if (at >= least && at <= most)
        put_tic(to, at, count);
    }
}

/* On a logarithmic axis of few powers of ten gnuplot has few tics, and goes far beyond the points on both sides. */
static void put_short_axis(FILE *to, char axis, double least, double most)
{
  const double apart = 1 + 1e-6; /* nearer ones are drawn as one: tics are told apart in 12 digits */
  double margin = most > apart * least ? pow(most / least, 0.04) : 1.1;
  int count = 0;
  least = fmax(least / margin, DBL_MIN);
  most = fmin(most * margin, DBL_MAX);
  fprintf(to, "set %crange [%.17g:%.17g]\nset %ctics (", axis, least, most, axis);
  if (most < 10 * least)
    put_even_tics(to, least, most, &count);
  else
    put_decade_tics(to, least, most, &count);
  fputs(")\n", to);
}

static void put_axis(FILE *to, char axis, bool logarithmic, double least, double most)
{
  enum { MANY_DECADES = 3 };
  if (!logarithmic)
    return;
  fprintf(to, "set logscale %c\n", axis);
  if (log10(most) - log10(least) < MANY_DECADES)
    put_short_axis(to, axis, least, most);
  else
    fprintf(to, "set format %c '10^{%%T}'\n", axis);
}

static void put_label(FILE *to, char axis, const char *const *names, int count)
{
  fprintf(to, "set %clabel \"", axis);
  for (int i = 0; i < count; i++) {
    fputs(i > 0 ? ", " : "", to);
    put_escaped(to, names[i]);
  }
  fputs("\" noenhanced\n", to);
}

/* ---- curves ---- */

static size_t longest_title(const struct plot *p, const struct plot_data *d)
{
  size_t longest = 0;
  for (int v = 0; v < d->values; v++)
    for (int q = 0; q < d->quantities; q++) {
      size_t length = (d->quantities > 1 ? strlen(p->y[q]) : 0) + (p->by ? strlen(p->by) + strlen(d->value[v]) + 3 : 0);
      longest = length > longest ? length : longest;
    }
  return longest;
}

/* Beside the curves, or below them where it would take too much of their room; one curve needs none, the axis names it. */
static void put_key(FILE *to, const struct plot *p, const struct plot_data *d)
{
  if (d->quantities * d->values == 1 && !p->by)
    fputs("unset key\n", to);
  else
    fprintf(to, "set key noenhanced samplen 2 Left reverse %s\n",
            longest_title(p, d) > SHORT_TITLE ? "below left" : "outside right top");
}

static void put_points(FILE *to, const struct plot_curve *c, int number)
{
  fprintf(to, "$curve%d << END\n", number);
  for (const struct plot_point *p = c->points; p < c->points + c->count; p++)
    if (isnan(p->x))
      fputc('\n', to);
    else
      fprintf(to, "%.17g\t%.17g\n", p->x, p->y);
  fputs("END\n", to);
}

/* By colour the values of by are told apart and by dashes the columns; without by the columns have colours. */
static void put_style(FILE *to, const struct plot *p, const struct plot_curve *c, int value, int quantity)
{
  int colour = p->by ? value : quantity, dashes = p->by ? quantity : 0;
  fprintf(to, " with %s lw 2 dt %d lc rgb '%s'", c->shown <= FEW_POINTS ? "linespoints" : "lines", dashes % 5 + 1,
          colours[colour % COLOURS]);
  if (c->shown <= FEW_POINTS)
    fprintf(to, " pt %d ps 0.6", 5 + 2 * (colour % 5));
}

static void put_title(FILE *to, const struct plot *p, const struct plot_data *d, int value, int quantity)
{
  fputs(" title \"", to);
  if (d->quantities > 1 || !p->by)
    put_escaped(to, p->y[quantity]);
  if (p->by) {
    fputs(d->quantities > 1 ? ", " : "", to);
    put_escaped(to, p->by);
    fputs(" = ", to);
    put_escaped(to, d->value[value]);
  }
  if (d->curves[value][quantity].shown == 0)
    fputs(" (none)", to);
  fputc('"', to);
}

void plot_script_write(FILE *to, const struct plot *p, const struct plot_data *d, const char *output)
{
  put_terminal(to, plot_kind(p->file), output);
  fputs(style, to);
  put_axis(to, 'x', p->log_x, d->least.x, d->most.x);
  put_axis(to, 'y', p->log_y, d->least.y, d->most.y);
  put_label(to, 'x', &p->x, 1);
  put_label(to, 'y', p->y, d->quantities);
  put_key(to, p, d);
  if (p->title) {
    fputs("set title ", to);
    put_quoted(to, p->title);
    fputs(" noenhanced\n", to);
  }
  for (int i = 0; i < d->values * d->quantities; i++)
    put_points(to, &d->curves[i / d->quantities][i % d->quantities], i);
  for (int i = 0; i < d->values * d->quantities; i++) {
    int value = i / d->quantities, quantity = i % d->quantities;
    const struct plot_curve *c = &d->curves[value][quantity];
    fputs(i == 0 ? "plot " : ", ", to);
    if (c->shown > 0)
      fprintf(to, "$curve%d using 1:2", i);
    else
      fputs("keyentry", to);
    put_style(to, p, c, value, quantity);
    put_title(to, p, d, value, quantity);
  }
  fputs("\nunset output\n", to);
}

void plot_script_load(FILE *to, const struct plot *p, const char *common, const char *output)
{
  const char *kind = plot_kind(p->file);
  put_terminal(to, kind, output);
  fputs("set datafile separator \"\\t\"\ntable = ", to);
  put_path(to, p->table);
  fprintf(to, "\noutput_file = '%s'\nkind = '%s'\n", output, kind);
  if (p->program)
    fprintf(to, "%s%s", shipped_text(shipped_scripts, "plot_common"), p->program);
  const char *const scripts[] = { common, p->script };
  for (int i = 0; i < 2; i++)
    if (scripts[i]) {
      fputs("load ", to);
      put_path(to, scripts[i]);
      fputc('\n', to);
    }
  fputs("unset output\n", to);
}
