/* Bodies, and where one of them turns near an end of a phase, as symbols and series. */
#include "asymptotics/symbolic/crossing.h"

#include "asymptotics/derived/scoped.h"

struct bodies bodies_of(struct symbols *s, enum scallop_phase_kind kind)
{
  bool extension = kind == SCALLOP_EXTENSION;
  symbolic F1 = symbolic_named(s, NAMED_F1), F2 = symbolic_named(s, NAMED_F2), both = symbolic_add(s, F1, F2);
  symbolic m1 = symbolic_named(s, NAMED_m1), m2 = symbolic_named(s, NAMED_m2), none = symbolic_number(s, 0, 1);
  return (struct bodies){ extension ? m1 : m2,
                          extension ? m2 : m1,
                          { symbolic_sub(s, none, both), extension ? symbolic_sub(s, F1, F2) : symbolic_sub(s, F2, F1),
                            both } };
}

symbolic bodies_curve(struct symbols *s, const struct bodies *bodies, int curve)
{
  return curve == 0 ? bodies->front_mass : symbolic_sub(s, symbolic_number(s, 0, 1), bodies->rear_mass);
}

void add_derivatives(struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind, slong order)
{
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, at_anchor, one);
  fmpq_one(one);
  scallop_rational_speed_series(speed, piece, at_anchor, order > 2 ? order : 2, one);
  for (slong k = 1; k == 1 || k < order - 1; k++)
    if (k < fmpq_poly_length(speed) && !fmpz_is_zero(fmpq_poly_numref(speed) + k))
      symbols_add(s, piece->anchor == SCALLOP_FROM_START ? NAMED_AT_START : NAMED_AT_END, (int)k + 1, kind);
}

struct end end_of(struct symbols *s, bool last, symbolic mu, enum scallop_phase_kind kind)
{
  struct end end = { .last = last, .mu = mu };
  symbolic none = symbolic_number(s, 0, 1);
  for (int i = 0; i < SYMBOLIC_TERMS; i++)
    end.law[i] = none;
  for (int place = 0; place < s->count; place++) {
    const struct symbol *symbol = &s->list[place];
    if (symbol->meaning != (end.last ? NAMED_AT_END : NAMED_AT_START) || symbol->kind != kind)
      continue;
    int k = symbol->derivative - 1, sign = (kind == SCALLOP_EXTENSION ? 1 : -1) * (end.last && k % 2 == 1 ? -1 : 1);
    end.law[k] = symbolic_mul(s, symbolic_place(s, place), symbolic_number(s, sign, 1));
    for (int i = 2; i <= k; i++)
      end.law[k] = symbolic_mul(s, end.law[k], symbolic_number(s, 1, (ulong)i));
    end.degree = k;
  }
  return end;
}

/* mu law(y) and its derivative */
static void curve_along(struct symbols *s, struct symbolic_series *value, struct symbolic_series *rate,
                        const struct end *end, const struct symbolic_series *y, slong length)
{
  symbolic none = symbolic_number(s, 0, 1);
  *value = symbolic_series_set(s, none, 0, length);
  *rate = *value;
  for (int k = end->degree; k >= 0; k--) { /* Horner's scheme, and its derivative */
    struct symbolic_series term = symbolic_series_set(s, symbolic_mul(s, end->mu, end->law[k]), 0, length);
    *rate = symbolic_series_mul(s, rate, y, length);
    *rate = symbolic_series_add(s, rate, value, length);
    *value = symbolic_series_mul(s, value, y, length);
    *value = symbolic_series_add(s, value, &term, length);
  }
}

struct symbolic_series way_to(struct symbols *s, const struct end *end, const struct symbolic_series *y, slong length)
{
  symbolic all = end->last ? symbolic_named(s, NAMED_L) : symbolic_number(s, 0, 1);
  struct symbolic_series way = symbolic_series_set(s, symbolic_number(s, 0, 1), 0, length),
                         rest = symbolic_series_set(s, all, 0, length);
  for (int k = end->degree; k >= 0; k--) { /* Horner's scheme */
    struct symbolic_series term = symbolic_series_set(
        s, symbolic_mul(s, end->law[k], symbolic_number(s, 1, (ulong)k + 1)), 0, length);
    way = symbolic_series_mul(s, &way, y, length);
    way = symbolic_series_add(s, &way, &term, length);
  }
  way = symbolic_series_mul(s, &way, y, length);
  return (end->last ? symbolic_series_sub : symbolic_series_add)(s, &rest, &way, length);
}

/* The time since the start of the phase */
struct symbolic_series time_of(struct symbols *s, const struct end *end, const struct symbolic_series *y, slong length)
{
  struct symbolic_series one = symbolic_series_set(s, symbolic_number(s, end->last, 1), 0, length);
  return (end->last ? symbolic_series_sub : symbolic_series_add)(s, &one, y, length);
}

/* The root y of mu law(y) = a + b s(y) by Newton's method: each step doubles the number of right terms. */
struct symbolic_series solve_crossing(struct symbols *s, const struct end *end, const struct line *line, slong terms)
{
  struct symbolic_series y = symbolic_series_set(s, symbolic_number(s, 0, 1), 0, 1), gap, slope, here;
  bool last = false;
  for (slong length = 2; !last; length *= 2) {
    last = length >= terms;
    slong part = last ? terms : length;
    curve_along(s, &gap, &slope, end, &y, part);
    here = time_of(s, end, &y, part);
    here = symbolic_series_mul(s, &here, &line->b, part);
    here = symbolic_series_add(s, &here, &line->a, part);
    gap = symbolic_series_sub(s, &gap, &here, part);
    slope = (end->last ? symbolic_series_add : symbolic_series_sub)(s, &slope, &line->b, part);
    gap = symbolic_series_div(s, &gap, &slope, part);
    y = symbolic_series_sub(s, &y, &gap, part);
  }
  return y;
}
