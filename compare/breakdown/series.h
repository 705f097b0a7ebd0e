/* A motion as a function of T: of a steady state the period, of one phase from velocity v0 its duration. T of the
 * crawler in it is not used, and parameters are the doubles they are. Beside it its series: formulas of books and of
 * the paper, the derived terms, the limit. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_SERIES_H
#define SCALLOP_COMPARE_BREAKDOWN_SERIES_H

#include "compare/answers/answer_flint.h"
#include "compare/breakdown/breakdown.h"
#include "model/exact/scoped.h"

enum {
  BREAKDOWN_BITS = 256, /* of the balls that errors are formed in */
  MOST_ITEMS = 32
};

SCOPED_KIND(ball_answer, struct ball_answer)

/* The motion at T. A phase is the half of a period: its duration is then exactly T. */
struct motion motion_at(const struct motion *motion, double T);
/* The answer in binary128 at T. A displacement that is 0 in double is 0. */
bool motion_in_wide(const struct motion *motion, double T, struct answer *answer);

/* Is it a quantity of this motion that has a series? */
bool motion_has(const struct motion *motion, enum quantity_id quantity);
/* The duration at which the Froude number is 1, and the Froude number. */
double motion_natural_time(const struct motion *motion);
double motion_froude(const struct motion *motion, double T);
/* Beyond this T nothing changes any more: the body with the larger friction rests for good. */
double motion_last_time(const struct motion *motion);

struct series_item { /* one series for one quantity */
  enum breakdown_source source;
  enum quantity_id quantity;
  const char *name;
  const struct scallop_formula *formula; /* of a book, or published */
  const struct series *series;           /* derived and limit: their terms below T^before */
  slong before;
};

struct expansions {
  const struct motion *motion;
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  struct series_answer derived;
};
/* Derives all terms below T^order, in balls of so many bits where they are not rational. */
void expansions_init(struct expansions *e, const struct motion *motion, slong order, slong precision);
void expansions_clear(struct expansions *e);
/* Of the limit T -> 0, or "" where there is none. */
const char *expansions_modes(const struct expansions *e);
const struct series *expansions_of(const struct expansions *e, enum quantity_id quantity);

/* Is the formula about the quantity, or about one that becomes it: a displacement the mean velocity, a change of
 * velocity the velocity at the end? */
bool series_is_about(const struct scallop_formula *formula, const struct motion *motion, enum quantity_id quantity);
/* All series of a quantity, by their source; order: of the derived one. Returns how many. */
int series_items(struct series_item items[MOST_ITEMS], const struct expansions *e, enum quantity_id quantity,
                 long order);
/* Value at T; nan or not finite where there is none. */
void series_item_value(arb_t value, const struct series_item *item, const struct expansions *e, double T,
                       slong precision);

#endif
