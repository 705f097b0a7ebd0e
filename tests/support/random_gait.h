/* Gaits made to measure (model/gaits.h) with random parameters. Header-only; knows public headers only. */
#ifndef SCALLOP_TESTS_SUPPORT_RANDOM_GAIT_H
#define SCALLOP_TESTS_SUPPORT_RANDOM_GAIT_H

#include "model/gaits.h"
#include "tests/support/random_crawler.h"

enum random_gait_kind { TRAPEZOIDAL, SKEWED, POLYNOMIAL, SPLINE, TURNING_POLYNOMIAL, TURNING_SPLINE, RANDOM_GAITS };
enum { STRAIGHT_OR_POLYNOMIAL = 3, WITHOUT_TURN = 4 }; /* the first of them */

enum { MOST_KNOTS = 40, MOST_SPLINE_PIECES = 2 * MOST_KNOTS };

struct random_gait {
  struct scallop_straight straight;
  struct scallop_polynomial polynomial;
  struct scallop_spline spline;
  struct scallop_piece pieces[MOST_SPLINE_PIECES];
  struct scallop_law laws[MOST_SPLINE_PIECES];
};

/* Often where 1 - x is no double */
static inline double random_part(struct random *r, double most)
{
  return random_below(r, 4) ? random_between(r, 0.02, most) : random_decades(r, 1e-3, most);
}

static inline const struct scallop_gait *random_straight(struct random *r, bool skewed, struct scallop_straight *g)
{
  double x[4];
  for (int kind = 0; kind < 2; kind++) {
    x[kind] = random_part(r, 0.97);
    x[2 + kind] = random_below(r, 5) ? random_part(r, 1 - x[kind]) : 1 - x[kind];
  }
  enum scallop_status made = skewed ? scallop_make_skewed(g, "skewed", x)
                                    : scallop_make_trapezoidal(g, "trapezoidal", x, x + 2);
  if (made != SCALLOP_OK) /* a sum beyond 1 by rounding */
    return random_straight(r, skewed, g);
  return &g->gait;
}

/* l' is a multiple of the sum of slope[k] s^k, k <= degree. False: it is none of a gait. */
static inline bool polynomial_of_slope(struct scallop_polynomial *g, const double *slope, int degree)
{
  double c[SCALLOP_POLYNOMIAL_DEGREE + 1] = { 0 }, sum = 0;
  for (int k = 0; k <= degree; k++)
    sum += c[k + 1] = slope[k] / (k + 1);
  for (int k = 1; k <= degree + 1; k++)
    c[k] = sum < 0 ? -c[k] : c[k];
  return scallop_make_polynomial(g, "polynomial", c, degree + 1, NULL) == SCALLOP_OK;
}

/* The polynomial times a + b s */
static inline void times(double *polynomial, int *degree, double a, double b)
{
  for (int k = ++*degree; k >= 0; k--)
    polynomial[k] = polynomial[k] * a + (k > 0 ? polynomial[k - 1] * b : 0);
}

/* l' = s^p (1 - s)^q times a random polynomial, which is positive or, turning, has one or two roots. */
static inline const struct scallop_gait *random_polynomial(struct random *r, bool turning, struct scallop_polynomial *g)
{
  enum { DEGREE = 8 };
  double slope[DEGREE + 1] = { 0 }, roots[2] = { random_between(r, 0.05, 0.45), random_between(r, 0.55, 0.95) };
  int rising = 1 + random_below(r, 2), falling = 1 + random_below(r, 2), degree = rising;
  slope[rising] = 1;
  int factors = falling + (turning ? 1 + random_below(r, 2) : random_below(r, 3));
  for (int i = 0; i < factors; i++) {
    double a = i < falling ? 1 : turning ? -roots[(i - falling) % 2] : random_between(r, 0.2, 1);
    times(slope, &degree, a, i < falling ? -1 : turning ? 1 : random_between(r, -0.9, 3) * a);
  }
  return polynomial_of_slope(g, slope, degree) ? &g->gait : random_polynomial(r, turning, g);
}

/* l' = s^p (1 - s) times factors s - root. The roots are anywhere, and next to the start, the middle, the end and each
 * other: so there are pieces that are much shorter than an ulp of l, and l goes back further than its amplitude. */
