/* What every command is asked: of which points, and how its table is written; and what of these stands in the head of a
 * table. The options of a command are a struct that begins with a request. */
#ifndef SCALLOP_COMPARE_ANSWERS_REQUEST_H
#define SCALLOP_COMPARE_ANSWERS_REQUEST_H

#include "compare/points/gaits.h"
#include "compare/points/sweep.h"
#include "compare/text/message.h"
#include "compare/tables/table.h"
#include "compare/text/values.h"

enum { MOST_NOTES = 16 };
struct asked;                /* answers/at.h */
struct scene_head {          /* of the tables of a scene */
  const char *scene, *title; /* title: or NULL */
  int notes;
  const char *note[MOST_NOTES];
  bool is_about_phase;       /* the scene says something of a phase or of its start */
  const struct point *given; /* on the command line, in place of what the scene says */
};

struct request {
  struct style style;
  struct point point;
  struct shard {
    long part, parts; /* parts 0: the whole sweep */
    char sweep[17];   /* which one: its name      */
  } shard;
  bool skip_complete; /* a shard that is there   */
  struct samples {
    enum sampling sampling;
    long count;
    uint64_t seed;
  } samples;                      /* of the ranges without a count */
  struct sweep sweep;             /* what varies; no product: one point, else point is where nothing varies */
  const char *points;             /* file name, "-" for standard input, or NULL */
  const char *formulas;           /* file name of a formula file, or NULL     */
  struct given_number smooth;     /* the noise of a measured gait's recording, which is read with it */
  struct given_count threads;     /* on how many rows are computed */
  bool stats;                     /* prints afterwards what was computed */
  struct given_number accuracy;   /* errors of series below this part of the exact value are 0 */
  struct given_word reference;    /* what they are errors against: exact, or certified */
  struct asked *asked;            /* by the tables with a row for each point; NULL: by none */
  const struct scene_head *scene; /* or NULL */
};

/* Are there, or may there be, many points? */
static inline bool has_many_points(const struct request *r) { return r->points || r->sweep.products > 0; }
/* Is the parameter the same in all rows? */
bool is_held(const struct request *request, const char *parameter);

/* " m1=1 ...": the crawler's parameters but those in not_held (NULL-terminated, or NULL: none), which vary or are not
 * used. as_written: numbers with all the digits that were given; else doubles. Returns text. */
enum { PARAMETERS_TEXT = CRAWLER_NUMBERS * (NUMBER_LENGTH + 8) + GAIT_TEXT };
const char *parameters_text(char text[PARAMETERS_TEXT], const struct point *point, const char *const *not_held,
                            bool as_written);
/* "# parameters: m1=1 ...", or no line where there is none. */
void note_parameters(struct table *table, const struct point *point, const char *const *not_held, bool as_written);

/* Prints what a recording was taken for, where the gait is measured, and what was laid through it. */
void point_tell_recording(const struct point *point, const struct style *style);

/* Says of a list as "1,5" that it is two values, and no decimal fraction. */
void tell_decimal_commas(const struct sweep *sweep, const struct style *style);

#endif
