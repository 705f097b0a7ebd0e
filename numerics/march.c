#include "numerics/march.h"

#include <string.h>

#include "numerics/enclose.h"

static const char *const grazing[] = { "body 1 touches zero velocity without turning, or almost: grazing",
                                       "body 2 touches zero velocity without turning, or almost: grazing" };
static const char *const at_end[] = { "body 1 comes to rest just as a piece of the gait ends, or as body 2 does",
                                      "body 2 comes to rest just as a piece of the gait ends, or as body 1 does" };
static const char *const at_limit[] = { "the force that holds body 1 is exactly at its limit, or almost",
                                        "the force that holds body 2 is exactly at its limit, or almost" };

void scallop_forces_init(struct scallop_forces *forces)
{
  scallop_exact_init(&forces->exact);
  for (int i = 0; i < 2; i++) {
    fmpq_init(forces->share[i]);
    fmpq_init(forces->friction[i]);
  }
}

void scallop_forces_clear(struct scallop_forces *forces)
{
  scallop_exact_clear(&forces->exact);
  for (int i = 0; i < 2; i++) {
    fmpq_clear(forces->share[i]);
    fmpq_clear(forces->friction[i]);
  }
}

void scallop_forces_of(struct scallop_forces *forces, const struct scallop_rational_crawler *c, enum scallop_phase_kind kind)
{
  fmpq_t M, unit;
  fmpq_init(M);
  fmpq_init(unit);
  forces->kind = kind;
  scallop_exact_of(&forces->exact, c->gait);
  fmpq_add(M, c->m1, c->m2);
  fmpq_div(forces->share[0], c->m2, M);
  fmpq_neg(forces->share[0], forces->share[0]);
  fmpq_div(forces->share[1], c->m1, M);
  scallop_rational_duration(unit, c, kind);
  fmpq_mul(unit, unit, unit);
  fmpq_div(unit, unit, M);
  fmpq_div(unit, unit, c->L);
  fmpq_mul(forces->friction[0], c->F1, unit);
  fmpq_mul(forces->friction[1], c->F2, unit);
  fmpq_clear(M);
  fmpq_clear(unit);
}

enum { BALLS = 19 };
static arb_ptr ball(struct scallop_march *m, int i)
{
  arb_ptr all[BALLS] = { m->now,     m->since,      m->rate,   m->v1,     m->v2,    m->x1,   m->x2,
                         m->l_since, m->l_now,      m->share1, m->share2, m->first, m->last, m->at_first,
                         m->at_last, m->multiplier, m->v_end,  m->path1,  m->path2 };
  return all[i];
}

void scallop_march_init(struct scallop_march *m)
{
  for (int i = 0; i < BALLS; i++)
    arb_init(ball(m, i));
  fmpq_init(m->bend);
}

void scallop_march_clear(struct scallop_march *m)
{
  for (int i = 0; i < BALLS; i++)
    arb_clear(ball(m, i));
  fmpq_clear(m->bend);
}

static void reset(struct scallop_march *m, const struct scallop_forces *forces, const arb_t v0, slong precision)
{
  for (int i = 0; i < BALLS; i++)
    arb_zero(ball(m, i));
  m->forces = forces;
  m->precision = precision;
  arb_set(m->v1, v0);
  arb_set(m->v2, v0);
  arb_one(m->multiplier);
  arb_set_fmpq(m->share1, forces->share[0], precision);
  arb_set_fmpq(m->share2, forces->share[1], precision);
  m->s1 = m->s2 = 0;
  m->departure[0] = m->departure[1] = SCALLOP_APART;
  m->switches = m->sticks = m->moves[0] = m->moves[1] = false;
  memset(&m->modes, 0, sizeof m->modes);
  m->why = NULL;
}

static arb_ptr velocity(struct scallop_march *m, int body) { return body == 0 ? m->v1 : m->v2; }
static arb_ptr position(struct scallop_march *m, int body) { return body == 0 ? m->x1 : m->x2; }
static arb_ptr share(struct scallop_march *m, int body) { return body == 0 ? m->share1 : m->share2; }
static int *direction(struct scallop_march *m, int body) { return body == 0 ? &m->s1 : &m->s2; }
static bool is_stuck(const struct scallop_march *m) { return m->s1 == 0 || m->s2 == 0; }
static int the_stuck(const struct scallop_march *m) { return m->s1 == 0 ? 0 : 1; }
static int rear(const struct scallop_march *m) { return m->forces->kind == SCALLOP_EXTENSION ? 0 : 1; }

