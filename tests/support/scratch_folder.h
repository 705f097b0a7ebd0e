/* An empty folder for tests that write files: it is the current one while they run, and is removed after them. */
#ifndef SCALLOP_TESTS_SUPPORT_SCRATCH_FOLDER_H
#define SCALLOP_TESTS_SUPPORT_SCRATCH_FOLDER_H

#include "tests/support/check.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static char scratch_folder[] = "/tmp/scallop-test-XXXXXX";

static inline void write_text(const char *name, const char *text)
{
  FILE *file = fopen(name, "w");
  assert_non_null(file);
  fputs(text, file);
  fclose(file);
}

/* What is in the file, which must be there; as much as fits. Returns how many bytes. */
static inline size_t read_text(const char *name, char *text, size_t size)
{
  FILE *file = fopen(name, "r");
  assert_non_null(file);
  size_t length = fread(text, 1, size - 1, file);
  fclose(file);
  text[length] = '\0';
  return length;
}

/* The file holds this text and nothing else. */
static inline void assert_holds(const char *name, const char *text)
{
  char got[8192];
  read_text(name, got, sizeof got);
  assert_string_equal(got, text);
}

/* How many files and folders there are. */
static inline int entries(bool to_remove)
{
  DIR *here = opendir(".");
  int count = 0;
  assert_non_null(here);
  for (struct dirent *d; (d = readdir(here));)
    if (strcmp(d->d_name, ".") != 0 && strcmp(d->d_name, "..") != 0) {
      count++;
      if (to_remove && unlink(d->d_name) != 0)
        rmdir(d->d_name);
    }
  closedir(here);
  return count;
}

static inline int lowest_free(void)
{
  int fd = dup(0);
  close(fd);
  return fd;
}

static int scratch_begin(void **state)
{
  (void)state;
  return mkdtemp(scratch_folder) && chdir(scratch_folder) == 0 ? 0 : -1;
}

static int scratch_end(void **state)
{
  (void)state;
  entries(true);
  return chdir("/") == 0 && rmdir(scratch_folder) == 0 ? 0 : -1;
}

#endif
