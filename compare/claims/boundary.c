/* "The maximum average velocity occurs at the boundary" where the start velocity vanishes (sections 4.4 and 5), mean velocity
 * "increases to a maximum and then decays to zero" (section 4.5), and what else is said to be extreme at that boundary. */
#include <math.h>
#include <stdlib.h>

#include "compare/answers/point.h"
#include "compare/claims/decide.h"

enum { SHORT = 6 };

static enum varied varied_by(const struct question *q) { return *(const enum varied *)q->with; }

/* The family of a row. Several rows of one family come one after another: the last family is kept. */
static const struct family *survey(struct question *q)
{
  static const char *const range[] = { "F1/F2 from 1.01 to 7838 by 1 %",
                                       "F1 and F2 together, 1/Froude from 1e-3 to 92 by 1 %",
                                       "T alone, 1/Froude from 1e-3 to 91 by 2 %" };
  static struct family last;
  enum varied varied = varied_by(q);
  if (last.count == 0 || last.varied != varied || !same_crawler(&last.crawler, &q->crawler)) {
    family_scan(&last, &q->crawler, varied, false);
    family_prove_maxima(&last);
    family_prove_boundary(&last);
  }
  under(q, "%s; %s", q->whose, range[varied]);
  return &last;
}

void start_velocity_changes_sign(struct question *q)
{
  const struct family *f = survey(q);
  if (f->found)
    measured(q, "certified: v_start > 0 at %s = %.10g (1 - 2^-60) and not at (1 + 2^-60)", family_name(f), f->boundary);
  else
    measured(q, "-");
  reason(q, "no change of sign was proven");
  settle(q, f->found, false);
}

/* How mean velocity is printed: T0 is the T of the family's crawler, also where T is varied. */
static const char *speed_text(const struct family *f) { return f->varied == VARY_PERIOD ? "<U> T0/L" : "<U> T/L"; }

static void measure_T0(struct question *q, const struct family *f)
{
  if (f->varied == VARY_PERIOD)
    measured(q, "; T0 = %.6g", f->crawler.T);
}

/* Where the mean velocity is higher than at the boundary: on the scan's highest peak, or at its first point */
static struct place higher_place(const struct family *f)
{
  const struct place *peak = &f->maximum[f->highest];
  return f->maxima > 0 && peak->speed > f->scan[0].speed ? *peak : f->scan[0];
}

/* A command that shows it; true: proven for the very numbers in it */
static bool example_of_higher(struct question *q, const struct family *f)
{
  const double x[] = { short_number(f->boundary, SHORT), short_number(higher_place(f).x, SHORT) };
  *q->row.reason = '\0';
  reason(q, "mean_velocity is lower at the boundary, the first row: ");
  family_command(q, f, x, 2, family_cut(f));
  return family_rises(f, x[0], x[1]);
}

void peaks_at_boundary(struct question *q)
{
  const struct family *f = survey(q);
  const struct place top = higher_place(f);
  bool holds = family_peak_is_proven(f);
  measured(
      q, "at %s = %.10g the certified slope d(%s)/d ln is %.6f before, %.6f after; %s is %.6f there, highest %.6f at %.4g",
      family_name(f), f->boundary, speed_text(f), f->before, f->after, speed_text(f), f->boundary_speed, top.speed, top.x);
  measure_T0(q, f);
  settle(q, holds, !holds && example_of_higher(q, f));
}

/* A command that shows that mean velocity falls and rises again between the last two maxima */
static void example_of_two(struct question *q, const struct family *f)
{
  const struct place *a = &f->maximum[f->maxima - 2], *b = a + 1;
  struct place low = { .x = f->maximum[0].x, .speed = INFINITY };
  for (int i = 0; i < f->count; i++)
    if (f->scan[i].x > a->x && f->scan[i].x < b->x && f->scan[i].speed < low.speed)
      low = f->scan[i];
  const double x[] = { short_number(a->x, SHORT), short_number(low.x, SHORT), short_number(b->x, SHORT) };
  reason(q, "mean_velocity falls and rises again: ");
  family_command(q, f, x, 3, family_cut(f));
}

void one_maximum(struct question *q)
{
  const struct family *f = survey(q);
  measured(q, "certified maxima of <U> T/L: %d;", f->maxima);
  for (int i = 0; i < f->maxima; i++)
    measured(q, " %.6f at %.4g%s", f->maximum[i].speed, f->maximum[i].x, i + 1 < f->maxima ? "," : "");
  if (f->maxima > 1)
    example_of_two(q, f);
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

void decays_once_sticking(struct question *q)
{
  const struct family *f = survey(q);
  struct place low = f->scan[0], high = low;
  under(q, ", where a body sticks");
  if (!largest_rise(f, &low, &high)) {
    measured(q, "it never rises between neighbours");
    settle(q, true, false);
    return;
  }
  const double x[] = { short_number(low.x, SHORT), short_number(high.x, SHORT) };
  bool proven = family_rises(f, x[0], x[1]);
  measured(q, "%s: %s rises from %.6f at %s = %.6g to %.6f at %.6g", proven ? "certified" : "not proven", speed_text(f),
           family_speed(f, x[0]), family_name(f), x[0], family_speed(f, x[1]), x[1]);
  measure_T0(q, f);
  reason(q, "mean_velocity rises, in stick-slip: ");
  family_command(q, f, x, 2, family_cut(f));
  settle(q, false, proven);
}

/* For which alpha, for which masses, and at random */

#define COARSE "F1/F2 from 1.01 to 7732 by 4 %%"

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
  under(q, "%s, alpha from 0.51 to 0.99 by 0.02; " COARSE, q->whose);
  measured(q, "certified slopes: it holds from alpha = %.6f to %.6f, and not at %.6f and %.6f", first / 1e6, last / 1e6,
           (first - 1) / 1e6, (last + 1) / 1e6);
  holds_for_alpha(&f, q->crawler, 520000);
  settle(q, first <= FIRST && !to, example_of_higher(q, &f));
}

