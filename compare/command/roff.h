/* Writes text for roff, with the macros of man(7): filled lines of at most 79 bytes, each sentence on lines of its own, in
 * which nothing is taken for a request, and what may be copied stays ASCII. */
#ifndef SCALLOP_ROFF_H
#define SCALLOP_ROFF_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Begins as { .to = file }. */
struct roff {
  FILE *to;
  size_t column; /* bytes on the line that is being filled                                                           */
  bool quoted;   /* inside of `backquotes`                                                                           */
  bool dotted;   /* the last word ends in a full stop or an ellipsis                                                 */
  bool stopped;  /* in a full stop                                                                                   */
};

/* A macro on a line of its own; text, unless it is NULL, is its argument. */
void roff_macro(struct roff *roff, const char *macro, const char *text);

/* Adds the words of length bytes. What stands in `backquotes` becomes bold, and so do options. */
void roff_words(struct roff *roff, const char *text, size_t length);
void roff_text(struct roff *roff, const char *text);

/* Adds text in the font 'B' or 'I', blanks included, with what is before and after it in roman. */
void roff_font(struct roff *roff, const char *before, char font, const char *text, const char *after);

/* Adds a line that is bold. */
void roff_bold_line(struct roff *roff, const char *text, size_t length);

/* Adds a line as it stands. */
void roff_line(struct roff *roff, const char *text);

/* Ends the line that is being filled. */
void roff_break(struct roff *roff);

#endif
