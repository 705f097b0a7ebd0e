/* Reading of rows in JSON lines. */
#ifndef SCALLOP_COMPARE_TABLES_JSON_H
#define SCALLOP_COMPARE_TABLES_JSON_H

struct json_member {
  char *name, *value;
};
/* Splits a line, a JSON object of texts, numbers, true, false and null (""), in place into at most `max` members.
 * Returns NULL or the error of the line. */
const char *json_split(char *line, struct json_member *members, int *count, int max);

#endif
