/* "The maximum average velocity occurs at the boundary" where the start velocity vanishes (sections 4.4 and 5), and mean velocity
 * "increases to a maximum and then decays to zero" (section 4.5). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/claims/family.h"
#include "compare/claims/words.h"

enum { MEASURED = 200, REASON = 320, CONDITIONS = 120, SHORT = 6 };

/* ---- one family ---- */

struct survey {
  struct family family;
  struct scan scan;
  struct boundary boundary;
  struct peaks peaks;
};

static void survey(struct survey *s, const struct scallop_crawler *c, enum varied varied)
{
  s->family = (struct family){ *c, varied };
  family_scan(&s->scan, &s->family, false);
  s->boundary = family_boundary(&s->family, &s->scan);
  s->peaks = family_peaks(&s->family, &s->scan, true);
}

/* Of the crawler and what is varied; the last one is kept, as rows of one survey come one after another. */
static const struct survey *survey_of(const struct words *w, enum varied varied)
{
  static struct survey last;
  const struct scallop_crawler *c = &w->crawler, *of = &last.family.crawler;
  bool same = last.scan.count > 0 && last.family.varied == varied && of->gait == c->gait && of->m1 == c->m1
              && of->m2 == c->m2 && of->F1 == c->F1 && of->F2 == c->F2 && of->L == c->L && of->T == c->T
              && of->alpha == c->alpha;
  if (!same)
    survey(&last, c, varied);
  return &last;
}

/* v_start vanishes, mean velocity rises up to there and falls behind, proven, and nowhere in the scan is it higher. */
static bool peaks_at_boundary(const struct survey *s)
{
  return s->boundary.found && s->boundary.rises_before && s->boundary.falls_after && peaks_at(&s->peaks, s->boundary.at);
}

static const char *range_text(enum varied varied)
{
  static const char *const text[] = { "F1/F2 from 1.01 to 7838 by 1 %",
                                      "F1 and F2 together, 1/Froude from 1e-3 to 92 by 1 %",
                                      "T alone, 1/Froude from 1e-3 to 91 by 2 %" };
  return text[varied];
}

/* How mean velocity is printed: T0 is the T of the family's crawler, also where T is varied. */
static const char *speed_text(const struct family *f) { return f->varied == VARY_PERIOD ? "<U> T0/L" : "<U> T/L"; }

static void say_T0(char measured[MEASURED], const struct family *f)
{
  size_t used = strlen(measured);
  if (f->varied == VARY_PERIOD)
    snprintf(measured + used, MEASURED - used, "; T0 = %.6g", f->crawler.T);
}

static void boundary_row(const struct words *w, const struct words_claim *claim)
{
  const struct survey *s = survey_of(w, (enum varied)claim->which);
  char conditions[CONDITIONS], measured[MEASURED];
  const struct boundary *b = &s->boundary;
  snprintf(conditions, sizeof conditions, "%s; %s", words_whose(w), range_text(s->family.varied));
  snprintf(measured, sizeof measured, "certified: v_start > 0 at %s = %.10g (1 - 2^-60) and not at (1 + 2^-60)",
           family_name(&s->family), b->at);
  words_enter(w, claim, conditions, w->of_the_paper, words_verdict(b->found, false), b->found ? measured : "-",
              "no change of sign was proven");
}

/* Where the mean velocity is higher than at the boundary: on the scan's highest peak, or at its first point */
static double higher_place(const struct survey *s)
{
  double first = s->scan.x[0];
  if (s->peaks.count > 0 && s->peaks.speed[s->peaks.highest] > s->scan.speed[0])
    return s->peaks.at[s->peaks.highest];
  return first;
}

/* A command that shows it; true: proven for the very numbers in it */
static bool example(char reason[REASON], const struct survey *s)
{
  const double places[] = { short_number(s->boundary.at, SHORT), short_number(higher_place(s), SHORT) };
  int used = snprintf(reason, REASON, "mean_velocity is lower at the boundary, the first row: ");
  family_command(reason + used, REASON - (size_t)used, &s->family, places, 2);
  return family_rises(&s->family, places[0], places[1]);
}

