/* One formula of a book, from when it is read. Not for other rooms. */
#ifndef SCALLOP_COMPARE_BOOK_ENTRY_H
#define SCALLOP_COMPARE_BOOK_ENTRY_H

#include "compare/book/book.h"
#include "compare/config/config.h"

enum { MOST_PARTS = 16, MOST_CONDITIONS = 8 };

struct book_entry {
  struct scallop_formula formula;
  struct scallop_part parts[MOST_PARTS + 1];
  const char *when[MOST_CONDITIONS + 1];
  int conditions, start, phase, of; /* start, phase, of: places among the words of book.h */
  const struct config *config;
  const config_setting_t *group;
};

/* Keeps an entry, which books_forget frees. False: out of memory. */
bool book_keep(struct book_entry *entry);
const struct book_entry *book_entry_named(const char *name); /* or NULL */

/* The files that were read, whose texts the entries have */
struct book_file {
  struct book_file *next;
  struct config config;
};
extern struct book_file *book_files;

#endif
