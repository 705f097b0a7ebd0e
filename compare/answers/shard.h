/* Shards: a sweep in parts of neighbouring points, each a table of its own, that can be put together again. The head of
 * a shard has the line "# shard: I of N of sweep NAME", whose name is made of the whole command and of the files of
 * points and formulas that it reads; in TSV its last line is "# end of shard". */
#ifndef SCALLOP_COMPARE_ANSWERS_SHARD_H
#define SCALLOP_COMPARE_ANSWERS_SHARD_H

#include <sys/types.h>

#include "compare/answers/request.h"
#include "compare/tables/npy.h"

#define SHARD_LINE "shard: %ld of %ld of sweep %s"
extern const char shard_end[];

/* The first of the points of a shard, of so many; of the next one: the end. */
static inline long shard_begin(const struct shard *s, long part, long points)
{
  const long left = points % s->parts;
  return points / s->parts * (part - 1) + (part - 1 < left ? part - 1 : left);
}

/* A name that begins, and one that goes on: of what a text says, of what a file holds. */
#define SHARD_NO_NAME UINT64_C(0xcbf29ce484222325) /* FNV-1a begins with it */
uint64_t shard_name_text(uint64_t name, const char *text);
uint64_t shard_name_file(uint64_t name, const char *path);

struct shard_file {
  FILE *file;
  struct shard shard;
  bool is_array;
  struct npy_file array;
  char *head;       /* in TSV the '#' lines and the names, without the line of the shard; of an array its notes */
  off_t begin, end; /* of the rows in TSV */
};
/* file: NULL where it cannot be opened, by errno. NULL, or why it is no whole shard, until the next call: it is to be
 * closed in either case. */
const char *shard_open(struct shard_file *shard, FILE *file);
void shard_close(struct shard_file *shard);
/* Is that shard there already, and whole? */
bool shard_is_there(const char *path, const struct shard *shard);

#endif
