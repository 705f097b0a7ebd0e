#include "numerics/certified/march.h"

static const char *const grazing[] = { "body 1 touches zero velocity without turning, or almost: grazing",
                                       "body 2 touches zero velocity without turning, or almost: grazing" };
static const char *const at_end[] = { "body 1 comes to rest just as a piece of the gait ends, or as body 2 does",
                                      "body 2 comes to rest just as a piece of the gait ends, or as body 1 does" };
static const char *const at_limit[] = { "the force that holds body 1 is exactly at its limit, or almost",
                                        "the force that holds body 2 is exactly at its limit, or almost" };

static bool undecided(struct scallop_march *m, const char *why)
{
  m->why = why;
  return false;
}

/* Decides whether a body continues or friction holds it when its velocity has reached 0. False: undecided. */
static bool turn(struct scallop_march *m, int body)
{
  int *s = &m->s[body];
  march_settle(m);
  march_rest(m, body);
  enum hold beyond = march_hold_against(m, body, -*s);
  if (beyond == UNDECIDED)
    return undecided(m, at_limit[body]);
  m->departure[0] = m->departure[1] = SCALLOP_APART;
  if (beyond == HELD) {
    arb_zero(m->multiplier);
    *s = 0;
  } else {
    march_shear(m, body, *s);
    *s = -*s;
    m->departure[body] = SCALLOP_FROM_ZERO;
  }
  march_take_down(m);
  return true;
}

static void release(struct scallop_march *m, int side, enum scallop_departure departure)
{
  int body = the_stuck(m);
  march_settle(m);
  m->s[body] = side;
  m->departure[0] = m->departure[1] = SCALLOP_APART;
  m->departure[body] = (int)departure;
  march_take_down(m);
}

/* Whether the stuck body is held where a piece begins; released if not. */
static bool hold(struct scallop_march *m)
{
  int body = the_stuck(m);
  for (int side = -1; side <= 1; side += 2) {
    enum hold held = march_hold_against(m, body, side);
    if (held == UNDECIDED)
      return undecided(m, at_limit[body]); /* GCOVR_EXCL_LINE: the piece before is undecided first, unless l'' jumps */
    if (held == PULLED) {
      release(m, side, SCALLOP_FROM_ZERO);
      return true;
    }
  }
  return true;
}

/* Both bodies at rest while l' leaves 0: the body with more friction is held, or they part. Equal ones always part. The
 * multiplier from the right: the rear body would have moved forward, and has turned or been caught. */
static bool start_from_rest(struct scallop_march *m)
{
  int stronger = fmpq_cmp(m->forces->friction[0], m->forces->friction[1]) > 0 ? 0 : 1;
  bool equal = fmpq_equal(m->forces->friction[0], m->forces->friction[1]);
  int turning = m->piece->direction > 0 ? 0 : 1;
  m->s[0] = -m->piece->direction;
  m->s[1] = m->piece->direction;
  enum hold held = equal ? PULLED : march_hold_against(m, stronger, m->s[stronger]);
  if (held == UNDECIDED)
    return undecided(m, at_limit[stronger]);
  m->departure[0] = m->departure[1] = SCALLOP_FROM_ZERO;
  if (held == PULLED)
    march_shear(m, turning, 1);
  else {
    m->s[stronger] = 0;
    arb_zero(m->multiplier);
  }
  march_take_down(m);
  return true;
}

static bool set_directions(struct scallop_march *m)
{
  int s1 = arb_sgn_nonzero(m->v[0]), s2 = arb_sgn_nonzero(m->v[1]);
  if (s1 == 0 || s2 == 0)
    return undecided(m, "a velocity cannot be told from 0 where a phase or a piece of the gait begins");
  m->s[0] = s1;
  m->s[1] = s2;
  march_take_down(m);
  return true;
}

static bool is_at_rest(const struct scallop_march *m) { return arb_is_zero(m->v[0]) && arb_is_zero(m->v[1]); }

/* A dwell begins: the bodies are one while it lasts. From the right: at rest they would have been moving, and come to
 * rest. */
static bool begin_dwell(struct scallop_march *m)
{
  if (!is_at_rest(m))
    return set_directions(m);
  m->s[0] = m->s[1] = 0;
  arb_zero(m->multiplier);
  march_take_down(m);
  return true;
}

/* l' jumps, and the velocities with it. */
static bool jump(struct scallop_march *m)
{
  SCOPED(arb, rate);
  scallop_enclose_gait(rate, m->piece, m->now, 0, m->precision);
  arb_sub(m->rate, rate, m->rate, m->precision);
  arb_addmul(m->v[0], m->share[0], m->rate, m->precision);
  arb_addmul(m->v[1], m->share[1], m->rate, m->precision);
  arb_swap(m->rate, rate);
  return m->piece->direction == 0 ? begin_dwell(m) : set_directions(m);
}

