/* Values of options: numbers from text, and the errors of texts that are not allowed. */
#ifndef SCALLOP_COMPARE_TEXT_VALUES_H
#define SCALLOP_COMPARE_TEXT_VALUES_H

#include <stdbool.h>
#include <stddef.h>

/* Reads a finite number in C's decimal or hexadecimal notation, of at most NUMBER_LENGTH characters: more than the
 * digits of any computation. Returns false, value unchanged, for another text. */
enum { NUMBER_LENGTH = 10100 };
bool read_number(const char *text, double *value);

/* Returns true if text is a number in JSON. */
bool json_takes_number(const char *text);

/* Reads an integer from low to high. Returns false, value unchanged, for another text. */
bool read_count(const char *text, long low, long high, long *value);

/* Copies the next item of a list between commas (commas within parentheses do not count), without blanks around it and
 * truncated to size. *list becomes the rest, NULL behind the last item. Returns false if it was NULL. */
bool next_item(char *item, size_t size, const char **list);

/* Returns the error of a text that is not allowed. */
const char *not_allowed(const char *text, const char *allowed);
/* Returns the error of a text that is not the number allowed, with the reason if it is nearly a number. */
const char *no_number(const char *text, const char *allowed);

/* Values of options, and whether they were given */
struct optional_number {
  double value;
  bool given;
};
struct optional_count {
  long value;
  bool given;
};
struct optional_word {
  const char *value;
  bool given;
};

#endif
