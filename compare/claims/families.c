/* Statements about families of crawlers that differ in one number. One member has start velocity 0: "the maximum
 * average velocity occurs at the boundary" (sections 4.4 and 5), mean velocity "increases to a maximum and then decays
 * to zero" (section 4.5), and further quantities are claimed to be extreme there. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/claims/decide.h"
#include "compare/points/point_flint.h"
#include "model/golden.h"

enum varied { VARY_RATIO, VARY_FORCES, VARY_PERIOD }; /* F1/F2, by F1; F2, with F1/F2 kept; T */

struct family_point { /* speed: mean velocity in L/T, T of the family's crawler; nan without a steady state */
  double x, speed, v_start;
  bool sliding;
};

enum { MAX_PLACES = 1150, MAX_PEAKS = 6, SHORT_DIGITS = 6 };

struct family {
  struct scallop_crawler crawler;
  enum varied varied;
  int count;
  struct family_point scan[MAX_PLACES]; /* from the smallest x; in doubles */
  /* x at the first zero of v_start; nan: it has no zero. found: v_start is proven to be positive at boundary (1 -
   * 2^-60) and not positive at boundary (1 + 2^-60). before, after: the certified derivative of speed by ln x between
   * (1 - 2^-39) and (1 - 2^-40), and between (1 + 2^-40) and (1 + 2^-39); speed: at (1 + 2^-40) */
  double boundary, before, after, speed;
  bool found;
  int maxima, highest; /* local maxima of speed, proven to be higher than 1 % to either side */
  struct family_point maximum[MAX_PEAKS];
};

/* Words of the conditions; x, speed, and the parameters that vary, as columns and for printf(1) */
static const struct {
  const char *condition, *x, *speed, *columns, *names;
} texts[] = {
  [VARY_RATIO] = { "F1/F2", "F1/F2", "<U> T/L", "F1", "F1\\n" },
  [VARY_FORCES] = { "F1 and F2 together", "F2", "<U> T/L", "F1,F2", "F1\\tF2\\n" },
  [VARY_PERIOD] = { "T alone", "T", "<U> T0/L", "T", "T\\n" },
};

static bool varies(const struct family *f, int place)
{
  return strstr(texts[f->varied].columns, crawler_parameters[place]) != NULL;
}

static struct scallop_crawler member(const struct family *f, double x)
{
  struct scallop_crawler c = f->crawler;
  if (f->varied == VARY_PERIOD)
    c.T = x;
  else if (f->varied == VARY_RATIO)
    c.F1 = x * c.F2;
  else
    c.F1 = x * (c.F1 / c.F2), c.F2 = x;
  return c;
}

/* In doubles */

static struct family_point place_at(const struct family *f, double x)
{
  const struct solved s = solve_steady_state(NULL, member(f, x));
  const double speed = s.mean_velocity * f->crawler.T / f->crawler.L;
  return (struct family_point){ x, speed, s.v_start, isfinite(speed) && s.regime == SCALLOP_SLIDING };
}

static double minus_speed(void *family, double x) { return -place_at(family, x).speed; }

/* F1/F2 to 7838, 1/Froude from 1e-3 to 92 (forces) or 91 */
static void scan(struct family *f)
{
  const struct scallop_crawler *c = &f->crawler;
  const double M_L = 1e-3 * (c->m1 + c->m2) * c->L;
  double x = f->varied == VARY_RATIO    ? 1.01
             : f->varied == VARY_FORCES ? M_L / (c->T * c->T) / (1 + c->F1 / c->F2)
                                        : sqrt(M_L / (c->F1 + c->F2));
  f->count = f->varied == VARY_RATIO ? 900 : f->varied == VARY_FORCES ? MAX_PLACES : MAX_PLACES / 2;
  for (int i = 0; i < f->count; i++, x *= 1.01)
    f->scan[i] = place_at(f, x);
  f->boundary = NAN;
  for (int i = 1; isnan(f->boundary) && i < f->count; i++)
    if (f->scan[i - 1].v_start > 0 && f->scan[i].v_start <= 0) {
      double behind = f->scan[i].x;
      f->boundary = f->scan[i - 1].x;
      for (double mid; halfway(&mid, f->boundary, behind);)
        *(place_at(f, mid).v_start > 0 ? &f->boundary : &behind) = mid;
    }
}

/* Certified */

static double velocity(struct question *q, const struct family *f, double x)
{
  return solve_steady_state(q, member(f, x)).mean_velocity;
}

