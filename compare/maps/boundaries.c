/* breakdown --map X Y --boundaries: changes of the modes of the steady state along the lines of a grid, and the parts
 * of boundaries within its cells. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/breakdown/motion.h"
#include "compare/maps/maps.h"
#include "compare/text/progress.h"
#include "numerics/threads.h"

/* The maximum distance of a change from both regions, relative to the value (log axis) or the larger end (linear) */
static const double tolerance = 1e-12;

/* HALVINGS: how often a cell in which boundaries meet is divided into quarters */
enum { MAX_CHANGES = 8, HALVINGS = 5, MAX_NODES = 2001 };

struct map_point { /* in the square, from 0 to 1 along both axes; places with equal modes are in one region */
  double u, v;
  bool rounded; /* solved in double only */
  struct answer answer;
};
struct change { /* at (u, v), between places within the tolerance */
  double u, v;
  struct map_point before, after;
};
struct changes {
  int count, edge; /* edge: index of the first change on the current edge */
  struct change list[4 * MAX_CHANGES];
};
struct boundaries {
  const struct breakdown_options *options;
  const struct sweep_variable *axes[2];
  int cells[2];
  struct table table;
  struct map_point nodes[2][MAX_NODES]; /* the current two lines of the grid; [j % 2] is line j */
};

/* Returns the value at u: linear between the ends at 0 and 1, in the logarithm if the axis is logarithmic. */
static double value_at(const struct sweep_variable *axis, double u)
{
  double from = axis->from.number, to = axis->to.number;
  if (u == 0 || u == 1)
    return u == 0 ? from : to;
  return axis->is_log ? from * pow(to / from, u) : from + u * (to - from);
}

/* Returns |d value/du| over the value on a logarithmic axis, over the larger end on a linear one. */
static double scale_of(const struct sweep_variable *axis)
{
  double from = axis->from.number, to = axis->to.number;
  return fabs(axis->is_log ? log(to / from) : (to - from) / fmax(from, to));
}

/* Solves in binary128 if available, because rounding in double may decide the modes near a boundary. A place without a
 * steady state has no modes. */
static struct map_point place_at(const struct boundaries *b, double u, double v)
{
  struct sweep_place at;
  struct map_point place = { u, v, .rounded = false };
  sweep_place_set(&at, &b->options->request.point);
  sweep_set(&at, b->axes[0], value_at(b->axes[0], u));
  sweep_set(&at, b->axes[1], value_at(b->axes[1], v));
  const struct motion m = motion_of(&at.point, OF_STEADY);
  place.rounded = !answer_in_wide(&place.answer, &m, SCALLOP_BINARY128) && answer_in_double(&place.answer, &m);
  return place;
}

static bool same(const struct map_point *a, const struct map_point *b)
{
  return same_modes(a->answer.modes, b->answer.modes);
}

static double distance(const struct boundaries *b, double du, double dv)
{
  return fmax(fabs(du) * scale_of(b->axes[0]), fabs(dv) * scale_of(b->axes[1]));
}

/* Adds a change. A region thinner than the tolerance, such as a line of symmetry, becomes part of the boundary. */
static void add_change(const struct boundaries *b, struct changes *all, const struct change *c)
{
  struct change *last = all->count > all->edge ? &all->list[all->count - 1] : NULL;
  if (last && same(&last->after, &c->before) && distance(b, c->u - last->u, c->v - last->v) <= 2 * tolerance) {
    *last = (struct change){ (last->u + c->u) / 2, (last->v + c->v) / 2, last->before, c->after };
    all->count -= same(&last->before, &last->after);
  } else if (c->before.answer.status >= 0 && c->after.answer.status >= 0 && all->count < all->edge + MAX_CHANGES) {
    all->list[all->count++] = *c;
  }
}

