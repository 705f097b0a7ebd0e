/* Messages: exit codes, texts on stderr, nearest names to a mistyped one, and escaped output. */
#ifndef SCALLOP_COMPARE_TEXT_MESSAGE_H
#define SCALLOP_COMPARE_TEXT_MESSAGE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum exit_code { EXIT_DONE = 0, EXIT_CHECK_FAILED = 1, EXIT_USAGE = 2, EXIT_UNSOLVED = 3, EXIT_FILE = 4 };

/* Returns the text that printf would write; the caller frees it. Control characters, except those in `kept`, become
 * question marks, because a terminal would obey them. NULL: out of memory. */
char *printed_line(const char *format, va_list arguments, const char *kept) __attribute__((format(printf, 1, 0)));

/* Prints "scallop NAME: message" to stderr. Returns false. */
bool complain(const char *command, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Formats an error or another short text like printf; arguments may be earlier such texts. The text is valid until four
 * calls later in the same thread. */
const char *wrong_text(const char *format, ...) __attribute__((format(printf, 1, 2), returns_nonnull));

/* Returns the index of a word in a NULL-terminated list, or -1. */
int word_place(const char *word, const char *const *words);
/* Writes "a, b or c" if last is " or ". Returns text. */
const char *joined(char *text, size_t size, const char *const *words, const char *last);

/* Returns the name (of a NULL-terminated list) nearest to a mistyped word, or NULL if all differ much. */
const char *nearest(const char *word, const char *const *names);
/* Returns the nearest name of a list of rows of `size` bytes that begin with a name; the last name is NULL. */
const char *nearest_in(const char *word, const void *list, size_t size);

/* Returns the end of a message about a name, ": did you mean 'NEAR'?", or "" for NULL (a wrong_text). */
const char *did_you_mean(const char *near);

/* Returns the end of a message about an unknown word: did_you_mean of the nearest name (of a NULL-terminated list), or
 * the list of names. */
const char *name_hint(const char *word, const char *const *names);

/* Returns the number of bytes, 1 to 4, of the first character of a text in UTF-8; 0 at its end, for invalid bytes and
 * for a control character. A terminal and XML can show all other characters. */
size_t shown_character(const char *text);
bool is_shown(const char *text); /* all characters are such */

/* The special characters of a format, and the replacement of each */
struct escapes {
  const char *special, *instead[8];
};
extern const struct escapes in_plain, in_json, in_csv, in_xml, in_markdown;

/* The bytes that are written unchanged: printable ASCII, characters that can be shown, or all bytes. Of the other bytes
 * a control character becomes a blank, each other byte a question mark. */
enum shown { SHOWS_ASCII, SHOWS_CHARACTERS, SHOWS_BYTES };
void put_escaped(FILE *to, const char *text, const struct escapes *escapes, enum shown shown);

#endif
