/* What the fuzz targets share.
 *
 * A target, fuzz_NAME.c, takes any bytes, gives them to one part of the toolkit, and judges what comes back: fuzz_fail
 * says what is wrong and aborts. `make fuzz` links it with libFuzzer, which makes the bytes; `make check` with
 * replay.c, which takes them from the files of tests/corpus/NAME/: seeds, and whatever failed once (past-...). */
#ifndef SCALLOP_TESTS_FUZZ_TARGET_H
#define SCALLOP_TESTS_FUZZ_TARGET_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <string.h>

#include "compare/command/commands.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

void fuzz_fail(const char *format, ...) __attribute__((format(printf, 1, 2), noreturn));

static inline bool same_bits(double a, double b)
{
  uint64_t x, y;
  memcpy(&x, &a, sizeof x);
  memcpy(&y, &b, sizeof y);
  return x == y;
}

/* Every byte is still UNTOUCHED, as memset had it. */
enum { UNTOUCHED = 0xa5 };
static inline bool untouched(const void *data, size_t size)
{
  const unsigned char *bytes = data;
  for (size_t i = 0; i < size; i++)
    if (bytes[i] != UNTOUCHED)
      return false;
  return true;
}

/* The bytes with a NUL after them, in memory that ends there; to be freed. */
char *fuzz_text(const uint8_t *data, size_t size);

/* The name of a file that holds these bytes until the next call. */
const char *fuzz_file(const uint8_t *data, size_t size);

/* What a command has written. */
struct written {
  char *out, *err; /* NUL-terminated */
  size_t out_size, err_size;
};
/* Between these two calls standard output and standard error are memory. */
void written_begin(struct written *written);
void written_end(struct written *written);
void written_free(struct written *written);
/* The end where something was read, which is done, or comes with a message and nothing else; frees what was written. */
void written_end_read(struct written *written, int code);

/* Runs a command with these arguments, NULL-terminated, the command's name left out. Returns its exit code. */
int fuzz_run(const struct command *command, const char *const *arguments, struct written *written);

/* Judges a command's output by itself: a refusal comes with a message and nothing else; a table is of printable ASCII,
 * tabs and newlines, its rows have the columns of the header, its JSON is JSON. Returns the number of rows. */
long fuzz_judge_table(const struct written *written, int code, enum format format);

#endif
