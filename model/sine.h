/* Sine and cosine of a fraction of a half turn, inline and without branches, for loops over many crawlers. Not
 * public. */
#ifndef SCALLOP_MODEL_SINE_H
#define SCALLOP_MODEL_SINE_H

#include "model/scaling.h"

/* Computes sin(pi u) and cos(pi u), 0 <= u <= 1/2, by Taylor polynomials around the nearer end: each is exactly 0 at
 * one end. Error: below 1.7 ulp. Unlike the library's sine it does not round to nearest in every rounding
 * mode, on which the walk relies next to the peak. */
SCALLOP_INLINE void sine_of_half_turn(double u, double *sine, double *cosine)
{
  const double low = 1.2246467991473532e-16; /* pi minus the double nearest to it */
  const double v = u > 0.25 ? 0.5 - u : u, x = v * v, y = x * x;
  const double odd = -5.16771278004997
                     + y * (-0.5992645293207921 + y * (-0.0073704309457143504 + y * -2.1915353447830217e-05));
  const double even = 2.5501640398773455
                      + y * (0.08214588661112823 + y * (0.00046630280576761255 + y * 7.952054001475513e-07));
  const double s = v * 3.141592653589793 + v * (low + x * (odd + x * even));
  const double far =
      -4.934802200544679
      + y
            * (-1.3352627688545895
               + y * (-0.02580689139001406 + y * (-0.0001046381049248457 + y * -1.3878952462213771e-07)));
  const double near = 4.0587121264167685
                      + y * (0.2353306303588932 + y * (0.0019295743094039231 + y * 4.303069587032947e-06));
  const double c = 1 + x * (far + x * near);
  *sine = u > 0.25 ? c : s;
  *cosine = u > 0.25 ? s : c;
}

#endif
