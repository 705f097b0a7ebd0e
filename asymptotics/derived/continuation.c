/* The equations of a branch at complex z, their derivatives, and Newton's method for them. */
#include "asymptotics/derived/continuation.h"

#include "asymptotics/derived/scoped.h"

/* Sets the law of a crossing. before: the preceding crossing, of to[-1], for a joined equation; or NULL. */
static void set_law(struct continued_crossing *to, const struct crossing *at, const struct crossing *before,
                    slong precision)
{
  const struct scallop_piece *piece = at->piece;
  bool turned;
  to->sine = piece->law && piece->law->kind == SCALLOP_LAW_SINE;
  to->joined = before && before->curve == at->curve && scallop_piece_continues(before->piece, piece, &turned);
  arb_init(to->base);
  arb_poly_init(to->law);
  if (to->joined) { /* exactly the same function */
    arb_set(to->base, to[-1].base);
    arb_poly_set(to->law, to[-1].law);
  }
  if (to->joined || to->sine)
    return;
  SCOPED(arb, u);
  series_coefficient(u, &at->offset, 0, precision);
  mag_zero(arb_radref(u));
  slong degree = piece->law && piece->law->degree > 1 ? piece->law->degree : 1;
  scallop_ball_speed_series(to->law, piece, u, degree + 1, precision);
  time_of_offset(to->base, piece, u, precision);
}

static void set_entry(acb_mat_t matrix, slong row, slong column, const fmpq_t value, slong precision)
{
  acb_set_fmpq(acb_mat_entry(matrix, row, column), value, precision);
}

/* Adds the product a b to an entry. */
static void add_entry(acb_mat_t matrix, slong row, slong column, const fmpq_t a, const fmpq_t b, slong precision)
{
  SCOPED(fmpq, product);
  SCOPED(acb, ball);
  fmpq_mul(product, a, b);
  acb_set_fmpq(ball, product, precision);
  acb_add(acb_mat_entry(matrix, row, column), acb_mat_entry(matrix, row, column), ball, precision);
}

/* Adds share times the gain of c over eps, up to crossing `until` of the phase (its count: up to the end), to a row:
 * the drops of the slope times the times of the crossings before, and the slope there times the time of this one (1 at
 * the end). */
static void add_gain(struct continuation *c, acb_mat_t matrix, slong row, const struct branch *b,
                     const struct phase_constants *p, slong first, slong until, const fmpq_t share, slong precision)
{
  SCOPED(fmpq, drop);
  for (slong j = 0; j < until; j++) {
    fmpq_sub(drop, p->beta[branch_region(b, (int)j)], p->beta[b->crossing[j].to]);
    add_entry(matrix, row, 1 + first + j, share, drop, precision);
  }
  slong column = until < b->count ? 1 + first + until : c->n + 1;
  add_entry(matrix, row, column, share, p->beta[branch_region(b, (int)until)], precision);
}

/* Sets the rows of a phase with crossings from `first` on. c starts at fraction times w; continue_steady adds the gain
 * of the first phase to the rows of the second. */
static void add_phase(struct continuation *c, const struct branch *b, const struct phase_constants *p, slong first,
                      slong count, const fmpq_t fraction, bool join, slong precision)
{
  SCOPED(fmpq, square, drop);
  fmpq_mul(square, fraction, fraction);
  for (slong i = 0; i < count; i++) {
    struct continued_crossing *to = &c->crossing[first + i];
    const struct crossing *at = &b->crossing[i];
    arb_init(to->q);
    arb_init(to->drop);
    set_law(to, at, join && i > 0 ? at - 1 : NULL, precision);
    arb_set_fmpq(to->q, p->curve[at->curve], precision);
    fmpq_sub(drop, p->beta[branch_region(b, (int)i)], p->beta[at->to]);
    arb_set_fmpq(to->drop, drop, precision);
    if (to->joined)
      add_entry(c->per_eps, first + i, c->n + 1, square, p->beta[branch_region(b, (int)i)], precision);
    else {
      set_entry(c->fixed, first + i, 0, fraction, precision);
      add_gain(c, c->per_eps, first + i, b, p, first, i, square, precision);
    }
    arb_ptr time = acb_realref(c->start + 1 + first + i);
    series_coefficient(time, &at->offset, 0, precision);
    time_of_offset(time, at->piece, time, precision);
  }
}

