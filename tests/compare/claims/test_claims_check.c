/* claims --check against a ledger with a verdict of its own, a row less and a row more: all three are found, and
 * nothing else. */
#include <stdio.h>
#include <stdlib.h>

#include "compare/claims/claims.h"
#include "compare/command/commands.h"
#include "compare/text/shipped.h"
#include "tests/support/said.h"
#include "tests/support/scratch_folder.h"

static const char file[] = "differences.tsv";

/* In the ledger of the tool the first row about the quadratic gait that holds is upset, and the next one is called
 * otherwise. */
static void change(char *text)
{
  for (char *line = text; *line; line = strchr(line, '\n') + 1) {
    char *gait = strstr(line, "\tquadratic\t"), *holds = strstr(line, "\tholds\t"), *end = strchr(line, '\n');
    if (!gait || !holds || gait > end || holds > end)
      continue;
    for (int i = 0; i < 5; i++)
      holds[1 + i] = "upset"[i];
    end[1] = 'X';
    return;
  }
  fail_msg("no row of the quadratic gait holds");
}

static enum exit_code check(const char *ledger, char *table, size_t size, struct said *said)
{
  struct claims_options options = { .request = { .style = { .command = "claims", .output = file },
                                                 .point = point_initial(command_claims.defaults) },
                                    .check = true };
  options.request.point.has_gait = true;
  said_begin(said);
  enum exit_code code = claims_check(&options, ledger);
  said_end(said);
  read_text(file, table, size);
  remove(file);
  return code;
}

TEST(differences_are_found)
{
  enum { TABLE = 4000 };
  char table[TABLE], *text = strdup(shipped_text(shipped_ledger, "claims"));
  struct said said;
  assert_non_null(text);
  change(text);
  assert_int_equal(check(text, table, TABLE, &said), EXIT_CHECK_FAILED);
  assert_non_null(strstr(said.text, " verdicts, 3 differ from the ledger that comes with the tool\n"));
  const char *rows = strstr(table, "committed_order\n");
  assert_non_null(rows);
  rows += strlen("committed_order\n");
  int lines = 0, upset = 0, unknown = 0, gone = 0;
  for (const char *line = rows; *line; line = strchr(line, '\n') + 1, lines++) {
    const char *end = strchr(line, '\n');
    assert_non_null(end);
    const char *verdict = strstr(line, "\tholds\t"), *was = strstr(line, "\tupset\t");
    upset += verdict && was && verdict < was && was < end;
    unknown += *line != 'X' && strncmp(end - 4, "\t-\t-", 4) == 0;
    gone += *line == 'X' && strstr(line, "\t-\t-\t") && strstr(line, "\t-\t-\t") < end;
  }
  assert_int_equal(lines, 3);
  assert_int_equal(upset, 1);
  assert_int_equal(unknown, 1);
  assert_int_equal(gone, 1);
  free(text);
}

TEST(a_text_that_is_no_ledger)
{
  const struct claims_options options = { .request = { .style = { .command = "claims" },
                                                       .point = point_initial(command_claims.defaults) } };
  struct said said;
  said_begin(&said);
  enum exit_code code = claims_check(&options, "h\terr\n1\t2\n");
  assert_string_equal(said_end(&said),
                      "scallop claims: the ledger that comes with the tool:1: there is no column 'claim'\n");
  assert_int_equal(code, EXIT_UNSOLVED);
}

int main(void) { return check_run(scratch_begin, scratch_end); }
