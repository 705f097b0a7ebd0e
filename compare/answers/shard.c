#include "compare/answers/shard.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char shard_end[] = "end of shard";
static const char not_shard[] = "it is not a shard: its head has no line '# shard: ...'";

static uint64_t fold(uint64_t name, const char *bytes, size_t size) /* FNV-1a */
{
  for (; size > 0; size--)
    name = (name ^ (unsigned char)*bytes++) * UINT64_C(0x100000001b3);
  return name;
}

uint64_t shard_name_text(uint64_t name, const char *text) { return fold(name, text, strlen(text) + 1); }

uint64_t shard_name_file(uint64_t name, const char *path)
{
  char bytes[1 << 14];
  FILE *file = fopen(path, "r");
  for (size_t size; file && (size = fread(bytes, 1, sizeof bytes, file)) > 0;)
    name = fold(name, bytes, size);
  if (file)
    fclose(file);
  return name;
}

/* Reads the line of a shard. Returns false if it is another line. */
static bool read_line(struct shard *s, const char *line)
{
  return sscanf(line, "# shard: %ld of %ld of sweep %16[0-9a-f]", &s->part, &s->parts, s->sweep) == 3 && s->part >= 1
         && s->part <= s->parts;
}

/* Removes the line of the shard from lines. Returns false if it is missing. */
static bool take_line(struct shard *s, char *lines)
{
  char *at = lines ? strstr(lines, "# shard: ") : NULL, *next = at ? strchr(at, '\n') : NULL;
  if (!next || (at > lines && at[-1] != '\n') || !read_line(s, at))
    return false;
  memmove(at, next + 1, strlen(next + 1) + 1);
  return true;
}

/* Reads the '#' lines and the names of the columns, and finds the rows. Returns NULL or the error. */
static const char *read_lines(struct shard_file *s)
{
  char last[sizeof shard_end + 4] = "", *line = NULL, expected[sizeof last];
  size_t size = 0, capacity = 0;
  bool in_head = true;
  FILE *head = open_memstream(&s->head, &size);
  while (head && in_head && getline(&line, &capacity, s->file) > 0) {
    fputs(line, head);
    in_head = *line == '#';
  }
  free(line);
  if (!head || fclose(head) != 0)
    return "out of memory";
  s->begin = ftello(s->file);
  const int length = snprintf(expected, sizeof expected, "# %s\n", shard_end);
  bool found = fseeko(s->file, -(off_t)length, SEEK_END) == 0 && (s->end = ftello(s->file)) >= s->begin
               && fread(last, 1, (size_t)length, s->file) == (size_t)length;
  if (!take_line(&s->shard, s->head))
    return not_shard;
  return found && strcmp(last, expected) == 0 ? NULL : "it is cut off: its last line is not '# end of shard'";
}

static const char *read_array(struct shard_file *s)
{
  const char *wrong = npy_open(&s->array, s->file, true);
  s->head = s->array.notes ? strdup(s->array.notes + strspn(s->array.notes, "\n")) : NULL;
  char *end = s->head ? strrchr(s->head, '#') : NULL; /* blanks pad the head behind the last '#' line */
  if (end)
    end[strcspn(end, "\n") + 1] = '\0';
  return wrong ? wrong : take_line(&s->shard, s->head) ? NULL : not_shard;
}

const char *shard_open(struct shard_file *s, FILE *file)
{
  *s = (struct shard_file){ .file = file };
  const int first = s->file ? getc(s->file) : EOF;
  s->is_array = first == 0x93;
  if (!s->file || ferror(s->file))
    return strerror(errno);
  if (!s->is_array && first != EOF)
    ungetc(first, s->file);
  return s->is_array ? read_array(s) : read_lines(s);
}

void shard_close(struct shard_file *s)
{
  if (s->file)
    fclose(s->file);
  npy_close(&s->array);
  free(s->head);
}

bool shard_is_complete(const char *path, const struct shard *shard)
{
  struct shard_file s;
  bool is_there = !shard_open(&s, fopen(path, "r")) && s.shard.part == shard->part && s.shard.parts == shard->parts
                  && strcmp(s.shard.sweep, shard->sweep) == 0;
  shard_close(&s);
  return is_there;
}
