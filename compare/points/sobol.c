/* Sobol sequences from GSL. A build without GSL omits this file. */
#include <gsl/gsl_qrng.h>

#include "compare/points/sweep.h"

static void *begin(int dimensions) { return gsl_qrng_alloc(gsl_qrng_sobol, (unsigned)dimensions); }
static void next(void *generator, double *x) { gsl_qrng_get(generator, x); }
static void end(void *generator) { gsl_qrng_free(generator); }

static void __attribute__((constructor)) init(void) { sweep_sobol = (struct sweep_sobol){ begin, next, end }; }
