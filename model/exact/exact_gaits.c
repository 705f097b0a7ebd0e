/* The gaits of families.h in fractions: the pieces are made in doubles, and each gets its fractions. */
#include <stdlib.h>

#include "model/exact/fractions.h"

static struct scallop_piece *piece_of(struct scallop_exact_gait *e, int kind, int i)
{
  return e->pieces + (kind == 0 ? 0 : e->gait.phase[0].count) + i;
}

static struct scallop_fractions *fractions_of(struct scallop_exact_gait *e, int kind, int i)
{
  return e->fractions + (piece_of(e, kind, i) - e->pieces);
}

static bool is_from_start(const struct scallop_piece *p) { return p->anchor == SCALLOP_FROM_START; }

/* Sets rest = 1 - x. */
static void rest_of(fmpq_t rest, const fmpq_t x)
{
  fmpq_sub_si(rest, x, 1);
  fmpq_neg(rest, rest);
}

static bool are_same(const struct scallop_fractions *a, const struct scallop_fractions *b)
{
  return fmpq_equal(a->origin, b->origin) && fmpq_equal(a->least, b->least) && fmpq_equal(a->most, b->most)
         && fmpq_poly_equal(a->speed, b->speed);
}

/* Shares the fractions of pieces that are mirror images of each other, within a phase or from one phase to the other:
 * scallop_gait_mirrors and scallop_gait_is_reversible compare them by address. */
static void share(struct scallop_exact_gait *e)
{
  const struct scallop_shape *phase = e->gait.phase;
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < phase[kind].count; i++) {
      struct scallop_fractions *f = fractions_of(e, kind, i);
      int back = phase[kind].count - 1 - i;
      const struct scallop_fractions *shared = f;
      if (back < i && are_same(f, fractions_of(e, kind, back)))
        shared = piece_of(e, kind, back)->exact;
      if (kind == 1 && i < phase[0].count && are_same(f, fractions_of(e, 0, i)))
        shared = piece_of(e, 0, i)->exact;
      piece_of(e, kind, i)->exact = shared;
    }
}

/* Removes pieces of zero duration; rounding makes their duration in doubles positive. */
static void leave_out_empty(struct scallop_exact_gait *e)
{
  struct scallop_piece *from[2] = { piece_of(e, 0, 0), piece_of(e, 1, 0) };
  for (int kind = 0; kind < 2; kind++) {
    struct scallop_shape *shape = &e->gait.phase[kind];
    int kept = 0;
    for (int i = 0; i < shape->count; i++)
      if (!fmpq_equal(from[kind][i].exact->least, from[kind][i].exact->most))
        from[kind][kept++] = from[kind][i];
    shape->count = kept;
  }
}

static void set_form(fmpq_t x, const struct scallop_straight_form *form, const fmpq_t up, const fmpq_t down)
{
  SCOPED(fmpq, c);
  scallop_rational_set_double(x, form->one);
  scallop_rational_set_double(c, form->up);
  fmpq_addmul(x, c, up);
  scallop_rational_set_double(c, form->down);
  fmpq_addmul(x, c, down);
}

/* Computes the fractions of a piece from the numbers of which its doubles were computed. */
static void set_straight(struct scallop_fractions *f, const struct scallop_straight_line *line, bool from_start,
                         const fmpq_t up, const fmpq_t down)
{
  SCOPED(fmpq, divisor, mean, c);
  fmpq_zero(f->origin);
  set_form(from_start ? f->least : f->most, &line->begin, up, down);
  set_form(from_start ? f->most : f->least, &line->end, up, down);
  set_form(divisor, &line->divisor, up, down);
  set_form(mean, &line->mean, up, down);
  fmpq_mul(divisor, divisor, mean);
  fmpq_poly_zero(f->speed);
  for (int k = 0; k < 2; k++) {
    scallop_rational_set_double(c, k == 0 ? line->start : line->slope);
    fmpq_poly_set_coeff_fmpq(f->speed, k, c);
  }
  fmpq_poly_scalar_div_fmpq(f->speed, f->speed, divisor);
}

/* Computes the pieces; up: of each phase; down: of each phase, `apart` numbers from one phase to the next. The falling
 * part takes the rest if up and down add up to more than 1, unlike the doubles. */
