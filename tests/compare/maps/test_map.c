/* Axes, journals and the words for a change of modes. */
#include <errno.h>
#include <sys/wait.h>

#include "compare/answers/mode_change.h"
#include "compare/maps/journal.h"
#include "compare/maps/maps.h"
#include "tests/support/cases.h"
#include "tests/support/scratch_folder.h"

TEST(axes_are_read)
{
  struct axis a;
  assert_null(axis_read(&a, "F1/F2", NULL));
  assert_true(a.from == 0.01 && a.to == 100 && a.count == 41 && a.log);
  CHECK_EQUAL(axis_node(&a, 20), 1.0);
  assert_null(axis_read(&a, "m1_over_m2", NULL));
  assert_int_equal(a.kind, AXIS_M1_M2);
  assert_null(axis_read(&a, "alpha", NULL));
  assert_true(a.from == 0.01 && a.to == 0.99 && a.count == 41 && !a.log);
  assert_null(axis_read(&a, "T", "0.5:8:5:linear"));
  CHECK_EQUAL(axis_node(&a, 0), 0.5);
  CHECK_EQUAL(axis_node(&a, 2), 4.25);
  CHECK_EQUAL(axis_node(&a, 4), 8.0);
  assert_null(axis_read(&a, "alpha", "0.1:0.4:3:log"));
  CHECK_RELATIVE(axis_node(&a, 1), 0.2, 0x1p-51);
  assert_null(axis_read(&a, "froude", "3:3:1"));
  CHECK_EQUAL(axis_node(&a, 0), 3.0);
}

TEST(bad_axes_are_refused)
{
  static const char ranges[] =
      "1:2|1:2:3:log:x|2:1:3|1:1:2|1:2:1|0:1:3|-1:1:3|1:2:0|1:2:2.5|a:2:3|1:b:3|1:inf:3|1:2:3:lo|1:2:100001||1:2:|"
      "1e-200:1e200:3";
  struct axis a = { .count = -7 };
  FOR_CASES (range, ranges)
    if (!axis_read(&a, "T", range))
      fail_msg("'%s' was taken", range);
  assert_non_null(axis_read(&a, "alpha", "0.5:1:3"));
  assert_non_null(strstr(axis_read(&a, "frude", NULL), "'froude'"));
  assert_int_equal(a.count, -7);
}

TEST(axes_set_the_crawler)
{
  struct axis axes[2];
  struct scallop_crawler base = scallop_crawler_default();
  base.F2 = 3;
  assert_null(axis_read(&axes[0], "froude", NULL));
  assert_null(axis_read(&axes[1], "F1/F2", NULL));
  struct scallop_crawler c = axes_crawler(axes, &base, 0.3, 2.5);
  CHECK_EQUAL(c.F1, 7.5);
  CHECK_RELATIVE((c.m1 + c.m2) * c.L / (c.T * c.T * (c.F1 + c.F2)), 0.3, 0x1p-50);
  assert_null(axis_read(&axes[0], "m1/m2", NULL));
  base.m2 = 0.5;
  c = axes_crawler(axes, &base, 4, 1);
  assert_true(c.m1 == 2 && c.m2 == 0.5 && c.F1 == 3 && c.T == base.T);
}

enum { ITEMS = 5 };
static const double items[ITEMS][3] = {
  { 1.5, -0.0, 0x1.123456789abcdp-300 }, { NAN, INFINITY, -INFINITY }, { 0.1, 0.2, 0.3 }, { 1e308, 4, 5 }, { 7, 8, 9 }
};

/* The output of a map, and the journal beside it */
static const char output[] = "map", path[] = "map.rows";

static struct journal ours(int count, int width)
{
  struct journal j;
  assert_true(journal_init(&j, count, width));
  assert_true(journal_open(&j, output, "ours"));
  return j;
}

