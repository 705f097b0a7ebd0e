/* The derived expansion of a motion minus the expansion of a formula, term by term */
#include "asymptotics/symbolic/left_out.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/published/read.h"
#include "asymptotics/symbolic/language.h"
#include "asymptotics/symbolic/reduced.h"

/* The motion of a formula, expanded in symbols */
struct expanded_motion {
  const struct scallop_rational_crawler *crawler;
  enum scallop_phase_kind kind;
  bool is_steady, from_rest;
  bool equal_forces; /* for all crawlers of the formula */
  struct symbols symbols;
  struct scallop_expansion phase;
  struct symbolic_steady steady;
};

static void motion_end(struct expanded_motion *m)
{
  scallop_expansion_clear(&m->phase);
  symbols_end(&m->symbols);
}

/* The symbols of derivatives of l at one end of the phase */
struct derivative {
  enum scallop_symbol symbol;
  enum symbol_meaning meaning;
  int derivative;
};
static const struct derivative derivatives[] = { { SCALLOP_SYMBOL_l0, NAMED_AT_START, 2 },
                                                 { SCALLOP_SYMBOL_lT, NAMED_AT_END, 2 },
                                                 { SCALLOP_SYMBOL_k0, NAMED_AT_START, 4 },
                                                 { SCALLOP_SYMBOL_kT, NAMED_AT_END, 4 } };
enum { DERIVATIVES = sizeof derivatives / sizeof *derivatives };

/* Computes a derivative as a number of amplitudes; pi is 1 in it unless the gait is rational. */
static void in_amplitudes(fmpq_t value, const struct symbol *symbol, const struct scallop_rational_crawler *crawler)
{
  SCOPED(fmpq, one);
  fmpq_one(one);
  symbol_value(value, symbol, crawler, NULL, one);
  fmpq_div(value, value, crawler->L);
}

static symbolic derivative_value(struct expanded_motion *m, const struct derivative *d)
{
  const struct symbol symbol = { .meaning = d->meaning, .derivative = d->derivative, .kind = m->kind };
  struct symbols *s = &m->symbols;
  SCOPED(fmpq, value);
  in_amplitudes(value, &symbol, m->crawler);
  const int place = symbols_place(s, d->meaning, d->derivative, m->kind);
  return place >= 0 ? symbolic_place(s, place)
                    : symbolic_mul(s, symbolic_fraction(s, value), symbolic_named(s, NAMED_L));
}

/* Returns true if the formula or the law of the gait contains pi. */
static bool needs_pi(const struct expanded_motion *m, const struct formula *formula)
{
  bool needs = !scallop_gait_is_rational(m->crawler->gait);
  for (int i = 0; i < formula->count; i++)
    needs = needs || formula->steps[i].operation == FORMULA_PI;
  return needs;
}

/* Lists the symbols of a phase in their usual order, and further symbols of the formula. */
static void list_symbols(struct expanded_motion *m, const struct formula *formula)
{
  static const enum symbol_meaning first[] = { NAMED_m1, NAMED_m2, NAMED_M, NAMED_F1, NAMED_F2, NAMED_L, NAMED_v0 };
  int places[FORMULA_STEPS], count = formula_places(formula, places);
  SCOPED(fmpq, value);
  for (size_t i = 0; i < sizeof first / sizeof *first; i++)
    symbols_add(&m->symbols, first[i], 0, m->kind);
  for (int i = 0; i < count; i++) {
    if (places[i] == SCALLOP_SYMBOL_alpha)
      symbols_add(&m->symbols, NAMED_alpha, 0, m->kind);
    for (const struct derivative *d = derivatives; d < derivatives + DERIVATIVES; d++) {
      const struct symbol symbol = { .meaning = d->meaning, .derivative = d->derivative, .kind = m->kind };
      in_amplitudes(value, &symbol, m->crawler);
      bool used = places[i] == (int)d->symbol || (places[i] == SCALLOP_SYMBOL_L_kin && d->derivative == 2);
      if (used && !fmpq_is_zero(value))
        symbols_add(&m->symbols, d->meaning, d->derivative, m->kind);
    }
  }
}

/* Returns the count of terms of a phase that is required: formulas divide given values by powers of T. */
static slong terms_for(const struct formula *formula, slong power)
{
  enum { MORE = 4 };
  int places[FORMULA_STEPS], count = formula_places(formula, places);
  bool divides = false;
  for (int i = 0; i < count; i++)
    divides = divides || places[i] == SCALLOP_SYMBOL_t1 || places[i] == SCALLOP_SYMBOL_dT
              || places[i] == SCALLOP_SYMBOL_x_switch;
  slong terms = (power < 0 ? 1 : power + 1) + (divides ? MORE : 0);
  return terms < SYMBOLIC_ORDERS ? terms : SYMBOLIC_ORDERS;
}

