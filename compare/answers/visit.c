/* The loop over points. Threads take chunks of neighbouring points and write them in the order of the points, therefore
 * the output does not depend on the number of threads. */
#define _GNU_SOURCE /* sched_getaffinity */
#include <limits.h>
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/block.h"
#include "compare/answers/shard.h"
#include "compare/points/point_file.h"
#include "compare/text/progress.h"

enum { CHUNKS = 8, MAX_CHUNK = 64 }; /* minimum number of chunks for each thread; maximum of slow rows in a chunk */
enum { MIN_POINTS = 8 };             /* with fewer slow rows a single thread is faster */

/* A thread and its state. A single thread writes to the tables; several threads write to parts of them. */
struct worker {
  struct loop *loop;
  struct at *at;
  struct block *block; /* NULL: compute rows one by one */
  struct sweep_walk walk;
  struct rows *rows;
  long unsolved;          /* points of the chunk */
  char why[POINT_STATUS]; /* the reason of the first of these */
  pthread_t thread;
};

/* The points of a sweep or of a file */
struct loop {
  struct rows_set *set;
  struct point_file *file; /* or NULL */
  long first, end, chunk;  /* points to compute; for a file end is LONG_MAX, except in a shard */
  int threads;
  struct worker *worker;
  pthread_mutex_t lock;
  pthread_cond_t turn;
  long next, written; /* the first point that is not taken; that is not written */
  bool ends;          /* after an error of writing, or at the end of the file */
};

static void compute_row(struct worker *w)
{
  const struct rows_set *set = w->loop->set;
  struct at *at = w->at;
  char why[POINT_STATUS] = "";
  at_begin_point(at);
  for (struct rows *r = w->rows; r < w->rows + set->count; r++) {
    at_begin_row(at);
    if (r->visit)
      r->visit(r, at);
    else
      sheet_row(&r->sheet, &r->table, at);
    if (why[0] == '\0' && at->why[0] != '\0')
      memcpy(why, at->why, sizeof why);
  }
  if (why[0] != '\0' && w->unsolved++ == 0)
    memcpy(w->why, why, sizeof why);
}

static void compute(struct worker *w, long first, long count)
{
  const struct request *r = w->rows->request;
  w->unsolved = 0;
  if (w->loop->file)
    return compute_row(w);
  if (w->block && block_rows(w->block, w->rows, w->at, &w->walk, first, (int)count))
    return;
  for (long i = first; i < first + count; i++) {
    sweep_place_copy(&w->at->place, sweep_point(&w->walk, &r->sweep, &r->point, i, at_formula_so_far, w->at));
    compute_row(w);
  }
}

/* Takes the next chunk. Returns its number of points; 0: no points are left. */
static long take_chunk(struct worker *w, long *first)
{
  struct loop *t = w->loop;
  pthread_mutex_lock(&t->lock);
  *first = t->next;
  long count = t->ends ? 0 : t->end - t->next < t->chunk ? t->end - t->next : t->chunk;
  if (count > 0 && t->file && !point_file_next(t->file, &w->at->place, &w->rows->request->point))
    count = 0;
  t->next += count;
  t->ends |= count == 0;
  progress_count(t->set->points + (t->threads == 1),
                 t->file ? point_file_rows(t->file, t->set->points + 1) : t->end - t->first);
  pthread_mutex_unlock(&t->lock);
  return count;
}

/* Writes the chunk of a worker after all earlier chunks. */
static void finish_chunk(struct worker *w, long first, long count)
{
  struct loop *t = w->loop;
  struct rows_set *set = t->set;
  pthread_mutex_lock(&t->lock);
  while (t->written != first)
    pthread_cond_wait(&t->turn, &t->lock);
  pthread_mutex_unlock(&t->lock); /* other workers wait until t->written changes */
  bool failed = false;
  for (int i = 0; i < set->count; i++) {
    struct rows *r = &set->rows[i];
    if (t->threads > 1)
      table_join(&r->table, &w->rows[i].table);
    failed |= r->is_open && table_failed(&r->table);
  }
  if (w->unsolved > 0 && set->unsolved == 0)
    memcpy(set->why, w->why, sizeof set->why);
  set->unsolved += w->unsolved;
  set->points += count;
  pthread_mutex_lock(&t->lock);
  t->written = first + count;
  t->ends |= failed;
  pthread_cond_broadcast(&t->turn);
  pthread_mutex_unlock(&t->lock);
}

