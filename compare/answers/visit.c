/* The loop over points: one at a time; or, of a sweep whose rows take long, blocks of them, each by as many threads as
 * there are processors. Rows are written in order as they come. */
#include <stdlib.h>
#include <string.h>

#include "compare/answers/rows.h"
#include "compare/points/point_file.h"
#include "compare/text/progress.h"

/* The rows of the point in at->place; or, of the only table, the cells of its row. why: the first thing that could not
 * be done, or "" */
static void make_rows(struct rows_run *run, struct at *at, struct table *cells, char why[POINT_STATUS])
{
  *why = '\0';
  at_move(at);
  for (struct rows *r = run->rows; r < run->rows + run->count; r++) {
    at_begin_row(at);
    if (r->visit)
      r->visit(r, at);
    else
      sheet_row(&r->sheet, cells ? cells : &r->table, at);
    if (!*why)
      memcpy(why, at->why, sizeof at->why);
  }
}

/* Counts a point whose rows are written. False: a table can no longer be written. */
static bool end_point(struct rows_run *run, const char *why)
{
  bool fine = true;
  run->points++;
  if (*why && run->unsolved++ == 0)
    snprintf(run->why, sizeof run->why, "%s", why);
  for (const struct rows *r = run->rows; r < run->rows + run->count; r++)
    fine &= !r->is_open || !table_failed(&r->table);
  return fine;
}

/* points: how many there are, 0: that is not known */
static bool visit_point(struct rows_run *run, struct at *at, long points)
{
  char why[POINT_STATUS];
  progress_count(run->points + 1, points);
  make_rows(run, at, NULL, why);
  return end_point(run, why);
}

enum { BLOCK = 64 };

struct block { /* of points of the only table */
  struct rows_run *run;
  int count, threads;
  struct at *at[BLOCK]; /* one for each thread */
  struct row {
    struct sweep_place place;
    struct table cells; /* never opened: what is written into it is kept */
    char why[POINT_STATUS];
  } row[BLOCK];
};

static void compute_row(struct at *at, int i, void *block)
{
  struct block *b = block;
  sweep_place_copy(&at->place, &b->row[i].place);
  make_rows(b->run, at, &b->row[i].cells, b->row[i].why);
}

static bool end_block(struct block *b)
{
  struct rows *rows = b->run->rows;
  bool fine = true;
  progress_count(b->run->points, sweep_points(&rows->request->sweep)); /* so that no worker counts anything else */
  at_flint->share(b->at, b->threads, b->count, compute_row, b);
  for (const struct row *row = b->row; row < b->row + b->count; row++) {
    table_repeat(&rows->table, &row->cells);
    fine = end_point(b->run, row->why);
  }
  b->count = 0;
  return fine;
}

/* Where a sweep is worth it, one table whose columns need FLINT; else NULL, as where there is no memory. */
static struct block *block_begin(struct rows_run *run, struct at *at)
{
  const struct rows *r = run->rows;
  bool takes_long = run->count == 1 && !r->visit && asked_needs_flint(r->sheet.asked);
  int threads = takes_long && sweep_points(&r->request->sweep) >= 8 ? at_flint->threads(BLOCK) : 1;
  struct block *b = threads > 1 ? calloc(1, sizeof *b) : NULL;
  if (!b)
    return NULL;
  b->run = run;
  b->at[b->threads++] = at;
  while (b->threads < threads && (b->at[b->threads] = at_new(r->sheet.asked)))
    b->threads++;
  for (struct row *row = b->row; row < b->row + BLOCK; row++) {
    row->cells = (struct table){ .style = &r->style };
    sheet_head(&r->sheet, &row->cells);
  }
  return b;
}

static void block_free(struct block *b)
{
  for (int i = 1; i < b->threads; i++)
    at_free(b->at[i]);
  for (int i = 0; i < BLOCK; i++)
    table_abandon(&b->row[i].cells);
  free(b);
}

