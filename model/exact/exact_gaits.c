/* The gaits of families.h in fractions, and splines: the pieces that the doubles make, each with what the fractions
 * make of it. */
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

/* 1 - x */
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

/* Pieces that are mirror images of each other within a phase, or from one phase to the other, share their fractions: by
 * that they are known to be (scallop_gait_mirrors, scallop_gait_is_reversible). */
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

/* Pieces that last no time, where fractions add up to what doubles only nearly do */
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

/* The parts of a phase in which |l'| rises, stays, and falls; the fall may be split at half of the phase, and what
 * stays as well. */
enum part { RISES, STAYS, FALLS, FALLS_FROM_START };

static enum part part_of(const struct scallop_piece *p)
{
  if (p->acceleration == 0)
    return STAYS;
  return p->velocity != 0 ? FALLS_FROM_START : is_from_start(p) ? RISES : FALLS;
}

/* What a piece with the other anchor leaves of the phase: half, where a part is split there */
static void set_most(struct scallop_fractions *f, const struct scallop_shape *shape, int i, const fmpq_t up,
                     const fmpq_t down)
{
  enum part here = part_of(&shape->pieces[i]);
  bool from_start = is_from_start(&shape->pieces[i]);
  enum part other = part_of(&shape->pieces[i + (from_start ? 1 : -1)]);
  if (here == RISES)
    fmpq_set(f->most, up);
  else if ((here == STAYS && other == STAYS) || here == FALLS_FROM_START || other == FALLS_FROM_START)
    fmpq_set_si(f->most, 1, 2);
  else if (here == FALLS)
    fmpq_set(f->most, down);
  else
    rest_of(f->most, from_start ? down : up);
}

/* height: of |l'| where it stays */
static void set_straight(struct scallop_fractions *f, const struct scallop_shape *shape, int i, const fmpq_t up,
                         const fmpq_t down, const fmpq_t height)
{
  enum part here = part_of(&shape->pieces[i]);
  SCOPED(fmpq, steep);
  fmpq_zero(f->origin);
  fmpq_poly_zero(f->speed);
  set_most(f, shape, i, up, down);
  fmpq_zero(f->least);
  if (here == STAYS || here == FALLS_FROM_START)
    fmpq_set(f->least, is_from_start(&shape->pieces[i]) ? up : down);
  if (here != STAYS)
    fmpq_div(steep, height, here == RISES ? up : down);
  if (here == STAYS)
    fmpq_poly_set_coeff_fmpq(f->speed, 0, height);
  else if (here == FALLS_FROM_START) {
    fmpq_poly_set_coeff_fmpq(f->speed, 0, steep);
    fmpq_neg(steep, steep);
  }
  if (here != STAYS)
    fmpq_poly_set_coeff_fmpq(f->speed, 1, steep);
}

static void set_straight_phase(struct scallop_exact_gait *e, int kind, const fmpq_t up, const fmpq_t down)
{
  const struct scallop_shape *shape = &e->gait.phase[kind];
  bool stays = false;
  SCOPED(fmpq, fall, height);
  for (int i = 0; i < shape->count; i++)
    stays = stays || part_of(&shape->pieces[i]) == STAYS;
  fmpq_add(height, up, down);
  if (stays && fmpq_cmp_si(height, 1) <= 0)
    fmpq_set(fall, down);
  else
    rest_of(fall, up);
  fmpq_add(height, up, fall);
  fmpq_div_2exp(height, height, 1);
  rest_of(height, height);
  fmpq_inv(height, height);
  for (int i = 0; i < shape->count; i++)
    set_straight(fractions_of(e, kind, i), shape, i, up, fall, height);
}

/* up: of each phase; down: likewise, `apart` numbers from one phase to the next */
static void set_straights(struct scallop_exact_gait *e, const fmpq *up, const fmpq *down, int apart)
{
  for (int kind = 0; kind < 2; kind++)
    set_straight_phase(e, kind, up + apart * kind, down + apart * kind);
  share(e);
  leave_out_empty(e);
}

/* What families.h calls the law of a family: what the numbers x, of both phases, make of what the doubles say, which *e
 * is. False: it is left as it is. */
typedef bool exact_law(struct scallop_exact_gait *e, const fmpq *x, int count);

static bool exact_trapezoidal(struct scallop_exact_gait *e, const fmpq *x, int count)
{
  set_straights(e, x, x + 1, count / 2);
  return true;
}

/* A number of each phase: |l'| rises for that, stays, and falls for as much; or, where it does not stay, for the
 * rest */
static bool exact_one_ramp(struct scallop_exact_gait *e, const fmpq *x, int count)
{
  set_straights(e, x, x, count / 2);
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

/* l' from the start, and as seen from the end; false: it is not 0 at both ends. */
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

/* c: of s, s^2, ... False where l' is not exactly 0 at both ends, and where it changes its sign within a phase: its
 * zeros are no fractions. */
static bool exact_polynomial(struct scallop_exact_gait *e, const fmpq *c, int degree)
{
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
  bool made = laws[of](e, both, all);
  _fmpq_vec_clear(both, all);
  return made;
}