/* Whether l'' is constant over the piece and rational; bend is l'' then. */
static bool is_even(fmpq_t bend, const struct scallop_piece *piece)
{
  SCOPED(fmpq_poly, law);
  fmpq_zero(bend);
  bool even = scallop_rational_speed_series(law, piece, bend, WORD_MAX, NULL) && fmpq_poly_degree(law) <= 1;
  if (even) {
    fmpq_poly_get_coeff_fmpq(bend, law, 1);
    fmpq_mul_si(bend, bend, piece->direction);
  }
  return even;
}

/* Returns whether l' is exactly 0 at the beginning of the piece. False if l' is not rational: its zeros are then the
 * ends of phases. */
static bool begins_at_zero(const struct scallop_piece *piece)
{
  SCOPED(fmpq, u);
  SCOPED(fmpq_poly, speed);
  scallop_rational_begin(u, piece);
  return scallop_rational_speed_series(speed, piece, u, 1, NULL) && fmpq_poly_is_zero(speed);
}

/* l' is 0 now and both bodies are at rest, without having turned back. From the right: the rear one would have done so
 * just before, or would have been caught. */
static bool turn_back(struct scallop_march *m)
{
  int turning = m->piece->direction > 0 ? 0 : 1;
  if (is_stuck(m) || m->s[turning] > 0)
    return true;
  enum hold held = march_hold_against(m, turning, 1);
  if (held == UNDECIDED)
    return undecided(m, at_limit[turning]); /* GCOVR_EXCL_LINE: l'' at the end is exact for every gait of the tests */
  if (held == PULLED)
    march_shear(m, turning, -1);
  else
    arb_zero(m->multiplier);
  return true;
}

static void set_piece(struct scallop_march *m, const struct scallop_piece *piece)
{
  m->piece = piece;
  m->even = is_even(m->bend, piece);
  m->departure[0] = m->departure[1] = SCALLOP_APART;
}

/* Passes to the next piece over a zero of l': bodies that do not both continue in one direction come to rest. */
static bool pass_zero(struct scallop_march *m, const struct scallop_piece *next)
{
  SCOPED(arb, rate);
  march_settle_at(m, rate);
  bool alike = m->s[0] == m->s[1] && m->s[0] != 0;
  bool decided = alike || is_at_rest(m) || undecided(m, at_end[arb_is_zero(m->v[0]) ? 1 : 0]);
  decided = decided && (alike || m->piece->direction == 0 || turn_back(m));
  set_piece(m, next);
  return decided && (next->direction == 0 ? begin_dwell(m) : alike || start_from_rest(m));
}

/* Where a piece begins. march_settle() looks at m->piece: the piece before must have been settled if l' jumps. */
static bool enter(struct scallop_march *m, const struct scallop_piece *piece, bool first)
{
  bool turns = !first && piece->direction != m->piece->direction, apart = m->s[0] != m->s[1] || is_stuck(m);
  if (!first && !piece->jump && (turns || piece->direction == 0 || (apart && begins_at_zero(piece))))
    return pass_zero(m, piece);
  if (piece->jump && !first)
    march_settle(m);
  set_piece(m, piece);
  if (piece->jump)
    return jump(m);
  if (piece->direction == 0)
    return begin_dwell(m);
  if (first)
    return is_at_rest(m) ? start_from_rest(m) : set_directions(m);
  return !is_stuck(m) || hold(m);
}

/* v_body while both bodies slide. */
static void set_velocity_track(struct scallop_track *f, struct scallop_march *m, int body)
{
  f->order = 0;
  march_friction_sum(f->slope, m, -m->s[0], -m->s[1]);
  arb_set(f->factor, m->share[body]);
  arb_set(f->constant, m->v[body]);
  arb_submul(f->constant, m->share[body], m->rate, m->precision);
  arb_submul(f->constant, f->slope, m->since, m->precision);
}

/* Sets f to the friction that is left before the stuck body is pulled away in direction side: F_i - side (share_i l'' -
 * F_j s_j) */
static void set_margin_track(struct scallop_track *f, struct scallop_march *m, int side)
{
  int body = the_stuck(m);
  f->order = 1;
  arb_zero(f->slope);
  arb_mul_si(f->factor, m->share[body], -side, m->precision);
  march_friction_sum(f->constant, m, body == 0 ? 1 : side * m->s[0], body == 0 ? side * m->s[1] : 1);
}

/* Finds the earlier of the first zeros of two tracks: its number and time, or -1. Returns false if not decided. Each
 * track is searched only before the zero of the other: a later zero need not be decided. */
