/* One phase at fixed v0 as a series in its duration T.
 *
 * With s for the time in units of T and Pi = M c T, where c is the velocity of the centre of mass, Pi is a straight
 * line of slope g T^2, g = -(F1 + F2), F_rear - F_front or F1 + F2 in the three regions, and meets at a crossing the
 * curve mu |f'(s)|, mu = m_front or -m_rear, l(t) = f(t/T). The same algebra as in asymptotics/derived/lift.c, in these
 * units. */
#include <stdio.h>

#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/crossing.h"

static void list_symbols(struct symbols *s, const struct branch *b, enum scallop_phase_kind kind, slong order)
{
  static const enum symbol_meaning first[] = { NAMED_m1, NAMED_m2, NAMED_M, NAMED_F1, NAMED_F2, NAMED_L, NAMED_v0 };
  for (size_t i = 0; i < sizeof first / sizeof *first; i++)
    symbols_add(s, first[i], 0, kind);
  for (int i = 0; i < b->count; i++)
    add_derivatives(s, b->crossing[i].piece, kind, order);
  symbols_begin(s);
}

/* The integral of Pi over s between two times: (t - s) (a + b (s + t)/2) */
static struct symbolic_series between(struct symbols *s, const struct line *line, const struct symbolic_series *from,
                                      const struct symbolic_series *to, slong length)
{
  struct symbolic_series duration = symbolic_series_sub(s, to, from, length),
                         middle = symbolic_series_add(s, to, from, length);
  middle = symbolic_series_scale(s, &middle, symbolic_number(s, 1, 2), length);
  middle = symbolic_series_mul(s, &middle, &line->b, length);
  middle = symbolic_series_add(s, &middle, &line->a, length);
  return symbolic_series_mul(s, &middle, &duration, length);
}

/* travel: M times that of the centre of mass; what a point moves against it is share/M times the change of l. */
static struct symbolic_series moved(struct symbols *s, const struct symbolic_series *travel, symbolic share,
                                    const struct symbolic_series *change, slong length)
{
  symbolic M = symbolic_named(s, NAMED_M);
  struct symbolic_series way = symbolic_series_scale(s, change, share, length);
  way = symbolic_series_add(s, &way, travel, length);
  return symbolic_series_scale(s, &way, symbolic_div(s, symbolic_number(s, 1, 1), M), length);
}

static void set_displacements(struct symbols *s, struct symbolic_phase *phase, const struct bodies *bodies,
                              enum scallop_phase_kind kind, const struct symbolic_series *travel, slong order)
{
  bool extension = kind == SCALLOP_EXTENSION;
  struct symbolic_series L = symbolic_series_set(s, symbolic_named(s, NAMED_L), 0, order);
  symbolic back = symbolic_sub(s, symbolic_number(s, 0, 1), bodies->front_mass);
  symbolic centre = symbolic_mul(s, symbolic_sub(s, bodies->rear_mass, bodies->front_mass), symbolic_number(s, 1, 2));
  *(extension ? &phase->dx1 : &phase->dx2) = moved(s, travel, back, &L, order);
  *(extension ? &phase->dx2 : &phase->dx1) = moved(s, travel, bodies->rear_mass, &L, order);
  phase->dxC = moved(s, travel, centre, &L, order);
}

/* Where the rear body is at a crossing, from its start */
static struct symbolic_series rear_position(struct symbols *s, const struct bodies *bodies, const struct end *end,
                                            const struct symbolic_series *y, const struct symbolic_series *travel,
                                            slong order)
{
  symbolic back = symbolic_sub(s, symbolic_number(s, 0, 1), bodies->front_mass);
  struct symbolic_series change = way_to(s, end, y, order);
  return moved(s, travel, back, &change, order);
}

