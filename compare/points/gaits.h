/* Gaits by their names on the command line: NAME or NAME:NUMBERS for the families of model/families.h, and
 * measured:FILE, a spline through a table of t and l. */
#ifndef SCALLOP_COMPARE_POINTS_GAITS_H
#define SCALLOP_COMPARE_POINTS_GAITS_H

#include "model/families.h"
#include "model/measured/measured.h"

/* Returns family i = 0, 1, ..., `measured` last; NULL after the last. */
const struct scallop_gait_family *gait_family(int i);

/* The maximum size of "--gait " and the text of a gait */
enum { GAIT_TEXT = 4096 };

enum gait_fault { GAIT_FINE, GAIT_UNKNOWN, GAIT_UNREADABLE };
struct gait_result {
  /* its name is the text; valid until the program ends; equal texts return the same gait */
  const struct scallop_gait *gait;
  enum gait_fault fault; /* UNREADABLE: the file could not be read                */
  const char *wrong;     /* the error if gait is NULL, valid until the next call */
};
struct gait_result gait_of_text(const char *text);

/* Returns true if text begins with the name of a family, up to a colon, a comma or the end of text. */
bool gait_family_begins(const char *text);

/* Returns the recording of a measured gait, with its own L, T and alpha; NULL for another gait. */
const struct gait_file *gait_file_of(const struct scallop_gait *gait);
/* Replaces the crawler's gait by alternative i of its recording, 0 <= i < SCALLOP_MEASURED_OTHERS; also L, T and alpha
 * if they equal the recording's. Returns false if the gait has no such alternative or is not measured. Thread-safe. */
bool gait_exchange(struct scallop_crawler *crawler, int i);

/* The family and the numbers of a gait, with all given digits */
struct gait_source {
  const struct scallop_gait_family *family;
  const char *number[SCALLOP_GAIT_NUMBERS]; /* as given, or the defaults */
  int count;                                /* of the numbers */
  void *kept;                               /* data that a user of the gait derives once; NULL at first */
  void (*discard)(void *kept);              /* frees it when the program ends */
};
/* Returns NULL if the gait is not made from numbers. A measured gait is exactly its doubles. */
struct gait_source *gait_source_of(const struct scallop_gait *gait);

/* Returns how often l' changes its sign within the phases: in a measured gait mostly noise. */
int gait_reversals(const struct scallop_gait *gait);

/* Returns true if l'' is not 0 at the ends of the phases. The published formulas divide by these values. */
bool gait_has_ends(const struct scallop_gait *gait);
extern const char gait_no_ends[]; /* the status if l'' is 0 there */

#endif
