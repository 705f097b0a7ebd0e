#include "model/gaits.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "model/law.h"

typedef long double real;
#include "model/bernstein.h"

enum { MOST = SCALLOP_LAW_MOST_DEGREE, MOST_ROOTS = 2 * MOST };

static long double binomial(int n, int k)
{
  long double value = 1;
  for (int i = 1; i <= k; i++)
    value = value * (n - k + i) / i;
  return value;
}

/* Computes Bernstein coefficients of sum of (i + 1) c[i + 1] s^i, i <= n, up to a factor; 0 if half an ulp of each c
 * can change them to 0. Returns NULL, or the reason why it is no gait. */
static const char *coefficients_of(long double *b, const double *c, int n)
{
  double top = 0;
  int exponent;
  for (int i = 0; i <= n; i++) {
    if (!isfinite(c[i + 1]))
      return "a coefficient is not finite";
    top = fmax(top, fabs(c[i + 1]));
  }
  frexp(top, &exponent);
  long double total = 0, sizes = 0;
  for (int j = 0; j <= n; j++) {
    long double size = 0;
    b[j] = 0;
    for (int i = 0; i <= j; i++) {
      long double term = binomial(j, i) / binomial(n, i) * (i + 1) * scalbnl(c[i + 1], -exponent);
      b[j] += term;
      size += fabsl(term);
    }
    if (fabsl(b[j]) <= (0.5L * DBL_EPSILON + n * LDBL_EPSILON) * size)
      b[j] = 0;
    total += b[j] / (n + 1);
    sizes += fabsl(scalbnl(c[j + 1], -exponent));
  }
  if (b[0] != 0)
    return "C1 is not 0, and so l' not at the start";
  if (b[n] != 0)
    return "C1 + 2 C2 + 3 C3 + ... is not 0, and so l' not at the end";
  if (!(total >= 1e-6L * sizes))
    return "C1 + C2 + ... is not positive, or less than a millionth of |C1| + |C2| + ...";
  for (int j = 0; j <= n; j++)
    b[j] /= total;
  return NULL;
}

/* A polynomial by its Bernstein coefficients, without its zeros at 0 and 1; noise: the largest size that cannot be
 * distinguished from 0. */
struct polynomial {
  long double b[MOST + 1], noise;
  int n;
};

static struct polynomial without_ends(const long double *b, int n)
{
  struct polynomial p = { .n = 0 };
  int first = 0, last = n;
  while (first < n && b[first] == 0)
    first++;
  while (last > first && b[last] == 0)
    last--;
  p.n = last - first;
  for (int j = first; j <= last; j++) {
    p.b[j - first] = b[j] * binomial(n, j) / binomial(p.n, j - first);
    p.noise = fmaxl(p.noise, fabsl(p.b[j - first]));
  }
  p.noise *= 0x1p-48L;
  return p;
}

/* Computes the coefficients of the parts before and after x. */
static void divide(const long double *b, int n, long double x, long double *before, long double *after)
{
  long double row[MOST + 1];
  for (int j = 0; j <= n; j++)
    row[j] = b[j];
  for (int k = 0; k <= n; k++) {
    before[k] = row[0];
    after[n - k] = row[n - k];
    for (int j = 0; j < n - k; j++)
      row[j] = (1 - x) * row[j] + x * row[j + 1];
  }
}

/* Returns the changes of sign along the coefficients, the count of roots or an even number more (Descartes' rule); -1:
 * noise may hide some. */
static int variations(const long double *b, int n, long double noise)
{
  int count = 0, last = 0;
  bool hidden = false;
  for (int j = 0; j <= n; j++) {
    int sign = b[j] > noise ? 1 : b[j] < -noise ? -1 : 0;
    if (sign == 0) {
      if (last == 0)
        return -1;
      hidden = true;
      continue;
    }
    if (hidden && sign == last)
      return -1;
    hidden = false;
    count += last != 0 && sign != last;
    last = sign;
  }
  return hidden ? -1 : count;
}

struct roots {
  const struct polynomial *p;
  long double low[MOST], high[MOST]; /* one between each pair                                               */
  int count;
  bool all; /* false: there may be more roots, or double roots, too near to each other */
};

static void isolate(struct roots *r, const long double *b, long double low, long double high, int depth)
{
  const long double part = 0.4871L; /* a place where roots are unlikely */
  int n = r->p->n, count = variations(b, n, r->p->noise);
  if (count == 0)
    return;
  if (count == 1 && r->count < MOST) {
    r->low[r->count] = low;
    r->high[r->count++] = high;
  } else if (depth == 0) {
    r->all = false;
  } else {
    long double before[MOST + 1], after[MOST + 1], middle = low + part * (high - low);
    divide(b, n, part, before, after);
    isolate(r, before, low, middle, depth - 1);
    isolate(r, after, middle, high, depth - 1);
  }
}

