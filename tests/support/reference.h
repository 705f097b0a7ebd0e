/* The rows of tests/support/reference.tsv: 50-digit values of a third program, scripts/python/reference.py.
 * Header-only. */
#ifndef SCALLOP_TESTS_SUPPORT_REFERENCE_H
#define SCALLOP_TESTS_SUPPORT_REFERENCE_H

#include <stdio.h>
#include <stdlib.h>

#include "tests/support/solved.h"

enum { REFERENCE_COLUMNS = 27, REFERENCE_LINE = 4096, REFERENCE_ROWS = 896 };

struct row {
  char text[REFERENCE_LINE];
  char *cell[REFERENCE_COLUMNS];
};
static struct row reference_header;

static inline void split_row(struct row *r)
{
  char *at = r->text;
  for (int i = 0; i < REFERENCE_COLUMNS; i++) {
    r->cell[i] = at;
    at += strcspn(at, "\t\n");
    assert_true(*at == (i + 1 < REFERENCE_COLUMNS ? '\t' : '\n'));
    *at++ = '\0';
  }
}

static inline void for_reference_rows(void (*check)(const struct row *r))
{
  static struct row r;
  FILE *file = fopen("tests/support/reference.tsv", "r");
  assert_non_null(file);
  int rows = -1; /* the first is the header */
  while (fgets(r.text, REFERENCE_LINE, file)) {
    if (r.text[0] == '#')
      continue;
    if (rows++ < 0) {
      memcpy(reference_header.text, r.text, REFERENCE_LINE);
      split_row(&reference_header);
      continue;
    }
    split_row(&r);
    check(&r);
  }
  fclose(file);
  assert_int_equal(rows, REFERENCE_ROWS);
}

static inline const char *cell(const struct row *r, const char *prefix, const char *name)
{
  char full[40];
  snprintf(full, sizeof full, "%s%s", prefix, name);
  for (int i = 0; i < REFERENCE_COLUMNS; i++)
    if (strcmp(reference_header.cell[i], full) == 0)
      return r->cell[i];
  fail_msg("no column %s", full);
  return NULL;
}

static inline double number_in(const struct row *r, const char *prefix, const char *name)
{
  return strtod(cell(r, prefix, name), NULL);
}

static inline bool of_steady_state(const struct row *r) { return strcmp(cell(r, "", "kind"), "steady") == 0; }
static inline enum scallop_phase_kind phase_in(const struct row *r)
{
  return cell(r, "", "phase")[0] == 'e' ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
}

#endif
