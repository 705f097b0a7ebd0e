/* Values in factored form, written in three languages */
#include "asymptotics/symbolic/language.h"

#include <stdio.h>
#include <string.h>

#include <flint/fmpz_mpoly_factor.h>

#include "model/exact/scoped.h"

#define LIKE_C \
  .times = "*", .fraction = { "", "/", "" }, .subscript = { "", "" }, .alpha = "alpha", .difference = "d", .slash = true

const struct language language_text = { .name = "text", LIKE_C, .power = { "^", "" } },
                      language_python = { .name = "python", LIKE_C, .power = { "**", "" } },
                      language_latex = { .name = "latex",
                                         .times = " ",
                                         .power = { "^{", "}" },
                                         .fraction = { "\\frac{", "}{", "}" },
                                         .subscript = { "_{", "}" },
                                         .alpha = "\\alpha",
                                         .difference = "\\Delta ",
                                         .ten = { " \\cdot 10^{", "}" } };

struct writer {
  FILE *out;
  struct symbols *symbols;
  const struct language *language;
  slong T; /* index of T in the list, -1 if absent */
};

static void put(struct writer *w, const char *text) { fputs(text, w->out); }

static void put_symbol(struct writer *w, const struct symbol *symbol)
{
  const struct language *l = w->language;
  char index[SYMBOL_NAME];
  if (symbol->meaning == NAMED_alpha || symbol->meaning == NAMED_beta) {
    fprintf(w->out, symbol->meaning == NAMED_beta ? "(1 - %s)" : "%s", l->alpha);
    return;
  }
  snprintf(index, sizeof index, "%s", symbol->name + 1);
  for (char *gap = index; !l->slash && (gap = strchr(gap, '_'));) /* l3_0 has the indices 3 and 0 */
    *gap = ',';
  fprintf(w->out, "%c", symbol->name[0]);
  if (*index)
    fprintf(w->out, "%s%s%s", l->subscript[0], index, l->subscript[1]);
}

static void put_number(struct writer *w, const fmpz_t number)
{
  char *text = fmpz_get_str(NULL, 10, number);
  put(w, text);
  flint_free(text);
}

/* Writes an exponent after its base, unless it is 1. */
static void put_power(struct writer *w, slong power)
{
  if (power != 1)
    fprintf(w->out, "%s%ld%s", w->language->power[0], (long)power, w->language->power[1]);
}

static void put_times(struct writer *w, bool *any)
{
  put(w, *any ? w->language->times : "");
  *any = true;
}

static void put_symbol_power(struct writer *w, slong place, slong power, bool *any)
{
  static const struct symbol time = { .meaning = NAMED_T, .name = "T" };
  put_times(w, any);
  put_symbol(w, place < 0 ? &time : &w->symbols->list[place]);
  put_power(w, power);
}

static void put_sign(struct writer *w, bool negative, bool first)
{
  put(w, first ? negative ? "-" : "" : negative ? " - " : " + ");
}

/* Writes a polynomial as the sum of its terms. */
static void put_terms(struct writer *w, const fmpz_mpoly_t polynomial)
{
  const fmpz_mpoly_ctx_struct *ring = w->symbols->names.ring;
  ulong powers[MOST_SYMBOLS];
  SCOPED(fmpz, coefficient);
  for (slong i = 0; i < fmpz_mpoly_length(polynomial, ring); i++) {
    bool any = false, constant = true;
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, i, ring);
    fmpz_mpoly_get_term_exp_ui(powers, polynomial, i, ring);
    for (int j = 0; j < w->symbols->count; j++)
      constant &= powers[j] == 0;
    put_sign(w, fmpz_sgn(coefficient) < 0, i == 0);
    fmpz_abs(coefficient, coefficient);
    if (!fmpz_is_one(coefficient) || constant) {
      put_times(w, &any);
      put_number(w, coefficient);
    }
    for (int j = 0; j < w->symbols->count; j++)
      if (powers[j] > 0)
        put_symbol_power(w, j, (slong)powers[j], &any);
  }
}

static slong power_of_T(const struct writer *w, const fmpz_mpoly_t polynomial)
{
  return w->T < 0 ? 0 : fmpz_mpoly_degree_si(polynomial, w->T, w->symbols->names.ring);
}

static void put_product(struct writer *w, const fmpz_mpoly_t polynomial, slong power);

