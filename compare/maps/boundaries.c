/* breakdown --map X Y --boundaries: where the modes of the steady state change along the lines of a grid, and the parts
 * of the boundaries that lie within its cells. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/breakdown/motion.h"
#include "compare/maps/maps.h"
#include "compare/text/memory.h"
#include "compare/text/progress.h"
#include "numerics/threads.h"

/* How near a change lies to both of its regions: relative on a logarithmic axis, of the larger end on a linear one. */
static const double promise = 1e-12;

/* Of boundaries that meet in a cell the halves of its halves ... are looked at, so many times. */
enum { NOWHERE = -1, MOST_CHANGES = 8, HALVINGS = 5 };

struct place { /* in the square, from 0 to 1 along both axes */
  double u, v;
  int region; /* its number, or NOWHERE: there is no steady state */
};
struct change {
  double u, v;
  int before, after;
};
struct changes {
  int count;
  struct change list[4 * MOST_CHANGES];
};
/* Of a boundary, from a change to (u, v): the region before is on the left. */
struct part {
  struct change from;
  double u, v;
  bool is_guess; /* the end */
};
struct parts {
  long count;
  struct part *list;
};

struct region {
  struct answer answer;
  char modes[MOTION_MODES_TEXT];
};
struct boundaries {
  const struct breakdown_options *options;
  struct axis axes[2];
  int cells[2];
  struct place *rows[2]; /* of nodes: below and above the cells that are at hand */
  struct parts *parts;   /* of these cells */
  struct region *regions;
  int count;
  bool in_double, out_of_memory;
};

/* By one thread at a time. */
static int number_of(struct boundaries *b, const struct answer *a)
{
  for (int i = 0; i < b->count; i++)
    if (same_modes(b->regions[i].answer.modes, a->modes))
      return i;
  struct region *regions = with_room(b->regions, b->count, sizeof *regions);
  if (!regions) {
    b->out_of_memory = true;
    return NOWHERE;
  }
  b->regions = regions;
  regions[b->count].answer = *a;
  motion_modes_text(regions[b->count].modes, OF_STEADY, a->modes);
  return b->count++;
}

/* In binary128, where there is one: rounding in double may choose the modes near a boundary. */
static struct place place_at(struct boundaries *b, double u, double v)
{
  const struct scallop_crawler *base = &b->options->request.point.crawler;
  const struct motion m = {
    .of = OF_STEADY, .crawler = axes_crawler(b->axes, base, axis_value(&b->axes[0], u), axis_value(&b->axes[1], v))
  };
  struct place place = { u, v, NOWHERE };
  struct answer a;
  bool wide = answer_in_wide(&a, &m, SCALLOP_BINARY128);
  if (!wide && !answer_in_double(&a, &m))
    return place;
#ifdef _OPENMP
#pragma omp critical
#endif
  {
    b->in_double |= !wide;
    place.region = number_of(b, &a);
  }
  return place;
}

static double apart(const struct boundaries *b, double du, double dv)
{
  return fmax(fabs(du) * axis_scale(&b->axes[0]), fabs(dv) * axis_scale(&b->axes[1]));
}

/* A region that is thinner than the promise, such as a line on which a symmetry holds, is a part of the boundary. */
static void add_change(const struct boundaries *b, struct changes *all, struct change c)
{
  struct change *last = all->count > 0 ? &all->list[all->count - 1] : NULL;
  if (last && last->after == c.before && apart(b, c.u - last->u, c.v - last->v) <= 2 * promise) {
    last->after = c.after;
    all->count -= last->before == last->after;
  } else if (c.before != NOWHERE && c.after != NOWHERE && all->count < MOST_CHANGES) {
    all->list[all->count++] = c;
  }
}

/* A region between two places is seen where a half of a half ... ends in it. */
static void find_changes(struct boundaries *b, struct changes *all, struct place from, struct place to)
{
  if (from.region == to.region)
    return;
  double u = from.u + (to.u - from.u) / 2, v = from.v + (to.v - from.v) / 2;
  if (apart(b, to.u - from.u, to.v - from.v) <= promise) {
    add_change(b, all, (struct change){ u, v, from.region, to.region });
    return;
  }
  const struct place middle = place_at(b, u, v);
  find_changes(b, all, from, middle);
  find_changes(b, all, middle, to);
}