static bool undecided(struct scallop_march *m, const char *why)
{
  m->why = why;
  return false;
}

/* Forces are accelerations here, those of equal masses M. */

/* n1 F1 + n2 F2 */
static void friction(fmpq_t sum, const struct scallop_march *m, int n1, int n2)
{
  fmpq_t term;
  fmpq_init(term);
  fmpq_mul_si(sum, m->forces->friction[0], n1);
  fmpq_mul_si(term, m->forces->friction[1], n2);
  fmpq_add(sum, sum, term);
  fmpq_clear(term);
}

/* The same, rounded once: exactly 0 where it is. */
static void friction_sum(arb_t sum, const struct scallop_march *m, int n1, int n2)
{
  fmpq_t exact;
  fmpq_init(exact);
  friction(exact, m, n1, n2);
  arb_set_fmpq(sum, exact, m->precision);
  fmpq_clear(exact);
}

/* x_body'' now if it goes in direction s and the other body as it goes; where l'' is even, rounded once. */
static void acceleration(arb_t value, struct scallop_march *m, int body, int s)
{
  fmpq_t drag, exact;
  fmpq_init(drag);
  fmpq_init(exact);
  friction(drag, m, body == 0 ? s : m->s1, body == 0 ? m->s2 : s);
  if (m->even) {
    fmpq_mul(exact, m->forces->share[body], m->bend);
    fmpq_sub(exact, exact, drag);
    arb_set_fmpq(value, exact, m->precision);
  } else {
    arb_t force;
    arb_init(force);
    scallop_enclose_gait(value, m->piece, m->now, 1, m->precision);
    arb_mul(value, value, share(m, body), m->precision);
    arb_set_fmpq(force, drag, m->precision);
    arb_sub(value, value, force, m->precision);
    arb_clear(force);
  }
  fmpq_clear(drag);
  fmpq_clear(exact);
}

/* What becomes of a body at rest that would go in direction side. A force exactly at its limit holds it as long as it is there. */
enum hold { HELD, PULLED, UNDECIDED };
static enum hold hold_against(struct scallop_march *m, int body, int side)
{
  arb_t value;
  arb_init(value);
  acceleration(value, m, body, side);
  int sign = arb_sgn_nonzero(value);
  bool at_its_limit = m->even && arb_is_zero(value);
  arb_clear(value);
  return sign == side ? PULLED : sign == -side || at_its_limit ? HELD : UNDECIDED;
}

/* A body turned from direction s: the flow is sheared by the ratio of its accelerations after and before. */
static void shear(struct scallop_march *m, int body, int s)
{
  arb_t before, after;
  arb_init(before);
  arb_init(after);
  acceleration(before, m, body, s);
  acceleration(after, m, body, -s);
  arb_div(after, after, before, m->precision);
  arb_mul(m->multiplier, m->multiplier, after, m->precision);
  arb_clear(before);
  arb_clear(after);
}

static void advance(struct scallop_march *m, const arb_t to)
{
  arb_ptr t = _arb_vec_init(3);
  arb_set(t, m->now);
  arb_set(t + 1, to);
  for (int i = 0; m->piece->anchor == SCALLOP_FROM_END && i < 2; i++) {
    arb_sub_ui(t + i, t + i, 1, m->precision);
    arb_neg(t + i, t + i);
  }
  scallop_ball_way(t + 2, m->piece, t, t + 1, m->precision);
  arb_mul_si(t + 2, t + 2, m->piece->direction, m->precision);
  arb_add(m->l_now, m->l_now, t + 2, m->precision);
  arb_set(m->now, to);
  _arb_vec_clear(t, 3);
}

