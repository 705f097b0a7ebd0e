/* Krawczyk's operator for the equations of a branch: for v_p in a ball, the others around a middle m, and C about the
 * inverse of the derivative J of the equations F by the others, both at the middle,
 *
 *     K(V) = m - C F(m) - C dF/dv_p (v_p - m_p) + (1 - C J(V)) (V - m).
 *
 * If K(V) lies inside V, F has exactly one zero in V for each v_p. 1 - C J(V) is summed from differences to the middle:
 * common parts of the entries of J then cancel before they widen the result. */
#include "asymptotics/derived/continuation.h"
#include "asymptotics/derived/scoped.h"

/* Matrices of the operator, by name and columns, n rows each */
#define KRAWCZYK_MATRICES(of) \
  of(jacobian, n + 1) of(middle, n + 1)            /* anywhere; at the middle             */ \
      of(others, n) of(inverse, n)                 /* of the middle the columns but p; C */ \
      of(near, n + 1) of(gain, n + 2) of(drive, 1) /* C J(m) - 1, C per_eps, C dF/dv_p   */ \
      of(residual, 1) of(step, 1)
#define KRAWCZYK_MEMBER(name, columns) acb_mat_t name;
#define KRAWCZYK_INIT(name, columns) acb_mat_init(k->name, n, columns);
#define KRAWCZYK_CLEAR(name, columns) acb_mat_clear(k->name);

struct krawczyk {
  const struct continuation *c;
  slong n, p, precision;
  KRAWCZYK_MATRICES(KRAWCZYK_MEMBER)
};

static void krawczyk_init(struct krawczyk *k, const struct continuation *c, slong p, slong precision)
{
  const slong n = c->n;
  *k = (struct krawczyk){ .c = c, .n = n, .p = p, .precision = precision };
  KRAWCZYK_MATRICES(KRAWCZYK_INIT)
}

static void krawczyk_clear(struct krawczyk *k) { KRAWCZYK_MATRICES(KRAWCZYK_CLEAR) }

/* Returns the coordinate of column j of the others. */
static slong other(const struct krawczyk *k, slong j) { return j + (j >= k->p); }

static void drop_column(acb_mat_t others, acb_mat_t dropped, const struct krawczyk *k, const acb_mat_t all)
{
  for (slong i = 0; i < k->n; i++) {
    for (slong j = 0; j < k->n; j++)
      acb_set(acb_mat_entry(others, i, j), acb_mat_entry(all, i, other(k, j)));
    acb_set(acb_mat_entry(dropped, i, 0), acb_mat_entry(all, i, k->p));
  }
}

/* Makes one step of Newton's method, and computes its size. Returns false if it is not finite. */
static bool newton_step(struct krawczyk *k, acb_ptr v, mag_t size)
{
  SCOPED(mag, here);
  continued_jacobian(k->middle, k->c, v, k->precision);
  continued_residual(k->residual, k->c, v, k->precision);
  drop_column(k->others, k->drive, k, k->middle);
  bool sound = acb_mat_is_finite(k->middle) && acb_mat_approx_inv(k->inverse, k->others, k->precision);
  if (sound)
    acb_mat_approx_mul(k->step, k->inverse, k->residual, k->precision);
  mag_zero(size);
  for (slong j = 0; j < k->n && sound; j++) {
    acb_ptr to = v + other(k, j);
    acb_get_mag(here, acb_mat_entry(k->step, j, 0));
    mag_max(size, size, here);
    acb_sub(to, to, acb_mat_entry(k->step, j, 0), k->precision);
    acb_get_mid(to, to);
    sound = acb_is_finite(to);
  }
  return sound;
}

/* Iterates Newton's method for the middle of v[p], until a step is small beside the ball of v[p] or its square is small
 * beside rounding. */
static bool find_middle(struct krawczyk *k, acb_ptr v)
{
  enum { STEPS = 20, SMALL = 3 };
  bool close = false;
  SCOPED(mag, size, enough);
  mag_max(enough, arb_radref(acb_realref(v + k->p)), arb_radref(acb_imagref(v + k->p)));
  mag_mul_2exp_si(enough, enough, -SMALL);
  for (slong j = 0; j <= k->n; j++)
    acb_get_mid(v + j, v + j);
  for (int i = 0; i < STEPS && !close && newton_step(k, v, size); i++)
    close = mag_cmp(size, enough) < 0 || mag_cmp_2exp_si(size, -k->precision / 2) < 0;
  return close;
}