static void find_maxima(struct family *f, struct question *q)
{
  for (int i = 1; i + 1 < f->count && f->maxima < MAX_PEAKS; i++) {
    if (!(f->scan[i].speed > f->scan[i - 1].speed && f->scan[i].speed > f->scan[i + 1].speed))
      continue;
    const double low = f->scan[i - 1].x, high = f->scan[i + 1].x;
    const struct family_point at = place_at(f, golden_least(minus_speed, f, low, high, 1e-7 * low));
    const double v = velocity(q, f, at.x);
    if (compare(v, velocity(q, f, 0.99 * at.x)) <= 0 || compare(v, velocity(q, f, 1.01 * at.x)) <= 0)
      continue;
    if (at.speed > f->maximum[f->highest].speed)
      f->highest = f->maxima;
    f->maximum[f->maxima++] = at;
  }
}

/* Solves the steady state of the member at boundary root (1 + side 2^-bits). */
static bool solve_beside(struct ball_answer *a, const struct family *f, const fmpq_t root, slong side, ulong bits)
{
  const struct scallop_crawler at = member(f, f->boundary);
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, factor);
  fmpq_set_si(factor, side, 1);
  fmpq_div_2exp(factor, factor, bits);
  fmpq_add_si(factor, factor, 1);
  fmpq_mul(factor, factor, root);
  rational_crawler(&c, &at);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (varies(f, i))
      fmpq_mul(rational_field(&c, i), rational_field(&c, i), factor);
  return answer_in_balls(a, &c, OF_STEADY, SCALLOP_EXTENSION, NULL, EVIDENCE_DIGITS);
}

/* Sets slope to d speed/d ln x on one side of the root, between the members 2^-39 and 2^-40 from it. */
static bool slope_beside(double *slope, struct ball_answer *far, struct ball_answer *near, const struct family *f,
                         const fmpq_t root, slong side)
{
  SCOPED(arb, rise);
  if (!solve_beside(far, f, root, side, 39) || !solve_beside(near, f, root, side, 40))
    return false;
  arb_sub(rise, far->value[Q_MEAN_VELOCITY], near->value[Q_MEAN_VELOCITY], EVIDENCE_BITS);
  arb_mul_2exp_si(rise, rise, 40);
  *slope = round_certified(rise) * (double)side * f->crawler.T / f->crawler.L;
  return true;
}

/* Refines the boundary in doubles, by the zero of the line through the two members before it, and proves it. */
static void prove_boundary(struct family *f)
{
  SCOPED(ball_answer, far, near);
  SCOPED(fmpq, root, step);
  fmpq_one(root);
  if (isnan(f->boundary) || !slope_beside(&f->before, &far, &near, f, root, -1))
    return;
  const double v_far = round_certified(far.value[Q_V_START]), v_near = round_certified(near.value[Q_V_START]);
  scallop_rational_set_double(step, v_near / (v_far - v_near) - 1);
  fmpq_div_2exp(step, step, 40);
  fmpq_add(root, root, step);
  if (!slope_beside(&f->after, &far, &near, f, root, 1))
    return;
  f->speed = round_certified(near.value[Q_MEAN_VELOCITY]) * f->crawler.T / f->crawler.L;
  f->found = solve_beside(&far, f, root, -1, 60) && arb_is_positive(far.value[Q_V_START])
             && solve_beside(&near, f, root, 1, 60) && arb_is_nonpositive(near.value[Q_V_START]);
}

/* Returns the family of a row. Later rows need it again: the last family of each kind is kept. */
static const struct family *survey(struct question *q, struct scallop_crawler c)
{
  static struct family kept[VARY_PERIOD + 1];
  enum varied varied = VARY_RATIO;
  while (!strstr(q->claim->conditions, texts[varied].condition))
    varied++;
  struct family *f = &kept[varied];
  if (f->count == 0 || !same_crawler(&f->crawler, &c)) {
    *f = (struct family){ .crawler = c, .varied = varied, .before = NAN, .after = NAN };
    scan(f);
    find_maxima(f, q);
    prove_boundary(f);
    q->solved = true;
  }
  return f;
}

/* Speeds are in L/T0 if T varies. */
static const char *unit_of_speed(const struct family *f)
{
  static char text[32];
  snprintf(text, sizeof text, "; T0 = %.6g", f->crawler.T);
  return f->varied == VARY_PERIOD ? text : "";
}

