/* The values of options: numbers from text, and what is said of a text that is not allowed. */
#ifndef SCALLOP_COMPARE_TEXT_VALUES_H
#define SCALLOP_COMPARE_TEXT_VALUES_H

#include <stdbool.h>
#include <stddef.h>

/* A finite number in C's decimal or hexadecimal notation and nothing else, of NUMBER_LENGTH characters at most: more
 * digits than any computation here is asked for. */
enum { NUMBER_LENGTH = 10100 };
bool read_number(const char *text, double *value);

/* Is it a number as JSON writes one? */
bool json_takes_number(const char *text);

/* A whole number from low to high and nothing else. */
bool read_count(const char *text, long low, long high, long *value);

/* Takes an item off a list with commas between, those within parentheses not counted, without blanks around it: as much
 * of it as there is room for. *list, then what is behind its comma, is NULL behind the last item. False: it was. */
bool next_item(char *item, size_t size, const char **list);

/* That text is not what is allowed. */
const char *not_allowed(const char *text, const char *allowed);
/* The same for a number, with what is the matter where the text nearly is one. */
const char *no_number(const char *text, const char *allowed);

/* Values of options that know whether they were given. */
struct given_number {
  double value;
  bool given;
};
struct given_count {
  long value;
  bool given;
};
struct given_word {
  const char *value;
  bool given;
};

#endif
