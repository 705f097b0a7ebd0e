/* The file that is written aside: what is left in its folder, and which error is told, whatever fails and whatever ends the process.
 * The calls to the system that make it, fill it and put it in its place are this file's own: they fail when told to. Each test runs
 * twice: with a file without a name, where there is such a thing, and with one that has a name from the start. */
#ifdef __linux__
#define _GNU_SOURCE /* O_TMPFILE */
#endif
#include "compare/text/aside.h"
#include "tests/scratch_folder.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- the calls ---- */

static int open_fails, sync_fails, close_fails, link_fails, rename_fails; /* with this error                      */
static int signal_in_rename, signal_in_sync;                              /* arrives there                        */
static bool only_named;                                                   /* no file without a name               */
static char calls[80];                                                    /* those made, in their order           */

static bool told(const char *call, int error)
{
  strncat(calls, call, sizeof calls - strlen(calls) - 1);
  errno = error;
  return error != 0;
}

int open(const char *path, int flags, ...)
{
  va_list arguments;
  va_start(arguments, flags);
  mode_t mode = va_arg(arguments, mode_t);
  va_end(arguments);
#ifdef O_TMPFILE
  if (only_named && (flags & O_TMPFILE) == O_TMPFILE) {
    errno = EOPNOTSUPP;
    return -1;
  }
#endif
  return told("open ", open_fails) ? -1 : openat(AT_FDCWD, path, flags, mode);
}

int fsync(int fd)
{
  if (signal_in_sync)
    raise(signal_in_sync);
  return told("sync ", sync_fails) ? -1 : fdatasync(fd);
}

#ifdef __GLIBC__
int _IO_fclose(FILE *file);

int fclose(FILE *file)
{
  int error = close_fails, closed = _IO_fclose(file);
  if (error != 0)
    errno = error;
  return error != 0 ? EOF : closed;
}
#endif

int rename(const char *from, const char *to)
{
  if (signal_in_rename)
    raise(signal_in_rename);
  return told("rename ", rename_fails) ? -1 : renameat(AT_FDCWD, from, AT_FDCWD, to);
}

#ifdef SYS_linkat
int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags)
{
  return told("link ", link_fails) ? -1 : (int)syscall(SYS_linkat, from_folder, from, to_folder, to, flags);
}
#endif

/* ---- the folder ---- */

static bool is_unnamed; /* what the last file was */

static void fresh(const char *earlier)
{
  open_fails = sync_fails = close_fails = link_fails = rename_fails = signal_in_rename = signal_in_sync = 0;
  entries(true);
  if (earlier)
    write_text("table", earlier);
  calls[0] = '\0';
}

static void open_and_write(struct aside *a, const char *name)
{
  assert_true(aside_open(a, name));
  is_unnamed = a->unnamed >= 0;
  assert_true(!is_unnamed || !only_named);
  assert_true(fcntl(fileno(a->file), F_GETFD) & FD_CLOEXEC);
  if (is_unnamed)
    assert_true(fcntl(a->unnamed, F_GETFD) & FD_CLOEXEC);
  fputs("new", a->file);
}

/* ---- what is kept, what is dropped ---- */

static void keeps(void **state)
{
  (void)state;
  for (int replaces = 0; replaces <= 1; replaces++) {
    struct aside a;
    fresh(replaces ? "earlier" : NULL);
    int before = lowest_free();
    open_and_write(&a, "table");
    assert_int_equal(entries(false), replaces + !is_unnamed);
    calls[0] = '\0';
    assert_true(aside_keep(&a));
    assert_holds("table", "new");
    assert_int_equal(entries(false), 1);
    assert_int_equal(lowest_free(), before);
    /* on the disk before it is in its place */
    assert_string_equal(calls, !is_unnamed ? "sync rename " : replaces ? "sync link link rename " : "sync link ");
  }
}

static void drops(void **state)
{
  (void)state;
  struct aside a;
  fresh("earlier");
  int before = lowest_free();
  open_and_write(&a, "table");
  aside_drop(&a);
  assert_holds("table", "earlier");
  assert_int_equal(entries(false), 1);
  assert_int_equal(lowest_free(), before);
}

static void takes_permissions_over(void **state)
{
  (void)state;
  struct aside a;
  struct stat there;
  mode_t mask = umask(027);
  fresh(NULL);
  open_and_write(&a, "table");
  assert_true(aside_keep(&a));
  assert_int_equal(stat("table", &there), 0);
  assert_int_equal(there.st_mode & 07777, 0640);
  chmod("table", 0604);
  open_and_write(&a, "table");
  assert_true(aside_keep(&a));
  assert_int_equal(stat("table", &there), 0);
  assert_int_equal(there.st_mode & 07777, 0604);
  umask(mask);
}

