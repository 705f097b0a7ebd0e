/* What the ledger knows about one motion: its expansion as T -> 0, and certified samples of it as T falls. */
#ifndef SCALLOP_LEDGER_H
#define SCALLOP_LEDGER_H

#include "asymptotics/derived.h"
#include "asymptotics/evaluate.h"
#include "compare/order/order.h"

/* T = T0 4^-k: T0 is the duration at which the Froude number is 1, or less where masses or forces are far apart; the last T is
 * below 1e-20 T0. */
enum { LEDGER_SAMPLES = 35, LEDGER_IDENTITIES = 3, LEDGER_NUMBERS = 32 };

struct condition {
  const char *text;
  bool inside;
  double v0;                                   /* in units of sqrt(L (F1 + F2)/M)                     */
  bool exchange_forces, mirror_alpha, light_1; /* m1 a hundredth                                      */
  bool equal_forces;                           /* F2 = F1                                             */
  bool reversed;                               /* the bodies exchange their roles against the paper   */
};

/* One crawler's expansion, with what the formulas need */
struct ledger_motion {
  struct scallop_rational_crawler crawler;
  fmpq_t v0, pi_squared;
  bool has_pi_squared; /* a random number in place of pi^2                                            */
  slong terms;
  struct scallop_phase_expansion phase;
  struct scallop_steady_expansion steady;
};

/* One setting, kind of phase, gait and condition; mirrored: seen in a mirror, the bodies exchanged, so that a reversed
 * motion becomes one that the paper's formulas are for. */
struct ledger_case {
  enum scallop_setting setting; /* SCALLOP_MOVING_EXTENSION stands for any phase with a start velocity */
  enum scallop_phase_kind kind;
  const struct condition *condition;
  bool mirrored;
  struct scallop_rational_crawler crawler; /* T is not used                                       */
  fmpq_t v0;
  struct ledger_motion *motion; /* of the crawler                                                      */
  /* of random crawlers with the same modes, with exact coefficients; NULL where there is none */
  struct ledger_motion *others[LEDGER_IDENTITIES];
  /* of the crawler, with the numbers 1, 2, ... in the place of pi^2; NULL where pi does not come in */
  struct ledger_motion *numbers[LEDGER_NUMBERS];
  struct ledger_sample *samples; /* LEDGER_SAMPLES of them, from the largest T                         */
};

enum scallop_status ledger_case_init(struct ledger_case *c, const struct scallop_rational_crawler *crawler,
                                     enum scallop_setting setting, enum scallop_phase_kind kind,
                                     const struct condition *condition, bool mirrored);
void ledger_case_clear(struct ledger_case *c);

/* The modes for T -> 0, as in "++ -+ ++ | ++ +- ++". */
const char *ledger_case_modes(const struct ledger_case *c);

/* What a formula leaves out: the derived expansion minus the formula. */
struct ledger_proof {
  bool found;  /* false: every coefficient below T^known vanishes                                    */
  slong order; /* of the first coefficient that does not                                             */
  slong known;
  slong general;             /* that order for random crawlers; order where there are none                        */
  int confirmed;             /* random crawlers that were looked at                                            */
  struct series coefficient; /* a constant                                                            */
  bool undecided;            /* a ball that holds 0 came before                                                  */
};
void ledger_proof_init(struct ledger_proof *p);
void ledger_proof_clear(struct ledger_proof *p);
/* formula NULL: the quantity itself, against 0 or, with limit, against its own leading term. */
bool ledger_prove(struct ledger_proof *proof, const struct ledger_case *c, const struct scallop_formula *formula,
                  enum scallop_quantity quantity, bool limit);

/* The certified error of the formula at every T where the motion has the modes of the limit: points[count], and the order
 * between the two smallest T (nan if there are not two, or the error is 0). */
int ledger_measure(struct order_point points[LEDGER_SAMPLES], double *slope, const struct ledger_case *c,
                   const struct scallop_formula *formula, enum scallop_quantity quantity, bool limit);

/* For samples.c and samples_measure.c: the expansion of a quantity; the samples of a case, T0 having been made smaller by so many
 * decades, or NULL. */
const struct series *ledger_expansion(const struct ledger_motion *m, const struct ledger_case *c,
                                      enum scallop_quantity quantity);
struct ledger_sample *ledger_take_samples(const struct ledger_case *c, const fmpq_t T0, double decades);
void ledger_free_samples(struct ledger_sample *samples);

#endif
