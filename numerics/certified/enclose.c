#include "numerics/certified/enclose.h"

#include "model/exact/fractions.h"

void scallop_enclose_offset(arb_t u, const struct scallop_piece *piece, const arb_t s, slong precision)
{
  arb_set(u, s);
  if (piece->anchor == SCALLOP_FROM_END) {
    arb_sub_ui(u, u, 1, precision);
    arb_neg(u, u);
  }
}

void scallop_enclose_gait(arb_t value, const struct scallop_piece *piece, const arb_t s, int order, slong precision)
{
  SCOPED(arb, u);
  scallop_enclose_offset(u, piece, s, precision);
  if (order == 0)
    scallop_ball_speed(value, piece, u, precision);
  else if (order == 1)
    scallop_ball_rate(value, piece, u, precision);
  else {
    SCOPED(arb_poly, series);
    scallop_ball_speed_series(series, piece, u, 3, precision);
    arb_poly_get_coeff_arb(value, series, 2);
    arb_mul_2exp_si(value, value, 1);
  }
  arb_mul_si(value, value, piece->direction, precision);
}

void scallop_enclose_end(arb_t s, const struct scallop_piece *piece, slong precision)
{
  SCOPED(fmpq, u);
  scallop_rational_end(u, piece);
  if (piece->anchor == SCALLOP_FROM_END) {
    fmpq_sub_si(u, u, 1);
    fmpq_neg(u, u);
  }
  arb_set_fmpq(s, u, precision);
}

/* A derivative of f, or f itself, over the ball s. */
static void enclose(arb_t value, const struct scallop_track *f, const arb_t s, int derivative, slong precision)
{
  scallop_enclose_gait(value, f->piece, s, f->order + derivative, precision);
  arb_mul(value, value, f->factor, precision);
  if (derivative == 1)
    arb_add(value, value, f->slope, precision);
  if (derivative == 0) {
    arb_addmul(value, f->slope, s, precision);
    arb_add(value, value, f->constant, precision);
  }
}

/* Most signs show at once: few bits are tried first. */
enum { FEW = 128 };

static int sign_over(const struct scallop_track *f, const arb_t s, int derivative, slong precision)
{
  SCOPED(arb, value);
  enclose(value, f, s, derivative, FLINT_MIN(FEW, precision));
  if (precision > FEW && arb_contains_zero(value))
    enclose(value, f, s, derivative, precision);
  return arb_sgn_nonzero(value);
}

/* Returns the sign of f over the ball s by the mean value theorem: for a small slope the excess is small. */
static int sign_by_mean_value(const struct scallop_track *f, const arb_t s, slong precision)
{
  SCOPED(arb, middle, value, slope);
  arb_get_mid_arb(middle, s);
  enclose(value, f, middle, 0, precision);
  enclose(slope, f, s, 1, precision);
  arb_sub(middle, s, middle, precision);
  arb_addmul(value, slope, middle, precision);
  return arb_sgn_nonzero(value);
}

/* One half of the ball, the earlier one or the later one. */
static void halve(arb_t x, bool earlier, slong precision)
{
  SCOPED(arf, low, middle, high);
  arf_set(middle, arb_midref(x));
  arb_get_interval_arf(low, high, x, precision);
  arb_set_interval_arf(x, earlier ? low : middle, earlier ? middle : high, precision);
}

/* Newton's method for the only zero in a ball over which f is monotone, until rounding is all that is left. Besides,
 * the sign in the middle decides the half: for slopes too uncertain for a good step. A step doubles the bits at most,
 * so it needs no more. */
static bool refine(arb_t zero, const struct scallop_track *f, slong precision)
{
  SCOPED(arb, middle, value, slope);
  SCOPED(mag, enough);
  bool right = true, going = true;
  slong bits = FLINT_MIN(FEW, precision);
  while (right && (going || bits < precision)) {
    slong known = FLINT_MIN(FLINT_MAX(arb_rel_accuracy_bits(zero), 0), precision);
    bits = going ? FLINT_MIN(FLINT_MAX(bits, 2 * known + FEW), precision) : precision;
    mag_mul_ui(enough, arb_radref(zero), 3);
    mag_mul_2exp_si(enough, enough, -2);
    arb_get_mid_arb(middle, zero);
    enclose(value, f, middle, 0, bits);
    enclose(slope, f, zero, 1, bits);
    int side = arb_sgn_nonzero(value) * arb_sgn_nonzero(slope);
    arb_div(value, value, slope, bits);
    arb_sub(middle, middle, value, precision);
    if (side != 0)
      halve(zero, side > 0, precision);
    if (arb_is_finite(middle))
      right = arb_intersection(zero, zero, middle, precision);
    going = mag_cmp(arb_radref(zero), enough) < 0;
  }
  return right && arb_is_finite(zero);
}