static void follows_a_link(void **state)
{
  (void)state;
  struct aside a;
  struct stat there;
  fresh("earlier");
  assert_int_equal(symlink("table", "link"), 0);
  open_and_write(&a, "link");
  assert_true(aside_keep(&a));
  assert_holds("table", "new");
  assert_int_equal(lstat("link", &there), 0);
  assert_true(S_ISLNK(there.st_mode));
  assert_int_equal(entries(false), 2);
}

/* ---- failures ---- */

static void assert_refused(const char *name, int error)
{
  struct aside a;
  int before = lowest_free();
  assert_false(aside_open(&a, name));
  assert_int_equal(errno, error);
  assert_int_equal(lowest_free(), before);
}

static void refuses_what_cannot_be_written(void **state)
{
  (void)state;
  char name[300];
  fresh("earlier");
  memset(name, 'n', sizeof name);
  name[256] = '\0';
  assert_refused(name, ENAMETOOLONG);
  assert_refused("missing/table", ENOENT);
  assert_refused("table/table", ENOTDIR);
  assert_refused("new/", ENOENT);
  assert_int_equal(symlink("nowhere", "link"), 0);
  assert_refused("link", ENOENT);
  chmod("table", 0444);
  if (access("table", W_OK) != 0) /* as root it is 0 */
    assert_refused("table", EACCES);
  open_fails = ENOSPC;
  assert_refused("other", ENOSPC);
  assert_holds("table", "earlier");
  assert_int_equal(entries(false), 2);
}

static void replaces_the_longest_name(void **state)
{
  (void)state;
  struct aside a;
  char name[256];
  fresh(NULL);
  memset(name, 'n', sizeof name);
  name[255] = '\0';
  write_text(name, "earlier");
  open_and_write(&a, name);
  assert_true(aside_keep(&a));
  assert_holds(name, "new");
  assert_int_equal(entries(false), 1);
}

static void assert_not_kept(int *fails, int error)
{
  struct aside a;
  fresh("earlier");
  int before = lowest_free();
  open_and_write(&a, "table");
  *fails = error;
  bool kept = aside_keep(&a);
  int told_error = errno;
  *fails = 0;
  assert_false(kept);
  assert_int_equal(told_error, error);
  assert_holds("table", "earlier");
  assert_int_equal(entries(false), 1);
  assert_int_equal(lowest_free(), before);
}

static void the_earlier_file_stays(void **state)
{
  (void)state;
  assert_not_kept(&sync_fails, ENOSPC);
  assert_not_kept(&sync_fails, EDQUOT);
  assert_not_kept(&rename_fails, EIO);
#ifdef __GLIBC__
  assert_not_kept(&close_fails, EDQUOT);
#endif
  if (is_unnamed)
    assert_not_kept(&link_fails, EDQUOT);
}

/* What a write says that comes too late for the caller to see: the last, out of the buffer */
static void the_last_write_fails(void **state)
{
  (void)state;
  struct aside a;
  struct rlimit before, tight;
  fresh("earlier");
  signal(SIGXFSZ, SIG_IGN);
  getrlimit(RLIMIT_FSIZE, &before);
  tight = before;
  tight.rlim_cur = 2;
  open_and_write(&a, "table");
  setrlimit(RLIMIT_FSIZE, &tight);
  bool kept = aside_keep(&a);
  int error = errno;
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_DFL);
  assert_false(kept);
  assert_int_equal(error, EFBIG);
  assert_holds("table", "earlier");
  assert_int_equal(entries(false), 1);
}

static void needs_no_disk(void **state)
{
  (void)state;
  struct aside a;
  fresh("earlier");
  open_and_write(&a, "table");
  sync_fails = EINVAL;
  assert_true(aside_keep(&a));
  assert_holds("table", "new");
}

static void other_names_are_let_alone(void **state)
{
  (void)state;
  struct aside a;
  char taken[2][40];
  fresh("earlier");
  for (int i = 0; i < 2; i++) {
    snprintf(taken[i], sizeof taken[i], "table.%ld.%d.part", (long)getpid(), i);
    write_text(taken[i], "other");
  }
  open_and_write(&a, "table");
  assert_true(aside_keep(&a));
  assert_holds("table", "new");
  for (int i = 0; i < 2; i++)
    assert_holds(taken[i], "other");
  assert_int_equal(entries(false), 3);
}

