/* What `scallop series` writes of derived series: a table, or a function of T in Python or a formula in LaTeX for each
 * quantity. Needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_EMIT_FLINT_H
#define SCALLOP_COMPARE_COMMAND_EMIT_FLINT_H

#include "asymptotics/symbolic/language.h"
#include "compare/answers/quantities.h"
#include "compare/command/series_options.h"
#include "model/exact/scoped.h"

struct report {
  const struct series_options *options;
  const struct scallop_rational_crawler *crawler; /* as it was written                                             */
  const fmpq *v0;
  long digits;                     /* of decimal numbers                                              */
  const struct language *language; /* NULL: a table                                                     */
  char why[240];                   /* the first that could not be done: the reason                     */
  struct table table;
  struct file out;
  bool any; /* has the quantity that is being written a term yet?                */
};
/* Opens the output, and writes what stands before the rows. of: the kind of table; note: what its names mean; more: of
 * a table alone; either NULL. False: the message is on stderr, exit with EXIT_FILE. */
bool report_open(struct report *r, const char *of, const char *const *columns, const char *note, const char *more);
/* Closes it: the exit code. done: had everything a series? */
enum exit_code report_close(struct report *r, bool done);
/* Calls one with a report about the options. */
enum exit_code report_run(const struct series_options *options, enum exit_code (*one)(struct report *r));

/* A motion that rows are about: its names, the period or a phase from rest or from v0 */
struct motion_names {
  const char *phase, *start;
  enum quantity_of of;
  enum scallop_phase_kind kind;
  bool from_v0;
};
extern const struct motion_names steady_motion;
void write_names(struct report *r, const struct motion_names *names, const char *quantity);
/* A motion of which nothing is known has its reason in the last column. Returns false. */
bool write_failure(struct report *r, const struct motion_names *names, enum scallop_status status, const char *why);
/* Calls one for each phase, from rest and from v0, and for the steady state. Did all give true? */
bool report_motions(struct report *r, bool (*one)(struct report *r, const struct motion_names *motion));

struct emitted { /* a quantity of a motion as a sum of terms                                             */
  struct motion_names names;
  const char *quantity, *modes;
  const struct symbols *symbols; /* its arguments but T are those of used[]; NULL: there are none     */
  bool used[MOST_SYMBOLS];
  slong below;       /* the power of T, or of small, from which on terms are left out, 0: none is */
  const char *small; /* NULL: a function of T                                                  */
};
/* What stands before the terms, each of them, which frees its text, and what stands behind */
void emit_begin(struct report *r, const struct emitted *emitted);
void emit_term(struct report *r, struct written term);
void emit_end(struct report *r, const struct emitted *emitted);

#endif