/* Starts the equations, with z scaled to make kappa near 1. */
static void begin(struct continuation *c, slong m, slong power, const fmpq_t kappa, slong precision)
{
  c->m = m;
  c->n = m + 1;
  c->power = power;
  arb_init(c->kappa);
  arb_init(c->fraction[0]);
  arb_init(c->fraction[1]);
  arb_set_fmpq(c->kappa, kappa, precision);
  c->scale = -arf_abs_bound_lt_2exp_si(arb_midref(c->kappa)) / power;
  arb_mul_2exp_si(c->kappa, c->kappa, power * c->scale);
  acb_mat_init(c->fixed, c->n, c->n + 2);
  acb_mat_init(c->per_eps, c->n, c->n + 2);
  c->start = _acb_vec_init(c->n + 1);
}

void continue_steady(struct continuation *c, const struct limit *l, const fmpq_t kappa, bool join, slong precision)
{
  const fmpq *f0 = l->phase[0].fraction, *f1 = l->phase[1].fraction;
  slong first = l->branch[0].count;
  SCOPED(fmpq, product);
  begin(c, first + l->branch[1].count, 1, kappa, precision);
  c->first_phase = first;
  series_coefficient(acb_realref(c->start), &l->w, 0, precision);
  fmpq_mul(product, f0, f1);
  for (int k = 0; k < 2; k++) {
    const struct branch *b = &l->branch[k];
    const struct phase_constants *p = &l->phase[k];
    arb_set_fmpq(c->fraction[k], p->fraction, precision);
    add_phase(c, b, p, k * first, b->count, p->fraction, join, precision);
    add_gain(c, c->fixed, c->m, b, p, k * first, b->count, p->fraction, precision); /* the balance */
  }
  for (slong i = first; i < c->m; i++) /* the gain of the first phase */
    if (!c->crossing[i].joined)
      add_gain(c, c->per_eps, i, &l->branch[0], &l->phase[0], 0, first, product, precision);
}

void continue_phase(struct continuation *c, const struct branch *b, const struct phase_constants *p, slong m,
                    const fmpq_t velocity, const fmpq_t kappa, bool join, slong precision)
{
  SCOPED(fmpq, one);
  fmpq_one(one);
  begin(c, m, 2, kappa, precision);
  c->first_phase = m;
  arb_one(c->fraction[0]);
  add_phase(c, b, p, 0, m, one, join, precision);
  set_entry(c->fixed, m, 0, one, precision);
  set_entry(c->fixed, m, c->n, velocity, precision);
  acb_ptr share = acb_mat_entry(c->fixed, m, c->n);
  acb_neg(share, share);
  acb_mul_2exp_si(share, share, c->scale);
}

void continuation_clear(struct continuation *c)
{
  for (slong i = 0; i < c->m; i++) {
    struct continued_crossing *at = &c->crossing[i];
    arb_clear(at->q);
    arb_clear(at->base);
    arb_clear(at->drop);
    arb_poly_clear(at->law);
  }
  arb_clear(c->kappa);
  arb_clear(c->fraction[0]);
  arb_clear(c->fraction[1]);
  acb_mat_clear(c->fixed);
  acb_mat_clear(c->per_eps);
  _acb_vec_clear(c->start, c->n + 1);
}

void continued_eps(acb_t eps, const struct continuation *c, const acb_t z, slong k, slong precision)
{
  if (k > c->power) {
    acb_zero(eps);
    return;
  }
  acb_pow_ui(eps, z, (ulong)(c->power - k), precision);
  acb_mul_arb(eps, eps, c->kappa, precision);
  if (k > 0)
    acb_mul_si(eps, eps, c->power, precision);
}

void continued_row(acb_t sum, const acb_mat_t matrix, slong row, acb_srcptr v, slong last, slong precision)
{
  slong n = acb_mat_ncols(matrix) - 1;
  acb_mul_si(sum, acb_mat_entry(matrix, row, n), last, precision);
  for (slong j = 0; j < n; j++)
    acb_addmul(sum, v + j, acb_mat_entry(matrix, row, j), precision);
}

static void law_at(acb_ptr jet, const struct continuation *c, slong i, acb_srcptr v, slong precision)
{
  continued_law(jet, &c->crossing[i], v + i, v + i + 1, precision);
}

void continued_residual(acb_mat_t f, const struct continuation *c, acb_srcptr v, slong precision)
{
  SCOPED_BALLS(jet, JET);
  SCOPED(acb, eps, term);
  continued_eps(eps, c, v + c->n, 0, precision);
  for (slong i = 0; i < c->n; i++) {
    acb_ptr value = acb_mat_entry(f, i, 0);
    continued_row(value, c->fixed, i, v, 1, precision);
    continued_row(term, c->per_eps, i, v, 1, precision);
    acb_addmul(value, term, eps, precision);
    acb_neg(value, value);
    if (i < c->m) {
      law_at(jet, c, i, v, precision);
      acb_add(value, value, jet + JET_VALUE, precision);
    }
  }
}

