/* asymptotics/: the series of Wagner & Lauga, "Crawling scallop" (arXiv 1303.2669), as published.
 *
 * A formula is a row of data: its text, and the claim of the text. paper.cfg has the paper's formulas, with their
 * printed mistakes; compare/ decides them. This folder does not use numerics/. */
#ifndef SCALLOP_ASYMPTOTICS_ASYMPTOTICS_H
#define SCALLOP_ASYMPTOTICS_ASYMPTOTICS_H

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The names in a formula. T is the duration of the phase in a formula about one phase, as in the paper's sections 4.3.1
 * and 4.3.2 and its appendices, and the period in a formula about the steady state. l0 and lT are l'' at the start and
 * the end of the phase times T^2, k0 and kT are l'''' there times T^4 (of the extension, in the steady state). Any
 * consistent units. */
#define SCALLOP_SYMBOL_LIST(SYMBOL) \
  SYMBOL(m1) \
  SYMBOL(m2) \
  SYMBOL(F1) \
  SYMBOL(F2) \
  SYMBOL(M)     /* m1 + m2                                                            */ \
  SYMBOL(L)     /* the amplitude                                                      */ \
  SYMBOL(L_kin) /* l0 lT/(2 (lT - l0)) of an extension, minus this expression of a contraction */ \
  SYMBOL(alpha) \
  SYMBOL(T) \
  SYMBOL(l0) \
  SYMBOL(lT) \
  SYMBOL(k0) \
  SYMBOL(kT) \
  SYMBOL(l_start) /* l at the start of the phase                                        */ \
  SYMBOL(l_end) \
  SYMBOL(v0) /* velocity of both bodies at the start                               */ \
  SYMBOL(t1) /* given: the first switching time, the lag of the last one, and the */ \
  SYMBOL(dT) /* position of the rear body there, from its start */ \
  SYMBOL(x_switch)
#define SCALLOP_SYMBOL_ENUM(name) SCALLOP_SYMBOL_##name,
enum scallop_symbol { SCALLOP_SYMBOL_LIST(SCALLOP_SYMBOL_ENUM) SCALLOP_SYMBOLS };
extern const char *const scallop_symbol_names[SCALLOP_SYMBOLS]; /* "m1", ... */

/* Values of the names */
struct scallop_values {
  double of[SCALLOP_SYMBOLS];
};

/* Returns the values for one phase of a crawler from v0; t1, dT and x_switch are nan. k0 and kT are nan if the gait has
 * no exact law. */
struct scallop_values scallop_phase_values(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                           double v0);
/* Returns the values for the steady state; v0, t1, dT and x_switch are nan. */
struct scallop_values scallop_steady_values(const struct scallop_crawler *crawler);

/* Returns the values of the same motion with the names of the bodies exchanged: a contraction becomes an extension. The
 * paper prints the formulas from rest for an extension only; the exchange yields the contraction. */
struct scallop_values scallop_exchanged(const struct scallop_values *values);
/* Returns the symbol that replaces another in this exchange; *sign is -1 if its sign changes, else 1. */
enum scallop_symbol scallop_symbol_exchanged(enum scallop_symbol symbol, int *sign);

/* The quantity of a formula: its name in a formula file, and its constant. "rear" is body 1 in an extension and
 * body 2 in a contraction, whichever body reverses; a formula file calls the displacements of the rear and the front
 * body by the number of the body: dx1, dx2. */
#define SCALLOP_QUANTITY_LIST(QUANTITY) \
  QUANTITY(dT, LAG)                      /* Delta T                                                            */ \
  QUANTITY(t1, FIRST_SWITCH)             /* t_1                                                                */ \
  QUANTITY(rear_at_first, REAR_AT_FIRST) /* position of the rear body at t_1, from its start                   */ \
  QUANTITY(rear_at_last, REAR_AT_LAST)   /* at T - Delta T                                                     */ \
  QUANTITY(rear_at_end, REAR_AT_END) \
  QUANTITY(front_at_end, FRONT_AT_END) \
  QUANTITY(dxC, CENTRE_AT_END) /* geometric centre (x1 + x2)/2, from its start                       */ \
  QUANTITY(v_end, VELOCITY_AT_END) \
  QUANTITY(v_change, VELOCITY_CHANGE)     /* v_end - v0                                                         */ \
  QUANTITY(v_at_first, VELOCITY_AT_FIRST) /* velocity of the body that reverses at t_1: 0 */ \
  QUANTITY(v_at_last, VELOCITY_AT_LAST)   /* velocity of the body that reverses at T - Delta T: 0 */ \
  QUANTITY(v_start, STEADY_VELOCITY)      /* velocity at the start of the extension */ \
  QUANTITY(v_mid, STEADY_V_MID)           /* velocity at the start of the contraction */ \
  QUANTITY(displacement, STEADY_DISPLACEMENT) \
  QUANTITY(mean_velocity, STEADY_MEAN_VELOCITY) \
  QUANTITY(friction_work, STEADY_FRICTION_WORK)
#define SCALLOP_QUANTITY_ENUM(word, NAME) SCALLOP_##NAME,
enum scallop_quantity { SCALLOP_QUANTITY_LIST(SCALLOP_QUANTITY_ENUM) SCALLOP_QUANTITIES };
extern const char *const scallop_quantity_words[SCALLOP_QUANTITIES]; /* "dT", ... */

enum scallop_setting { SCALLOP_AT_REST_START, SCALLOP_MOVING_EXTENSION, SCALLOP_MOVING_CONTRACTION, SCALLOP_STEADY };

/* The limits of the steady state for T -> 0: a body reverses in each phase, or no body reverses in one phase. */
enum scallop_turns { SCALLOP_TURNS_IN_BOTH, SCALLOP_NO_TURN_IN_CONTRACTION, SCALLOP_NO_TURN_IN_EXTENSION };

/* Instead of a remainder: the formula is printed as an equality. */
enum { SCALLOP_EQUALITY = -1 };

/* A name for a part of a formula, and its text */
struct scallop_part {
  const char *name, *text;
};

/* A formula, and its printed claim */
struct scallop_formula {
  const char *name;
  const char *equation;
  enum scallop_setting setting;
  enum scallop_quantity quantity;
  /* printed "+ O(T^remainder)"; 0: no printed remainder, and the table of claims skips the formula */
  int remainder;
  /* in the names of SCALLOP_SYMBOL_LIST and of its parts; formula.h has the language */
  const char *text;
  const struct scallop_part *parts; /* names for parts of the text; the last has name NULL. NULL: no parts */
  const char *const *when;          /* conditions of the claim: "alpha > 1/2", ..., NULL. NULL: no condition */
  const char *corrected;            /* name of the right formula if this one is wrong, else NULL */
  enum scallop_turns turns;         /* limit of a formula about the steady state */
};

/* The paper's formulas, in its order; the last has name NULL. */
extern const struct scallop_formula scallop_published[];
/* The right formulas for an extension, each for one or more wrong ones, listed in equation. A contraction is an
 * extension with the bodies exchanged. */
extern const struct scallop_formula scallop_corrected[];

/* Returns the formula of this name in these lists, or NULL. */
const struct scallop_formula *scallop_formula_named(const char *name);

/* Returns the value of a formula in double, from its text: for the phase of this kind from v0, with the given values of
 * t1, dT and x_switch (used by formulas that contain them), or for the steady state, independent of all five. A formula
 * that is printed for an extension is converted to a contraction by exchanging the bodies. nan: the text cannot be
 * read. */
double scallop_published_value(const struct scallop_formula *formula, const struct scallop_crawler *crawler,
                               enum scallop_phase_kind kind, double v0, double t1, double dT, double x_switch);

/* A user's formula is such a row with setting, text and, optionally, parts. A text consists of decimal numbers, names,
 * + - * / ^ and parentheses, with -2^2 = -4, 2^3^2 = 2^9 and 1/2/2 = 1/4. Names are the symbols of SCALLOP_SYMBOL_LIST
 * and the parts: a part's text is read as if in parentheses. pi is the number; abs sqrt exp log log10 sin cos asin are
 * functions of one argument in parentheses, min and max of two or more.
 *
 *     const struct scallop_formula mine = { .setting = SCALLOP_STEADY, .text = "-(F1 - F2)/M*T^2/8" };
 *     struct scallop_read_formula *read = scallop_formula_read(&mine, message);
 *
 * Once read, it can be evaluated many times, by several threads too: in double here, in balls by scallop_formula_ball
 * (asymptotics/derived/expansion.h). Nothing else in libscallop-core is allocated, except measured gaits. */
struct scallop_read_formula;
enum { SCALLOP_FORMULA_MESSAGE = 320 }; /* characters of a message and its NUL */

/* Reads copies of text and parts, for the setting. The caller frees the result by scallop_formula_free. NULL: message
 * describes the mistake and the character of the text, counted from 1, or of the part that it names ("character 6: '('
 * is not closed"), or memory is short. A formula of the steady state cannot contain v0, t1, dT and x_switch. A text has
 * at most 256 numbers, names and operations. */
struct scallop_read_formula *scallop_formula_read(const struct scallop_formula *formula,
                                                  char message[SCALLOP_FORMULA_MESSAGE]);
void scallop_formula_free(struct scallop_read_formula *read); /* NULL is allowed */

/* Returns true if the text, or a part that it uses, contains this symbol. */
bool scallop_formula_takes(const struct scallop_read_formula *read, enum scallop_symbol symbol);

/* Returns the value of scallop_published_value, to the last bit: each operation is rounded to the nearest double. The
 * crawler must pass scallop_crawler_check. nan or an infinity: a quotient, power or function is outside its domain, a
 * value is one, or k0 or kT of a gait without exact law is used. */
double scallop_formula_double(const struct scallop_read_formula *read, const struct scallop_crawler *crawler,
                              enum scallop_phase_kind kind, double v0, double t1, double dT, double x_switch);

#ifdef __cplusplus
}
#endif

#endif
