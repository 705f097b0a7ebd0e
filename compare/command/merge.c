/* Command merge: the table of a sweep from its shards. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/shard.h"
#include "compare/command/commands.h"
#include "compare/text/file.h"

enum { BLOCK = 4096, MAX_NAMED = 8 };

struct merge {
  const char *command, *const *names; /* of the files */
  int count;
  struct shard first;  /* of the first file */
  bool is_array;       /* the first file is in npy format */
  const char **shards; /* file name of each part, or NULL */
};

/* Adds file i; returns NULL, or an error, such as a conflict with an earlier file. */
static const char *add_shard(struct merge *m, const struct shard_file *s, int i)
{
  const char *name = m->names[i];
  if (!m->shards) {
    m->first = s->shard;
    m->is_array = s->is_array;
    m->shards = calloc((size_t)s->shard.parts, sizeof *m->shards);
    if (!m->shards)
      return "out of memory";
  }
  if (strcmp(s->shard.sweep, m->first.sweep) != 0 || s->shard.parts != m->first.parts || s->is_array != m->is_array)
    return wrong_text(
        "%.200s and %.200s are of different sweeps, of different numbers of shards, or of different formats",
        m->names[0], name);
  const char **shard = &m->shards[s->shard.part - 1];
  if (*shard)
    return wrong_text("%.200s and %.200s are both shard %ld of %ld", *shard, name, s->shard.part, s->shard.parts);
  *shard = name;
  return NULL;
}

/* Reads the heads of all files. Returns NULL, or an error. */
static const char *read_heads(struct merge *m)
{
  const char *wrong = NULL;
  for (int i = 0; i < m->count && !wrong; i++) {
    struct shard_file s;
    const char *why = shard_open(&s, file_read(m->names[i]));
    wrong = why ? wrong_text("%.200s: %s", m->names[i], why) : add_shard(m, &s, i);
    shard_close(&s);
  }
  return wrong;
}

/* Returns NULL, or an error with the missing shards. */
static const char *missing_text(const struct merge *m)
{
  char list[MAX_NAMED * 24] = "";
  size_t used = 0;
  long count = 0;
  if (!m->shards)
    return "no shard is given";
  for (long part = 1; part <= m->first.parts; part++)
    if (!m->shards[part - 1] && count++ < MAX_NAMED)
      used += (size_t)snprintf(list + used, sizeof list - used, " %ld", part);
  return count == 0 ? NULL
                    : wrong_text("of the %ld shards of this sweep %ld are missing:%s%s", m->first.parts, count, list,
                                 count > MAX_NAMED ? " ..." : "");
}

static int copy_lines(struct shard_file *s, FILE *to, bool is_first)
{
  char bytes[1 << 16];
  if (is_first && fputs(s->head, to) < 0)
    return errno;
  for (off_t left = s->end - s->begin; left > 0;) {
    const size_t size = left < (off_t)sizeof bytes ? (size_t)left : sizeof bytes;
    if (fseeko(s->file, s->end - left, SEEK_SET) != 0 || fread(bytes, 1, size, s->file) != size)
      return EIO;
    if (fwrite(bytes, 1, size, to) != size)
      return errno;
    left -= (off_t)size;
  }
  return 0;
}

/* Appends the records of a shard to the output. */
static int copy_records(struct npy_file *from, struct npy *file, FILE *to, long head)
{
  struct npy block;
  int error = 0;
  npy_begin(&block, from->columns);
  for (long left = from->rows; left > 0 && error == 0; left -= block.room) {
    block.room = left < BLOCK ? left : BLOCK;
    npy_free(&block);
    block.records = malloc((size_t)block.room * from->size);
    block.size = from->size;
    block.rows = block.room;
    for (int i = 0; i < from->columns; i++)
      block.width[i] = from->column[i].kind == 'f' ? 0 : from->column[i].size;
    error = !block.records ? ENOMEM
            : fread(block.records, from->size, (size_t)block.rows, from->file) != (size_t)block.rows
                ? EIO
                : npy_move(file, to, head, &block);
  }
  npy_free(&block);
  return error;
}

static int write_all(const struct merge *m, FILE *to)
{
  const char *names[TABLE_COLUMNS];
  struct shard_file first, s;
  struct npy file;
  long head = 0;
  if (!m->shards)
    return EINVAL;
  int error = shard_open(&first, file_read(m->shards[0])) ? EIO : 0;
  if (m->is_array && error == 0) {
    for (int i = 0; i < first.array.columns; i++)
      names[i] = first.array.column[i].name;
    head = npy_head_size(names, first.array.columns, first.head);
    npy_begin(&file, first.array.columns);
  }
  for (long part = 0; part < m->first.parts && error == 0; part++) {
    error = shard_open(&s, file_read(m->shards[part])) ? EIO : 0;
    if (error == 0)
      error = m->is_array ? copy_records(&s.array, &file, to, head) : copy_lines(&s, to, part == 0);
    shard_close(&s);
  }
  if (m->is_array && error == 0)
    error = npy_write_head(&file, to, head, names, first.head);
  shard_close(&first);
  return error;
}

static enum exit_code run(const struct arguments *a, const void *options)
{
  const struct style *style = &((const struct request *)options)->style;
  struct merge m = { .command = style->command, .names = a->operands, .count = a->operand_count };
  struct file out;
  const char *wrong = read_heads(&m);
  wrong = wrong ? wrong : missing_text(&m);
  enum exit_code code = EXIT_USAGE;
  if (!wrong && m.is_array && !style->output)
    wrong = no_npy_to_pipe;
  if (!wrong) {
    int error = file_open(&out, style->output);
    if (error == 0) {
      error = m.is_array && !out.target ? EINVAL : write_all(&m, out.stream);
      int closed = file_close(&out, error == 0);
      error = error != 0 ? error : closed;
    }
    code = error == 0 ? EXIT_DONE : EXIT_FILE;
    if (error != 0)
      complain(m.command, "cannot write %s: %s", style->output ? style->output : "standard output", file_error(error));
  } else
    complain(m.command, "%s", wrong);
  free(m.shards);
  return code;
}

static const struct option options_of_merge[] = { OPTION_OUTPUT, OPTION_QUIET, NO_MORE_OPTIONS };

const struct command command_merge = {
  .name = "merge",
  .operand = "FILE...",
  .options = options_of_merge,
  .size = sizeof(struct request),
  .run = run,
};