static struct roots roots_of(const struct polynomial *p)
{
  enum { DEPTH = 36 };
  struct roots r = { .p = p, .all = true };
  isolate(&r, p->b, 0, 1, DEPTH);
  return r;
}

/* Ends of pieces inside a phase: the offset from the start or, if late, from the end */
struct polynomial_place {
  double offset;
  bool late, turns; /* l' changes its sign                                                      */
};

static double value_at(const struct polynomial *p, double offset, bool late)
{
  long double u = offset;
  return (double)(late ? bernstein_sum(p->b, p->n, 1 - u, u) : bernstein_sum(p->b, p->n, u, 1 - u));
}

/* Returns the root between low and high, to the last digit of its offset from the nearer end. */
static struct polynomial_place root_at(const struct polynomial *p, long double low, long double high, bool turns)
{
  double middle = value_at(p, 0.5, false);
  if (low < 0.5L && high > 0.5L && fabs(middle) <= p->noise)
    return (struct polynomial_place){ 0.5, false, turns };
  bool at_low = bernstein_sum(p->b, p->n, low, 1 - low) > 0;
  bool late = low >= 0.5L || (high > 0.5L && (middle > 0) == at_low);
  double lo = (double)(late ? 1 - high : low), hi = (double)(late ? 1 - low : high);
  hi = fmin(hi, 0.5);
  bool sign_lo = late ? !at_low : at_low;
  for (double u; (u = lo + (hi - lo) / 2) > lo && u < hi;)
    *((value_at(p, u, late) > 0) == sign_lo ? &lo : &hi) = u;
  return (struct polynomial_place){ hi, late, turns };
}

struct plan {
  long double b[2][MOST + 1]; /* of l', from the start and from the end */
  int n;
  struct polynomial_place places[MOST_ROOTS + 3]; /* in the order of time, with the start first and the end last */
  int count;
  bool turns; /* some place has turns */
};

static bool is_later(const struct polynomial_place *p, const struct polynomial_place *q)
{
  if (p->late != q->late)
    return p->late;
  return p->late ? p->offset < q->offset : p->offset > q->offset;
}

static double distance(const struct polynomial_place *p, const struct polynomial_place *q)
{
  double s = p->late ? 1 - p->offset : p->offset, t = q->late ? 1 - q->offset : q->offset;
  return p->late == q->late ? fabs(p->offset - q->offset) : fabs(s - t);
}

/* Adds a place unless it is already in the plan. A change of sign of l' must be exact; a zero of l''' may be off by
 * rounding. */
static void add_place(struct plan *plan, struct polynomial_place place)
{
  for (int i = 0; i < plan->count; i++)
    if (distance(&plan->places[i], &place) <= (place.turns ? 0 : 0x1p-40)) {
      plan->places[i].turns |= place.turns;
      return;
    }
  int at = plan->count++;
  for (; at > 0 && is_later(&plan->places[at - 1], &place); at--)
    plan->places[at] = plan->places[at - 1];
  plan->places[at] = place;
}

/* Adds the roots. Returns false if rounding hides a change of sign of l'. */
static bool add_roots(struct plan *plan, const long double *b, int n, bool turns)
{
  struct polynomial p = without_ends(b, n);
  struct roots r = roots_of(&p);
  for (int i = 0; i < r.count; i++)
    add_place(plan, root_at(&p, r.low[i], r.high[i], turns));
  plan->turns |= turns && r.count > 0;
  return r.all;
}

/* Plans the places: the ends, the middle, and the changes of sign of l' and of l'''. In between, l'' is monotone. If
 * roots of l''' are too near to each other to be separated, l'' is monotone except for rounding. */
static bool make_plan(struct plan *plan)
{
  long double bend[MOST + 1];
  int n = plan->n, of_bend = n - 2;
  add_place(plan, (struct polynomial_place){ 0, false, false });
  add_place(plan, (struct polynomial_place){ 0, true, false });
  add_place(plan, (struct polynomial_place){ 0.5, false, false });
  if (!add_roots(plan, plan->b[0], n, true))
    return false;
  for (int j = 0; j <= of_bend; j++)
    bend[j] = plan->b[0][j + 2] - 2 * plan->b[0][j + 1] + plan->b[0][j];
  add_roots(plan, bend, of_bend, false);
  return true;
}

