/* Error of a formula, the derived expansion minus the formula, in numbers and in symbols; and the verdict. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/symbolic/left_out.h"
#include "compare/claims/decide.h"
#include "compare/points/point_flint.h"
#include "compare/text/progress.h"

enum { MANY_TERMS = 48, PRECISION = 1400, MAX_POWER_OF_EQUALITY = 11, DIGITS = 12 };

struct proof {
  struct claim_row *row; /* derived_order: of the first coefficient that is not exactly 0 */
  struct trial *m;
  const struct scallop_formula *f;
  struct series *left_out;
  slong general;             /* order for all parameters with these modes; if unknown, the row's */
  bool for_all;              /* general is known, and equals the row's */
  slong for_all_below;       /* coefficients below this power vanish for all parameters; 0: unknown */
  char why[FORMULA_MESSAGE]; /* reason why the formula has no expansion */
};

__attribute__((format(printf, 2, 3))) static void add_reason(struct claim_row *row, const char *format, ...)
{
  char reason[sizeof row->reason];
  va_list values;
  va_start(values, format);
  vsnprintf(reason, sizeof reason, format, values);
  va_end(values);
  append(row->reason, sizeof row->reason, "%s%s", *row->reason ? "; " : "", reason);
}

/* Sets left_out to derived - formula, both with the given number of terms. False: the formula has no expansion. */
static bool set_left_out(struct series *left_out, struct proof *p, slong terms)
{
  const struct trial *m = p->m;
  const struct scallop_formula *f = p->f;
  const struct ring ring = { terms, PRECISION };
  const struct scallop_expansion *phase = &m->series.phase;
  const struct series *const given[] = { &phase->t1, &phase->dT, &phase->rear_at_last };
  SCOPED(scallop_symbols, symbols);
  SCOPED(series, value);
  series_set(left_out, trial_series(m, f->quantity));
  if (!f->text) {
    series_set_zero(left_out, trial_leading_power(f));
    return true;
  }
  scallop_symbols_set(&symbols, &m->crawler, m->condition->kind, m->v0, NULL, &ring);
  for (int i = 0; i < 3; i++)
    if (phase->switches || trial_is_steady(m))
      series_set(&symbols.value[SCALLOP_SYMBOL_t1 + i], given[i]);
    else
      series_set_unknown(&symbols.value[SCALLOP_SYMBOL_t1 + i]);
  if (scallop_formula_expand(&value, f, &symbols, m->condition->kind, &ring, p->why))
    return false;
  if (f->quantity == SCALLOP_VELOCITY_CHANGE)
    series_add(&value, &value, &symbols.value[SCALLOP_SYMBOL_v0], &ring);
  series_sub(left_out, left_out, &value, &ring);
  return true;
}

/* Sets exact zeros: one coefficient that is a ball turns all into balls, but fewer terms without it may be exact. */
static void set_zeros(struct proof *p, slong max)
{
  const struct series *all = p->left_out;
  SCOPED(series, fewer);
  for (slong terms = 1; terms < max; terms++) {
    if (!set_left_out(&fewer, p, terms) || series_first_power(&fewer) < fewer.known)
      return;
    for (slong k = all->first, end = k + series_terms(all); k < end && k < fewer.known; k++)
      series_set_zero(p->left_out, k);
  }
}

static bool find_order(struct proof *p)
{
  const slong terms = p->m->terms + 8;
  SCOPED(arb, x);
  if (!set_left_out(p->left_out, p, terms))
    return false;
  if (p->left_out->kind == SERIES_BALLS)
    set_zeros(p, terms);
  const slong order = series_first_power(p->left_out);
  p->row->derived_order = p->general = order;
  p->row->exact = order >= p->left_out->known;
  if (!p->row->exact)
    series_coefficient(x, p->left_out, order, PRECISION);
  p->row->proven = p->row->exact || !arb_contains_zero(x);
  return true;
}

