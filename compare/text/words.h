/* Words that a user writes: the name that a mistyped one was meant to be, and what can be shown as it is. */
#ifndef SCALLOP_WORDS_H
#define SCALLOP_WORDS_H

#include <stdbool.h>
#include <stddef.h>

/* Is word name but for upper and lower case? */
bool likely(const char *word, const char *name);

/* The one of names (NULL-terminated) nearest to a mistyped word, or NULL if none is near. */
const char *nearest(const char *word, const char *const *names);

/* Bytes of the character in UTF-8 that text begins with: 1 to 4; 0 where it begins with none, with a control character, or ends.
 * What consists of such characters can be shown on a terminal and in XML. */
size_t shown_character(const char *text);
bool is_shown(const char *text);

#endif