static void *work(void *worker)
{
  struct worker *w = worker;
  long first;
  for (long count; (count = take_chunk(w, &first)) > 0;) {
    compute(w, first, count);
    finish_chunk(w, first, count);
  }
  return NULL;
}

static void *work_beside(void *worker)
{
  work(worker);
  if (at_flint)
    at_flint->end_thread();
  return NULL;
}

int request_threads(const struct request *r)
{
  const char *variable = getenv("OMP_NUM_THREADS");
  cpu_set_t own;
  long count = r->threads.value;
  if (!r->threads.given && !(variable && read_count(variable, 1, MAX_THREADS, &count)))
    count = sched_getaffinity(0, sizeof own, &own) == 0 ? CPU_COUNT(&own) : 1;
  return (int)count;
}

/* Returns the number of threads and sets the chunk. Several threads need rows that are independent of each other; they
 * are not used for several tables of series, because each thread would derive the series again. */
static int threads_of(struct loop *t)
{
  const struct rows_set *set = t->set;
  const long points = t->end - t->first;
  const bool takes_flint = quantity_needing_flint(set->rows->sheet.required) != NULL;
  bool takes_long = takes_flint, any_order = !t->file && !(takes_flint && set->count > 1);
  for (const struct rows *r = set->rows; r < set->rows + set->count; r++) {
    any_order &= r->is_open && (!r->visit || r->any_order);
    takes_long |= r->visit != NULL;
  }
  const bool is_short = takes_long && points < MIN_POINTS; /* quantities that points share are computed once */
  const int threads = any_order && !is_short ? request_threads(set->rows->request) : 1;
  const long each = points / (CHUNKS * threads), max = takes_long ? MAX_CHUNK : BLOCK_ROWS;
  t->chunk = t->file || each < 1 ? 1 : !takes_long || each > max ? max : each;
  const long chunks = points / t->chunk + (points % t->chunk != 0);
  return threads < chunks ? threads : (int)(chunks > 0 ? chunks : 1);
}

/* Returns false if memory is short; worker_end frees the worker in either case. */
static bool worker_begin(struct worker *w, struct loop *t, bool is_first)
{
  const struct rows_set *set = t->set;
  w->loop = t;
  w->rows = set->rows;
  if (!is_first && !(w->at = at_new(set->rows->sheet.required)))
    return false;
  if (set->count == 1 && !t->file)
    w->block = block_new(set->rows);
  if (t->threads == 1)
    return true;
  w->rows = malloc((size_t)set->count * sizeof *w->rows);
  bool fine = w->rows != NULL;
  for (int i = 0; i < set->count && w->rows; i++) {
    w->rows[i] = set->rows[i];
    fine &= table_part(&w->rows[i].table, &set->rows[i].table);
  }
  return fine;
}

static void worker_end(struct worker *w, struct loop *t)
{
  at_free(w->at);
  sweep_walk_end(&w->walk);
  block_free(w->block);
  for (int i = 0; w->rows && w->rows != t->set->rows && i < t->set->count; i++)
    table_abandon(&w->rows[i].table);
  if (w->rows != t->set->rows)
    free(w->rows);
}

static void run_threads(struct loop *t)
{
  int ready = 1;
  while (ready < t->threads && worker_begin(&t->worker[ready], t, false)
         && pthread_create(&t->worker[ready].thread, NULL, work_beside, &t->worker[ready]) == 0)
    ready++;
  work(&t->worker[0]);
  for (int i = 1; i < ready; i++)
    pthread_join(t->worker[i].thread, NULL);
}

