/* The pages of the manual, from what --help tells. A page is called scallop, or scallop-COMMAND. */
#ifndef SCALLOP_MAN_H
#define SCALLOP_MAN_H

#include <stdbool.h>
#include <stdio.h>

/* Writes the page called name in the macros of man(7): "scallop", a command, or "scallop-" and a command; or, called "list",
 * the names of all pages, one a line. False: there is none of that name. */
bool man_page(FILE *to, const char *name);

/* The name of the command that a page of that name is about: what follows "scallop-", or all of it. */
const char *man_subject(const char *name);

#endif
