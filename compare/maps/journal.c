#include "compare/maps/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/text/memory.h"

enum { NUMBER = 32, LINE = (JOURNAL_VALUES + 2) * NUMBER };

static bool take_line(char *line, journal_taker *take, void *context)
{
  double values[JOURNAL_VALUES];
  char *sum = strrchr(line, '\t'), *at = line;
  if (!sum || strtoul(sum, NULL, 16) != checksum_after(CHECKSUM_OF_NOTHING, line, (size_t)(sum - line)))
    return false;
  *sum = '\0';
  long number = strtol(line, &at, 10);
  int count = 0;
  while (*at && count < JOURNAL_VALUES)
    values[count++] = strtod(at, &at);
  return take(context, number, count, values);
}

/* The length of the whole lines that can be used, of which the title is the first; -1: it is another title. */
static long read_all(FILE *file, const char *title, journal_taker *take, void *context)
{
  char line[LINE];
  long good = 0;
  while (fgets(line, LINE, file)) {
    size_t length = strcspn(line, "\n");
    bool ended = line[length] == '\n';
    line[length] = '\0';
    if (good == 0 && (ended ? strcmp(line, title) : strncmp(line, title, length)) != 0)
      return -1;
    if (!ended || (good > 0 && !take_line(line, take, context)))
      break;
    good += (long)length + 1;
  }
  return good;
}

/* Locks the file, reads it, and cuts it off after what can be used. */
static enum journal_outcome resume(struct journal *j, const char *title, journal_taker *take, void *context)
{
  struct flock whole = { .l_type = F_WRLCK, .l_whence = SEEK_SET };
  if (fcntl(fileno(j->stream), F_SETLK, &whole) != 0)
    return errno == EACCES || errno == EAGAIN ? JOURNAL_BUSY : JOURNAL_ERROR;
  rewind(j->stream);
  long good = read_all(j->stream, title, take, context);
  if (ferror(j->stream))
    return JOURNAL_ERROR;
  if (good < 0)
    return JOURNAL_OTHER;
  if (ftruncate(fileno(j->stream), good) != 0 || fseek(j->stream, 0, SEEK_END) != 0
      || (good == 0 && (fprintf(j->stream, "%s\n", title) < 0 || fflush(j->stream) != 0)))
    return JOURNAL_ERROR;
  return good > (long)strlen(title) + 1 ? JOURNAL_FOUND : JOURNAL_NEW;
}

enum journal_outcome journal_open(struct journal *j, const char *path, const char *title, journal_taker *take, void *context)
{
  *j = (struct journal){ .path = strdup(path), .stream = fopen(path, "a+") };
  enum journal_outcome outcome = j->path && j->stream ? resume(j, title, take, context) : JOURNAL_ERROR;
  int error = errno;
  if (outcome != JOURNAL_NEW && outcome != JOURNAL_FOUND)
    journal_close(j, false);
  errno = error;
  return outcome;
}

bool journal_add(struct journal *j, long number, int count, const double *values)
{
  char line[LINE];
  int used = snprintf(line, LINE, "%ld", number);
  for (int i = 0; i < count; i++)
    used += snprintf(line + used, (size_t)(LINE - used), "\t%a", values[i]);
  unsigned long sum = checksum_after(CHECKSUM_OF_NOTHING, line, (size_t)used);
  if (j->error == 0 && (fprintf(j->stream, "%s\t%08lx\n", line, sum) < 0 || fflush(j->stream) != 0))
    j->error = errno;
  return j->error == 0;
}

void journal_close(struct journal *j, bool done)
{
  if (done)
    unlink(j->path);
  if (j->stream)
    fclose(j->stream);
  free(j->path);
  *j = (struct journal){ 0 };
}