/* Sets the points to compute: all, or a shard. */
static void set_range(struct loop *t)
{
  const struct request *r = t->set->rows->request;
  const struct shard *s = &r->shard;
  const long points = !t->file ? sweep_points(&r->sweep) : s->parts > 0 ? point_file_count(r->points) : LONG_MAX;
  t->first = s->parts > 0 ? shard_begin(s, s->part, points) : 0;
  t->end = s->parts > 0 ? shard_begin(s, s->part + 1, points) : points;
  t->next = t->written = t->first;
  if (t->file)
    tsv_skip(&t->file->tsv, t->first);
}

/* Visits all points. Returns false if memory is short. */
static bool visit_all(struct loop *t, struct at *at)
{
  set_range(t);
  t->threads = threads_of(t);
  struct worker *alone = t->worker = calloc((size_t)t->threads, sizeof *t->worker);
  bool fine = alone != NULL;
  if (fine) {
    alone->at = at;
    fine = worker_begin(alone, t, true);
  }
  if (fine)
    run_threads(t);
  for (int i = 0; i < t->threads && t->worker; i++)
    worker_end(&t->worker[i], t);
  if (!alone)
    at_free(at);
  free(t->worker);
  return fine;
}

enum exit_code rows_visit(struct rows_set *set, struct point_file *file)
{
  const char *command = set->rows->request->style.command, *error = NULL;
  struct loop t = { .set = set, .file = file, .lock = PTHREAD_MUTEX_INITIALIZER, .turn = PTHREAD_COND_INITIALIZER };
  struct at *at = at_new(set->rows->sheet.required);
  bool open = at != NULL, fine = open;
  if (!open)
    return EXIT_UNSOLVED;
  for (int i = 0; i < set->count && open; i++)
    open = set->rows[i].opens_late || rows_open(&set->rows[i]);
  if (!open)
    at_free(at);
  else if (!visit_all(&t, at))
    return complain(command, "out of memory"), EXIT_UNSOLVED;
  if (open && file && (error = tsv_error(&file->tsv)))
    complain(command, "%s", error);
  if (open && set->rows->request->shard.parts > 0)
    table_note(&set->rows->table, "%s", shard_end);
  for (struct rows *r = set->rows; r < set->rows + set->count && open; r++)
    fine &= !r->cannot_open && (!r->is_open || table_flush(&r->table));
  return open && fine && !error ? EXIT_DONE : EXIT_FILE;
}

bool rows_close(struct rows_set *set, bool keep)
{
  bool whole = true;
  for (struct rows *r = set->rows; r < set->rows + set->count; r++)
    if (r->is_open && !keep && !table_failed(&r->table))
      table_abandon(&r->table);
    else if (r->is_open)
      whole &= table_close(&r->table);
  return whole;
}

static enum exit_code finish(struct rows_set *set, enum exit_code code)
{
  const struct request *request = set->rows->request;
  const char *command = request->style.command;
  bool incomplete = set->rows->opens_late && set->unsolved > 0;
  if (!rows_close(set, code == EXIT_DONE && !incomplete))
    return EXIT_FILE;
  if (code != EXIT_DONE)
    return code;
  if (set->unsolved == 0)
    return set->rows->failed_checks > 0 ? EXIT_CHECK_FAILED : EXIT_DONE;
  if (has_many_points(request))
    complain(command, "%ld of %ld points could not be solved: the column 'status' states why", set->unsolved,
             set->points);
  else
    complain(command, "this point could not be solved: %s", set->why);
  return EXIT_UNSOLVED;
}

enum exit_code rows_table(struct rows *r)
{
  const struct style *style = &r->request->style;
  if (r->request->shard.parts > 0 && ((r->visit && !r->any_order) || r->opens_late))
    return complain(style->command, "--shard: this table has no row for each point"), EXIT_USAGE;
  if (r->request->skip_complete && shard_is_complete(style->output, &r->request->shard))
    return EXIT_DONE;
  struct rows_set set = { .count = 1, .rows = r };
  struct quantities *all = &r->sheet.required->quantities;
  struct point_file file = { .v0_may_be_nan = r->sheet.required->from_steady },
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
    code = finish(&set, rows_visit(&set, points));
  if (points)
    point_file_close(points);
  return code;
}
