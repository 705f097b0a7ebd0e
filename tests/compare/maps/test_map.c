/* The words for a change of modes. */
#include "compare/breakdown/motion.h"
#include "tests/support/cases.h"
#include "tests/support/scratch_folder.h"

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
    { "-- -+ 0+ ++ | ++ +- --", "-- -+ 0+ | +- --", "body 1 is stuck to the end of the extension" },
    { "-+ 0+ | +- 0-", "0+ | +- 0-", "body 1 is stuck from the start of the extension" },
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