/* Finds the changes between two places by bisection; finds a region in between if a midpoint lies in it. */
static void find_changes(const struct boundaries *b, struct changes *all, const struct map_point *from,
                         const struct map_point *to)
{
  double u = (from->u + to->u) / 2, v = (from->v + to->v) / 2; /* symmetric in from and to */
  if (same(from, to))
    return;
  if (distance(b, to->u - from->u, to->v - from->v) <= tolerance) {
    add_change(b, all, &(struct change){ u, v, *from, *to });
    return;
  }
  const struct map_point middle = place_at(b, u, v);
  find_changes(b, all, from, &middle);
  find_changes(b, all, &middle, to);
}

/* Returns the changes around a cell, anticlockwise from its corner with the least u and v. */
static struct changes changes_around(const struct boundaries *b, const struct map_point corner[4])
{
  struct changes all = { .count = 0 };
  for (int k = 0; k < 4; k++) {
    all.edge = all.count;
    find_changes(b, &all, &corner[k], &corner[(k + 1) % 4]);
  }
  return all;
}

/* Returns a measure of sticking, by the regime and the number of modes with a stuck body; writes the modes. */
static int sticking_measure(char modes[MOTION_MODES_TEXT], const struct answer *a)
{
  int zeros = 0;
  motion_modes_text(modes, OF_STEADY, a->modes);
  for (const char *mode = modes; *mode; mode++)
    zeros += *mode == '0';
  return (int)a->regime * MOTION_MODES_TEXT + zeros;
}

/* Writes a part of a boundary, from a change to (u, v); region_2 has more sticking than region_1. */
static void write_part(struct boundaries *b, const struct change *from, double u, double v, bool is_guess)
{
  const double ends[2][2] = { { from->u, from->v }, { u, v } };
  const struct answer *sides[] = { &from->before.answer, &from->after.answer };
  bool rounded = from->before.rounded || from->after.rounded;
  char modes[2][MOTION_MODES_TEXT], what[MODE_CHANGE_TEXT];
  int more = sticking_measure(modes[0], sides[0]) - sticking_measure(modes[1], sides[1]);
  bool turned = more != 0 ? more > 0 : strcmp(modes[0], modes[1]) > 0;
  for (int i = 0; i < 4; i++)
    table_number(&b->table, value_at(b->axes[i % 2], ends[(i / 2) ^ turned][i % 2]));
  table_text(&b->table, modes[turned]);
  table_text(&b->table, modes[!turned]);
  table_text(&b->table, mode_change_text(what, sides[turned], sides[!turned]));
  table_text(&b->table, is_guess ? "one end is a guess: boundaries meet there" : rounded ? "in double" : "ok");
}

static void write_quarters(struct boundaries *b, const struct map_point corner[4], int halvings);

/* Writes the parts of boundaries in a cell. The modes change from A to B at the point in
 * which a boundary enters, and from B to A at the point in which it leaves. If changes are left, boundaries meet: in
 * one of the quarters, or, after the last halving, about at the mean of these changes. */
static void write_parts(struct boundaries *b, const struct map_point corner[4], const struct changes *around,
                        int halvings)
{
  const struct change *c = around->list;
  int partner[4 * MAX_CHANGES], left = around->count;
  double u = 0, v = 0;
  for (int p = 0; p < around->count; p++)
    partner[p] = -1;
  for (int p = 0; p < around->count; p++)
    for (int q = p + 1; q < around->count && partner[p] < 0; q++)
      if (partner[q] < 0 && same(&c[p].before, &c[q].after) && same(&c[p].after, &c[q].before)) {
        partner[p] = q;
        partner[q] = p;
        left -= 2;
      }
  if (left > 0 && halvings > 0) {
    write_quarters(b, corner, halvings - 1);
    return;
  }
  for (int p = 0; p < around->count; p++) {
    if (partner[p] > p)
      write_part(b, &c[p], c[partner[p]].u, c[partner[p]].v, false);
    u += partner[p] < 0 ? c[p].u / left : 0;
    v += partner[p] < 0 ? c[p].v / left : 0;
  }
  for (int p = 0; p < around->count; p++)
    if (partner[p] < 0)
      write_part(b, &c[p], u, v, true);
}

