/* What the commands ask of the parts that need FLINT.
 *
 * `scallop` is linked without FLINT, so that a command that needs none does not load it. A command that does is handed over to
 * `scallop-flint`, the same program linked with it, which stands beside (hand_over.c). A build with WITH_FLINT=0 has no such
 * program, and these commands print what is missing. */
#ifndef SCALLOP_WITH_FLINT_H
#define SCALLOP_WITH_FLINT_H

#include "compare/answers/quantities.h"
#include "compare/text/message.h"

/* True: FLINT is here, go on. Where it is not, the other program takes over and this does not return; or, if there is none, false,
 * with the message on stderr. To be called before anything is read or written. what needs it: "--certified". */
struct arguments;
bool has_flint(const struct arguments *arguments, const char *what);

struct answer;
struct point;
struct series_options;
struct claims_options;
struct workprec_options;
struct stress_options;
struct breakdown_options;

/* To be called where has_flint. Weak: `scallop` is linked without this table, and its address is NULL there. */
extern const struct with_flint {
  bool (*answer_in_decimals)(struct answer *answer, char *texts[QUANTITIES], const struct point *point, enum quantity_of of,
                             long digits, const char **why);
  void (*decimals_free)(char *texts[QUANTITIES]);
  enum exit_code (*series)(const struct series_options *);
  enum exit_code (*claims)(const struct claims_options *);
  enum exit_code (*workprec)(const struct workprec_options *);
  enum exit_code (*stress)(const struct stress_options *);
  enum exit_code (*stress_point)(const struct stress_options *);
  enum exit_code (*stress_stiff)(const struct stress_options *);
  enum exit_code (*breakdown)(const struct breakdown_options *);
  enum exit_code (*map)(const struct breakdown_options *);
  enum exit_code (*boundaries)(const struct breakdown_options *);
} with_flint __attribute__((weak, visibility("hidden")));

#endif
