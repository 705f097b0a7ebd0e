/* The page of a summary, in sentences, and that of breakdown, which is a part of it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/summary/summary.h"

enum { DIGITS = 6 };

struct page {
  FILE *file;
  int digits;
  struct at *at;            /* the point */
  struct quantities *asked; /* of it: all that the page tells */
  struct study *study;
  const struct scallop_formula *formula[SUMMARY_FORMULAS];
  int formulas;
};

const struct page_quantity page_quantities[PAGE_QUANTITIES] = { { Q_V_START, "derived_8.v_start" },
                                                                { Q_DISPLACEMENT, "derived_8.displacement" } };

const char *const page_reaches[PAGE_REACHES] = { "reach_0.01.", "reach_0.05." };

int page_formulas(const struct scallop_formula *formulas[SUMMARY_FORMULAS])
{
  const struct scallop_formula *f;
  int count = 0;
  for (int q = 0; q < PAGE_QUANTITIES; q++)
    for (int i = 0; (f = listed_formula(i)) && count < SUMMARY_FORMULAS; i++)
      if (f->setting == SCALLOP_STEADY && quantity_of_formula(f, SCALLOP_EXTENSION) == page_quantities[q].id)
        formulas[count++] = f;
  return count;
}

/* The quantity of this name, or, of a series, what its name begins with */
static double number(const struct page *p, const char *of, const char *series)
{
  char name[2 * QUANTITY_NAME];
  snprintf(name, sizeof name, "%s%.*s", of, QUANTITY_NAME, series);
  return at_number(p->at, quantity_named(p->asked, name));
}

static double value(const struct page *p, enum quantity_id q) { return number(p, quantity_rows[q].name, ""); }

static const struct answer *answer_of(const struct page *p) { return &p->at->solved[STEADY_STATE].answer; }

static void write_way(const struct page *p)
{
  double way = value(p, Q_DISPLACEMENT);
  if (answer_of(p)->regime == SCALLOP_AT_REST)
    fputs("  It stays where it is: one body never moves, and the other is pushed away and pulled back.\n", p->file);
  else if (way == 0)
    fputs("  It moves to and fro, and is where it was after each period.\n", p->file);
  else
    fprintf(p->file, "  It crawls %s, by %.*g in each period: a mean velocity of %.*g.\n",
            way > 0 ? "forward (towards body 2)" : "backward (towards body 1)", p->digits, fabs(way), p->digits,
            value(p, Q_MEAN_VELOCITY));
}

static void write_stretches(const struct page *p)
{
  struct stretch stretch[MOST_STRETCHES];
  int count = stretches_of(stretch, &p->at->solved[STEADY_STATE].motion, answer_of(p));
  int kept = count < MOST_STRETCHES ? count : MOST_STRETCHES;
  for (int i = 0; i < kept; i++) {
    char words[MODE_WORDS];
    bool first = i == 0 || stretch[i].phase != stretch[i - 1].phase;
    fprintf(p->file, "  %-12s %s from %.*g to %.*g\n", first ? book_phases[stretch[i].phase] : "",
            mode_in_words(words, stretch[i].mode), p->digits, stretch[i].from, p->digits, stretch[i].until);
  }
  if (kept < count)
    fprintf(p->file, "  %-12s and %d more changes of mode\n", "", count - kept);
}

static void write_velocities(const struct page *p)
{
  double multiplier = value(p, Q_MULTIPLIER);
  fprintf(p->file,
          "  Both bodies have the velocity %.*g when the extension starts, and %.*g when the contraction starts.\n",
          p->digits, value(p, Q_V_START), p->digits, value(p, Q_V_MID));
  if (multiplier == 0)
    fputs("  Started with a velocity near this one, it moves like this from the next period on.\n", p->file);
  else if (answer_of(p)->status == SCALLOP_OK)
    fprintf(p->file, "  A small deviation from this motion shrinks to %.*g of itself in each period.\n", p->digits,
            multiplier);
}

static void write_motion(const struct page *p)
{
  char status[ANSWER_STATUS];
  const struct answer *a = answer_of(p);
  fprintf(p->file, "What it does (Froude number %.*g, %s)\n", p->digits, value(p, Q_FROUDE),
          scallop_regime_text(a->regime));
  write_way(p);
  if (a->status != SCALLOP_OK)
    fprintf(p->file, "  This is one of many steady motions: %s.\n", answer_status_text(status, a));
  if (a->regime != SCALLOP_AT_REST)
    write_velocities(p);
  write_stretches(p);
}

static void write_error(const struct page *p, double error)
{
  if (error == 0)
    fputs(", the same", p->file);
  else if (error < -1)
    fputs(", wrong sign", p->file);
  else if (isfinite(error))
    fprintf(p->file, ", %.3g %% off", 100 * fabs(error));
}

/* "O(T)", "O(T^4)" */
static const char *order_text(char text[24], double order)
{
  snprintf(text, 24, order == 1 ? "O(T)" : "O(T^%g)", order);
  return text;
}