/* Writes a polynomial by powers of T, with factored coefficients. */
static void put_by_powers(struct writer *w, const fmpz_mpoly_t polynomial)
{
  const fmpz_mpoly_ctx_struct *ring = w->symbols->names.ring;
  fmpz_mpoly_t coefficient;
  bool first = true;
  fmpz_mpoly_init(coefficient, ring);
  for (ulong k = 0; (slong)k <= power_of_T(w, polynomial); k++) {
    fmpz_mpoly_get_coeff_vars_ui(coefficient, polynomial, &w->T, &k, 1, ring);
    if (fmpz_mpoly_is_zero(coefficient, ring))
      continue;
    bool negative = fmpz_sgn(coefficient->coeffs) < 0;
    put_sign(w, negative, first);
    first = false;
    if (negative)
      fmpz_mpoly_neg(coefficient, coefficient, ring);
    put_product(w, coefficient, (slong)k);
  }
  fmpz_mpoly_clear(coefficient, ring);
}

/* Replaces beta by 1 - alpha in factors of alpha and beta, both present, alone; removes factors that become 1. */
static void write_in_alpha(fmpz_mpoly_factor_t factors, const struct symbols *s)
{
  const fmpz_mpoly_ctx_struct *ring = s->names.ring;
  fmpz_mpoly_struct instead[MOST_SYMBOLS], *list[MOST_SYMBOLS];
  int used[MOST_SYMBOLS], alpha = -1, beta = -1;
  for (int i = 0; i < s->count; i++) {
    fmpz_mpoly_init(&instead[i], ring);
    fmpz_mpoly_gen(&instead[i], i, ring);
    list[i] = &instead[i];
    alpha = s->list[i].meaning == NAMED_alpha ? i : alpha;
    beta = s->list[i].meaning == NAMED_beta ? i : beta;
  }
  if (beta >= 0) {
    fmpz_mpoly_neg(&instead[beta], &instead[alpha], ring);
    fmpz_mpoly_add_si(&instead[beta], &instead[beta], 1, ring);
  }
  for (slong i = 0; beta >= 0 && i < factors->num; i++) {
    fmpz_mpoly_used_vars(used, factors->poly + i, ring);
    bool others = !used[alpha] || !used[beta];
    for (int j = 0; j < s->count; j++)
      others |= used[j] && j != alpha && j != beta;
    if (!others)
      fmpz_mpoly_compose_fmpz_mpoly(factors->poly + i, factors->poly + i, list, ring, ring);
    if (fmpz_mpoly_is_one(factors->poly + i, ring))
      fmpz_zero(factors->exp + i);
  }
  for (int i = 0; i < s->count; i++)
    fmpz_mpoly_clear(&instead[i], ring);
}

/* Returns the count of written factors, without the number 1. */
static slong count_factors(const fmpz_mpoly_factor_t factors, slong power)
{
  slong count = (power != 0) + !fmpz_is_one(factors->constant);
  for (slong i = 0; i < factors->num; i++)
    count += !fmpz_is_zero(factors->exp + i);
  return count;
}

/* Writes the number, the symbols in the order of the list, T^power, and the sums. alone: no neighbour needs
 * brackets. */
static void put_factors(struct writer *w, const fmpz_mpoly_factor_t factors, slong power, bool alone)
{
  const struct symbols *s = w->symbols;
  slong count = count_factors(factors, power);
  bool any = false;
  if (!fmpz_is_one(factors->constant) || count == 0) {
    put_times(w, &any);
    put_number(w, factors->constant);
  }
  for (slong place = 0; place < s->count; place++)
    for (slong i = 0; i < factors->num; i++)
      if (fmpz_mpoly_is_gen(factors->poly + i, place, s->names.ring))
        put_symbol_power(w, place, fmpz_get_si(factors->exp + i), &any);
  if (power != 0)
    put_symbol_power(w, -1, power, &any);
  for (slong i = 0; i < factors->num; i++) {
    const fmpz_mpoly_struct *sum = factors->poly + i;
    slong exponent = fmpz_get_si(factors->exp + i);
    if (exponent == 0 || fmpz_mpoly_is_gen(sum, -1, s->names.ring))
      continue;
    bool bare = alone && count == 1 && exponent == 1;
    put_times(w, &any);
    put(w, bare ? "" : "(");
    (power_of_T(w, sum) > 0 ? put_by_powers : put_terms)(w, sum);
    put(w, bare ? "" : ")");
    put_power(w, exponent);
  }
}

