#include "compare/text/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

#include "compare/text/checksum.h"
#include "compare/text/lines.h"

enum { NUMBER = 32, LINE = (JOURNAL_VALUES + 2) * NUMBER };

static uint32_t checksum(const char *text) { return checksum_after(CHECKSUM_OF_NOTHING, text, strlen(text)); }

/* ---- reading ---- */

/* Takes the checksum off a line; false if it is not its own. */
static bool is_whole(char *line)
{
  char *last = strrchr(line, '\t'), *end;
  if (!last || strlen(last + 1) != 8)
    return false;
  *last = '\0';
  return strtoul(last + 1, &end, 16) == checksum(line) && *end == '\0';
}

static bool take_line(char *line, journal_taker *take, void *context)
{
  char *cells[JOURNAL_VALUES + 2], *end;
  double values[JOURNAL_VALUES];
  if (!is_whole(line))
    return false;
  int count = lines_cells(line, cells, JOURNAL_VALUES + 2);
  long number = strtol(cells[0], &end, 10);
  if (*end != '\0' || count > JOURNAL_VALUES + 1)
    return false;
  for (int i = 1; i < count; i++) {
    values[i - 1] = strtod(cells[i], &end);
    if (*end != '\0')
      return false;
  }
  return take(context, number, count - 1, values);
}

/* The length of the part of the file that can be used: its whole lines. The first is the title. -1: it is of another title; 0: empty,
 * or only a part of the title. */
static off_t read_all(FILE *file, const char *title, journal_taker *take, void *context)
{
  char *line = NULL;
  size_t size = 0;
  off_t good = 0;
  ssize_t length;
  bool first = true, goes_on = true;
  while (goes_on && (length = getline(&line, &size, file)) > 0) {
    bool ended = line[length - 1] == '\n';
    line[length - ended] = '\0';
    if (first && (ended ? strcmp(line, title) != 0 : strncmp(line, title, (size_t)length) != 0)) {
      good = -1;
      break;
    }
    goes_on = ended && (first || take_line(line, take, context));
    good += goes_on ? length : 0;
    first = false;
  }
  free(line);
  return good;
}

/* ---- writing ---- */

static bool put(struct journal *j, const char *text, size_t length)
{
  while (length > 0 && j->error == 0) {
    ssize_t written = write(fileno(j->stream), text, length);
    if (written < 0 && errno != EINTR)
      j->error = errno;
    else if (written > 0) {
      text += written;
      length -= (size_t)written;
    }
  }
  return j->error == 0;
}

bool journal_add(struct journal *j, long number, int count, const double *values)
{
  char line[LINE];
  if (j->error != 0)
    return false;
  int used = snprintf(line, sizeof line, "%ld", number);
  for (int i = 0; i < count; i++)
    used += snprintf(line + used, sizeof line - (size_t)used, "\t%a", values[i]);
  used += snprintf(line + used, sizeof line - (size_t)used, "\t%08lx\n", (unsigned long)checksum(line));
  return put(j, line, (size_t)used);
}

/* ---- open and close ---- */

static bool lock(int file)
{
  struct flock whole = { .l_type = F_WRLCK, .l_whence = SEEK_SET };
  return fcntl(file, F_SETLK, &whole) == 0;
}

/* After the whole lines; behind a title where there is none yet. */
static bool go_on_after(struct journal *j, off_t good, const char *title)
{
  int file = fileno(j->stream);
  if (ftruncate(file, good) != 0 || lseek(file, good, SEEK_SET) < 0)
    j->error = errno;
  return j->error == 0 && (good > 0 || (put(j, title, strlen(title)) && put(j, "\n", 1)));
}

static enum journal_outcome begin(struct journal *j, const char *title, journal_taker *take, void *context)
{
  if (!lock(fileno(j->stream)))
    return errno == EACCES || errno == EAGAIN ? JOURNAL_BUSY : JOURNAL_ERROR;
  errno = 0;
  off_t good = read_all(j->stream, title, take, context);
  if (ferror(j->stream))
    return JOURNAL_ERROR;
  if (good < 0)
    return JOURNAL_OTHER;
  if (!go_on_after(j, good, title)) {
    errno = j->error;
    return JOURNAL_ERROR;
  }
  return good > (off_t)strlen(title) + 1 ? JOURNAL_FOUND : JOURNAL_NEW;
}

/* Closing another descriptor of the file would drop the lock: the stream that read it stays open, and what is written goes past it. */
static FILE *open_stream(const char *path)
{
  int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  FILE *stream = file < 0 ? NULL : fdopen(file, "r+");
  if (!stream && file >= 0)
    close(file);
  return stream;
}

enum journal_outcome journal_open(struct journal *j, const char *path, const char *title, journal_taker *take, void *context)
{
  *j = (struct journal){ .path = strdup(path) };
  j->stream = j->path ? open_stream(path) : NULL;
  enum journal_outcome outcome = j->stream ? begin(j, title, take, context) : JOURNAL_ERROR;
  if (outcome != JOURNAL_NEW && outcome != JOURNAL_FOUND) {
    int error = errno;
    journal_close(j, false);
    errno = error;
  }
  return outcome;
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
