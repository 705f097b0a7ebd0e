/* What `scallop series` writes of derived series: a table, or for each quantity a function of T in Python or a formula
 * in LaTeX. Needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_REPORT_FLINT_H
#define SCALLOP_COMPARE_COMMAND_REPORT_FLINT_H

#include "asymptotics/symbolic/language.h"
#include "compare/answers/quantities.h"
#include "compare/command/series.h"

struct report;
struct reported_motion { /* the period, or a phase from v0, by the names that it has in rows */
  const char *phase, *start;
  enum quantity_of of;
  enum scallop_phase_kind kind;
  const fmpq *v0;
};
struct report_kind {
  const char *options; /* that ask for it */
  bool has_order;      /* --order, too */
  const char *of;      /* the kind of its picture */
  const char *columns[9], *meaning;
  bool has_phases; /* of each phase, from rest and from v0, and then of the steady state: else of that alone */
  bool (*write)(struct report *r, const struct reported_motion *motion); /* false: report_failure has been called */
};
struct report {
  const struct report_kind *kind;
  const struct series_options *options;
  const struct scallop_rational_crawler *crawler; /* as it was written */
  long digits;                                    /* of decimal numbers */
  const struct language *language;                /* NULL: a table */
  char why[240];                                  /* the first motion that has no series: the reason */
  struct table table;
  struct file out; /* of a language */
};
/* Opens the output, and writes what stands before the rows. False: the message is on stderr, exit with EXIT_FILE. */
bool report_open(struct report *r);
/* Closes it: the exit code. done: had everything a series? */
enum exit_code report_close(struct report *r, bool done);

/* A motion of which nothing is known has its reason in the last column. Returns false. */
bool report_failure(struct report *r, const struct reported_motion *motion, enum scallop_status status,
                    const char *why);

struct reported_sum { /* a quantity of a motion: its terms from the power first to below another */
  const struct reported_motion *motion;
  const char *quantity, *modes;
  const struct series *series;
  slong first, below;
  const char *small;       /* what the powers are of, which stands in the terms; NULL: T, which does not */
  bool is_closed;          /* one term, which is all of it */
  struct symbols *symbols; /* of the coefficients, the arguments of a function; of numbers T alone */
  slong precision;         /* of numbers: bits of the sums */
  const arb_struct *T;     /* where they are summed */
  const arb_struct *exact; /* what the sum should be; NULL: it is not known */
  const char *status;      /* and what is to be said of it */
};
/* A row for each term that is not 0, or one row if all are; or a function or a formula. */
void report_sum(struct report *r, const struct reported_sum *sum);
/* A cell: a number with so many digits; NULL: nan */
void report_ball(struct table *table, const arb_struct *x, long digits);

/* Bits that so many digits take */
static inline slong bits_of_digits(long digits) { return (slong)(3.33 * (double)digits); }

#endif
