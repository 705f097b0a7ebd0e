#include "compare/text/decimal.h"

char *decimal_text(const arb_t x, long digits) { return arb_get_str(x, digits, ARB_STR_NO_RADIUS); }

char *decimal_fraction(const fmpq_t x) { return fmpq_get_str(NULL, 10, x); }

char *decimal_ball(const arb_t x, long digits) { return arb_get_str(x, digits, 0); }
