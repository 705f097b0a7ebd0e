/* Quantities of a summary, as columns of a table or as a page in sentences. The page of `breakdown` is a part of it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/summary/summary.h"

struct page_series {
  const char *name;
  enum quantity_id of;
  const struct scallop_formula *formula; /* NULL: derived terms */
};

static const struct page_series terms[] = { { PAGE_TERMS "v_start", Q_V_START, NULL },
                                            { PAGE_TERMS "displacement", Q_DISPLACEMENT, NULL } };
enum { TERMS = sizeof terms / sizeof *terms, MAX_FORMULAS = MAX_USER_FORMULAS + 8 };

struct page {
  FILE *file;
  int digits;
  struct at *at;                 /* the point */
  struct quantities *quantities; /* of the point, all that the page has */
  const struct answer *answer;
  struct study *study;
  bool digits_are_given, is_recorded;
  int formulas; /* in series; derived terms follow */
  struct page_series series[MAX_FORMULAS + TERMS];
};

/* Returns true if the formula gives the steady quantity of a page_series or, for NULL, v_start or the displacement. */
static bool is_on_page(const void *of, const struct scallop_formula *f)
{
  enum quantity_id q = quantity_of_formula(f, SCALLOP_EXTENSION);
  return f->setting == SCALLOP_STEADY
         && (of ? q == ((const struct page_series *)of)->of : q == Q_V_START || q == Q_DISPLACEMENT);
}

static void find_formulas(struct page *p)
{
  const struct scallop_formula *f;
  for (int q = 0; q < TERMS; q++)
    for (int i = 0; (f = listed_formula(i)) && p->formulas < MAX_FORMULAS; i++)
      if (is_on_page(&terms[q], f))
        p->series[p->formulas++] = (struct page_series){ f->name, terms[q].of, f };
  memcpy(p->series + p->formulas, terms, sizeof terms);
}

/* The motion */

static double number(const struct page *p, const char *name)
{
  return at_number(p->at, quantity_named(p->quantities, name));
}

static double value(const struct page *p, enum quantity_id q) { return number(p, quantity_rows[q].name); }

/* Returns the digits of x that its uncertainty from a recording leaves; unknown nan: all */
static int digits_of(const struct page *p, double x, double unknown)
{
  return isnan(unknown) || p->digits_are_given ? p->digits : digits_known(x, unknown);
}

static int digits_of_value(const struct page *p, enum quantity_id q)
{
  const int place = quantity_named(p->quantities, quantity_rows[q].name);
  return digits_of(p, at_number(p->at, place), at_data_error(p->at, place));
}

/* Writes "from -0.31 to -0.297". */
static void write_interval(const struct page *p, double low, double high)
{
  const double unknown = (high - low) / 2;
  fprintf(p->file, "from %.*g to %.*g", digits_of(p, low, unknown), low, digits_of(p, high, unknown), high);
}

/* Writes the columns low.NAME and high.NAME. */
static void write_intervals(const struct page *p)
{
  fputs("  As far as the recording tells:\n", p->file);
  for (enum quantity_id q = Q_V_START; q <= Q_MULTIPLIER; q++) {
    const char *name = quantity_rows[q].name;
    fprintf(p->file, "  %-14s ", name);
    write_interval(p, number(p, wrong_text("low.%s", name)), number(p, wrong_text("high.%s", name)));
    fputc('\n', p->file);
  }
  if (number(p, "low.displacement") < 0 && number(p, "high.displacement") > 0)
    fputs("  The recording does not tell in which direction the crawler moves.\n", p->file);
}

static void write_displacement(const struct page *p)
{
  double displacement = value(p, Q_DISPLACEMENT);
  if (p->answer->regime == SCALLOP_AT_REST)
    fputs("  It stays where it is: one body never moves, and the other is pushed away and pulled back.\n", p->file);
  else if (displacement == 0)
    fputs("  It moves to and fro, and is where it was after each period.\n", p->file);
  else
    fprintf(p->file, "  It crawls %s, by %.*g in each period: a mean velocity of %.*g.\n",
            displacement > 0 ? "forward (towards body 2)" : "backward (towards body 1)",
            digits_of_value(p, Q_DISPLACEMENT), fabs(displacement), digits_of_value(p, Q_MEAN_VELOCITY),
            value(p, Q_MEAN_VELOCITY));
}

