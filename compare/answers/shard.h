/* Shards: tables of consecutive parts of a sweep; `merge` joins them. The head of a shard has the line
 * "# shard: I of N of sweep NAME"; NAME is a hash of the command and of the files of points and formulas that it reads.
 * In TSV the last line is "# end of shard". */
#ifndef SCALLOP_COMPARE_ANSWERS_SHARD_H
#define SCALLOP_COMPARE_ANSWERS_SHARD_H

#include <sys/types.h>

#include "compare/answers/request.h"
#include "compare/tables/npy.h"

#define SHARD_LINE "shard: %ld of %ld of sweep %s"
extern const char shard_end[];

/* Returns the index of the first point of a part, 1 <= part <= parts; for part + 1 the end of the part. */
static inline long shard_begin(const struct shard *s, long part, long points)
{
  const long left = points % s->parts;
  return points / s->parts * (part - 1) + (part - 1 < left ? part - 1 : left);
}

/* Return the hash of a name, extended by a text or by the contents of a file. It begins with SHARD_NO_NAME. */
#define SHARD_NO_NAME UINT64_C(0xcbf29ce484222325) /* the offset of FNV-1a */
uint64_t shard_name_text(uint64_t name, const char *text);
uint64_t shard_name_file(uint64_t name, const char *path);

struct shard_file {
  FILE *file;
  struct shard shard;
  bool is_array;
  struct npy_file array;
  char *head;       /* without the line of the shard: in TSV '#' lines and names of columns, in NPY the notes */
  off_t begin, end; /* of the rows, in TSV */
};
/* Reads the head of a shard; file may be NULL after a failed fopen, errno being set. Returns NULL, or why the file is
 * not a complete shard, valid until the next call. The shard must be closed in either case. */
const char *shard_open(struct shard_file *shard, FILE *file);
void shard_close(struct shard_file *shard);
/* Returns true if the file is that shard and complete. */
bool shard_is_complete(const char *path, const struct shard *shard);

#endif
