/* What the commands ask of the parts that need FLINT.
 *
 * `scallop` is linked without FLINT, so that a command that needs none does not load it. A command that does is handed over to
 * `scallop-flint`, the same program linked with it, which stands beside. A build with WITH_FLINT=0 has no such program, and
 * these commands print what is missing. */
#ifndef SCALLOP_WITH_FLINT_H
#define SCALLOP_WITH_FLINT_H

#include "compare/command/compare.h"

/* True: FLINT is here, go on. Where it is not, the other program takes over and this does not return; or, if there is none, false,
 * with the message on stderr. To be called before anything is read or written. what needs it: "--certified". */
bool has_flint(const struct options *options, const char *what);

/* To be called where has_flint. Weak: `scallop` has no such table, and its address is NULL there. */
extern const struct with_flint {
  const char *(*phase_row)(struct table *, const struct options *);
  const char *(*steady_row)(struct table *, const struct options *);
  enum exit_code (*series)(const struct options *);
  enum exit_code (*claims)(const struct options *);
  enum exit_code (*workprec)(const struct options *);
  enum exit_code (*stress)(const struct options *);
  enum exit_code (*stress_point)(const struct options *);
  enum exit_code (*stress_stiff)(const struct options *);
  enum exit_code (*breakdown)(const struct options *);
  enum exit_code (*map)(const struct options *);
  enum exit_code (*boundaries)(const struct options *);
} with_flint __attribute__((weak));

#endif
