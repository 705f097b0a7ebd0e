/* What the claims in words are decided with: the row that is being filled, certified solutions, random crawlers, roots and maxima.
 * Needs FLINT. Not public. */
#ifndef SCALLOP_CLAIMS_EVIDENCE_H
#define SCALLOP_CLAIMS_EVIDENCE_H

#include "compare/claims/claims.h"
#include "numerics/certified.h"

enum { EVIDENCE_BITS = 160, EVIDENCE_SLOTS = 8 };

/* One claim in words while it is decided, for one crawler. */
struct question {
  struct scallop_crawler crawler; /* with the gait in question                                        */
  bool of_the_paper;              /* it is the one of the paper's figures                             */
  const char *whose;              /* "the paper's crawler" or "the ledger's crawler"                  */
  const void *with;               /* the parameter that the row of the claim has for its function     */
  struct claim_row row;           /* claim, equation, quantity, gait and inside are set               */
  bool solved;                    /* every certified solution so far                                  */
  /* What the functions below hand out; it lasts as long as the question. */
  struct scallop_certified_phase phase[EVIDENCE_SLOTS];
  struct scallop_certified_steady steady[EVIDENCE_SLOTS];
  arb_struct number[EVIDENCE_SLOTS];
  int phases, steadies, numbers;
};
void question_init(struct question *q);
void question_clear(struct question *q);

/* The texts of the row: conditions, measured and reason, each appended to what is there. */
void under(struct question *q, const char *format, ...) __attribute__((format(printf, 2, 3)));
void measured(struct question *q, const char *format, ...) __attribute__((format(printf, 2, 3)));
void reason(struct question *q, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* A command as reason: before, the options that make the default crawler this one, and the rest. */
void command(struct question *q, const char *before, const struct scallop_crawler *c, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* holds or refuted where one of them is proven (both need every certified solution that was asked for), else undecided */
void settle(struct question *q, bool holds, bool fails);
void settle_by_sign(struct question *q, const arb_t x); /* positive: holds */

/* The paper's crawler with the gait in question */
struct scallop_crawler paper_crawler(const struct question *q);
/* The duration at which the Froude number is 1 */
double natural_time(const struct scallop_crawler *c);

/* In doubles; nan where there is no solution */
struct scallop_steady_result steady_state(const struct scallop_crawler *c);
struct scallop_phase_result extension(const struct scallop_crawler *c, double v0);
/* A displacement in L that is only rounding: a dozen terms of size up to 1, the start velocity known to an ulp. */
#define EVIDENCE_ZERO 1e-14

/* Certified, with 30 digits: parameters are the shortest decimals that read back, v0 is what the double is */
const struct scallop_certified_steady *certified_steady(struct question *q, const struct scallop_crawler *c);
const struct scallop_certified_phase *certified_phase(struct question *q, const struct scallop_crawler *c,
                                                      enum scallop_phase_kind kind, double v0);
/* dx_C of a phase from a start velocity somewhere in the ball v0: it rises with v0, since motions under one l never cross. */
arb_ptr certified_move(struct question *q, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t v0);
/* |l'| and l'' of a phase, in L over its duration (squared), a part of the duration after its start or, from_end, before its end */
void certified_law(arb_t speed, arb_t acceleration, const struct scallop_crawler *c, enum scallop_phase_kind kind,
                   const arb_t part, bool from_end);
/* A new number, 0 */
arb_ptr certified_number(struct question *q);
double middle(const arb_t x);

/* Masses and forces within a factor of 10 of 1, L = 1, 0.05 < alpha < 0.95, eps from 0.01 to 10: a Sobol sequence, the same bits on
 * every machine. Returns count, or 0: out of memory. */
enum { RANDOM_CRAWLERS = 400 };
int random_crawlers(struct scallop_crawler *c, int count, const struct scallop_gait *gait);

typedef double function_of(const void *context, double x);
/* The last double before f, positive at low and not at high, is not positive any more */
double last_positive(function_of *f, const void *context, double low, double high);
/* Where f, with one maximum between a and b, is highest, to 1e-7 of it */
double highest_between(function_of *f, const void *context, double a, double b);

/* The number with so many digits: what a command says */
double short_number(double x, int digits);

#endif
