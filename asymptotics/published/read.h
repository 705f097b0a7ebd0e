/* Formulas and conditions read from their texts. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_PUBLISHED_READ_H
#define SCALLOP_ASYMPTOTICS_PUBLISHED_READ_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/formula.h"

/* Reads the text of a formula, including its parts; the index of a name is its enum scallop_symbol. nearest: returns
 * the most similar of names (NULL-terminated) to an unknown one, or NULL; may be NULL. Returns NULL, or `message`
 * (formula_read). */
typedef const char *nearest_name(const char *name, const char *const *names);
const char *scallop_formula_text(struct formula *read, const struct scallop_formula *formula, nearest_name *nearest,
                                 char message[FORMULA_MESSAGE]);

/* Returns true if a formula about the other kind of phase is evaluated for this kind, with the bodies exchanged. */
bool scallop_formula_is_exchanged(const struct scallop_formula *formula, enum scallop_phase_kind kind);

/* Returns the value of a formula that was read. */
double scallop_formula_value(const struct formula *read, const struct scallop_formula *formula,
                             enum scallop_phase_kind kind, const struct scallop_values *values);

/* Splits a condition "LEFT < RIGHT", with each side at its original position. Returns the < > or = between them, '\0'
 * if it is missing or the condition is too long. */
enum { SCALLOP_CONDITION = 400 }; /* characters of a condition and its NUL */
struct scallop_sides {
  char left[SCALLOP_CONDITION], right[SCALLOP_CONDITION];
};
char scallop_condition_split(struct scallop_sides *sides, const char *condition);
/* Returns true if the condition is F1 = F2 or F2 = F1. */
bool scallop_condition_is_equal_forces(const char *condition);

/* Returns true if all conditions of the formula hold in doubles. A condition that cannot be read does not hold. */
bool scallop_formula_is_claimed(const struct scallop_formula *formula, const struct scallop_values *values);

/* Returns scallop_published_value of a formula that was read. */
double scallop_formula_at(const struct formula *read, const struct scallop_formula *formula,
                          const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0, double t1,
                          double dT, double x_switch);

/* The result of scallop_formula_read */
struct scallop_read_formula {
  struct formula operations;
  struct scallop_formula formula; /* its setting only */
  char texts[];                   /* texts that the operations refer to */
};

#endif
