/* Steady states of neighbouring points of a sweep, solved together: the same rows, many times as fast. */
#ifndef SCALLOP_COMPARE_ANSWERS_BLOCK_H
#define SCALLOP_COMPARE_ANSWERS_BLOCK_H

#include "compare/answers/rows.h"

enum { BLOCK_ROWS = 1024 };

/* NULL: some column is none of these: a parameter, a quantity of the steady state, its regime, modes or status; or
 * there is no memory. */
struct block *block_new(const struct rows *rows);
void block_free(struct block *block);
/* Writes the rows of up to BLOCK_ROWS points. False: nothing is written, as one of them has no answer, whose reason
 * stands in its row: they go one by one. */
bool block_rows(struct block *block, struct rows *rows, struct at *at, struct sweep_walk *walk, long first, int count);

#endif
