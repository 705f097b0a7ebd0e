/* "The maximum average velocity occurs at the boundary" where the start velocity vanishes (sections 4.4 and 5), mean
 * velocity "increases to a maximum and then decays to zero" (section 4.5), and what else is said to be extreme at that
 * boundary. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point.h"
#include "compare/claims/evidence.h"
#include "compare/claims/family.h"

enum { SHORT = 6 };

/* {1} to {6} of the texts of a family. T0 is the T of the family's crawler, also where T is varied. */
static const char *const words[][6] = { [VARY_RATIO] = { "F1/F2 from 1.01 to 7838 by 1 %", "F1/F2", "<U> T/L", "",
                                                         "3,13", "F1/F2" },
                                        [VARY_FORCES] = { "F1 and F2 together, 1/Froude from 1e-3 to 92 by 1 %", "F2",
                                                          "<U> T/L", "", "3,4,13", "F1 and F2 together," },
                                        [VARY_PERIOD] = { "T alone, 1/Froude from 1e-3 to 91 by 2 %", "T", "<U> T0/L",
                                                          "; T0 = {6g T:0}", "6,12,13", "T alone," } };

static void find(struct question *q, int i, double x) { q->found[i] = short_number(x, SHORT); }

/* The family of a row. Several rows of one family come one after another: the last family is kept. */
static const struct family *survey(struct question *q)
{
  static struct family last;
  enum varied varied = q->claim->varied;
  memcpy(q->word, words[varied], sizeof words[varied]);
  if (last.count == 0 || last.varied != varied || !same_crawler(&last.crawler, &q->crawler)) {
    family_scan(&last, &q->crawler, varied, false);
    family_prove_maxima(&last);
    family_prove_boundary(&last);
  }
  return &last;
}

/* x1: the boundary */
void start_velocity_changes_sign(struct question *q)
{
  const struct family *f = survey(q);
  q->found[0] = f->boundary;
  q->row.evidence = CERTIFIED_CRAWLER;
  settle(q, f->found, false);
}

/* Where the mean velocity is higher than at the boundary: on the scan's highest peak, or at its first point */
static struct place higher_place(const struct family *f)
{
  const struct place *peak = &f->maximum[f->highest];
  return f->maxima > 0 && peak->speed > f->scan[0].speed ? *peak : f->scan[0];
}

/* x1: the boundary, x2: a place where the mean velocity is higher; is that proven for these very numbers? */
static bool is_higher(struct question *q, const struct family *f)
{
  arb_t excess;
  find(q, 0, f->boundary);
  find(q, 1, higher_place(f).x);
  solve_motions(q, true);
  arb_init(excess);
  bool higher = judge(q, excess) < 0;
  arb_clear(excess);
  return higher;
}

void peaks_at_boundary(struct question *q)
{
  const struct family *f = survey(q);
  const struct place top = higher_place(f);
  const double measured[] = { f->boundary, f->before, f->after, f->boundary_speed, top.speed, top.x };
  memcpy(q->found + 2, measured, sizeof measured);
  bool holds = family_peak_is_proven(f);
  settle(q, holds, !holds && is_higher(q, f));
}

/* x4: how many maxima, {4}: all of them; x1, x2, x3: the last two, and the lowest place between them in the middle */
void one_maximum(struct question *q)
{
  const struct family *f = survey(q);
  char list[PEAKS_MOST * 32] = "";
  for (int i = 0; i < f->maxima; i++)
    snprintf(list + strlen(list), sizeof list - strlen(list), " %.6f at %.4g%s", f->maximum[i].speed, f->maximum[i].x,
             i + 1 < f->maxima ? "," : "");
  q->word[3] = list;
  q->found[3] = f->maxima;
  if (f->maxima > 1) {
    const struct place *a = &f->maximum[f->maxima - 2], *b = a + 1;
    struct place low = { .x = f->maximum[0].x, .speed = INFINITY };
    for (int i = 0; i < f->count; i++)
      if (f->scan[i].x > a->x && f->scan[i].x < b->x && f->scan[i].speed < low.speed)
        low = f->scan[i];
    find(q, 0, a->x);
    find(q, 1, low.x);
    find(q, 2, b->x);
    solve_motions(q, false);
    q->row.evidence = CERTIFIED_CRAWLER; /* of the maxima */
  }
  settle(q, f->maxima == 1, f->maxima > 1);
}