/* Finds the order; false: p->why has the reason why not. */
static bool prove(struct proof *p)
{
  if (!trial_series(p->m, p->f->quantity)) {
    snprintf(p->why, sizeof p->why, "no body turns in this phase, so that %s does not exist",
             scallop_quantity_words[p->f->quantity]);
    return false;
  }
  if (!find_order(p))
    return false;
  /* a later coefficient may differ from 0; zeros of further coefficients can be shown for a rational gait only */
  const bool further = scallop_gait_is_rational(p->m->crawler.gait) && p->m->terms < MANY_TERMS;
  return !p->row->exact || !further || (trial_expand(p->m, MANY_TERMS) && find_order(p));
}

/* Returns true if a condition is an equality other than F1 = F2: independent symbols do not satisfy it. */
static bool has_equality(const struct scallop_formula *f)
{
  bool has = false;
  for (const char *const *when = f->when; when && *when; when++)
    has = has || (strchr(*when, '=') && !scallop_condition_is_equal_forces(*when));
  return has;
}

static bool is_of_paper(const struct scallop_formula *f)
{
  const struct scallop_formula *own = scallop_formula_named(f->name);
  return own && own->text && strcmp(own->text, f->text) == 0 && (!f->parts || !f->parts->name);
}

/* Finds the order in symbols, for all parameters; if all coefficients vanish, up to the claimed order and some powers
 * more. This proves an equality of finite sums, and of the paper's formulas for the quadratic gait, of low degree in T
 * (docs/background/theory.md, The proofs of claims). False: symbols and numbers contradict each other. */
static bool prove_for_all(struct proof *p)
{
  const struct scallop_formula *f = p->f;
  const struct scallop_rational_crawler *crawler = &p->m->crawler;
  const slong order = p->row->derived_order, known = p->left_out->known;
  const slong claimed = f->remainder > MAX_POWER_OF_EQUALITY ? f->remainder : MAX_POWER_OF_EQUALITY;
  const slong max = !p->row->exact ? order : claimed < known ? claimed : known - 1;
  ENDED_BY(left_out_clear) struct left_out l;
  SCOPED(fmpq, coefficient);
  left_out_init(&l);
  p->for_all = p->m->condition->at_end;
  if (!f->text || has_equality(f) || max >= SYMBOLIC_ORDERS
      || symbolic_left_out(&l, f, crawler, p->m->condition->kind, p->m->v0, max, p->why))
    return true;
  const bool vanishes = l.order > max;
  const bool low_degree = is_of_paper(f) && crawler->gait == &scallop_gait_quadratic;
  const bool all = f->remainder != SCALLOP_EQUALITY || known >= SERIES_ALL || low_degree;
  p->general = vanishes ? order : l.order;
  p->for_all = p->row->exact ? vanishes && all : l.order == order;
  p->for_all_below = vanishes ? max + 1 : l.order;
  if (p->for_all) {
    p->row->leading_error = l.term;
    l.term = NULL;
  }
  bool same = !p->for_all || !l.is_number
              || (series_rational_coefficient(coefficient, p->left_out, order)
                  && fmpq_equal(coefficient, l.coefficient));
  return p->row->exact || (!vanishes && same);
}

/* Reflects errors back: positions and velocities change their sign in a reflection, times do not. */
static void reflect(struct proof *p)
{
  if (p->f->quantity == SCALLOP_LAG || p->f->quantity == SCALLOP_FIRST_SWITCH)
    return;
  series_neg(p->left_out, p->left_out);
  for (int i = 0; i < p->row->count; i++)
    p->row->points[i].err = -p->row->points[i].err;
}

static void set_coefficient(struct claim_row *row, const struct proof *p)
{
  SCOPED(fmpq, q);
  SCOPED(arb, x);
  bool is_rational = series_rational_coefficient(q, p->left_out, row->derived_order);
  series_coefficient(x, p->left_out, row->derived_order, 128);
  if (!is_rational && arb_is_exact(x)) { /* a ball of radius 0 is a number */
    arf_get_fmpq(q, arb_midref(x));
    is_rational = true;
  }
  char *fraction = decimal_fraction(q), *ball = decimal_ball(x, DIGITS);
  bool is_short = is_rational && strlen(fraction) < sizeof row->coefficient;
  append(row->coefficient, sizeof row->coefficient, "%s", is_short ? fraction : ball);
  flint_free(fraction);
  flint_free(ball);
}

