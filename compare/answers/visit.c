/* The loop over points: one at a time; or, of a sweep whose rows take long, blocks of them, each by as many threads as
 * there are processors. Rows are written in order as they come. */
#include <stdlib.h>
#include <string.h>

#include "compare/answers/rows.h"
#include "compare/points/point_file.h"
#include "compare/text/progress.h"

/* Counts a point, and what is wrong with it, or "". */
static void count_point(struct rows_run *run, const char *why)
{
  run->points++;
  if (*why && run->unsolved++ == 0)
    snprintf(run->why, sizeof run->why, "%s", why);
}

/* False: a table can no longer be written. */
static bool at_point(struct rows_run *run, struct at *at)
{
  char why[POINT_STATUS] = "";
  bool fine = true;
  for (struct rows *r = run->rows; r < run->rows + run->count; r++) {
    at_begin_row(at);
    if (r->visit)
      r->visit(r, at);
    else
      sheet_row(&r->sheet, &r->table, at);
    if (!*why && at->why[0] != '\0')
      memcpy(why, at->why, sizeof why);
    fine &= !r->is_open || !table_failed(&r->table);
  }
  count_point(run, why);
  return fine;
}

/* The points of a sweep, one after another */
struct tour {
  struct rows_run *run;
  struct at *at;
  struct block *block;                                          /* or NULL */
  bool (*visit)(struct tour *tour, const struct sweep_place *); /* false: no more are wanted */
  const struct sweep_product *product;
};

/* All points from a place where the groups in front of group g are set */
static bool tour_from(struct tour *t, const struct sweep_place *so_far, int g)
{
  struct sweep_place place;
  bool more = true;
  if (g == t->product->groups)
    return t->visit(t, so_far);
  for (long i = 0; i < t->product->group[g].count && more; i++) {
    sweep_place_copy(&place, so_far);
    sweep_step(&place, t->product, g, i, at_formula_so_far, t->at);
    more = tour_from(t, &place, g + 1);
  }
  return more;
}

static bool tour_sweep(struct tour *t)
{
  const struct request *r = t->run->rows->request;
  struct sweep_place place;
  sweep_place_set(&place, &r->point);
  bool more = r->sweep.products > 0 || t->visit(t, &place);
  for (int p = 0; p < r->sweep.products && more; p++) {
    t->product = &r->sweep.product[p];
    more = tour_from(t, &place, 0);
  }
  return more;
}

static bool visit_place(struct tour *t, const struct sweep_place *place)
{
  sweep_place_copy(&t->at->place, place);
  progress_count(t->run->points + 1, sweep_points(&t->run->rows->request->sweep));
  at_move(t->at);
  return at_point(t->run, t->at);
}

static void visit_file(struct rows_run *run, struct at *at, struct point_file *file)
{
  bool fine = true;
  while (fine && point_file_next(file, &at->place, &run->rows->request->point)) {
    progress_count(run->points + 1, point_file_rows(file, run->points + 1));
    at_move(at);
    fine = at_point(run, at);
  }
}

enum { BLOCK = 64 };

struct block {
  const struct rows *rows;
  int count;
  struct row {
    struct sweep_place place;
    struct table cells; /* never opened: what is written into it is kept */
    char why[POINT_STATUS];
  } row[BLOCK];
  int threads;
  struct at *at[BLOCK]; /* one for each thread */
};

/* Computes a row of the block where it belongs. */
static void compute_row(struct at *at, int i, void *block)
{
  const struct block *b = block;
  struct row *row = &((struct block *)block)->row[i];
  sweep_place_copy(&at->place, &row->place);
  at_move(at);
  at_begin_row(at);
  sheet_row(&b->rows->sheet, &row->cells, at);
  memcpy(row->why, at->why, sizeof row->why);
}

static bool end_block(struct tour *t)
{
  struct block *b = t->block;
  struct rows_run *run = t->run;
  progress_count(run->points, sweep_points(&run->rows->request->sweep)); /* so that no worker counts anything else */
  at_flint->share(b->at, b->threads, b->count, compute_row, b);
  for (const struct row *row = b->row; row < b->row + b->count; row++) {
    count_point(run, row->why);
    table_repeat(&run->rows->table, &row->cells);
  }
  b->count = 0;
  return !table_failed(&run->rows->table);
}

static bool put_in_block(struct tour *t, const struct sweep_place *place)
{
  sweep_place_copy(&t->block->row[t->block->count++].place, place);
  return t->block->count < BLOCK || end_block(t);
}

/* Is the sweep worth blocks: one table whose columns need FLINT? */
static bool takes_long(const struct rows_run *run)
{
  const struct rows *r = run->rows;
  return run->count == 1 && !r->visit && asked_needs_flint(r->sheet.asked) && sweep_points(&r->request->sweep) >= 8
         && at_flint->threads(BLOCK) > 1;
}