static void write_verdict(const struct page *p, const struct scallop_formula *f)
{
  const struct claim_row *c = claim_of(p->at, f);
  double limit = number(p, "error_limit.", f->name);
  char claimed[24], derived[24];
  order_text(claimed, c->claimed_order);
  order_text(derived, (double)c->derived_order);
  if (c->verdict == CLAIM_UNDECIDED)
    fprintf(p->file, "undecided: %s", c->reason);
  else if (c->exact)
    fputs("proven: it is exact", p->file);
  else if (c->verdict == CLAIM_REFUTED && isfinite(limit))
    fprintf(p->file, "refuted: %s is claimed, but the relative error tends to %.3g %% as T -> 0", claimed, 100 * limit);
  else if (c->verdict == CLAIM_REFUTED && c->derived_order <= 0)
    fprintf(p->file, "refuted: %s is claimed, but the error does not vanish as T -> 0", claimed);
  else if (c->verdict == CLAIM_REFUTED)
    fprintf(p->file, "refuted: %s is claimed, but the error is %s", claimed, derived);
  else if (c->verdict == CLAIM_SHARPER)
    fprintf(p->file, "proven, and better than claimed: the error is %s, not only %s", derived, claimed);
  else
    fprintf(p->file, "proven: the error is %s, as claimed", derived);
}

/* Where the error of a series reaches 1 and 5 percent */
static void write_reach(const struct page *p, const char *series)
{
  enum { FROUDE_DIGITS = 3 };
  double limit = number(p, "error_limit.", series);
  for (int i = 0; i < 2; i++) {
    double T = number(p, page_reaches[i], series);
    int percent = i == 0 ? 1 : 5;
    fputs(i > 0 ? ", " : "off ", p->file);
    if (isnan(T))
      fprintf(p->file, "%d %%: no exact value", percent);
    else if (isinf(T))
      fprintf(p->file, "by less than %d %% at every T", percent);
    else if (T > 0)
      fprintf(p->file, "by %d %% at T = %.*g (Froude %.*g)", percent, p->digits, T, FROUDE_DIGITS,
              motion_froude(&p->study->motion, T));
    else if (isnan(limit))
      fprintf(p->file, "by more than %d %% at every small T", percent);
    else
      fprintf(p->file, "by more than %d %% however small T is (%.3g %% as T -> 0)", percent, 100 * limit);
    if (isinf(T) || !(T > 0))
      break; /* the same holds for the levels above, or nothing more is known */
  }
  fputc('\n', p->file);
}

static bool agree(double a, double b) { return a == b || (isnan(a) && isnan(b)); }

/* Formulas that agree in all that is told of them are told once. */
static bool is_same(const struct page *p, const struct scallop_formula *a, const struct scallop_formula *b)
{
  static const char *const told[] = { "value.", "deviation.", "error_limit.", "reach_0.01.", "reach_0.05.", "order." };
  bool same = a->quantity == b->quantity && a->remainder == b->remainder;
  for (size_t i = 0; i < sizeof told / sizeof *told && same; i++)
    same = agree(number(p, told[i], a->name), number(p, told[i], b->name));
  return same;
}

static const char *name_of(const struct scallop_formula *f) { return f->name; }

static const char *equation_of(const struct scallop_formula *f)
{
  return *f->equation && strcmp(f->equation, "-") != 0 ? f->equation : f->name;
}

/* The names of formula i and of those behind it that are the same */
static void write_names(const struct page *p, int i, const char *(*name)(const struct scallop_formula *))
{
  for (int k = i; k < p->formulas; k++)
    if (is_same(p, p->formula[i], p->formula[k]))
      fprintf(p->file, "%s%s", k == i ? "" : ", ", name(p->formula[k]));
}

static void write_formula(const struct page *p, int i)
{
  const struct scallop_formula *f = p->formula[i];
  enum quantity_id of = quantity_of_formula(f, SCALLOP_EXTENSION);
  for (int before = 0; before < i; before++)
    if (is_same(p, p->formula[before], f))
      return;
  double of_formula = number(p, "value.", f->name);
  fputs("  ", p->file);
  write_names(p, i, equation_of);
  fprintf(p->file, " %s ", quantity_rows[of].name);
  if (isnan(of_formula)) {
    fputs("has no value: it divides by l'', which is 0 at an end of a phase [", p->file);
  } else {
    fprintf(p->file, "= %.*g, exact %.*g", p->digits, of_formula, p->digits, value(p, of));
    write_error(p, number(p, "deviation.", f->name));
    fputs(" [", p->file);
  }
  write_names(p, i, name_of);
  fputs("]\n", p->file);
  if (isnan(of_formula))
    return;
  fputs("       ", p->file);
  write_verdict(p, f);
  fputs("\n       ", p->file);
  write_reach(p, f->name);
}