static inline const struct scallop_gait *far_turning(struct random *r, struct scallop_polynomial *g)
{
  enum { MOST = 8 };
  double slope[MOST + 1] = { 0 }, root = 0;
  int degree = 1 + random_below(r, 2), roots = 1 + random_below(r, 4);
  slope[degree] = 1;
  for (int i = 0; i <= roots; i++) { /* the last one is 1 */
    double closeness = random_decades(r, 1e-9, 0.1), side = random_below(r, 2) ? 1 : -1;
    const double places[] = { random_between(r, 0.02, 0.98), 0.5 + side * closeness, closeness, 1 - closeness,
                              root + 0.02 };
    root = i < roots ? places[random_below(r, 5)] : 1;
    times(slope, &degree, -root, 1);
  }
  return polynomial_of_slope(g, slope, degree) ? &g->gait : far_turning(r, g);
}

/* ... or hardly at all */
static const char *const far_turning_texts[] = {
  "polynomial:0,0,-60,125,-64",
  "polynomial:0,330,-1420,1860,-768",
  "polynomial:0,0,220,-1065,1488,-640",
  "polynomial:0,135,-1690,3120,-1536",
  "polynomial:0,0,-12,25,-12.8",
  "polynomial:0,0,-4,9,-4.8",
  "polynomial:0,0,-19.999999976000002,44.999999952000003,-23.999999976000002",
  "polynomial:0,-6.0000000012000002e-10,4.0000000012000001,-3.0000000006"
};
enum { FAR_TURNING = sizeof far_turning_texts / sizeof *far_turning_texts };

/* Steffen's slope at the middle one of three knots */
static inline double steffen(const struct scallop_knot *k)
{
  double h = k[0].time - k[-1].time, g = k[1].time - k[0].time;
  double s = (k[0].length - k[-1].length) / h, t = (k[1].length - k[0].length) / g;
  if (s * t <= 0)
    return 0;
  return copysign(fmin(fmin(2 * fabs(s), 2 * fabs(t)), fabs(s * g + t * h) / (g + h)), s);
}

/* turning: l goes back and forth, and rests now and then */
static inline int random_knots(struct random *r, bool turning, int kind, struct scallop_knot *knots)
{
  int count = 2 + random_below(r, MOST_KNOTS - 1);
  double time = 0, way = 0;
  for (int i = 0; i < count; i++) {
    knots[i] = (struct scallop_knot){ time, way, 0 };
    time += random_between(r, 0.2, 1);
    way += random_between(r, 0.05, 1);
  }
  for (int i = 0; i < count; i++) {
    double l = knots[i].length / knots[count - 1].length;
    if (turning && i > 0 && i < count - 1)
      l = random_below(r, 3) ? random_between(r, 0.01, 0.99)
          : kind == 0        ? knots[i - 1].length
                             : 1 - knots[i - 1].length;
    knots[i].time = scallop_knot_round(knots[i].time / knots[count - 1].time);
    knots[i].length = scallop_knot_round(kind == 0 ? l : 1 - l);
  }
  for (int i = 1; i + 1 < count; i++)
    knots[i].slope = steffen(&knots[i]);
  return count;
}

/* The spline through these knots of the extension and of the contraction */
static inline enum scallop_status spline_through(struct random_gait *g, const struct scallop_knot *out, int count_out,
                                                 const struct scallop_knot *back, int count_back)
{
  const struct scallop_knot *const knots[2] = { out, back };
  const int count[2] = { count_out, count_back };
  g->spline = (struct scallop_spline){ .pieces = g->pieces, .laws = g->laws };
  return scallop_make_spline(&g->spline, "spline", knots, count);
}

static inline const struct scallop_gait *random_spline(struct random *r, bool turning, struct random_gait *g)
{
  struct scallop_knot out[MOST_KNOTS], back[MOST_KNOTS];
  const int count_out = random_knots(r, turning, 0, out), count_back = random_knots(r, turning, 1, back);
  assert_int_equal(spline_through(g, out, count_out, back, count_back), SCALLOP_OK);
  return &g->spline.gait;
}

static inline const struct scallop_gait *random_gait(struct random *r, enum random_gait_kind kind,
                                                     struct random_gait *g)
{
  if (kind == TRAPEZOIDAL || kind == SKEWED)
    return random_straight(r, kind == SKEWED, &g->straight);
  if (kind == POLYNOMIAL || kind == TURNING_POLYNOMIAL)
    return random_polynomial(r, kind == TURNING_POLYNOMIAL, &g->polynomial);
  return random_spline(r, kind == TURNING_SPLINE, g);
}

#endif