/* Shows a command that prints the members at x; does nothing without a boundary. */
static void show_members(struct question *q, const struct family *f, const double *x, int count, const char *what,
                         const char *quantities)
{
  const struct scallop_crawler usual = scallop_crawler_default();
  struct scallop_crawler others = f->crawler;
  char rows[240] = "";
  if (isnan(x[0]))
    return;
  for (int k = 0; k < count; k++)
    for (int i = 0, cells = 0; i < CRAWLER_NUMBERS; i++)
      if (varies(f, i)) {
        const struct scallop_crawler c = member(f, x[k]);
        *crawler_field(&others, i) = crawler_number(&usual, i);
        append(rows, sizeof rows, "%s%.10g", cells++ > 0 ? "\\t" : k > 0 ? "\\n" : "", crawler_number(&c, i));
      }
  show(q, "%s: printf '%s%s\\n' | scallop steady --points -%s --columns %s,%s", what, texts[f->varied].names, rows,
       write_options(q, others), texts[f->varied].columns, quantities);
}

/* Statements */

static void changes_sign(struct question *q, struct scallop_crawler c)
{
  const struct family *f = survey(q, c);
  q->solved = f->found;
  conclude(q, 1, "certified: v_start > 0 at %s = %.10g (1 - 2^-60) and not at (1 + 2^-60)", texts[f->varied].x,
           f->boundary);
  show(q, "no change of sign was proven");
}

/* Proven: mean velocity rises up to the boundary and falls beyond it; no higher value is in the scan. Refuted: it is
 * higher on the highest peak, or at the first point. */
static void peaks_at_boundary(struct question *q, struct scallop_crawler c)
{
  const struct family *f = survey(q, c);
  const char *speed = texts[f->varied].speed;
  const struct family_point *peak = &f->maximum[f->highest];
  const struct family_point top = f->maxima > 0 && peak->speed > f->scan[0].speed ? *peak : f->scan[0];
  const double x[] = { short_number(f->boundary, SHORT_DIGITS), short_number(top.x, SHORT_DIGITS) };
  const bool peaks = f->maxima > 0 && fabs(peak->x / f->boundary - 1) < 1e-5;
  const bool proven = f->found && f->before > 0 && f->after < 0 && peaks;
  q->by = proven ? MEASURED : CERTIFIED_CRAWLER; /* by the scan */
  conclude(q, proven ? 1 : -(compare(velocity(q, f, x[1]), velocity(q, f, x[0])) > 0),
           "at %s = %.10g the certified slope d(%s)/d ln is %.6f before, %.6f after; %s is %.6f there, highest %.6f at "
           "%s = %.4g%s",
           texts[f->varied].x, f->boundary, speed, f->before, f->after, speed, f->speed, top.speed, texts[f->varied].x,
           top.x, unit_of_speed(f));
  show_members(q, f, x, 2, "mean_velocity is lower at the boundary, the first row", "mean_velocity");
}

/* Refuted by several maxima: the last two are shown, with the lowest place between them. */
static void has_one_maximum(struct question *q, struct scallop_crawler c)
{
  const struct family *f = survey(q, c);
  char list[MAX_PEAKS * 32] = "";
  for (int i = 0; i < f->maxima; i++)
    append(list, sizeof list, "%s %.6f at %.4g", i > 0 ? "," : "", f->maximum[i].speed, f->maximum[i].x);
  conclude(q, f->maxima == 1 ? 1 : -(f->maxima > 1), "certified maxima of <U> T/L: %d;%s", f->maxima, list);
  if (f->maxima < 2)
    return;
  const double first = f->maximum[f->maxima - 2].x, second = f->maximum[f->maxima - 1].x;
  struct family_point low = { .speed = INFINITY };
  for (int i = 0; i < f->count; i++)
    if (f->scan[i].x > first && f->scan[i].x < second && f->scan[i].speed < low.speed)
      low = f->scan[i];
  const double x[] = { short_number(first, SHORT_DIGITS), short_number(low.x, SHORT_DIGITS),
                       short_number(second, SHORT_DIGITS) };
  show_members(q, f, x, 3, "mean_velocity falls and rises again", "mean_velocity");
}

/* Finds the two places beyond the onset of sticking between which mean velocity rises most; false: it never rises. */
static bool largest_rise(const struct family *f, double x[2])
{
  int i = 0;
  double most = 0;
  while (i < f->count && f->scan[i].sliding)
    i++;
  for (const struct family_point *at = &f->scan[i], *low = at; at < f->scan + f->count; at++) {
    low = at->speed < low->speed ? at : low;
    if (at->speed - low->speed > most) {
      most = at->speed - low->speed;
      x[0] = short_number(low->x, SHORT_DIGITS);
      x[1] = short_number(at->x, SHORT_DIGITS);
    }
  }
  return most > 0;
}

