/* Values written down: in the language of formulas, which reads them back, and beside others where each is expected. */
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/symbolic/language.h"
#include "tests/support/exact.h"

static int place_of(void *context, const char *name)
{
  const struct symbols *s = context;
  for (int i = 0; i < s->count; i++)
    if (strcmp(s->list[i].name, name) == 0)
      return i;
  return -1;
}

/* What the text says at these values, times T^power. False: the text is longer than a formula may be. */
static bool read_back(fmpq_t value, const struct written *written, struct symbols *s, const fmpq *values)
{
  const struct ring ring = { 1, 64 };
  const struct formula_names names = { .place = place_of, .context = s };
  struct series at[MOST_SYMBOLS], result;
  struct formula formula;
  char message[FORMULA_MESSAGE];
  if (formula_read(&formula, written->text, &names, message))
    return assert_non_null(strstr(message, "256")), false;
  series_init(&result);
  for (int i = 0; i < s->count; i++) {
    series_init(&at[i]);
    series_set_rational(&at[i], values + i);
  }
  assert_null(formula_series(&result, &formula, at, NULL, &ring, message));
  assert_true(series_rational_coefficient(value, &result, 0));
  if (written->negative)
    fmpq_neg(value, value);
  for (int i = 0; i < s->count; i++)
    series_clear(&at[i]);
  series_clear(&result);
  return true;
}

static int read_texts;

static void check_text(symbolic a, struct symbols *s, const fmpq *values)
{
  SCOPED(fmpq, wanted, got);
  struct written written = symbolic_written(s, a, 0, &language_text);
  assert_true(symbolic_value(wanted, a, s, values));
  if (read_back(got, &written, s, values)) {
    read_texts++;
    if (!fmpq_equal(got, wanted))
      fail_msg("%s", written.text);
  }
  free(written.text);
}

TEST(texts_read_back)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0, pi_squared);
  struct random r = { 1303 };
  long most = check_cases(20);
  read_texts = 0;
  for (long i = 0; i < most; i++) {
    struct symbols s[2];
    struct symbolic_steady steady;
    SCOPED(scallop_expansion, phase);
    SCOPED(series, series);
    random_exact_crawler(&c, &r, i % 2 ? &scallop_gait_quadratic : &scallop_gait_sinusoidal);
    random_fraction(v0, &r);
    random_positive(pi_squared, &r);
    symbols_init(&s[0]);
    assert_int_equal(symbolic_expand_phase(&s[0], &c, SCALLOP_EXTENSION, v0, 7, &phase, NULL), SCALLOP_OK);
    fmpq *values = _fmpq_vec_init(MOST_SYMBOLS);
    symbols_values(values, &s[0], &c, v0, pi_squared);
    for (slong k = 0; k < 7; k++) {
      check_text(symbolic_coefficient(&s[0], &phase.dT, k), &s[0], values);
      check_text(symbolic_coefficient(&s[0], &phase.dxC, k), &s[0], values);
    }
    symbols_end(&s[0]);
    symbols_init(&s[1]);
    if (symbolic_solve_steady(&s[1], &c, &steady, NULL) == SCALLOP_OK) {
      symbols_values(values, &s[1], &c, NULL, NULL);
      symbolic_in_T(&series, &s[1], steady.displacement, 8);
      check_text(steady.v_start, &s[1], values);
      for (slong k = 0; k < 8; k++)
        check_text(symbolic_coefficient(&s[1], &series, k), &s[1], values);
      symbols_end(&s[1]);
    }
    _fmpq_vec_clear(values, MOST_SYMBOLS);
  }
  assert_true(read_texts > 10 * most);
  print_message("%d texts read\n", read_texts);
}

static const struct language *const languages[] = { &language_text, &language_python, &language_latex };
enum { LANGUAGES = 3 };

static void check_written(struct symbols *s, symbolic a, slong power, bool negative,
                          const char *const wanted[LANGUAGES])
{
  for (int i = 0; i < LANGUAGES; i++) {
    struct written written = symbolic_written(s, a, power, languages[i]);
    assert_string_equal(written.text, wanted[i]);
    assert_true(written.negative == negative);
    free(written.text);
  }
}

