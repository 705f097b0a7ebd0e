#include "model/exact/ball.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/exact/fractions.h"
#include "model/law.h"

static fmpq *fields(struct scallop_rational_crawler *c, int i)
{
  fmpq *all[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  return all[i];
}
enum { FIELDS = 7 };

void scallop_rational_init(struct scallop_rational_crawler *c)
{
  for (int i = 0; i < FIELDS; i++)
    fmpq_init(fields(c, i));
  c->gait = NULL;
}

void scallop_rational_clear(struct scallop_rational_crawler *c)
{
  for (int i = 0; i < FIELDS; i++)
    fmpq_clear(fields(c, i));
}

void scallop_rational_copy(struct scallop_rational_crawler *to, const struct scallop_rational_crawler *from)
{
  for (int i = 0; i < FIELDS; i++)
    fmpq_set(fields(to, i), fields((struct scallop_rational_crawler *)from, i));
  to->gait = from->gait;
}

void scallop_rational_set_double(fmpq_t x, double value)
{
  SCOPED(arf, exact);
  arf_set_d(exact, value);
  arf_get_fmpq(x, exact);
}

void scallop_rational_of(struct scallop_rational_crawler *exact, const struct scallop_crawler *c)
{
  const double values[FIELDS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  for (int i = 0; i < FIELDS; i++)
    scallop_rational_set_double(fields(exact, i), values[i]);
  exact->gait = c->gait;
}

bool scallop_rational_is_valid(const struct scallop_rational_crawler *c)
{
  const fmpq *positive[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->alpha };
  for (size_t i = 0; i < sizeof positive / sizeof *positive; i++)
    if (fmpq_sgn(positive[i]) <= 0)
      return false;
  return fmpq_cmp_si(c->alpha, 1) < 0 && c->gait;
}

void scallop_rational_fraction(fmpq_t fraction, const struct scallop_rational_crawler *c, enum scallop_phase_kind kind)
{
  fmpq_set(fraction, c->alpha);
  if (kind == SCALLOP_CONTRACTION) {
    fmpq_neg(fraction, fraction);
    fmpq_add_si(fraction, fraction, 1);
  }
}

void scallop_rational_duration(fmpq_t duration, const struct scallop_rational_crawler *c, enum scallop_phase_kind kind)
{
  scallop_rational_fraction(duration, c, kind);
  fmpq_mul(duration, duration, c->T);
}

/* x = digits base^exponent */
static void scale_by_power(fmpq_t x, const fmpz_t digits, ulong base, slong exponent)
{
  SCOPED(fmpz, power);
  fmpz_ui_pow_ui(power, base, (ulong)labs(exponent));
  fmpq_set_fmpz(x, digits);
  if (exponent >= 0)
    fmpq_mul_fmpz(x, x, power);
  else
    fmpq_div_fmpz(x, x, power);
}

/* Reads digits with at most one point among them, in the given base. Returns their end, or NULL; *places: count of
 * digits after the point. */
static const char *read_digits(const char *text, int base, char *digits, slong *places)
{
  bool point = false, some = false;
  *places = 0;
  for (; isxdigit((unsigned char)*text) || *text == '.'; text++) {
    if (*text == '.') {
      if (point)
        return NULL;
      point = true;
    } else if (base == 16 || isdigit((unsigned char)*text)) {
      *digits++ = *text;
      *places += point;
      some = true;
    } else
      break;
  }
  *digits = '\0';
  return some ? text : NULL;
}

bool scallop_rational_parse(fmpq_t x, const char *text)
{
  enum { LARGEST_EXPONENT = 100000 };
  bool negative = *text == '-', read = false;
  text += negative || *text == '+';
  bool hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  text += hexadecimal ? 2 : 0;
  int base = hexadecimal ? 16 : 10;
  slong places, exponent = 0;
  char *digits = malloc(strlen(text) + 1), *end = NULL;
  SCOPED(fmpz, mantissa);
  const char *after = digits ? read_digits(text, base, digits, &places) : NULL;
  if (after && tolower((unsigned char)*after) == (hexadecimal ? 'p' : 'e')
      && (isdigit((unsigned char)after[1]) || strchr("+-", after[1]))) {
    errno = 0;
    exponent = strtol(after + 1, &end, 10);
    after = errno == 0 && end != after + 1 ? end : NULL;
  }
  if (after && *after == '\0' && exponent >= -LARGEST_EXPONENT && exponent <= LARGEST_EXPONENT
      && fmpz_set_str(mantissa, digits, base) == 0) {
    scale_by_power(x, mantissa, hexadecimal ? 2 : 10, exponent - (hexadecimal ? 4 : 1) * places);
    if (negative)
      fmpq_neg(x, x);
    read = true;
  }
  free(digits);
  return read;
}

bool scallop_gait_is_rational(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < gait->phase[kind].count; i++)
      if (law_is_sine(&gait->phase[kind].pieces[i]))
        return false;
  return scallop_gait_is_exact(gait);
}

/* Returns |l'| of a piece that is not a sine: its own fractions, or the exact values of its doubles, in *made. */
static const struct scallop_fractions *fractions_for(const struct scallop_piece *p, struct scallop_fractions *made)
{
  if (!p->exact)
    fractions_of_doubles(made, p);
  return p->exact ? p->exact : made;
}

/* Computes |l'| as a polynomial in sign time + start: exact for an exact start. */
static void polynomial_of_time(fmpq_poly_t law, const struct scallop_piece *p, int sign, const fmpq_t start)
{
  SCOPED(fmpq, offset);
  SCOPED(fmpq_poly, shifted);
  SCOPED(fractions, made);
  const struct scallop_fractions *f = fractions_for(p, &made);
  fmpq_sub(offset, start, f->origin);
  fmpq_poly_set_coeff_si(shifted, 1, sign);
  fmpq_poly_set_coeff_fmpq(shifted, 0, offset);
  fmpq_poly_compose(law, f->speed, shifted);
}

/* Sets x = u - origin. */
static void shift(arb_t x, const arb_t u, const fmpq_t origin, slong precision)
{
  SCOPED(arb, o);
  arb_set_fmpq(o, origin, precision);
  arb_sub(x, u, o, precision);
}

/* Computes a derivative of |l'| with respect to u, or for order -1 its integral from the origin, of a piece that is not
 * a sine; Horner's rule. */
static void evaluate(arb_t value, const struct scallop_piece *p, int order, const arb_t u, slong precision)
{
  SCOPED(fractions, made);
  const struct scallop_fractions *f = fractions_for(p, &made);
  SCOPED(arb, x, sum);
  SCOPED(fmpz, c);
  shift(x, u, f->origin, precision);
  for (slong k = fmpq_poly_degree(f->speed); k >= FLINT_MAX(order, 0); k--) {
    fmpz_set(c, fmpq_poly_numref(f->speed) + k);
    for (int i = 0; i < order; i++)
      fmpz_mul_si(c, c, k - i);
    arb_mul(sum, sum, x, precision);
    if (order >= 0)
      arb_add_fmpz(sum, sum, c, precision);
    else {
      arb_set_fmpz(value, c);
      arb_div_si(value, value, k + 1, precision);
      arb_add(sum, sum, value, precision);
    }
  }
  if (order < 0)
    arb_mul(sum, sum, x, precision);
  arb_div_fmpz(value, sum, fmpq_poly_denref(f->speed), precision);
}

static void set_place(arb_t u, const struct scallop_piece *p, void (*place)(fmpq_t, const struct scallop_piece *),
                      slong precision)
{
  SCOPED(fmpq, exact);
  place(exact, p);
  arb_set_fmpq(u, exact, precision);
}

void scallop_ball_begin(arb_t u, const struct scallop_piece *p, slong precision)
{
  set_place(u, p, scallop_rational_begin, precision);
}

void scallop_ball_end(arb_t u, const struct scallop_piece *p, slong precision)
{
  set_place(u, p, scallop_rational_end, precision);
}

void scallop_ball_speed(arb_t speed, const struct scallop_piece *p, const arb_t u, slong precision)
{
  if (law_is_sine(p)) { /* (pi/2) sin(pi u) */
    SCOPED(arb, half_pi);
    arb_const_pi(half_pi, precision);
    arb_mul_2exp_si(half_pi, half_pi, -1);
    arb_sin_pi(speed, u, precision);
    arb_mul(speed, speed, half_pi, precision);
    return;
  }
  evaluate(speed, p, 0, u, precision);
}

void scallop_ball_rate(arb_t rate, const struct scallop_piece *p, const arb_t u, slong precision)
{
  if (law_is_sine(p)) { /* (pi^2/2) cos(pi u) */
    SCOPED(arb, pi);
    arb_const_pi(pi, precision);
    arb_mul(pi, pi, pi, precision);
    arb_mul_2exp_si(pi, pi, -1);
    arb_cos_pi(rate, u, precision);
    arb_mul(rate, rate, pi, precision);
  } else
    evaluate(rate, p, 1, u, precision);
  arb_mul_si(rate, rate, law_sense(p), precision);
}

void scallop_ball_way(arb_t way, const struct scallop_piece *p, const arb_t u, const arb_t v, slong precision)
{
  SCOPED(arb, a, b);
  if (law_is_sine(p)) { /* (cos(pi u) - cos(pi v))/2 = sin(pi (u + v)/2) sin(pi (v - u)/2) */
    arb_add(a, u, v, precision);
    arb_sub(b, v, u, precision);
    arb_mul_2exp_si(a, a, -1);
    arb_mul_2exp_si(b, b, -1);
    arb_sin_pi(a, a, precision);
    arb_sin_pi(b, b, precision);
    arb_mul(way, a, b, precision);
  } else {
    evaluate(a, p, -1, u, precision);
    evaluate(b, p, -1, v, precision);
    arb_sub(way, b, a, precision);
  }
  arb_mul_si(way, way, law_sense(p), precision);
}

void scallop_ball_speed_series(arb_poly_t series, const struct scallop_piece *p, const arb_t u, slong length,
                               slong precision)
{
  SCOPED(arb, s);
  SCOPED(arb_poly, time);
  arb_set_si(s, law_sense(p));
  arb_poly_set_coeff_arb(time, 1, s);
  arb_poly_set_coeff_arb(time, 0, u);
  if (law_is_sine(p)) {
    arb_poly_sin_pi_series(series, time, length, precision);
    arb_const_pi(s, precision);
    arb_mul_2exp_si(s, s, -1);
    arb_poly_scalar_mul(series, series, s, precision);
  } else {
    SCOPED(fractions, made);
    const struct scallop_fractions *f = fractions_for(p, &made);
    shift(s, u, f->origin, precision);
    arb_poly_set_coeff_arb(time, 0, s);
    arb_poly_set_fmpq_poly(series, f->speed, precision);
    arb_poly_compose(series, series, time, precision);
    arb_poly_truncate(series, length);
  }
}

/* Evaluates a polynomial of a series, by Horner's rule. */
static void evaluate_along(arb_poly_t value, const fmpq_poly_t law, const arb_poly_t x, slong length, slong precision)
{
  SCOPED(fmpq, c);
  SCOPED(arb, ball, constant);
  SCOPED(arb_poly, sum);
  for (slong k = fmpq_poly_degree(law); k >= 0; k--) {
    arb_poly_mullow(sum, sum, x, length, precision);
    fmpq_poly_get_coeff_fmpq(c, law, k);
    arb_poly_get_coeff_arb(ball, sum, 0);
    arb_set_fmpq(constant, c, precision);
    arb_add(ball, ball, constant, precision);
    arb_poly_set_coeff_arb(sum, 0, ball);
  }
  arb_poly_swap(value, sum);
}

void scallop_ball_speed_along(arb_poly_t speed, arb_poly_t rate, const struct scallop_piece *p, const arb_t u,
                              const arb_poly_t time, slong length, slong precision)
{
  SCOPED(arb, pi);
  SCOPED(arb_poly, offset);
  arb_poly_set(offset, time);
  if (law_sense(p) < 0)
    arb_poly_neg(offset, offset);
  arb_poly_set_coeff_arb(offset, 0, u);
  if (law_is_sine(p)) {
    arb_poly_sin_cos_pi_series(speed, rate, offset, length, precision);
    arb_const_pi(pi, precision);
    arb_mul_2exp_si(pi, pi, -1);
    arb_poly_scalar_mul(speed, speed, pi, precision);
    arb_mul(pi, pi, pi, precision);
    arb_mul_2exp_si(pi, pi, 1);
    arb_poly_scalar_mul(rate, rate, pi, precision);
  } else {
    SCOPED(fmpq_poly, slope);
    SCOPED(fractions, made);
    const struct scallop_fractions *f = fractions_for(p, &made);
    shift(pi, u, f->origin, precision);
    arb_poly_set_coeff_arb(offset, 0, pi);
    evaluate_along(speed, f->speed, offset, length, precision);
    fmpq_poly_derivative(slope, f->speed);
    evaluate_along(rate, slope, offset, length, precision);
  }
  if (law_sense(p) < 0)
    arb_poly_neg(rate, rate);
}

bool scallop_piece_continues(const struct scallop_piece *p, const struct scallop_piece *next, bool *turned)
{
  *turned = p->anchor != next->anchor;
  if (law_is_sine(p) || law_is_sine(next))
    return law_is_sine(p) && law_is_sine(next);
  SCOPED(fmpq, start);
  SCOPED(fmpq_poly, here, there);
  polynomial_of_time(here, p, 1, start);
  fmpq_set_si(start, *turned, 1);
  polynomial_of_time(there, next, *turned ? -1 : 1, start);
  return p->direction == next->direction && fmpq_poly_equal(here, there);
}

/* (1/2) sum over k of (-1)^k pi^(2k+2) u^(2k+1) / (2k+1)! */
static void sine_at_its_zero(fmpq_poly_t series, slong length, const fmpq_t pi_squared)
{
  SCOPED(fmpq, c);
  fmpq_poly_zero(series);
  fmpq_div_2exp(c, pi_squared, 1);
  for (slong k = 1; k < length; k += 2) {
    fmpq_poly_set_coeff_fmpq(series, k, c);
    fmpq_mul(c, c, pi_squared);
    fmpq_mul_si(c, c, -1);
    fmpz_mul_ui(fmpq_denref(c), fmpq_denref(c), (ulong)((k + 1) * (k + 2)));
    fmpq_canonicalise(c);
  }
}

bool scallop_rational_speed_series(fmpq_poly_t series, const struct scallop_piece *p, const fmpq_t u, slong length,
                                   const fmpq_t pi_squared)
{
  if (law_is_sine(p) && (!pi_squared || !fmpq_is_zero(u)))
    return false;
  if (law_is_sine(p)) {
    SCOPED(fmpq_poly, time);
    fmpq_poly_set_coeff_si(time, 1, law_sense(p));
    sine_at_its_zero(series, length, pi_squared);
    fmpq_poly_compose(series, series, time);
  } else
    polynomial_of_time(series, p, law_sense(p), u);
  fmpq_poly_truncate(series, length);
  return true;
}
