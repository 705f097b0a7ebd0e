/* The texts of formulas, read. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_PUBLISHED_READ_H
#define SCALLOP_ASYMPTOTICS_PUBLISHED_READ_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/formula.h"

/* Reads the text of a formula, which may use its parts; the place of a name is that in enum scallop_symbol. nearest,
 * which may be NULL: the one of names (NULL-terminated) that an unknown one resembles, or NULL. Returns NULL, or
 * `message` (formula_read). */
typedef const char *nearest_name(const char *name, const char *const *names);
const char *scallop_formula_text(struct formula *read, const struct scallop_formula *formula, nearest_name *nearest,
                                 char message[FORMULA_MESSAGE]);

/* Is the formula, for a phase of this kind, that of the other kind, with the bodies exchanged? */
bool scallop_formula_is_exchanged(const struct scallop_formula *formula, enum scallop_phase_kind kind);

/* The value of a formula that was read */
double scallop_formula_value(const struct formula *read, const struct scallop_formula *formula,
                             enum scallop_phase_kind kind, const struct scallop_values *values);

/* The sides of a condition "LEFT < RIGHT", each at its place: what is left of right is blank. Returns the < > or =
 * between them; '\0': there is none, or the condition is too long. */
enum { SCALLOP_CONDITION = 400 }; /* characters of a condition and its NUL */
struct scallop_sides {
  char left[SCALLOP_CONDITION], right[SCALLOP_CONDITION];
};
char scallop_condition_split(struct scallop_sides *sides, const char *condition);
/* Is it F1 = F2, or F2 = F1? */
bool scallop_condition_is_equal_forces(const char *condition);

/* Do all conditions hold under which the formula is claimed, in doubles? One that cannot be read does not. */
bool scallop_formula_is_claimed(const struct scallop_formula *formula, const struct scallop_values *values);

/* The value of a formula that was read, for the steady state or the phase of this kind; as scallop_published_value. */
double scallop_formula_at(const struct formula *read, const struct scallop_formula *formula,
                          const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0, double t1,
                          double dT, double x_switch);

/* What scallop_formula_read makes */
struct scallop_read_formula {
  struct formula operations;
  struct scallop_formula formula; /* its setting, and nothing else */
  char texts[];                   /* those that the operations refer to */
};

#endif
