/* The laws of a branch in balls, and its crossings one after another, each found from the one before. */
#include "asymptotics/derived/branch.h"

#include <math.h>

#include "asymptotics/derived/scoped.h"

void ball_times(arb_t product, const arb_t x, const fmpq_t q, slong precision)
{
  arb_mul_fmpz(product, x, fmpq_numref(q), precision);
  arb_div_fmpz(product, product, fmpq_denref(q), precision);
}

void time_of_offset(arb_t time, const struct scallop_piece *piece, const arb_t u, slong precision)
{
  arb_set(time, u);
  if (piece->anchor == SCALLOP_FROM_END) {
    arb_sub_si(time, time, 1, precision);
    arb_neg(time, time);
  }
}

void gap_at(arb_t gap, arb_t slope, const struct scallop_piece *piece, const fmpq_t q, const arb_t a, const arb_t b,
            const arb_t u, slong precision)
{
  SCOPED(arb, s);
  time_of_offset(s, piece, u, precision);
  scallop_ball_speed(gap, piece, u, precision);
  ball_times(gap, gap, q, precision);
  arb_submul(gap, b, s, precision);
  arb_sub(gap, gap, a, precision);
  scallop_ball_rate(slope, piece, u, precision);
  ball_times(slope, slope, q, precision);
  arb_sub(slope, slope, b, precision);
  if (piece->anchor == SCALLOP_FROM_END)
    arb_neg(slope, slope);
}

void phase_constants_init(struct phase_constants *p, const struct scallop_rational_crawler *c,
                          enum scallop_phase_kind kind)
{
  bool extension = kind == SCALLOP_EXTENSION;
  SCOPED(fmpq, total);
  fmpq_init(p->fraction);
  p->kind = kind;
  p->shape = &c->gait->phase[kind];
  scallop_rational_fraction(p->fraction, c, kind);
  for (int i = 0; i < 2; i++)
    fmpq_init(p->curve[i]);
  for (int i = 0; i < 3; i++)
    fmpq_init(p->beta[i]);
  fmpq_add(total, c->m1, c->m2);
  fmpq_div(p->curve[0], extension ? c->m2 : c->m1, total);
  fmpq_sub_si(p->curve[1], p->curve[0], 1);
  fmpq_add(total, c->F1, c->F2);
  fmpq_sub(p->beta[1], extension ? c->F1 : c->F2, extension ? c->F2 : c->F1);
  fmpq_div(p->beta[1], p->beta[1], total);
  fmpq_set_si(p->beta[0], -1, 1);
  fmpq_set_si(p->beta[2], 1, 1);
}

void phase_constants_clear(struct phase_constants *p)
{
  fmpq_clear(p->fraction);
  for (int i = 0; i < 2; i++)
    fmpq_clear(p->curve[i]);
  for (int i = 0; i < 3; i++)
    fmpq_clear(p->beta[i]);
}

void branch_init(struct branch *b)
{
  b->first_region = 1;
  b->count = 0;
  for (int i = 0; i < MOST_CROSSINGS; i++) {
    b->crossing[i].tangent = false;
    series_init(&b->crossing[i].offset);
  }
}

void branch_clear(struct branch *b)
{
  for (int i = 0; i < MOST_CROSSINGS; i++)
    series_clear(&b->crossing[i].offset);
}

int branch_region(const struct branch *b, int segment)
{
  return segment == 0 ? b->first_region : b->crossing[segment - 1].to;
}

typedef void piece_function(arb_t value, const struct scallop_piece *piece, const arb_t u, slong precision);

typedef void piece_place(arb_t u, const struct scallop_piece *piece, slong precision);

static bool is_zero_at(piece_function *f, const struct scallop_piece *piece, piece_place *place)
{
  SCOPED(arb, u, value);
  place(u, piece, 64);
  f(value, piece, u, 64);
  return arb_contains_zero(value);
}

const char *const branch_impossible =
    "l' is 0 or changes its sign within a phase: bodies turn there, too, and no series is derived for that";

bool branch_is_possible(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &gait->phase[kind];
    for (int i = 0; i < shape->count; i++) {
      const struct scallop_piece *piece = &shape->pieces[i];
      if (piece->direction != (kind == SCALLOP_EXTENSION ? 1 : -1))
        return false;
      if ((i > 0 && is_zero_at(scallop_ball_speed, piece, scallop_ball_begin))
          || (i + 1 < shape->count && is_zero_at(scallop_ball_speed, piece, scallop_ball_end)))
        return false;
    }
  }
  return true;
}

const char *const branch_without_ends =
    "l'' = 0 at an end of a phase: the switching times go as fractional powers of T; or "
    "the piece there is anchored elsewhere";

static void add_crossing(struct branch *b, const struct scallop_piece *piece, int curve, int to, bool tangent)
{
  struct crossing *at = &b->crossing[b->count++];
  at->tangent = tangent;
  at->piece = piece;
  at->curve = curve;
  at->to = to;
  series_set_si(&at->offset, 0);
}

/* A crossing at one end of the phase, which is at that offset of the piece: its anchor. Where l' jumps there is none: c
 * is small. */
static bool add_end(struct branch *b, const struct scallop_piece *piece, bool at_end, int curve, int to)
{
  piece_place *place = at_end ? scallop_ball_end : scallop_ball_begin;
  if (!is_zero_at(scallop_ball_speed, piece, place))
    return true;
  if ((at_end ? piece->end : piece->begin) != 0 || is_zero_at(scallop_ball_rate, piece, place))
    return false;
  add_crossing(b, piece, curve, to, false);
  return true;
}

/* Where l'' = 0 at the start of a phase from rest, friction that differs holds the body with more of it. Likewise */
static bool add_release(struct branch *b, const struct scallop_piece *piece, int sign)
{
  if (sign == 0 || !is_zero_at(scallop_ball_speed, piece, scallop_ball_begin)
      || !is_zero_at(scallop_ball_rate, piece, scallop_ball_begin))
    return true;
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, start);
  bool parabolic = piece->begin == 0 && scallop_rational_speed_series(speed, piece, start, 3, NULL)
                   && fmpq_poly_length(speed) == 3 && fmpz_is_zero(fmpq_poly_numref(speed) + 1);
  if (parabolic)
    add_crossing(b, piece, sign > 0 ? 0 : 1, 1, true);
  return parabolic;
}

bool branch_from_ends(struct branch *b, const struct phase_constants *p, int sign_at_start, int sign_at_end)
{
  const struct scallop_piece *first = &p->shape->pieces[0], *last = &p->shape->pieces[p->shape->count - 1];
  b->count = 0;
  b->first_region = 1;
  if (sign_at_start != 0) {
    if (!add_end(b, first, false, sign_at_start > 0 ? 0 : 1, 1))
      return false;
    if (b->count > 0)
      b->first_region = sign_at_start > 0 ? 0 : 2;
  } else if (!add_release(b, first, fmpq_sgn(p->beta[1])))
    return false;
  return sign_at_end == 0 || add_end(b, last, true, sign_at_end > 0 ? 0 : 1, sign_at_end > 0 ? 0 : 2);
}
