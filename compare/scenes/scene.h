/* Scenes: files that say which crawler and gait, what varies, and what is wanted of it. docs/scenes.md has the language.
 *
 * read.c reads one (libconfig), answers/quantity.c knows what can be wanted, plan.c works out the least work that gives it, run.c does
 * that work. */
#ifndef SCALLOP_SCENE_H
#define SCALLOP_SCENE_H

#include "compare/text/formula.h"
#include "compare/text/plot.h"
#include "compare/command/options.h"
#include "compare/answers/quantity.h"

enum {
  SCENE_GROUPS = 8,
  SCENE_VARIABLES = 8,
  SCENE_PRODUCTS = 16,
  SCENE_WANTS = 32,
  SCENE_COLUMNS = 60,
  SCENE_NOTES = 16,
  SCENE_INCLUDED = 64
};
/* What a table of orders has beside parameters and labels; NULL-terminated. */
extern const char *const order_columns[];

enum { SCENE_RAMP = 1000000, SCENE_TIMES = 4096 }; /* most values of a range; most periods of an order */

/* ---- what varies ---- */

/* What a variable sets. F1_over_F2 and m1_over_m2 keep body 2 as it is; froude sets T when all else is set. */
enum scene_target {
  TARGET_NUMBER, /* m1 m2 F1 F2 L T alpha                                                          */
  TARGET_GAIT,
  TARGET_V0,
  TARGET_F1_OVER_F2,
  TARGET_M1_OVER_M2,
  TARGET_FROUDE,
  TARGET_LABEL /* nothing: a text of its own, for a column                                       */
};

struct scene_end { /* of a range                                                                      */
  bool is_formula; /* of parameters that are set further out, and sticking_onset                     */
  double number;
  struct arithmetic formula;
};

struct scene_variable {
  enum scene_target target;
  int place; /* of a number among the crawler's, of a label among the scene's                    */
  const char *name;
  long count;         /* values; 1: the same throughout its group                                        */
  double *numbers;    /* a list of numbers, or NULL                                                    */
  const char **texts; /* a list of texts: labels, gaits, numbers as they were written (NULL: as a double), or NULL */
  bool is_log;        /* a range                                                                       */
  bool needs_onset;   /* to know its ends                                                              */
  struct scene_end from, to;
};

struct scene_group { /* variables that go on together                                                     */
  int variables;
  struct scene_variable variable[SCENE_VARIABLES];
  long count;
};
struct scene_product { /* every combination of its groups, the first slowest                               */
  int groups;
  struct scene_group group[SCENE_GROUPS];
};

/* ---- what is wanted ---- */

enum want_kind { WANT_ROWS, WANT_TRAJECTORY, WANT_ORDERS, WANT_COMMAND };

struct scene_column {
  const char *name; /* in the table                                                                  */
  int quantity;     /* one as it is, a text perhaps; -1: the formula                                 */
  struct arithmetic formula;
};

struct scene_want {
  enum want_kind kind;
  const char *what; /* as it is written                                                              */
  const char *file; /* NULL: standard output                                                         */
  enum format format;
  long digits;
  int columns;
  struct scene_column *column; /* room for SCENE_COLUMNS                                             */
  bool is_certified;           /* errors against certified values, whatever the accuracy                 */
  double accuracy;             /* rows and orders with errors: they are told down to this part of the exact value */
  long periods, samples;       /* trajectory                                                              */
  struct scene_end until;      /* and no further than this time                                              */
  int series;                  /* orders: of the errors of these                                             */
  int of[SCENE_COLUMNS];       /* the errors, as quantities                                                  */
  bool has_expect;
  double expect, tolerance;
  const struct command *command; /* a command, run at each point ...                                         */
  char **arguments;              /* ... with these, NULL-terminated, and the parameters of the point             */
  int argument_count;
  bool has_plot;
  struct plot plot; /* but for table, title and common                                          */
};

/* ---- a scene ---- */

enum scene_start { START_REST, START_STEADY, START_VELOCITY };

struct scene {
  char *name;       /* of the file, without folder and .cfg                                        */
  const char *path; /* of the file, NULL: it comes with the tool, or from standard input            */
  int included;     /* files that it includes                                                        */
  const char *include[SCENE_INCLUDED];
  const char *title; /* or NULL                                                                     */
  int notes;
  const char *note[SCENE_NOTES];
  struct options base; /* the crawler where nothing varies                                            */
  enum scallop_phase_kind phase;
  enum scene_start start;
  bool varies_v0;
  int products; /* one after the other; at least one, which may have no groups: one point       */
  struct scene_product *product;
  struct quantities quantities; /* all that are used                                               */
  int wants;
  struct scene_want want[SCENE_WANTS];
  struct config_t *file; /* libconfig's, whose texts the above points to                                     */
  struct kept *kept;     /* and other texts                                                              */
};

/* Where a scene comes from: a file, or a text that has no folder. */
struct scene_source {
  const char *path; /* for messages, and to read if text is NULL                                    */
  const char *text;
};

/* Reads and checks a scene. options: of the command line; parameters that are given there take the place of the scene's, varied or not.
 * EXIT_DONE, or the exit code, the message being on stderr. */
enum exit_code scene_read(struct scene *scene, const struct scene_source *source, const struct options *options);
void scene_free(struct scene *scene);

/* The quantities of a column: that one, or those of its formula. Returns how many. */
int scene_column_quantities(const struct scene_column *column, int places[ARITHMETIC_STEPS]);

/* The parameter that a variable sets: F1 for F1_over_F2, T for froude; its own name for others. */
const char *scene_variable_sets(const struct scene_variable *variable);
/* The variables of all products, one after another: number i, or NULL after the last. */
const struct scene_variable *scene_variable(const struct scene *scene, int i);

/* Points of the scene: the products of its groups, one after the other. */
long scene_points(const struct scene *scene);
long scene_product_points(const struct scene_product *product);

#endif
