/* The steady state where l' is linear at every crossing, in closed form.
 *
 * With s for the time in units of a phase that takes the fraction f of the period, and Pi = M c T, T the period, the
 * line is f Pi = p + g s, g = f^2 T^2 force, and crosses the curve mu L (a + b y), y the time from the anchor of a
 * piece. All of this is linear in Pi at the start, so the map of the period is Pi -> A Pi + B, and Pi = B/(1 - A) in
 * the steady state. */
#include <stdio.h>
#include <string.h>

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/crossing.h"

struct affine { /* slope times the unknown, plus constant                                                */
  symbolic slope, constant;
};

static struct affine times(struct symbols *s, struct affine a, symbolic factor)
{
  return (struct affine){ symbolic_mul(s, a.slope, factor), symbolic_mul(s, a.constant, factor) };
}

static struct affine plus(struct symbols *s, struct affine a, symbolic constant)
{
  return (struct affine){ a.slope, symbolic_add(s, a.constant, constant) };
}

/* |l'| = (a + b y) L/duration */
struct linear_law {
  bool last; /* y is the time to the end of the phase                                               */
  symbolic a, b;
};

/* False: the piece is not linear. */
static bool is_linear(fmpq_poly_t speed, const struct scallop_piece *piece)
{
  enum { LENGTH = 4 };
  SCOPED(fmpq, at_anchor);
  return scallop_rational_speed_series(speed, piece, at_anchor, LENGTH, NULL) && fmpq_poly_length(speed) <= 2;
}

static bool crossings_are_linear(const struct branch *b)
{
  SCOPED(fmpq_poly, speed);
  bool linear = true;
  for (int i = 0; linear && i < b->count; i++)
    linear = is_linear(speed, b->crossing[i].piece);
  return linear;
}

static struct linear_law law_of(struct symbols *s, const struct scallop_piece *piece)
{
  struct linear_law law = { .last = piece->anchor == SCALLOP_FROM_END };
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, coefficient);
  is_linear(speed, piece);
  fmpq_poly_get_coeff_fmpq(coefficient, speed, 0);
  law.a = symbolic_fraction(s, coefficient);
  fmpq_poly_get_coeff_fmpq(coefficient, speed, 1);
  if (law.last)
    fmpq_neg(coefficient, coefficient);
  law.b = symbolic_fraction(s, coefficient);
  return law;
}

struct walk {             /* through the period                                                                    */
  struct affine momentum; /* Pi                                                                  */
  symbolic travel;        /* M times that of the centre of mass, if the slope of Pi is 0                */
};

/* The integral of p + g s from one time to another */
static symbolic way(struct symbols *s, symbolic p, symbolic g, symbolic from, symbolic to)
{
  symbolic middle = symbolic_mul(s, symbolic_mul(s, g, symbolic_add(s, from, to)), symbolic_number(s, 1, 2));
  return symbolic_mul(s, symbolic_sub(s, to, from), symbolic_add(s, p, middle));
}

/* The time of a crossing since the start of the phase: mu L (a + b y) = p + g s */
static struct affine crossing_time(struct symbols *s, const struct linear_law *law, symbolic mu, struct affine p,
                                   symbolic g)
{
  symbolic scale = symbolic_mul(s, mu, symbolic_named(s, NAMED_L)), minus = symbolic_number(s, -1, 1);
  symbolic a = symbolic_mul(s, scale, law->a), b = symbolic_mul(s, scale, law->b);
  struct affine over = plus(s, p, symbolic_mul(s, a, minus));
  if (!law->last)
    return times(s, over, symbolic_div(s, symbolic_number(s, 1, 1), symbolic_sub(s, b, g)));
  over = plus(s, over, g); /* s = 1 - y */
  return plus(s, times(s, over, symbolic_div(s, minus, symbolic_add(s, b, g))), symbolic_number(s, 1, 1));
}

