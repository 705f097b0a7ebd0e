/* The wider solver in long double. */
#include <float.h>
#include <math.h>

typedef long double real;
#define REAL_BITS LDBL_MANT_DIG
#define WIDE wide_long
#include "numerics/wide/wide_parts.h"

static real real_sine(real x) { return sinl(x); }
static real real_cosine(real x) { return cosl(x); }

#include "numerics/wide/wide_solve.h"