/* What a journal by that title has: the items from the first on, to the last bit, and no others. -1: it is refused. */
static long look(const char *title)
{
  struct journal j;
  assert_true(journal_init(&j, ITEMS, 3));
  long count = journal_open(&j, output, title) ? j.done_count : -1;
  for (int item = 0; item < ITEMS; item++) {
    assert_int_equal(j.done[item], item < count);
    for (int i = 0; i < 3 && item < count; i++) {
      double a = j.values[3 * item + i], b = items[item][i];
      assert_true(isnan(b) ? isnan(a) : a == b && !signbit(a) == !signbit(b));
    }
  }
  journal_close(&j, false);
  return count;
}

static void write_all(void)
{
  unlink(path);
  struct journal j = ours(ITEMS, 3);
  assert_int_equal(j.done_count, 0);
  for (int i = 0; i < ITEMS; i++)
    assert_true(journal_add(&j, i, items[i]));
  assert_int_equal(j.done_count, ITEMS);
  journal_close(&j, false);
}

/* However much of the file was written: the items of its whole lines, to the last bit, and never a wrong one. */
TEST(any_part_of_a_journal)
{
  char bytes[2000];
  write_all();
  size_t size = read_text(path, bytes, sizeof bytes);
  long last = 0;
  for (size_t part = 0; part <= size; part++) {
    FILE *f = fopen(path, "w");
    fwrite(bytes, 1, part, f);
    fclose(f);
    int lines = 0;
    for (size_t i = 0; i < part; i++)
      lines += bytes[i] == '\n';
    last = look("ours");
    assert_int_equal(last, lines > 0 ? lines - 1 : 0);
  }
  assert_int_equal(last, ITEMS);
}

TEST(a_changed_line_ends_it)
{
  write_all();
  FILE *f = fopen(path, "r+");
  char line[200];
  long third = 0;
  for (int i = 0; i < 3; i++) /* the title and two items */
    assert_non_null(fgets(line, sizeof line, f));
  third = ftell(f);
  fseek(f, third + 6, SEEK_SET);
  fputc('f', f);
  fclose(f);
  assert_int_equal(look("ours"), 2);
  assert_int_equal(look("ours"), 2); /* the rest is gone */
}

/* The numbers of a whole line are right, but of more rows, or of wider ones */
TEST(a_row_of_another_size_ends_it)
{
  write_all();
  struct journal j = ours(ITEMS - 1, 3);
  assert_int_equal(j.done_count, ITEMS - 1);
  journal_close(&j, false);
  for (int width = 2; width <= 4; width += 2) {
    write_all();
    j = ours(ITEMS, width);
    assert_int_equal(j.done_count, 0);
    journal_close(&j, false);
  }
}

TEST(journals_of_others)
{
  write_all();
  assert_int_equal(look("our"), -1);
  assert_int_equal(look("ours and more"), -1);
  assert_int_equal(look("ours"), ITEMS); /* it was left as it is */
  unlink(path);
  write_text(path, "oursomething else");
  assert_int_equal(look("ours"), -1);
  unlink(path);
  errno = 0;
  struct journal j;
  assert_true(journal_init(&j, ITEMS, 3));
  assert_false(journal_open(&j, "/nonexistent/journal", "ours"));
  assert_int_equal(errno, ENOENT);
  journal_close(&j, false);
}

/* While another process has it open */
TEST(a_journal_at_work_is_left_alone)
{
  int opened[2] = { -1, -1 }, done[2] = { -1, -1 };
  char byte = 'x';
  write_all();
  assert_true(pipe(opened) == 0 && pipe(done) == 0);
  pid_t other = fork();
  assert_true(other >= 0);
  if (other == 0) {
    struct journal j;
    bool good = journal_init(&j, ITEMS, 3) && journal_open(&j, output, "ours");
    good = write(opened[1], &byte, 1) == 1 && read(done[0], &byte, 1) == 1 && good;
    _exit(!good);
  }
  assert_int_equal(read(opened[0], &byte, 1), 1);
  assert_int_equal(look("ours"), -1);
  assert_int_equal(write(done[1], &byte, 1), 1);
  int status;
  assert_int_equal(waitpid(other, &status, 0), other);
  assert_int_equal(status, 0);
  assert_int_equal(look("ours"), ITEMS);
  for (int i = 0; i < 2; i++) {
    close(opened[i]);
    close(done[i]);
  }
}