static void set_straights(struct scallop_exact_gait *e, const struct scallop_straight *made, const fmpq *up,
                          const fmpq *down, int apart)
{
  SCOPED(fmpq, rest);
  for (int kind = 0; kind < 2; kind++, up += apart, down += apart) {
    rest_of(rest, up);
    for (int i = 0; i < e->gait.phase[kind].count; i++)
      set_straight(fractions_of(e, kind, i), &made->lines[kind][i], is_from_start(piece_of(e, kind, i)), up,
                   fmpq_cmp(down, rest) > 0 ? rest : down);
  }
  share(e);
  leave_out_empty(e);
}

/* The law of a family (families.h): changes *e, the exact values of the gait's doubles, to the gait of the numbers x of
 * both phases. Returns false if *e is unchanged. */
typedef bool exact_law(struct scallop_exact_gait *e, const union scallop_made_gait *made, const fmpq *x, int count);

static bool exact_trapezoidal(struct scallop_exact_gait *e, const union scallop_made_gait *made, const fmpq *x,
                              int count)
{
  set_straights(e, &made->straight, x, x + 1, count / 2);
  return true;
}

/* One number per phase: |l'| rises during this fraction, is constant, and falls during the same fraction; without a
 * constant part it falls during the rest. */
static bool exact_one_ramp(struct scallop_exact_gait *e, const union scallop_made_gait *made, const fmpq *x, int count)
{
  set_straights(e, &made->straight, x, x, count / 2);
  return true;
}

static bool never_turns(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < gait->phase[kind].count; i++)
      if (gait->phase[kind].pieces[i].direction != (kind == 0 ? 1 : -1))
        return false;
  return true;
}

/* Computes l' from the start, and as seen from the end. Returns false if it is not 0 at both ends. */
static bool set_speeds(fmpq_poly_t forward, fmpq_poly_t back, const fmpq *c, int degree)
{
  SCOPED(fmpq, sum, at_end);
  fmpq_poly_zero(forward);
  for (int k = 0; k < degree; k++) {
    fmpq_add(sum, sum, c + k);
    fmpq_mul_si(at_end, c + k, k + 1);
    fmpq_poly_set_coeff_fmpq(forward, k, at_end);
  }
  bool right = !fmpq_is_zero(sum);
  if (right)
    fmpq_poly_scalar_div_fmpq(forward, forward, sum);
  fmpq_poly_set_coeff_si(back, 0, 1);
  fmpq_poly_set_coeff_si(back, 1, -1);
  fmpq_poly_compose(back, forward, back);
  fmpq_poly_get_coeff_fmpq(sum, forward, 0);
  fmpq_poly_get_coeff_fmpq(at_end, back, 0);
  right = right && fmpq_is_zero(sum) && fmpq_is_zero(at_end);
  return right;
}

/* c: coefficients of s, s^2, ... Returns false if l' is not exactly 0 at both ends, or changes its sign within a phase:
 * its zeros are then not rational. */
static bool exact_polynomial(struct scallop_exact_gait *e, const union scallop_made_gait *made, const fmpq *c,
                             int degree)
{
  (void)made;
  SCOPED(fmpq_poly, forward, back);
  bool right = never_turns(&e->gait) && set_speeds(forward, back, c, degree);
  for (int i = 0; right && i < e->count; i++) {
    fmpq_zero(e->fractions[i].origin);
    fmpq_poly_set(e->fractions[i].speed, is_from_start(&e->pieces[i]) ? forward : back);
  }
  if (right)
    share(e);
  return right;
}

#define LAW(family, law) law,
static exact_law *const laws[] = { SCALLOP_GAIT_FAMILIES(LAW) };

bool scallop_exact_made(struct scallop_exact_gait *e, const struct scallop_gait_family *family,
                        const struct scallop_gait *gait, const fmpq *x, int count)
{
  int of = 0, all = family->each == 0 ? count : 2 * family->each;
  while (scallop_gait_family(of) != family)
    of++;
  scallop_exact_of(e, gait);
  if (!laws[of])
    return false;
  fmpq *both = _fmpq_vec_init(all);
  for (int i = 0; i < all; i++)
    fmpq_set(both + i, x + i % count);
  bool made = laws[of](e, (const union scallop_made_gait *)gait, both, all);
  _fmpq_vec_clear(both, all);
  return made;
}
