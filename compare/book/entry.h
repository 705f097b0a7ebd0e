/* One formula of a book while it is read and checked. Not for other rooms. */
#ifndef SCALLOP_COMPARE_BOOK_ENTRY_H
#define SCALLOP_COMPARE_BOOK_ENTRY_H

#include "compare/book/book.h"
#include "compare/config/config.h"

enum { MOST_PARTS = 16, MOST_CONDITIONS = 8, MOST_CLAIMED = 999 };

/* The places of the words of a book in their lists (book.h) */
enum { FROM_REST, FROM_V0, FROM_STEADY };

/* One formula, and what its texts stand for */
struct entry {
  struct scallop_formula formula;
  struct scallop_part parts[MOST_PARTS + 1];
  const char *when[MOST_CONDITIONS + 1];
  int conditions, start, phase, of;
  const char *path;
  const config_setting_t *group; /* NULL: the formula of an option */
  struct entry *next;            /* behind it in the list of a checksum of names */
};

/* The entries of all books: how many, and the one at place i; keeps one more, false: out of memory. A file to be read,
 * for as long as its entries are there, or NULL. */
int book_count(void);
const struct entry *book_entry(int i);
const struct entry *book_entry_named(const char *name); /* or NULL */
bool book_keep(struct entry *entry);
struct config *book_config(void);

/* Is the word that of a quantity of the steady state? */
bool is_steady_word(const char *word);

/* check.c: false, and a message, where the entry has no meaning. The first looks at what there is; the second, when the
 * formula is made, at its texts. */
bool check_entry(const struct config *config, const struct entry *entry, name_is_taken *taken);
bool check_texts(const struct config *config, const struct entry *entry);
/* Is there the formula that takes the place of this one? For when all of the book is read. */
bool check_corrected(const struct config *config, const struct entry *entry);

#endif