void continued_jacobian(acb_mat_t to, const struct continuation *c, acb_srcptr v, slong precision)
{
  SCOPED_BALLS(jet, JET);
  SCOPED(acb, eps, rate, term);
  continued_eps(eps, c, v + c->n, 0, precision);
  continued_eps(rate, c, v + c->n, 1, precision);
  for (slong i = 0; i < c->n; i++) {
    for (slong j = 0; j <= c->n; j++) {
      acb_set(acb_mat_entry(to, i, j), acb_mat_entry(c->fixed, i, j));
      acb_addmul(acb_mat_entry(to, i, j), eps, acb_mat_entry(c->per_eps, i, j), precision);
      acb_neg(acb_mat_entry(to, i, j), acb_mat_entry(to, i, j));
    }
    continued_row(term, c->per_eps, i, v, 1, precision);
    acb_submul(acb_mat_entry(to, i, c->n), term, rate, precision);
    if (i < c->m) {
      law_at(jet, c, i, v, precision);
      acb_add(acb_mat_entry(to, i, i), acb_mat_entry(to, i, i), jet + JET_A, precision);
      acb_add(acb_mat_entry(to, i, i + 1), acb_mat_entry(to, i, i + 1), jet + JET_B, precision);
    }
  }
}

/* Computes -(law_aa u_a^2 + 2 law_ab u_a u_b + law_bb u_b^2) + 2 eps' u_z per_eps u + eps'' u_z^2 per_eps (v, 1). */
void continued_bend(acb_mat_t bend, const struct continuation *c, acb_srcptr v, acb_srcptr u, slong precision)
{
  SCOPED_BALLS(jet, JET);
  acb_srcptr z = v + c->n, dz = u + c->n;
  SCOPED(acb, rate, change, term);
  continued_eps(rate, c, z, 1, precision);
  acb_mul(rate, rate, dz, precision);
  acb_mul_2exp_si(rate, rate, 1);
  continued_eps(change, c, z, 2, precision);
  acb_mul(change, change, dz, precision);
  acb_mul(change, change, dz, precision);
  for (slong i = 0; i < c->n; i++) {
    acb_ptr to = acb_mat_entry(bend, i, 0);
    continued_row(to, c->per_eps, i, u, 0, precision);
    acb_mul(to, to, rate, precision);
    continued_row(term, c->per_eps, i, v, 1, precision);
    acb_addmul(to, term, change, precision);
    if (i == c->m)
      break;
    law_at(jet, c, i, v, precision);
    acb_mul(term, jet + JET_BB, u + i + 1, precision);
    acb_submul(to, term, u + i + 1, precision);
    acb_mul_2exp_si(jet + JET_AB, jet + JET_AB, 1);
    acb_mul(term, jet + JET_AA, u + i, precision);
    acb_addmul(term, jet + JET_AB, u + i + 1, precision);
    acb_submul(to, term, u + i, precision);
  }
}

/* Computes a gain. With the direction u, the drops d_i of the slope over eps at the crossings, and f_i the fraction of
 * the phase of crossing i: after the first phase u_0 + eps sum of f_0 d_i u_i over its crossings; travel u_0 + eps sum
 * of f_i d_i u_i (f_i (1 - s_i) + (f_1 in the first phase)). */
void continued_gain(acb_t gain, const struct continuation *c, enum continued_value value, acb_srcptr v, acb_srcptr u,
                    slong precision)
{
  slong count = value == TRAVEL ? c->m : value == AFTER_FIRST_PHASE ? c->first_phase : 0;
  SCOPED(acb, eps, share);
  continued_eps(eps, c, v + c->n, 0, precision);
  acb_set(gain, value == LAST_CROSSING ? u + c->m : u);
  for (slong i = 0; i < count; i++) {
    arb_srcptr fraction = c->fraction[i >= c->first_phase];
    acb_one(share);
    if (value == TRAVEL) {
      acb_sub(share, share, v + 1 + i, precision);
      acb_mul_arb(share, share, fraction, precision);
      if (i < c->first_phase)
        acb_add_arb(share, share, c->fraction[1], precision);
    }
    acb_mul(share, share, u + 1 + i, precision);
    acb_mul_arb(share, share, c->crossing[i].drop, precision);
    acb_mul_arb(share, share, fraction, precision);
    acb_addmul(gain, share, eps, precision);
  }
}
