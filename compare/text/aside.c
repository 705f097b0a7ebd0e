#ifdef __linux__
#define _GNU_SOURCE /* O_TMPFILE */
#endif
#include "compare/text/aside.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_NAMES = 100, LONGEST_HEAD = 200, ENDING = 48 };

static size_t name_room(const struct aside *a) { return strlen(a->target) + ENDING; }

/* Where in the path of the target its own name begins */
static int folder_length(const struct aside *a)
{
  const char *slash = strrchr(a->target, '/');
  return slash ? (int)(slash + 1 - a->target) : 0;
}

/* ---- files that have a name, and signals ---- */

/* The names of unfinished files, for a signal that ends the process; NULL: the place is free. */
static const char *volatile unfinished[ASIDE_NAMED];

static const char *volatile *find_place(const char *name)
{
  for (int i = 0; i < ASIDE_NAMED; i++)
    if (unfinished[i] == name)
      return &unfinished[i];
  return NULL;
}

static void give_up(int signal_number)
{
  for (int i = 0; i < ASIDE_NAMED; i++)
    if (unfinished[i])
      unlink(unfinished[i]);
  signal(signal_number, SIG_DFL);
  raise(signal_number);
}

static void intercept(int signal_number)
{
  struct sigaction before, ours = { .sa_handler = give_up };
  sigfillset(&ours.sa_mask); /* a second signal waits until the files are gone */
  /* What is ignored stays so: under nohup the terminal may go. So does another's handler, of a sanitizer for one. */
  if (sigaction(signal_number, NULL, &before) == 0 && before.sa_handler == SIG_DFL)
    sigaction(signal_number, &ours, NULL);
}

static void intercept_all(void)
{
  static const int ending[] = { SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP, SIGABRT, SIGBUS,    SIGFPE,  SIGUSR1, SIGSEGV,
                                SIGUSR2, SIGPIPE, SIGALRM, SIGTERM, SIGXCPU, SIGXFSZ, SIGVTALRM, SIGPROF, SIGSYS };
  for (size_t i = 0; i < sizeof ending / sizeof *ending; i++)
    intercept(ending[i]);
#ifdef SIGPOLL
  intercept(SIGPOLL);
#endif
#ifdef SIGPWR
  intercept(SIGPWR);
#endif
#ifdef SIGSTKFLT
  intercept(SIGSTKFLT);
#endif
#ifdef SIGRTMIN
  for (int s = SIGRTMIN; s <= SIGRTMAX; s++)
    intercept(s);
#endif
}

static void hold_signals(sigset_t *before)
{
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, before);
}

static void release_signals(const sigset_t *before)
{
  int error = errno;
  sigprocmask(SIG_SETMASK, before, NULL);
  errno = error;
}

/* Makes the file by make(), under a name that nothing has: a process that was killed may have left one, and in another container
 * another process can have the same number. Signals are held, or one could find a file that is not noted yet. */
static bool make_named(struct aside *a, bool (*make)(struct aside *))
{
  int folder = folder_length(a);
  const char *head = a->target + folder;
  bool made = false;
  errno = EEXIST;
  for (int n = 0; !made && errno == EEXIST && n < MOST_NAMES; n++) {
    /* of a long name only the head, or this one would be too long */
    snprintf(a->name, name_room(a), "%.*s%.*s.%ld.%d.part", folder, a->target, LONGEST_HEAD, head, (long)getpid(), n);
    made = make(a);
  }
  return made;
}

static bool create(struct aside *a)
{
  int fd = open(a->name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0)
    return false;
  a->file = fdopen(fd, "w");
  if (a->file)
    return true;
  close(fd);
  unlink(a->name);
  return false;
}

static bool open_named(struct aside *a)
{
  const char *volatile *place = find_place(NULL);
  sigset_t before;
  errno = EMFILE;
  if (!place)
    return false;
  hold_signals(&before);
  bool made = make_named(a, create);
  if (made) {
    *place = a->name;
    intercept_all();
  }
  release_signals(&before);
  return made;
}

/* ---- the file without a name ---- */

#ifdef O_TMPFILE

enum { WAY = 40 };

/* The path by which an open file can be linked to. */
static void way_to(int fd, char way[WAY]) { snprintf(way, WAY, "/proc/self/fd/%d", fd); }