static bool earlier(struct scallop_march *m, struct scallop_track *const f[2], const int *signs, const arb_t end,
                    arb_t when, int *which)
{
  enum scallop_found found[2] = { SCALLOP_GRAZES, SCALLOP_GRAZES };
  SCOPED(arb, until);
  arb_set(until, end);
  *which = -1;
  for (int pass = 0; pass < 3; pass++) {
    int i = pass % 2;
    if (pass == 2 && (found[0] == SCALLOP_NONE || found[0] == SCALLOP_CROSSES || found[1] != SCALLOP_CROSSES))
      break;
    struct scallop_stretch stretch = { m->now, until, signs[i], (enum scallop_departure)m->departure[i] };
    if (is_stuck(m))
      stretch.departure = SCALLOP_APART;
    found[i] = scallop_first_zero(when, f[i], &stretch, m->precision);
    if (found[i] == SCALLOP_CROSSES) {
      arb_set(until, when);
      *which = i;
    }
  }
  arb_set(when, until);
  bool stopped = *which >= 0 && !arb_lt(when, end);
  for (int i = 0; i < 2; i++)
    if (found[i] == SCALLOP_GRAZES || found[i] == SCALLOP_AT_END || (stopped && *which == i)) {
      int body = is_stuck(m) ? the_stuck(m) : i;
      return undecided(m, is_stuck(m) ? at_limit[body] : found[i] == SCALLOP_GRAZES ? grazing[body] : at_end[body]);
    }
  return true;
}

static bool next_change(struct scallop_march *m, const arb_t end, arb_t when, int *which)
{
  *which = -1;
  if (is_stuck(m) && m->even) /* what holds it is constant */
    return true;
  SCOPED(scallop_track, one, other);
  struct scallop_track *const f[2] = { &one, &other };
  int signs[2] = { 1, 1 };
  for (int i = 0; i < 2; i++) {
    f[i]->piece = m->piece;
    if (is_stuck(m))
      set_margin_track(f[i], m, i == 0 ? -1 : 1);
    else {
      set_velocity_track(f[i], m, i);
      signs[i] = m->s[i];
    }
  }
  return earlier(m, f, signs, end, when, which);
}

/* While l' stays 0: v' = -s (F1 + F2) until both are at rest, if they move at all. */
static bool march_dwell(struct scallop_march *m, const arb_t end)
{
  SCOPED(arb, stop, drag);
  bool decided = true;
  if (m->s[0] != 0) {
    march_friction_sum(drag, m, m->s[0], m->s[1]);
    decided = arb_intersection(stop, m->v[0], m->v[1], m->precision);
    arb_div(stop, stop, drag, m->precision);
    arb_add(stop, m->now, stop, m->precision);
    if (decided && arb_lt(stop, end)) {
      march_advance(m, stop);
      march_settle(m);
      arb_zero(m->v[0]);
      arb_zero(m->v[1]);
      m->s[0] = m->s[1] = 0;
      arb_zero(m->multiplier);
      march_take_down(m);
    } else
      decided = decided
                && (arb_gt(stop, end) || undecided(m, "both bodies come to rest just as a dwell ends, or almost"));
  }
  if (decided)
    march_advance(m, end);
  return decided;
}

static bool march_piece(struct scallop_march *m)
{
  SCOPED(arb, end, when);
  scallop_enclose_end(end, m->piece, m->precision);
  bool moves = m->piece->direction != 0, decided = moves || march_dwell(m, end);
  int which = moves ? 0 : -1;
  while (decided && which >= 0) {
    decided = next_change(m, end, when, &which);
    if (decided)
      march_advance(m, which >= 0 ? when : end);
    if (decided && which >= 0 && is_stuck(m))
      release(m, which == 0 ? -1 : 1, SCALLOP_FROM_ZERO_FLAT);
    else if (decided && which >= 0)
      decided = turn(m, which);
  }
  return decided;
}

/* The amplitude is 1: so l has gained exactly that, and both bodies must agree on the velocity that they have in
 * common. */
static bool finish(struct scallop_march *m)
{
  SCOPED(arb, t, left, right);
  const arb_ptr v_end[2] = { left, right };
  int gained = m->forces->kind == SCALLOP_EXTENSION ? 1 : -1;
  slong p = m->precision;
  arb_add(t, m->l_since, m->l_now, p);
  bool agrees = arb_contains_si(t, gained);
  arb_sub_si(t, m->l_since, gained, p);
  arb_neg(m->l_now, t);
  march_settle(m);
  for (int i = 0; i < 2; i++) {
    arb_mul(v_end[i], m->share[i], m->rate, p);
    arb_sub(v_end[i], m->v[i], v_end[i], p);
  }
  if (!agrees || !arb_intersection(m->v_end, left, right, p))
    return undecided(m, "the law of the gait contradicts its amplitude, or the bodies each other: a defect");
  bool rests = arb_is_zero(m->v_end) && arb_contains_zero(m->rate);
  return m->piece->direction == 0 || !rests || turn_back(m);
}

bool scallop_march_phase(struct scallop_march *m, const struct scallop_forces *forces, const arb_t v0, slong precision)
{
  const struct scallop_shape *shape = &forces->exact.gait.phase[forces->kind];
  march_reset(m, forces, v0, precision);
  for (int i = 0; i < shape->count; i++)
    if (!enter(m, &shape->pieces[i], i == 0) || !march_piece(m))
      return false;
  return finish(m);
}
