/* The arguments of the command line, as read. What the options are: compare/command/option_table.h. */
#ifndef SCALLOP_OPTIONS_H
#define SCALLOP_OPTIONS_H

#include <stdbool.h>

#include "compare/text/values.h"
#include "compare/text/words.h"
#include "model/model.h"

struct command;

enum format { FORMAT_TSV, FORMAT_JSON };

struct options {
  const struct command *command;
  char **arguments; /* of the program, all of them, NULL-terminated                     */
  struct scallop_crawler crawler;
  const char *written[7]; /* m1 m2 F1 F2 L T alpha as they were written, NULL where not given  */
  enum scallop_phase_kind phase;
  double v0;
  const char *written_v0;
  const char *start;     /* trajectory: "rest", "steady" or a number                        */
  double start_velocity; /* that number                                                     */
  const char *points;    /* file name, "-" for standard input, or NULL                      */
  const char *errors;    /* claims: the names whose errors are wanted, or NULL               */
  bool check;            /* claims: compare the verdicts with an earlier ledger; stress       */
  const char *against;   /* claims: that ledger, NULL: the one that comes with the tool       */
  const char *source;    /* series: "published", "derived" or "limit"                        */
  long order;            /* series: terms below T^order                                      */
  bool bound, certified;
  const char *operand;   /* the first of them, or NULL                                         */
  const char **operands; /* all, in the order they were given                                 */
  int operand_count;
  const char *output; /* NULL: standard output                                           */
  const char *folder; /* run: where files without a folder go, or NULL                      */
  struct table *into; /* the table to continue in place of output, or NULL               */
  enum format format;
  long digits; /* significant digits; 0: as many as read back exactly             */
  long periods, samples;
  double expect, tolerance;
  const char *from;                          /* workprec: a table to summarise, or NULL                              */
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
  bool unreadable;                           /* the file of a measured gait                                     */
  bool has_expect, has_phase, has_v0, has_seed, has_gait, has_source, has_order, has_tolerance, has_output, has_format,
      quiet;
};

/* A named parameter of a point: m1 m2 F1 F2 L T alpha gait, and phase v0 where they apply. Sets it
 * from text. Returns NULL, or what is wrong with the text. The message lives until the next call. */
const char *options_set_parameter(struct options *options, const char *name, const char *text);

/* Names of the parameters that describe a crawler, NULL-terminated: first the numbers, then the gait. */
enum { CRAWLER_NUMBERS = 7 };
extern const char *const crawler_parameters[];
/* One of the numbers by its name. */
double crawler_parameter(const struct scallop_crawler *crawler, const char *name);
/* For many points: all numbers in that order; the place of one, or CRAWLER_NUMBERS where it is none; options_set_parameter
 * by place. */
void crawler_numbers(const struct scallop_crawler *crawler, double numbers[CRAWLER_NUMBERS]);
int crawler_place(const char *name);
const char *options_set_crawler_number(struct options *options, int place, const char *text);

/* Sets L, T and alpha where they are not written: those of the table of a measured gait, or the usual ones. After the last
 * parameter is set. */
void options_complete(struct options *options);

/* What holds where no option is given. options_free has nothing to do for it. */
void options_initial(struct options *options, const struct command *command);

/* Reads arguments[2], ... : those after the command's name. True: run it. False: *code is the exit code (help was
 * asked for, or the message is on stderr). Whichever it is, options_free ends it. */
bool options_read(struct options *options, const struct command *command, int count, char **arguments, int *code);
void options_free(struct options *options);

#endif
