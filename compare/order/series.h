/* Tables of h and err as files hold them: series, each one column y against x, and the rows with the same texts left of
 * x. */
#ifndef SCALLOP_COMPARE_ORDER_SERIES_H
#define SCALLOP_COMPARE_ORDER_SERIES_H

#include "asymptotics/observed/order.h"
#include "compare/order/columns.h"
#include "compare/text/message.h"

enum { MOST_SERIES = 4096, MOST_ROWS = 1000000 };

struct series {
  const char *file; /* as it is called in messages                                              */
  char *name;       /* the texts left of x, joined; "" where there are none                     */
  char *y;          /* the column                                                              */
  bool values;      /* it holds values                                                         */
  bool unread;      /* the file could not be read: result.reason says why                      */
  struct scallop_order_point *points;
  int count;
  struct scallop_order_result result;
};

struct series_list {
  struct series *series;
  int count;
  long rows; /* of all of them                                                          */
};

/* Adds the series of a file ('-': standard input). Of a file that cannot be read, or is no table, it adds one series
 * without rows that is unread, and the message of command is on stderr. */
enum exit_code series_read(struct series_list *list, const char *command, const char *file,
                           const struct columns_wanted *wanted);
void series_free(struct series_list *list);

#endif