static const char *expand(struct expanded_motion *m, const struct formula *formula, const fmpq_t v0, slong power)
{
  const char *why = NULL;
  if (needs_pi(m, formula))
    symbols_add(&m->symbols, NAMED_pi, 0, m->kind);
  if (m->is_steady && !scallop_gait_is_rational(m->crawler->gait))
    return "the closed form of the steady state is for rational gaits";
  if (!m->is_steady)
    list_symbols(m, formula);
  enum scallop_status status = m->is_steady ? symbolic_solve_steady(&m->symbols, m->crawler, &m->steady, &why)
                                            : symbolic_expand_phase(&m->symbols, m->crawler, m->kind, v0,
                                                                    terms_for(formula, power), &m->phase, &why);
  return status == SCALLOP_OK ? NULL : why ? why : scallop_status_text(status);
}

/* Derives the quantity of the formula for the motion; returns false if it has no formula. */
static bool derive(struct series *derived, struct expanded_motion *m, enum scallop_quantity quantity,
                   const struct ring *ring)
{
  const struct series *expanded = scallop_expansion_of(&m->phase, quantity);
  const symbolic closed = !m->is_steady                         ? NULL
                          : quantity == SCALLOP_STEADY_VELOCITY ? m->steady.v_start
                          : quantity == SCALLOP_STEADY_V_MID    ? m->steady.v_mid
                          : quantity == SCALLOP_STEADY_DISPLACEMENT || quantity == SCALLOP_STEADY_MEAN_VELOCITY
                              ? m->steady.displacement
                              : NULL;
  if (closed)
    symbolic_in_T(derived, &m->symbols, closed, ring->length);
  else if (expanded)
    series_set(derived, expanded);
  if (quantity == SCALLOP_STEADY_MEAN_VELOCITY)
    series_shift(derived, derived, -1);
  return closed || expanded;
}

/* Sets the values of the names in the formula. */
static void set_names(struct scallop_symbols *names, struct expanded_motion *m, const struct ring *ring)
{
  static const struct {
    enum scallop_symbol symbol;
    enum symbol_meaning meaning;
  } plain[] = { { SCALLOP_SYMBOL_m1, NAMED_m1 }, { SCALLOP_SYMBOL_m2, NAMED_m2 },      { SCALLOP_SYMBOL_F1, NAMED_F1 },
                { SCALLOP_SYMBOL_F2, NAMED_F2 }, { SCALLOP_SYMBOL_M, NAMED_M },        { SCALLOP_SYMBOL_L, NAMED_L },
                { SCALLOP_SYMBOL_v0, NAMED_v0 }, { SCALLOP_SYMBOL_alpha, NAMED_alpha } };
  struct symbols *s = &m->symbols;
  struct series *value = names->value;
  names->names = &s->names;
  for (int i = 0; i < SCALLOP_SYMBOLS; i++)
    series_set_unknown(&value[i]);
  for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
    if (symbols_place(s, plain[i].meaning, 0, m->kind) >= 0)
      series_set_ratio(&value[plain[i].symbol], symbolic_named(s, plain[i].meaning));
  if (m->from_rest)
    series_set_si(&value[SCALLOP_SYMBOL_v0], 0);
  for (int i = 0; i < DERIVATIVES; i++)
    series_set_ratio(&value[derivatives[i].symbol], derivative_value(m, &derivatives[i]));
  scallop_symbols_complete(names, m->kind, ring);
  if (!m->is_steady && m->phase.switches) {
    series_set(&value[SCALLOP_SYMBOL_t1], &m->phase.t1);
    series_set(&value[SCALLOP_SYMBOL_dT], &m->phase.dT);
    series_set(&value[SCALLOP_SYMBOL_x_switch], &m->phase.rear_at_last);
  }
}

/* Sets F2 to F1 if the forces of all these crawlers are equal. of_gait: sets derivatives of l to this gait's values, a
 * number of amplitudes, times a power of pi. */
static void set_replacements(struct replacements *r, const struct expanded_motion *m, bool of_gait)
{
  const struct symbols *s = &m->symbols;
  if (m->equal_forces)
    r->of[symbols_place(s, NAMED_F2, 0, m->kind)].by = symbols_place(s, NAMED_F1, 0, m->kind);
  for (int i = 0; of_gait && i < s->count; i++)
    if (s->list[i].derivative > 0) {
      in_amplitudes(r->of[i].times, &s->list[i], m->crawler);
      r->of[i].by = symbols_place(s, NAMED_L, 0, m->kind);
      r->of[i].pi_power = scallop_gait_is_rational(m->crawler->gait) ? 0 : s->list[i].derivative;
    }
}

static slong length_of(symbolic a, const struct symbols *s)
{
  return fmpz_mpoly_length(a->over, s->names.ring) + fmpz_mpoly_length(a->under, s->names.ring);
}

