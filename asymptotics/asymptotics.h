/* asymptotics/: the series of Wagner & Lauga, "Crawling scallop" (arXiv 1303.2669), as published.
 *
 * A formula is a row of data: its text, and what the text claims. The paper's are those of paper.cfg, printed mistakes
 * included: what a formula is worth is for compare/ to decide. Never looks at numerics/.
 */
#ifndef SCALLOP_ASYMPTOTICS_ASYMPTOTICS_H
#define SCALLOP_ASYMPTOTICS_ASYMPTOTICS_H

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The names in a formula. T is the duration of the phase in a formula about one, as in the paper's sections 4.3.1 and
 * 4.3.2 and its appendices, and the period in one about the steady state; l0 and lT, k0 and kT are the second and the
 * fourth derivative of l at the start and at the end of the phase (of the extension, in the steady state), times T^2
 * and T^4. Any consistent units. */
#define SCALLOP_SYMBOL_LIST(SYMBOL) \
  SYMBOL(m1) \
  SYMBOL(m2) \
  SYMBOL(F1) \
  SYMBOL(F2) \
  SYMBOL(M)     /* m1 + m2                                                            */ \
  SYMBOL(L)     /* the amplitude                                                      */ \
  SYMBOL(L_kin) /* l0 lT/(2 (lT - l0)) of an extension, minus that of a contraction   */ \
  SYMBOL(alpha) \
  SYMBOL(T) \
  SYMBOL(l0) \
  SYMBOL(lT) \
  SYMBOL(k0) \
  SYMBOL(kT) \
  SYMBOL(l_start) /* l at the start of the phase                                        */ \
  SYMBOL(l_end) \
  SYMBOL(v0) /* velocity of both bodies at the start                               */ \
  SYMBOL(t1) /* given: the first switching time, the lag of the last one, and the    */ \
  SYMBOL(dT) /* position of the rear body there, from its start                    */ \
  SYMBOL(x_switch)
#define SCALLOP_SYMBOL_ENUM(name) SCALLOP_SYMBOL_##name,
enum scallop_symbol { SCALLOP_SYMBOL_LIST(SCALLOP_SYMBOL_ENUM) SCALLOP_SYMBOLS };
extern const char *const scallop_symbol_names[SCALLOP_SYMBOLS];

/* What the names stand for */
struct scallop_values {
  double of[SCALLOP_SYMBOLS];
};

/* Of one phase of a crawler from v0, and of its steady state; t1, dT and x_switch, and v0 of the steady state, are nan.
 * k0 and kT are nan where the gait has no exact law. */
struct scallop_values scallop_phase_values(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                           double v0);
struct scallop_values scallop_steady_values(const struct scallop_crawler *crawler);

/* The same motion with the names of the bodies exchanged: a contraction becomes an extension. The paper prints the
 * formulas from rest for an extension only; this carries them to a contraction. */
struct scallop_values scallop_exchanged(const struct scallop_values *values);
/* The symbol that stands in the place of another then; *sign becomes -1 if its sign changes, else 1. */
enum scallop_symbol scallop_symbol_exchanged(enum scallop_symbol symbol, int *sign);

/* What a formula gives: the word for it in a formula file, and the constant. "rear" is body 1 in an extension and 2
 * in a contraction, whichever body turns; a book calls its position at the end, and that of the other body, by the
 * number of the body: dx1, dx2. */
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
  QUANTITY(v_at_first, VELOCITY_AT_FIRST) /* of the body that turns at t_1: 0                                    */ \
  QUANTITY(v_at_last, VELOCITY_AT_LAST)   /* of the body that turns at T - Delta T: 0                            */ \
  QUANTITY(v_start, STEADY_VELOCITY)      /* at the start of the extension                                      */ \
  QUANTITY(v_mid, STEADY_V_MID)           /* of the contraction                                                 */ \
  QUANTITY(displacement, STEADY_DISPLACEMENT) \
  QUANTITY(mean_velocity, STEADY_MEAN_VELOCITY) \
  QUANTITY(friction_work, STEADY_FRICTION_WORK)
#define SCALLOP_QUANTITY_ENUM(word, NAME) SCALLOP_##NAME,
enum scallop_quantity { SCALLOP_QUANTITY_LIST(SCALLOP_QUANTITY_ENUM) SCALLOP_QUANTITIES };
extern const char *const scallop_quantity_words[SCALLOP_QUANTITIES];

enum scallop_setting { SCALLOP_AT_REST_START, SCALLOP_MOVING_EXTENSION, SCALLOP_MOVING_CONTRACTION, SCALLOP_STEADY };

