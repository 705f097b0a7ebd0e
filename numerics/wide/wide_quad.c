/* The wider solver: in binary128 if __float128 exists, else in long double, which may also be binary128. */
#include <float.h>

#include "numerics/wide/wide_parts.h"

#if WIDE_HAS_FLOAT128
__extension__ typedef __float128 real;
#define REAL_BITS 113
#else
typedef long double real;
#define REAL_BITS LDBL_MANT_DIG
#endif
#define WIDE wide_quad
#define SMALL_STEP 1e-18
#define SMALL_THIRD_STEP 1e-12

/* The C library has no sine for some of these types. */
#define OVER(n) ((real)1 / ((n) * ((n) + 1)))
static const real over[] = { OVER(1),  OVER(2),  OVER(3),  OVER(4),  OVER(5),  OVER(6),  OVER(7),  OVER(8),
                             OVER(9),  OVER(10), OVER(11), OVER(12), OVER(13), OVER(14), OVER(15), OVER(16),
                             OVER(17), OVER(18), OVER(19), OVER(20), OVER(21), OVER(22), OVER(23), OVER(24),
                             OVER(25), OVER(26), OVER(27), OVER(28), OVER(29), OVER(30) };
enum { TERMS = sizeof over / sizeof over[0] };

/* The sum of (-1)^k x^(2k + first)/(2k + first)!: the sine for first = 1, the cosine for first = 0; |x| < 1. */
static real sine_sum(real x, int first)
{
  const real last = 1 / ((real)(1LL << REAL_BITS / 2) * (1LL << (REAL_BITS + 4 - REAL_BITS / 2)));
  real term = first ? x : 1, sum = term, square = -x * x;
  for (int n = first; n < TERMS; n += 2) {
    term *= square * over[n];
    sum += term;
    if (term < last && -term < last && (first == 0 || (term < last * x && -term < last * x)))
      break;
  }
  return sum;
}

static real real_sine(real x) { return sine_sum(x, 1); }
static real real_cosine(real x) { return sine_sum(x, 0); }

#include "numerics/wide/wide_solve.h"
