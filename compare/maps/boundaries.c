/* breakdown --map X Y --boundaries: the curves between the regions of a map in which the modes of the steady state are
 * the same. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/mode_change.h"
#include "compare/maps/curves.h"
#include "compare/maps/maps.h"
#include "compare/text/memory.h"
#include "compare/text/progress.h"
#include "numerics/threads.h"

/* How far from a printed point each of the two regions is looked for: relative on a logarithmic axis, of the larger end
 * on a linear one. */
static const double promise = 1e-12;

struct boundaries {
  const struct breakdown_options *options;
  struct axis axes[2];
  struct answer *regions; /* their modes, and how one may come there */
  int count;
  bool out_of_memory;
};

static struct motion motion_at(const struct boundaries *b, double u, double v)
{
  const struct scallop_crawler *base = &b->options->request.point.crawler;
  return (struct motion){
    .of = OF_STEADY, .crawler = axes_crawler(b->axes, base, axis_value(&b->axes[0], u), axis_value(&b->axes[1], v))
  };
}

/* Of both bodies alike: the sign of their velocity where a phase begins (end: false) or ends; 0 where they differ or
 * one is at rest. */
static int common_sign(const struct scallop_modes *m, bool end)
{
  if (m->count == 0 || m->count > SCALLOP_MODES_KEPT)
    return 0;
  struct scallop_mode mode = m->kept[end ? m->count - 1 : 0];
  return mode.s1 == mode.s2 ? mode.s1 : 0;
}

/* Whether rounding may have chosen the modes: a phase ends with a velocity with which the next one does not begin, or
 * that is tiny. */
static bool is_uncertain(const struct scallop_crawler *c, const struct answer *a)
{
  const double tiny = 1e-13 * c->L / c->T, v[2] = { fabs(a->value[Q_V_START].high), fabs(a->value[Q_V_MID].high) };
  for (int phase = 0; phase < 2; phase++)
    if (common_sign(&a->modes[1 - phase], true) != common_sign(&a->modes[phase], false)
        || (v[phase] > 0 && v[phase] < tiny))
      return true;
  return false;
}

/* In double where that decides, else in wider arithmetic where that can. */
static bool solve(const struct motion *m, struct answer *a)
{
  struct answer wide;
  if (!answer_in_double(a, m))
    return false;
  if (is_uncertain(&m->crawler, a) && answer_in_wide(&wide, m, SCALLOP_BINARY128))
    *a = wide;
  a->value[Q_V_START].high = common_sign(&a->modes[0], false);
  return true;
}

/* By one thread at a time. */
static int number_of(struct boundaries *b, const struct answer *r)
{
  for (int i = 0; i < b->count; i++)
    if (same_modes(b->regions[i].modes, r->modes))
      return i;
  struct answer *regions = with_room(b->regions, b->count, sizeof *regions);
  if (!regions) {
    b->out_of_memory = true;
    return MAP_NOWHERE;
  }
  b->regions = regions;
  b->regions[b->count] = *r;
  return b->count++;
}

static int region_at(void *context, double u, double v)
{
  struct boundaries *b = context;
  struct answer r;
  const struct motion m = motion_at(b, u, v);
  int found;
  if (!solve(&m, &r))
    return MAP_NOWHERE;
#ifdef _OPENMP
#pragma omp critical
#endif
  found = number_of(b, &r);
  return found;
}

/* What a point is found to be when it is looked at more closely. Which side of the curve a place is on is told by the
 * modes in binary128. */
enum outcome { CHECKED, IN_DOUBLE, NOT_THERE };
enum side { ON_LEFT, ON_RIGHT, ON_OTHER, ON_UNKNOWN };

static enum side side_of(const struct boundaries *b, const struct map_curve *c, const struct map_point *p,
                         double distance)
{
  struct answer r;
  const struct motion m = motion_at(b, p->u + distance * p->nu, p->v + distance * p->nv);
  if (!answer_in_wide(&r, &m, SCALLOP_BINARY128))
    return ON_UNKNOWN;
  if (same_modes(b->regions[c->left].modes, r.modes))
    return ON_LEFT;
  return same_modes(b->regions[c->right].modes, r.modes) ? ON_RIGHT : ON_OTHER;
}

static bool is_within(const struct boundaries *b, const struct map_curve *c, const struct map_point *p, double distance)
{
  return side_of(b, c, p, distance) == ON_LEFT && side_of(b, c, p, -distance) == ON_RIGHT;
}

/* The promise in u and v, across the curve */
static double promised(const struct boundaries *b, const struct map_point *p)
{
  return promise / fmax(fabs(p->nu) * axis_scale(&b->axes[0]), fabs(p->nv) * axis_scale(&b->axes[1]));
}

/* The curve lies within that distance of the point: moves it there. */
static void bisect(const struct boundaries *b, const struct map_curve *c, struct map_point *p, double far,
                   double enough)
{
  double right = -far, left = far;
  while (left - right > enough) {
    double middle = right + (left - right) / 2;
    *(side_of(b, c, p, middle) == ON_RIGHT ? &right : &left) = middle;
  }
  double middle = right + (left - right) / 2;
  p->u += middle * p->nu;
  p->v += middle * p->nv;
}

/* Modes in double are those of the other side within rounding of a curve. Where they misled, the curve is sought
 * again. */
