/* The steady state in words: for which alpha the published velocity is right, whether there is one steady state, and when it is
 * reached; and a single phase against its duration. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/claims/words.h"
#include "numerics/numerics.h"
#include "compare/answers/rational.h"
#include "numerics/certified.h"

enum { MEASURED = 200, REASON = 320, BITS = 160, DIGITS = 30 };

static const char *gait_option(const struct words *w)
{
  return w->crawler.gait == &scallop_gait_quadratic ? "" : " --gait sinusoidal";
}

static double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

/* ---- (27): v_start T -> (F1-F2)(2 alpha-1) L_kin m* / (alpha^2 F1 m1 + (1-alpha)^2 F2 m2) ---- */

/* alpha^2 a + (1-alpha)^2 b */
static void weighted(fmpq_t sum, const fmpq_t alpha, const fmpq_t a, const fmpq_t b)
{
  fmpq_t square;
  fmpq_init(square);
  fmpq_set_si(sum, 1, 1);
  fmpq_sub(sum, sum, alpha);
  fmpq_mul(sum, sum, sum);
  fmpq_mul(sum, sum, b);
  fmpq_mul(square, alpha, alpha);
  fmpq_mul(square, square, a);
  fmpq_add(sum, sum, square);
  fmpq_clear(square);
}

/* Where (27) is positive what it says of the quadratic gait; mirrored: with F2 m2 and F1 m1 exchanged below the line */
static void published_velocity(fmpq_t u, const struct scallop_rational_crawler *c, bool mirrored)
{
  fmpq_t first, second, below;
  fmpq_init(first);
  fmpq_init(second);
  fmpq_init(below);
  fmpq_mul(first, c->F1, c->m1);
  fmpq_mul(second, c->F2, c->m2);
  weighted(below, c->alpha, mirrored ? second : first, mirrored ? first : second);
  fmpq_add(first, c->m1, c->m2);
  fmpq_mul(below, below, first);
  fmpq_mul(below, below, c->T);
  fmpq_sub(u, c->F1, c->F2);
  fmpq_mul(u, u, c->L);
  fmpq_mul(u, u, c->m1);
  fmpq_mul(u, u, c->m2);
  fmpq_mul_si(first, c->alpha, 2);
  fmpq_sub_si(first, first, 1);
  fmpq_mul(u, u, first);
  fmpq_div(u, u, below);
  fmpq_clear(first);
  fmpq_clear(second);
  fmpq_clear(below);
}

/* (27) over the certified v_start at T = 1e-20, minus 1; NAN if there is none */
static double relative_error(const struct scallop_crawler *crawler, int alpha_hundredths, bool mirrored)
{
  struct scallop_rational_crawler c;
  struct scallop_certified_steady s;
  double error = NAN;
  arb_t u;
  fmpq_t q;
  arb_init(u);
  fmpq_init(q);
  scallop_rational_init(&c);
  scallop_certified_steady_init(&s);
  rational_crawler(&c, crawler);
  fmpq_set_si(c.alpha, alpha_hundredths, 100);
  scallop_rational_parse(c.T, "1e-20");
  if (scallop_certified_steady(&c, DIGITS, &s, NULL) == SCALLOP_OK) {
    published_velocity(q, &c, mirrored);
    arb_set_fmpq(u, q, BITS);
    if (crawler->gait != &scallop_gait_quadratic) { /* L_kin = pi^2 L/8 */
      arb_t pi;
      arb_init(pi);
      arb_const_pi(pi, BITS);
      arb_mul(pi, pi, pi, BITS);
      arb_mul_2exp_si(pi, pi, -3);
      arb_mul(u, u, pi, BITS);
      arb_clear(pi);
    }
    arb_div(u, u, s.v_start, BITS);
    arb_sub_ui(u, u, 1, BITS);
    error = middle(u);
  }
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&c);
  arb_clear(u);
  fmpq_clear(q);
  return error;
}

enum { LONGER_EXTENSION, LONGER_CONTRACTION, MIRRORED };