/* v += share (l' - rate) - drag h, x += v h + share (l gained - rate h) - drag h^2/2 */
static void slide(struct scallop_march *m, int body, const arb_t rate, const arb_t h, const arb_t drag)
{
  arb_ptr t = _arb_vec_init(2), v = velocity(m, body), x = position(m, body);
  slong p = m->precision;
  arb_mul(t, m->rate, h, p);
  arb_sub(t, m->l_now, t, p);
  arb_addmul(x, t, share(m, body), p);
  arb_mul_2exp_si(t, h, -1);
  arb_mul(t, t, drag, p);
  arb_sub(t, v, t, p);
  arb_addmul(x, t, h, p);
  arb_sub(t, rate, m->rate, p);
  arb_addmul(v, t, share(m, body), p);
  arb_submul(v, drag, h, p);
  _arb_vec_clear(t, 2);
}

/* Body at rest exactly; so the other one has all of l'. */
static void rest(struct scallop_march *m, int body)
{
  arb_zero(velocity(m, body));
  arb_mul_si(velocity(m, 1 - body), m->rate, body == 0 ? 1 : -1, m->precision);
}

/* The bodies have come from x1 and x2 to where they are, in the directions of the mode. Overwrites x1 and x2. */
static void add_paths(struct scallop_march *m, arb_t x1, arb_t x2)
{
  arb_sub(x1, m->x1, x1, m->precision);
  arb_sub(x2, m->x2, x2, m->precision);
  arb_addmul_si(m->path1, x1, m->s1, m->precision);
  arb_addmul_si(m->path2, x2, m->s2, m->precision);
}

/* Brings velocities and positions up to date, where l' is rate now. */
static void settle_at(struct scallop_march *m, const arb_t rate)
{
  arb_ptr t = _arb_vec_init(4), h = t, drag = t + 1, x1 = t + 2, x2 = t + 3;
  slong p = m->precision;
  arb_set(x1, m->x1);
  arb_set(x2, m->x2);
  if (is_stuck(m)) {
    int body = the_stuck(m);
    (body == 0 ? arb_add : arb_sub)(position(m, 1 - body), position(m, 1 - body), m->l_now, p);
    arb_set(m->rate, rate);
    rest(m, body);
  } else {
    arb_sub(h, m->now, m->since, p);
    friction_sum(drag, m, m->s1, m->s2);
    slide(m, 0, rate, h, drag);
    slide(m, 1, rate, h, drag);
    arb_set(m->rate, rate);
  }
  add_paths(m, x1, x2);
  arb_set(m->since, m->now);
  arb_add(m->l_since, m->l_since, m->l_now, p);
  arb_zero(m->l_now);
  _arb_vec_clear(t, 4);
}

static void settle(struct scallop_march *m)
{
  arb_t rate;
  arb_init(rate);
  scallop_enclose_gait(rate, m->piece, m->now, 0, m->precision);
  settle_at(m, rate);
  arb_clear(rate);
}

/* Takes down the mode, if it is another one than before. Only after settling. */
static void take_down(struct scallop_march *m)
{
  struct scallop_mode mode = { (signed char)m->s1, (signed char)m->s2 };
  struct scallop_modes *modes = &m->modes;
  struct scallop_mode *last = &modes->kept[FLINT_MAX(FLINT_MIN(modes->count, SCALLOP_MODES_KEPT) - 1, 0)];
  if (modes->count > 0 && last->s1 == mode.s1 && last->s2 == mode.s2)
    return;
  last += modes->count > 0 && modes->count < SCALLOP_MODES_KEPT; /* the last place holds the last mode */
  *last = mode;
  modes->count++;
  m->sticks = m->sticks || is_stuck(m);
  m->moves[0] = m->moves[0] || m->s1 != 0;
  m->moves[1] = m->moves[1] || m->s2 != 0;
  if (modes->count == 1)
    return;
  if (!m->switches) {
    arb_set(m->first, m->now);
    arb_set(m->at_first, position(m, rear(m)));
  }
  m->switches = true;
  arb_set(m->last, m->now);
  arb_set(m->at_last, position(m, rear(m)));
}

/* The velocity of a body has come to 0 across it: does it go on, or can friction hold it? */
static bool turn(struct scallop_march *m, int body)
{
  int *s = direction(m, body);
  settle(m);
  rest(m, body);
  enum hold beyond = hold_against(m, body, -*s);
  if (beyond == UNDECIDED)
    return undecided(m, at_limit[body]);
  m->departure[0] = m->departure[1] = SCALLOP_APART;
  if (beyond == HELD) {
    arb_zero(m->multiplier);
    *s = 0;
  } else {
    shear(m, body, *s);
    *s = -*s;
    m->departure[body] = SCALLOP_FROM_ZERO;
  }
  take_down(m);
  return true;
}

