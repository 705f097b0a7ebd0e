/* How a claim about an order is decided: the motion is expanded as T -> 0 and sampled, and what a formula leaves out of
 * that is a row of the ledger. Needs FLINT. Not public. */
#ifndef SCALLOP_COMPARE_CLAIMS_ORDERS_H
#define SCALLOP_COMPARE_CLAIMS_ORDERS_H

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/scoped.h"
#include "compare/answers/answer_flint.h"
#include "compare/claims/claims.h"

/* Under which a formula is tested */
struct condition {
  enum scallop_setting setting;
  enum scallop_phase_kind kind;
  const char *text;
  bool inside;                                 /* assumed by the paper                                */
  double v0;                                   /* in units of sqrt(L (F1 + F2)/M)                     */
  bool exchange_forces, mirror_alpha, light_1; /* m1 a hundredth                                      */
  bool equal_forces;                           /* F2 = F1                                             */
  bool reversed;                               /* the bodies exchange their roles against the paper   */
  /* In place of a motion l' and l before the end of an extension, T = L = 1, at the time T before that: REAR_AT_END is
   * l', and FRONT_AT_END l. What holds for one crawler holds for all. */
  bool at_end;
};

/* The crawler under one condition (trial.c); mirrored: seen in a mirror, the bodies exchanged, so that a reversed
 * motion becomes one that the paper's formulas are for. */
struct trial {
  const struct condition *condition;
  bool mirrored;
  fmpq_t v0;
  struct scallop_rational_crawler crawler; /* T is not used                                         */
  struct series_answer series;             /* status: whether the motion has an expansion in powers of T     */
  slong terms;
  struct sample *samples;
};
void trial_init(struct trial *m);
void trial_clear(struct trial *m);
/* Expands the motion, and samples it. */
void trial_begin(struct trial *m, const struct scallop_rational_crawler *crawler, const struct condition *condition,
                 bool mirrored);
bool trial_expand(struct trial *m, slong terms);
bool trial_is_steady(const struct trial *m);
/* The expansion of a quantity, NULL: it has none. Of a formula without a text its leading term */
const struct series *trial_series(const struct trial *m, enum scallop_quantity quantity);
slong trial_leading_power(const struct scallop_formula *formula);
/* The certified error of the formula at every T where the motion has the modes of the limit: points and count of the
 * row. Returns how far left_out, the derived expansion minus the formula, summed, is from that error, over the latter,
 * at the smallest T where it has digits; nan: there is none. */
double trial_measure(struct claim_row *row, const struct trial *m, const struct scallop_formula *formula,
                     const struct series *left_out);

struct claim_row row_of_formula(const struct scallop_formula *f, const struct scallop_gait *gait,
                                const struct condition *condition);
/* Adds the row (proof.c), with the verdict from what the formula leaves out of the motion. why: nothing can be said of
 * that, for this reason, "" where none is known; or NULL. */
void ledger_decide(struct ledger *ledger, struct claim_row *row, struct trial *m, const struct scallop_formula *formula,
                   const char *why);
/* Behind what the text holds, as far as there is room */
void append(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Notes what cannot be. */
void ledger_contradict(struct ledger *ledger, const struct claim_row *row, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