static void the_target_changes_meanwhile(void **state)
{
  (void)state;
  struct aside a;
  fresh(NULL);
  open_and_write(&a, "table");
  write_text("table", "appeared");
  assert_true(aside_keep(&a));
  assert_holds("table", "new");
  fresh("earlier");
  open_and_write(&a, "table");
  unlink("table");
  assert_true(aside_keep(&a));
  assert_holds("table", "new");
  fresh("earlier");
  open_and_write(&a, "table");
  unlink("table");
  mkdir("table", 0777);
  assert_false(aside_keep(&a));
  assert_int_equal(errno, EISDIR);
  assert_int_equal(entries(false), 1);
}

/* ---- signals ---- */

/* The status of a process that writes the file, gets one signal before it keeps it, and if it lives ends well. */
static int run_and_signal(int before_keep)
{
  int status = 0;
  fflush(stdout);
  pid_t child = fork();
  if (child == 0) {
    struct aside a;
    for (int s = 1; s <= SIGRTMAX; s++) /* not cmocka's */
      if (s != SIGHUP)
        signal(s, SIG_DFL);
    if (!aside_open(&a, "table"))
      _exit(90);
    fputs("new", a.file);
    if (before_keep)
      raise(before_keep);
    _exit(aside_keep(&a) ? 0 : 91);
  }
  assert_true(child > 0 && waitpid(child, &status, 0) == child);
  return status;
}

static bool ends_a_process(int s)
{
  static const int others[] = { SIGCHLD,  SIGCONT, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU, SIGURG,
#ifdef SIGWINCH
                                SIGWINCH,
#endif
                                SIGHUP };
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    if (s == others[i])
      return false;
  return s <= SIGSYS || s >= SIGRTMIN; /* between them the C library has its own */
}

static void signals_remove_it(void **state)
{
  (void)state;
  struct rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  for (int s = 1; s <= SIGRTMAX; s++) {
    if (!ends_a_process(s) || (s == SIGKILL && !is_unnamed))
      continue;
    fresh("earlier");
    int status = run_and_signal(s);
    if (!WIFSIGNALED(status) || WTERMSIG(status) != s)
      fail_msg("signal %d: status %x", s, (unsigned)status);
    assert_holds("table", "earlier");
    if (entries(false) != 1)
      fail_msg("signal %d leaves something", s);
  }
}

static void an_ignored_signal_stays_ignored(void **state)
{
  (void)state;
  fresh("earlier");
  signal(SIGHUP, SIG_IGN);
  assert_int_equal(run_and_signal(SIGHUP), 0);
  signal(SIGHUP, SIG_DFL);
  assert_holds("table", "new");
}

/* Without a name from the start, it waits for the two calls that put the file in its place. */
static void a_signal_on_the_way(void **state)
{
  (void)state;
  fresh("earlier");
  signal_in_sync = SIGTERM;
  assert_int_equal(WTERMSIG(run_and_signal(0)), SIGTERM);
  assert_holds("table", "earlier");
  assert_int_equal(entries(false), 1);
  fresh("earlier");
  signal_in_rename = SIGTERM;
  assert_int_equal(WTERMSIG(run_and_signal(0)), SIGTERM);
  assert_holds("table", is_unnamed ? "new" : "earlier");
  assert_int_equal(entries(false), 1);
}

static int set_way(bool named)
{
  struct aside a;
  only_named = named;
  fresh(NULL);
  open_and_write(&a, "table");
  aside_drop(&a);
  return 0;
}

static int with_a_name(void **state)
{
  (void)state;
  return set_way(true);
}

static int either_way(void **state)
{
  (void)state;
  return set_way(false);
}

int main(void)
{
#define BOTH(test) \
  { #test, test, either_way, NULL, NULL }, { "with a name: " #test, test, with_a_name, NULL, NULL }
  const struct CMUnitTest tests[] = {
    BOTH(keeps),
    BOTH(drops),
    BOTH(takes_permissions_over),
    BOTH(follows_a_link),
    BOTH(refuses_what_cannot_be_written),
    BOTH(replaces_the_longest_name),
    BOTH(the_earlier_file_stays),
    BOTH(the_last_write_fails),
    BOTH(needs_no_disk),
    BOTH(other_names_are_let_alone),
    BOTH(the_target_changes_meanwhile),
    BOTH(signals_remove_it),
    BOTH(an_ignored_signal_stays_ignored),
    BOTH(a_signal_on_the_way),
  };
  return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