enum judgement { NOTHING, ZERO, UNKNOWN, UNKNOWN_AT_END };

/* Returns whether l' or l'' (order 0, 1) is exactly 0 at the end of the piece; a ball may not hold that end exactly. */
static bool gait_ends_in_zero(const struct scallop_piece *piece, int order)
{
  SCOPED(fmpq, u);
  SCOPED(fmpq_poly, series);
  scallop_rational_end(u, piece);
  bool rational = scallop_rational_speed_series(series, piece, u, order + 1, NULL);
  fmpq_poly_get_coeff_fmpq(u, series, order);
  return rational && fmpq_is_zero(u);
}

/* A margin that is 0 exactly where a piece ends is looked at again by the next piece, and what happens at the end of
 * the phase does not matter to it: equal forces while l'' goes to 0. So such an end can be left out of the stretch. */
static bool ends_in_zero(const struct scallop_track *f, const arb_t end, slong precision)
{
  SCOPED(arb, value);
  scallop_enclose_end(value, f->piece, precision);
  if (arb_equal(value, end) && gait_ends_in_zero(f->piece, f->order)) {
    arb_mul(value, f->slope, end, precision);
    arb_add(value, value, f->constant, precision);
  } else
    enclose(value, f, end, 0, precision);
  return arb_is_zero(value) && (f->order == 1 || arb_is_one(end));
}

/* Judges (begin, end] as a whole: returns what is certain there; over is its ball. */
static enum judgement judge(const struct scallop_track *f, const struct scallop_stretch *w, const arb_t over,
                            slong precision)
{
  int slope = sign_over(f, over, 1, precision);
  if (slope == w->sign)
    return NOTHING;
  if (w->departure == SCALLOP_FROM_ZERO_FLAT)
    return sign_over(f, over, 2, precision) == w->sign ? NOTHING : UNKNOWN;
  if (w->departure == SCALLOP_FROM_ZERO)
    return UNKNOWN;
  if (slope == 0)
    return sign_by_mean_value(f, over, precision) == w->sign ? NOTHING : UNKNOWN;
  int at_end = sign_over(f, w->end, 0, precision);
  return at_end == w->sign ? NOTHING : at_end ? ZERO : UNKNOWN_AT_END;
}

/* Returns whether f = factor l' exactly: then f is not 0 inside a piece. */
static bool is_gait_itself(const struct scallop_track *f)
{
  return f->order == 0 && arb_is_zero(f->constant) && arb_is_zero(f->slope);
}

/* From the begin on in steps that are halved until something is certain, and doubled again. Powers of 2: the step is
 * 2^-halvings. */
enum scallop_found scallop_first_zero(arb_t zero, const struct scallop_track *f, const struct scallop_stretch *stretch,
                                      slong precision)
{
  if (is_gait_itself(f))
    return SCALLOP_NONE;
  SCOPED(arb, begin, end, over, step);
  arb_set(begin, stretch->begin);
  struct scallop_stretch now = { begin, end, stretch->sign, stretch->departure };
  for (slong halvings = 0; halvings <= precision;) {
    arb_one(step);
    arb_mul_2exp_si(step, step, -halvings);
    arb_get_mid_arb(end, begin);
    arb_add(end, end, step, 2 * precision);
    bool last = !arb_lt(end, stretch->end);
    if (last)
      arb_set(end, stretch->end);
    if (!arb_lt(begin, end))
      break; /* GCOVR_EXCL_LINE: needs a begin less precise than the step; halvings <= precision rules that out */
    arb_union(over, begin, end, precision);
    enum judgement judged = judge(f, &now, over, precision);
    if (judged == ZERO) {
      arb_set(zero, over);
      return refine(zero, f, precision) ? SCALLOP_CROSSES : SCALLOP_GRAZES;
    }
    if (last && (judged == NOTHING || judged == UNKNOWN_AT_END))
      return judged == NOTHING || ends_in_zero(f, end, precision) ? SCALLOP_NONE : SCALLOP_AT_END;
    halvings += judged == NOTHING ? -(halvings > 0) : 1;
    if (judged == NOTHING) {
      arb_set(begin, end);
      now.departure = SCALLOP_APART;
    }
  }
  return SCALLOP_GRAZES;
}