/* Sets the verdict. Finitely many coefficients prove an order up to them; they prove an equality only of finite sums,
 * or of known degree. */
static void judge(struct claim_row *row, const struct proof *p)
{
  if (!row->proven) {
    add_reason(row, "the coefficient of T^%ld cannot be distinguished from 0", row->derived_order);
    return;
  }
  const long order = row->derived_order;
  if (!row->exact)
    set_coefficient(row, p);
  const bool all = row->exact && order >= SERIES_ALL, equal = row->exact && (all || p->for_all);
  row->verdict = (double)order > row->claimed_order                                            ? CLAIM_SHARPER
                 : (double)order == row->claimed_order || (isinf(row->claimed_order) && equal) ? CLAIM_HOLDS
                 : row->exact                                                                  ? CLAIM_UNDECIDED
                                                                                               : CLAIM_REFUTED;
  char why[DIMENSION_WHY];
  if (row->verdict == CLAIM_REFUTED && row->source == OF_USER && row->formula && dimension_refutes(why, p->m, p->f))
    add_reason(row, "%s", why);
  if (all)
    add_reason(row, "every coefficient vanishes");
  else if (row->exact)
    add_reason(row, "every coefficient below T^%ld vanishes", order);
  else if (row->verdict == CLAIM_REFUTED && order == 0)
    add_reason(row, "the error does not fall");
  else if (row->verdict != CLAIM_HOLDS)
    add_reason(row, "the error goes as T^%ld", order);
  if (row->exact && !all && p->for_all_below > 0)
    add_reason(row, "for all parameters those below T^%ld", (long)p->for_all_below);
  row->evidence = row->verdict == CLAIM_UNDECIDED ? NO_EVIDENCE : p->for_all ? PROVEN_FOR_ALL : CERTIFIED_CRAWLER;
  if (p->general < order) {
    add_reason(row, "of other crawlers as T^%ld", (long)p->general);
    if (row->any_crawler && (double)p->general < row->claimed_order)
      row->verdict = CLAIM_REFUTED;
  }
}

/* The table of claims */

const char *claim_verdict_text(enum claim_verdict verdict)
{
  static const char *const text[] = { "holds", "sharper", "undecided", "refuted" };
  return text[verdict];
}

void claim_table_add(struct claim_table *claims, const struct claim_row *row)
{
  claims->rows = flint_realloc(claims->rows, (size_t)(claims->count + 1) * sizeof *row);
  claims->rows[claims->count++] = *row;
  if (claims->expected > 0) /* a whole table, after its forecast */
    progress_count(claims->count, claims->expected);
}

bool claim_table_expects(struct claim_table *claims)
{
  claims->expected += claims->is_forecast;
  return claims->is_forecast;
}

void claim_table_free(struct claim_table *claims)
{
  for (int i = 0; i < claims->count; i++)
    free(claims->rows[i].leading_error), free(claims->rows[i].formula);
  flint_free(claims->rows);
  *claims = (struct claim_table){ .rows = NULL };
}

void claim_table_contradict(struct claim_table *claims, const struct claim_row *row, const char *format, ...)
{
  va_list values;
  va_start(values, format);
  vsnprintf(claims->contradiction, sizeof claims->contradiction, format, values);
  va_end(values);
  append(claims->contradiction, sizeof claims->contradiction, " (%s, %s, %s)", row->claim, row->gait, row->conditions);
}

