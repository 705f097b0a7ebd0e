#include "compare/text/decimal.h"

#include "compare/answers/gaits.h"
#include "compare/text/table.h"
#include "compare/answers/written_gait.h"

static void decimal_rational(fmpq_t x, double value)
{
  char text[NUMBER_TEXT];
  number_text(text, value, 0);
  if (!scallop_rational_parse(x, text))
    scallop_rational_set_double(x, value);
}

void decimal_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *c)
{
  fmpq *const fields[] = { exact->m1, exact->m2, exact->F1, exact->F2, exact->L, exact->T, exact->alpha };
  const double values[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  for (int i = 0; i < 7; i++)
    decimal_rational(fields[i], values[i]);
  exact->gait = written_gait(c->gait);
}

/* L, T and alpha that come of the table of a measured gait are those of its decimals. */
static void take_own(struct scallop_rational_crawler *exact, const struct options *o)
{
  enum { OWN = 3, FIRST = 4 }; /* of the crawler's numbers */
  fmpq_t own[OWN];
  double L, T, alpha;
  for (int i = 0; i < OWN; i++)
    fmpq_init(own[i]);
  if (gait_has_own(o->crawler.gait, &L, &T, &alpha) && written_gait_has_own(o->crawler.gait, own[0], own[1], own[2])) {
    const double is[OWN] = { o->crawler.L, o->crawler.T, o->crawler.alpha }, was[OWN] = { L, T, alpha };
    fmpq *const fields[OWN] = { exact->L, exact->T, exact->alpha };
    for (int i = 0; i < OWN; i++)
      if (!o->written[FIRST + i] && is[i] == was[i])
        fmpq_set(fields[i], own[i]);
  }
  for (int i = 0; i < OWN; i++)
    fmpq_clear(own[i]);
}

void decimal_options(struct scallop_rational_crawler *exact, fmpq_t v0, const struct options *o)
{
  fmpq *const fields[] = { exact->m1, exact->m2, exact->F1, exact->F2, exact->L, exact->T, exact->alpha };
  decimal_crawler(exact, &o->crawler);
  for (int i = 0; i < 7; i++)
    if (o->written[i])
      scallop_rational_parse(fields[i], o->written[i]);
  take_own(exact, o);
  if (!v0)
    return;
  decimal_rational(v0, o->v0);
  if (o->written_v0)
    scallop_rational_parse(v0, o->written_v0);
}

char *decimal_text(const arb_t x, long digits) { return arb_get_str(x, digits, ARB_STR_NO_RADIUS); }

char *decimal_fraction(const fmpq_t x) { return fmpq_get_str(NULL, 10, x); }

char *decimal_ball(const arb_t x, long digits) { return arb_get_str(x, digits, 0); }
