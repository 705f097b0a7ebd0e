/* The derived expansion of a motion minus that of a formula, term by term. */
#include "asymptotics/symbolic/left_out.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/scoped.h"
#include "asymptotics/published/read.h"
#include "asymptotics/symbolic/formula_symbolic.h"
#include "asymptotics/symbolic/language.h"
#include "asymptotics/symbolic/reduced.h"

/* The motion that a formula is about, as formulas */
struct motion {
  const struct scallop_rational_crawler *crawler;
  enum scallop_phase_kind kind;
  bool is_steady, from_rest, exchanged;
  bool equal_forces; /* of all crawlers that the formula is about                                */
  struct symbols symbols;
  struct symbolic_phase phase;
  struct symbolic_steady steady;
};

/* The symbols that are a derivative of l at an end of the phase */
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

/* Of a gait that is not rational pi is 1 in it. */
static void in_amplitudes(fmpq_t value, const struct symbol *symbol, const struct scallop_rational_crawler *crawler)
{
  const struct symbols one = { .count = 1, .list = { *symbol } };
  fmpq *values = _fmpq_vec_init(1), *unit = _fmpq_vec_init(1);
  fmpq_one(unit);
  symbols_values(values, &one, crawler, NULL, unit);
  fmpq_div(value, values, crawler->L);
  _fmpq_vec_clear(values, 1);
  _fmpq_vec_clear(unit, 1);
}

static symbolic derivative_value(struct motion *m, const struct derivative *d)
{
  const struct symbol symbol = { .meaning = d->meaning, .derivative = d->derivative, .kind = m->kind };
  struct symbols *s = &m->symbols;
  SCOPED(fmpq, value);
  in_amplitudes(value, &symbol, m->crawler);
  int place = symbols_place(s, d->meaning, d->derivative, m->kind);
  symbolic in_L = place >= 0 ? symbolic_place(s, place)
                             : symbolic_mul(s, symbolic_fraction(s, value), symbolic_named(s, NAMED_L));
  return in_L;
}

/* Is pi in the formula, or in the law of the gait? */
static bool needs_pi(const struct motion *m, const struct formula *formula)
{
  bool needs = !scallop_gait_is_rational(m->crawler->gait);
  for (int i = 0; i < formula->count; i++)
    needs = needs || formula->steps[i].operation == FORMULA_PI;
  return needs;
}

/* The symbols of a phase in their usual order, and those of the formula that the phase does without */
static void list_symbols(struct motion *m, const struct formula *formula)
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

/* How many terms of a phase are needed: formulas divide what is given by powers of T. */
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

