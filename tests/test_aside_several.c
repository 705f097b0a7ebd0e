/* Several files written aside at once: each is kept or dropped by itself, and a signal removes them all. Each test runs
 * twice: with files without a name, where there is such a thing, and with ones that have a name from the start. */
#ifdef __linux__
#define _GNU_SOURCE /* O_TMPFILE */
#endif
#include "compare/text/aside.h"
#include "tests/scratch_folder.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

static bool only_named; /* no file without a name */

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
  return openat(AT_FDCWD, path, flags, mode);
}

static void open_and_write(struct aside *a, const char *name)
{
  assert_true(aside_open(a, name));
  assert_true(a->unnamed < 0 || !only_named);
  fputs("new ", a->file);
  fputs(name, a->file);
}

static void each_by_itself(void **state)
{
  (void)state;
  for (int first_kept = 0; first_kept <= 1; first_kept++)
    for (int backwards = 0; backwards <= 1; backwards++) {
      struct aside a[2];
      int before = lowest_free();
      write_text("one", "earlier one");
      write_text("two", "earlier two");
      open_and_write(&a[0], "one");
      open_and_write(&a[1], "two");
      for (int i = 0; i < 2; i++) {
        int which = backwards ? 1 - i : i;
        if ((which == 0) == first_kept)
          assert_true(aside_keep(&a[which]));
        else
          aside_drop(&a[which]);
      }
      assert_holds("one", first_kept ? "new one" : "earlier one");
      assert_holds("two", first_kept ? "earlier two" : "new two");
      assert_int_equal(entries(true), 2);
      assert_int_equal(lowest_free(), before);
    }
}

static void the_same_target_twice(void **state)
{
  (void)state;
  struct aside first, last;
  open_and_write(&first, "table");
  open_and_write(&last, "table");
  fputs(", last", last.file);
  assert_true(aside_keep(&first));
  assert_holds("table", "new table");
  assert_true(aside_keep(&last));
  assert_holds("table", "new table, last");
  assert_int_equal(entries(true), 1);
}

/* Opens files file0, file1, ... until it is refused. */
static int open_all(struct aside *a, int most)
{
  char name[20];
  for (int i = 0; i < most; i++) {
    snprintf(name, sizeof name, "file%d", i);
    if (!aside_open(&a[i], name))
      return i;
  }
  return most;
}

static void as_many_as_are_promised(void **state)
{
  (void)state;
  struct aside a[ASIDE_NAMED], more;
  assert_int_equal(open_all(a, ASIDE_NAMED), ASIDE_NAMED);
  bool opened = aside_open(&more, "more");
  int error = errno;
  assert_int_equal(opened, a[0].unnamed >= 0);
  if (opened)
    aside_drop(&more);
  else
    assert_int_equal(error, EMFILE);
  aside_drop(&a[20]);
  assert_int_equal(entries(false), only_named ? ASIDE_NAMED - 1 : 0);
  open_and_write(&a[20], "again"); /* the place of one that is gone */
  for (int i = 0; i < ASIDE_NAMED; i++)
    if (i % 2 == 0)
      assert_true(aside_keep(&a[i]));
    else
      aside_drop(&a[i]);
  assert_holds("again", "new again");
  assert_int_equal(entries(true), ASIDE_NAMED / 2);
}

/* The status of a process that opens so many files, keeps one, drops one, and gets a signal. */
static int open_and_end(int count, int signal_number)
{
  int status = 0;
  fflush(stdout);
  pid_t child = fork();
  if (child == 0) {
    struct aside a[ASIDE_NAMED];
    for (int s = 1; s <= SIGSYS; s++) /* not cmocka's */
      signal(s, SIG_DFL);
    if (open_all(a, count) < count || (count > 2 && !aside_keep(&a[0])))
      _exit(90);
    if (count > 2)
      aside_drop(&a[1]);
    raise(signal_number);
    _exit(91);
  }
  assert_true(child > 0 && waitpid(child, &status, 0) == child);
  return status;
}

static void a_signal_removes_all(void **state)
{
  (void)state;
  static const int ending[] = { SIGTERM, SIGINT, SIGHUP, SIGSEGV, SIGABRT };
  struct rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
    write_text("file0", "earlier");
    int status = open_and_end(2, ending[i]);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == ending[i]);
    assert_holds("file0", "earlier");
    assert_int_equal(entries(true), 1);
    status = open_and_end(ASIDE_NAMED, ending[i]);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == ending[i]);
    assert_holds("file0", ""); /* the one that was kept */
    assert_int_equal(entries(true), 1);
  }
}

static int without_a_name(void **state)
{
  (void)state;
  entries(true);
  only_named = false;
  return 0;
}

static int with_a_name(void **state)
{
  (void)state;
  entries(true);
  only_named = true;
  return 0;
}

int main(void)
{
#define BOTH(test) \
  { #test, test, without_a_name, NULL, NULL }, { "with a name: " #test, test, with_a_name, NULL, NULL }
  const struct CMUnitTest tests[] = {
    BOTH(each_by_itself),
    BOTH(the_same_target_twice),
    BOTH(as_many_as_are_promised),
    BOTH(a_signal_removes_all),
  };
  return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