static void alpha_row(const struct words *w, const struct words_claim *claim)
{
  bool mirrored = claim->which == MIRRORED, longer = claim->which == LONGER_EXTENSION;
  int first = longer ? 51 : 1, last = longer ? 99 : 49, example = longer ? 75 : 25;
  char conditions[120], measured[MEASURED], reason[REASON];
  double worst = 0;
  int at = first;
  for (int i = first; i <= last; i += 8) {
    double error = relative_error(&w->crawler, i, mirrored);
    if (!(fabs(error) <= fabs(worst))) {
      worst = error;
      at = i;
    }
  }
  bool holds = fabs(worst) < 1e-15;
  snprintf(conditions, sizeof conditions, "%s, T = 1e-20, alpha from %.2f to %.2f by 0.08%s", words_whose(w), first / 100.,
           last / 100., mirrored ? "; with F1 m1 and F2 m2 exchanged below the line" : "");
  if (holds)
    snprintf(measured, sizeof measured, "relative error, certified: below 1e-15 throughout");
  else
    snprintf(measured, sizeof measured, "relative error, certified: %.6f at alpha = %.2f, largest %.6f at alpha = %.2f",
             relative_error(&w->crawler, example, mirrored), example / 100., worst, at / 100.);
  snprintf(reason, sizeof reason,
           "published against exact: scallop series --T 1e-6 --alpha %.2f%s | grep '^text_steady_velocity.(27)'",
           example / 100., gait_option(w));
  words_enter(w, claim, conditions, longer, words_verdict(holds, isfinite(worst)), measured,
              w->of_the_paper ? reason : NULL);
}

/* ---- when is the steady state reached? ---- */

/* Periods from rest until the velocity is within 1e-6 L/T of the steady one and, with *same, until it is the same; 0: not in 1000 */
static int periods_until(const struct scallop_crawler *c, bool same)
{
  struct scallop_period_result p = { .v_end = 0 };
  double v = words_steady(c).period.v_start, before = NAN;
  for (int n = 1; n <= 1000; n++) {
    before = p.v_end;
    if (scallop_period(c, before, &p) < 0)
      return 0;
    if (same ? p.v_end == before : fabs(p.v_end - v) <= 1e-6 * c->L / c->T)
      return same ? n - 1 : n;
  }
  return 0;
}

/* The certified multiplier; false: there is none. *zero: it is exactly 0. */
static bool proven_multiplier(const struct scallop_crawler *crawler, double *multiplier, bool *zero)
{
  struct scallop_rational_crawler c;
  struct scallop_certified_steady s;
  scallop_rational_init(&c);
  scallop_certified_steady_init(&s);
  rational_crawler(&c, crawler);
  bool solved = scallop_certified_steady(&c, DIGITS, &s, NULL) == SCALLOP_OK;
  *multiplier = middle(s.multiplier);
  *zero = arb_is_zero(s.multiplier);
  solved = solved && (*zero || arb_is_positive(s.multiplier));
  scallop_certified_steady_clear(&s);
  scallop_rational_clear(&c);
  return solved;
}

/* which: T */
static void reached_row(const struct words *w, const struct words_claim *claim)
{
  double T = claim->which;
  char conditions[120], measured[MEASURED], reason[REASON];
  struct scallop_crawler c = w->crawler;
  double multiplier;
  bool zero;
  c.T = T;
  bool proven = proven_multiplier(&c, &multiplier, &zero);
  if (!proven)
    snprintf(measured, sizeof measured, "not proven");
  else if (zero)
    snprintf(measured, sizeof measured, "certified multiplier 0; from rest the velocity is the steady one after %d period",
             periods_until(&c, true));
  else
    snprintf(measured, sizeof measured,
             "certified multiplier %.10f > 0: the distance shrinks by that and is never 0; within 1e-6 L/T after %d periods",
             multiplier, periods_until(&c, false));
  snprintf(conditions, sizeof conditions, "the paper's crawler, T = %g, from rest; read as: after finitely many periods", T);
  snprintf(reason, sizeof reason, "the multiplier is not 0: scallop steady --certified --T %g%s | cut -f 14", T,
           gait_option(w));
  words_enter(w, claim, conditions, true, words_verdict(proven && zero, proven), measured, reason);
}

/* ---- one steady state, or many? ---- */

static void unique_row(const struct words *w, const struct words_claim *claim)
{
  enum { CRAWLERS = 400 };
  char measured[MEASURED];
  int single = 0;
  gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  for (int i = 0; q && i < CRAWLERS; i++) {
    struct scallop_crawler c = words_random(q, w->crawler.gait);
    struct scallop_steady_result r;
    single += scallop_steady(&c, &r) == SCALLOP_OK && r.v_low == r.v_high;
  }
  if (q)
    gsl_qrng_free(q);
  snprintf(measured, sizeof measured,
           "proven for continuous l' (docs/theory.md, How many steady states); the solver finds one for %d of 400 "
           "quasi-random crawlers",
           single);
  words_enter(w, claim, "l' continuous, any masses, forces > 0 and alpha", true, words_verdict(single == CRAWLERS, true),
              measured, NULL);
}

