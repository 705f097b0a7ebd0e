/* FLINT's numbers, and structs of them, initialized by their declaration and cleared at the end of their block:
 * SCOPED(arb, x, y); is arb_t x, y; arb_init(x); arb_init(y); ... arb_clear(x); arb_clear(y); SCOPED_KIND does the
 * same for a struct with _init and _clear. Header-only; needs FLINT. */
#ifndef SCALLOP_MODEL_EXACT_SCOPED_H
#define SCALLOP_MODEL_EXACT_SCOPED_H

#include <string.h>

#include "model/exact/ball.h"
#include "model/exact/flint.h"

#define SCOPED(kind, ...) SCOPED_OF(__VA_ARGS__, 6, 5, 4, 3, 2, 1)(kind, __VA_ARGS__)
#define SCOPED_OF(a, b, c, d, e, f, count, ...) SCOPED_##count
#define SCOPED_1(kind, name) \
  ENDED_BY(scoped_end_##kind) scoped_##kind name; \
  scoped_begin_##kind(&name)
#define SCOPED_2(kind, name, ...) \
  SCOPED_1(kind, name); \
  SCOPED_1(kind, __VA_ARGS__)
#define SCOPED_3(kind, name, ...) \
  SCOPED_1(kind, name); \
  SCOPED_2(kind, __VA_ARGS__)
#define SCOPED_4(kind, name, ...) \
  SCOPED_1(kind, name); \
  SCOPED_3(kind, __VA_ARGS__)
#define SCOPED_5(kind, name, ...) \
  SCOPED_1(kind, name); \
  SCOPED_4(kind, __VA_ARGS__)
#define SCOPED_6(kind, name, ...) \
  SCOPED_1(kind, name); \
  SCOPED_5(kind, __VA_ARGS__)

/* ENDED_BY(f) struct thing a, b; calls f(&a), f(&b) at the end of the block. */
#define ENDED_BY(end) __attribute__((cleanup(end)))

#define SCOPED_BY(kind, type, begin, end) \
  typedef type scoped_##kind; \
  __attribute__((unused)) static inline void scoped_begin_##kind(scoped_##kind *x) { begin; } \
  __attribute__((unused)) static inline void scoped_end_##kind(scoped_##kind *x) { end; }
#define SCOPED_KIND(kind, type) SCOPED_BY(kind, type, kind##_init(x), kind##_clear(x))
#define SCOPED_FLINT(kind) SCOPED_BY(kind, kind##_t, kind##_init(*x), kind##_clear(*x))

/* Defines kind_init and kind_clear of a struct of such parts. PARTS(of) lists them as of(kind, pointer), with s for
 * the struct; all other members are set to 0. */
#define SCOPED_INIT(kind, part) kind##_init(part);
#define SCOPED_CLEAR(kind, part) kind##_clear(part);
#define SCOPED_PARTS(kind, type, PARTS) \
  static inline void kind##_init(type *s) \
  { \
    memset(s, 0, sizeof *s); \
    PARTS(SCOPED_INIT) \
  } \
  static inline void kind##_clear(type *s){ PARTS(SCOPED_CLEAR) } SCOPED_KIND(kind, type)

SCOPED_FLINT(fmpq)
SCOPED_FLINT(fmpz)
SCOPED_FLINT(fmpq_poly)
SCOPED_FLINT(arf)
SCOPED_FLINT(mag)
SCOPED_FLINT(arb)
SCOPED_FLINT(arb_poly)
SCOPED_FLINT(fmpz_poly)
SCOPED_KIND(scallop_rational, struct scallop_rational_crawler)

#endif