static const char *expand(struct motion *m, const struct formula *formula, const fmpq_t v0, slong power)
{
  const char *why = NULL;
  symbols_init(&m->symbols);
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

/* What the formula gives, as the motion has it; false: it has no formula. */
static bool derive(struct symbolic_laurent *derived, struct motion *m, enum scallop_quantity quantity, slong power)
{
  struct symbols *s = &m->symbols;
  const struct symbolic_phase *p = &m->phase;
  const bool extension = m->kind == SCALLOP_EXTENSION;
  const struct symbolic_series *series = NULL,
                               none = symbolic_series_set(s, symbolic_number(s, 0, 1), 0, SYMBOLIC_TERMS);
  symbolic closed = NULL;
  slong first = 0;
  switch (quantity) {
  case SCALLOP_LAG: series = p->switches ? &p->dT : NULL; break;
  case SCALLOP_FIRST_SWITCH: series = p->switches ? &p->t1 : NULL; break;
  case SCALLOP_REAR_AT_END: series = extension ? &p->dx1 : &p->dx2; break;
  case SCALLOP_FRONT_AT_END: series = extension ? &p->dx2 : &p->dx1; break;
  case SCALLOP_REAR_AT_FIRST: series = p->switches ? &p->at_first : NULL; break;
  case SCALLOP_REAR_AT_LAST: series = p->switches ? &p->at_last : NULL; break;
  case SCALLOP_CENTRE_AT_END: series = &p->dxC; break;
  case SCALLOP_VELOCITY_AT_END:
  case SCALLOP_VELOCITY_CHANGE: series = &p->v_end; break;
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: series = p->switches ? &none : NULL; break;
  case SCALLOP_STEADY_VELOCITY: closed = m->steady.v_start, first = -1; break;
  case SCALLOP_STEADY_V_MID: closed = m->steady.v_mid, first = -1; break;
  case SCALLOP_STEADY_DISPLACEMENT: closed = m->steady.displacement; break;
  case SCALLOP_STEADY_MEAN_VELOCITY: closed = m->steady.displacement, first = -1; break;
  default: return false;
  }
  if (closed) {
    const slong before = quantity == SCALLOP_STEADY_MEAN_VELOCITY ? 0 : first;
    const struct symbolic_series of_closed = symbolic_series_of(s, closed, before,
                                                                power < first ? 1 : power - first + 1);
    *derived = symbolic_laurent_of(s, &of_closed, first);
  } else if (series)
    *derived = symbolic_laurent_of(s, series, 0);
  if (series && quantity == SCALLOP_VELOCITY_CHANGE) {
    const struct symbolic_laurent v0 = symbolic_laurent_set(s, symbolic_named(s, NAMED_v0), 0);
    *derived = symbolic_laurent_sub(s, derived, &v0);
  }
  return closed || series;
}

struct values { /* in a formula; NULL: without a value here */
  struct symbolic_laurent value[SCALLOP_SYMBOLS];
  const struct symbolic_laurent *list[SCALLOP_SYMBOLS];
};

static void set_name(struct values *names, enum scallop_symbol symbol, struct symbolic_laurent value)
{
  names->value[symbol] = value;
  names->list[symbol] = &names->value[symbol];
}

static void set_symbol(struct values *names, struct symbols *s, enum scallop_symbol symbol, symbolic value)
{
  set_name(names, symbol, symbolic_laurent_set(s, value, 0));
}

static void set_kinematic_length(struct values *names, struct motion *m, symbolic l0, symbolic lT)
{
  struct symbols *s = &m->symbols;
  symbolic difference = symbolic_sub(s, lT, l0), twice = symbolic_number(s, m->kind == SCALLOP_EXTENSION ? 2 : -2, 1);
  if (!symbolic_is_zero(difference, s))
    set_symbol(names, s, SCALLOP_SYMBOL_L_kin,
               symbolic_div(s, symbolic_mul(s, l0, lT), symbolic_mul(s, twice, difference)));
}

/* The bodies exchanged, and with them the sign of l */
static void exchange_names(struct values *names, struct symbols *s)
{
  const struct values before = *names;
  const struct symbolic_laurent none = symbolic_laurent_set(s, symbolic_number(s, 0, 1), 0);
  for (int i = 0, sign; i < SCALLOP_SYMBOLS; i++) {
    enum scallop_symbol meant = scallop_symbol_exchanged((enum scallop_symbol)i, &sign);
    const struct symbolic_laurent *value = before.list[meant] ? &before.value[meant] : NULL;
    if (!value)
      names->list[i] = NULL;
    else
      set_name(names, (enum scallop_symbol)i, sign < 0 ? symbolic_laurent_sub(s, &none, value) : *value);
  }
}

static void set_names(struct values *names, struct motion *m)
{
  static const struct {
    enum scallop_symbol symbol;
    enum symbol_meaning meaning;
  } plain[] = { { SCALLOP_SYMBOL_m1, NAMED_m1 }, { SCALLOP_SYMBOL_m2, NAMED_m2 },      { SCALLOP_SYMBOL_F1, NAMED_F1 },
                { SCALLOP_SYMBOL_F2, NAMED_F2 }, { SCALLOP_SYMBOL_M, NAMED_M },        { SCALLOP_SYMBOL_L, NAMED_L },
                { SCALLOP_SYMBOL_v0, NAMED_v0 }, { SCALLOP_SYMBOL_alpha, NAMED_alpha } };
  struct symbols *s = &m->symbols;
  symbolic ends[DERIVATIVES], none = symbolic_number(s, 0, 1), L = symbolic_named(s, NAMED_L);
  bool extension = m->kind == SCALLOP_EXTENSION;
  for (int i = 0; i < SCALLOP_SYMBOLS; i++)
    names->list[i] = NULL;
  for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
    if (symbols_place(s, plain[i].meaning, 0, m->kind) >= 0)
      set_symbol(names, s, plain[i].symbol, symbolic_named(s, plain[i].meaning));
  if (m->from_rest)
    set_symbol(names, s, SCALLOP_SYMBOL_v0, none);
  for (int i = 0; i < DERIVATIVES; i++)
    set_symbol(names, s, derivatives[i].symbol, ends[i] = derivative_value(m, &derivatives[i]));
  set_kinematic_length(names, m, ends[0], ends[1]);
  set_symbol(names, s, SCALLOP_SYMBOL_l_start, extension ? none : L);
  set_symbol(names, s, SCALLOP_SYMBOL_l_end, extension ? L : none);
  set_name(names, SCALLOP_SYMBOL_T, symbolic_laurent_set(s, symbolic_number(s, 1, 1), 1));
  if (!m->is_steady && m->phase.switches) {
    set_name(names, SCALLOP_SYMBOL_t1, symbolic_laurent_of(s, &m->phase.t1, 0));
    set_name(names, SCALLOP_SYMBOL_dT, symbolic_laurent_of(s, &m->phase.dT, 0));
    set_name(names, SCALLOP_SYMBOL_x_switch, symbolic_laurent_of(s, &m->phase.at_last, 0));
  }
  if (m->exchanged)
    exchange_names(names, s);
}

/* A derivative of l as this gait has it: a number of amplitudes, times a power of pi */
static void replace_derivative(struct replacement *replaced, const struct motion *m, int place)
{
  const struct symbol *symbol = &m->symbols.list[place];
  in_amplitudes(replaced->times, symbol, m->crawler);
  replaced->by = symbols_place(&m->symbols, NAMED_L, 0, m->kind);
  replaced->pi_power = scallop_gait_is_rational(m->crawler->gait) ? 0 : symbol->derivative;
}

/* F2 is F1 where the forces of all these crawlers are equal. */
static void replace(struct replacement replaced[MOST_SYMBOLS], const struct motion *m, bool of_gait)
{
  const struct symbols *s = &m->symbols;
  if (m->equal_forces)
    replaced[symbols_place(s, NAMED_F2, 0, m->kind)].by = symbols_place(s, NAMED_F1, 0, m->kind);
  for (int i = 0; of_gait && i < s->count; i++)
    if (s->list[i].derivative > 0)
      replace_derivative(&replaced[i], m, i);
}

static slong length_of(symbolic a, const struct symbols *s)
{
  return fmpz_mpoly_length(a->over, s->ring) + fmpz_mpoly_length(a->under, s->ring);
}

/* The coefficient of T^power, NULL: it is not known. of_gait: as this gait has the derivatives of l. With M and beta as
 * they stand, if that is shorter */
static symbolic coefficient_of(struct motion *m, const struct symbolic_laurent *difference, slong power, bool of_gait)
{
  struct replacement replaced[MOST_SYMBOLS];
  struct symbols *s = &m->symbols;
  symbolic term = symbolic_laurent_term(s, difference, power), reduced, other;
  if (!term)
    return NULL;
  replacements_init(replaced);
  replace(replaced, m, of_gait);
  reduced = symbolic_reduced(s, term, replaced);
  other = symbolic_replaced(s, term, replaced);
  replacements_clear(replaced);
  return reduced && other && !symbolic_is_zero(reduced, s) && length_of(other, s) < length_of(reduced, s) ? other
                                                                                                          : reduced;
}

/* The first power up to T^most whose coefficient is not 0, or most + 1. False: one is not known. */
static bool first_power(slong *power, struct motion *m, const struct symbolic_laurent *difference, slong most,
                        bool of_gait)
{
  symbolic found = NULL;
  for (*power = difference->first < most ? difference->first : most; *power <= most; ++*power)
    if (!(found = coefficient_of(m, difference, *power, of_gait)) || !symbolic_is_zero(found, &m->symbols))
      break;
  return *power > most || found;
}

static char *write(struct motion *m, symbolic found, slong power)
{
  struct written written = symbolic_written(&m->symbols, found, power, &language_text);
  size_t size = strlen(written.text) + 2;
  char *text = flint_malloc(size);
  snprintf(text, size, "%s%s", written.negative ? "-" : "", written.text);
  free(written.text);
  return text;
}

static void evaluate(fmpq_t coefficient, const struct motion *m, symbolic found, const fmpq_t v0)
{
  fmpq *values = _fmpq_vec_init(m->symbols.count);
  symbols_values(values, &m->symbols, m->crawler, v0, NULL);
  symbolic_value(coefficient, found, &m->symbols, values);
  _fmpq_vec_clear(values, m->symbols.count);
}

static const char *find(struct left_out *l, struct motion *m, const struct formula *formula,
                        enum scallop_quantity quantity, const fmpq_t v0, slong most, char message[FORMULA_MESSAGE])
{
  struct symbolic_laurent derived, value;
  struct values *names = flint_malloc(sizeof *names);
  const char *why = NULL;
  set_names(names, m);
  if (!derive(&derived, m, quantity, most))
    why = "this quantity is not derived as a formula";
  else if (!formula_symbolic(&value, formula, names->list, &m->symbols, message)) {
    const struct symbolic_laurent difference = symbolic_laurent_sub(&m->symbols, &derived, &value);
    slong of_any_gait;
    if (!first_power(&l->order, m, &difference, most, true))
      why = "too few terms are known";
    else if (l->order <= most) {
      bool general = first_power(&of_any_gait, m, &difference, most, false) && of_any_gait == l->order;
      symbolic found = coefficient_of(m, &difference, l->order, !general);
      l->term = write(m, found, l->order);
      l->is_number = !needs_pi(m, formula);
      if (l->is_number)
        evaluate(l->coefficient, m, found, v0);
    }
  } else
    why = message;
  flint_free(names);
  if (why && why != message)
    snprintf(message, FORMULA_MESSAGE, "%s", why);
  return why ? message : NULL;
}

void left_out_init(struct left_out *l)
{
  *l = (struct left_out){ .term = NULL };
  fmpq_init(l->coefficient);
}

void left_out_clear(struct left_out *l)
{
  free(l->term);
  fmpq_clear(l->coefficient);
}

const char *symbolic_left_out(struct left_out *l, const struct scallop_formula *f,
                              const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                              const fmpq_t v0, slong most, char message[FORMULA_MESSAGE])
{
  struct motion m = { .crawler = crawler,
                      .kind = kind,
                      .is_steady = f->setting == SCALLOP_STEADY,
                      .from_rest = f->setting == SCALLOP_AT_REST_START,
                      .exchanged = scallop_formula_is_exchanged(f, kind) };
  struct formula formula;
  /* from rest no body turns where F1 = F2: these modes say so */
  m.equal_forces = m.from_rest;
  for (const char *const *when = f->when; when && *when; when++)
    m.equal_forces = m.equal_forces || scallop_condition_is_equal_forces(*when);
  m.equal_forces = m.equal_forces && fmpq_equal(crawler->F1, crawler->F2);
  if (scallop_formula_text(&formula, f, NULL, message))
    return message;
  const char *why = most >= SYMBOLIC_ORDERS ? "the order is not below 16" : expand(&m, &formula, v0, most);
  if (why) {
    snprintf(message, FORMULA_MESSAGE, "%s", why);
    return message;
  }
  why = find(l, &m, &formula, f->quantity, v0, most, message);
  symbols_end(&m.symbols);
  return why;
}