static void peak_row(const struct words *w, const struct words_claim *claim)
{
  const struct survey *s = survey_of(w, (enum varied)claim->which);
  char conditions[CONDITIONS], measured[MEASURED], reason[REASON] = "";
  const struct boundary *b = &s->boundary;
  double top = higher_place(s);
  bool holds = peaks_at_boundary(s);
  snprintf(conditions, sizeof conditions, "%s; %s", words_whose(w), range_text(s->family.varied));
  snprintf(measured, sizeof measured,
           "at %s = %.10g the certified slope d(%s)/d ln is %.6f before, %.6f after; %s is %.6f there, highest %.6f at %.4g",
           family_name(&s->family), b->at, speed_text(&s->family), b->before, b->after, speed_text(&s->family), b->speed,
           family_speed(&s->family, top), top);
  say_T0(measured, &s->family);
  bool proven = !holds && example(reason, s);
  words_enter(w, claim, conditions, w->of_the_paper, words_verdict(holds, proven), measured, reason);
}

/* ---- is it the only maximum? ---- */

static void single_peak_row(const struct words *w, const struct words_claim *claim)
{
  const struct survey *s = survey_of(w, (enum varied)claim->which);
  char conditions[CONDITIONS], measured[MEASURED], reason[REASON] = "";
  const struct peaks *p = &s->peaks;
  snprintf(conditions, sizeof conditions, "%s; %s", words_whose(w), range_text(s->family.varied));
  snprintf(measured, sizeof measured, "certified maxima of <U> T/L: %d;", p->count);
  for (int i = 0; i < p->count; i++)
    snprintf(measured + strlen(measured), sizeof measured - strlen(measured), " %.6f at %.4g%s", p->speed[i], p->at[i],
             i + 1 < p->count ? "," : "");
  if (p->count > 1) {
    const struct scan *scan = &s->scan;
    double low = p->at[0], least = INFINITY; /* the lowest place between the last two */
    for (int i = 0; i < scan->count; i++)
      if (scan->x[i] > p->at[p->count - 2] && scan->x[i] < p->at[p->count - 1] && scan->speed[i] < least) {
        least = scan->speed[i];
        low = scan->x[i];
      }
    const double places[] = { short_number(p->at[p->count - 2], SHORT), short_number(low, SHORT),
                              short_number(p->at[p->count - 1], SHORT) };
    size_t used = (size_t)snprintf(reason, sizeof reason, "mean_velocity falls and rises again: ");
    family_command(reason + used, sizeof reason - used, &s->family, places, 3);
  }
  words_enter(w, claim, conditions, w->of_the_paper, words_verdict(p->count == 1, p->count > 1), measured, reason);
}

/* ---- does it decay once a body sticks? ---- */

/* The two places behind the onset of sticking between which the mean velocity rises most; false if it never rises. */
static bool largest_rise(const struct scan *scan, int *low, int *high)
{
  int onset = 0, lowest;
  double most = 0;
  while (onset < scan->count && scan->sliding[onset])
    onset++;
  lowest = onset;
  for (int i = onset; i < scan->count; i++) {
    if (scan->speed[i] < scan->speed[lowest])
      lowest = i;
    if (scan->speed[i] - scan->speed[lowest] > most) {
      most = scan->speed[i] - scan->speed[lowest];
      *low = lowest;
      *high = i;
    }
  }
  return most > 0;
}