static void release(struct scallop_march *m, int side, enum scallop_departure departure)
{
  int body = the_stuck(m);
  settle(m);
  *direction(m, body) = side;
  m->departure[0] = m->departure[1] = SCALLOP_APART;
  m->departure[body] = (int)departure;
  take_down(m);
}

/* Whether the stuck body is held where a piece begins; released if not. */
static bool hold(struct scallop_march *m)
{
  int body = the_stuck(m);
  for (int side = -1; side <= 1; side += 2) {
    enum hold held = hold_against(m, body, side);
    if (held == UNDECIDED)
      return undecided(m, at_limit[body]); /* GCOVR_EXCL_LINE: the piece before says so first, unless l'' jumps */
    if (held == PULLED) {
      release(m, side, SCALLOP_FROM_ZERO);
      return true;
    }
  }
  return true;
}

/* Both bodies at rest while l' leaves 0: the one with more friction is held, or else they part. Equal ones always part.
 * The multiplier from the right: the rear body would have been going forward, and has turned or has been caught. */
static bool start_from_rest(struct scallop_march *m)
{
  int stronger = fmpq_cmp(m->forces->friction[0], m->forces->friction[1]) > 0 ? 0 : 1;
  bool equal = fmpq_equal(m->forces->friction[0], m->forces->friction[1]);
  int turning = m->piece->direction > 0 ? 0 : 1;
  m->s1 = -m->piece->direction;
  m->s2 = m->piece->direction;
  enum hold held = equal ? PULLED : hold_against(m, stronger, *direction(m, stronger));
  if (held == UNDECIDED)
    return undecided(m, at_limit[stronger]);
  m->departure[0] = m->departure[1] = SCALLOP_FROM_ZERO;
  if (held == PULLED)
    shear(m, turning, 1);
  else {
    *direction(m, stronger) = 0;
    arb_zero(m->multiplier);
  }
  take_down(m);
  return true;
}

static bool set_directions(struct scallop_march *m)
{
  int s1 = arb_sgn_nonzero(m->v1), s2 = arb_sgn_nonzero(m->v2);
  if (s1 == 0 || s2 == 0)
    return undecided(m, "a velocity cannot be told from 0 where a phase or a piece of the gait begins");
  m->s1 = s1;
  m->s2 = s2;
  take_down(m);
  return true;
}

static bool is_at_rest(const struct scallop_march *m) { return arb_is_zero(m->v1) && arb_is_zero(m->v2); }

/* A dwell begins: the bodies are one while it lasts. From the right: at rest they would have been moving, and come to rest. */
static bool begin_dwell(struct scallop_march *m)
{
  if (!is_at_rest(m))
    return set_directions(m);
  m->s1 = m->s2 = 0;
  arb_zero(m->multiplier);
  take_down(m);
  return true;
}

/* l' jumps, and the velocities with it. */
static bool jump(struct scallop_march *m)
{
  arb_t rate;
  arb_init(rate);
  scallop_enclose_gait(rate, m->piece, m->now, 0, m->precision);
  arb_sub(m->rate, rate, m->rate, m->precision);
  arb_addmul(m->v1, m->share1, m->rate, m->precision);
  arb_addmul(m->v2, m->share2, m->rate, m->precision);
  arb_swap(m->rate, rate);
  arb_clear(rate);
  return m->piece->direction == 0 ? begin_dwell(m) : set_directions(m);
}

/* Whether l'' is constant over the piece and rational; bend is l'' then. */
static bool is_even(fmpq_t bend, const struct scallop_piece *piece)
{
  fmpq_poly_t law;
  fmpq_poly_init(law);
  fmpq_zero(bend);
  bool even = scallop_rational_speed_series(law, piece, bend, WORD_MAX, NULL) && fmpq_poly_degree(law) <= 1;
  if (even) {
    fmpq_poly_get_coeff_fmpq(bend, law, 1);
    fmpq_mul_si(bend, bend, piece->direction);
  }
  fmpq_poly_clear(law);
  return even;
}

