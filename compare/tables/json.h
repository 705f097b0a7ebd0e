/* Rows of a table in JSON lines. */
#ifndef SCALLOP_COMPARE_TABLES_JSON_H
#define SCALLOP_COMPARE_TABLES_JSON_H

struct json_member {
  char *name, *value;
};
/* Splits a line, a JSON object of texts, numbers, true, false and null ("") into its members, at most `most`, in place.
 * NULL, or what is wrong with the line. */
const char *json_split(char *line, struct json_member *members, int *count, int most);

#endif