/* False: there is no memory for it, and nothing has been done. */
static bool visit_in_blocks(struct rows_run *run, struct at *at)
{
  const struct rows *rows = run->rows;
  struct block *b = calloc(1, sizeof *b);
  struct tour tour = { .run = run, .at = at, .block = b, .visit = put_in_block };
  bool fine = b != NULL;
  for (int i = 0; i < BLOCK && fine; i++) {
    b->row[i].cells = (struct table){ .style = &rows->style };
    sheet_head(&rows->sheet, &b->row[i].cells);
  }
  for (int i = at_flint->threads(BLOCK); fine && i > 0; i--) {
    b->rows = rows;
    b->at[b->threads++] = at_new(rows->sheet.asked);
    fine = b->at[b->threads - 1] != NULL;
  }
  if (fine && tour_sweep(&tour))
    end_block(&tour);
  for (int i = 0; b && i < b->threads; i++)
    at_free(b->at[i]);
  for (int i = 0; b && i < BLOCK; i++)
    table_abandon(&b->row[i].cells);
  free(b);
  return fine;
}

static void visit_points(struct rows_run *run, struct at *at, struct point_file *file)
{
  struct tour tour = { .run = run, .at = at, .visit = visit_place };
  if (file)
    visit_file(run, at, file);
  else if (!takes_long(run) || !visit_in_blocks(run, at))
    tour_sweep(&tour);
}

static bool open_tables(struct rows_run *run)
{
  bool open = true;
  for (int i = 0; i < run->count && open; i++)
    open = run->rows[i].opens_late || rows_open(&run->rows[i]);
  return open;
}

enum exit_code rows_visit(struct rows_run *run, struct point_file *file)
{
  const struct style *style = &run->rows->request->style;
  struct at *at = at_new(run->rows->sheet.asked);
  enum exit_code code = at ? EXIT_FILE : EXIT_UNSOLVED;
  if (at && open_tables(run)) {
    visit_points(run, at, file);
    const char *error = file ? tsv_error(&file->tsv) : NULL;
    code = error ? complain(style->command, "%s", error), EXIT_FILE : EXIT_DONE;
    for (int i = 0; i < run->count; i++)
      code = run->rows[i].cannot_open || (run->rows[i].is_open && !table_flush(&run->rows[i].table)) ? EXIT_FILE : code;
  }
  at_free(at);
  return code;
}

bool rows_close(struct rows_run *run, bool keep)
{
  bool whole = true;
  for (struct rows *r = run->rows; r < run->rows + run->count; r++)
    if (r->is_open && !keep && !table_failed(&r->table))
      table_abandon(&r->table);
    else if (r->is_open)
      whole &= table_close(&r->table);
  return whole;
}

static enum exit_code finish(struct rows_run *run, enum exit_code code)
{
  const struct request *request = run->rows->request;
  const char *command = request->style.command;
  bool incomplete = run->rows->opens_late && run->unsolved > 0;
  if (!rows_close(run, code == EXIT_DONE && !incomplete))
    return EXIT_FILE;
  if (code != EXIT_DONE || run->unsolved == 0)
    return code != EXIT_DONE ? code : run->rows->failed_checks > 0 ? EXIT_CHECK_FAILED : EXIT_DONE;
  if (has_many_points(request))
    complain(command, "%ld of %ld points could not be solved: the column 'status' says why", run->unsolved,
             run->points);
  else
    complain(command, "this point could not be solved: %s", run->why);
  return EXIT_UNSOLVED;
}

static enum exit_code make(struct rows *r, struct point_file *file)
{
  struct rows_run run = { .count = 1, .rows = r };
  struct quantities *all = &r->sheet.asked->quantities;
  all->carries = file ? file->carries : 0;
  all->carried = file ? file->carried : NULL;
  const char *wrong = rows_columns(r);
  if (!wrong)
    return finish(&run, rows_visit(&run, file));
  complain(r->request->style.command, "%s%s", r->request->style.choice ? "--columns: " : "", wrong);
  return EXIT_USAGE;
}

enum exit_code rows_table(struct rows *r)
{
  const struct request *request = r->request;
  struct point_file file = { .v0_may_be_nan = r->sheet.asked->from_steady };
  if (!request->points)
    return make(r, NULL);
  enum exit_code code = point_file_open(&file, request->points, request->style.command, request->style.quiet, r->extra,
                                        (const char *const *)r->own);
  code = code == EXIT_DONE ? make(r, &file) : code;
  point_file_close(&file);
  return code;
}
