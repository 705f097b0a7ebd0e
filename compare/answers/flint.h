/* The part of the program that needs FLINT: derived series, certified numbers and the table of claims.
 *
 * It is a shared object, scallop-flint.so, beside the program or in ../lib/scallop. It is loaded when a command first
 * needs it, because loading FLINT takes longer than most commands do. It takes all other functions from the program
 * and exports one table. A build with WITH_FLINT=0 has no such file. */
#ifndef SCALLOP_COMPARE_ANSWERS_FLINT_H
#define SCALLOP_COMPARE_ANSWERS_FLINT_H

#include "compare/text/message.h"

struct request;
struct rows;
struct series_options;
struct claims_options;
struct workprec_options;
struct breakdown_options;
struct stress_options;
extern const struct flint_part {
  const char *version; /* must equal SCALLOP_VERSION of the program */
  enum exit_code (*series_report)(const struct series_options *options);
  enum exit_code (*claims_table)(const struct claims_options *options);
  enum exit_code (*workprec_table)(const struct workprec_options *options);
  enum exit_code (*breakdown_table)(const struct breakdown_options *options);
  const char *(*breakdown_map)(const struct breakdown_options *options, struct rows *rows);
  enum exit_code (*breakdown_boundaries)(const struct breakdown_options *options);
  const char *(*breakdown_page)(struct rows *rows);
  const char *(*summary_plan)(struct rows *rows);
  enum exit_code (*stress_table)(const struct stress_options *options);
  enum exit_code (*stress_point)(const struct stress_options *options);
  enum exit_code (*stress_stiff)(const struct stress_options *options);
} flint_part; /* in part_flint.c; other files call load_flint */

/* Loads and returns the table; then quantities that need FLINT are available (answers/at.h). what, "--certified", is
 * named in the message. Returns NULL after a message on stderr. Must be called before any output. */
const struct flint_part *load_flint(const char *command, const char *what);

#endif