/* Around a cell, against the clock from its corner with the least u and v. */
static struct changes changes_around(struct boundaries *b, const struct place corner[4])
{
  struct changes all = { .count = 0 };
  for (int k = 0; k < 4; k++) {
    struct changes edge = { .count = 0 };
    bool back = k >= 2; /* the same edge is always halved from the same end */
    find_changes(b, &edge, corner[back ? (k + 1) % 4 : k], corner[back ? k : k + 1]);
    for (int i = 0; i < edge.count; i++) {
      struct change c = edge.list[back ? edge.count - 1 - i : i];
      all.list[all.count++] = back ? (struct change){ c.u, c.v, c.after, c.before } : c;
    }
  }
  return all;
}

static void add_part(struct boundaries *b, struct parts *parts, struct part part)
{
  struct part *list = with_room(parts->list, parts->count, sizeof *list);
  if (!list) {
    b->out_of_memory = true;
    return;
  }
  parts->list = list;
  parts->list[parts->count++] = part;
}

/* The changes that are left go to their middle. */
static void add_guesses(struct boundaries *b, struct parts *parts, const struct changes *left)
{
  double u = 0, v = 0;
  for (int i = 0; i < left->count; i++) {
    u += left->list[i].u / left->count;
    v += left->list[i].v / left->count;
  }
  for (int i = 0; i < left->count; i++)
    add_part(b, parts, (struct part){ left->list[i], u, v, true });
}

static void quarter(struct boundaries *b, struct parts *parts, const struct place corner[4], int halvings);

/* A boundary that comes into a cell with the regions A and B beside it goes out with B and A. */
static void find_parts(struct boundaries *b, struct parts *parts, const struct place corner[4], int halvings)
{
  const struct changes around = changes_around(b, corner);
  struct changes left = { .count = 0 };
  bool done[4 * MOST_CHANGES] = { false };
  const long before = parts->count;
  for (int p = 0; p < around.count; p++) {
    const struct change *in = &around.list[p], *out;
    for (int q = p + 1; q < around.count && !done[p]; q++) {
      out = &around.list[q];
      if (!done[q] && in->before == out->after && in->after == out->before) {
        add_part(b, parts, (struct part){ *in, out->u, out->v, false });
        done[p] = done[q] = true;
      }
    }
    if (!done[p])
      left.list[left.count++] = *in;
  }
  if (left.count == 0 || halvings == 0) {
    add_guesses(b, parts, &left);
    return;
  }
  parts->count = before;
  quarter(b, parts, corner, halvings - 1);
}

/* Nodes of the quarters: the corners, the middles of the edges behind each, and the centre */
static void quarter(struct boundaries *b, struct parts *parts, const struct place corner[4], int halvings)
{
  struct place middle[4];
  double u = corner[0].u + (corner[2].u - corner[0].u) / 2, v = corner[0].v + (corner[2].v - corner[0].v) / 2;
  const struct place centre = place_at(b, u, v);
  for (int k = 0; k < 4; k++)
    middle[k] = place_at(b, k % 2 ? corner[k].u : u, k % 2 ? v : corner[k].v);
  find_parts(b, parts, (struct place[4]){ corner[0], middle[0], centre, middle[3] }, halvings);
  find_parts(b, parts, (struct place[4]){ middle[0], corner[1], middle[1], centre }, halvings);
  find_parts(b, parts, (struct place[4]){ centre, middle[1], corner[2], middle[2] }, halvings);
  find_parts(b, parts, (struct place[4]){ middle[3], centre, middle[2], corner[3] }, halvings);
}

/* Line i of the grid: not at even fractions, where symmetries hold more often than elsewhere, and a little inside. */
static double grid_line(int i, int cells)
{
  static const double inside = 1e-11;
  return i == 0 ? inside : i == cells ? 1 - inside : (i + 0.0618) / (cells + 0.1);
}

/* Row j of the nodes, and the boundaries between it and the one before. */
static void find_row(struct boundaries *b, int j)
{
  struct place *low = b->rows[0], *high = b->rows[1];
  const int cells = b->cells[0];
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(0, cells))
  for (int i = 0; i <= cells; i++)
    high[i] = place_at(b, grid_line(i, cells), grid_line(j, b->cells[1]));
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(0, cells))
  for (int i = 0; i < cells; i++) {
    b->parts[i].count = 0;
    if (j > 0)
      find_parts(b, &b->parts[i], (struct place[4]){ low[i], low[i + 1], high[i + 1], high[i] }, HALVINGS);
  }
}

/* The bodies that rest in the modes */
static int rests(const char *modes)
{
  int count = 0;
  for (; *modes; modes++)
    count += *modes == '0';
  return count;
}

