#include "compare/text/file.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compare/text/memory.h"

enum { NAME = 4096, LONGEST_HEAD = 200 };
/* The names of temporary files, removed at the end of the process; "": a free place */
static char unfinished[FILES_OPEN][NAME];

static void remove_unfinished(void)
{
  for (int i = 0; i < FILES_OPEN; i++)
    if (unfinished[i][0])
      unlink(unfinished[i]);
}

static volatile pid_t child; /* the script that writes to one of these files, or 0 */

static void handle_signal(int signal_number)
{
  if (child > 0 && kill(-child, SIGKILL) == 0) /* else the script would create the file again */
    waitpid(child, NULL, 0);
  remove_unfinished();
  signal(signal_number, SIG_DFL);
  raise(signal_number);
}

static void catch_signals(void)
{
  static const int ends[] = { SIGHUP, SIGINT, SIGTERM };
  static bool watched;
  struct sigaction before, ours = { .sa_handler = handle_signal };
  sigfillset(&ours.sa_mask);
  if (!watched)
    watched = atexit(remove_unfinished) == 0;
  for (int i = 0; i < 3; i++) /* an ignored signal stays ignored, for nohup */
    if (sigaction(ends[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
      sigaction(ends[i], &ours, NULL);
}

static struct stat *files_read;
static int read_count;

static int check_read(const struct stat *file)
{
  for (int i = 0; i < read_count && S_ISREG(file->st_mode); i++)
    if (files_read[i].st_dev == file->st_dev && files_read[i].st_ino == file->st_ino)
      return FILE_IS_READ;
  return 0;
}

FILE *file_read(const char *path)
{
  FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
  struct stat there, *grown;
  if (!file || fstat(fileno(file), &there) != 0 || !S_ISREG(there.st_mode) || check_read(&there))
    return file;
  if ((grown = list_grown(files_read, read_count, sizeof there))) {
    files_read = grown;
    files_read[read_count++] = there;
  }
  return file;
}

int file_check_output(const char *path)
{
  struct stat there;
  return (path ? stat(path, &there) : fstat(STDOUT_FILENO, &there)) == 0 ? check_read(&there) : 0;
}

const char *file_error(int error)
{
  return error == FILE_IS_READ ? "it is a file that this command reads: name another one" : strerror(error);
}

/* Opens the temporary file, with the permissions of the earlier file, or by the umask. Its name is stored before the
 * file exists, because a signal can arrive at any time. Returns 0 or an error. */
static int open_temporary(struct file *f, const struct stat *earlier)
{
  const char *slash = strrchr(f->target, '/');
  const int folder = slash ? (int)(slash + 1 - f->target) : 0;
  const mode_t mask = umask(0);
  umask(mask);
  for (int i = 0; i < FILES_OPEN && !f->temporary; i++)
    f->temporary = unfinished[i][0] ? NULL : unfinished[i];
  if (!f->temporary)
    return EMFILE;
  catch_signals();
  snprintf(f->temporary, NAME, "%.*s%.*s.scallop-XXXXXX", folder, f->target, LONGEST_HEAD, f->target + folder);
  int descriptor = mkstemp(f->temporary);
  f->stream = descriptor < 0 ? NULL : fdopen(descriptor, "w");
  const int error = f->stream ? 0 : errno;
  if (f->stream)
    (void)fchmod(descriptor, earlier ? earlier->st_mode & 07777 : 0666 & ~mask);
  else if (descriptor >= 0) {
    close(descriptor);
    unlink(f->temporary);
  }
  return error;
}

static void release(struct file *f)
{
  if (f->temporary)
    f->temporary[0] = '\0';
  free(f->target);
  *f = (struct file){ .stream = NULL };
}

/* Returns true for a link such as /dev/stdout: renaming a file to its target would replace earlier output. */
static bool leads_to_standard_output(const char *path)
{
  struct stat link, there, standard;
  return lstat(path, &link) == 0 && S_ISLNK(link.st_mode) && stat(path, &there) == 0
         && fstat(STDOUT_FILENO, &standard) == 0 && there.st_dev == standard.st_dev && there.st_ino == standard.st_ino;
}

int file_open(struct file *f, const char *path)
{
  struct stat there;
  *f = (struct file){ .stream = stdout };
  int error = file_check_output(path);
  if (error != 0 || !path || leads_to_standard_output(path))
    return error;
  bool exists = stat(path, &there) == 0;
  if (!exists && (errno != ENOENT || lstat(path, &there) == 0)) /* a link to nothing is refused */
    return errno;
  if (exists && !S_ISREG(there.st_mode))
    return (f->stream = fopen(path, "w")) ? 0 : errno;
  if (exists && access(path, W_OK) != 0)
    return errno;
  f->target = exists ? realpath(path, NULL) : strdup(path);
  error = f->target ? open_temporary(f, exists ? &there : NULL) : errno;
  if (error != 0)
    release(f);
  return error;
}

/* fsync is needed because a name may reach the disk before the contents, and a power cut would then leave an empty file
 * in place of the earlier one; on some file systems only fsync reports a full quota. EINVAL: a file without a disk. */
int file_flush(struct file *f)
{
  if (ferror(f->stream))
    return EIO; /* an earlier write failed */
  bool flushed = fflush(f->stream) == 0 && (!f->target || fsync(fileno(f->stream)) == 0 || errno == EINVAL);
  return flushed ? 0 : errno;
}

/* Closes the stream. Standard output stays open: closing a copy of it reports the same errors. Returns false after an
 * error. */
static bool close_stream(FILE *stream)
{
  int copy = stream == stdout ? dup(STDOUT_FILENO) : -1;
  return stream == stdout ? copy < 0 || close(copy) == 0 : fclose(stream) == 0;
}

int file_close(struct file *f, bool keep)
{
  int error = keep ? file_flush(f) : 0;
  if (!close_stream(f->stream) && error == 0)
    error = errno;
  if (f->target && keep && error == 0)
    error = file_check_output(f->target);
  if (f->target && keep && error == 0 && rename(f->temporary, f->target) != 0)
    error = errno;
  if (f->target && (!keep || error != 0))
    unlink(f->temporary);
  release(f);
  return error;
}

int file_run(const char *script, const char *name)
{
  int status = 0;
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before); /* no signal arrives between fork and the assignment */
  const pid_t process = child = fork();
  if (process == 0) {
    setpgid(0, 0);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    execl("/bin/sh", "sh", "-c", script, name, (char *)NULL);
    _exit(EXIT_FAILURE);
  }
  if (process > 0)
    setpgid(process, process); /* in both processes, because either may run first */
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  while (process > 0 && waitpid(process, &status, 0) < 0 && errno == EINTR)
    ;
  child = 0;
  return process > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