/* The two places behind the onset of sticking between which the mean velocity rises most; false if it never rises. */
static bool largest_rise(const struct family *f, struct place *low, struct place *high)
{
  int i = 0;
  double most = 0;
  while (i < f->count && f->scan[i].sliding)
    i++;
  for (const struct place *at = &f->scan[i], *lowest = at; at < f->scan + f->count; at++) {
    lowest = at->speed < lowest->speed ? at : lowest;
    if (at->speed - lowest->speed > most) {
      most = at->speed - lowest->speed;
      *low = *lowest;
      *high = *at;
    }
  }
  return most > 0;
}

/* x1, x2: these places */
void decays_once_sticking(struct question *q)
{
  const struct family *f = survey(q);
  struct place low = f->scan[0], high = low;
  bool rises = largest_rise(f, &low, &high);
  find(q, 0, low.x);
  find(q, 1, high.x);
  if (rises)
    proven(q);
  else
    settle(q, true, false);
}

/* With no more proven than needed: where the highest place is plainly another one, that is all. */
static bool peak_holds_for(struct family *f, const struct scallop_crawler *c)
{
  family_scan(f, c, VARY_RATIO, true);
  if (!family_peaks_at_boundary(f))
    return false;
  family_prove_boundary(f);
  return family_peak_is_proven(f);
}

static bool holds_for_alpha(struct family *f, struct scallop_crawler c, int millionths)
{
  c.alpha = millionths / 1e6;
  return peak_holds_for(f, &c);
}

/* The last alpha that is like `from`, seen from there towards `to`, which is not */
static int last_like(struct family *f, const struct scallop_crawler *c, int from, int to)
{
  bool like = holds_for_alpha(f, *c, from);
  while (abs(to - from) > 1) {
    int mid = from + (to - from) / 2;
    *(holds_for_alpha(f, *c, mid) == like ? &from : &to) = mid;
  }
  return from;
}

/* x3, x4: the first alpha and the last one for which it holds */
void peak_for_alphas(struct question *q)
{
  enum { FIRST = 510000, STEP = 20000, STEPS = 25 };
  struct family f;
  int from = 0, to = 0;
  for (int alpha = FIRST; alpha < FIRST + STEPS * STEP && !to; alpha += STEP) {
    bool holds = holds_for_alpha(&f, q->crawler, alpha);
    if (holds && !from)
      from = alpha;
    if (!holds && from)
      to = alpha;
  }
  int first = from > FIRST ? last_like(&f, &q->crawler, from, from - STEP) : from;
  int last = to ? last_like(&f, &q->crawler, to - STEP, to) : FIRST + (STEPS - 1) * STEP;
  q->found[2] = first / 1e6;
  q->found[3] = last / 1e6;
  holds_for_alpha(&f, q->crawler, 520000);
  settle(q, first <= FIRST && !to, is_higher(q, &f));
}

/* x3: for how many it holds, of x4; the first for which it does not, if that is proven, is the base crawler in the
 * end. */
void peak_for_masses(struct question *q)
{
  enum { DOUBLINGS = 5 };
  struct family f;
  struct scallop_crawler c = q->crawler;
  bool higher = false;
  q->found[3] = 2 * DOUBLINGS + 1;
  for (int i = -DOUBLINGS; i <= DOUBLINGS; i++) {
    c.m1 = ldexp(1, i);
    c.m2 = 1;
    bool holds = peak_holds_for(&f, &c);
    q->found[2] += holds;
    if (!holds && !higher) {
      q->crawler = c;
      higher = is_higher(q, &f);
    }
  }
  settle(q, q->found[2] == q->found[3], higher);
}

/* x3: how many have a boundary, x4: for how many that is the highest point; the base crawler likewise */
void peak_at_random(struct question *q)
{
  enum { CRAWLERS = 100 };
  struct scallop_crawler c[CRAWLERS];
  int count = random_crawlers(c, CRAWLERS, q->crawler.gait);
  bool higher = false;
  struct family f;
  for (int i = 0; i < count; i++) {
    c[i].alpha = fmax(c[i].alpha, 1 - c[i].alpha);
    family_scan(&f, &c[i], VARY_RATIO, true);
    bool has = isfinite(f.boundary), at = family_peaks_at_boundary(&f);
    q->found[2] += has;
    q->found[3] += at;
    if (has && !at && !higher) {
      q->crawler = c[i];
      higher = is_higher(q, &f);
    }
  }
  settle(q, count > 0 && q->found[2] == q->found[3], higher);
}

/* x1, x2, x3: three places through the boundary, before it, at it and behind it, 1 % apart */
void through_boundary(struct question *q)
{
  struct family f;
  memcpy(q->word, words[q->claim->varied], sizeof words[q->claim->varied]);
  family_scan(&f, &q->crawler, q->claim->varied, false);
  for (int i = 0; i < 3; i++)
    find(q, i, f.boundary * (0.99 + 0.01 * i));
  proven(q);
}