/* The points of a sweep, one after another */
struct tour {
  struct rows_run *run;
  struct at *at;
  struct block *block; /* or NULL */
  const struct sweep_product *product;
};

/* False: no more are wanted. */
static bool visit_place(struct tour *t, const struct sweep_place *place)
{
  struct block *b = t->block;
  sweep_place_copy(b ? &b->row[b->count++].place : &t->at->place, place);
  if (!b)
    return visit_point(t->run, t->at, sweep_points(&t->run->rows->request->sweep));
  return b->count < BLOCK || end_block(b);
}

/* All points from a place where the groups in front of group g are set */
static bool tour_from(struct tour *t, const struct sweep_place *so_far, int g)
{
  struct sweep_place place;
  bool more = true;
  if (!t->product || g == t->product->groups)
    return visit_place(t, so_far);
  for (long i = 0; i < t->product->group[g].count && more; i++) {
    sweep_place_copy(&place, so_far);
    sweep_step(&place, t->product, g, i, at_formula_so_far, t->at);
    more = tour_from(t, &place, g + 1);
  }
  return more;
}

static void visit_sweep(struct rows_run *run, struct at *at)
{
  const struct request *r = run->rows->request;
  struct tour t = { .run = run, .at = at, .block = block_begin(run, at) };
  struct sweep_place place;
  sweep_place_set(&place, &r->point);
  bool more = r->sweep.products > 0 || tour_from(&t, &place, 0);
  for (int p = 0; p < r->sweep.products && more; p++) {
    t.product = &r->sweep.product[p];
    more = tour_from(&t, &place, 0);
  }
  if (t.block && more)
    end_block(t.block);
  if (t.block)
    block_free(t.block);
}

static void visit_file(struct rows_run *run, struct at *at, struct point_file *file)
{
  bool fine = true;
  while (fine && point_file_next(file, &at->place, &run->rows->request->point))
    fine = visit_point(run, at, point_file_rows(file, run->points + 1));
}

enum exit_code rows_visit(struct rows_run *run, struct point_file *file)
{
  const struct style *style = &run->rows->request->style;
  struct at *at = at_new(run->rows->sheet.asked);
  enum exit_code code = at ? EXIT_FILE : EXIT_UNSOLVED;
  bool open = at != NULL;
  for (int i = 0; i < run->count && open; i++)
    open = run->rows[i].opens_late || rows_open(&run->rows[i]);
  if (open) {
    if (file)
      visit_file(run, at, file);
    else
      visit_sweep(run, at);
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
  if (code != EXIT_DONE)
    return code;
  if (run->unsolved == 0)
    return run->rows->failed_checks > 0 ? EXIT_CHECK_FAILED : EXIT_DONE;
  if (has_many_points(request))
    complain(command, "%ld of %ld points could not be solved: the column 'status' says why", run->unsolved,
             run->points);
  else
    complain(command, "this point could not be solved: %s", run->why);
  return EXIT_UNSOLVED;
}

enum exit_code rows_table(struct rows *r)
{
  const struct style *style = &r->request->style;
  struct rows_run run = { .count = 1, .rows = r };
  struct quantities *all = &r->sheet.asked->quantities;
  struct point_file file = { .v0_may_be_nan = r->sheet.asked->from_steady },
                    *points = r->request->points ? &file : NULL;
  enum exit_code code = EXIT_DONE;
  if (points)
    code = point_file_open(points, r->request->points, style->command, style->quiet, r->extra,
                           (const char *const *)r->own);
  all->carries = file.carries;
  all->carried = file.carried;
  const char *wrong = code == EXIT_DONE ? rows_columns(r) : NULL;
  if (wrong) {
    complain(style->command, "%s%s", style->choice ? "--columns: " : "", wrong);
    code = EXIT_USAGE;
  } else if (code == EXIT_DONE)
    code = finish(&run, rows_visit(&run, points));
  if (points)
    point_file_close(points);
  return code;
}
