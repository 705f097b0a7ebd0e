#include "compare/decimal.h"

#include "compare/table.h"

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
  exact->gait = c->gait;
}

void decimal_options(struct scallop_rational_crawler *exact, fmpq_t v0, const struct options *o)
{
  fmpq *const fields[] = { exact->m1, exact->m2, exact->F1, exact->F2, exact->L, exact->T, exact->alpha };
  decimal_crawler(exact, &o->crawler);
  for (int i = 0; i < 7; i++)
    if (o->written[i])
      scallop_rational_parse(fields[i], o->written[i]);
  if (!v0)
    return;
  decimal_rational(v0, o->v0);
  if (o->written_v0)
    scallop_rational_parse(v0, o->written_v0);
}

char *decimal_text(const arb_t x, long digits) { return arb_get_str(x, digits, ARB_STR_NO_RADIUS); }

char *decimal_fraction(const fmpq_t x) { return fmpq_get_str(NULL, 10, x); }

char *decimal_ball(const arb_t x, long digits) { return arb_get_str(x, digits, 0); }
