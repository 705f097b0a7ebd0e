/* The page of a summary, in sentences. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/summary/summary.h"

static double value(const struct summary *s, enum quantity_id q) { return s->answer.value[q].high; }

static void write_way(FILE *page, const struct summary *s, int digits)
{
  double way = value(s, Q_DISPLACEMENT);
  if (s->answer.regime == SCALLOP_AT_REST)
    fprintf(page, "  It stays where it is: one body never moves, and the other is pushed away and pulled back.\n");
  else if (way == 0)
    fprintf(page, "  It moves to and fro, and is where it was after each period.\n");
  else
    fprintf(page, "  It crawls %s, by %.*g in each period: a mean velocity of %.*g.\n",
            way > 0 ? "forward (towards body 2)" : "backward (towards body 1)", digits, fabs(way), digits,
            value(s, Q_MEAN_VELOCITY));
}

static void write_stretches(FILE *page, const struct summary *s, int digits)
{
  static const char *const names[] = { "extension", "contraction" };
  struct stretch stretch[MOST_STRETCHES];
  int count = stretches_of(stretch, &s->motion, &s->answer), kept = count < MOST_STRETCHES ? count : MOST_STRETCHES;
  for (int i = 0; i < kept; i++) {
    char words[MODE_WORDS];
    bool first = i == 0 || stretch[i].phase != stretch[i - 1].phase;
    fprintf(page, "  %-12s %s from %.*g to %.*g\n", first ? names[stretch[i].phase] : "",
            mode_in_words(words, stretch[i].mode), digits, stretch[i].from, digits, stretch[i].until);
  }
  if (kept < count)
    fprintf(page, "  %-12s and %d more changes of mode\n", "", count - kept);
}

static void write_velocities(FILE *page, const struct summary *s, int digits)
{
  fprintf(page,
          "  Both bodies have the velocity %.*g when the extension starts, and %.*g when the contraction starts.\n",
          digits, value(s, Q_V_START), digits, value(s, Q_V_MID));
  if (value(s, Q_MULTIPLIER) == 0)
    fputs("  Started with a velocity near this one, it moves like this from the next period on.\n", page);
  else if (s->answer.status == SCALLOP_OK)
    fprintf(page, "  A small deviation from this motion shrinks to %.*g of itself in each period.\n", digits,
            value(s, Q_MULTIPLIER));
}

void page_of_motion(FILE *page, const struct summary *s, int digits)
{
  char status[ANSWER_STATUS];
  fprintf(page, "What it does (Froude number %.*g, %s)\n", digits, value(s, Q_FROUDE),
          scallop_regime_text(s->answer.regime));
  write_way(page, s, digits);
  if (s->answer.status != SCALLOP_OK)
    fprintf(page, "  This is one of many steady motions: %s.\n", answer_status_text(status, &s->answer));
  if (s->answer.regime != SCALLOP_AT_REST)
    write_velocities(page, s, digits);
  write_stretches(page, s, digits);
}

static const char *name_of(const struct summary_series *f) { return quantity_rows[f->item.quantity].name; }

static void write_error(FILE *page, double error)
{
  if (error == 0)
    fputs(", the same", page);
  else if (error < -1)
    fputs(", wrong sign", page);
  else if (isfinite(error))
    fprintf(page, ", %.3g %% off", 100 * fabs(error));
}

/* "O(T)", "O(T^4)" */
static const char *order_text(char text[24], double order)
{
  snprintf(text, 24, order == 1 ? "O(T)" : "O(T^%g)", order);
  return text;
}

static void write_verdict(FILE *page, const struct summary_series *f)
{
  const struct claim_row *c = &f->claim;
  char claimed[24], derived[24];
  order_text(claimed, c->claimed_order);
  order_text(derived, (double)c->derived_order);
  if (c->verdict == CLAIM_UNDECIDED)
    fprintf(page, "undecided: %s", c->reason);
  else if (c->exact)
    fputs("proven: it is exact", page);
  else if (c->verdict == CLAIM_REFUTED && isfinite(f->limit))
    fprintf(page, "refuted: %s is claimed, but the relative error tends to %.3g %% as T -> 0", claimed, 100 * f->limit);
  else if (c->verdict == CLAIM_REFUTED && c->derived_order <= 0)
    fprintf(page, "refuted: %s is claimed, but the error does not vanish as T -> 0", claimed);
  else if (c->verdict == CLAIM_REFUTED)
    fprintf(page, "refuted: %s is claimed, but the error is %s", claimed, derived);
  else if (c->verdict == CLAIM_SHARPER)
    fprintf(page, "proven, and better than claimed: the error is %s, not only %s", derived, claimed);
  else
    fprintf(page, "proven: the error is %s, as claimed", derived);
}

/* Where the error reaches the levels */
static void write_reach(FILE *page, const struct summary *s, const struct summary_series *f, int digits)
{
  enum { FROUDE_DIGITS = 3 };
  for (int i = 0; i < SUMMARY_LEVELS; i++) {
    double T = f->reach[i], percent = 100 * summary_levels[i];
    fputs(i > 0 ? ", " : "off ", page);
    if (isnan(T))
      fprintf(page, "%g %%: no exact value", percent);
    else if (isinf(T))
      fprintf(page, "by less than %g %% at every T", percent);
    else if (T > 0)
      fprintf(page, "by %g %% at T = %.*g (Froude %.*g)", percent, digits, T, FROUDE_DIGITS,
              motion_froude(&s->motion, T));
    else if (isnan(f->limit))
      fprintf(page, "by more than %g %% at every small T", percent);
    else
      fprintf(page, "by more than %g %% however small T is (%.3g %% as T -> 0)", percent, 100 * f->limit);
    if (isinf(T) || !(T > 0))
      break; /* the same holds for the levels above, or nothing more is known */
  }
}