static void write_quarters(struct boundaries *b, const struct map_point corner[4], int halvings)
{
  struct map_point middle[4]; /* midpoint of the edge behind each corner */
  double u = corner[0].u + (corner[2].u - corner[0].u) / 2, v = corner[0].v + (corner[2].v - corner[0].v) / 2;
  const struct map_point centre = place_at(b, u, v);
  for (int k = 0; k < 4; k++)
    middle[k] = place_at(b, k % 2 ? corner[k].u : u, k % 2 ? v : corner[k].v);
  for (int k = 0; k < 4; k++) {
    struct map_point quarter[4];
    quarter[k] = corner[k];
    quarter[(k + 1) % 4] = middle[k];
    quarter[(k + 2) % 4] = centre;
    quarter[(k + 3) % 4] = middle[(k + 3) % 4];
    const struct changes around = changes_around(b, quarter);
    write_parts(b, quarter, &around, halvings);
  }
}

/* Returns line i of the grid, avoiding the ends, and simple fractions, because these are often lines of symmetry. */
static double grid_line(int i, int cells)
{
  static const double inside = 1e-11;
  return i == 0 ? inside : i == cells ? 1 - inside : (i + 0.0618) / (cells + 0.1);
}

/* Solves row j of the nodes, and writes the boundaries between it and the row before. */
static void write_row(struct boundaries *b, int j)
{
  const int cells = b->cells[0];
  struct map_point *low = b->nodes[(j + 1) % 2], *high = b->nodes[j % 2];
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(0, cells))
  for (int i = 0; i <= cells; i++)
    high[i] = place_at(b, grid_line(i, cells), grid_line(j, b->cells[1]));
#pragma omp parallel for ordered schedule(dynamic) num_threads(threads_for(0, cells))
  for (int i = 0; i < (j > 0 ? cells : 0); i++) {
    const struct map_point corner[4] = { low[i], low[i + 1], high[i + 1], high[i] };
    const struct changes around = changes_around(b, corner);
#ifdef _OPENMP
#pragma omp ordered
#endif
    write_parts(b, corner, &around, HALVINGS);
  }
}

static bool begin_table(struct boundaries *b)
{
  struct table *t = &b->table;
  static char to[2][32];
  const char *const *names = b->options->map;
  if (!table_head(t, &b->options->request.style, "breakdown --map %s %s --boundaries", names[0], names[1]))
    return false;
  t->of = "boundaries";
  map_head(t, b->options);
  table_note(t, "regions: of the same modes; a row: the part of a boundary within a cell of the grid, from one edge of "
                "it to another");
  table_note(t, "region_1 is on the left from the first end to the second, x to the right and y up; change: from "
                "region_1 to region_2");
  for (int i = 0; i < 2; i++)
    snprintf(to[i], sizeof to[i], "to_%s", names[i]);
  table_columns(
      t, (const char *const[]){ names[0], names[1], to[0], to[1], "region_1", "region_2", "change", "status", NULL });
  table_begin_rows(t);
  return true;
}

enum exit_code breakdown_boundaries(const struct breakdown_options *o)
{
  static struct boundaries b; /* too large for the stack */
  b.options = o;
  for (int i = 0; i < 2; i++) {
    const struct sweep_variable *v = b.axes[i] = map_axis(o, i);
    if (v->count < 2 || v->count > MAX_NODES || !(v->from.number < v->to.number)) {
      complain("breakdown", "--%c: --boundaries takes 2 to %d values along each axis, with FROM < TO", "xy"[i],
               MAX_NODES);
      return EXIT_USAGE;
    }
    b.cells[i] = (int)v->count - 1;
  }
  if (!begin_table(&b))
    return EXIT_FILE;
  for (int j = 0; j <= b.cells[1] && !table_failed(&b.table); j++) {
    progress_count(j, b.cells[1]);
    write_row(&b, j);
  }
  progress_end();
  return table_close(&b.table) ? EXIT_DONE : EXIT_FILE;
}
