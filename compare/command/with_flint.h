/* What the commands ask of the parts that need FLINT.
 *
 * `scallop` is linked without FLINT, so that a command that needs none does not load it. A command that does is handed
 * over to `scallop-flint`, the same program linked with it, which stands beside (hand_over.c). A build with
 * WITH_FLINT=0 has no such program, and these commands print what is missing. A function that needs FLINT is weak where
 * a command calls it: `scallop` is linked without it, and calls it only where has_flint. */
#ifndef SCALLOP_COMPARE_COMMAND_WITH_FLINT_H
#define SCALLOP_COMPARE_COMMAND_WITH_FLINT_H

#include <stdbool.h>

/* True: FLINT is here, go on. Where it is not, the other program takes over and this does not return; or, if there is
 * none, false, with the message on stderr. To be called before anything is read or written. what needs it:
 * "--certified"; NULL: it may be needed, and without the other program there is no message. */
struct arguments;
bool has_flint(const struct arguments *arguments, const char *what);

/* Before a file is read: standard input, or a pipe, which is read once, is left to the other program where there is
 * one. */
void hand_over_before(const struct arguments *arguments, const char *path);

#endif
