/* Formulas as text: one language for the columns of a scene, the published series and formula files. A formula is read
 * once into operations, and evaluated any number of times in double (below), in balls or as a series in T
 * (formula_flint.h).
 *
 *     sum      product, then any number of + product, - product
 *     product  factor, then any number of * factor, / factor
 *     factor   - factor, or value, or value ^ factor
 *     value    a number, a name, FUNCTION(sum, ...) or (sum)
 *
 * Hence -2^2 = -4, 2^3^2 = 2^9, 2^-3 = 1/8 and 1/2/2 = 1/4. Numbers are decimal (12, .5 or 1.25e-3), in the range of
 * doubles, and kept as text: balls and series read 0.1 as 1/10. Names are a letter, then letters, digits, _ . and :. A
 * name before a parenthesis is a function: abs sqrt exp log log10 sin cos asin have one argument, min and max two or
 * more. The caller defines all other names, except pi if the caller does not: quantities, and parts, with texts that
 * are read as if in parentheses. Blanks and tabs may separate all of these.
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
 *                   a series if                         exact, if x is, for               refused, among others
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
 * x^16, the lower powers first, or its inverse: the same bits on every machine, x^2 and x^-1 correctly rounded, and a
 * relative error of at most 16 * 2^-53 if x^|n| is in the normal range of doubles (the largest in 10^7 powers is 13.1
 * ulp, at x = 0x1.000b273205d5cp+5, n = -16). Any other x^y is computed by pow. */
#ifndef SCALLOP_ASYMPTOTICS_FORMULA_H
#define SCALLOP_ASYMPTOTICS_FORMULA_H

#include <stdbool.h>

enum {
  FORMULA_STEPS = 256,   /* most numbers, names and operations of a formula */
  FORMULA_NESTED = 64,   /* deepest nesting of parentheses, minus signs and powers */
  FORMULA_NAME = 64,     /* characters of a name and its NUL                        */
  FORMULA_DIGITS = 1200, /* characters of a number and a NUL                        */
  FORMULA_PRODUCTS = 16, /* the largest power that is a product in double           */
  /* most values on the stack: each but the last needs an operation that consumes it */
  FORMULA_DEPTH = FORMULA_STEPS / 2 + 1,
  FORMULA_MESSAGE = 320
};

/* Operations of one operand start at FORMULA_NEGATE, of two at FORMULA_ADD. */
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

/* A formula in postfix order: each operation follows its operands. */
struct formula {
  int count;
  struct formula_step {
    enum formula_operation operation;
    /* text of the formula or of a part, owned by the caller; balls and series read its numbers again */
    const char *text;
    int at;        /* position in text, from 0 */
    int length;    /* length of a number in text */
    int place;     /* index of a quantity, from formula_names */
    double number; /* nearest double of a number */
  } steps[FORMULA_STEPS];
};

/* The meaning of names, defined by the caller. Only place is required. */
struct formula_names {
  /* Returns the index of a quantity among the values, or < 0 for an unknown name. */
  int (*place)(void *context, const char *name);
  /* nearest: returns the known name most similar to an unknown one, or, if functions (NULL-terminated) is not NULL, the
   * most similar of these; or NULL. part: returns the text of a part, or NULL. */
  const char *(*nearest)(void *context, const char *name, const char *const *functions);
  const char *(*part)(void *context, const char *name);
  void *context;
};

/* Reads text. Returns NULL, or `message`: the mistake and its character, counted from 1, in the text or in the part
 * that the message names; *formula is then unchanged. A part that contains itself exceeds FORMULA_NESTED. */
const char *formula_read(struct formula *formula, const char *text, const struct formula_names *names,
                         char message[FORMULA_MESSAGE]);

/* Returns the value in double; values[place] is the value of the quantity with this index. A formula that is one name
 * returns the same bits as the value. */
double formula_double(const struct formula *formula, const double *values);

/* Writes the indices of the quantities in a formula, each once, in the order of first use. Returns their count. */
int formula_places(const struct formula *formula, int places[FORMULA_STEPS]);

/* Returns true if the name is a word of the language: a function, or pi. */
bool formula_is_word(const char *name);

/* Returns the notation of an operation: "+", "sqrt". */
const char *formula_operation_text(enum formula_operation operation);

/* Writes "character 3: log WRONG" to message, with the name, number or operation of the step. Returns message. */
const char *formula_refuse(char message[FORMULA_MESSAGE], const struct formula_step *step, const char *wrong);

#endif