static bool agree(double a, double b) { return a == b || (isnan(a) && isnan(b)); }

/* Formulas that agree in all that is told of them are told once. */
static bool is_same(const struct summary_series *a, const struct summary_series *b)
{
  bool same = a->item.quantity == b->item.quantity && agree(a->value, b->value) && agree(a->error, b->error)
              && agree(a->limit, b->limit) && a->claim.verdict == b->claim.verdict
              && agree(a->claim.claimed_order, b->claim.claimed_order)
              && strcmp(a->claim.coefficient, b->claim.coefficient) == 0;
  for (int i = 0; i < SUMMARY_LEVELS && same; i++)
    same = agree(a->reach[i], b->reach[i]);
  return same;
}

static const char *equation_of(const struct summary_series *f)
{
  const struct scallop_formula *formula = f->item.formula;
  return *formula->equation && strcmp(formula->equation, "-") != 0 ? formula->equation : formula->name;
}

/* The equations, or the names, of a formula and of those behind it that are the same */
static void write_names(FILE *page, const struct summary_series *f, const struct summary_series *end, bool of_names)
{
  for (const struct summary_series *k = f; k < end; k++)
    if (is_same(f, k))
      fprintf(page, "%s%s", k == f ? "" : ", ", of_names ? k->item.name : equation_of(k));
}

static void write_formula(FILE *page, const struct summary *s, const struct summary_series *f, int digits)
{
  const struct summary_series *end = s->formula + s->formulas;
  for (const struct summary_series *before = s->formula; before < f; before++)
    if (is_same(before, f))
      return;
  fputs("  ", page);
  write_names(page, f, end, false);
  fprintf(page, " %s ", name_of(f));
  if (isnan(f->value)) {
    fputs("has no value: it divides by l'', which is 0 at an end of a phase [", page);
  } else {
    fprintf(page, "= %.*g, exact %.*g", digits, f->value, digits, value(s, f->item.quantity));
    write_error(page, f->error);
    fputs(" [", page);
  }
  write_names(page, f, end, true);
  fputs("]\n", page);
  if (isnan(f->value))
    return;
  fputs("       ", page);
  write_verdict(page, f);
  fputs("\n       ", page);
  write_reach(page, s, f, digits);
  fputc('\n', page);
}

static void write_best(FILE *page, const struct summary *s, int i)
{
  bool more = study_gains_from_more(&s->study, s->derived[i].item.quantity, s->best_order[i]);
  fprintf(page, "  derived %s: %s below T^%ld", name_of(&s->derived[i]),
          more ? "better with every term, here all" : "best with the terms", (long)s->best_order[i]);
  write_error(page, s->best_error[i]);
  fputc('\n', page);
}

void page_of_formulas(FILE *page, const struct summary *s, int digits)
{
  fputs("\nFormulas of the paper, for this gait and these parameters\n", page);
  for (int i = 0; i < s->formulas; i++)
    write_formula(page, s, &s->formula[i], digits);
  for (int i = 0; i < s->series; i++)
    if (s->best_order[i] > 0)
      write_best(page, s, i);
  if (s->series == 0)
    fprintf(page, "  There is no derived series: %s.\n", study_why_none(&s->study));
}

void page_of_events(FILE *page, const struct summary *s, int digits)
{
  enum { SHOWN = 8 };
  const struct events *e = &s->study.events;
  fputs("\nWhere the expansion ends\n", page);
  if (e->count == 0 && s->series == 0)
    fputs("  There is no expansion.\n", page);
  else if (e->count == 0)
    fprintf(page, "  Nowhere: the sequence of modes is the same at every T up to %.3g.\n", e->until);
  for (long i = 0; i < e->count && i < SHOWN; i++)
    fprintf(page, "  T = %.*g (Froude %.3g): %s\n", digits, e->event[i].T, motion_froude(&s->motion, e->event[i].T),
            e->event[i].what);
  if (e->count > SHOWN)
    fprintf(page, "  and %ld more events at larger T\n", e->count - SHOWN);
}

void page_of_reversals(FILE *page, const struct summary *s, int digits)
{
  const struct events *e = &s->study.events;
  for (long i = 0; i < e->reversals; i++)
    fprintf(page, "%s T = %.*g", i == 0 ? "  The direction of crawling reverses at" : ",", digits, e->reversal[i].T);
  fputs(e->reversals > 0 ? ".\n" : "", page);
}

void page_of_place(FILE *page, const struct summary *s, int digits)
{
  double T = s->motion.crawler.T;
  if (s->study.events.count > 0)
    fprintf(page, "  T = %.*g is %s.\n", digits, T, study_where(&s->study, T));
}

void page_of_reaches(FILE *page, const struct summary *s, int digits)
{
  const struct summary_series *const lists[] = { s->formula, s->derived };
  const int counts[] = { s->formulas, s->series };
  fputs("\nUp to which T a series holds\n", page);
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < counts[k]; i++) {
      const struct summary_series *f = &lists[k][i];
      if (f->item.formula && equation_of(f) != f->item.name)
        fprintf(page, "  %s %s, %s\n       ", equation_of(f), f->item.name, name_of(f));
      else if (f->item.formula)
        fprintf(page, "  %s, %s\n       ", f->item.name, name_of(f));
      else
        fprintf(page, "  derived terms below T^%d, %s\n       ", SUMMARY_ORDER, name_of(f));
      write_reach(page, s, f, digits);
      fputc('\n', page);
    }
}
