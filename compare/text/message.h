/* Messages: exit codes, what is printed on stderr, and the name that a mistyped one was meant to be. */
#ifndef SCALLOP_COMPARE_TEXT_MESSAGE_H
#define SCALLOP_COMPARE_TEXT_MESSAGE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum exit_code { EXIT_DONE = 0, EXIT_CHECK_FAILED = 1, EXIT_USAGE = 2, EXIT_UNSOLVED = 3, EXIT_FILE = 4 };

/* What printf writes, to be freed; control characters, but for those that are kept, become '?': a terminal would listen
 * to them. NULL: out of memory. */
char *printed_line(const char *format, va_list arguments, const char *kept) __attribute__((format(printf, 1, 0)));

/* "scallop NAME: message" on stderr. Returns false. */
bool complain(const char *command, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* What is wrong, or another short text, as printf makes it, also of the last three such texts: until four calls later,
 * and in one thread. */
const char *wrong_text(const char *format, ...) __attribute__((format(printf, 1, 2), returns_nonnull));

/* The place of a word in a list of words (NULL-terminated), or -1. */
int word_place(const char *word, const char *const *words);
/* "a, b or c", where last is " or ". Returns text. */
const char *joined(char *text, size_t size, const char *const *words, const char *last);

/* The one of names (NULL-terminated) nearest to a mistyped word, or NULL if none is near. */
const char *nearest(const char *word, const char *const *names);
/* The same of rows of so many bytes that begin with a name; that of the last is NULL. */
const char *nearest_in(const char *word, const void *list, size_t size);

/* ": did you mean 'NEAR'?", or "" for NULL: what ends a message about a name (a wrong_text). */
const char *did_you_mean(const char *near);

/* What ends a message about a word that is none of names (NULL-terminated): did_you_mean of the nearest, or ": there
 * are A, B, C". */
const char *instead_of(const char *word, const char *const *names);

/* Bytes of the character in UTF-8 that text begins with: 1 to 4; 0 where it begins with none, with a control character,
 * or ends. What consists of such characters can be shown on a terminal and in XML. */
size_t shown_character(const char *text);
bool is_shown(const char *text);

/* Characters that mean something in a format, and what is written instead of each */
struct escapes {
  const char *special, *instead[8];
};
extern const struct escapes in_plain, in_json, in_csv, in_xml, in_markdown;

/* What goes out as it is: printable ASCII, what can be shown, or any bytes. Of the rest a control character
 * becomes a blank, each other byte '?'. */
enum shown { SHOWS_ASCII, SHOWS_CHARACTERS, SHOWS_BYTES };
void put_escaped(FILE *to, const char *text, const struct escapes *escapes, enum shown shown);

#endif