static void walk_phase(struct symbols *s, struct walk *walk, const struct branch *b, enum scallop_phase_kind kind)
{
  struct bodies bodies = bodies_of(s, kind);
  symbolic f = symbolic_named(s, kind == SCALLOP_EXTENSION ? NAMED_alpha : NAMED_beta), T = symbolic_named(s, NAMED_T);
  symbolic duration = symbolic_mul(s, f, T), since = symbolic_number(s, 0, 1), end = symbolic_number(s, 1, 1);
  symbolic square = symbolic_mul(s, duration, duration), g = symbolic_mul(s, bodies.force[b->first_region], square);
  bool fixed = symbolic_is_zero(walk->momentum.slope, s);
  struct affine p = times(s, walk->momentum, f);
  for (int i = 0; i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    struct linear_law law = law_of(s, at->piece);
    struct affine time = crossing_time(s, &law, bodies_curve(s, &bodies, at->curve), p, g);
    symbolic next = symbolic_mul(s, bodies.force[at->to], square), drop = symbolic_sub(s, g, next);
    if (fixed)
      walk->travel = symbolic_add(s, walk->travel, way(s, p.constant, g, since, time.constant));
    time = times(s, time, drop);
    p = (struct affine){ symbolic_add(s, p.slope, time.slope), symbolic_add(s, p.constant, time.constant) };
    since = symbolic_div(s, time.constant, drop);
    g = next;
  }
  if (fixed)
    walk->travel = symbolic_add(s, walk->travel, way(s, p.constant, g, since, end));
  walk->momentum = times(s, plus(s, p, g), symbolic_div(s, end, f));
}

static void solve(struct symbols *s, const struct limit *limit, struct symbolic_steady *steady)
{
  symbolic one = symbolic_number(s, 1, 1), none = symbolic_number(s, 0, 1), M = symbolic_named(s, NAMED_M);
  symbolic per_time = symbolic_div(s, one, symbolic_mul(s, M, symbolic_named(s, NAMED_T)));
  struct walk walk = { { one, none }, none };
  for (int k = 0; k < 2; k++)
    walk_phase(s, &walk, &limit->branch[k], (enum scallop_phase_kind)k);
  symbolic start = symbolic_div(s, walk.momentum.constant, symbolic_sub(s, one, walk.momentum.slope));
  walk = (struct walk){ { none, start }, none };
  steady->v_start = symbolic_mul(s, start, per_time);
  walk_phase(s, &walk, &limit->branch[0], SCALLOP_EXTENSION);
  steady->v_mid = symbolic_mul(s, walk.momentum.constant, per_time);
  walk_phase(s, &walk, &limit->branch[1], SCALLOP_CONTRACTION);
  steady->displacement = symbolic_div(s, walk.travel, M);
}

static enum scallop_status refuse(const char **why, const char *reason)
{
  if (why)
    *why = reason;
  return SCALLOP_EDOMAIN;
}

enum scallop_status symbolic_solve_steady(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          struct symbolic_steady *steady, const char **why)
{
  static const enum symbol_meaning names[] = { NAMED_m1, NAMED_m2,    NAMED_M,    NAMED_F1, NAMED_F2,
                                               NAMED_L,  NAMED_alpha, NAMED_beta, NAMED_T };
  enum { PRECISION = 128 };
  struct limit limit;
  SCOPED(scallop_steady_expansion, numeric);
  enum scallop_status status = scallop_expand_steady(crawler, 1, PRECISION, &numeric, why);
  if (status == SCALLOP_OK) {
    limit_init(&limit, crawler);
    limit_find(&limit, crawler, PRECISION, why);
    if (series_coefficient_is_zero(&limit.w, 0))
      status = refuse(
          why, "alpha = 1/2 or F1 = F2: the start velocity is 0 for T -> 0, and bodies turn otherwise than for any "
               "alpha, F1 and F2 near these");
    else if (!crossings_are_linear(&limit.branch[0]) || !crossings_are_linear(&limit.branch[1]))
      status = refuse(
          why, "l' is not linear where bodies turn, so that the steady state has no closed form: see --source limit");
    else {
      for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        symbols_add(s, names[i], 0, SCALLOP_EXTENSION);
      symbols_begin(s);
      solve(s, &limit, steady);
      memcpy(steady->modes, numeric.modes, sizeof steady->modes);
    }
    limit_clear(&limit);
  }
  return status;
}
