/* What the code under test says on standard error. */
#ifndef SCALLOP_TESTS_SUPPORT_SAID_H
#define SCALLOP_TESTS_SUPPORT_SAID_H

#include "tests/support/check.h"

#include <stdio.h>
#include <unistd.h>

enum { SAID_TEXT = 4096 };

struct said {
  FILE *file;
  int standard_error;
  char text[SAID_TEXT];
};

/* Between these two calls standard error goes to a file; the second puts what came there into text. */
static inline void said_begin(struct said *said)
{
  fflush(stderr);
  said->file = tmpfile();
  said->standard_error = dup(STDERR_FILENO);
  assert_true(said->file && said->standard_error >= 0);
  dup2(fileno(said->file), STDERR_FILENO);
}

static inline const char *said_end(struct said *said)
{
  fflush(stderr);
  dup2(said->standard_error, STDERR_FILENO);
  close(said->standard_error);
  rewind(said->file);
  said->text[fread(said->text, 1, SAID_TEXT - 1, said->file)] = '\0';
  fclose(said->file);
  return said->text;
}

#endif
