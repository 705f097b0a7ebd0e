/* Formulas by name: the paper's, their corrections, and the formulas of the formula files that were read.
 *
 * A formula file is in libconfig's format; docs/reference/formulas.md lists its members. Formula files are read with
 * the options, before any computation, and stay until the program ends; after that all functions are thread-safe. */
#ifndef SCALLOP_COMPARE_FORMULAS_FORMULA_FILE_H
#define SCALLOP_COMPARE_FORMULAS_FORMULA_FILE_H

#include "asymptotics/published/read.h"
#include "compare/text/message.h"

/* A function that returns true if a formula must not have the name, because a quantity has it. */
typedef bool name_is_taken(const char *name);

/* Reads text if it is not NULL (path is then its name in messages), else the formula file at path, once. taken may be
 * NULL. Returns EXIT_DONE, or the exit code after a message on stderr with file, line and place in the formula. */
enum exit_code formula_file_read(const char *command, const char *path, const char *text, name_is_taken *taken);
/* Frees all formula files, for tests. Their formulas must not be in use. */
void formula_files_free(void);

/* The words of a formula file, NULL-terminated: quantities of one phase and, from place FORMULA_STEADY on, of the
 * steady state; starts of motions; phases. */
enum { FORMULA_STEADY = 11 };
extern const char *const formula_quantities[], *const formula_starts[], *const phase_names[];

/* A formula from options, called "formula": its text; words of these lists (start and phase may be NULL); and
 * the claim, a number or "equality". Returns EXIT_DONE, or the exit code after a message on stderr. */
struct formula_option {
  const char *text, *of, *start, *phase, *claimed;
};
enum exit_code user_formula_add(const char *command, const struct formula_option *given);

/* Return formula i = 0, 1, ..., or NULL after the last: of the formula files; of these and the paper's formulas without
 * a condition besides their start; of all formulas. */
const struct scallop_formula *user_formula(int i);
const struct scallop_formula *listed_formula(int i);
const struct scallop_formula *formula_at(int i);
/* Returns the first formula called name, or the only one of the formula files and the paper with the equation "(28)";
 * else NULL. */
const struct scallop_formula *formula_named(const char *name);
/* Returns true if list is "all", or names and equations between commas that include the formula called name. */
bool formula_is_listed(const char *list, const char *name);
/* Returns the end of the message "there is no formula 'NAME'": the formulas with that equation, or the nearest name.
 * Valid until the next call. */
const char *formula_hint(const char *name);

/* Checks that 1 to MAX_USER_FORMULAS formulas of the formula files apply to a command, by is_for; without any
 * --formulas FILE would have no effect. file: NULL without --formulas. Returns false after a message on stderr. */
enum { MAX_USER_FORMULAS = 24 };
typedef bool formula_is_for(const void *context, const struct scallop_formula *formula);
bool formula_file_applies(const char *command, const char *file, formula_is_for *is_for, const void *context,
                          const char *what);

/* Writes the place of the formula, "FILE:LINE: ", or "" if it is not in a file. Returns text. */
enum { FORMULA_PLACE = 200 };
const char *formula_place(char text[FORMULA_PLACE], const struct scallop_formula *formula);

/* Returns the parsed formula, parsed at the first call. NULL: out of memory. */
const struct formula *formula_read_once(const struct scallop_formula *formula);
/* Returns true if the text of the formula, or a part of it, uses the symbol. */
bool formula_takes(const struct scallop_formula *formula, enum scallop_symbol symbol);

/* For read.c: adds a formula to the list; user_formulas_free frees the struct that begins with it. Returns false
 * if memory is short. */
bool user_formula_keep(struct scallop_formula *formula);
const struct scallop_formula *user_formula_named(const char *name); /* or NULL */
void user_formulas_free(void);

#endif
