/* breakdown --map X Y --boundaries: the curves between the regions of a map in which the modes of the steady state are the same. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/answers/exact.h"
#include "numerics/numerics.h"
#include "compare/maps/map.h"
#include "compare/answers/mode_change.h"
#include "compare/command/with_flint.h"
#include "numerics/threads.h"
#include "numerics/wide.h"

/* How far from a printed point each of the two regions is looked for: relative on a logarithmic axis, of the larger end on a linear one. */
static const double promise = 1e-12;

struct region {
  struct scallop_modes modes[2];
  enum scallop_regime regime;
  double v_start; /* its sign */
};

struct boundaries {
  const struct options *options;
  struct axis axes[2];
  struct region *regions;
  int count;
  bool out_of_memory;
};

/* ---- regions ---- */

static bool same_modes(const struct scallop_modes a[2], const struct scallop_modes b[2])
{
  for (int phase = 0; phase < 2; phase++) {
    if (a[phase].count != b[phase].count)
      return false;
    for (int i = 0; i < a[phase].count && i < SCALLOP_MODES_KEPT; i++)
      if (a[phase].kept[i].s1 != b[phase].kept[i].s1 || a[phase].kept[i].s2 != b[phase].kept[i].s2)
        return false;
  }
  return true;
}

static struct scallop_crawler crawler_at(const struct boundaries *b, double u, double v)
{
  return axes_crawler(b->axes, &b->options->point.crawler, axis_value(&b->axes[0], u), axis_value(&b->axes[1], v));
}

/* Of both bodies alike: the sign of their velocity where a phase begins (end: false) or ends; 0 where they differ or one is at rest. */
static int common_sign(const struct scallop_modes *m, bool end)
{
  if (m->count == 0 || m->count > SCALLOP_MODES_KEPT)
    return 0;
  struct scallop_mode mode = m->kept[end ? m->count - 1 : 0];
  return mode.s1 == mode.s2 ? mode.s1 : 0;
}

/* Whether rounding may have chosen the modes: a phase ends with a velocity with which the next one does not begin, or that is tiny. */
static bool is_uncertain(const struct scallop_crawler *c, const struct scallop_period_result *p)
{
  const double tiny = 1e-13 * c->L / c->T, v[2] = { fabs(p->v_start), fabs(p->v_mid) };
  for (int phase = 0; phase < 2; phase++)
    if (common_sign(&p->modes[1 - phase], true) != common_sign(&p->modes[phase], false) || (v[phase] > 0 && v[phase] < tiny))
      return true;
  return false;
}

/* Wider arithmetic tells where it can. */
static bool solve(const struct scallop_crawler *c, struct region *r)
{
  struct scallop_steady_result plain;
  struct scallop_wide_steady wide;
  if (scallop_steady(c, &plain) < 0)
    return false;
  bool widely = is_uncertain(c, &plain.period) && scallop_wide_steady(SCALLOP_BINARY128, c, &wide) >= 0;
  memcpy(r->modes, widely ? wide.period.modes : plain.period.modes, sizeof r->modes);
  r->regime = widely ? wide.period.regime : plain.period.regime;
  r->v_start = common_sign(&r->modes[0], false);
  return true;
}

static int add_region(struct boundaries *b, const struct region *r)
{
  if ((b->count & (b->count - 1)) == 0) {
    struct region *more = realloc(b->regions, (size_t)(b->count > 0 ? 2 * b->count : 1) * sizeof *more);
    if (!more) {
      b->out_of_memory = true;
      return MAP_NOWHERE;
    }
    b->regions = more;
  }
  b->regions[b->count] = *r;
  return b->count++;
}

static int region_at(void *context, double u, double v)
{
  struct boundaries *b = context;
  struct region r;
  const struct scallop_crawler c = crawler_at(b, u, v);
  int found = MAP_NOWHERE;
  if (!solve(&c, &r))
    return MAP_NOWHERE;
#ifdef _OPENMP
#pragma omp critical
#endif
  {
    for (int i = 0; i < b->count && found == MAP_NOWHERE; i++)
      if (same_modes(b->regions[i].modes, r.modes))
        found = i;
    if (found == MAP_NOWHERE)
      found = add_region(b, &r);
  }
  return found;
}

/* ---- a point looked at more closely ---- */

/* Which side of the curve a place is on, from the modes in binary128: */
enum side { ON_LEFT, ON_RIGHT, ON_OTHER, ON_UNKNOWN };

