/* What the commands ask of the parts that need FLINT.
 *
 * `scallop` itself is linked without FLINT, so that a command that needs none does not load it. A command that does is
 * handed over to `scallop-flint`, the same program linked with it, which stands beside (hand_over.c). A build with
 * WITH_FLINT=0 has no such program, and these commands say what is missing. */
#ifndef SCALLOP_WITH_FLINT_H
#define SCALLOP_WITH_FLINT_H

#include "compare/command/compare.h"

/* True: FLINT is here, go on. Where it is not, the other program takes over and this does not return; or, if there is none, false,
 * with the message on stderr. To be called before anything is read or written. what needs it: "--certified". */
bool has_flint(const struct options *options, const char *what);

/* Digits of certified numbers unless --digits is given */
#define CERTIFIED_DIGITS 30

/* series --source derived|limit and series --bound */
enum exit_code series_derived(const struct options *options);

/* The ledger */
enum exit_code claims_table(const struct options *options);

/* Error against run time. The periods unless --T is given, and the seconds unless --limit is; the second of each with --quick */
#define WORKPREC_T 1, 0.1, 0.01, 1e-3, 1e-4
#define WORKPREC_QUICK_T 0.5, 0.01
#define WORKPREC_LIMIT 1
#define WORKPREC_QUICK_LIMIT 0.05
enum exit_code workprec_table(const struct options *options);

/* Digits that survive: a table of families, one point, and friction smoothed for stiff solvers. Cases unless --cases is given */
#define STRESS_CASES 1000
#define STRESS_CHECK_STEADY 4
#define STRESS_CHECK_PHASES 30
#define STRESS_FULL_CASES 5000
enum exit_code stress_table(const struct options *options);
enum exit_code stress_point(const struct options *options);
enum exit_code stress_stiff(const struct options *options);

#endif
