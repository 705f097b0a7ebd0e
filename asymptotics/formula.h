/* Formulas as text: one language for the columns of a scene, the published series and any formula file. A formula
 * is read once into operations, and evaluated as often as needed in double (below), in balls or as a series in T
 * (formula_flint.h).
 *
 *     sum      product, then any number of + product, - product
 *     product  factor, then any number of * factor, / factor
 *     factor   - factor, or value, or value ^ factor
 *     value    a number, a name, FUNCTION(sum, ...) or (sum)
 *
 * So -2^2 = -4, 2^3^2 = 2^9, 2^-3 = 1/8 and 1/2/2 = 1/4. Numbers are decimal (12, .5 or 1.25e-3) and in the range of
 * doubles; they are kept as text, so that balls and series take 0.1 for 1/10. Names begin with a letter and go on with
 * letters, digits, _ . and :. A name before a parenthesis is that of a function: abs sqrt exp log log10 sin cos asin,
 * of one argument, min and max, of two or more. Any other name means what the caller says: a quantity, or a part, whose
 * text is read in its place as if in parentheses; or else, if it is pi, that number. Blanks and tabs may stand between
 * all of these.
 *
 *                   double                ball              series in T
 *     number, pi    the nearest double    enclosed          exact: pi is a name, in fractions of polynomials in pi
 *     + - *         rounded               enclosed          exact while both operands are, else enclosed
 *     /             rounded               enclosed          refused if the divisor may be 0
 *     x^y           below                 enclosed          y whole with |y| <= 64 as products; else as below
 *     functions     the C library's       enclosed          as below
 *     off a domain  nan or an infinity    nan (not finite)  refused
 *
 * A series holds for T -> 0 from above. x = c T^k (1 + ...), k a whole number, c the first coefficient that is not
 * exactly 0:
 *
 *                   a series where                      exact, if x is, where             refused, among others
 *     exp sin cos   x is known at T = 0: no T^-1, ...   x = 0 at T = 0                    exp(1/T)
 *     asin          -1 < x < 1 at T = 0, or x = -1 or 1 x = 0 at T = 0                    asin(1 - T)
 *     log log10     k = 0, c > 0                        x = 1 at T = 0 (log)              log(T)
 *     sqrt          c > 0, k even; x = 0                c is the square of a fraction     sqrt(T)
 *     x^y           c > 0, y constant, k y whole        y = p/q with |p|, q <= 64, and c  T^0.5; T beyond power 4096
 *                   (c < 0 for whole y); 0^y, y > 0     the q-th power of a fraction
 *                   c > 0, k = 0, y varies: exp(y log x), as these two are                 T^T
 *     abs min max   the sign of c, for min and max of   always                            min(exp(1), exp(1))
 *                   the difference, is proven, or all
 *                   its known coefficients are exactly 0
 *
 * In double, min and max of a nan are nan, and x^n for whole |n| <= FORMULA_PRODUCTS is a product of x, x^2, x^4, x^8,
 * x^16, the lower powers first, or 1 over that: the same bits on every machine, x^2 and x^-1 correctly rounded, and a
 * relative error of at most 16 * 2^-53 where x^|n| is in the normal range of doubles (the largest met in 10^7 powers is
 * 13.1 ulp, at x = 0x1.000b273205d5cp+5, n = -16). Any other x^y is pow's. */
#ifndef SCALLOP_ASYMPTOTICS_FORMULA_H
#define SCALLOP_ASYMPTOTICS_FORMULA_H

#include <stdbool.h>

enum {
  FORMULA_STEPS = 256,                   /* numbers, names and operations of a formula              */
  FORMULA_NESTED = 64,                   /* parentheses, minus signs and powers within one another  */
  FORMULA_NAME = 64,                     /* characters of a name and its NUL                        */
  FORMULA_DIGITS = 1200,                 /* characters of a number and a NUL                        */
  FORMULA_PRODUCTS = 16,                 /* the largest power that is a product in double           */
  FORMULA_DEPTH = FORMULA_STEPS / 2 + 1, /* values at a time: each but the last needs an operation that takes it away */
  FORMULA_MESSAGE = 320
};

/* Those of one operand are from FORMULA_NEGATE on, those of two from FORMULA_ADD on. */
enum formula_operation {
  FORMULA_NUMBER,
  FORMULA_QUANTITY,
  FORMULA_PI,
  FORMULA_NEGATE,
  FORMULA_ABS,
  FORMULA_SQRT,
  FORMULA_EXP,
  FORMULA_LOG,
  FORMULA_LOG10,
  FORMULA_SIN,
  FORMULA_COS,
  FORMULA_ASIN,
  FORMULA_ADD,
  FORMULA_SUBTRACT,
  FORMULA_MULTIPLY,
  FORMULA_DIVIDE,
  FORMULA_POWER,
  FORMULA_MIN,
  FORMULA_MAX
};

/* A formula that was read: its operations after their operands. */
struct formula {
  int count;
  struct formula_step {
    enum formula_operation operation;
    const char *text; /* of the formula, or of the part; the caller's: balls and series read its numbers again */
    int at;           /* where it stands in text, from 0                     */
    int length;       /* of a number, there                                  */
    int place;        /* of a quantity, as formula_names says                */
    double number;    /* of a number, the nearest double                     */
  } steps[FORMULA_STEPS];
};

/* What names mean. */
struct formula_names {
  /* of a quantity among the values, or < 0 where the name is unknown */
  int (*place)(void *context, const char *name);
  /* The known name that an unknown one resembles, or, where functions (NULL-terminated) is not NULL, the one of these;
   * or NULL. May be NULL, as may part: the text of a part, or NULL */
  const char *(*nearest)(void *context, const char *name, const char *const *functions);
  const char *(*part)(void *context, const char *name);
  void *context;
};

/* Reads text. Returns NULL, or `message`: what is wrong and at which character, counted from 1, of the text or of the
 * part that the message names; *formula is then unchanged. A part that uses itself is found by the limit
 * FORMULA_NESTED. */
const char *formula_read(struct formula *formula, const char *text, const struct formula_names *names,
                         char message[FORMULA_MESSAGE]);

/* The value in double, where values[place] is that of the quantity at a place. A formula that is one name gives that
 * value's bits. */
double formula_double(const struct formula *formula, const double *values);

/* The places that a formula uses, each once, in the order in which it first does. Returns how many. */
int formula_places(const struct formula *formula, int places[FORMULA_STEPS]);

/* Is it a word of the language: the name of a function, or pi? */
bool formula_is_word(const char *name);

/* How an operation is written: "+", "sqrt" */
const char *formula_operation_text(enum formula_operation operation);

/* message becomes "character 3: log WRONG", with the name, number or operation of the step. Returns it. */
const char *formula_refuse(char message[FORMULA_MESSAGE], const struct formula_step *step, const char *wrong);

#endif
