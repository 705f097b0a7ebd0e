/* Output files: what is in the folder, and which error is returned, whatever fails and whatever ends the process. The
 * calls that bring a file to the disk and to its place are this file's own: they fail, or are signalled, when told
 * to. */
#include "compare/text/file.h"
#include "tests/support/scratch_folder.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

static int sync_fails, rename_fails, signal_in_rename;
static char calls[40];

static void called(const char *call) { strncat(calls, call, sizeof calls - strlen(calls) - 1); }

int fsync(int fd)
{
  called("sync ");
  errno = sync_fails;
  return sync_fails != 0 ? -1 : fdatasync(fd);
}

int rename(const char *from, const char *to)
{
  called("rename ");
  raise(signal_in_rename);
  errno = rename_fails;
  return rename_fails != 0 ? -1 : renameat(AT_FDCWD, from, AT_FDCWD, to);
}

/* A folder with one table, or an empty one */
static void fresh(const char *earlier)
{
  sync_fails = rename_fails = signal_in_rename = 0;
  entries(true);
  if (earlier)
    write_text("table", earlier);
  calls[0] = '\0';
}

static struct file open_and_write(const char *name)
{
  struct file f;
  assert_int_equal(file_open(&f, name), 0);
  fprintf(f.stream, "new %s", name);
  return f;
}

static void written(const char *name)
{
  struct file f = open_and_write(name);
  assert_int_equal(file_close(&f, true), 0);
}

TEST(keeps_or_drops)
{
  for (int replaces = 0; replaces <= 1; replaces++)
    for (int keep = 0; keep <= 1; keep++) {
      fresh(replaces ? "earlier" : NULL);
      int before = lowest_free();
      struct file f = open_and_write("table");
      assert_non_null(strstr(f.temporary, "table.scallop-"));
      assert_int_equal(access(f.temporary, F_OK), 0);
      assert_int_equal(entries(false), replaces + 1);
      assert_int_equal(file_close(&f, keep), 0);
      if (keep || replaces)
        assert_holds("table", keep ? "new table" : "earlier");
      assert_int_equal(entries(false), keep || replaces);
      assert_int_equal(lowest_free(), before);
      assert_string_equal(calls, keep ? "sync rename " : ""); /* on the disk before it is in its place */
    }
}

TEST(permissions_and_links)
{
  struct stat there;
  mode_t mask = umask(027);
  fresh(NULL);
  for (int i = 0; i < 2; i++) {
    written("table");
    assert_int_equal(stat("table", &there), 0);
    assert_int_equal(there.st_mode & 07777, i == 0 ? 0640 : 0604);
    chmod("table", 0604);
  }
  umask(mask);
  assert_int_equal(symlink("table", "link"), 0);
  written("link");
  assert_holds("table", "new link");
  assert_true(lstat("link", &there) == 0 && S_ISLNK(there.st_mode));
  assert_int_equal(entries(false), 2);
}

TEST(refuses_what_cannot_be_written)
{
  static const struct {
    const char *name;
    int error;
  } cases[] = {
    { "missing/table", ENOENT }, { "table/table", ENOTDIR }, { "new/", ENOENT }, { ".", EISDIR }, { "link", ENOENT }
  };
  struct file f;
  char name[257];
  fresh("earlier");
  assert_int_equal(symlink("nowhere", "link"), 0);
  int before = lowest_free();
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    assert_int_equal(file_open(&f, cases[i].name), cases[i].error);
  memset(name, 'n', 256);
  name[256] = '\0';
  assert_int_equal(file_open(&f, name), ENAMETOOLONG);
  chmod("table", 0444);
  if (access("table", W_OK) != 0) /* as root it is 0 */
    assert_int_equal(file_open(&f, "table"), EACCES);
  assert_int_equal(lowest_free(), before);
  assert_int_equal(entries(false), 2);
  name[255] = '\0'; /* the longest name */
  written(name);
  assert_int_equal(entries(false), 3);
}

/* Of a write that fails: to the disk, but for EINVAL, which says that there is no disk; of the name; and, last, of what
 * is in the buffer */
TEST(the_earlier_file_stays)
{
  static const struct {
    int sync, rename, limit, wanted;
  } cases[] = { { ENOSPC, 0, 0, ENOSPC }, { EINVAL, 0, 0, 0 }, { 0, EIO, 0, EIO }, { 0, 0, 2, EFBIG } };
  struct rlimit before, tight;
  signal(SIGXFSZ, SIG_IGN);
  getrlimit(RLIMIT_FSIZE, &before);
  for (int i = 0; i < 4; i++) {
    fresh("earlier");
    int lowest = lowest_free();
    struct file f = open_and_write("table");
    sync_fails = cases[i].sync, rename_fails = cases[i].rename;
    tight = before;
    if (cases[i].limit > 0)
      tight.rlim_cur = (rlim_t)cases[i].limit;
    setrlimit(RLIMIT_FSIZE, &tight);
    int error = file_close(&f, true);
    setrlimit(RLIMIT_FSIZE, &before);
    assert_int_equal(error, cases[i].wanted);
    assert_holds("table", error == 0 ? "new table" : "earlier");
    assert_int_equal(entries(false), 1);
    assert_int_equal(lowest_free(), lowest);
  }
}

TEST(several_at_once)
{
  struct file f[FILES_OPEN], more;
  char name[20];
  fresh(NULL);
  for (int i = 0; i < FILES_OPEN; i++) { /* the last two have the same target */
    snprintf(name, sizeof name, "file%d", i < FILES_OPEN - 1 ? i : i - 1);
    f[i] = open_and_write(name);
  }
  assert_int_equal(file_open(&more, "more"), EMFILE);
  for (int i = FILES_OPEN - 1; i >= 0; i--)
    assert_int_equal(file_close(&f[i], i % 2 == 0 || i == FILES_OPEN - 1), 0);
  assert_int_equal(entries(false), FILES_OPEN / 2);
  assert_holds("file0", "new file0");
  more = open_and_write("more");
  assert_int_equal(file_close(&more, false), 0);
}

/* The status of a process that opens two files, is signalled before it keeps the first, and then exits. */
static int ends_by(int before_keep, int in_rename)
{
  int status = 0;
  fflush(stdout);
  pid_t child = fork();
  if (child == 0) {
    for (int s = 1; s < 32; s++) /* cmocka's */
      if (s != SIGHUP)
        signal(s, SIG_DFL);
    struct file table = open_and_write("table");
    open_and_write("other");
    signal_in_rename = in_rename;
    raise(before_keep);
    exit(file_close(&table, true));
  }
  assert_true(child > 0 && waitpid(child, &status, 0) == child);
  return status;
}

TEST(whatever_ends_the_process)
{
  static const int signals[] = { SIGHUP, SIGINT, SIGTERM };
  for (int i = 0; i < 6; i++) {
    const int by = signals[i % 3];
    fresh("earlier");
    assert_int_equal(WTERMSIG(ends_by(i < 3 ? by : 0, i < 3 ? 0 : by)), by);
    assert_holds("table", "earlier");
    assert_int_equal(entries(false), 1);
  }
  signal(SIGHUP, SIG_IGN); /* and stays ignored; exit drops the other file */
  assert_int_equal(ends_by(SIGHUP, 0), 0);
  signal(SIGHUP, SIG_DFL);
  assert_holds("table", "new table");
  assert_int_equal(entries(false), 1);
  assert_int_equal(WTERMSIG(ends_by(SIGKILL, 0)), SIGKILL);
  assert_holds("table", "new table");
  assert_int_equal(entries(false), 3); /* both temporary files */
}

int main(void) { return check_run(scratch_begin, scratch_end); }
