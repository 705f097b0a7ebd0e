#include "compare/claims/proven.h"

#include "numerics/certified.h"
#include "compare/answers/rational.h"

bool proven_steady(struct scallop_certified_steady *s, const struct scallop_crawler *c)
{
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_crawler(&exact, c);
  bool solved = scallop_certified_steady(&exact, PROVEN_DIGITS, s, NULL) == SCALLOP_OK;
  scallop_rational_clear(&exact);
  return solved;
}

static bool phase_from(struct scallop_certified_phase *p, const struct scallop_crawler *c, enum scallop_phase_kind kind,
                       const fmpq_t v0)
{
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_crawler(&exact, c);
  bool solved = scallop_certified_phase(&exact, kind, v0, PROVEN_DIGITS, p, NULL) == SCALLOP_OK;
  scallop_rational_clear(&exact);
  return solved;
}

bool proven_phase(struct scallop_certified_phase *p, const struct scallop_crawler *c, enum scallop_phase_kind kind,
                  double v0)
{
  fmpq_t exact;
  fmpq_init(exact);
  scallop_rational_set_double(exact, v0);
  bool solved = phase_from(p, c, kind, exact);
  fmpq_clear(exact);
  return solved;
}

bool proven_move(arb_t dxC, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t v0)
{
  struct scallop_certified_phase p;
  bool solved = true;
  arf_t end[2];
  fmpq_t v;
  arb_t moved[2];
  arf_init(end[0]);
  arf_init(end[1]);
  fmpq_init(v);
  scallop_certified_phase_init(&p);
  arb_get_interval_arf(end[0], end[1], v0, PROVEN_BITS);
  for (int i = 0; i < 2; i++) {
    arb_init(moved[i]);
    arf_get_fmpq(v, end[i]);
    solved = phase_from(&p, c, kind, v) && solved;
    arb_set(moved[i], p.dxC);
  }
  arb_union(dxC, moved[0], moved[1], PROVEN_BITS);
  for (int i = 0; i < 2; i++) {
    arb_clear(moved[i]);
    arf_clear(end[i]);
  }
  scallop_certified_phase_clear(&p);
  fmpq_clear(v);
  return solved;
}

/* The piece that a part of the phase lies in, and its offset there; a part within rounding of where two meet is in the earlier one. */
static const struct scallop_piece *piece_at(arb_t offset, const struct scallop_shape *shape, const arb_t part, bool from_end)
{
  const struct scallop_piece *piece = shape->pieces, *last = piece + shape->count - 1;
  arb_t other;
  arb_init(other);
  arb_sub_ui(other, part, 1, PROVEN_BITS);
  arb_neg(other, other);
  double time = proven_middle(from_end ? other : part); /* since the start */
  while (piece < last && time > (piece->anchor == SCALLOP_FROM_END ? 1 - piece->end : piece->end))
    piece++;
  arb_set(offset, (piece->anchor == SCALLOP_FROM_END) == from_end ? part : other);
  arb_clear(other);
  return piece;
}

void proven_speed(arb_t speed, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t part,
                  bool from_end)
{
  arb_t offset;
  arb_init(offset);
  const struct scallop_piece *piece = piece_at(offset, &c->gait->phase[kind], part, from_end);
  scallop_ball_speed(speed, piece, offset, PROVEN_BITS);
  arb_clear(offset);
}

void proven_acceleration(arb_t acceleration, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t part,
                         bool from_end)
{
  arb_t offset;
  arb_init(offset);
  const struct scallop_piece *piece = piece_at(offset, &c->gait->phase[kind], part, from_end);
  scallop_ball_rate(acceleration, piece, offset, PROVEN_BITS);
  arb_mul_si(acceleration, acceleration, piece->direction, PROVEN_BITS);
  arb_clear(offset);
}

double proven_middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

double proven_over(const arb_t x, double unit) { return proven_middle(x) / unit; }
