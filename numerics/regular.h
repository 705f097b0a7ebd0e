/* The steady state in closed form, for phases of two ramps (ramps.h) and the regular modes: each phase begins and ends
 * with both bodies moving one way, and in between one of them turns back and forth, never held. Inline and without a branch, so that
 * many crawlers can be solved in a row by vector instructions. Not public.
 *
 * In one phase, with c the velocity of the centre of mass in L/tau, q |l'| the curve it crosses, f the friction of the body
 * that turns, and the other's force larger or smaller by beta = (F_turns - F_other)/(F1 + F2):
 *     t1 = c_start/(up q + eps)                                   the first crossing
 *     dT = (beta eps + (up q - beta eps) t1)/(down q + beta eps)  the last one, from the end
 *     c_end = (down q - eps) dT
 * so that all is linear in the start velocity of the period, and so is the balance of impulses
 *     beta (2 alpha - 1) = 2 f_e alpha (t1 + dT)_e + 2 f_c (1 - alpha) (t1 + dT)_c.
 */
#ifndef SCALLOP_REGULAR_H
#define SCALLOP_REGULAR_H

#include "model/scaling.h"
#include "numerics/ramps.h"

struct regular_phase {
  double up, down, eps, between;    /* up q, down q, and c' outside and between the crossings; all per tau      */
  double t_slope, u_start, u_slope; /* t1 = t_slope c, dT = u_start + u_slope c, for c at the start             */
};

struct regular {
  double c_start, c_mid, c_end; /* in L/T                                                                      */
  double travel, multiplier, balance;
};

static inline struct regular_phase regular_phase(const struct ramps *r, double q, double eps, double beta)
{
  struct regular_phase p = { .up = r->up * q, .down = r->down * q, .eps = eps, .between = beta * eps };
  double share = 1 / (p.down + p.between);
  p.t_slope = 1 / (p.up + eps);
  p.u_start = p.between * share;
  p.u_slope = (p.up - p.between) * p.t_slope * share;
  return p;
}

/* The phase from c at its start: what it adds to the travel; its times and last velocity. True: in these modes. */
static inline int regular_run(const struct regular_phase *p, const struct ramps *r, double c, double *travel, double *turned,
                              double *c_end)
{
  double t = p->t_slope * c, u = p->u_start + p->u_slope * c, y = p->up * t, z = p->down * u;
  *c_end = z - p->eps * u;
  *turned = t + u;
  *travel = 0.5 * ((c + y) * t + (y + z) * (1 - t - u) + (z + *c_end) * u);
  return (t > 0) & (t < r->top) & (u > 0) & (u < r->rest) & (p->up > p->between) & (p->down > p->eps);
}

/* alpha: of the scaled crawler; driven: 2 alpha - 1 as the gait has it. True: these are the modes, and *out the steady state. */
static inline int regular_steady(const struct scaling *s, double alpha, double driven, const struct ramps *extension,
                                 const struct ramps *contraction, struct regular *out)
{
  int forward = s->delta * driven > 0; /* backward is forward with the bodies exchanged, in a mirror */
  double sign = forward ? 1 : -1, beta = sign * s->delta, b = 1 - alpha;
  double q_e = forward ? s->mu2 : s->mu1, q_c = forward ? s->mu1 : s->mu2;
  double f_e = alpha * (forward ? s->f1 : s->f2), f_c = b * (forward ? s->f2 : s->f1);
  struct regular_phase e = regular_phase(extension, q_e, s->eps * (alpha * alpha), beta);
  struct regular_phase c = regular_phase(contraction, q_c, s->eps * (b * b), -beta);
  double across = (b / alpha) * (e.down - e.eps), back = (alpha / b) * (c.down - c.eps);
  double turned_e = e.t_slope + e.u_slope, turned_c = across * (c.t_slope + c.u_slope);
  double drive = 0.5 * beta * driven;
  double at_zero = drive - f_e * e.u_start - f_c * (c.u_start + turned_c * e.u_start);
  double start = at_zero / (f_e * turned_e + f_c * turned_c * e.u_slope), mid, end;
  double travel_e, travel_c;
  int valid = regular_run(&e, extension, start, &travel_e, &turned_e, &mid);
  mid *= b / alpha;
  valid &= regular_run(&c, contraction, mid, &travel_c, &turned_c, &end);
  out->c_start = sign * (start / alpha);
  out->c_mid = sign * (mid / b);
  out->c_end = sign * (end / b);
  out->travel = sign * (travel_e + travel_c);
  out->multiplier = (across * e.u_slope) * (back * c.u_slope);
  out->balance = sign * 2 * (drive - f_e * turned_e - f_c * turned_c);
  return valid;
}

#endif
