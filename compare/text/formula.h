/* Formulas over named quantities, as "dvC*T/L" or "log10(abs(error))".
 *
 *     sum      product, then any number of + product, - product
 *     product  factor, then any number of * factor, / factor
 *     factor   - factor, or value, or value ^ factor
 *     value    a number, a quantity, FUNCTION(sum, ...) or (sum)
 *
 * So -2^2 = -4, 2^3^2 = 2^9, 2^-3 = 1/8 and 1/2/2 = 1/4. Numbers are decimal, 12, .5 or 1.25e-3. Names begin with a letter
 * and go on with letters, digits, _ . and :; one before a parenthesis is a function's: abs sqrt exp log log10, of one
 * argument, min and max, of two or more. Blanks and tabs may stand between all of these.
 *
 * The value is that of the operations in double, one after another, as IEEE 754 and C's library define them: what is outside
 * of a domain gives nan or an infinity and no complaint, and min and max of a nan are nan. x^n for integers |n| <=
 * ARITHMETIC_PRODUCTS is a product of x, x^2, x^4, x^8, x^16, the lower powers first, or 1 over that: the same bits on every
 * machine, x^2 and x^-1 correctly rounded, and a relative error of at most 16 * 2^-53 where x^|n| is in the normal range of
 * doubles (the largest met in 10^7 powers is 13.1 ulp, at x = 0x1.000b273205d5cp+5, n = -16). */
#ifndef SCALLOP_ARITHMETIC_H
#define SCALLOP_ARITHMETIC_H

enum { ARITHMETIC_STEPS = 256, ARITHMETIC_NESTED = 64, ARITHMETIC_NAME = 64, ARITHMETIC_PRODUCTS = 16 };

enum arithmetic_operation {
  ARITHMETIC_NUMBER,
  ARITHMETIC_QUANTITY,
  ARITHMETIC_NEGATE,
  ARITHMETIC_ADD,
  ARITHMETIC_SUBTRACT,
  ARITHMETIC_MULTIPLY,
  ARITHMETIC_DIVIDE,
  ARITHMETIC_POWER,
  ARITHMETIC_ABS,
  ARITHMETIC_SQRT,
  ARITHMETIC_EXP,
  ARITHMETIC_LOG,
  ARITHMETIC_LOG10,
  ARITHMETIC_MIN,
  ARITHMETIC_MAX
};

/* A compiled formula: its operations after their operands. */
struct arithmetic {
  int count;
  struct arithmetic_step {
    enum arithmetic_operation operation;
    int place;     /* of a quantity */
    double number; /* of a number   */
  } steps[ARITHMETIC_STEPS];
};

/* The place of a quantity among the values, >= 0, or < 0 where there is none of this name. */
typedef int arithmetic_names(void *context, const char *name);

/* Compiles text: at most ARITHMETIC_STEPS numbers, quantities and operations, ARITHMETIC_NESTED parentheses, minus signs and
 * powers within one another, and names of fewer than ARITHMETIC_NAME characters. Returns NULL, or what is wrong and at which
 * character, counted from 1: it lives until the next call, and *formula is unchanged. */
const char *arithmetic_compile(struct arithmetic *formula, const char *text, arithmetic_names *names, void *context);

/* The value, where values[place] is that of the quantity at a place. A formula that is one name gives that value's bits. */
double arithmetic_value(const struct arithmetic *formula, const double *values);

/* The places that a formula uses, each once, in the order in which it first does. Returns how many. */
int arithmetic_places(const struct arithmetic *formula, int places[ARITHMETIC_STEPS]);

#endif