static void decay_row(const struct words *w, const struct words_claim *claim)
{
  const struct survey *s = survey_of(w, (enum varied)claim->which);
  char conditions[CONDITIONS], measured[MEASURED] = "it never rises between neighbours", reason[REASON] = "";
  int low = 0, high = 0;
  bool rises = largest_rise(&s->scan, &low, &high), proven = false;
  snprintf(conditions, sizeof conditions, "%s; %s, where a body sticks", words_whose(w), range_text(s->family.varied));
  if (rises) {
    const double places[] = { short_number(s->scan.x[low], SHORT), short_number(s->scan.x[high], SHORT) };
    proven = family_rises(&s->family, places[0], places[1]);
    snprintf(measured, sizeof measured, "%s: %s rises from %.6f at %s = %.6g to %.6f at %.6g",
             proven ? "certified" : "not proven", speed_text(&s->family), family_speed(&s->family, places[0]),
             family_name(&s->family), places[0], family_speed(&s->family, places[1]), places[1]);
    say_T0(measured, &s->family);
    size_t used = (size_t)snprintf(reason, sizeof reason, "mean_velocity rises, in stick-slip: ");
    family_command(reason + used, sizeof reason - used, &s->family, places, 2);
  }
  words_enter(w, claim, conditions, w->of_the_paper, words_verdict(!rises, proven), measured, reason);
}

/* ---- for which alpha, for which masses ---- */

/* As peaks_at_boundary, with no more proven than needed: where the highest place is plainly another one, that is all. */
static bool holds_for(struct survey *s, const struct scallop_crawler *c)
{
  s->family = (struct family){ *c, VARY_RATIO };
  family_scan(&s->scan, &s->family, true);
  s->peaks = family_peaks(&s->family, &s->scan, false);
  s->boundary = (struct boundary){ .at = rough_boundary(&s->family, &s->scan) };
  if (!peaks_at(&s->peaks, s->boundary.at))
    return false;
  s->boundary = family_boundary(&s->family, &s->scan);
  return peaks_at_boundary(s);
}

static const char *const coarse = "F1/F2 from 1.01 to 7732 by 4 %";

static bool holds_for_alpha(struct survey *s, const struct scallop_crawler *crawler, int millionths)
{
  struct scallop_crawler c = *crawler;
  c.alpha = millionths / 1e6;
  return holds_for(s, &c);
}

/* The last place that is like `from`, seen from there towards `to`, which is not */
static int last_like(struct survey *s, const struct scallop_crawler *c, int from, int to)
{
  bool like = holds_for_alpha(s, c, from);
  while (abs(to - from) > 1) {
    int mid = from + (to - from) / 2;
    *(holds_for_alpha(s, c, mid) == like ? &from : &to) = mid;
  }
  return from;
}

static void alpha_row(const struct words *w, const struct words_claim *claim)
{
  enum { FIRST = 510000, STEP = 20000, STEPS = 25 };
  char conditions[CONDITIONS], measured[MEASURED], reason[REASON] = "";
  struct survey s;
  int from = 0, to = 0;
  for (int i = 0; i < STEPS && !to; i++) {
    bool holds = holds_for_alpha(&s, &w->crawler, FIRST + i * STEP);
    if (holds && !from)
      from = FIRST + i * STEP;
    if (!holds && from)
      to = FIRST + i * STEP;
  }
  int first = from > FIRST ? last_like(&s, &w->crawler, from, from - STEP) : from;
  int last = to ? last_like(&s, &w->crawler, to - STEP, to) : FIRST + (STEPS - 1) * STEP;
  snprintf(measured, sizeof measured, "certified slopes: it holds from alpha = %.6f to %.6f, and not at %.6f and %.6f",
           first / 1e6, last / 1e6, (first - 1) / 1e6, (last + 1) / 1e6);
  holds_for_alpha(&s, &w->crawler, 520000);
  bool proven = example(reason, &s);
  snprintf(conditions, sizeof conditions, "%s, alpha from 0.51 to 0.99 by 0.02; %s", words_whose(w), coarse);
  words_enter(w, claim, conditions, true, words_verdict(first <= FIRST && !to, proven), measured, reason);
}

