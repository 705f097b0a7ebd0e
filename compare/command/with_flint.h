/* What the commands ask of the parts that need FLINT.
 *
 * `scallop` is linked without FLINT, so that a command that needs none does not load it. A command that does is handed over to
 * `scallop-flint`, the same program linked with it, which stands beside (hand_over.c). A build with WITH_FLINT=0 has no such
 * program, and these commands print what is missing. */
#ifndef SCALLOP_WITH_FLINT_H
#define SCALLOP_WITH_FLINT_H

#include <stdbool.h>

/* True: FLINT is here, go on. Where it is not, the other program takes over and this does not return; or, if there is none, false,
 * with the message on stderr. To be called before anything is read or written. what needs it: "--certified"; NULL: it may be needed, and
 * without the other program there is no message. */
struct arguments;
bool has_flint(const struct arguments *arguments, const char *what);

/* To be called where has_flint: `scallop` is linked without them, and their addresses are NULL there. */
#pragma weak flint_cleanup
#pragma weak answer_in_decimals
#pragma weak decimals_free
#pragma weak series_derived
#pragma weak claims_table
#pragma weak workprec_table
#pragma weak stress_table
#pragma weak stress_point
#pragma weak stress_stiff
#pragma weak breakdown_table
#pragma weak breakdown_map
#pragma weak breakdown_boundaries

#endif
