/* Axes and the words for a change of modes. */
#include "compare/breakdown/motion.h"
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
