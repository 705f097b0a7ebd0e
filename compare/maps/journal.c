#include "compare/maps/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/text/memory.h"
#include "compare/text/message.h"

enum { NUMBER = 32, LINE = (JOURNAL_WIDTH + 2) * NUMBER };

bool journal_init(struct journal *j, long rows, int width)
{
  *j = (struct journal){ .rows = rows, .width = width };
  j->values = calloc((size_t)(rows * width) + 1, sizeof *j->values);
  j->done = calloc((size_t)rows, sizeof *j->done);
  return j->values && j->done;
}

static void take(struct journal *j, long row, const double *values)
{
  memcpy(j->values + row * j->width, values, (size_t)j->width * sizeof *values);
  j->done_count += !j->done[row];
  j->done[row] = true;
}

static bool take_line(struct journal *j, char *line)
{
  double values[JOURNAL_WIDTH + 1];
  char *sum = strrchr(line, '\t'), *at = line;
  if (!sum || strtoul(sum, NULL, 16) != checksum_after(CHECKSUM_OF_NOTHING, line, (size_t)(sum - line)))
    return false;
  *sum = '\0';
  long row = strtol(line, &at, 10);
  int count = 0;
  while (*at && count <= j->width)
    values[count++] = strtod(at, &at);
  if (row < 0 || row >= j->rows || count != j->width)
    return false;
  take(j, row, values);
  return true;
}

/* The length of the whole lines that can be used, of which the title is the first; -1: it is another title. */
static long take_all(struct journal *j, const char *title)
{
  char line[LINE];
  long good = 0;
  while (fgets(line, LINE, j->stream)) {
    size_t length = strcspn(line, "\n");
    bool ended = line[length] == '\n';
    line[length] = '\0';
    if (good == 0 && (ended ? strcmp(line, title) : strncmp(line, title, length)) != 0)
      return -1;
    if (!ended || (good > 0 && !take_line(j, line)))
      break;
    good += (long)length + 1;
  }
  return good;
}

/* Locks the file, reads it, and cuts it off after what can be used. NULL, or why it cannot be used. */
static const char *resume(struct journal *j, const char *title)
{
  struct flock whole = { .l_type = F_WRLCK, .l_whence = SEEK_SET };
  if (!j->stream)
    return strerror(errno);
  if (fcntl(fileno(j->stream), F_SETLK, &whole) != 0)
    return errno == EACCES || errno == EAGAIN ? "another process is at work on this map" : strerror(errno);
  rewind(j->stream);
  long good = take_all(j, title);
  if (good < 0)
    return "it is of another map, of another version, or of a measured gait whose file has changed since; remove it, "
           "or "
           "write elsewhere";
  bool cut = !ferror(j->stream) && ftruncate(fileno(j->stream), good) == 0 && fseek(j->stream, 0, SEEK_END) == 0;
  return cut && (good > 0 || (fprintf(j->stream, "%s\n", title) >= 0 && fflush(j->stream) == 0)) ? NULL
                                                                                                 : strerror(errno);
}

bool journal_open(struct journal *j, const char *output, const char *title)
{
  size_t size = strlen(output) + sizeof ".rows";
  j->path = malloc(size);
  if (j->path) {
    snprintf(j->path, size, "%s.rows", output);
    j->stream = fopen(j->path, "a+");
  }
  const char *wrong = resume(j, title);
  if (wrong)
    complain("breakdown", "cannot keep rows in %s.rows: %s", output, wrong);
  return !wrong;
}

bool journal_add(struct journal *j, long row, const double *values)
{
  char line[LINE];
  take(j, row, values);
  int used = snprintf(line, LINE, "%ld", row);
  for (int i = 0; i < j->width; i++)
    used += snprintf(line + used, (size_t)(LINE - used), "\t%a", values[i]);
  unsigned long sum = checksum_after(CHECKSUM_OF_NOTHING, line, (size_t)used);
  if (j->stream && j->error == 0 && (fprintf(j->stream, "%s\t%08lx\n", line, sum) < 0 || fflush(j->stream) != 0))
    j->error = errno;
  return j->error == 0;
}

void journal_close(struct journal *j, bool done)
{
  if (j->stream && done)
    unlink(j->path);
  if (j->stream)
    fclose(j->stream);
  free(j->path);
  free(j->values);
  free(j->done);
  *j = (struct journal){ 0 };
}
