/* Scenes: files that say which crawler and gait, what varies, and which tables are wanted. docs/scenes.md has the
 * language.
 *
 * A scene is read (read.c) and run: each point of what varies is visited once, and each table gets its rows there.
 * Terms: a variable is a parameter, ratio or label that varies; variables of a group advance together; a product is
 * every combination of its groups; a want is one table.
 *
 * Promises: nothing is computed or written before all of a scene is read and checked; the tables of a scene are
 * replaced together, when all are complete. */
#ifndef SCALLOP_COMPARE_SCENES_SCENE_H
#define SCALLOP_COMPARE_SCENES_SCENE_H

#include "compare/points/counts.h"
#include "compare/answers/points.h"
#include "compare/answers/sheet.h"
#include "compare/config/config.h"
#include "asymptotics/formula.h"
#include "compare/text/plot.h"

enum {
  SCENE_WANTS = 32,
  SCENE_COLUMNS = 60,
  SCENE_NOTES = 16,
  SCENE_TIMES = 4096 /* most periods of an order */
};

enum want_kind { WANT_ROWS, WANT_TRAJECTORY, WANT_ORDERS, WANT_COMMAND };

enum { REFERENCE_NOT_GIVEN = -1, REFERENCE_EXACT, REFERENCE_CERTIFIED };

struct scene_want {
  enum want_kind kind;
  const char *what; /* as it is written */
  const char *file; /* as the command line has it, and NULL: standard output */
  enum format format;
  long digits;
  struct sheet sheet; /* its columns */
  const struct scene *scene;
  double accuracy;           /* errors below this part of the exact value are 0 */
  long periods, samples;     /* trajectory */
  struct sweep_end until;    /* and no further than this time */
  int named, series, source; /* columns and series that are asked for; source: of the usual series */
  const char *name[SCENE_COLUMNS + 1], *series_name[SCENE_COLUMNS];
  long order;            /* of the usual series */
  int reference;         /* what errors are told against */
  int of[SCENE_COLUMNS]; /* orders: the errors of the series, as quantities */
  bool has_expect;
  double expect, tolerance;
  char **arguments; /* of a command: its long options */
  int argument_count;
  bool has_plot;
  struct plot plot;
};

enum scene_start { START_REST, START_STEADY, START_VELOCITY };

struct scene_options {
  struct request request;
  const char *folder; /* below which all files go, or NULL */
  bool check_only, no_plots;
};

struct scene;
/* Makes the table of a want that is another command's, or only reads its options. The command line hands this in, as
 * scenes know no command. */
typedef enum exit_code scene_command(const struct scene *scene, const struct scene_want *want,
                                     const struct scene_options *options, bool only_read);

struct scene {
  char *name;        /* of the file, without folder and .cfg */
  const char *path;  /* of the file, NULL: it comes with the tool, or from standard input */
  const char *title; /* or NULL */
  const char *book;  /* whose formulas are quantities too, or NULL */
  int notes;
  const char *note[SCENE_NOTES];
  struct point base; /* the crawler where nothing varies */
  enum scallop_phase_kind phase;
  enum scene_start start;
  bool varies_v0;
  struct sweep sweep;
  struct asked asked; /* all that its columns take */
  int wants;
  struct scene_want want[SCENE_WANTS];
  bool needs_flint;
  scene_command *run_command;
  struct config config; /* whose texts the above points to */
};

/* Where a scene comes from: a file, or a text that has no folder. */
struct scene_source {
  const char *path; /* for messages, and to read if text is NULL */
  const char *text;
};

/* Reads and checks a scene. options: of the command line; parameters that are given there take the place of the
 * scene's, varied or not. EXIT_DONE, or the exit code, the message being on stderr. */
enum exit_code scene_read(struct scene *scene, const struct scene_source *source, const struct scene_options *options,
                          scene_command *run_command);
void scene_free(struct scene *scene);

/* Runs a scene: opens its tables, visits its points once, closes them and draws the plots. options: of the command
 * line. */
enum exit_code scene_run(const struct scene *scene, const struct scene_options *options);

/* Do tables and plots of these scenes all go to different files, and none to one that is read? Files are told apart by
 * what they are, and not by how a path is spelled. */
enum exit_code scenes_check_files(const struct scene *scenes, int count, const struct scene_options *options);

#endif
