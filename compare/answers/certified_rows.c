/* Rows of `phase` and `steady` whose every digit is proven. */
#include <math.h>
#include <string.h>

#include "compare/answers/counts_flint.h"
#include "compare/answers/rational.h"
#include "compare/text/decimal.h"
#include "compare/answers/exact.h"
#include "compare/answers/points.h"
#include "compare/answers/defaults.h"
#include "compare/answers/proven.h"
#include "numerics/certified.h"

static void write_ball(struct table *table, const arb_t x, long digits)
{
  char *text = decimal_text(x, digits);
  table_digits(table, text);
  flint_free(text);
}

/* A few digits more than are printed, so that the last one is right to a unit. */
static long digits_of(const struct options *point, long *solve)
{
  long digits = point->digits > 0 ? point->digits : CERTIFIED_DIGITS;
  *solve = digits + 3 < SCALLOP_MOST_DIGITS ? digits + 3 : SCALLOP_MOST_DIGITS;
  return digits;
}

/* Digits with an exponent at most: what every reader takes for a number */
static bool is_plain(const char *text)
{
  size_t whole = strspn(text, "0123456789");
  const char *rest = text + whole;
  if (whole == 0 || (whole > 1 && *text == '0'))
    return false;
  if (*rest == '.')
    rest += 1 + strspn(rest + 1, "0123456789");
  return rest[-1] != '.' && (*rest == '\0' || *rest == 'e' || *rest == 'E');
}

/* As it was written: a double would not hold all digits. */
static void write_parameter(struct table *table, const char *written, double value)
{
  char text[NUMBER_TEXT];
  number_text(text, value, 0);
  if (written && !is_plain(written) && table->options->format == FORMAT_JSON)
    table_text(table, written);
  else
    table_digits(table, written ? written : text);
}

static void parameters(struct table *table, const struct options *point)
{
  int i = 0;
  for (const char *const *name = crawler_parameters; *name; name++, i++)
    if (strcmp(*name, "gait") == 0)
      table_text(table, point->point.crawler.gait->name);
    else
      write_parameter(table, point->point.written[i], crawler_parameter(&point->point.crawler, *name));
}

static const char *reason(enum scallop_status status, const char *why)
{
  static char text[200];
  snprintf(text, sizeof text, "%s%s%s", scallop_status_text(status), why ? ": " : "", why ? why : "");
  return text;
}

/* The cells of a row without an answer; returns the reason. */
static const char *write_no_answer(struct table *table, enum scallop_status status, const char *why)
{
  const char *text = reason(status, why);
  point_blank(table, 6);
  table_text(table, "-");
  table_text(table, "-");
  table_text(table, text);
  return text;
}

const char *certified_phase_row(struct table *table, const struct options *point)
{
  long solve, digits = digits_of(point, &solve);
  struct scallop_rational_crawler crawler;
  struct scallop_certified_phase p;
  const char *why = NULL;
  char modes[SCALLOP_MODES_TEXT];
  fmpq_t v0;
  scallop_rational_init(&crawler);
  scallop_certified_phase_init(&p);
  fmpq_init(v0);
  rational_point(&crawler, v0, &point->point);
  parameters(table, point);
  table_text(table, point->point.phase == SCALLOP_EXTENSION ? "extension" : "contraction");
  write_parameter(table, point->point.written_v0, point->point.v0);
  enum scallop_status status = counted_certified_phase(&crawler, point->point.phase, v0, solve, &p, &why);
  if (status == SCALLOP_OK) {
    const arb_struct *numbers[] = { p.t1, p.dT, p.v_end, p.dx1, p.dx2, p.dxC };
    for (int i = 0; i < 6; i++)
      if (i < 2 && !p.switches)
        table_number(table, NAN);
      else
        write_ball(table, numbers[i], digits);
    table_text(table, scallop_regime_text(p.regime));
    scallop_modes_text(&p.modes, modes);
    table_text(table, modes);
    table_text(table, "certified");
  }
  const char *unsolved = status == SCALLOP_OK ? NULL : write_no_answer(table, status, why);
  fmpq_clear(v0);
  scallop_certified_phase_clear(&p);
  scallop_rational_clear(&crawler);
  return unsolved;
}

const char *certified_steady_row(struct table *table, const struct options *point)
{
  long solve, digits = digits_of(point, &solve);
  struct scallop_rational_crawler crawler;
  struct scallop_certified_steady s;
  const char *why = NULL;
  char modes[PERIOD_MODES_TEXT];
  scallop_rational_init(&crawler);
  scallop_certified_steady_init(&s);
  rational_point(&crawler, NULL, &point->point);
  parameters(table, point);
  enum scallop_status status = counted_certified_steady(&crawler, solve, &s, &why);
  if (status == SCALLOP_OK) {
    const arb_struct *numbers[] = { s.froude, s.v_start, s.v_mid, s.displacement, s.mean_velocity, s.multiplier };
    for (int i = 0; i < 6; i++)
      write_ball(table, numbers[i], digits);
    table_text(table, scallop_regime_text(s.regime));
    table_text(table, period_modes_text(modes, s.modes));
    table_text(table, "certified");
  }
  const char *unsolved = status == SCALLOP_OK ? NULL : write_no_answer(table, status, why);
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&crawler);
  return unsolved;
}