static void write_velocities(const struct page *p)
{
  double multiplier = value(p, Q_MULTIPLIER);
  fprintf(p->file,
          "  Both bodies have the velocity %.*g when the extension starts, and %.*g when the contraction starts.\n",
          digits_of_value(p, Q_V_START), value(p, Q_V_START), digits_of_value(p, Q_V_MID), value(p, Q_V_MID));
  if (multiplier == 0)
    fputs("  Started with a velocity near this one, it moves like this from the next period on.\n", p->file);
  else if (p->answer->status == SCALLOP_OK)
    fprintf(p->file, "  A small deviation from this motion shrinks to %.*g of itself in each period.\n",
            digits_of_value(p, Q_MULTIPLIER), multiplier);
}

static void write_segments(const struct page *p)
{
  struct mode_segment segment[MAX_SEGMENTS];
  char words[MODE_WORDS];
  int count = motion_segments(segment, &p->at->solved[STEADY_STATE].motion, p->answer);
  for (int i = 0; i < count && i < MAX_SEGMENTS; i++) {
    bool first = i == 0 || segment[i].phase != segment[i - 1].phase;
    fprintf(p->file, "  %-12s %s from %.*g to %.*g\n", first ? phase_names[segment[i].phase] : "",
            mode_in_words(words, segment[i].mode), p->digits, segment[i].from, p->digits, segment[i].until);
  }
  if (count > MAX_SEGMENTS)
    fprintf(p->file, "  %-12s and %d more changes of mode\n", "", count - MAX_SEGMENTS);
}

static void write_motion(const struct page *p)
{
  char status[ANSWER_STATUS];
  fprintf(p->file, "\nWhat it does (Froude number %.*g, %s)\n", p->digits, value(p, Q_FROUDE),
          scallop_regime_text(p->answer->regime));
  write_displacement(p);
  if (p->answer->status != SCALLOP_OK)
    fprintf(p->file, "  This is one of many steady motions: %s.\n", answer_status_text(status, p->answer));
  if (p->answer->regime != SCALLOP_AT_REST)
    write_velocities(p);
  write_segments(p);
  if (p->is_recorded)
    write_intervals(p);
}

/* The series */

static void write_error(const struct page *p, double error)
{
  if (error == 0)
    fputs(", the same", p->file);
  else if (error < -1)
    fputs(", wrong sign", p->file);
  else if (isfinite(error))
    fprintf(p->file, ", %.3g %% off", 100 * fabs(error));
}

/* Returns "O(T)", "O(T^4)". */
static const char *order_text(double order) { return order == 1 ? "O(T)" : wrong_text("O(T^%g)", order); }

static void write_verdict(const struct page *p, const struct page_series *t)
{
  const struct claim_row *c = claim_of(p->at, t->formula);
  double limit = number(p, wrong_text("error_limit.%s", t->name));
  const char *claimed = order_text(c->claimed_order), *derived = order_text((double)c->derived_order);
  if (c->verdict == CLAIM_UNDECIDED)
    fprintf(p->file, "undecided: %s", c->reason);
  else if (c->exact)
    fputs("proven: it is exact", p->file);
  else if (c->verdict == CLAIM_SHARPER)
    fprintf(p->file, "proven, and better than claimed: the error is %s, not only %s", derived, claimed);
  else if (c->verdict == CLAIM_HOLDS)
    fprintf(p->file, "proven: the error is %s, as claimed", derived);
  else if (isfinite(limit))
    fprintf(p->file, "refuted: %s is claimed, but the relative error tends to %.3g %% as T -> 0", claimed, 100 * limit);
  else if (c->derived_order <= 0)
    fprintf(p->file, "refuted: %s is claimed, but the error does not vanish as T -> 0", claimed);
  else
    fprintf(p->file, "refuted: %s is claimed, but the error is %s", claimed, derived);
}

static void write_reach(const struct page *p, const struct page_series *t)
{
  static const int percents[] = { PAGE_PERCENTS };
  double T = 1, limit = number(p, wrong_text("error_limit.%s", t->name));
  for (int i = 0; i < 2 && isfinite(T) && T > 0; i++) { /* else the first implies the second */
    const int percent = percents[i];
    T = number(p, wrong_text("reach_%g.%s", percent / 100., t->name));
    fputs(i == 0 ? "       off " : ", ", p->file);
    if (isnan(T))
      fprintf(p->file, "%d %%: no exact value", percent);
    else if (isinf(T))
      fprintf(p->file, "by less than %d %% at every T", percent);
    else if (T > 0)
      fprintf(p->file, "by %d %% at T = %.*g (Froude %.3g)", percent, p->digits, T,
              motion_froude(&p->study->motion, T));
    else if (isnan(limit))
      fprintf(p->file, "by more than %d %% at every small T", percent);
    else
      fprintf(p->file, "by more than %d %% however small T is (%.3g %% as T -> 0)", percent, 100 * limit);
  }
  fputc('\n', p->file);
}

