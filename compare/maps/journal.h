/* What a long computation has found so far, in a file: the same command resumes from there.
 *
 * The first line is a title, with all that the values depend on; the journal of another computation is neither used nor touched. Each
 * further line has the number of an item, its values as hexadecimal doubles, and a checksum, so that a damaged or half-written line is
 * noticed: the journal ends before it. */
#ifndef SCALLOP_JOURNAL_H
#define SCALLOP_JOURNAL_H

#include <stdbool.h>
#include <stdio.h>

enum journal_outcome {
  JOURNAL_NEW,   /* there was none                                                               */
  JOURNAL_FOUND, /* and its items were given to take                                              */
  JOURNAL_OTHER, /* of another computation, or no journal: left as it is                          */
  JOURNAL_BUSY,  /* another process is at work on it                                              */
  JOURNAL_ERROR  /* errno says why                                                                */
};
enum { JOURNAL_VALUES = 64 }; /* of an item, at most                                                */

struct journal {
  char *path;
  FILE *stream;
  int error; /* errno of the first write that failed, or 0                                     */
};

/* Takes an item of a journal. False: there is no such item; the journal ends before it. */
typedef bool journal_taker(void *context, long number, int count, const double *values);

enum journal_outcome journal_open(struct journal *journal, const char *path, const char *title, journal_taker *take,
                                  void *context);
/* Adds an item, in one write; not for two threads at once. False: this or an earlier write failed. */
bool journal_add(struct journal *journal, long number, int count, const double *values);
/* Closes the journal; done: and removes it. */
void journal_close(struct journal *journal, bool done);

#endif