/* Computes the parts of K that do not depend on V. */
static void prepare(struct krawczyk *k, acb_srcptr middle, const acb_t whole)
{
  SCOPED_BALLS(v, k->n + 1);
  _acb_vec_set(v, middle, k->n + 1);
  continued_residual(k->residual, k->c, v, k->precision);
  acb_mat_mul(k->residual, k->inverse, k->residual, k->precision);
  continued_jacobian(k->middle, k->c, v, k->precision);
  acb_mat_mul(k->near, k->inverse, k->middle, k->precision);
  for (slong i = 0; i < k->n; i++)
    acb_sub_ui(acb_mat_entry(k->near, i, other(k, i)), acb_mat_entry(k->near, i, other(k, i)), 1, k->precision);
  acb_mat_mul(k->gain, k->inverse, k->c->per_eps, k->precision);
  acb_set(v + k->p, whole);
  continued_jacobian(k->jacobian, k->c, v, k->precision);
  drop_column(k->others, k->drive, k, k->jacobian);
  acb_mat_mul(k->drive, k->inverse, k->drive, k->precision);
}

/* Computes next = m - C F(m) - C dF/dv_p (v_p - m_p). */
static void first_guess(acb_ptr next, const struct krawczyk *k, acb_srcptr middle, const acb_t whole)
{
  SCOPED(acb, way);
  acb_sub(way, whole, middle + k->p, k->precision);
  for (slong j = 0; j < k->n; j++) {
    acb_ptr to = next + other(k, j);
    acb_sub(to, middle + other(k, j), acb_mat_entry(k->residual, j, 0), k->precision);
    acb_submul(to, acb_mat_entry(k->drive, j, 0), way, k->precision);
  }
  acb_set(next + k->p, whole);
}

/* Subtracts the contribution of eps - eps(middle) to C (J(V) - J(m)) (V - m): the difference times C per_eps. */
static void subtract_change_of_eps(acb_ptr to, const struct krawczyk *k, acb_srcptr middle, acb_srcptr around,
                                   acb_srcptr way)
{
  const struct continuation *c = k->c;
  const slong n = k->n, precision = k->precision;
  SCOPED(acb, change, rate, rate_at_middle, sum, at_middle);
  continued_eps(change, c, around + n, 0, precision);
  continued_eps(sum, c, middle + n, 0, precision);
  acb_sub(change, change, sum, precision);
  continued_eps(rate, c, around + n, 1, precision);
  continued_eps(rate_at_middle, c, middle + n, 1, precision);
  for (slong i = 0; i < n; i++) {
    acb_ptr here = to + other(k, i);
    continued_row(sum, k->gain, i, way, 0, precision);
    acb_addmul(here, sum, change, precision);
    if (k->p == n)
      continue;
    continued_row(sum, k->gain, i, around, 1, precision);
    acb_mul(sum, sum, rate, precision);
    continued_row(at_middle, k->gain, i, middle, 1, precision);
    acb_submul(sum, at_middle, rate_at_middle, precision);
    acb_addmul(here, sum, way + n, precision);
  }
}

/* Subtracts the contribution of the curves: C times the change of each curve's derivatives. */
static void subtract_change_of_curves(acb_ptr to, const struct krawczyk *k, acb_srcptr middle, acb_srcptr around,
                                      acb_srcptr way)
{
  const struct continuation *c = k->c;
  const slong precision = k->precision;
  SCOPED_BALLS(here, JET);
  SCOPED_BALLS(there, JET);
  SCOPED(acb, sum);
  for (slong l = 0; l < c->m; l++) {
    continued_law(here, &c->crossing[l], around + l, around + l + 1, precision);
    if (c->crossing[l].joined) {
      acb_mul(here + JET_A, here + JET_AA, way + l, precision);
      acb_addmul(here + JET_A, here + JET_AB, way + l + 1, precision);
      acb_mul(here + JET_B, here + JET_BB, way + l + 1, precision);
      acb_addmul(here + JET_B, here + JET_AB, way + l, precision);
    } else {
      continued_law(there, &c->crossing[l], middle + l, middle + l + 1, precision);
      _acb_vec_sub(here, here, there, JET, precision);
    }
    acb_mul(sum, here + JET_A, way + l, precision);
    acb_addmul(sum, here + JET_B, way + l + 1, precision);
    for (slong i = 0; i < k->n; i++)
      acb_submul(to + other(k, i), acb_mat_entry(k->inverse, i, l), sum, precision);
  }
}