static const struct scallop_piece out[] = {
  { .begin = 0, .end = 1, .direction = 1, .jump = true, .linear = true, .velocity = 1, .curve = &scallop_curve_linear }
};
static const struct scallop_piece back[] = {
  { .begin = 0, .end = 1, .direction = -1, .jump = true, .linear = true, .velocity = -1, .curve = &scallop_curve_linear }
};
static const struct scallop_gait sawtooth = {
  "sawtooth", { { out, 1, 0, 0, 1, 1, false, false }, { back, 1, 0, 0, 1, -1, false, false } }
};

static void jumps_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct words of = *w;
  struct scallop_steady_result r;
  of.crawler = scallop_crawler_default();
  of.crawler.alpha = 0.5;
  of.crawler.gait = &sawtooth;
  bool many = scallop_steady(&of.crawler, &r) == SCALLOP_INTERVAL;
  double unit = of.crawler.L / of.crawler.T;
  snprintf(measured, sizeof measured, "every v_start T/L from %.6f to %.6f is steady", r.v_low / unit, r.v_high / unit);
  snprintf(reason, sizeof reason,
           "by hand: while |x_C'| < L/T the bodies move oppositely throughout; x_C' gains (F1-F2)T/(2M) = 0.75 in the "
           "extension and loses it again");
  words_enter(&of, claim, "l' constant out and back, with jumps; alpha = 1/2, else the paper's crawler", false,
              words_verdict(!many, true), measured, reason);
}

/* ---- one extension from a start velocity, against its duration ---- */

static double moved(const struct words *w, double F1, double v0, double T)
{
  struct scallop_crawler c = w->crawler;
  struct scallop_phase_result r;
  c.F1 = F1;
  c.T = T;
  return scallop_phase(&c, SCALLOP_EXTENSION, v0, &r) < 0 ? NAN : r.dxC / c.L;
}

static bool certainly_less(const struct words *w, double F1, double v0, double T, double longer)
{
  struct scallop_rational_crawler c;
  struct scallop_certified_phase p[2];
  struct scallop_crawler crawler = w->crawler;
  fmpq_t v;
  bool solved = true;
  fmpq_init(v);
  scallop_rational_set_double(v, v0);
  crawler.F1 = F1;
  scallop_rational_init(&c);
  for (int i = 0; i < 2; i++) {
    scallop_certified_phase_init(&p[i]);
    crawler.T = i ? longer : T;
    rational_crawler(&c, &crawler);
    solved = scallop_certified_phase(&c, SCALLOP_EXTENSION, v, DIGITS, &p[i], NULL) == SCALLOP_OK && solved;
  }
  bool less = solved && arb_lt(p[1].dxC, p[0].dxC);
  for (int i = 0; i < 2; i++)
    scallop_certified_phase_clear(&p[i]);
  scallop_rational_clear(&c);
  fmpq_clear(v);
  return less;
}

struct fall {
  double F1, v0, T, longer, size;
};

/* The largest fall of the displacement between two durations, T from 0.05 on by 2 % */
static void largest_fall(struct fall *worst, const struct words *w, double F1, double v0)
{
  enum { DURATIONS = 260 };
  double T = 0.05, most = -INFINITY, at = T;
  for (int i = 0; i < DURATIONS; i++, T *= 1.02) {
    double x = moved(w, F1, v0, T);
    if (most - x > worst->size)
      *worst = (struct fall){ F1, v0, at, T, most - x };
    if (x > most) {
      most = x;
      at = T;
    }
  }
}

static double short_duration(double T)
{
  char text[40];
  snprintf(text, sizeof text, "%.4g", T);
  return strtod(text, NULL);
}

enum { STRONGER_REAR, WEAKER_REAR };

