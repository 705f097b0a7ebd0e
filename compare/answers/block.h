/* Blocks: steady states of neighbouring points of a sweep, solved together; same rows as one by one, but faster. */
#ifndef SCALLOP_COMPARE_ANSWERS_BLOCK_H
#define SCALLOP_COMPARE_ANSWERS_BLOCK_H

#include "compare/answers/rows.h"

enum { BLOCK_ROWS = 1024 };

/* Returns NULL if memory is short, or if a column is not a parameter, a quantity of the steady state, its regime,
 * modes or status. */
struct block *block_new(const struct rows *rows);
void block_free(struct block *block);
/* Writes the rows of up to BLOCK_ROWS points. Returns false, with nothing written, if a point has no answer: its row
 * states the reason, and the points are solved one by one. */
bool block_rows(struct block *block, struct rows *rows, struct at *at, struct sweep_walk *walk, long first, int count);

#endif