static struct symbols list(void)
{
  static const enum symbol_meaning names[] = { NAMED_m1, NAMED_F1, NAMED_F2, NAMED_alpha, NAMED_beta, NAMED_T };
  struct symbols s;
  symbols_init(&s);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    symbols_add(&s, names[i], 0, SCALLOP_EXTENSION);
  symbols_add(&s, NAMED_AT_START, 3, SCALLOP_EXTENSION);
  symbols_add(&s, NAMED_AT_END, 3, SCALLOP_CONTRACTION);
  symbols_begin(&s);
  return s;
}

TEST(each_language)
{
  struct symbols s = list();
  symbolic m1 = symbolic_named(&s, NAMED_m1), F1 = symbolic_named(&s, NAMED_F1), F2 = symbolic_named(&s, NAMED_F2);
  symbolic alpha = symbolic_named(&s, NAMED_alpha), beta = symbolic_named(&s, NAMED_beta),
           T = symbolic_named(&s, NAMED_T);
  symbolic zero = symbolic_number(&s, 0, 1), half = symbolic_number(&s, -1, 2), sum = symbolic_sub(&s, F1, F2);
  check_written(&s, zero, 0, false, (const char *[]){ "0", "0", "0" });
  check_written(&s, half, 0, true, (const char *[]){ "1/2", "1/2", "\\frac{1}{2}" });
  check_written(&s, symbolic_div(&s, sum, m1), 0, false,
                (const char *[]){ "(F1 - F2)/m1", "(F1 - F2)/m1", "\\frac{F_{1} - F_{2}}{m_{1}}" });
  check_written(&s, symbolic_mul(&s, sum, sum), -2, false,
                (const char *[]){ "(F1 - F2)^2/T^2", "(F1 - F2)**2/T**2", "\\frac{(F_{1} - F_{2})^{2}}{T^{2}}" });
  /* alpha - beta is 2 alpha - 1, alpha + beta is 1, and beta alone is 1 - alpha */
  symbolic times = symbolic_mul(&s, symbolic_sub(&s, symbolic_mul(&s, alpha, alpha), symbolic_mul(&s, beta, beta)),
                                beta);
  check_written(&s, times, 1, false,
                (const char *[]){ "(1 - alpha)*T*(2*alpha - 1)", "(1 - alpha)*T*(2*alpha - 1)",
                                  "(1 - \\alpha) T (2 \\alpha - 1)" });
  /* by powers of T, with factored coefficients; derivatives, the second phase's with a name of its own */
  symbolic of_T = symbolic_sub(&s, symbolic_mul(&s, m1, symbolic_place(&s, 6)),
                               symbolic_mul(&s, symbolic_mul(&s, T, T), symbolic_mul(&s, sum, symbolic_place(&s, 7))));
  struct written text = symbolic_written(&s, of_T, 0, &language_text),
                 latex = symbolic_written(&s, of_T, 0, &language_latex);
  assert_string_equal(text.text, "(m1*l3_0 - l3_T_c*T^2*(F1 - F2))");
  assert_string_equal(latex.text, "(m_{1} l_{3,0} - l_{3,T,c} T^{2} (F_{1} - F_{2}))");
  free(text.text);
  free(latex.text);
  symbols_end(&s);
}

static void check_decimal(const char *decimal, slong power, const char *const wanted[LANGUAGES])
{
  for (int i = 0; i < LANGUAGES; i++) {
    struct written written = decimal_written(decimal, power, languages[i]);
    assert_string_equal(written.text, wanted[i]);
    assert_true(written.negative == (*decimal == '-'));
    free(written.text);
  }
}

TEST(decimal_numbers)
{
  check_decimal("-1.25", 0, (const char *[]){ "1.25", "1.25", "1.25" });
  check_decimal("1.25e-7", 2, (const char *[]){ "1.25e-7*T^2", "1.25e-7*T**2", "1.25 \\cdot 10^{-7} T^{2}" });
}

TEST(symbols_that_are_used)
{
  struct symbols s = list();
  bool used[MOST_SYMBOLS] = { false };
  used[1] = true; /* stays */
  symbolic_uses(symbolic_div(&s, symbolic_place(&s, 0), symbolic_place(&s, 3)), &s, used);
  for (int i = 0; i < s.count; i++)
    assert_true(used[i] == (i == 0 || i == 1 || i == 3));
  char *name = symbol_written(&s.list[4], &language_python), *index = symbol_written(&s.list[0], &language_latex);
  assert_string_equal(name, "(1 - alpha)");
  assert_string_equal(index, "m_{1}");
  free(name);
  free(index);
  symbols_end(&s);
}