static void decays_once_sticking(struct question *q, struct scallop_crawler c)
{
  const struct family *f = survey(q, c);
  const double unit = c.L / c.T;
  double x[2] = { 0 };
  if (!largest_rise(f, x)) {
    q->by = MEASURED;
    conclude(q, 1, "it never rises between neighbours");
    return;
  }
  const double low = velocity(q, f, x[0]), high = velocity(q, f, x[1]);
  conclude(q, -(compare(high, low) > 0), "certified: %s rises from %.6f at %s = %.6g to %.6f at %.6g%s",
           texts[f->varied].speed, low / unit, texts[f->varied].x, x[0], high / unit, x[1], unit_of_speed(f));
  show_members(q, f, x, 2, "mean_velocity rises, in stick-slip", "mean_velocity");
}

/* Solves members before the boundary, at it and beyond it, 1 % apart. True: v_start changes its sign. */
static bool pass_boundary(struct question *q, const struct family *f, double x[3], struct solved s[3])
{
  for (int i = 0; i < 3; i++) {
    x[i] = short_number(f->boundary * (0.99 + 0.01 * i), SHORT_DIGITS);
    s[i] = solve_steady_state(q, member(f, x[i]));
  }
  return s[0].v_start > 0 && s[2].v_start < 0;
}

void v_mid_peaks(struct question *q, struct scallop_crawler c)
{
  const struct family *f = survey(q, c);
  struct solved s[3];
  double x[3], v[3];
  bool crosses = pass_boundary(q, f, x, s);
  for (int i = 0; i < 3; i++)
    v[i] = s[i].v_mid * member(f, x[i]).T / c.L;
  conclude(q, crosses ? compare(v[1], fmax(v[0], v[2])) : 0,
           "certified: v_start changes its sign; v_mid T/L = %.6f, %.6f, %.6f at %s = %.6g, %.6g, %.6g", v[0], v[1],
           v[2], texts[f->varied].x, x[0], x[1], x[2]);
  show_members(q, f, x, 3, "v_mid, the last column, is not highest in the second row", "v_start,v_mid");
}

void contraction_loses_least(struct question *q, struct scallop_crawler c)
{
  const struct family *f = survey(q, c);
  struct solved s[3];
  double x[3], forth[3], back[3];
  bool crosses = pass_boundary(q, f, x, s);
  for (int i = 0; i < 3; i++) {
    forth[i] = solve_extension(q, member(f, x[i]), s[i].v_start).dxC / c.L;
    back[i] = solve_contraction(q, member(f, x[i]), s[i].v_mid).dxC / c.L;
  }
  conclude(q, crosses ? compare(back[1], fmax(back[0], back[2])) : 0,
           "certified: dxC/L of the contraction is %.6f, %.6f, %.6f there; of the extension %.6f, %.6f, %.6f", back[0],
           back[1], back[2], forth[0], forth[1], forth[2]);
  if (!isnan(f->boundary))
    show(q, "dxC of the contraction at the boundary: scallop phase --phase contraction%s --v0 %.6g --columns dxC",
         write_options(q, member(f, x[1])), s[1].v_mid);
}

#define BY_RATIO "%s; F1/F2 from 1.01 to 7838 by 1 %%"
#define BY_FORCES "%s; F1 and F2 together, 1/Froude from 1e-3 to 92 by 1 %%"
#define BY_PERIOD "%s; T alone, 1/Froude from 1e-3 to 91 by 2 %%"
static const char changes[] = "start_velocity_changes_sign", peaks[] = "mean_velocity_peaks_where_v_start_is_0";
static const char decays[] = "mean_velocity_decays_once_sticking_begins", speed[] = "mean velocity";

/* The paper claims a decay without restriction to sliding for F1/F2 alone. */
const struct statement statements_of_families[] = {
  { changes, "4.4", "v_start", BY_RATIO, .test = changes_sign },
  { peaks, "4.4", speed, BY_RATIO, .test = peaks_at_boundary },
  { "mean_velocity_has_one_maximum", "4.5", speed, BY_RATIO ": \"increases to a maximum and then decays to zero\"",
    .test = has_one_maximum },
  { decays, "4.5", speed, BY_RATIO ", where a body sticks: \"then decays to zero as the asymmetry increases\"",
    .test = decays_once_sticking },
  { changes, "4.4", "v_start", BY_FORCES, .test = changes_sign },
  { peaks, "4.4", speed, BY_FORCES, .test = peaks_at_boundary },
  { decays, "4.5", speed, BY_FORCES ", where a body sticks", .test = decays_once_sticking, .outside = true },
  { changes, "4.4", "v_start", BY_PERIOD, .test = changes_sign },
  { peaks, "4.4", speed, BY_PERIOD, .test = peaks_at_boundary },
  { decays, "4.5", speed, BY_PERIOD ", where a body sticks", .test = decays_once_sticking, .outside = true },
  { .name = NULL },
};
