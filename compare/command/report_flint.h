/* What `scallop series` writes of derived series: a table, or for each quantity a function of T in Python or a formula
 * in LaTeX. Needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_REPORT_FLINT_H
#define SCALLOP_COMPARE_COMMAND_REPORT_FLINT_H

#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/language.h"
#include "compare/answers/quantities.h"
#include "compare/command/series_options.h"

struct report {
  const struct series_options *options;
  const struct scallop_rational_crawler *crawler; /* as it was written */
  long digits;                                    /* of decimal numbers */
  const struct language *language;                /* NULL: a table */
  char why[240];                                  /* the first that could not be done: the reason */
  struct table table;
  struct file out; /* of a language */
};
/* Opens the output, and writes what stands before the rows. of: the kind of table; note: what its names mean; more: of
 * a table alone; each may be NULL. False: the message is on stderr, exit with EXIT_FILE. */
bool report_open(struct report *r, const char *of, const char *const *columns, const char *note, const char *more);
/* Closes it: the exit code. done: had everything a series? */
enum exit_code report_close(struct report *r, bool done);

/* A motion that rows are about: the period, or a phase from v0 */
struct reported_motion {
  const char *phase, *start; /* its names */
  enum quantity_of of;
  enum scallop_phase_kind kind;
  const fmpq *v0;
};
/* A motion of which nothing is known has its reason in the last column. Returns false. */
bool report_failure(struct report *r, const struct reported_motion *motion, enum scallop_status status,
                    const char *why);

struct reported_sum { /* a quantity of a motion: its terms from the power first to below another */
  const struct reported_motion *motion;
  const char *quantity, *modes;
  slong first, below;
  const char *small;       /* what the powers are of, which stands in the terms; NULL: T, which does not */
  bool is_closed;          /* one term, which is all of it */
  struct symbols *symbols; /* the arguments of a function, and T */
  const symbolic *term;    /* of T^first and on, or NULL: */
  const struct series *series;
  const fmpq *T;           /* of a series: where it is summed, */
  const arb_struct *exact; /* what the sum should be, NULL: it is not known, */
  const char *status;      /* and what is to be said of it */
};
/* A row for each term that is not 0, or one row if all are; or a function or a formula. */
void report_sum(struct report *r, const struct reported_sum *sum);

/* Bits that so many digits take */
static inline slong bits_of_digits(long digits) { return (slong)(3.33 * (double)digits); }
/* sum - exact. With too few digits of the exact value for this, false. */
bool report_error(arb_t error, const arb_t sum, const arb_t exact, slong precision);
/* A cell: a number with so many digits */
void report_ball(struct table *table, const arb_t x, long digits);

#endif
