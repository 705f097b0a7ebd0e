/* Rows that take long, of a sweep: blocks of them, each by as many threads as there are processors, in order. */
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/answers/rows.h"
#include "compare/text/progress.h"

enum { BLOCK = 64, MOST_THREADS = 64 };

struct block {
  const struct rows *rows;
  int count;
  struct row {
    struct sweep_place place;
    struct table cells; /* never opened: what is written into it is kept */
    char why[POINT_STATUS];
  } row[BLOCK];
  atomic_int next;
};

/* Computes rows of the block until none is left, each where it belongs. */
struct worker {
  pthread_t thread;
  bool runs;
  struct at *at;
  struct block *block;
};
static void *work(void *worker)
{
  const struct worker *w = worker;
  for (int i; (i = atomic_fetch_add(&w->block->next, 1)) < w->block->count;) {
    struct row *row = &w->block->row[i];
    sweep_place_copy(&w->at->place, &row->place);
    at_move(w->at);
    at_begin_row(w->at);
    sheet_row(&w->block->rows->sheet, &row->cells, w->at);
    memcpy(row->why, w->at->why, sizeof row->why);
  }
  at_end_thread(w->at);
  return NULL;
}

/* The last of them is this thread. */
static void compute(struct block *block, struct worker *workers, int threads)
{
  atomic_store(&block->next, 0);
  for (int i = 0; i < threads - 1; i++)
    workers[i].runs = pthread_create(&workers[i].thread, NULL, work, &workers[i]) == 0;
  work(&workers[threads - 1]);
  for (int i = 0; i < threads - 1; i++)
    if (workers[i].runs)
      pthread_join(workers[i].thread, NULL);
}

/* Writes the rows, in order. False: the table can no longer be written. */
static bool write_block(struct rows_run *run, const struct block *block)
{
  struct table *t = &run->rows->table;
  for (const struct row *row = block->row; row < block->row + block->count; row++) {
    rows_count(run, row->why);
    table_repeat(t, &row->cells);
  }
  progress_count(run->points, sweep_points(&run->rows->request->sweep));
  return !table_failed(t);
}

static bool visit_product(struct rows_run *run, struct at *at, const struct sweep_product *product,
                          struct block *block, struct worker *workers, int threads)
{
  const struct request *request = run->rows->request;
  struct sweep_cursor cursor = { .product = NULL };
  long index[SWEEP_GROUPS] = { 0 };
  bool more = true, fine = true;
  while (more && fine) {
    for (block->count = 0; more && block->count < BLOCK; block->count++) {
      at_place(at, &cursor, &request->point, product, index);
      sweep_place_copy(&block->row[block->count].place, &at->place);
      more = sweep_next(product, index);
    }
    compute(block, workers, threads);
    fine = write_block(run, block);
  }
  return fine;
}

static int processors(void)
{
  const char *wanted = getenv("OMP_NUM_THREADS");
  long count = wanted && atol(wanted) > 0 ? atol(wanted) : sysconf(_SC_NPROCESSORS_ONLN);
  return count < 1 ? 1 : count > MOST_THREADS ? MOST_THREADS : (int)count;
}

bool rows_in_blocks(struct rows_run *run, struct at *at)
{
  const struct rows *rows = run->rows;
  const struct sweep *sweep = &rows->request->sweep;
  const int threads = processors();
  struct worker workers[MOST_THREADS] = { { .runs = false } };
  if (threads == 1 || run->count > 1 || rows->visit || !asked_needs_flint(rows->sheet.asked) || sweep_points(sweep) < 8)
    return false;
  struct block *block = calloc(1, sizeof *block);
  bool fine = block != NULL;
  for (int i = 0; i < BLOCK && fine; i++) {
    block->row[i].cells = (struct table){ .style = &rows->style };
    sheet_head(&rows->sheet, &block->row[i].cells);
  }
  for (int i = 0; i < threads && fine; i++) {
    workers[i] = (struct worker){ .at = malloc(sizeof *at), .block = block };
    fine = workers[i].at && at_init(workers[i].at, rows->sheet.asked);
  }
  if (fine)
    block->rows = rows;
  for (int p = 0; fine && p < sweep->products; p++)
    fine = visit_product(run, at, &sweep->product[p], block, workers, threads);
  for (int i = 0; i < threads; i++) {
    if (workers[i].at)
      at_clear(workers[i].at);
    free(workers[i].at);
  }
  for (int i = 0; block && i < BLOCK; i++)
    table_abandon(&block->row[i].cells);
  bool begun = block && block->rows;
  free(block);
  return begun;
}