static const char *equation_of(const struct page_series *t)
{
  const char *equation = t->formula->equation;
  return *equation && strcmp(equation, "-") != 0 ? equation : t->name;
}

/* Writes a formula once with all of the same value and claim, as (26) and (27). */
static void write_formula(const struct page *p, const struct page_series *t)
{
  const double of_formula = number(p, wrong_text("value.%s", t->name));
  char equations[400] = "", names[1000] = "";
  for (const struct page_series *u = p->series; u < p->series + p->formulas; u++) {
    const double other = number(p, wrong_text("value.%s", u->name));
    const char *comma = u == t ? "" : ", ";
    bool same = u->of == t->of && u->formula->remainder == t->formula->remainder
                && (other == of_formula || (isnan(other) && isnan(of_formula)));
    if (same && u < t)
      return;
    if (same) {
      snprintf(equations + strlen(equations), sizeof equations - strlen(equations), "%s%s", comma, equation_of(u));
      snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", comma, u->name);
    }
  }
  fprintf(p->file, "  %s %s ", equations, quantity_rows[t->of].name);
  if (isnan(of_formula)) {
    fprintf(p->file, "has no value: it divides by l'', which is 0 at an end of a phase [%s]\n", names);
    return;
  }
  fprintf(p->file, "= %.*g, exact %.*g", p->digits, of_formula, p->digits, value(p, t->of));
  write_error(p, number(p, wrong_text("deviation.%s", t->name)));
  fprintf(p->file, " [%s]\n       ", names);
  write_verdict(p, t);
  fputc('\n', p->file);
  write_reach(p, t);
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

static void write_transition(const struct page *p, const struct transition *e)
{
  fprintf(p->file, "  T = %.*g%s", digits_of(p, e->T, e->error), e->T, p->is_recorded ? ", " : "");
  if (p->is_recorded)
    write_interval(p, e->T - e->error, e->T + e->error);
  fprintf(p->file, " (Froude %.3g): %s\n", motion_froude(&p->study->motion, e->T), e->causes);
}

static void write_transitions(const struct page *p)
{
  enum { SHOWN = 8 };
  const struct transitions *e = study_transitions(p->study);
  fputs("\nWhere the expansion ends\n", p->file);
  if (e->count == 0 && p->study->derived.status != SCALLOP_OK)
    fputs("  There is no expansion.\n", p->file);
  else if (e->count == 0)
    fprintf(p->file, "  Nowhere: the sequence of modes is the same at every T up to %.3g.\n", e->until);
  for (long i = 0; i < e->count && i < SHOWN; i++)
    write_transition(p, &e->transition[i]);
  if (e->left_out > 0)
    fprintf(p->file, "  Left out: %ld changes that other curves through the recording do not have\n", e->left_out);
  if (e->count > SHOWN)
    fprintf(p->file, "  and %ld more transitions at larger T\n", e->count - SHOWN);
  for (long i = 0; i < e->reversals; i++)
    fprintf(p->file, "%s T = %.*g", i == 0 ? "  The direction of crawling reverses at" : ",", p->digits,
            e->reversal[i].T);
  fputs(e->reversals > 0 ? ".\n" : "", p->file);
}

static void write_summary(const struct page *p)
{
  double T = p->at->place.point.crawler.T;
  write_motion(p);
  fputs("\nFormulas of the paper, for this gait and these parameters\n", p->file);
  for (int i = 0; i < p->formulas; i++)
    write_formula(p, &p->series[i]);
  if (p->study->derived.status != SCALLOP_OK)
    fprintf(p->file, "  There is no derived series: %s.\n", study_no_series_text(p->study));
  for (int i = 0; i < TERMS; i++)
    write_best(p, terms[i].of);
  write_transitions(p);
  if (p->study->transitions.count > 0)
    fprintf(p->file, "  T = %.*g is %s.\n", p->digits, T, study_position_text(p->study, T));
  fputs("\nMore: scallop steady --certified       proven digits\n"
        "      scallop claims                   the claims of the paper\n"
        "      scallop series --source derived  the expansion\n"
        "      scallop breakdown --all          every transition and reach\n",
        p->file);
}

static void write_breakdown(const struct page *p)
{
  const int count = p->formulas + (p->study->derived.status == SCALLOP_OK ? TERMS : 0);
  write_transitions(p);
  fputs("\nUp to which T a series holds\n", p->file);
  for (const struct page_series *t = p->series; t < p->series + count; t++) {
    const char *first = t->formula ? equation_of(t) : "derived terms below T^8";
    bool named = t->formula && first != t->name;
    fprintf(p->file, "  %s%s%s, %s\n", first, named ? " " : "", named ? t->name : "", quantity_rows[t->of].name);
    write_reach(p, t);
  }
  fputs("\nMore: --all, or --only transition, reversal, reach, radius or best, gives the table with every row.\n",
        p->file);
}

/* Writes a page, or a row in a format for programs. omitted: parameters that the page does not list */
static void visit(struct rows *rows, struct at *at, const char *const *omitted, void (*write)(const struct page *))
{
  enum { DIGITS = 6 };
  int digits = (int)rows->request->style.digits;
  char parameters[PARAMETERS_TEXT];
  struct page p = { table_page(&rows->table),          digits > 0 ? digits : DIGITS,     at,
                    &rows->sheet.required->quantities, &at->solved[STEADY_STATE].answer, .formulas = 0 };
  if (!p.file) {
    sheet_row(&rows->sheet, &rows->table, at);
    return;
  }
  find_formulas(&p);
  p.digits_are_given = digits > 0;
  p.is_recorded = gait_file_of(at->place.point.crawler.gait) != NULL;
  p.study = at->is_outside ? NULL : study_of(at);
  if (!p.study || isnan(value(&p, Q_V_START))) {
    fprintf(p.file, "\nThis crawler has no page: %s.\n", at->why);
    return;
  }
  parameters_text(parameters, &at->place.point, omitted, true);
  fprintf(p.file, "\nCrawler:%s\n", parameters);
  write(&p);
}

static void page_of_crawler(struct rows *rows, struct at *at) { visit(rows, at, NULL, write_summary); }

static void page_of_breakdown(struct rows *rows, struct at *at)
{
  visit(rows, at, (const char *const[]){ "T", NULL }, write_breakdown);
}

/* The columns */

/* Returns false, with a message on stderr, if a formula file is given without a formula for the page. */
static bool has_formulas(const struct request *request)
{
  return formula_file_applies(request->style.command, request->formulas, is_on_page, NULL,
                              "the steady v_start or displacement");
}

const char *summary_plan(struct rows *rows)
{
  static const char *const before[] = { "froude",     "v_start", "v_mid", "displacement", "mean_velocity",
                                        "multiplier", "regime",  "modes", "motion" };
  static const char *const behind[] = { "first_transition",
                                        "first_transition_T",
                                        "first_transition_froude",
                                        "reversals",
                                        "best_order",
                                        "best_error",
                                        "status" };
  static const char *const of_formula[][2] = { { "", "value" },
                                               { "_error", "deviation" },
                                               { "_reach_1", "reach_0.01" },
                                               { "_reach_5", "reach_0.05" },
                                               { "_limit", "error_limit" },
                                               { "_verdict", "verdict" },
                                               { "_order", "order" } };
  struct page p = { .formulas = 0 };
  const char *wrong = NULL;
  if (!has_formulas(rows->request))
    return "";
  find_formulas(&p);
  rows->has_parameters = true;
  rows->visit = page_of_crawler;
  for (size_t i = 0; i < sizeof before / sizeof *before && !wrong; i++) {
    const bool has_interval = gait_file_of(rows->request->point.crawler.gait) && i > 0 && i < 6;
    wrong = rows_own(rows, "%s", before[i]);
    for (int high = 0; high < 2 && has_interval && !wrong; high++)
      wrong = rows_own(rows, high ? "high.%s" : "low.%s", before[i]);
  }
  for (const struct page_series *t = p.series; t < p.series + p.formulas; t++)
    for (size_t i = 0; i < sizeof of_formula / sizeof *of_formula && !wrong; i++)
      wrong = rows_own(rows, "%s%s = %s.%s", t->name, of_formula[i][0], of_formula[i][1], t->name);
  for (size_t i = 0; i < sizeof behind / sizeof *behind && !wrong; i++)
    wrong = rows_own(rows, "%s", behind[i]);
  return wrong;
}

const char *breakdown_page(struct rows *rows)
{
  rows->visit = page_of_breakdown;
  return has_formulas(rows->request) ? rows_own(rows, "v_start") : "";
}
