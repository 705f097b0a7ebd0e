/* The wider solver in long double, if its type is not binary128. */
#include <float.h>
#include <math.h>

#include "numerics/wide/wide_parts.h"

#if LDBL_MANT_DIG != 113
typedef long double real;
#define REAL_BITS LDBL_MANT_DIG
#define WIDE wide_long
#define SMALL_STEP 3e-11L
#define SMALL_THIRD_STEP 1e-7L

static real real_sine(real x) { return sinl(x); }
static real real_cosine(real x) { return cosl(x); }

#include "numerics/wide/wide_solve.h"
#endif
