/* What the files breakdown_*.c share: a motion as a function of T, and the series beside it. Not public. */
#ifndef SCALLOP_BREAKDOWN_PARTS_H
#define SCALLOP_BREAKDOWN_PARTS_H

#include "asymptotics/evaluate.h"
#include "asymptotics/singularity.h"
#include "compare/breakdown/breakdown.h"
#include "compare/answers/answer_flint.h"
#include "compare/answers/mode_change.h"
#include "compare/answers/quantity.h"

enum { BREAKDOWN_BITS = 256 }; /* of the balls that errors are formed in                            */

/* ---- the exact motion as a function of T ---- */

/* The steady state, T being the period; or one phase from velocity v0, T being its duration. Parameters are the doubles they are. */
struct subject {
  struct scallop_crawler crawler; /* T is not used                                                  */
  bool steady;
  enum scallop_phase_kind kind;
  double v0;
};

/* The crawler at T. A phase is the half of a period: its duration is then exactly T. */
struct scallop_crawler subject_crawler(const struct subject *subject, double T);

/* The answer at one T: in double (low = 0), or in binary128: 25 us to 0.4 ms. */
void subject_in_double(const struct subject *subject, double T, struct answer *answer);
void subject_in_wide(const struct subject *subject, double T, struct answer *answer);
/* All of them as balls with so many digits: values[QUANTITIES], not finite where there is none. False: they cannot be
 * certified. */
bool subject_in_balls(const struct subject *subject, double T, long digits, arb_ptr values);

bool subject_has(const struct subject *subject, enum quantity_id quantity);
/* The duration at which the Froude number is 1, and the Froude number. */
double subject_natural_time(const struct subject *subject);
double subject_froude(const struct subject *subject, double T);
/* Beyond this T nothing changes any more: the body with the larger friction rests for good. */
double subject_last_time(const struct subject *subject);

/* ---- the series beside it ---- */

struct series_item { /* one series for one quantity                                               */
  struct breakdown_series which;
  const struct scallop_formula *formula; /* published                                             */
  const struct series *series;           /* derived and limit                                     */
  slong before;                          /* their terms below T^before                            */
  bool divide_by_T, add_v0;              /* published: what is done to the formula's value           */
  const char *name;
};

struct expansions {
  const struct subject *subject;
  struct scallop_rational_crawler crawler;
  struct series_answer derived;
  struct scallop_symbols symbols;
};
/* Derives all terms below T^order, in balls of so many bits where they are not rational. */
void expansions_init(struct expansions *e, const struct subject *subject, slong order, slong precision);
void expansions_clear(struct expansions *e);
/* Of the limit T -> 0, or "" where there is none. */
const char *expansions_modes(const struct expansions *e);
const struct series *expansions_of(const struct expansions *e, enum quantity_id quantity);

/* The next series of a quantity after item->name (NULL: the first); order: of the derived one. False: there is none left. */
bool series_item_next(struct series_item *item, const struct expansions *e, enum quantity_id quantity, long order);
/* Value at T; nan or not finite where there is none. */
void series_item_value(arb_t value, const struct series_item *item, struct expansions *e, double T, slong precision);

/* ---- how far it reaches ---- */

/* series/exact - 1 as a function of T, with what has been computed of it. */
struct comparison {
  const struct subject *subject;
  struct expansions *expansions;
  struct series_item item;
  struct exact_cache *cache; /* shared by the comparisons of a subject                                */
};
struct exact_cache *exact_cache_new(const struct subject *subject);
void exact_cache_free(struct exact_cache *cache);

/* series/exact - 1 at T for this exact value; nan where it has none, 0 where both are 0. */
double comparison_error_beside(const struct comparison *c, double T, const arb_t exact, slong precision);
/* The error at T, by binary128. */
double comparison_error(const struct comparison *c, double T);
/* By certified values with so many digits: -1 if |error| < tolerance at T is proven, +1 if the contrary is, 0 if neither. */
int comparison_certified_side(const struct comparison *c, double T, double tolerance, long digits);

/* As breakdown_reach. */
double comparison_reach(const struct comparison *c, double tolerance);
/* The error for T -> 0, if it settles at a value other than 0; else nan. */
double comparison_limit(const struct comparison *c);

/* ---- what ends it ---- */

enum { EVENT_TEXT = MODE_CHANGE_TEXT };

struct event {
  double T;
  char what[EVENT_TEXT];
  struct scallop_modes modes[2]; /* from here on                                                      */
  enum scallop_regime regime;
  const char *status; /* how it is known: certified, binary128 or double                          */
};
struct events {
  struct scallop_modes first[2]; /* the modes below the first event                                   */
  enum scallop_regime regime;
  double from, until; /* searched: this range of T                                              */
  int count, room;
  struct event *event;
};
/* limit_modes: those for T -> 0, or "" where they are not known. */
void events_find(struct events *events, const struct subject *subject, const char *limit_modes);
void events_clear(struct events *events);

/* ---- radius of convergence ---- */

struct radius {
  const char *method;  /* poles, singularity, or bound: T is proven to be no more than the radius          */
  double T, low, high; /* |T| of the nearest singularity; the radius is proven to be within [low, high]      */
  const char *status;
  char note[2 * EVENT_TEXT];
};
/* From the coefficients below T^order, where the series is that of a rational function. False: it is not. */
bool radius_from_poles(struct radius *r, const struct series *series, slong order);
/* Of the branch that the series expand, or of its first crossing alone, which t1 depends on. False: there is none. */
bool singularity_of(struct scallop_singularity *s, const struct expansions *e, bool first_crossing);
void radius_from_singularity(struct radius *r, const struct scallop_singularity *s, enum quantity_id quantity);

#endif