static void write_best(const struct page *p, enum quantity_id of)
{
  const struct best_order best = study_best_order(p->study, of, p->at->place.point.crawler.T);
  if (isinf(best.error))
    return;
  fprintf(p->file, "  derived %s: %s below T^%ld", quantity_rows[of].name,
          best.gains_from_more ? "better with every term, here all" : "best with the terms", (long)best.order);
  write_error(p, best.error);
  fputc('\n', p->file);
}

static void write_formulas(const struct page *p)
{
  fputs("\nFormulas of the paper, for this gait and these parameters\n", p->file);
  for (int i = 0; i < p->formulas; i++)
    write_formula(p, i);
  if (p->study->derived.status != SCALLOP_OK)
    fprintf(p->file, "  There is no derived series: %s.\n", study_why_none(p->study));
  for (int q = 0; q < PAGE_QUANTITIES; q++)
    write_best(p, page_quantities[q].id);
}

static void write_events(const struct page *p)
{
  enum { SHOWN = 8 };
  const struct events *e = study_events(p->study);
  fputs("\nWhere the expansion ends\n", p->file);
  if (e->count == 0 && p->study->derived.status != SCALLOP_OK)
    fputs("  There is no expansion.\n", p->file);
  else if (e->count == 0)
    fprintf(p->file, "  Nowhere: the sequence of modes is the same at every T up to %.3g.\n", e->until);
  for (long i = 0; i < e->count && i < SHOWN; i++)
    fprintf(p->file, "  T = %.*g (Froude %.3g): %s\n", p->digits, e->event[i].T,
            motion_froude(&p->study->motion, e->event[i].T), e->event[i].what);
  if (e->count > SHOWN)
    fprintf(p->file, "  and %ld more events at larger T\n", e->count - SHOWN);
  for (long i = 0; i < e->reversals; i++)
    fprintf(p->file, "%s T = %.*g", i == 0 ? "  The direction of crawling reverses at" : ",", p->digits,
            e->reversal[i].T);
  fputs(e->reversals > 0 ? ".\n" : "", p->file);
}

/* not_held: parameters that are left out (answers/request.h) */
static void write_crawler(const struct page *p, const char *const *not_held)
{
  char parameters[PARAMETERS_TEXT];
  parameters_text(parameters, &p->at->place.point, not_held, true);
  fprintf(p->file, "\nCrawler:%s\n", parameters);
}

static void write_summary(const struct page *p)
{
  double T = p->at->place.point.crawler.T;
  write_crawler(p, NULL);
  fputc('\n', p->file);
  write_motion(p);
  write_formulas(p);
  write_events(p);
  if (p->study->events.count > 0)
    fprintf(p->file, "  T = %.*g is %s.\n", p->digits, T, study_where(p->study, T));
  fputs("\nMore: scallop steady --certified       proven digits\n"
        "      scallop claims                   the claims of the paper\n"
        "      scallop series --source derived  the expansion\n"
        "      scallop breakdown --all          every event and reach\n",
        p->file);
}

static void write_breakdown(const struct page *p)
{
  write_crawler(p, (const char *const[]){ "T", NULL });
  write_events(p);
  fputs("\nUp to which T a series holds\n", p->file);
  for (int i = 0; i < p->formulas; i++) {
    const struct scallop_formula *f = p->formula[i];
    const char *equation = equation_of(f), *of = quantity_rows[quantity_of_formula(f, SCALLOP_EXTENSION)].name;
    fprintf(p->file, equation != f->name ? "  %s %s, %s\n       " : "  %s%.0s, %s\n       ", equation, f->name, of);
    write_reach(p, f->name);
  }
  for (int q = 0; q < PAGE_QUANTITIES && p->study->derived.status == SCALLOP_OK; q++) {
    fprintf(p->file, "  derived terms below T^8, %s\n       ", quantity_rows[page_quantities[q].id].name);
    write_reach(p, page_quantities[q].derived);
  }
  fputs("\nMore: --all, or --only event, reversal, reach, radius or best, gives the table with every row.\n", p->file);
}

/* To people a page, else a row */
static void visit(struct rows *rows, struct at *at, void (*write)(const struct page *))
{
  int digits = (int)rows->request->style.digits;
  struct page p = { .at = at, .asked = &rows->sheet.asked->quantities, .digits = digits > 0 ? digits : DIGITS };
  p.file = table_page(&rows->table);
  if (!p.file) {
    sheet_row(&rows->sheet, &rows->table, at);
    return;
  }
  p.study = at->is_outside ? NULL : study_of(at);
  p.formulas = page_formulas(p.formula);
  if (!p.study || isnan(value(&p, Q_V_START)))
    fprintf(p.file, "\nThis crawler has no page: %s.\n", at->why);
  else
    write(&p);
}

void page_of_crawler(struct rows *rows, struct at *at) { visit(rows, at, write_summary); }
void page_of_breakdown(struct rows *rows, struct at *at) { visit(rows, at, write_breakdown); }
