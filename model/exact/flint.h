/* The headers of FLINT and of its ball arithmetic Arb: a separate library with FLINT 2, a part of FLINT 3. */
#ifndef SCALLOP_MODEL_EXACT_FLINT_H
#define SCALLOP_MODEL_EXACT_FLINT_H

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#if __FLINT_RELEASE >= 30000
#include <flint/arb.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/arb_poly.h>
#else
#include <arb.h>
#include <arb_fmpz_poly.h>
#include <arb_poly.h>
#endif

#endif
