#include <math.h>

#include "asymptotics/observed/judged.h"

/* Returns P(|T| <= t): the finite sum in theta = atan(t/sqrt(dof)) for integer dof (Abramowitz & Stegun 26.7.3 and
 * 26.7.4), or, for many terms, the probability of the equivalent normal deviate (Hill, Comm. ACM 13, 1970, 617). */
static double within(double t, long dof)
{
  static const double pi = 3.14159265358979323846;
  static const long most_terms = 200;
  if (dof > most_terms) {
    double n = (double)dof - 0.5, square = n * log1p(t * t / (double)dof), z = sqrt(square);
    return erf((z + (square + 3) * z / (48 * n * n)) / sqrt(2));
  }
  double theta = atan(t / sqrt((double)dof)), cosine = cos(theta), term = sin(theta), sum = 0;
  bool odd = dof % 2 != 0;
  term *= odd ? cosine : 1;
  for (long k = odd ? 3 : 2; k <= dof; k += 2) {
    sum += term;
    term *= cosine * cosine * (double)(k - 1) / (double)k;
  }
  return odd ? 2 / pi * (theta + sum) : sum;
}

double student_quantile(double share, long dof)
{
  double low = 0, high = 1;
  while (within(high, dof) < share)
    high *= 2;
  for (double mid = high / 2; low < mid && mid < high; mid = low + (high - low) / 2)
    *(within(mid, dof) < share ? &low : &high) = mid;
  return high;
}
