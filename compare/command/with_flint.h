/* What the commands ask of the parts that need FLINT.
 *
 * `scallop` is linked without FLINT, so that a command that needs none does not load it. A command that does is handed over to
 * `scallop-flint`, the same program linked with it, which stands beside (hand_over.c). A build with WITH_FLINT=0 has no such
 * program, and these commands print what is missing. */
#ifndef SCALLOP_WITH_FLINT_H
#define SCALLOP_WITH_FLINT_H

#include "compare/answers/quantities.h"
#include "compare/command/compare.h"

/* True: FLINT is here, go on. Where it is not, the other program takes over and this does not return; or, if there is none, false,
 * with the message on stderr. To be called before anything is read or written. what needs it: "--certified". */
bool has_flint(const struct options *options, const char *what);

struct answer;
struct point;
typedef enum exit_code table_of(const struct options *options);

/* To be called where has_flint. Weak: `scallop` is linked without this table, and its address is NULL there. */
extern const struct with_flint {
  bool (*answer_in_decimals)(struct answer *answer, char *texts[QUANTITIES], const struct point *point, enum quantity_of of,
                             long digits, const char **why);
  void (*decimals_free)(char *texts[QUANTITIES]);
  table_of *series, *claims, *workprec, *stress, *stress_point, *stress_stiff, *breakdown, *map, *boundaries;
} with_flint __attribute__((weak, visibility("hidden")));

/* series --source derived|limit and series --bound */
enum exit_code series_derived(const struct options *options);

#endif