static void from_velocity_row(const struct words *w, const struct words_claim *claim)
{
  static const struct {
    double forces[4];
    int count;
    const char *text;
  } over[] = { { { 2, 4, 10, 40 }, 4, "F1/F2 = 2, 4, 10, 40" }, { { 0.25, 0.5 }, 2, "F1/F2 = 1/4, 1/2" } };
  static const double velocities[] = { 0.5, 1, 2, 5, 10, 20 };
  char conditions[120], measured[MEASURED] = "it never falls by more than 1e-14 L", reason[REASON] = "";
  struct fall worst = { .size = 1e-14 };
  for (int i = 0; i < over[claim->which].count; i++)
    for (size_t j = 0; j < sizeof velocities / sizeof *velocities; j++)
      largest_fall(&worst, w, over[claim->which].forces[i], velocities[j]);
  bool falls = worst.F1 > 0, proven = false;
  if (falls) {
    double T = short_duration(worst.T), longer = short_duration(worst.longer);
    proven = certainly_less(w, worst.F1, worst.v0, T, longer);
    snprintf(
        measured, sizeof measured,
        "%s: from v0 = %g at F1 = %g dx_C/L is %.6f for T = %.4g and %.6f for T = %.4g; these extensions last %.6g and %.6g",
        proven ? "certified" : "not proven", worst.v0, worst.F1, moved(w, worst.F1, worst.v0, T), T,
        moved(w, worst.F1, worst.v0, longer), longer, T * w->crawler.alpha, longer * w->crawler.alpha);
    snprintf(reason, sizeof reason,
             "dxC falls from the first row to the second: printf 'T\\n%.4g\\n%.4g\\n' | scallop phase --points - --F1 %g "
             "--v0 %g%s | cut -f 6,16",
             T, longer, worst.F1, worst.v0, gait_option(w));
  }
  snprintf(conditions, sizeof conditions,
           "the paper's crawler, %s, from v0 = 0.5, 1, 2, 5, 10, 20; T from 0.05 to 8.4 by 2 %%", over[claim->which].text);
  words_enter(w, claim, conditions, false, words_verdict(!falls, proven), measured, reason);
}

/* From rest the displacement grows in the direction of F1 - F2, proven in docs/theory.md: here at random, past sticking too. */
static void from_rest_row(const struct words *w, const struct words_claim *claim)
{
  enum { CRAWLERS = 100, DURATIONS = 150 };
  char measured[MEASURED];
  int fell = 0;
  gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  for (int i = 0; q && i < CRAWLERS; i++) {
    struct words one = *w;
    one.crawler = words_random(q, w->crawler.gait);
    double T = 0.01 * words_natural_time(&one.crawler), before = -INFINITY;
    bool falls = false;
    for (int j = 0; j < DURATIONS; j++, T *= 1.05) {
      double x = moved(&one, one.crawler.F1, 0, T) * (one.crawler.F1 > one.crawler.F2 ? 1 : -1);
      falls = falls || !(x >= before - 1e-14);
      before = x;
    }
    fell += falls;
  }
  if (q)
    gsl_qrng_free(q);
  snprintf(measured, sizeof measured,
           "proven (docs/theory.md, One extension against its duration); of 100 quasi-random crawlers and 150 durations "
           "each it falls for %d",
           fell);
  words_enter(w, claim, "from rest, any masses, forces and duration; in the direction of F1 - F2", true,
              words_verdict(q && fell == 0, true), measured, NULL);
}

static const char limit[] = "text_steady_velocity_in_the_limit", grows[] = "displacement_grows_with_duration";

const struct words_claim words_of_steady_states[] = {
  { "steady_state_is_unique", "5", "v_start", WORDS_ONCE, jumps_row, 0 },
  { limit, "(27)", "v_start", WORDS_EACH_CRAWLER, alpha_row, LONGER_EXTENSION },
  { limit, "(27)", "v_start", WORDS_EACH_CRAWLER, alpha_row, LONGER_CONTRACTION },
  { "text_steady_velocity_mirrored_in_the_limit", "(27)", "v_start", WORDS_OF_THE_PAPER, alpha_row, MIRRORED },
  { grows, "4.4", "dx_C", WORDS_OF_THE_PAPER, from_velocity_row, STRONGER_REAR },
  { grows, "4.4", "dx_C", WORDS_OF_THE_PAPER, from_velocity_row, WEAKER_REAR },
  { grows, "4.4", "dx_C", WORDS_OF_THE_PAPER, from_rest_row, 0 },
  { "steady_state_is_unique", "5", "v_start", WORDS_OF_THE_PAPER, unique_row, 0 },
  { "steady_state_is_reached", "5", "v", WORDS_OF_THE_PAPER, reached_row, 2 },
  { "steady_state_is_reached", "5", "v", WORDS_OF_THE_PAPER, reached_row, 4 },
  { .claim = NULL }
};