struct checked {
  struct map_point point;
  bool kept; /* to be printed */
  enum { CHECKED, IN_DOUBLE, NOT_THERE } outcome;
};

static enum side side_of(const struct boundaries *b, const struct map_curve *c, const struct map_point *p, double distance)
{
  struct scallop_wide_steady r;
  const struct scallop_crawler crawler = crawler_at(b, p->u + distance * p->nu, p->v + distance * p->nv);
  if (scallop_wide_steady(SCALLOP_BINARY128, &crawler, &r) < 0)
    return ON_UNKNOWN;
  return same_modes(b->regions[c->left].modes, r.period.modes)    ? ON_LEFT
         : same_modes(b->regions[c->right].modes, r.period.modes) ? ON_RIGHT
                                                                  : ON_OTHER;
}

/* The promise in u and v, across the curve */
static double promised(const struct boundaries *b, const struct map_point *p)
{
  return promise / fmax(fabs(p->nu) * axis_scale(&b->axes[0]), fabs(p->nv) * axis_scale(&b->axes[1]));
}

/* The curve lies between the two distances from the point: moves it there. */
static void bisect(const struct boundaries *b, const struct map_curve *c, struct map_point *p, double right, double left,
                   double enough)
{
  while (left - right > enough) {
    double middle = right + (left - right) / 2;
    *(side_of(b, c, p, middle) == ON_RIGHT ? &right : &left) = middle;
  }
  double middle = right + (left - right) / 2;
  p->u += middle * p->nu;
  p->v += middle * p->nv;
}

/* Modes in double are those of the other side within rounding of a curve. Where they misled, the curve is sought again. */
static void check(const struct boundaries *b, const struct map_curve *c, struct checked *k)
{
  enum { WIDER = 7 };
  struct map_point *p = &k->point;
  double near = promised(b, p);
  enum side left = side_of(b, c, p, near), right = side_of(b, c, p, -near);
  if (left == ON_UNKNOWN || right == ON_UNKNOWN) {
    k->outcome = IN_DOUBLE;
    return;
  }
  double far = near;
  for (int i = 0; i < WIDER && (left != ON_LEFT || right != ON_RIGHT); i++) {
    far *= 8;
    left = side_of(b, c, p, far);
    right = side_of(b, c, p, -far);
  }
  if (far > near && left == ON_LEFT && right == ON_RIGHT) {
    bisect(b, c, p, -far, far, near / 8);
    left = side_of(b, c, p, near);
    right = side_of(b, c, p, -near);
  }
  k->outcome = left == ON_LEFT && right == ON_RIGHT ? CHECKED : NOT_THERE;
}

/* ---- which points are printed ---- */

static bool is_end(const struct map_curve *c, long i) { return i == 0 || i == c->count - 1; }

/* Evenly: the short steps before a bend or an end are left out. */
static void choose(const struct map_curve *c, double step, struct checked *checked)
{
  const struct map_point *last = &c->points[0], *end = &c->points[c->count - 1];
  for (long i = 0; i < c->count; i++) {
    const struct map_point *p = &c->points[i];
    bool apart = hypot(p->u - last->u, p->v - last->v) >= 0.6 * step && hypot(p->u - end->u, p->v - end->v) >= 0.3 * step;
    checked[i] = (struct checked){ .point = *p, .kept = is_end(c, i) || apart };
    if (apart)
      last = p;
  }
}

/* ---- the table ---- */

static const char *end_text(enum map_end end)
{
  static const char *const texts[] = { "-", "open", "closed", "junction", "stops" };
  return texts[end];
}

static void modes_of(const struct boundaries *b, int region, char text[PERIOD_MODES_TEXT])
{
  if (region == MAP_NOWHERE)
    memcpy(text, "-", 2);
  else
    period_modes_text(text, b->regions[region].modes);
}

static const char *what_changes(const struct boundaries *b, const struct map_curve *c, char text[MODE_CHANGE_TEXT])
{
  const struct region *r1 = &b->regions[c->left], *r2 = &b->regions[c->right];
  const struct mode_state before = { r1->modes, r1->regime, r1->v_start }, after = { r2->modes, r2->regime, r2->v_start };
  return mode_change_text(text, &before, &after);
}

static const char *status_text(const struct checked *k)
{
  if (k->point.end == MAP_STOPS)
    return "could not be followed further";
  return k->outcome == CHECKED     ? "ok"
         : k->outcome == IN_DOUBLE ? "not checked in wider arithmetic"
                                   : "other modes within 1e-12";
}

