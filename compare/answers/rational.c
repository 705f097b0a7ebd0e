#include "compare/answers/rational.h"

#include "compare/answers/gaits.h"
#include "compare/answers/written_gait.h"
#include "compare/text/digits.h"
#include "compare/text/table.h"

static void rational_number(fmpq_t x, double value)
{
  char text[NUMBER_TEXT];
  number_text(text, value, 0);
  if (!scallop_rational_parse(x, text))
    scallop_rational_set_double(x, value);
}

void rational_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *c)
{
  fmpq *const fields[] = { exact->m1, exact->m2, exact->F1, exact->F2, exact->L, exact->T, exact->alpha };
  const double values[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  for (int i = 0; i < 7; i++)
    rational_number(fields[i], values[i]);
  exact->gait = written_gait(c->gait);
}

/* L, T and alpha that come of the table of a measured gait are those of its decimals. */
static void take_own(struct scallop_rational_crawler *exact, const struct point *p)
{
  enum { OWN = 3, FIRST = 4 }; /* of the crawler's numbers */
  fmpq_t own[OWN];
  double L, T, alpha;
  for (int i = 0; i < OWN; i++)
    fmpq_init(own[i]);
  if (gait_has_own(p->crawler.gait, &L, &T, &alpha) && written_gait_has_own(p->crawler.gait, own[0], own[1], own[2])) {
    const double is[OWN] = { p->crawler.L, p->crawler.T, p->crawler.alpha }, was[OWN] = { L, T, alpha };
    fmpq *const fields[OWN] = { exact->L, exact->T, exact->alpha };
    for (int i = 0; i < OWN; i++)
      if (!p->written[FIRST + i] && is[i] == was[i])
        fmpq_set(fields[i], own[i]);
  }
  for (int i = 0; i < OWN; i++)
    fmpq_clear(own[i]);
}

void rational_point(struct scallop_rational_crawler *exact, fmpq_t v0, const struct point *p)
{
  fmpq *const fields[] = { exact->m1, exact->m2, exact->F1, exact->F2, exact->L, exact->T, exact->alpha };
  rational_crawler(exact, &p->crawler);
  for (int i = 0; i < 7; i++)
    if (p->written[i])
      scallop_rational_parse(fields[i], p->written[i]);
  take_own(exact, p);
  if (!v0)
    return;
  rational_number(v0, p->v0);
  if (p->written_v0)
    scallop_rational_parse(v0, p->written_v0);
}