static enum outcome check(const struct boundaries *b, const struct map_curve *c, struct map_point *p)
{
  enum { WIDER = 7 };
  double near = promised(b, p), far = near;
  if (side_of(b, c, p, near) == ON_UNKNOWN || side_of(b, c, p, -near) == ON_UNKNOWN)
    return IN_DOUBLE;
  if (is_within(b, c, p, near))
    return CHECKED;
  bool found = false;
  for (int i = 0; i < WIDER && !found; i++)
    found = is_within(b, c, p, far *= 8);
  if (found)
    bisect(b, c, p, far, near / 8);
  return found && is_within(b, c, p, near) ? CHECKED : NOT_THERE;
}

/* Points are printed evenly: the short steps before a bend or an end are left out. */
static void make_even(struct map_curve *c, double step)
{
  const struct map_point end = c->points[c->count - 1];
  struct map_point *last = c->points;
  for (long i = 1; i + 1 < c->count; i++) {
    const struct map_point *p = &c->points[i];
    if (hypot(p->u - last->u, p->v - last->v) >= 0.6 * step && hypot(p->u - end.u, p->v - end.v) >= 0.3 * step)
      *++last = *p;
  }
  if (c->count > 1)
    *++last = end;
  c->count = last - c->points + 1;
}

static void write_curve(const struct boundaries *b, struct table *t, long number, const struct map_curve *c,
                        const enum outcome *outcomes)
{
  static const char *const ends[] = { "-", "open", "closed", "junction", "stops" };
  static const char *const statuses[] = { "ok", "not checked in wider arithmetic", "other modes within 1e-12" };
  const struct answer *left = &b->regions[c->left], *right = &b->regions[c->right];
  char modes[MOTION_MODES_TEXT], what[MODE_CHANGE_TEXT];
  for (long i = 0; i < c->count; i++) {
    const struct map_point *p = &c->points[i];
    table_number(t, (double)number);
    table_number(t, (double)(i + 1));
    table_number(t, axis_value(&b->axes[0], p->u));
    table_number(t, axis_value(&b->axes[1], p->v));
    table_text(t, motion_modes_text(modes, OF_STEADY, left->modes));
    table_text(t, motion_modes_text(modes, OF_STEADY, right->modes));
    table_text(t, mode_change_text(what, left, right));
    table_text(t, ends[p->end]);
    table_text(t, p->third == MAP_NOWHERE ? "-" : motion_modes_text(modes, OF_STEADY, b->regions[p->third].modes));
    table_text(t, p->end == MAP_STOPS ? "could not be followed further" : statuses[outcomes[i]]);
  }
}

/* False: out of memory. */
static bool do_curve(struct boundaries *b, struct table *t, long number, struct map_curve *c, double step)
{
  enum outcome *outcomes = calloc((size_t)c->count, sizeof *outcomes);
  if (!outcomes)
    return false;
  if (b->regions[c->left].regime > b->regions[c->right].regime) /* from region_1 to region_2 there is more sticking */
    map_curve_reverse(c);
  make_even(c, step);
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(0, c->count))
  for (long i = 0; i < c->count; i++)
    outcomes[i] = check(b, c, &c->points[i]);
  write_curve(b, t, number, c, outcomes);
  free(outcomes);
  return true;
}

static void begin_table(const struct boundaries *b, struct table *t)
{
  t->of = "boundaries";
  axes_head(t, b->options, b->axes, " --boundaries");
  table_note(t, "regions: of the same modes; region_1 is on the left as the points go, x to the right and y up");
  table_note(t, "what: happens from region_1 to region_2; meets: the third region at a junction");
  table_note(
      t,
      "found: every curve that crosses a line of the grid at which the modes of its nodes differ, and what meets it");
  table_columns(t, (const char *const[]){ "curve", "point", b->axes[0].name, b->axes[1].name, NULL });
  table_columns(t, (const char *const[]){ "region_1", "region_2", "what", "end", "meets", "status", NULL });
  table_begin_rows(t);
}

static enum exit_code run(struct boundaries *b, struct table *t)
{
  struct map_curves curves = { .count = 0 };
  int columns = (int)b->axes[0].count - 1, rows = (int)b->axes[1].count - 1;
  double step = 1.0 / (columns > rows ? columns : rows);
  const struct progress progress = progress_begin(b->options->request.style.quiet);
  progress_show(&progress, "following the boundaries");
  bool done = map_follow(region_at, b, columns, rows, step, &curves) && !b->out_of_memory;
  begin_table(b, t);
  for (long i = 0; done && i < curves.count && !table_failed(t); i++) {
    progress_show(&progress, "curve %ld of %ld", i + 1, curves.count);
    done = do_curve(b, t, i + 1, &curves.curves[i], step);
  }
  progress_end(&progress);
  if (curves.lost > 0)
    table_note(t, "changes from which no curve could be followed: %ld", curves.lost);
  map_curves_clear(&curves);
  free(b->regions);
  if (done)
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
  for (int i = 0; i < 2; i++)
    if (b.axes[i].count < LEAST || b.axes[i].count > MOST) {
      complain("breakdown", "--%c: %ld values; --boundaries takes 2 to 2001 along each axis", "xy"[i], b.axes[i].count);
      return EXIT_USAGE;
    }
  return table_open(&t, &o->request.style) ? run(&b, &t) : EXIT_FILE;
}
