#include "asymptotics/observed/student.h"

#include <math.h>
#include <stdbool.h>

enum { MOST_TERMS = 200 };

/* P(|T| <= t) */
static double within(double t, long dof)
{
  static const double pi = 3.14159265358979323846;
  double theta = atan(t / sqrt((double)dof)), cosine = cos(theta), term = sin(theta), sum = 0;
  bool odd = dof % 2 != 0;
  term *= odd ? cosine : 1;
  for (long k = odd ? 3 : 2; k <= dof; k += 2) {
    sum += term;
    term *= cosine * cosine * (double)(k - 1) / (double)k;
  }
  return odd ? 2 / pi * (theta + sum) : sum;
}

static double normal_within(double z) { return erf(z / sqrt(2)); }

double student_quantile(double share, long dof)
{
  const bool many = dof > MOST_TERMS;
  double low = 0, high = 1;
  while ((many ? normal_within(high) : within(high, dof)) < share)
    high *= 2;
  for (double mid = high / 2; low < mid && mid < high; mid = low + (high - low) / 2)
    *((many ? normal_within(mid) : within(mid, dof)) < share ? &low : &high) = mid;
  if (!many)
    return high;
  double z = high, s = z * z, n = (double)dof;
  double g1 = z * (s + 1) / 4, g2 = z * ((5 * s + 16) * s + 3) / 96, g3 = z * (((3 * s + 19) * s + 17) * s - 15) / 384;
  double g4 = z * ((((79 * s + 776) * s + 1482) * s - 1920) * s - 945) / 92160;
  return z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}