/* Returns the coefficient of T^power, NULL if unknown; with M and beta if shorter. of_gait: see set_replacements */
static symbolic coefficient_of(struct expanded_motion *m, const struct series *difference, slong power, bool of_gait)
{
  struct symbols *s = &m->symbols;
  symbolic term = symbolic_coefficient(s, difference, power);
  if (!term)
    return NULL;
  SCOPED(replacements, replacements);
  set_replacements(&replacements, m, of_gait);
  symbolic reduced = symbolic_replaced(s, term, &replacements, true),
           other = symbolic_replaced(s, term, &replacements, false);
  return reduced && other && !ratio_is_zero(reduced) && length_of(other, s) < length_of(reduced, s) ? other : reduced;
}

/* Finds the first power up to T^most with a nonzero coefficient, or most + 1. Returns false if one is unknown. */
static bool first_power(slong *power, struct expanded_motion *m, const struct series *difference, slong most,
                        bool of_gait)
{
  symbolic found = NULL;
  for (*power = difference->first < most ? difference->first : most; *power <= most; ++*power)
    if (!(found = coefficient_of(m, difference, *power, of_gait)) || !ratio_is_zero(found))
      break;
  return *power > most || found;
}

static char *write(struct expanded_motion *m, symbolic found, slong power)
{
  struct written written = symbolic_written(&m->symbols, found, power, &language_text);
  size_t size = strlen(written.text) + 2;
  char *text = flint_malloc(size);
  snprintf(text, size, "%s%s", written.negative ? "-" : "", written.text);
  free(written.text);
  return text;
}

static void evaluate(fmpq_t coefficient, const struct expanded_motion *m, symbolic found, const fmpq_t v0)
{
  fmpq *values = _fmpq_vec_init(m->symbols.count);
  symbols_values(values, &m->symbols, m->crawler, v0, NULL);
  symbolic_value(coefficient, found, &m->symbols, values);
  _fmpq_vec_clear(values, m->symbols.count);
}

static const char *find(struct left_out *l, struct expanded_motion *m, const struct scallop_formula *f, const fmpq_t v0,
                        slong most, char message[FORMULA_MESSAGE])
{
  const struct ring ring = { SYMBOLIC_ORDERS + 2, 2 };
  slong of_any_gait;
  ENDED_BY(scallop_symbols_clear) struct scallop_symbols names;
  scallop_symbols_init(&names);
  SCOPED(series, derived, value);
  set_names(&names, m, &ring);
  if (!derive(&derived, m, f->quantity, &ring))
    return "this quantity is not derived as a formula";
  if (scallop_formula_expand(&value, f, &names, m->kind, &ring, message))
    return message;
  series_sub(&value, &derived, &value, &ring);
  if (!first_power(&l->order, m, &value, most, true))
    return "too few terms are known";
  if (l->order <= most) {
    bool general = first_power(&of_any_gait, m, &value, most, false) && of_any_gait == l->order;
    symbolic found = coefficient_of(m, &value, l->order, !general);
    l->term = write(m, found, l->order);
    l->is_number = m->symbols.names.pi < 0;
    if (l->is_number)
      evaluate(l->coefficient, m, found, v0);
  }
  return NULL;
}

void left_out_init(struct left_out *l)
{
  *l = (struct left_out){ .term = NULL };
  fmpq_init(l->coefficient);
}

void left_out_clear(struct left_out *l)
{
  free(l->term); /* cppcheck-suppress ctuuninitvar ; left_out_init comes first */
  fmpq_clear(l->coefficient);
}

const char *symbolic_left_out(struct left_out *l, const struct scallop_formula *f,
                              const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                              const fmpq_t v0, slong most, char message[FORMULA_MESSAGE])
{
  ENDED_BY(motion_end)
  struct expanded_motion m = { .crawler = crawler,
                               .kind = kind,
                               .is_steady = f->setting == SCALLOP_STEADY,
                               .from_rest = f->setting == SCALLOP_AT_REST_START };
  struct formula formula;
  symbols_init(&m.symbols);
  scallop_expansion_init(&m.phase);
  /* from rest no body turns if F1 = F2: these modes imply it */
  m.equal_forces = m.from_rest;
  for (const char *const *when = f->when; when && *when; when++)
    m.equal_forces = m.equal_forces || scallop_condition_is_equal_forces(*when);
  m.equal_forces = m.equal_forces && fmpq_equal(crawler->F1, crawler->F2);
  if (scallop_formula_text(&formula, f, NULL, message))
    return message;
  const char *why = most >= SYMBOLIC_ORDERS ? "the order is not below 16" : expand(&m, &formula, v0, most);
  if (!why)
    why = find(l, &m, f, v0, most, message);
  if (why && why != message)
    snprintf(message, FORMULA_MESSAGE, "%s", why);
  return why ? message : NULL;
}
