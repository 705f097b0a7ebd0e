/* The loop over points: one at a time; or, of a sweep whose rows take long, blocks of them, each by as many threads as
 * there are processors. Rows are written in order as they come. */
#include <stdlib.h>
#include <string.h>

#include "compare/answers/rows.h"
#include "compare/points/point_file.h"
#include "compare/text/progress.h"

enum { BLOCK = 64 };

/* One of the points that are computed together. Of a point by itself the place is that of its at, and its cells go
 * where they belong. */
struct row {
  struct sweep_place *place;
  struct table *cells;    /* of the only table, never opened: what is written into it is kept; or NULL */
  char why[POINT_STATUS]; /* the first thing that could not be done, or "" */
};
struct shared {
  struct sweep_place place;
  struct table cells;
};

/* The points of a sweep or of a file, one after another, in blocks */
struct tour {
  struct rows_run *run;
  const struct sweep_product *product;
  long points;      /* how many there are; 0: that is not known */
  int block, count; /* points that are computed together, and those of them that are there */
  int threads;
  struct at *at[BLOCK]; /* one for each thread */
  struct row row[BLOCK];
  struct shared *shared; /* BLOCK of them; NULL: points are computed by themselves */
};

static void compute_row(struct at *at, int i, void *tour)
{
  struct tour *t = tour;
  struct row *row = &t->row[i];
  if (row->cells)
    sweep_place_copy(&at->place, row->place);
  row->why[0] = '\0';
  at_move(at);
  for (struct rows *r = t->run->rows; r < t->run->rows + t->run->count; r++) {
    at_begin_row(at);
    if (r->visit)
      r->visit(r, at);
    else
      sheet_row(&r->sheet, row->cells ? row->cells : &r->table, at);
    if (row->why[0] == '\0' && at->why[0] != '\0')
      memcpy(row->why, at->why, sizeof at->why);
  }
}

/* False: a table can no longer be written. */
static bool end_block(struct tour *t)
{
  struct rows_run *run = t->run;
  bool fine = true;
  /* the first of them: of points that are computed together no worker counts anything else */
  progress_count(run->points + (t->threads == 1), t->points);
  if (t->threads > 1)
    at_flint->share(t->at, t->threads, t->count, compute_row, t);
  for (int i = 0; i < t->count && t->threads == 1; i++)
    compute_row(t->at[0], i, t);
  for (const struct row *row = t->row; row < t->row + t->count; row++) {
    if (row->cells)
      table_repeat(&run->rows->table, row->cells);
    run->points++;
    if (row->why[0] != '\0' && run->unsolved++ == 0)
      memcpy(run->why, row->why, sizeof row->why);
  }
  t->count = 0;
  for (const struct rows *r = run->rows; r < run->rows + run->count; r++)
    fine &= !r->is_open || !table_failed(&r->table);
  return fine;
}

/* Where a sweep is worth it, one table whose columns need FLINT, points are computed together. */
static void share_out(struct tour *t)
{
  const struct rows *r = t->run->rows;
  bool takes_long = t->run->count == 1 && !r->visit && asked_needs_flint(r->sheet.asked) && t->points >= 8;
  int threads = takes_long ? at_flint->threads(BLOCK) : 1;
  t->shared = threads > 1 ? calloc(BLOCK, sizeof *t->shared) : NULL;
  if (!t->shared)
    return;
  while (t->threads < threads && (t->at[t->threads] = at_new(r->sheet.asked)))
    t->threads++;
  t->block = BLOCK;
  for (int i = 0; i < BLOCK; i++) {
    t->row[i] = (struct row){ &t->shared[i].place, &t->shared[i].cells, "" };
    t->row[i].cells->style = &r->style;
    sheet_head(&r->sheet, t->row[i].cells);
  }
}

static void tour_free(struct tour *t)
{
  for (int i = 0; i < t->threads; i++)
    at_free(t->at[i]);
  for (int i = 0; i < BLOCK && t->shared; i++)
    table_abandon(&t->shared[i].cells);
  free(t->shared);
  free(t);
}

/* All points from a place where the groups in front of group g are set. False: no more are wanted. */
static bool tour_from(struct tour *t, const struct sweep_place *so_far, int g)
{
  struct sweep_place place;
  bool more = true;
  if (!t->product || g == t->product->groups) {
    sweep_place_copy(t->row[t->count++].place, so_far);
    return t->count < t->block || end_block(t);
  }
  for (long i = 0; i < t->product->group[g].count && more; i++) {
    sweep_place_copy(&place, so_far);
    sweep_step(&place, t->product, g, i, at_formula_so_far, t->at[0]);
    more = tour_from(t, &place, g + 1);
  }
  return more;
}

static void tour_sweep(struct tour *t)
{
  const struct request *r = t->run->rows->request;
  struct sweep_place place;
  t->points = sweep_points(&r->sweep);
  share_out(t);
  sweep_place_set(&place, &r->point);
  bool more = r->sweep.products > 0 || tour_from(t, &place, 0);
  for (int p = 0; p < r->sweep.products && more; p++) {
    t->product = &r->sweep.product[p];
    more = tour_from(t, &place, 0);
  }
  if (more && t->count > 0)
    end_block(t);
}

static void tour_file(struct tour *t, struct point_file *file)
{
  bool more = true;
  while (more && point_file_next(file, t->row[0].place, &t->run->rows->request->point)) {
    t->points = point_file_rows(file, t->run->points + 1);
    t->count = 1;
    more = end_block(t);
  }
}

enum exit_code rows_visit(struct rows_run *run, struct point_file *file)
{
  const char *command = run->rows->request->style.command, *error = NULL;
  struct tour *t = calloc(1, sizeof *t);
  bool open = t && (t->at[0] = at_new(run->rows->sheet.asked)), fine = open;
  if (!t)
    complain(command, "out of memory");
  if (!open)
    return free(t), EXIT_UNSOLVED;
  t->run = run;
  t->block = t->threads = 1;
  t->row[0].place = &t->at[0]->place;
  for (int i = 0; i < run->count && open; i++)
    open = run->rows[i].opens_late || rows_open(&run->rows[i]);
  if (open && file)
    tour_file(t, file);
  else if (open)
    tour_sweep(t);
  if (open && file && (error = tsv_error(&file->tsv)))
    complain(command, "%s", error);
  for (struct rows *r = run->rows; r < run->rows + run->count && open; r++)
    fine &= !r->cannot_open && (!r->is_open || table_flush(&r->table));
  tour_free(t);
  return open && fine && !error ? EXIT_DONE : EXIT_FILE;
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
