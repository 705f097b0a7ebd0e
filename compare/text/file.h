/* Output that is complete or absent.
 *
 * A plain file is written under another name in its folder, TARGET.scallop-XXXXXX with six random characters (of a long
 * name the first 200 bytes), is brought to the disk, and only then renamed to TARGET: until then an earlier TARGET
 * stays, and two programs that write the same TARGET do not mix. A failure, exit, SIGHUP, SIGINT and SIGTERM remove the
 * temporary file; SIGKILL, any other signal and a power cut can leave it. Standard output, a pipe or a device has
 * nothing to replace and is written directly. */
#ifndef SCALLOP_COMPARE_TEXT_FILE_H
#define SCALLOP_COMPARE_TEXT_FILE_H

#include <stdbool.h>
#include <stdio.h>

enum { FILES_OPEN = 64 };   /* temporary files at a time, opened and closed by one thread */
enum { FILE_IS_READ = -1 }; /* an error beside those of errno: the file, by device and number, is one that was read */

/* Opens a file for reading, or standard input for "-". A plain file that was opened so is never replaced or added to
 * afterwards. */
FILE *file_read(const char *path);
/* May output go to path, or to standard output where it is NULL? Returns 0 or FILE_IS_READ. */
int file_spares(const char *path);
/* What an error means */
const char *file_error(int error);

struct file {
  FILE *stream;    /* to write to                                                              */
  char *target;    /* the file to replace, symbolic links followed; NULL: written directly      */
  char *temporary; /* the name of the file until then                                          */
};

/* Opens path, or standard output where path is NULL or a link to what standard output goes to. An earlier file must be
 * writable, and its permissions are kept. Returns 0, or an error as in errno or FILE_IS_READ: then nothing is left to
 * close. */
int file_open(struct file *file, const char *path);
/* Brings what was written to the disk, or to the pipe or device. Returns 0 or an error. */
int file_flush(struct file *file);
/* Runs a script of the shell that writes to such a file by its name; name: what the shell calls it in messages. What
 * ends this process ends those of the script first. Returns its exit code, or -1: none. */
int file_run(const char *script, const char *name);
/* Closes the file; keep: and a plain one replaces its target. Returns 0 or an error: then the earlier file stays. */
int file_close(struct file *file, bool keep);

#endif
