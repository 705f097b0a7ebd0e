/* What a long computation has found so far, in a file: the same command goes on from there if something ends it.
 *
 * A line each: the number of an item, its values as hexadecimal doubles, and a checksum, so that a line of which only a part was
 * written, or something else in its place, is seen. The first line says of which computation it is, with all that its values
 * depend on; the journal of another computation is neither used nor touched. */
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

struct journal {
  char *path;
  FILE *stream;
  int error; /* errno of the first write that failed, or 0                                     */
};

/* One item that was found: number in [0, items), count values. False: no such item; the journal ends before it. */
typedef bool journal_taker(void *context, long number, int count, const double *values);

/* Opens the journal at path, or begins one. title: one line that says which computation it is. Values are nan, infinite or finite; at
 * most JOURNAL_VALUES an item. */
enum { JOURNAL_VALUES = 64 };
enum journal_outcome journal_open(struct journal *journal, const char *path, const char *title, journal_taker *take,
                                  void *context);
/* Adds an item, in one write. Not for two threads at once. False: it failed, now or before; error says why. */
bool journal_add(struct journal *journal, long number, int count, const double *values);
/* Closes it; done: and removes it. */
void journal_close(struct journal *journal, bool done);

#endif
