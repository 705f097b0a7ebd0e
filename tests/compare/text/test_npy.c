/* Files of NumPy: a file does not depend on the order in which its rows came, nor on how they were shared out. */
#include "compare/tables/table.h"
#include "compare/text/values.h"
#include "tests/support/scratch_folder.h"

static const struct style npy = { .command = "test", .output = "table", .format = FORMAT_NPY, .has_format = true };

/* The first column holds doubles, the second texts of any length, the third both. */
static void write_row(struct table *t, long i)
{
  static const char *const texts[] = { "ok", "a text of more than thirty-two bytes, which widens its column", "", "-" };
  table_number(t, (double)i / 7);
  table_text(t, texts[i % 4001 == 4000 ? 1 : 0]);
  if (i % 2 == 0)
    table_number(t, -1.0 / (double)(i + 1));
  else
    table_text(t, "-");
}

static void begin(struct table *t)
{
  static const char *const columns[] = { "T", "it's", "mixed", NULL };
  assert_true(table_open(t, &npy));
  table_note(t, "note");
  table_columns(t, columns);
  table_begin_rows(t);
}

enum { ROWS = 12000, MOST = 1 << 22 };

TEST(parts_make_the_same_file)
{
  struct table t, part;
  size_t size[2];
  char *bytes[2];
  for (int k = 0; k < 2; k++) {
    begin(&t);
    assert_true(table_part(&part, &t));
    for (long i = 0; i < ROWS; i++) {
      write_row(k == 0 ? &t : &part, i);
      if (k == 1 && (i % 1000 == 999 || i == 1))
        table_join(&t, &part);
    }
    table_abandon(&part);
    assert_true(table_close(&t));
    assert_non_null(bytes[k] = malloc(MOST));
    size[k] = read_text("table", bytes[k], MOST);
  }
  assert_int_equal(size[0], size[1]);
  assert_memory_equal(bytes[0], bytes[1], size[0]);
  free(bytes[1]);

  const char *head = bytes[0] + 12, *records = bytes[0] + 192;
  assert_memory_equal(bytes[0], "\x93NUMPY\x03\x00\xb4\x00\x00\x00", 12);
  assert_non_null(strstr(head,
                         "{'descr': [('T', '<f8'), ('it\\'s', '|S64'), ('mixed', '|S32')], 'fortran_order': False, "
                         "'shape': (12000,), }\n# note\n"));
  assert_int_equal(records[-1], '\n');
  assert_int_equal(size[0], 192 + ROWS * (8 + 64 + 32));
  for (long i = 0; i < ROWS; i++, records += 8 + 64 + 32) {
    double x, mixed = NAN;
    memcpy(&x, records, sizeof x);
    assert_true(x == (double)i / 7);
    assert_string_equal(records + 8,
                        i % 4001 == 4000 ? "a text of more than thirty-two bytes, which widens its column" : "ok");
    if (i % 2 == 0)
      assert_true(read_number(records + 72, &mixed) && mixed == -1.0 / (double)(i + 1));
    else
      assert_string_equal(records + 72, "-");
  }
  free(bytes[0]);
}

int main(void) { return check_run(scratch_begin, scratch_end); }
