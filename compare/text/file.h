/* Files that are replaced atomically, and files that are read and therefore never replaced.
 *
 * A plain file is written under another name in its folder, TARGET.scallop-XXXXXX with six random characters (and at
 * most 200 bytes of the name), synchronised with the disk, and then renamed to TARGET. Until then an earlier TARGET
 * remains, and two programs that write the same TARGET do not mix. A failure, exit, SIGHUP, SIGINT and SIGTERM remove
 * the temporary file; SIGKILL, another signal or a power cut can leave it. Standard output, pipes and devices are
 * written directly. */
#ifndef SCALLOP_COMPARE_TEXT_FILE_H
#define SCALLOP_COMPARE_TEXT_FILE_H

#include <stdbool.h>
#include <stdio.h>

enum { FILES_OPEN = 64 };   /* maximum number of temporary files, all opened and closed by one thread */
enum { FILE_IS_READ = -1 }; /* an error besides errno: file_read has opened the same file, by device and inode */

/* Opens a file for reading, or standard input for "-". The functions below never write to a plain file opened here. */
FILE *file_read(const char *path);
/* Returns 0 if output may go to path (NULL: standard output), else FILE_IS_READ. */
int file_check_output(const char *path);
/* Returns the text of an error. */
const char *file_error(int error);

struct file {
  FILE *stream;    /* to write to */
  char *target;    /* the file to replace, symbolic links resolved; NULL: written directly */
  char *temporary; /* the name of the file until then */
};

/* Opens path, or standard output if path is NULL or a link to the file of standard output. An earlier file must be
 * writable and keeps its permissions. Returns 0, or an error as in errno or FILE_IS_READ, with nothing to close. */
int file_open(struct file *file, const char *path);
/* Flushes the stream, and synchronises a file with the disk. Returns 0 or an error. */
int file_flush(struct file *file);
/* Runs a shell script, also one that writes to the temporary file; name: of the script in messages. A signal
 * that ends this process first ends the processes of the script. Returns the exit code of the script, or -1 if it did
 * not exit. */
int file_run(const char *script, const char *name);
/* Closes the file; keep: a plain file replaces its target. Returns 0 or an error, after which the earlier file
 * remains. */
int file_close(struct file *file, bool keep);

#endif
