/* Gaits by their names on the command line: NAME or NAME:NUMBERS for the families of model/families.h, and
 * measured:FILE, a table of t and l through which a spline is laid. */
#ifndef SCALLOP_COMPARE_POINTS_GAITS_H
#define SCALLOP_COMPARE_POINTS_GAITS_H

#include "model/families.h"
#include "model/measured/measured.h"

/* The families, measured last: i = 0, 1, ...; NULL after the last. */
const struct scallop_gait_family *gait_family(int i);

/* The text of a gait is shorter than this, with "--gait " before it. */
enum { GAIT_TEXT = 4096 };

enum gait_fault { GAIT_FINE, GAIT_UNKNOWN, GAIT_UNREADABLE };
struct gait_answer {
  /* its name is the text; it lives until the program ends, and the same text gives the same one */
  const struct scallop_gait *gait;
  enum gait_fault
      fault;         /* UNREADABLE: a file could not be read at all                                                */
  const char *wrong; /* what is wrong, where gait is NULL; lives until the next call                             */
};
struct gait_answer gait_of_text(const char *text);

/* Does text begin with the name of a family, up to a colon, a comma or its end? */
bool gait_family_begins(const char *text);

/* A measured gait has an amplitude, a period and a fraction of it for the extension of its own. NULL: this is none. */
const struct gait_file *gait_file_of(const struct scallop_gait *gait);
/* Gives the crawler one of the gaits that its recording admits as well, 0 <= i < SCALLOP_MEASURED_OTHERS, and that
 * gait's L, T and alpha where it has those of the recording. False: there is none, or the gait is not measured.
 * From any thread. */
bool gait_exchange(struct scallop_crawler *crawler, int i);

/* What a gait was made of, for those who want more digits of its numbers than doubles have. */
struct gait_source {
  const struct scallop_gait_family *family;
  const char *number[SCALLOP_GAIT_NUMBERS]; /* as they were written, or the usual ones */
  int count;                                /* of them */
  void *kept;                               /* NULL at first: what is worked out once for this gait; it is freed by */
  void (*discard)(void *kept);              /* this, when the program ends */
};
/* NULL: it is none of those that were made of numbers. A measured gait is exactly its doubles. */
struct gait_source *gait_source_of(const struct scallop_gait *gait);

/* How often l' changes its sign within the phases: of a measured gait, seldom by intention. */
int gait_reversals(const struct scallop_gait *gait);

/* Whether l'' is not 0 where the phases begin and end: else the published formulas, which divide by it there, have no
 * value. */
bool gait_has_ends(const struct scallop_gait *gait);
extern const char gait_no_ends[]; /* that, as a status */

#endif
