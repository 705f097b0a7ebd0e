/* compare/: the harness. It sets the exact periods of numerics/ beside the series of asymptotics/,
 * measures orders, keeps the ledger of claims, makes the figures' tables, and holds the command line.
 * Output, arguments and files live in this room alone.
 */
#ifndef SCALLOP_COMPARE_H
#define SCALLOP_COMPARE_H

#include "compare/command/options.h"
#include "compare/text/message.h"
#include "compare/text/table.h"
#include "numerics/numerics.h"

/* The text of what a macro stands for, so that --help tells the numbers that are used */
#define TEXT_OF(...) TEXT_OF_WRITTEN(__VA_ARGS__)
#define TEXT_OF_WRITTEN(...) #__VA_ARGS__

/* What a command does where options are not given, if that is not to take the value that struct options begins with. */
struct unless_given {
  const char *options; /* names, separated by blanks; NULL ends a list                                       */
  const char *text;    /* in which %s stands for that value                                                  */
};

/* One command: `scallop NAME`. */
struct command {
  const char *name;
  const char *summary;                     /* one line                                                        */
  const char *example;                     /* what `--help` shows first                                       */
  const char *operand;                     /* "FILE", or NULL if there is none                                */
  const char *const *accepts;              /* names of the options it takes, NULL-terminated                  */
  const char *about;                       /* what the columns mean                                           */
  const struct scallop_crawler *defaults;  /* NULL: scallop_crawler_default()                                 */
  const struct unless_given *unless_given; /* NULL: nothing of that kind                                      */
  const char *proven; /* where its numbers are proven and --digits goes beyond 17: "with --certified"; NULL: nowhere */
  enum exit_code (*run)(const struct options *);
};

extern const struct command command_phase, command_steady, command_trajectory, command_series, command_claims, command_order,
    command_figure, command_workprec, command_stress, command_breakdown, command_run;
/* All commands, NULL-terminated. */
extern const struct command *const commands[];

#endif
