/* Table of series --bound. */
#include <math.h>

#include "asymptotics/derived/scoped.h"
#include "compare/command/series_options.h"
#include "compare/points/point_flint.h"

enum { BOUND_PRECISION = 128 };

/* Writes four digits, rounded to the safe side: C and the bound up, times down. */
static void write_rounded(struct table *t, const arb_t x, int direction)
{
  enum { SPARE = 1000, DIGITS = 4 }; /* a thousandth is more than the fourth digit's rounding */
  SCOPED(arb, shifted);
  (direction > 0 ? arb_get_ubound_arf : arb_get_lbound_arf)(arb_midref(shifted), x, BOUND_PRECISION);
  arb_mul_si(shifted, shifted, SPARE + direction, BOUND_PRECISION);
  arb_div_si(shifted, shifted, SPARE, BOUND_PRECISION);
  char *text = decimal_text(shifted, DIGITS);
  table_digits(t, text);
  flint_free(text);
}

static void write_bound(struct table *t, const char *quantity, const struct scallop_bound *b, const fmpq_t T,
                        long order)
{
  SCOPED(arb, power, at);
  arb_set_fmpq(at, T, BOUND_PRECISION);
  arb_pow_ui(power, at, (ulong)b->power, BOUND_PRECISION);
  arb_mul(power, power, b->C, BOUND_PRECISION);
  table_text(t, quantity);
  table_count(t, order);
  write_rounded(t, b->C, 1);
  table_count(t, b->power);
  write_rounded(t, b->T0, -1);
  if (arb_le(at, b->T0))
    write_rounded(t, power, 1);
  else
    table_number(t, NAN);
  write_rounded(t, b->T_end, -1);
  table_text(t, b->ends);
}

struct bounds { /* of v_start and displacement */
  struct scallop_bound of[2];
};
#define BOUNDS(of_type) of_type(scallop_bound, &s->of[0]) of_type(scallop_bound, &s->of[1])
SCOPED_PARTS(bounds, struct bounds, BOUNDS)

enum exit_code series_bound(const struct series_options *o, const struct scallop_rational_crawler *crawler)
{
  static const char *const columns[] = { "quantity", "order", "C", "power", "T0", "bound", "T_end", "ends", NULL };
  const long order = o->order.value;
  const char *why = NULL;
  struct table table;
  SCOPED(bounds, bounds);
  enum scallop_status status = scallop_steady_bounds(crawler, order, BOUND_PRECISION, bounds.of, &why);
  if (status != SCALLOP_OK)
    return complain("series", "no bound: %s", why ? why : scallop_status_text(status)), EXIT_UNSOLVED;
  if (!table_head(&table, &o->request.style, "series --bound --order %ld", order))
    return EXIT_FILE;
  table.of = "bounds";
  note_parameters(&table, &o->request.point, NULL, true);
  table_note(&table, "|exact - terms below T^order| <= C T^power for 0 < T <= T0; bound: C T^power at this T");
  table_columns(&table, columns);
  table_begin_rows(&table);
  write_bound(&table, "v_start", &bounds.of[0], crawler->T, order);
  write_bound(&table, "displacement", &bounds.of[1], crawler->T, order);
  return table_close(&table) ? EXIT_DONE : EXIT_FILE;
}