/* For which limit of the steady state a formula is: one in which a body turns in both phases, or one in which none
 * turns in one. */
enum scallop_turns { SCALLOP_TURNS_IN_BOTH, SCALLOP_NO_TURN_IN_CONTRACTION, SCALLOP_NO_TURN_IN_EXTENSION };

/* In the place of the remainder: the formula is printed as an equality. */
enum { SCALLOP_EQUALITY = -1 };

struct scallop_part {
  const char *name, *text;
};

struct scallop_formula {
  const char *name;
  const char *equation;
  enum scallop_setting setting;
  enum scallop_quantity quantity;
  int remainder; /* printed "+ O(T^remainder)"; 0: none is printed, and the table of claims passes the formula over */
  const char *text; /* in the names of SCALLOP_SYMBOL_LIST and of its parts; formula.h has the language   */
  const struct scallop_part *parts; /* names for parts of the text; the last has name NULL. NULL: none        */
  const char *const *when;          /* where it is claimed: "alpha > 1/2", ..., NULL. NULL: under no other condition */
  const char *corrected;            /* where it is wrong: the name of the right one, or NULL                        */
  enum scallop_turns turns;         /* of a steady state                                                   */
};

/* The paper's formulas, in its order; the last has name NULL. */
extern const struct scallop_formula scallop_published[];
/* What should stand in place of those that are wrong, for an extension: a contraction is one with the bodies exchanged.
 * equation: what they replace. */
extern const struct scallop_formula scallop_corrected[];

/* The one of this name in these lists, or NULL. */
const struct scallop_formula *scallop_formula_named(const char *name);

/* The value of a formula in double, from its text: for the phase of this kind from v0, with these values for t1, dT and
 * x_switch (read by the formulas that take them as given), or for the steady state, which looks at none of them. A
 * formula that is printed for an extension is carried to a contraction by exchanging the bodies. nan: the text is not
 * one that can be read. */
double scallop_published_value(const struct scallop_formula *formula, const struct scallop_crawler *crawler,
                               enum scallop_phase_kind kind, double v0, double t1, double dT, double x_switch);

/* A formula of one's own is such a row with setting, text and, where it has them, parts. A text is of decimal numbers,
 * names, + - * / ^ and parentheses, with -2^2 = -4, 2^3^2 = 2^9 and 1/2/2 = 1/4. Names are those of SCALLOP_SYMBOL_LIST
 * and of the parts, whose texts are read in their place as if in parentheses; pi is the number; abs sqrt exp log log10
 * sin cos asin are functions of one argument in parentheses, min and max of two or more.
 *
 *     const struct scallop_formula mine = { .setting = SCALLOP_STEADY, .text = "-(F1 - F2)/M*T^2/8" };
 *     struct scallop_read_formula *read = scallop_formula_read(&mine, message);
 *
 * Read once, it is evaluated as often as needed, by several threads too: in double here, in balls by
 * scallop_formula_ball (asymptotics/derived/expansion.h). It is the one thing in libscallop-core that is allocated. */
struct scallop_read_formula;
enum { SCALLOP_FORMULA_MESSAGE = 320 }; /* characters of a message and its NUL */

/* Reads copies of text and parts, for the setting; to be freed by scallop_formula_free. NULL: message says what is
 * wrong and at which character of the text, counted from 1, or of the part that it names ("character 6: '(' is not
 * closed"); or that there is no memory. In a formula of the steady state v0, t1, dT and x_switch have no meaning and
 * are refused. A text has at most 256 numbers, names and operations. */
struct scallop_read_formula *scallop_formula_read(const struct scallop_formula *formula,
                                                  char message[SCALLOP_FORMULA_MESSAGE]);
void scallop_formula_free(struct scallop_read_formula *read); /* which may be NULL */

/* Does the text, or a part that it uses, have this symbol? */
bool scallop_formula_takes(const struct scallop_read_formula *read, enum scallop_symbol symbol);

/* The value as scallop_published_value has it, to the last bit: each operation is rounded to the nearest double. The
 * crawler is one that scallop_crawler_check accepts. nan or an infinity: a quotient, power or function outside its
 * domain, a value that is one, or k0 and kT of a gait without exact law. */
double scallop_formula_double(const struct scallop_read_formula *read, const struct scallop_crawler *crawler,
                              enum scallop_phase_kind kind, double v0, double t1, double dT, double x_switch);

#ifdef __cplusplus
}
#endif

#endif
