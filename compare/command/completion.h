/* Completion of what is typed in a shell, from what --help tells. */
#ifndef SCALLOP_COMPLETION_H
#define SCALLOP_COMPLETION_H

#include <stdio.h>

/* Writes a script for bash 3.2 or later, which needs nothing but bash. */
void completion_script(FILE *to);

#endif
