/* What the command line asks of breakdown, in words. */
#ifndef SCALLOP_BREAKDOWN_ASKED_H
#define SCALLOP_BREAKDOWN_ASKED_H

#include "compare/breakdown/breakdown.h"

const char *breakdown_source_text(enum breakdown_source source);
/* The quantity of that name that has series, of the steady state or of one phase. False: there is none, and the message is on stderr. */
bool breakdown_quantity_read(enum quantity_id *quantity, const char *name, enum quantity_of of);
/* Do the options go together? False: the message is on stderr. */
bool breakdown_is_sound(const struct breakdown_options *options, enum quantity_of of);

#endif