static void expand(struct symbols *s, const struct branch *b, enum scallop_phase_kind kind, bool from_rest, slong order,
                   struct symbolic_phase *phase)
{
  const slong length = order + 1,
              terms = order > 2 ? order - 1 : 2; /* b is of the order of T^2: that many terms of y do */
  struct bodies bodies = bodies_of(s, kind);
  symbolic M = symbolic_named(s, NAMED_M), none = symbolic_number(s, 0, 1);
  struct symbolic_series since = symbolic_series_set(s, none, 0, length), travel = since, way, time;
  struct symbolic_series end_of_phase = symbolic_series_set(s, symbolic_number(s, 1, 1), 0, length);
  struct line line = { symbolic_series_set(s, from_rest ? none : symbolic_mul(s, M, symbolic_named(s, NAMED_v0)), 1,
                                           length),
                       symbolic_series_set(s, bodies.force[b->first_region], 2, length) };
  phase->switches = b->count > 0;
  phase->t1 = phase->dT = phase->at_first = phase->at_last = symbolic_series_set(s, none, 0, order);
  for (int i = 0; i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    struct end end = end_of(s, at->piece->anchor == SCALLOP_FROM_END, bodies_curve(s, &bodies, at->curve), kind);
    struct symbolic_series y = solve_crossing(s, &end, &line, terms);
    time = time_of(s, &end, &y, length);
    way = between(s, &line, &since, &time, length);
    travel = symbolic_series_add(s, &travel, &way, length);
    since = time;
    phase->at_last = rear_position(s, &bodies, &end, &y, &travel, order);
    struct symbolic_series slope = symbolic_series_set(s, bodies.force[at->to], 2, length);
    way = symbolic_series_sub(s, &line.b, &slope, length);
    way = symbolic_series_mul(s, &way, &time, length);
    line.a = symbolic_series_add(s, &line.a, &way, length);
    line.b = slope;
    way = symbolic_series_sub(s, &end_of_phase, &time, length);
    if (i == 0) {
      phase->t1 = symbolic_series_shift(s, &time, 1, order);
      phase->at_first = phase->at_last;
    }
    phase->dT = symbolic_series_shift(s, &way, 1, order);
  }
  way = between(s, &line, &since, &end_of_phase, length);
  travel = symbolic_series_add(s, &travel, &way, length);
  way = symbolic_series_add(s, &line.a, &line.b, length);
  way = symbolic_series_shift(s, &way, -1, order);
  phase->v_end = symbolic_series_scale(s, &way, symbolic_div(s, symbolic_number(s, 1, 1), M), order);
  set_displacements(s, phase, &bodies, kind, &travel, order);
}

enum scallop_status symbolic_expand_phase(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum scallop_phase_kind kind, const fmpq_t v0, slong order,
                                          struct symbolic_phase *phase, const char **why)
{
  enum { PRECISION = 64 };
  struct phase_constants p;
  struct branch b;
  if (order < 1 || order > SYMBOLIC_ORDERS) {
    if (why)
      *why = "the order of a formula is outside of 1 to 16";
    return SCALLOP_EDOMAIN;
  }
  SCOPED(scallop_phase_expansion, numeric);
  SCOPED(fmpq, pi_squared);
  fmpq_one(pi_squared);
  enum scallop_status status = scallop_expand_phase(crawler, kind, v0, 1, PRECISION, pi_squared, &numeric, why);
  if (status == SCALLOP_OK) {
    phase_constants_init(&p, crawler, kind);
    branch_init(&b);
    int at_start = fmpq_sgn(v0), at_end = at_start != 0 ? at_start : fmpq_sgn(p.beta[1]) < 0 ? -1 : 1;
    branch_from_ends(&b, &p, at_start, at_end);
    if (b.count > 0 && b.crossing[0].tangent) {
      status = SCALLOP_EDOMAIN;
      if (why)
        *why = "l'' = 0 at the start of the phase, where a body is held first: its motion is not derived as a formula";
    } else {
      list_symbols(s, &b, kind, order);
      expand(s, &b, kind, at_start == 0, order, phase);
      snprintf(phase->modes, sizeof phase->modes, "%s", numeric.modes);
    }
    branch_clear(&b);
    phase_constants_clear(&p);
  }
  return status;
}
