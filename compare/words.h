/* The name that a mistyped word was meant to be. */
#ifndef SCALLOP_WORDS_H
#define SCALLOP_WORDS_H

#include <stdbool.h>

/* Is word name but for upper and lower case? */
bool likely(const char *word, const char *name);

/* The one of names (NULL-terminated) nearest to a mistyped word, or NULL if none is near. */
const char *nearest(const char *word, const char *const *names);

#endif
