/* The headers of FLINT's complex balls, see flint.h and scoped.h. */
#ifndef SCALLOP_MODEL_EXACT_FLINT_COMPLEX_H
#define SCALLOP_MODEL_EXACT_FLINT_COMPLEX_H

#include "model/exact/scoped.h"
#if __FLINT_RELEASE >= 30000
#include <flint/acb_mat.h>
#include <flint/acb_poly.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/arb_mat.h>
#else
#include <acb_mat.h>
#include <acb_poly.h>
#include <arb_fmpz_poly.h>
#include <arb_mat.h>
#endif

SCOPED_FLINT(acb)
SCOPED_FLINT(acb_poly)

#endif
