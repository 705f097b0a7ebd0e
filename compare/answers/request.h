/* Requests: the points, the quantities and the output of a command, and the lines about them in the head of a table.
 * The options of a command are a struct that begins with a request. */
#ifndef SCALLOP_COMPARE_ANSWERS_REQUEST_H
#define SCALLOP_COMPARE_ANSWERS_REQUEST_H

#include "compare/points/gaits.h"
#include "compare/points/sweep.h"
#include "compare/text/message.h"
#include "compare/tables/table.h"
#include "compare/text/values.h"

enum { MAX_NOTES = 16 };
struct requirements;         /* answers/quantities.h */
struct scene_head {          /* the head of the tables of a scene */
  const char *scene, *title; /* title may be NULL */
  int notes;
  const char *note[MAX_NOTES];
  bool is_about_phase;       /* the scene sets a phase or its start */
  const struct point *given; /* parameters of the command line; they override the scene */
};

struct request {
  struct style style;
  struct point point;
  struct shard {
    long part, parts; /* parts 0: the whole sweep */
    char sweep[17];   /* name of the sweep, shard.h */
  } shard;
  bool skip_complete; /* skips a shard that is complete */
  struct samples {
    enum sampling sampling;
    long count;
    uint64_t seed;
  } samples;                     /* samples of the ranges without a count */
  struct sweep sweep;            /* the variables; without a product the only point is `point` */
  const char *points;            /* file name, "-" for standard input, or NULL */
  const char *formulas;          /* name of a formula file, or NULL */
  struct optional_number smooth; /* noise of a measured gait's recording */
  struct optional_count threads;
  bool stats;                      /* print the counts of computations at the end */
  struct optional_number accuracy; /* errors of series below this part of the exact value are 0 */
  struct optional_word reference;  /* of errors: exact, or certified */
  struct requirements *required;   /* quantities of the tables of points; NULL: no such table */
  const struct scene_head *scene;  /* or NULL */
};

/* Returns true if the request has, or may have, several points. */
static inline bool has_many_points(const struct request *r) { return r->points || r->sweep.products > 0; }
/* Returns true if the parameter is the same in all rows. */
bool is_constant(const struct request *request, const char *parameter);

/* Writes " m1=1 ...", the crawler's parameters except excluded (NULL-terminated, or NULL). as_written: numbers with all
 * given digits; else doubles. Returns text. */
enum { PARAMETERS_TEXT = CRAWLER_NUMBERS * (NUMBER_LENGTH + 8) + GAIT_TEXT };
const char *parameters_text(char text[PARAMETERS_TEXT], const struct point *point, const char *const *excluded,
                            bool as_written);
/* Writes the line "# parameters: m1=1 ...", unless it would be empty. */
void note_parameters(struct table *table, const struct point *point, const char *const *excluded, bool as_written);

/* Prints the columns and the fitted curve of the recording if the gait is measured. */
void print_recording(const struct point *point, const struct style *style);

/* Prints a note that a list like "1,5" is two values, not a decimal fraction. */
void print_decimal_commas(const struct sweep *sweep, const struct style *style);

#endif