TEST(a_finished_journal_goes)
{
  write_all();
  struct journal j = ours(ITEMS, 3);
  journal_close(&j, true);
  assert_int_not_equal(access(path, F_OK), 0);
}

/* "++ -+ ++ | ++ +- ++" */
static void read_modes(const char *text, struct scallop_modes modes[2])
{
  int phase = 0;
  modes[0].count = modes[1].count = 0;
  for (; *text; text++) {
    if (*text == '|')
      phase = 1;
    if (*text == ' ' || *text == '|')
      continue;
    signed char s[2];
    for (int i = 0; i < 2; i++)
      s[i] = (signed char)(text[i] == '+' ? 1 : text[i] == '-' ? -1 : 0);
    modes[phase].kept[modes[phase].count++] = (struct scallop_mode){ s[0], s[1] };
    text++;
  }
}

static enum scallop_regime regime_of(const char *text)
{
  return !strchr(text, '0')                                             ? SCALLOP_SLIDING
         : strcmp(text, "0+ | 0-") == 0 || strcmp(text, "-0 | +0") == 0 ? SCALLOP_AT_REST
                                                                        : SCALLOP_STICK_SLIP;
}

static double sign_of(const char *text) { return text[0] != text[1] ? 0 : text[0] == '+' ? 1 : -1; }

TEST(changes_in_words)
{
  static const struct {
    const char *before, *after, *wanted;
  } cases[] = {
    { "++ -+ ++ | ++ +- ++", "-- -+ ++ | ++ +- --", "start velocity changes sign" },
    { "++ -+ ++ | ++ +- ++", "++ -+ -- | -- +- ++", "mid velocity changes sign" },
    { "-- -+ ++ | ++ +- --", "-- -+ 0+ | +- --", "onset of sticking: body 1 in the extension" },
    { "-- -+ ++ | ++ +- --", "-+ ++ | ++ +- 0-", "onset of sticking: body 1 in the contraction" },
    { "-+ ++ | ++ +- 0-", "-- -+ ++ | ++ +- --", "end of sticking: body 1 in the contraction" },
    { "++ -+ -- | -- +- ++", "++ -+ -0 | +- ++", "onset of sticking: body 2 in the extension" },
    { "0+ | +- 0-", "0+ | 0-", "permanent rest of body 1" },
    { "-0 | +0", "-0 | +- +0", "end of the permanent rest of body 2" },
    { "++ -+ ++ | ++ +- ++", "++ -+ ++ | ++", "body 2 ceases to turn in the contraction" },
    { "++ -+ ++ | ++", "++ -+ ++ | ++ +- ++", "body 2 begins to turn in the contraction" },
    { "-- -+ 0+ | +- --", "-- -+ 0+ ++ | ++ +- --", "body 1 is released before the end of the extension" },
    { "-- -+ 0+ ++ | ++ +- --", "-- -+ 0+ | +- --", "body 1 is held to the end of the extension" },
    { "-+ 0+ | +- 0-", "0+ | +- 0-", "body 1 is held from the start of the extension" },
    { "++ -+ ++ | ++ +- ++", "-- -+ -- | -- +- --", "the bodies exchange their roles" },
    { "++ -+ ++ | ++ +- ++", "++ -+ ++ | ++ +- ++", "no change of modes" },
    { "++ -+ 0+ ++ | ++ +- ++", "++ -+ 0+ -+ 0+ ++ | ++ +- ++", "body 1 sticks more often in the extension" },
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct answer a = { .regime = regime_of(cases[i].before), .value[Q_V_START] = { sign_of(cases[i].before), 0 } };
    struct answer b = { .regime = regime_of(cases[i].after), .value[Q_V_START] = { sign_of(cases[i].after), 0 } };
    char text[MODE_CHANGE_TEXT];
    read_modes(cases[i].before, a.modes);
    read_modes(cases[i].after, b.modes);
    assert_string_equal(mode_change_text(text, &a, &b), cases[i].wanted);
  }
}

int main(void) { return check_run(scratch_begin, scratch_end); }