/* Whether l' is 0 where the piece begins, exactly. Where l' is not rational it is taken not to be: there its zeros are the ends of phases. */
static bool begins_at_zero(const struct scallop_piece *piece)
{
  fmpq_t u;
  fmpq_poly_t speed;
  fmpq_init(u);
  fmpq_poly_init(speed);
  scallop_rational_begin(u, piece);
  bool zero = scallop_rational_speed_series(speed, piece, u, 1, NULL) && fmpq_poly_is_zero(speed);
  fmpq_clear(u);
  fmpq_poly_clear(speed);
  return zero;
}

/* l' is 0 now and both bodies are at rest, without having turned back. From the right: the rear one would have done so just before, or would
 * have been caught. */
static bool turn_back(struct scallop_march *m)
{
  int turning = m->piece->direction > 0 ? 0 : 1;
  if (is_stuck(m) || *direction(m, turning) > 0)
    return true;
  enum hold held = hold_against(m, turning, 1);
  if (held == UNDECIDED)
    return undecided(m, at_limit[turning]); /* GCOVR_EXCL_LINE: l'' at the end is exact for every gait of the tests */
  if (held == PULLED)
    shear(m, turning, -1);
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

/* From a piece to the next one where l' is 0 in between: what does not go on in one direction comes to rest. */
static bool pass_zero(struct scallop_march *m, const struct scallop_piece *next)
{
  arb_t rate;
  arb_init(rate);
  settle_at(m, rate);
  arb_clear(rate);
  bool alike = m->s1 == m->s2 && m->s1 != 0;
  bool decided = alike || is_at_rest(m) || undecided(m, at_end[arb_is_zero(m->v1) ? 1 : 0]);
  decided = decided && (alike || m->piece->direction == 0 || turn_back(m));
  set_piece(m, next);
  return decided && (next->direction == 0 ? begin_dwell(m) : alike || start_from_rest(m));
}

/* Where a piece begins. settle() looks at m->piece: the piece before must have been settled if l' jumps. */
static bool enter(struct scallop_march *m, const struct scallop_piece *piece, bool first)
{
  bool turns = !first && piece->direction != m->piece->direction, apart = m->s1 != m->s2 || is_stuck(m);
  if (!first && !piece->jump && (turns || piece->direction == 0 || (apart && begins_at_zero(piece))))
    return pass_zero(m, piece);
  if (piece->jump && !first)
    settle(m);
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
  friction_sum(f->slope, m, -m->s1, -m->s2);
  arb_set(f->factor, share(m, body));
  arb_set(f->constant, velocity(m, body));
  arb_submul(f->constant, share(m, body), m->rate, m->precision);
  arb_submul(f->constant, f->slope, m->since, m->precision);
}

/* What is left of its friction before the stuck body is pulled away in direction side: F_i - side (share_i l'' - F_j s_j) */
static void set_margin_track(struct scallop_track *f, struct scallop_march *m, int side)
{
  int body = the_stuck(m);
  f->order = 1;
  arb_zero(f->slope);
  arb_mul_si(f->factor, share(m, body), -side, m->precision);
  friction_sum(f->constant, m, body == 0 ? 1 : side * m->s1, body == 0 ? side * m->s2 : 1);
}

/* The earlier of the first zeros of two tracks: its number and when, or -1; false if not decided. Each is asked about the time
 * before the zero of the other only, so that one which comes later need not be decided. */
static bool earlier(struct scallop_march *m, const struct scallop_track *f, const int *signs, const arb_t end, arb_t when,
                    int *which)
{
  enum scallop_found found[2] = { SCALLOP_GRAZES, SCALLOP_GRAZES };
  arb_t until;
  arb_init(until);
  arb_set(until, end);
  *which = -1;
  for (int pass = 0; pass < 3; pass++) {
    int i = pass % 2;
    if (pass == 2 && (found[0] == SCALLOP_NONE || found[0] == SCALLOP_CROSSES || found[1] != SCALLOP_CROSSES))
      break;
    struct scallop_stretch stretch = { m->now, until, signs[i], (enum scallop_departure)m->departure[i] };
    if (is_stuck(m))
      stretch.departure = SCALLOP_APART;
    found[i] = scallop_first_zero(when, &f[i], &stretch, m->precision);
    if (found[i] == SCALLOP_CROSSES) {
      arb_set(until, when);
      *which = i;
    }
  }
  arb_set(when, until);
  bool stopped = *which >= 0 && !arb_lt(when, end);
  arb_clear(until);
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
  struct scallop_track f[2];
  int signs[2] = { 1, 1 };
  for (int i = 0; i < 2; i++) {
    scallop_track_init(&f[i]);
    f[i].piece = m->piece;
    if (is_stuck(m))
      set_margin_track(&f[i], m, i == 0 ? -1 : 1);
    else {
      set_velocity_track(&f[i], m, i);
      signs[i] = *direction(m, i);
    }
  }
  bool decided = earlier(m, f, signs, end, when, which);
  scallop_track_clear(&f[0]);
  scallop_track_clear(&f[1]);
  return decided;
}

/* While l' stays 0: v' = -s (F1 + F2) until both are at rest, if they move at all. */
static bool march_dwell(struct scallop_march *m, const arb_t end)
{
  arb_t stop, drag;
  arb_init(stop);
  arb_init(drag);
  bool decided = true;
  if (m->s1 != 0) {
    friction_sum(drag, m, m->s1, m->s2);
    decided = arb_intersection(stop, m->v1, m->v2, m->precision);
    arb_div(stop, stop, drag, m->precision);
    arb_add(stop, m->now, stop, m->precision);
    if (decided && arb_lt(stop, end)) {
      advance(m, stop);
      settle(m);
      arb_zero(m->v1);
      arb_zero(m->v2);
      m->s1 = m->s2 = 0;
      arb_zero(m->multiplier);
      take_down(m);
    } else
      decided = decided && (arb_gt(stop, end) || undecided(m, "both bodies come to rest just as a dwell ends, or almost"));
  }
  if (decided)
    advance(m, end);
  arb_clear(stop);
  arb_clear(drag);
  return decided;
}

static bool march_piece(struct scallop_march *m)
{
  arb_t end, when;
  arb_init(end);
  arb_init(when);
  scallop_enclose_end(end, m->piece, m->precision);
  bool moves = m->piece->direction != 0, decided = moves || march_dwell(m, end);
  int which = moves ? 0 : -1;
  while (decided && which >= 0) {
    decided = next_change(m, end, when, &which);
    if (decided)
      advance(m, which >= 0 ? when : end);
    if (decided && which >= 0 && is_stuck(m))
      release(m, which == 0 ? -1 : 1, SCALLOP_FROM_ZERO_FLAT);
    else if (decided && which >= 0)
      decided = turn(m, which);
  }
  arb_clear(end);
  arb_clear(when);
  return decided;
}

/* The amplitude is 1: so l has gained exactly that, and both bodies must agree on the velocity that they have in common. */
static bool finish(struct scallop_march *m)
{
  arb_ptr t = _arb_vec_init(2);
  int gained = m->forces->kind == SCALLOP_EXTENSION ? 1 : -1;
  slong p = m->precision;
  arb_add(t, m->l_since, m->l_now, p);
  bool right = arb_contains_si(t, gained);
  arb_sub_si(t, m->l_since, gained, p);
  arb_neg(m->l_now, t);
  settle(m);
  for (int i = 0; i < 2; i++) {
    arb_mul(t + i, share(m, i), m->rate, p);
    arb_sub(t + i, velocity(m, i), t + i, p);
  }
  right = right && arb_intersection(m->v_end, t, t + 1, p);
  _arb_vec_clear(t, 2);
  if (!right)
    return undecided(m, "the law of the gait contradicts its amplitude, or the bodies each other: a defect");
  return m->piece->direction == 0 || !arb_is_zero(m->v_end) || turn_back(m);
}

bool scallop_march_phase(struct scallop_march *m, const struct scallop_forces *forces, const arb_t v0, slong precision)
{
  const struct scallop_shape *shape = &forces->exact.gait.phase[forces->kind];
  reset(m, forces, v0, precision);
  for (int i = 0; i < shape->count; i++)
    if (!enter(m, &shape->pieces[i], i == 0) || !march_piece(m))
      return false;
  return finish(m);
}