static void map(acb_ptr next, const struct krawczyk *k, acb_srcptr middle, acb_srcptr around)
{
  SCOPED_BALLS(way, k->n + 1);
  first_guess(next, k, middle, around + k->p);
  _acb_vec_sub(way, around, middle, k->n + 1, k->precision);
  acb_zero(way + k->p);
  for (slong i = 0; i < k->n; i++)
    for (slong j = 0; j <= k->n; j++)
      acb_submul(next + other(k, i), acb_mat_entry(k->near, i, j), way + j, k->precision);
  subtract_change_of_eps(next, k, middle, around, way);
  subtract_change_of_curves(next, k, middle, around, way);
}

/* Sets a box around middle, slightly larger than next requires. */
static void widen(acb_ptr around, const struct krawczyk *k, acb_srcptr middle, acb_srcptr next)
{
  SCOPED(mag, size, least);
  SCOPED(acb, way);
  mag_set_ui_2exp_si(least, 1, 8 - k->precision);
  for (slong j = 0; j < k->n; j++) {
    acb_ptr to = around + other(k, j);
    acb_sub(way, next + other(k, j), middle + other(k, j), k->precision);
    acb_get_mag(size, way);
    mag_mul_ui(size, size, 5);
    mag_mul_2exp_si(size, size, -2);
    mag_add(size, size, least);
    acb_set(to, middle + other(k, j));
    acb_add_error_mag(to, size);
  }
}

static bool lies_inside(const struct krawczyk *k, acb_srcptr around, acb_srcptr next)
{
  for (slong j = 0; j < k->n; j++)
    if (!acb_is_finite(next + other(k, j)) || !acb_contains_interior(around + other(k, j), next + other(k, j)))
      return false;
  return true;
}

bool continuation_enclose(acb_ptr v, acb_ptr around, const struct continuation *c, slong p, slong precision)
{
  enum { TRIES = 4 };
  SCOPED_BALLS(middle, c->n + 1);
  SCOPED_BALLS(next, c->n + 1);
  ENDED_BY(krawczyk_clear) struct krawczyk k;
  krawczyk_init(&k, c, p, precision);
  _acb_vec_set(middle, v, c->n + 1);
  if (!find_middle(&k, middle))
    return false;
  prepare(&k, middle, v + p);
  first_guess(next, &k, middle, v + p);
  acb_set(around + p, v + p);
  for (int i = 0; i < TRIES; i++) {
    widen(around, &k, middle, next);
    map(next, &k, middle, around);
    if (lies_inside(&k, around, next)) {
      _acb_vec_set(v, next, c->n + 1);
      return true;
    }
  }
  return false;
}

bool continuation_derivatives(acb_ptr first, acb_t second, const struct continuation *c, acb_srcptr v, slong p,
                              slong precision)
{
  ENDED_BY(krawczyk_clear) struct krawczyk k;
  krawczyk_init(&k, c, p, precision);
  continued_jacobian(k.jacobian, c, v, precision);
  drop_column(k.others, k.drive, &k, k.jacobian);
  acb_mat_neg(k.drive, k.drive);
  if (!acb_mat_solve_precond(k.step, k.others, k.drive, precision))
    return false; /* GCOVR_EXCL_LINE: balls too wide */
  acb_one(first + p);
  for (slong j = 0; j < c->n; j++)
    acb_set(first + other(&k, j), acb_mat_entry(k.step, j, 0));
  continued_bend(k.residual, c, v, first, precision);
  if (!acb_mat_solve_precond(k.step, k.others, k.residual, precision))
    return false; /* GCOVR_EXCL_LINE: balls too wide */
  acb_zero(second);
  if (p < c->n)
    acb_set(second, acb_mat_entry(k.step, c->n - 1, 0));
  return true;
}
