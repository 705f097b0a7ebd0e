/* Plots that the tests draw, and what is in them. */
#ifndef PICTURES_H
#define PICTURES_H

#include "compare/command/plot.h"
#include "tests/said.h"
#include "tests/scratch_folder.h"

static const char *const y_only[] = { "y", NULL }, *const two[] = { "y", "z", NULL };

static inline void read_picture(char *text, size_t size, const char *name)
{
  FILE *file = fopen(name, "r");
  assert_non_null(file);
  text[fread(text, 1, size - 1, file)] = '\0';
  fclose(file);
}

static inline void draws(const struct plot *plot)
{
  struct said said;
  int before = lowest_free();
  said_begin(&said);
  bool drawn = plot_draw(plot, "run");
  said_end(&said);
  if (!drawn)
    fail_msg("%s", said.text);
  assert_string_equal(said.text, "");
  assert_int_equal(lowest_free(), before);
}

static inline void assert_in(const char *text, const char *part)
{
  if (!strstr(text, part))
    fail_msg("no '%s' in\n%s", part, text);
}

#endif
