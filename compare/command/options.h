/* The arguments of the command line, as read. What the options are: compare/command/option_table.h. */
#ifndef SCALLOP_OPTIONS_H
#define SCALLOP_OPTIONS_H

#include <stdbool.h>

#include "compare/text/values.h"
#include "compare/answers/point.h"
#include "compare/text/message.h"

struct command;

enum format { FORMAT_TSV, FORMAT_JSON };

struct options {
  const struct command *command;
  char **arguments; /* of the program, all of them, NULL-terminated                     */
  struct point point;
  const char *start;     /* trajectory: "rest", "steady" or a number                        */
  double start_velocity; /* that number                                                     */
  const char *points;    /* file name, "-" for standard input, or NULL                      */
  const char *errors;    /* claims: the names whose errors are wanted, or NULL               */
  bool check;            /* claims: compare the verdicts with those of the tool's ledger; stress       */
  const char *source;    /* series: "published", "derived" or "limit"                        */
  long order;            /* series: terms below T^order                                      */
  bool bound, certified;
  const char *operand;   /* the first of them, or NULL                                         */
  const char **operands; /* all, in the order they were given                                 */
  int operand_count;
  const char *output; /* NULL: standard output                                           */
  const char *folder; /* run: where files without a folder go, or NULL                      */
  enum format format;
  long digits; /* significant digits; 0: as many as read back exactly             */
  long periods, samples;
  double expect, tolerance;
  const char *family;                        /* stress: the only family, or NULL                                    */
  long cases, seed;                          /* stress: of each family, 0: as many as is usual; of their parameters   */
  bool full, stiff, error;                   /* stress; steady and phase                                          */
  const char *quantity;                      /* breakdown: the only one, or NULL                                     */
  const char *only;                          /* breakdown: the only kind of rows, or NULL                            */
  const char *map[2];                        /* breakdown: what varies along x and along y, or NULL                  */
  const char *range[2];                      /* breakdown: FROM:TO:COUNT of x and of y, or NULL                      */
  bool boundaries;                           /* breakdown: the curves between the regions of a map                    */
  double limit;                              /* workprec: seconds for each setting; 0: not given                   */
  bool quick, summary;                       /* workprec                                                       */
  bool check_only, explain, stats, no_plots; /* run                                                      */
  bool has_expect, has_seed, has_source, has_order, has_tolerance, has_output, has_format, quiet;
};

/* What holds where no option is given. options_free has nothing to do for it. */
void options_initial(struct options *options, const struct command *command);

/* Reads arguments[2], ... : those after the command's name. True: run it. False: *code is the exit code (help was
 * asked for, or the message is on stderr). Whichever it is, options_free ends it. */
bool options_read(struct options *options, const struct command *command, int count, char **arguments, int *code);
void options_free(struct options *options);

#endif
