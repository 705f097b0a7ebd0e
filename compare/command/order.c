/* Options of `scallop order`. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/columns/columns.h"
#include "compare/command/commands.h"
#include "compare/order/order.h"

struct order_options {
  struct request request;
  struct expected_orders orders;
  struct optional_number tolerance;
  struct order_columns columns;
  struct optional_word format;
  bool rows;
};
_Static_assert(sizeof(struct order_options) <= sizeof((struct arguments *)NULL)->options,
               "the options fit into struct arguments");

/* Reads "2", "2,3/2" or "L2=2,H1=1". */
static const char *read_orders(void *options, const struct option *o, const char *text)
{
  struct expected_orders *orders = (struct expected_orders *)((char *)options + o->field);
  static char item[NUMBER_LENGTH + COLUMN_NAME + 2];
  const char *rest = text, *at = text;
  orders->count = 0;
  orders->at_least = strcmp(o->name, "at-least") == 0;
  for (; next_item(item, sizeof item, &rest); at = rest) {
    const char *number = strrchr(item, '=');
    const int n = orders->count++, length = number ? (int)(number - item) : 0;
    if (n == MAX_ORDERS || length >= COLUMN_NAME)
      return n == MAX_ORDERS ? "more than 32 orders" : "a name is too long";
    orders->of[n].name = number ? at + strspn(at, " ") : NULL;
    orders->of[n].length = length;
    orders->of[n].order = text_number(number ? number + 1 : item);
    if (!isfinite(orders->of[n].order))
      return no_number(number ? number + 1 : item, o->allowed);
    if (!orders->of[n].name != !orders->of[0].name)
      return "either each order has the name of its column, or none has";
  }
  return orders->count > 0 ? NULL : no_number(text, o->allowed);
}

/* Reads "cells", "cells:DIM" or "dofs:DIM". */
static const char *read_per(void *options, const struct option *o, const char *text)
{
  struct order_columns *columns = (struct order_columns *)((char *)options + o->field);
  const char *colon = strchr(text, ':');
  const size_t length = colon ? (size_t)(colon - text) : strlen(text);
  const bool is_cells = length == 5 && strncmp(text, "cells", length) == 0;
  long dimension = 1;
  if ((!is_cells && (length != 4 || strncmp(text, "dofs", length) != 0 || !colon))
      || (colon && !read_count(colon + 1, 1, 9, &dimension)))
    return not_allowed(text, o->allowed);
  columns->power = -1 / (double)dimension;
  return NULL;
}

/* Reads --y; each one adds columns. */
static const char *read_columns(void *options, const struct option *o, const char *text)
{
  struct order_columns *columns = (struct order_columns *)((char *)options + o->field);
  if (*text == '\0' || columns->lists == MAX_LISTS)
    return *text == '\0' ? "it takes columns, separated by commas" : "not more than 16 times";
  columns->y[columns->lists++] = text;
  return NULL;
}

#define OPTION_ORDER(name) \
  OPTION(name, read_orders, OPTION_FIELD(order_options, orders), \
         .allowed = "a finite number, or a fraction such as 3/2")
static const struct option options_of_order[] = {
  OPTION_ORDER("expect"),
  OPTION_ORDER("at-least"),
  OPTION_NUMBER("tol", order_options, tolerance, POSITIVE),
  OPTION_TEXT("x", order_options, columns.x, "a column"),
  OPTION("per", read_per, OPTION_FIELD(order_options, columns), .allowed = "cells, cells:DIMENSION or dofs:DIMENSION"),
  OPTION("y", read_columns, OPTION_FIELD(order_options, columns)),
  OPTION_FLAG("values", order_options, columns.values),
  OPTION_FLAG("rows", order_options, rows),
  OPTION_FLAG("require-measured", order_options, orders.required),
  OPTION_WORD("format", order_options, format, report_formats),
  OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS),
  OPTIONS_PLOT,
  OPTIONS_LAST,
};
static const struct option_rule rules[] = {
  { "expect", RULE_WITH, "at-least", "and --at-least exclude each other" },
  { NULL, RULE_WITH, NULL, NULL },
};
static const struct order_options initial = { .tolerance = { 0.1, false }, .format = { "tsv", false } };

static int format_of(const struct order_options *o) { return word_place(o->format.value, report_formats); }

static const char *complete(void *options)
{
  const struct order_options *o = options;
  bool is_table = format_of(o) < FORMATS;
  if (!is_table && o->request.style.choice)
    return wrong_text("--columns is for tables, and '%s' is none", o->format.value);
  return is_table || !o->rows ? NULL : wrong_text("--rows: '%s' is a format for verdicts", o->format.value);
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct order_options *o = options;
  struct series_list list = { 0 };
  struct expected_orders orders = o->orders;
  struct order_columns columns = o->columns;
  orders.tolerance = o->tolerance.value;
  columns.orders = &orders;
  columns.quiet = o->request.style.quiet;
  enum exit_code read = EXIT_DONE;
  for (int i = 0; i < arguments->operand_count; i++) {
    enum exit_code code = series_read(&list, arguments->operands[i], &columns);
    read = code > read ? code : read;
  }
  series_judge(&list, &orders);
  const int format = format_of(o);
  const bool draws = !o->rows && o->request.style.plot.file && list.rows > 0;
  struct style style = o->request.style, to_draw = style;
  style.format = format < FORMATS ? (enum format)format : FORMAT_TSV;
  style.has_format = o->format.given;
  style.plot.file = o->rows ? style.plot.file : NULL; /* the rows are drawn, not the verdicts */
  to_draw.output = "/dev/null";
  enum exit_code code = o->rows ? report_rows(&list, &style) : report_write(&list, &orders, &style, format);
  if (code == EXIT_DONE && draws)
    code = report_rows(&list, &to_draw);
  if (code == EXIT_DONE)
    code = report_exit(&list, &orders, style.output != NULL);
  series_free(&list);
  return read > code ? read : code;
}

const struct command command_order = {
  .name = "order",
  .operand = "FILE...",
  .options = options_of_order,
  .rules = rules,
  .size = sizeof(struct order_options),
  .initial = &initial,
  .complete = complete,
  .run = run,
};