/* Factors a polynomial, see write_in_alpha. */
static void factor(fmpz_mpoly_factor_t factors, const fmpz_mpoly_t polynomial, const struct symbols *s)
{
  if (!fmpz_mpoly_factor(factors, polynomial, s->names.ring)) {         /* only if exponents overflow */
    fmpz_mpoly_factor_one(factors, s->names.ring);                      /* GCOVR_EXCL_LINE */
    fmpz_mpoly_factor_append_ui(factors, polynomial, 1, s->names.ring); /* GCOVR_EXCL_LINE */
  }
  fmpz_mpoly_factor_sort(factors, s->names.ring); /* an order independent of FLINT's */
  write_in_alpha(factors, s);
}

static void put_product(struct writer *w, const fmpz_mpoly_t polynomial, slong power)
{
  fmpz_mpoly_factor_t factors;
  fmpz_mpoly_factor_init(factors, w->symbols->names.ring);
  factor(factors, polynomial, w->symbols);
  put_factors(w, factors, power, false);
  fmpz_mpoly_factor_clear(factors, w->symbols->names.ring);
}

static struct writer writer_of(struct symbols *s, const struct language *language, char **text, size_t *size)
{
  struct writer w = { open_memstream(text, size), s, language, -1 };
  for (int i = 0; i < s->count; i++)
    if (s->list[i].meaning == NAMED_T)
      w.T = i;
  return w;
}

struct written symbolic_written(struct symbols *s, symbolic a, slong power, const struct language *language)
{
  struct written written = { !ratio_is_zero(a) && fmpz_sgn(a->over->coeffs) < 0, NULL };
  size_t size;
  struct writer w = writer_of(s, language, &written.text, &size);
  fmpz_mpoly_factor_t over, under;
  fmpz_mpoly_factor_init(over, s->names.ring);
  fmpz_mpoly_factor_init(under, s->names.ring);
  factor(over, a->over, s);
  factor(under, a->under, s);
  fmpz_abs(over->constant, over->constant);
  slong below = power < 0 ? -power : 0, divisors = count_factors(under, below);
  bool brackets = language->slash && divisors > 1;
  put(&w, divisors > 0 ? language->fraction[0] : "");
  put_factors(&w, over, power > 0 ? power : 0, divisors > 0 && !language->slash);
  if (divisors > 0) {
    put(&w, language->fraction[1]);
    put(&w, brackets ? "(" : "");
    put_factors(&w, under, below, !language->slash);
    put(&w, brackets ? ")" : "");
    put(&w, language->fraction[2]);
  }
  fmpz_mpoly_factor_clear(over, s->names.ring);
  fmpz_mpoly_factor_clear(under, s->names.ring);
  fclose(w.out);
  return written;
}

struct written decimal_written(const char *decimal, slong power, const struct language *language)
{
  struct written written = { *decimal == '-', NULL };
  size_t size;
  struct symbols none = { .count = 0 };
  struct writer w = writer_of(&none, language, &written.text, &size);
  const char *digits = decimal + written.negative, *e = language->slash ? NULL : strchr(digits, 'e');
  bool any = true;
  fprintf(w.out, "%.*s", (int)(e ? e - digits : (long)strlen(digits)), digits);
  if (e)
    fprintf(w.out, "%s%s%s", language->ten[0], e + 1, language->ten[1]);
  if (power != 0)
    put_symbol_power(&w, -1, power, &any);
  fclose(w.out);
  return written;
}

char *symbol_written(const struct symbol *symbol, const struct language *language)
{
  char *text;
  size_t size;
  struct symbols none = { .count = 0 };
  struct writer w = writer_of(&none, language, &text, &size);
  put_symbol(&w, symbol);
  fclose(w.out);
  return text;
}

void symbolic_uses(symbolic a, const struct symbols *s, bool *used)
{
  int over[MOST_SYMBOLS], under[MOST_SYMBOLS];
  fmpz_mpoly_used_vars(over, a->over, s->names.ring);
  fmpz_mpoly_used_vars(under, a->under, s->names.ring);
  for (int i = 0; i < s->count; i++)
    used[i] |= over[i] || under[i];
}
