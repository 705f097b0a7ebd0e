/* A cell of a table. */
#ifndef SCALLOP_COMPARE_TEXT_CELL_H
#define SCALLOP_COMPARE_TEXT_CELL_H

#include <stddef.h>

/* A cell of a row: a number, a number as it stands, a text, or a cell of another table */
enum cell_kind { CELL_NUMBER, CELL_DIGITS, CELL_TEXT, CELL_CARRIED };
struct table_cell {
  enum cell_kind kind;
  double value; /* of a number; nan: only the text says it */
  char *text;   /* of all but CELL_NUMBER */
  size_t room;  /* of text                */
};

#endif