struct claim_row row_of_formula(const struct scallop_formula *f, const struct scallop_gait *gait,
                                const struct condition *condition)
{
  struct claim_row row = { .equation = f->equation,
                           .quantity = formula_quantity_text(f, condition->kind),
                           .gait = gait->name,
                           .inside = condition->inside,
                           .claimed_order = f->remainder == SCALLOP_EQUALITY ? INFINITY : f->remainder };
  append(row.claim, sizeof row.claim, "%s", f->name);
  append(row.corrected, sizeof row.corrected, "%s", f->corrected ? f->corrected : "");
  append(row.conditions, sizeof row.conditions, "%s", condition->text);
  return row;
}

/* Counts the points, from the smallest T on, at which the error may be 0. */
static int points_at_0(const struct claim_row *row)
{
  int count = 0;
  for (int i = row->count - 1; i >= 0 && fabs(row->points[i].err) <= row->points[i].noise; i--)
    count++;
  return count;
}

/* Fits the order over the smallest T. */
static void fit(struct claim_row *row)
{
  struct scallop_order_point *points = row->points;
  enum { FITTED = 12 };
  int tail = row->count < FITTED ? row->count : FITTED;
  for (int i = 0; i < row->count; i++) {
    points[i].pairwise = i + 1 < row->count
                             ? log(fabs(points[i].err / points[i + 1].err)) / log(points[i].h / points[i + 1].h)
                             : NAN;
    points[i].use = row->exact ? SCALLOP_ORDER_ZERO : SCALLOP_ORDER_COARSE;
  }
  struct scallop_order_wanted wanted = { .order = NAN, .tolerance = CLAIM_TOLERANCE };
  scallop_order(points + row->count - tail, &tail, &wanted, &row->fit);
}

/* Fits the order to the points of the row, compares it with the derived one, and adds the row. */
static void enter(struct claim_table *claims, struct claim_row *row)
{
  fit(row);
  if (row->exact && isinf(row->claimed_order) && points_at_0(row) < row->count) {
    row->verdict = CLAIM_REFUTED;
    row->evidence = CERTIFIED_CRAWLER;
    add_reason(row, "but the certified error is not 0 at every T");
  }
  /* the measured error is the sum of the terms left out; if those below a power vanish, it is 0 at the smallest T, or
   * of this power or higher */
  const bool beyond = row->fit.order > (double)row->derived_order - CLAIM_TOLERANCE;
  if (row->proven && row->count == 0)
    claim_table_contradict(claims, row, "no exact motion has the modes of the expansion");
  else if (row->proven && row->exact && points_at_0(row) == 0 && !beyond)
    claim_table_contradict(claims, row, "nothing is left out, and the certified error is not 0");
  if (row->proven && !row->exact && fabs(row->fit.order - (double)row->derived_order) > CLAIM_TOLERANCE)
    add_reason(row, "at the T measured it goes as T^%.3g", row->fit.order);
  if (row->verdict != CLAIM_REFUTED)
    *row->corrected = '\0';
  claim_table_add(claims, row);
}

void claim_table_decide(struct claim_table *claims, struct claim_row *row, struct trial *m,
                        const struct scallop_formula *f, const char *why)
{
  SCOPED(series, left_out);
  struct proof p = { .row = row, .m = m, .f = f, .left_out = &left_out };
  row->verdict = CLAIM_UNDECIDED;
  if (!why && prove(&p)) {
    if (row->proven && !prove_for_all(&p))
      claim_table_contradict(claims, row, "the coefficients in symbols differ from those in numbers");
    const double mismatch = trial_measure(row, m, f, &left_out);
    if (row->proven && !row->exact && mismatch > 1e-6) /* many times the next terms at such T */
      claim_table_contradict(claims, row, "the sum of what is left out differs from the certified error by %.1e of it",
                             mismatch);
    if (m->mirrored)
      reflect(&p);
    judge(row, &p);
  } else {
    char place[FORMULA_PLACE]; /* of an error in the text */
    why = why ? why : p.why;
    add_reason(row, "%s%s", strncmp(why, "character", 9) == 0 ? formula_place(place, f) : "",
               *why ? why : "no expansion in powers of T is known for this motion");
    row->proven = row->exact = false;
  }
  enter(claims, row);
}