void peak_for_masses(struct question *q)
{
  enum { DOUBLINGS = 5 };
  struct family f;
  int held = 0;
  bool proven = false;
  for (int i = -DOUBLINGS; i <= DOUBLINGS; i++) {
    struct scallop_crawler c = q->crawler;
    c.m1 = ldexp(1, i);
    c.m2 = 1;
    bool holds = peak_holds_for(&f, &c);
    held += holds;
    if (!holds && !proven)
      proven = example_of_higher(q, &f);
  }
  under(q, "%s, m2 = 1, m1 = 1/32, 1/16, ..., 32; " COARSE, q->whose);
  measured(q, "certified slopes: it holds for %d of %d", held, 2 * DOUBLINGS + 1);
  settle(q, held == 2 * DOUBLINGS + 1, proven);
}

void peak_at_random(struct question *q)
{
  enum { CRAWLERS = 100 };
  struct scallop_crawler c[CRAWLERS];
  int with_boundary = 0, held = 0, count = random_crawlers(c, CRAWLERS, q->crawler.gait);
  bool proven = false;
  struct family f;
  for (int i = 0; i < count; i++) {
    c[i].alpha = fmax(c[i].alpha, 1 - c[i].alpha);
    family_scan(&f, &c[i], VARY_RATIO, true);
    bool has = isfinite(f.boundary), at = family_peaks_at_boundary(&f);
    with_boundary += has;
    held += at;
    if (has && !at && !proven)
      proven = example_of_higher(q, &f);
  }
  under(q, "100 quasi-random crawlers, masses and forces within 100:1, alpha > 1/2; " COARSE);
  measured(q, "in doubles: %d have a boundary, and for %d of these it is the highest point", with_boundary, held);
  settle(q, count > 0 && held == with_boundary, proven);
}

/* Three steady states through the boundary: before it, at it and behind it, 1 % apart */

struct passage {
  struct family family;
  double x[3];
  struct scallop_crawler crawler[3];
  const struct scallop_certified_steady *s[3];
};

static void pass(struct passage *p, struct question *q)
{
  static const char *const what[] = { "F1/F2", "F1 and F2 together,", "T alone," };
  const struct scallop_crawler c = paper_crawler(q);
  under(q, "the paper's crawler, %s from 1 %% below to 1 %% above the boundary", what[varied_by(q)]);
  family_scan(&p->family, &c, varied_by(q), false);
  q->solved = isfinite(p->family.boundary);
  for (int i = 0; i < 3; i++) {
    p->x[i] = q->solved ? short_number(p->family.boundary * (0.99 + 0.01 * i), SHORT) : 1;
    p->crawler[i] = family_member(&p->family, p->x[i]);
    p->s[i] = certified_steady(q, &p->crawler[i]);
  }
  q->solved = q->solved && arb_is_positive(p->s[0]->v_start) && arb_is_negative(p->s[2]->v_start);
}

/* The claim that the middle one of three balls is above its neighbours */
static void settle_peak(struct question *q, arb_srcptr x0, arb_srcptr x1, arb_srcptr x2)
{
  settle(q, arb_gt(x1, x0) && arb_gt(x1, x2), arb_lt(x1, x0) || arb_lt(x1, x2));
}

void v_mid_peaks(struct question *q)
{
  struct passage p;
  double v[3];
  pass(&p, q);
  for (int i = 0; i < 3; i++)
    v[i] = middle(p.s[i]->v_mid) / (p.crawler[i].L / p.crawler[i].T);
  measured(q, "%s: v_start changes its sign; v_mid T/L = %.6f, %.6f, %.6f at %s = %.6g, %.6g, %.6g",
           q->solved ? "certified" : "not proven", v[0], v[1], v[2], family_name(&p.family), p.x[0], p.x[1], p.x[2]);
  reason(q, "v_mid, the last column, is not highest in the second row: ");
  family_command(q, &p.family, p.x, 3, " | cut -f 6,10,11");
  settle_peak(q, p.s[0]->v_mid, p.s[1]->v_mid, p.s[2]->v_mid);
}

void contraction_loses(struct question *q)
{
  struct passage p;
  arb_ptr out[3], back[3];
  pass(&p, q);
  for (int i = 0; i < 3; i++) {
    out[i] = certified_move(q, &p.crawler[i], SCALLOP_EXTENSION, p.s[i]->v_start);
    back[i] = certified_move(q, &p.crawler[i], SCALLOP_CONTRACTION, p.s[i]->v_mid);
  }
  const double L = q->crawler.L;
  measured(q, "%s: dx_C/L of the contraction is %.6f, %.6f, %.6f there; of the extension %.6f, %.6f, %.6f",
           q->solved ? "certified" : "not proven", middle(back[0]) / L, middle(back[1]) / L, middle(back[2]) / L,
           middle(out[0]) / L, middle(out[1]) / L, middle(out[2]) / L);
  reason(q, "dx_C of the contraction at the boundary: ");
  command(q, "scallop phase --phase contraction", &p.crawler[1], " --v0 %.6g | cut -f 16", middle(p.s[1]->v_mid));
  settle_peak(q, back[0], back[1], back[2]);
}
