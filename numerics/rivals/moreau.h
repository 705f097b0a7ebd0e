/* A rival (rival.h): Moreau and Jean's time stepping, which steps over events and needs to know nothing of them. One
 * step of the velocity c of the centre of mass (numerics.h) is the implicit Euler step with the set-valued sign,
 * Sgn(0) = [-1, 1],
 *
 *     c_new + h (F1 Sgn(c_new - (m2/M) l') + F2 Sgn(c_new + (m1/M) l'))/M  contains  c_old,
 *
 * l' at the end of the step, and its path that of the theta rule, X_new = X_old + h (c_old + c_new)/2. The inclusion
 * is monotone and piecewise linear in one unknown, so it is solved in closed form: no iteration, no tolerance, and a
 * stuck body is exactly at rest. The displacement of the geometric centre is that of X, as l returns.
 * Sources: J. J. Moreau, "Unilateral contact and dry friction in finite freedom dynamics", 1988; M. Jean, Comput.
 * Methods Appl. Mech. Eng. 177 (1999) 235; V. Acary and B. Brogliato, "Numerical methods for nonsmooth dynamical
 * systems", 2008, chapter 10. */
#ifndef SCALLOP_NUMERICS_RIVALS_MOREAU_H
#define SCALLOP_NUMERICS_RIVALS_MOREAU_H

#include "numerics/rivals/rival.h"

#ifdef __cplusplus
extern "C" {
#endif

/* steps equal steps a phase, 1 <= steps <= 2^53. NULL: an argument outside of that, or memory is short. Patience is
 * asked every 256 steps. evaluations: of l'. Never SCALLOP_ECONVERGE. First order, and that from the crossings alone:
 * in the step in which a body turns, friction has the sign of the end for the whole step. So the error lies anywhere
 * below its bound, by where in the step that happens, and does not fall smoothly. Worst seen in 10000 periods, in v_end
 * in L/T and in the displacement in L: 1.8 eps/steps, eps = T^2 (F1 + F2)/(M L); tests/numerics/rivals/test_moreau.c
 * holds both to 2 eps/steps. Rounding adds up to 1e-16 (1 + |c| T/L) steps, and overtakes that at about 1e8 steps. */
struct scallop_rival *scallop_moreau_rival(long steps);

#ifdef __cplusplus
}
#endif

#endif
