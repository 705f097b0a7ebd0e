#include "compare/claims/read.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/lines.h"
#include "compare/text/shipped.h"

enum { MOST_CELLS = 40, WANTED = COMMITTED_KEYS + 2 };
static const char *const wanted[WANTED] = {
  "claim", "equation", "quantity", "gait", "conditions", "verdict", "derived_order"
};

struct reading {
  struct lines lines;
  bool started;   /* the header has been read                          */
  int columns;    /* in it                                             */
  int at[WANTED]; /* their places                                      */
};

/* False if a column is missing. */
static bool read_header(struct reading *r)
{
  char *cells[MOST_CELLS];
  r->started = true;
  r->columns = lines_cells(r->lines.line, cells, MOST_CELLS);
  for (int i = 0; i < WANTED; i++) {
    int k = 0;
    while (k < r->columns && strcmp(cells[k], wanted[i]) != 0)
      k++;
    if (k == r->columns)
      return false;
    r->at[i] = k;
  }
  return true;
}

/* The place of a new row, or NULL: out of memory */
static struct committed *append(struct committed_ledger *ledger, const char *line)
{
  if (ledger->count == ledger->room) {
    int room = ledger->room + 512;
    struct committed *grown = realloc(ledger->rows, sizeof *grown * (size_t)room);
    if (!grown)
      return NULL;
    ledger->rows = grown;
    ledger->room = room;
  }
  struct committed *row = &ledger->rows[ledger->count];
  *row = (struct committed){ .line = strdup(line) };
  ledger->count += row->line != NULL;
  return row->line ? row : NULL;
}

/* Returns NULL, or what is wrong with the line. */
static const char *read_line(struct reading *r, struct committed_ledger *ledger)
{
  char *cells[MOST_CELLS];
  if (line_fault(&r->lines))
    return line_fault(&r->lines);
  if (r->lines.line[0] == '#' || r->lines.line[0] == '\0')
    return NULL;
  if (!r->started)
    return read_header(r) ? NULL : "this is no row of a ledger";
  struct committed *row = append(ledger, r->lines.line);
  if (!row)
    return "out of memory";
  if (lines_cells(row->line, cells, MOST_CELLS) != r->columns)
    return "this is no row of a ledger";
  for (int i = 0; i < COMMITTED_KEYS; i++)
    row->key[i] = cells[r->at[i]];
  row->verdict = cells[r->at[COMMITTED_KEYS]];
  row->order = cells[r->at[COMMITTED_KEYS + 1]];
  return NULL;
}

const char *ledger_name(const char *name) { return name ? name : "the ledger that comes with the tool"; }

static bool open_ledger(struct lines *lines, const char *file)
{
  if (!file)
    return lines_of_text(lines, shipped_text(shipped_ledger, "claims"));
  *lines = (struct lines){ .file = fopen(file, "r") };
  return lines->file != NULL;
}

enum exit_code committed_read(struct committed_ledger *ledger, const char *file)
{
  struct reading r = { .columns = 0 };
  const char *wrong = NULL, *name = ledger_name(file);
  *ledger = (struct committed_ledger){ 0 };
  if (!open_ledger(&r.lines, file)) {
    complain("claims", "cannot read %s: %s", name, strerror(errno));
    return EXIT_FILE;
  }
  while (!wrong && next_line(&r.lines))
    wrong = read_line(&r, ledger);
  bool failed = r.lines.error != 0;
  if (wrong)
    complain("claims", "%s:%ld: %s: `scallop claims` writes one", name, r.lines.number, wrong);
  else if (failed)
    complain("claims", "cannot read %s: %s", name, lines_error_text(&r.lines));
  else if (ledger->count == 0)
    complain("claims", "%s: no row of a ledger: `scallop claims` writes one", name);
  if (file)
    fclose(r.lines.file);
  lines_free(&r.lines);
  return failed ? EXIT_FILE : wrong || ledger->count == 0 ? EXIT_USAGE : EXIT_DONE;
}

void committed_free(struct committed_ledger *ledger)
{
  for (int i = 0; i < ledger->count; i++)
    free(ledger->rows[i].line);
  free(ledger->rows);
}