static bool way_leads_there(int fd)
{
  char way[WAY];
  struct stat there, here;
  way_to(fd, way);
  return stat(way, &there) == 0 && fstat(fd, &here) == 0 && there.st_dev == here.st_dev && there.st_ino == here.st_ino;
}

static bool open_unnamed(struct aside *a)
{
  snprintf(a->name, name_room(a), "%.*s.", folder_length(a), a->target); /* the folder */
  int fd = open(a->name, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (fd < 0)
    return false;
  /* To be written to and closed, so that no error of either is missed, before the file gets its name by the first. */
  int other = way_leads_there(fd) ? fcntl(fd, F_DUPFD_CLOEXEC, 0) : -1;
  a->file = other < 0 ? NULL : fdopen(other, "w");
  if (a->file) {
    a->unnamed = fd;
    return true;
  }
  if (other >= 0)
    close(other);
  close(fd);
  return false;
}

static bool link_as(const struct aside *a, const char *name)
{
  char way[WAY];
  way_to(a->unnamed, way);
  return linkat(AT_FDCWD, way, AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
}

static bool link_aside(struct aside *a) { return link_as(a, a->name); }

/* linkat does not replace a file; rename does. */
static bool put_unnamed(struct aside *a)
{
  if (link_as(a, a->target))
    return true;
  if (errno != EEXIST)
    return false;
  sigset_t before;
  hold_signals(&before); /* for two calls to the system */
  bool linked = make_named(a, link_aside), put = linked && rename(a->name, a->target) == 0;
  if (linked && !put) {
    int error = errno;
    unlink(a->name);
    errno = error;
  }
  release_signals(&before);
  return put;
}

#else

static bool open_unnamed(struct aside *a)
{
  (void)a;
  return false;
}

static bool put_unnamed(struct aside *a)
{
  (void)a;
  return false;
}

#endif

/* ---- both ---- */

static bool put_named(struct aside *a)
{
  if (rename(a->name, a->target) == 0)
    return true;
  int error = errno;
  unlink(a->name);
  errno = error;
  return false;
}

static void forget(struct aside *a)
{
  const char *volatile *place = a->name ? find_place(a->name) : NULL;
  if (place)
    *place = NULL;
  if (a->unnamed >= 0)
    close(a->unnamed);
  free(a->target);
  free(a->name);
  *a = (struct aside){ .unnamed = -1 };
}

/* Through any link; a link to nothing is refused, and any name that no file could have. */
static char *find_target(const char *output)
{
  struct stat there;
  if (lstat(output, &there) != 0)
    return errno == ENOENT ? strdup(output) : NULL;
  return S_ISLNK(there.st_mode) ? realpath(output, NULL) : strdup(output);
}

bool aside_open(struct aside *a, const char *output)
{
  struct stat there;
  *a = (struct aside){ .target = find_target(output), .unnamed = -1 };
  bool replaces = a->target && stat(a->target, &there) == 0;
  bool allowed = a->target && (!replaces || access(a->target, W_OK) == 0);
  a->name = allowed ? malloc(name_room(a)) : NULL;
  bool opened = allowed && a->name && (open_unnamed(a) || open_named(a));
  int error = errno;
  if (!opened)
    forget(a);
  else if (replaces)
    (void)fchmod(fileno(a->file), there.st_mode & 07777); /* what the file replaces could be read by the same people */
  errno = error;
  return opened;
}

/* A name may reach the disk before what it stands for: without fsync a power cut can leave an empty file where the earlier one was.
 * And of some file systems only this tells that the disk or the quota is full. It is done once a table and takes about as long as a
 * program to start, 0.8 ms where it was measured. The folder is not waited for: the earlier file is good, too.
 * EINVAL: there is no disk behind it. */
static bool is_on_disk(FILE *file) { return fflush(file) == 0 && (fsync(fileno(file)) == 0 || errno == EINVAL); }

bool aside_keep(struct aside *a)
{
  bool whole = is_on_disk(a->file);
  int error = errno;
  if (fclose(a->file) != 0 && whole) {
    whole = false;
    error = errno;
  }
  bool kept = false;
  if (!whole && a->unnamed < 0)
    unlink(a->name);
  else if (whole) {
    kept = a->unnamed < 0 ? put_named(a) : put_unnamed(a);
    error = errno;
  }
  forget(a);
  errno = error;
  return kept;
}

void aside_drop(struct aside *a)
{
  fclose(a->file);
  if (a->unnamed < 0)
    unlink(a->name);
  forget(a);
}
