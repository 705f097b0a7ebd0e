/* The passages of a command's about text, which is broken into lines by these conventions:
 *
 *     Text begins a passage after an empty line, and on a line of its own behind a sentence that is about a name.
 *     name: text           begins one where the line before ends a sentence; name is an option or columns, in lower case.
 *                          A single column may begin one within a line.
 *     Columns: a; b; c.    does so too, and within a passage is a sentence of its own
 *       name   text        indented: a list
 */
#ifndef SCALLOP_ABOUT_H
#define SCALLOP_ABOUT_H

#include <stdbool.h>
#include <stddef.h>

/* A part of a text, line breaks and indentation included. */
struct span {
  const char *start;
  size_t length;
};

struct passage {
  struct span name;    /* what it is about, without the colon; empty for plain text                                    */
  struct span before;  /* its text up to the sentence on columns; all of it where there is none                        */
  struct span columns; /* what follows "Columns:", up to the full stop                                                 */
  struct span after;   /* the rest                                                                                     */
};

/* The passage at *text, which is moved to what follows it. False: there is none any more. */
bool about_passage(const char **text, struct passage *passage);

/* The next of a list of columns, separated by semicolons outside of brackets. columns is cut down to the others. */
bool about_column(struct span *columns, struct span *column);

#endif
