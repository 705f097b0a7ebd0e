/* The cheapest setting for each wanted error. */
#ifndef SCALLOP_WORKPREC_SUMMARY_H
#define SCALLOP_WORKPREC_SUMMARY_H

#include "compare/text/table.h"
#include "compare/workprec/setting.h"

extern const char *const summary_columns[];
/* The rows of one reference: for each wanted error that some setting reaches. */
void summary_write(struct table *table, const struct settings *settings);

#endif
