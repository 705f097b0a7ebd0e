/* Formulas by name: the paper's, those that hold where one of the paper's does not, and those of the formula files
 * that were read.
 *
 * A formula file is in libconfig's format; docs/reference/formulas.md has its members. Formula files are read with the
 * options, before anything is computed, and stay for as long as the program runs; after that any thread may ask. */
#ifndef SCALLOP_COMPARE_FORMULAS_FORMULA_FILE_H
#define SCALLOP_COMPARE_FORMULAS_FORMULA_FILE_H

#include "asymptotics/published/read.h"
#include "compare/text/message.h"

/* Is the name that of something else, in whose place the formula would stand? */
typedef bool name_is_taken(const char *name);

/* Reads the formula file at path, once, or, where it is not NULL, a text, which is called path in messages. The
 * message of what is wrong is on stderr: FILE:LINE: and the place in the formula. taken: may be NULL. */
enum exit_code formula_file_read(const char *command, const char *path, const char *text, name_is_taken *taken);
/* Forgets all formula files: for tests. No formula of theirs may be in use. */
void formula_files_forget(void);

/* The words of a formula file, NULL-terminated: what formulas give, of one phase and, from place FORMULA_STEADY on, of
 * the steady state; where motions start; and the phases. */
enum { FORMULA_STEADY = 11 };
extern const char *const formula_quantities[], *const formula_starts[], *const phase_names[];

/* A formula by itself, "formula", as options give it: its text; words of these lists, where start and phase may be
 * NULL; and the claim, a number or "equality". What is wrong is on stderr. */
struct formula_given {
  const char *text, *of, *start, *phase, *claimed;
};
enum exit_code user_formula_add(const char *command, const struct formula_given *given);

/* The formula at place i, or NULL, there are no more: of those of the formula files that were read; of these and those
 * of the paper's that are claimed under no other condition than their start; of all. */
const struct scallop_formula *user_formula(int i);
const struct scallop_formula *listed_formula(int i);
const struct scallop_formula *formula_at(int i);
/* The first of this name, or the only one of the formula files and of the paper that has this equation, "(28)"; else
 * NULL. */
const struct scallop_formula *formula_named(const char *name);
/* Is the formula called name one of a list, separated by commas, of such names and equations, or is the list "all"? */
bool formula_is_listed(const char *list, const char *name);
/* What is wrong with a name by which there is no formula, behind "there is no formula 'NAME'": which ones have the
 * equation, or which name is near. Until the next call. */
const char *formula_instead(const char *name);

/* Are formulas of the formula files for this, of which a command takes MAX_USER_FORMULAS? False: none is, so that
 * --formulas FILE would have no effect, or more are, and the message is on stderr. file: NULL, there is no --formulas.
 */
enum { MAX_USER_FORMULAS = 24 };
typedef bool formula_is_for(const void *context, const struct scallop_formula *formula);
bool formula_file_serves(const char *command, const char *file, formula_is_for *is_for, const void *context,
                         const char *what);

/* Where the formula stands, "FILE:LINE: ", in text, which is returned; "" where it is in no file. */
enum { FORMULA_PLACE = 200 };
const char *formula_place(char text[FORMULA_PLACE], const struct scallop_formula *formula);

/* Its text, read when it is first asked for. NULL: out of memory. */
const struct formula *formula_read_once(const struct scallop_formula *formula);
/* Does its text, or a part of it, use the symbol? */
bool formula_takes(const struct scallop_formula *formula, enum scallop_symbol symbol);

/* For read.c, which has the files: keeps a formula, which forget_user_formulas frees with what it is the first member
 * of. False: out of memory. */
bool user_formula_keep(struct scallop_formula *formula);
const struct scallop_formula *user_formula_named(const char *name); /* or NULL */
void forget_user_formulas(void);

#endif