static void write_curve(const struct boundaries *b, struct table *t, long number, const struct map_curve *c,
                        const struct checked *checked)
{
  char left[PERIOD_MODES_TEXT], right[PERIOD_MODES_TEXT], third[PERIOD_MODES_TEXT], what[MODE_CHANGE_TEXT];
  modes_of(b, c->left, left);
  modes_of(b, c->right, right);
  what_changes(b, c, what);
  long point = 0;
  for (long i = 0; i < c->count; i++) {
    const struct map_point *p = &checked[i].point;
    if (!checked[i].kept)
      continue;
    modes_of(b, p->third, third);
    table_number(t, (double)number);
    table_number(t, (double)++point);
    table_number(t, axis_value(&b->axes[0], p->u));
    table_number(t, axis_value(&b->axes[1], p->v));
    table_text(t, left);
    table_text(t, right);
    table_text(t, what);
    table_text(t, end_text(p->end));
    table_text(t, third);
    table_text(t, status_text(&checked[i]));
  }
}

/* So that from region_1 to region_2 there is more sticking. */
static void orient(const struct boundaries *b, struct map_curve *c)
{
  if (b->regions[c->left].regime <= b->regions[c->right].regime)
    return;
  int left = c->left;
  c->left = c->right;
  c->right = left;
  for (long i = 0, j = c->count - 1; i <= j; i++, j--) {
    struct map_point p = c->points[i];
    c->points[i] = c->points[j];
    c->points[j] = p;
  }
  for (long i = 0; i < c->count; i++) {
    c->points[i].nu = -c->points[i].nu;
    c->points[i].nv = -c->points[i].nv;
  }
}

/* False: out of memory. */
static bool do_curve(struct boundaries *b, struct table *t, long number, struct map_curve *c, double step)
{
  struct checked *checked = calloc((size_t)c->count, sizeof *checked);
  if (!checked)
    return false;
  orient(b, c);
  choose(c, step, checked);
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(0, c->count))
  for (long i = 0; i < c->count; i++)
    if (checked[i].kept)
      check(b, c, &checked[i]);
  write_curve(b, t, number, c, checked);
  free(checked);
  return true;
}

static void begin_table(const struct boundaries *b, struct table *t)
{
  const char *axes[] = { axis_name(b->axes[0].kind), axis_name(b->axes[1].kind), NULL };
  static const char *const first[] = { "curve", "point", NULL };
  static const char *const last[] = { "region_1", "region_2", "what", "end", "meets", "status", NULL };
  map_begin(t, b->options, b->axes, " --boundaries");
  table_note(t, "regions: of the same modes; region_1 is on the left as the points go, x to the right and y up");
  table_note(t, "what: happens from region_1 to region_2; meets: the third region at a junction");
  table_note(t,
             "found: every curve that crosses a line of the grid at which the modes of its nodes differ, and what meets it");
  table_columns(t, first);
  table_columns(t, axes);
  table_columns(t, last);
  table_begin_rows(t);
}

static enum exit_code run(struct boundaries *b, struct table *t)
{
  struct map_curves curves = { .count = 0 };
  int columns = (int)b->axes[0].count - 1, rows = (int)b->axes[1].count - 1;
  double step = 1.0 / (columns > rows ? columns : rows);
  bool shown = !b->options->quiet && isatty(STDERR_FILENO);
  if (shown)
    fprintf(stderr, "\rfollowing the boundaries\033[K");
  bool done = map_follow(region_at, b, columns, rows, step, &curves) && !b->out_of_memory;
  begin_table(b, t);
  for (long i = 0; done && i < curves.count && !table_failed(t); i++) {
    if (shown)
      fprintf(stderr, "\rcurve %ld of %ld\033[K", i + 1, curves.count);
    done = do_curve(b, t, i + 1, &curves.curves[i], step);
  }
  if (shown)
    fprintf(stderr, "\r\033[K");
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

enum exit_code breakdown_boundaries(const struct options *options)
{
  enum { LEAST = 2, MOST = 2001 };
  struct boundaries b = { .options = options };
  struct table t;
  if (!axes_read(b.axes, options))
    return EXIT_USAGE;
  for (int i = 0; i < 2; i++)
    if (b.axes[i].count < LEAST || b.axes[i].count > MOST) {
      complain("breakdown", "--%c: %ld values; --boundaries takes 2 to 2001 along each axis", i == 0 ? 'x' : 'y',
               b.axes[i].count);
      return EXIT_USAGE;
    }
  return table_open(&t, options) ? run(&b, &t) : EXIT_FILE;
}