/* From region_1 to region_2 there is more sticking. */
static bool comes_second(const struct region *a, const struct region *b)
{
  int more = a->answer.regime != b->answer.regime ? (int)a->answer.regime - (int)b->answer.regime
                                                  : rests(a->modes) - rests(b->modes);
  return more != 0 ? more > 0 : strcmp(a->modes, b->modes) > 0;
}

static void write_part(const struct boundaries *b, struct table *t, const struct part *p)
{
  const struct region *left = &b->regions[p->from.before], *right = &b->regions[p->from.after];
  double x[2] = { axis_value(&b->axes[0], p->from.u), axis_value(&b->axes[0], p->u) };
  double y[2] = { axis_value(&b->axes[1], p->from.v), axis_value(&b->axes[1], p->v) };
  char what[MODE_CHANGE_TEXT];
  bool turned = comes_second(left, right);
  const struct region *one = turned ? right : left, *two = turned ? left : right;
  for (int i = 0; i < 2; i++) {
    table_number(t, x[i ^ turned]);
    table_number(t, y[i ^ turned]);
  }
  table_text(t, one->modes);
  table_text(t, two->modes);
  table_text(t, mode_change_text(what, &one->answer, &two->answer));
  table_text(t, p->is_guess ? "one end is a guess: boundaries meet there" : b->in_double ? "in double" : "ok");
}

static void begin_table(const struct boundaries *b, struct table *t)
{
  static char to[2][32];
  t->of = "boundaries";
  axes_head(t, b->options, b->axes, " --boundaries");
  table_note(t, "regions: of the same modes; a row: the part of a boundary within a cell of the grid, from one edge of "
                "it to another");
  table_note(t, "region_1 is on the left from the first end to the second, x to the right and y up; what: happens from "
                "region_1 to region_2");
  for (int i = 0; i < 2; i++)
    snprintf(to[i], sizeof to[i], "to_%s", b->axes[i].name);
  table_columns(t, (const char *const[]){ b->axes[0].name, b->axes[1].name, to[0], to[1], "region_1", "region_2",
                                          "what", "status", NULL });
  table_begin_rows(t);
}

static enum exit_code run(struct boundaries *b, struct table *t)
{
  const struct progress progress = progress_begin(b->options->request.style.quiet);
  begin_table(b, t);
  for (int j = 0; j <= b->cells[1] && !b->out_of_memory && !table_failed(t); j++) {
    progress_show(&progress, "row %d of %d", j, b->cells[1]);
    find_row(b, j);
    for (int i = 0; j > 0 && i < b->cells[0]; i++)
      for (long k = 0; k < b->parts[i].count; k++)
        write_part(b, t, &b->parts[i].list[k]);
    struct place *above = b->rows[1];
    b->rows[1] = b->rows[0];
    b->rows[0] = above;
  }
  progress_end(&progress);
  if (!b->out_of_memory)
    return table_close(t) ? EXIT_DONE : EXIT_FILE;
  complain("breakdown", "out of memory");
  table_abandon(t);
  return EXIT_UNSOLVED;
}

enum exit_code breakdown_boundaries(const struct breakdown_options *o)
{
  enum { LEAST = 2, MOST = 2001 };
  struct boundaries b = { .options = o };
  struct table t;
  if (!axes_read(b.axes, o->map, o->range, &o->request.point))
    return EXIT_USAGE;
  for (int i = 0; i < 2; i++) {
    if (b.axes[i].count < LEAST || b.axes[i].count > MOST) {
      complain("breakdown", "--%c: %ld values; --boundaries takes 2 to 2001 along each axis", "xy"[i], b.axes[i].count);
      return EXIT_USAGE;
    }
    b.cells[i] = (int)b.axes[i].count - 1;
  }
  const size_t nodes = (size_t)b.axes[0].count;
  for (int i = 0; i < 2; i++)
    b.rows[i] = calloc(nodes, sizeof *b.rows[i]);
  b.parts = calloc(nodes, sizeof *b.parts);
  b.out_of_memory = !b.rows[0] || !b.rows[1] || !b.parts;
  enum exit_code code = table_open(&t, &o->request.style) ? run(&b, &t) : EXIT_FILE;
  for (size_t i = 0; b.parts && i < nodes; i++)
    free(b.parts[i].list);
  for (int i = 0; i < 2; i++)
    free(b.rows[i]);
  free(b.parts);
  free(b.regions);
  return code;
}
