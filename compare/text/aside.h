/* A file that is written aside: nobody sees it before it is complete, and what had its name before stays until then.
 *
 * Where the system knows files without a name (Linux: O_TMPFILE, and /proc to name one through), this one has none until its
 * last byte is on the disk: whatever ends the process, SIGKILL included, the system takes it away. It then gets its name in
 * one step; if an earlier file has that name, in two, TARGET.PID.N.part and the renaming, between which only SIGKILL or a
 * power cut can come. Elsewhere it is TARGET.PID.N.part from the start, and every signal that would end the process removes
 * it first.
 *
 * Several can be open at once, each kept or dropped by itself, in a process with one thread. Those that have a name from the
 * start are ASIDE_NAMED at most: what a signal removes is noted in so many places. Those without one are as many as
 * descriptors allow, two each. */
#ifndef SCALLOP_ASIDE_H
#define SCALLOP_ASIDE_H

#include <stdbool.h>
#include <stdio.h>

enum { ASIDE_NAMED = 64 };

struct aside {
  FILE *file;   /* to write to                                                                    */
  char *target; /* the file it becomes, through any link                                          */
  char *name;   /* room for its own name in the same folder                                       */
  int unnamed;  /* another descriptor of it while it has no name; -1: it had one from the start */
};

/* Opens a file that is to become output. If there is such a file, it must be plain and writable, and its permissions are taken over.
 * False: errno says why (EMFILE: too many are open), and nothing is left to close. */
bool aside_open(struct aside *aside, const char *output);
/* Closes it and puts it in its place, once all of it is on the disk: after a power cut there is the earlier file or this one, never
 * an empty one. False: errno says why, the earlier file stays, and nothing else is left. */
bool aside_keep(struct aside *aside);
/* Closes it: nothing is left. */
void aside_drop(struct aside *aside);

#endif
