/* The exact solver against 50-digit values (tests/reference.tsv, made by scripts/python/reference.py).
 *
 * The bound: BOUND ulp times the larger of the result and its absolute condition number (sum over the
 * inputs p of |p dq/dp|, in the table). For nearly equal forces and nearly symmetric timing the
 * displacement is also held to 1e-15 L. The largest error seen is printed, in those ulp. */
#include "tests/check.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "numerics/numerics.h"

enum { COLUMNS = 27, LINE = 4096, QUANTITIES = 7, BOUND = 16 };

struct row {
  char text[LINE];
  const char *cell[COLUMNS];
};

static const char *const quantities[QUANTITIES] = { "t1", "dT", "v_end", "dxC", "v_start", "v_mid", "displacement" };

static char header[LINE];
static const char *names[COLUMNS];
static struct {
  double worst;
  char where[200];
} worst[QUANTITIES];

static int split(char *line, const char **cells)
{
  int n = 0;
  line[strcspn(line, "\n")] = '\0';
  for (char *cell = line; cell && n < COLUMNS;) {
    char *tab = strchr(cell, '\t');
    cells[n++] = cell;
    if (tab)
      *tab++ = '\0';
    cell = tab;
  }
  return n;
}

static const char *cell(const struct row *r, const char *prefix, const char *name)
{
  char full[40];
  snprintf(full, sizeof full, "%s%s", prefix, name);
  for (int i = 0; i < COLUMNS; i++)
    if (strcmp(names[i], full) == 0)
      return r->cell[i];
  fail_msg("no column %s", full);
  return NULL;
}

static double number(const struct row *r, const char *prefix, const char *name)
{
  return strtod(cell(r, prefix, name), NULL);
}

static void compare(const struct row *r, int q, double got, double L)
{
  double wanted = number(r, "", quantities[q]), cond = number(r, "cond_", quantities[q]);
  const char *family = cell(r, "", "family");
  bool nearly = strstr(family, "near") != NULL && strcmp(quantities[q], "displacement") == 0;
  double tolerance = BOUND * DBL_EPSILON * fmax(fabs(wanted), cond);
  if (nearly)
    tolerance = fmin(tolerance, 1e-15 * L);
  if (isnan(wanted)) {
    CHECK_EQUAL(got, wanted);
    return;
  }
  double share = tolerance > 0 ? fabs(got - wanted) / tolerance : 0;
  if (share > worst[q].worst) {
    worst[q].worst = share;
    snprintf(worst[q].where, sizeof worst[q].where, "%s %s, off by %.2g of %.17g, cond %g", family, cell(r, "", "gait"),
             got - wanted, wanted, cond);
  }
  if (!check_near(got, wanted, tolerance)) {
    print_error("%s %s %s:", family, cell(r, "", "kind"), cell(r, "", "gait"));
    for (int i = 3; i < 12; i++)
      print_error(" %s=%s", names[i], r->cell[i]);
    print_error("\n%s: cond %g ", quantities[q], cond);
    check_fail(quantities[q], got, wanted, tolerance, "absolute", __FILE__, __LINE__);
  }
}

static void check_modes(const struct row *r, const struct scallop_modes *modes, int count)
{
  char text[2][SCALLOP_MODES_TEXT], both[2 * SCALLOP_MODES_TEXT + 4];
  for (int i = 0; i < count; i++)
    scallop_modes_text(&modes[i], text[i]);
  snprintf(both, sizeof both, count == 2 ? "%s | %s" : "%s", text[0], text[1]);
  assert_string_equal(both, cell(r, "", "modes"));
}

static void check_row(const struct row *r)
{
  struct scallop_crawler c = { number(r, "", "m1"),    number(r, "", "m2"),
                               number(r, "", "F1"),    number(r, "", "F2"),
                               number(r, "", "L"),     number(r, "", "T"),
                               number(r, "", "alpha"), scallop_gait_named(cell(r, "", "gait")) };
  if (strcmp(cell(r, "", "kind"), "steady") == 0) {
    struct scallop_steady_result s;
    assert_int_equal(scallop_steady(&c, &s), SCALLOP_OK);
    compare(r, 4, s.period.v_start, c.L);
    compare(r, 5, s.period.v_mid, c.L);
    compare(r, 6, s.period.displacement, c.L);
    check_modes(r, s.period.modes, 2);
    return;
  }
  struct scallop_phase_result p;
  bool extension = cell(r, "", "phase")[0] == 'e';
  assert_int_equal(scallop_phase(&c, extension ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION, number(r, "", "v0"), &p),
                   SCALLOP_OK);
  compare(r, 0, p.t1, c.L);
  compare(r, 1, p.dT, c.L);
  compare(r, 2, p.v_end, c.L);
  compare(r, 3, p.dxC, c.L);
  check_modes(r, &p.modes, 1);
}

static void every_row(void **state)
{
  (void)state;
  FILE *file = fopen("tests/reference.tsv", "r");
  assert_non_null(file);
  int rows = 0;
  static struct row r;
  while (fgets(r.text, LINE, file)) {
    if (r.text[0] == '#')
      continue;
    if (!names[0]) {
      memcpy(header, r.text, LINE);
      assert_int_equal(split(header, names), COLUMNS);
      continue;
    }
    assert_int_equal(split(r.text, r.cell), COLUMNS);
    check_row(&r);
    rows++;
  }
  fclose(file);
  assert_true(rows > 500);
  for (int q = 0; q < QUANTITIES; q++)
    print_message("%-13s worst %.1f ulp: %s\n", quantities[q], BOUND * worst[q].worst, worst[q].where);
}

int main(void)
{
  const struct CMUnitTest tests[] = { cmocka_unit_test(every_row) };
  return cmocka_run_group_tests_name("reference", tests, NULL, NULL);
}