/* Returns the index of the largest coefficient except the first and the last: rounding affects it least when it is
 * computed from the others. */
static int largest(const double *b, int degree)
{
  int at = 1;
  for (int j = 2; j < degree; j++)
    if (fabs(b[j]) > fabs(b[at]))
      at = j;
  return at;
}

static struct scallop_law law_of(int degree, const double *b, int implied, double near, double far, double way,
                                 double base)
{
  struct scallop_bernstein_law law = { .near = near, .far = far, .way = way, .implied = implied };
  for (int j = 0; j <= degree; j++)
    law.b[j] = j == implied ? 0 : b[j];
  return (struct scallop_law){ SCALLOP_LAW_BERNSTEIN, degree, .bernstein = law, .base = base };
}

/* Sets two laws for all pieces, one from the start and one from the end. */
static void set_common_laws(struct scallop_polynomial *g, const struct plan *plan)
{
  int n = plan->n;
  double b[2][MOST + 1] = { { 0 } };
  for (int j = 0; j <= n; j++)
    b[0][j] = b[1][n - j] = (double)plan->b[0][j];
  int implied = largest(b[0], n);
  g->laws[0] = law_of(n, b[0], implied, 0, 1, 1, 0);
  g->laws[1] = law_of(n, b[1], n - implied, 0, 1, 1, 0);
}

/* Returns the integral of l' in an extension from the place's anchor to the place, in time or back. */
static long double way_to(const struct plan *plan, const struct polynomial_place *place)
{
  long double sums[MOST + 2] = { 0 }, u = place->offset;
  for (int j = 0; j <= plan->n; j++)
    sums[j + 1] = sums[j] + plan->b[place->late][j];
  return bernstein_sum(sums, plan->n + 1, u, 1 - u) / (plan->n + 1);
}

static double speed_at(const struct plan *plan, const struct polynomial_place *place)
{
  long double u = place->offset;
  return place->turns ? 0 : (double)bernstein_sum(plan->b[place->late], plan->n, u, 1 - u);
}

/* Sets the law of one piece, with l' = 0 exactly at changes of its sign, and the way to the last digit, however short
 * it is. */
static void set_own_law(struct scallop_polynomial *g, int at, const struct plan *plan, int direction, bool late,
                        const struct polynomial_place *begin, const struct polynomial_place *end)
{
  const struct polynomial_place *near = late ? end : begin, *far = late ? begin : end;
  long double before[MOST + 1], after[MOST + 1], rest[MOST + 1], u = near->offset, v = far->offset, sum = 0;
  double b[MOST + 1] = { 0 };
  divide(plan->b[late], plan->n, v, before, after);
  divide(before, plan->n, u / v, rest, after);
  for (int j = 0; j <= plan->n; j++)
    b[j] = (double)(direction * after[j]);
  b[0] = direction * speed_at(plan, near);
  b[plan->n] = direction * speed_at(plan, far);
  for (int j = 0; j <= plan->n; j++)
    sum += b[j];
  g->laws[at] = law_of(plan->n, b, largest(b, plan->n), near->offset, far->offset,
                       (double)(sum * (v - u) / (plan->n + 1)),
                       (double)(direction * (late ? -1 : 1) * way_to(plan, near)));
}

/* Returns the sign of l' between two places, in an extension. */
static int direction_between(const struct plan *plan, const struct polynomial_place *begin,
                             const struct polynomial_place *end, bool late)
{
  long double u = ((long double)begin->offset + end->offset) / 2;
  return bernstein_sum(plan->b[late], plan->n, u, 1 - u) > 0 ? 1 : -1;
}

/* Sets the ways, each rounded to its own last digit; the longest is the rest of the amplitude, to all digits. Returns
 * false if one is not positive, because its piece is too short. */
static bool share_amplitude(struct scallop_polynomial *g, const struct plan *plan)
{
  const struct scallop_piece *pieces = g->pieces[SCALLOP_EXTENSION];
  int longest = 0, others = 0;
  bool positive = true;
  for (int i = 0; i + 1 < plan->count; i++) {
    positive = positive && g->laws[i].bernstein.way > 0;
    if (g->laws[i].bernstein.way > g->laws[longest].bernstein.way)
      longest = i;
  }
  for (int i = 0; i + 1 < plan->count; i++)
    if (i != longest)
      g->ways[others++] = -pieces[longest].direction * pieces[i].direction * g->laws[i].bernstein.way;
  struct scallop_bernstein_law *rest = &g->laws[longest].bernstein;
  rest->way = pieces[longest].direction;
  rest->more = g->ways;
  rest->more_count = others;
  return positive;
}

