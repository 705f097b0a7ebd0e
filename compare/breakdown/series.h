/* The series beside a motion: the paper's formulas, the derived terms, the limit. */
#ifndef SCALLOP_BREAKDOWN_SERIES_H
#define SCALLOP_BREAKDOWN_SERIES_H

#include "asymptotics/derived/evaluate.h"
#include "compare/answers/answer_flint.h"
#include "compare/breakdown/breakdown.h"

enum { BREAKDOWN_BITS = 256 }; /* of the balls that errors are formed in                            */

struct series_item { /* one series for one quantity                                               */
  struct breakdown_series which;
  const struct scallop_formula *formula; /* published                                             */
  const struct series *series;           /* derived and limit                                     */
  slong before;                          /* their terms below T^before                            */
  bool divide_by_T, add_v0;              /* published: what is done to the formula's value           */
  const char *name;
};

struct expansions {
  const struct motion *motion;
  struct scallop_rational_crawler crawler;
  struct series_answer derived;
  struct scallop_symbols symbols;
};
/* Derives all terms below T^order, in balls of so many bits where they are not rational. */
void expansions_init(struct expansions *e, const struct motion *motion, slong order, slong precision);
void expansions_clear(struct expansions *e);
/* Of the limit T -> 0, or "" where there is none. */
const char *expansions_modes(const struct expansions *e);
const struct series *expansions_of(const struct expansions *e, enum quantity_id quantity);

/* The next series of a quantity after item->name (NULL: the first); order: of the derived one. False: there is none left. */
bool series_item_next(struct series_item *item, const struct expansions *e, enum quantity_id quantity, long order);
/* Value at T; nan or not finite where there is none. */
void series_item_value(arb_t value, const struct series_item *item, struct expansions *e, double T, slong precision);

#endif