static void masses_row(const struct words *w, const struct words_claim *claim)
{
  enum { DOUBLINGS = 5 };
  char conditions[CONDITIONS], measured[MEASURED] = "", reason[REASON] = "";
  int held = 0;
  bool proven = false;
  struct survey s;
  for (int i = -DOUBLINGS; i <= DOUBLINGS; i++) {
    struct scallop_crawler c = w->crawler;
    c.m1 = ldexp(1, i);
    c.m2 = 1;
    bool holds = holds_for(&s, &c);
    held += holds;
    if (!holds && !proven)
      proven = example(reason, &s);
  }
  snprintf(measured, sizeof measured, "certified slopes: it holds for %d of %d", held, 2 * DOUBLINGS + 1);
  snprintf(conditions, sizeof conditions, "%s, m2 = 1, m1 = 1/32, 1/16, ..., 32; %s", words_whose(w), coarse);
  words_enter(w, claim, conditions, true, words_verdict(held == 2 * DOUBLINGS + 1, proven), measured, reason);
}

/* ---- at random ---- */

static void random_row(const struct words *w, const struct words_claim *claim)
{
  enum { CRAWLERS = 100 };
  char measured[MEASURED], reason[REASON] = "";
  int with_boundary = 0, held = 0;
  bool proven = false;
  struct survey s;
  gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  for (int i = 0; q && i < CRAWLERS; i++) {
    struct scallop_crawler c = words_random(q, w->crawler.gait);
    c.alpha = fmax(c.alpha, 1 - c.alpha);
    s.family = (struct family){ c, VARY_RATIO };
    family_scan(&s.scan, &s.family, true);
    s.peaks = family_peaks(&s.family, &s.scan, false);
    s.boundary = (struct boundary){ .at = rough_boundary(&s.family, &s.scan) };
    bool at = peaks_at(&s.peaks, s.boundary.at);
    with_boundary += isfinite(s.boundary.at);
    held += at;
    if (isfinite(s.boundary.at) && !at && !proven)
      proven = example(reason, &s);
  }
  if (q)
    gsl_qrng_free(q);
  snprintf(measured, sizeof measured, "in doubles: %d have a boundary, and for %d of these it is the highest point",
           with_boundary, held);
  words_enter(w, claim,
              "100 quasi-random crawlers, masses and forces within 100:1, alpha > 1/2; F1/F2 from 1.01 to 7732 by 4 %", true,
              words_verdict(q && held == with_boundary, proven), measured, reason);
}

static const char peaks[] = "mean_velocity_peaks_where_v_start_is_0", decays[] = "mean_velocity_decays_once_sticking_begins";

const struct words_claim words_of_peaks[] = {
  { peaks, "4.4", "mean velocity", WORDS_EACH_GAIT, random_row, 0 },
  { "start_velocity_changes_sign", "4.4", "v_start", WORDS_EACH_CRAWLER, boundary_row, VARY_RATIO },
  { peaks, "4.4", "mean velocity", WORDS_EACH_CRAWLER, peak_row, VARY_RATIO },
  { "mean_velocity_has_one_maximum", "4.5", "mean velocity", WORDS_EACH_CRAWLER, single_peak_row, VARY_RATIO },
  { decays, "4.5", "mean velocity", WORDS_EACH_CRAWLER, decay_row, VARY_RATIO },
  { "start_velocity_changes_sign", "4.4", "v_start", WORDS_EACH_CRAWLER, boundary_row, VARY_FORCES },
  { peaks, "4.4", "mean velocity", WORDS_EACH_CRAWLER, peak_row, VARY_FORCES },
  { decays, "4.5", "mean velocity", WORDS_EACH_CRAWLER, decay_row, VARY_FORCES },
  { "start_velocity_changes_sign", "4.4", "v_start", WORDS_EACH_CRAWLER, boundary_row, VARY_PERIOD },
  { peaks, "4.4", "mean velocity", WORDS_EACH_CRAWLER, peak_row, VARY_PERIOD },
  { decays, "4.5", "mean velocity", WORDS_EACH_CRAWLER, decay_row, VARY_PERIOD },
  { peaks, "4.4", "mean velocity", WORDS_OF_THE_PAPER, alpha_row, 0 },
  { peaks, "4.4", "mean velocity", WORDS_OF_THE_PAPER, masses_row, 0 },
  { .claim = NULL }
};