static bool add_pieces(struct scallop_polynomial *g, const struct plan *plan)
{
  for (int i = 0; i + 1 < plan->count; i++) {
    const struct polynomial_place *begin = &plan->places[i], *end = &plan->places[i + 1];
    bool late = end->late;
    int direction = direction_between(plan, begin, end, late);
    if (plan->turns)
      set_own_law(g, i, plan, direction, late, begin, end);
    for (int kind = 0; kind < 2; kind++)
      g->pieces[kind][i] = (struct scallop_piece){ .begin = begin->offset,
                                                   .end = end->offset,
                                                   .anchor = late ? SCALLOP_FROM_END : SCALLOP_FROM_START,
                                                   .direction = kind == SCALLOP_EXTENSION ? direction : -direction,
                                                   .curve = &law_curve_bernstein,
                                                   .law = &g->laws[plan->turns ? i : late] };
  }
  return !plan->turns || share_amplitude(g, plan);
}

/* Returns max |l'|, attained at an end of a piece or at l'' = 0. */
static double peak_of(const struct scallop_shape *shape)
{
  double peak = 0;
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    double top = p->curve->when(p, 0);
    peak = fmax(peak, fabs(p->curve->velocity(p, p->end)));
    if (!isnan(top))
      peak = fmax(peak, fabs(p->curve->velocity(p, top)));
  }
  return peak;
}

/* Returns whether |l'| rises at the start with the fourth power of the time or a lower one: a bell is not so level that
 * rounding counts many times. */
static bool is_steep(const long double *b) { return b[1] != 0 || b[2] != 0 || b[3] != 0 || b[4] != 0; }

/* By the signs of the second differences of the coefficients: l''' changes its sign no more often than they do. */
static void set_bends(struct scallop_shape *shape, const struct plan *plan)
{
  int part = 0;
  shape->bell = shape->concave = !plan->turns;
  for (int j = 0; j + 2 <= plan->n; j++) {
    const long double bend = plan->b[0][j + 2] - 2 * plan->b[0][j + 1] + plan->b[0][j];
    shape->bell = shape->bell && law_is_bell(&part, bend);
    shape->concave = shape->concave && bend <= 0;
  }
  shape->bell = shape->bell && !shape->concave && is_steep(plan->b[0]) && is_steep(plan->b[1]);
}

static void conclude(struct scallop_polynomial *g, const struct plan *plan, int kind)
{
  struct scallop_shape *shape = &g->gait.phase[kind];
  *shape = (struct scallop_shape){ .pieces = g->pieces[kind], .count = plan->count - 1 };
  set_bends(shape, plan);
  const struct scallop_piece *first = &shape->pieces[0], *last = &shape->pieces[shape->count - 1];
  shape->l0 = first->curve->acceleration(first, 0) + 0.0; /* no -0 */
  shape->lT = last->curve->acceleration(last, 0) + 0.0;
  shape->peak = peak_of(shape);
  for (int i = 0; i < shape->count; i++)
    shape->net += shape->pieces[i].direction * distance(&plan->places[i], &plan->places[i + 1]);
}

static const char *const too_near = "l' is so near to 0 between the ends that rounding may change its sign";

static const char *plan_of(struct plan *plan, const double *c, int degree)
{
  while (degree > 0 && c[degree] == 0)
    degree--;
  if (degree < 3 || degree > SCALLOP_POLYNOMIAL_DEGREE)
    return "the degree is not from 3 to 16";
  plan->n = degree - 1;
  const char *wrong = coefficients_of(plan->b[0], c, plan->n);
  for (int j = 0; !wrong && j <= plan->n; j++)
    plan->b[1][plan->n - j] = plan->b[0][j];
  return wrong ? wrong : make_plan(plan) ? NULL : too_near;
}

enum scallop_status scallop_make_polynomial(struct scallop_polynomial *g, const char *name, const double *c, int degree,
                                            const char **why)
{
  struct plan plan = { .n = 0 };
  const char *wrong = plan_of(&plan, c, degree);
  if (!wrong && !plan.turns)
    set_common_laws(g, &plan);
  if (!wrong)
    wrong = add_pieces(g, &plan) ? NULL : too_near;
  if (wrong && why)
    *why = wrong;
  if (wrong)
    return SCALLOP_EDOMAIN;
  g->gait.name = name;
  for (int kind = 0; kind < 2; kind++)
    conclude(g, &plan, kind);
  return SCALLOP_OK;
}
