/* One motion that claims about an order are about: its expansion as T -> 0, and what a formula leaves out of that.
 * Needs FLINT. Not public. */
#ifndef SCALLOP_COMPARE_CLAIMS_TRIAL_H
#define SCALLOP_COMPARE_CLAIMS_TRIAL_H

#include "asymptotics/derived/derived.h"
#include "asymptotics/derived/evaluate.h"
#include "compare/claims/claims.h"

/* Under which a formula is tested */
struct condition {
  enum scallop_setting setting; /* SCALLOP_MOVING_EXTENSION stands for any phase with a start velocity */
  enum scallop_phase_kind kind;
  const char *text;
  bool inside;                                 /* assumed by the paper                                */
  double v0;                                   /* in units of sqrt(L (F1 + F2)/M)                     */
  bool exchange_forces, mirror_alpha, light_1; /* m1 a hundredth                                      */
  bool equal_forces;                           /* F2 = F1                                             */
  bool reversed;                               /* the bodies exchange their roles against the paper   */
  const struct scallop_formula *formula;       /* of a book, whose conditions are to hold; else NULL                */
};
/* Do the conditions of the formula of a book hold for the crawler? v0 of the trial does not come in. */
bool condition_allows(const struct condition *condition, const struct scallop_rational_crawler *crawler);
/* Changes the crawler so that they do: parameters that are to equal something are set, and where that does not do,
 * another crawler is taken. False: none was found. */
bool condition_fit(const struct condition *condition, struct scallop_rational_crawler *crawler);

/* The crawler under one condition; mirrored: seen in a mirror, the bodies exchanged, so that a reversed motion becomes
 * one that the paper's formulas are for. */
struct trial {
  const struct condition *condition;
  bool mirrored;
  fmpq_t v0;
  struct scallop_rational_crawler crawler; /* T is not used                                         */
  struct expanded *expanded;               /* of the crawler                                                         */
  const char *why;                         /* it has no expansion: why not                                */
  struct sample *samples;                  /* samples.h */
};
/* False: it has no expansion in powers of T. To be cleared all the same. */
bool trial_init(struct trial *m, const struct scallop_rational_crawler *crawler, const struct condition *condition,
                bool mirrored);
void trial_clear(struct trial *m);
/* The modes for T -> 0, as in "++ -+ ++ | ++ +- ++". */
const char *trial_modes(const struct trial *m);

/* What a formula leaves out: the derived expansion minus the formula. */
struct proof {
  bool found;  /* false: every coefficient below T^known vanishes                                    */
  slong order; /* of the first coefficient that does not                                             */
  slong known;
  slong general;       /* that order for all parameters with these modes; order where that is not known         */
  bool for_all;        /* general is known, and order                                                   */
  slong for_all_below; /* where nothing was found: lower coefficients vanish for all parameters; 0: not known */
  char *term;          /* then the first term as a formula, or NULL                                     */
  bool contradicts;    /* the two routes, by numbers and in names, differ                               */
  struct series left_out;
  bool undecided;            /* a ball that holds 0 came before                                                  */
  char why[FORMULA_MESSAGE]; /* the formula has no expansion: what a series cannot do                       */
};
void proof_init(struct proof *p);
void proof_clear(struct proof *p);
/* A formula without a text is the leading term of the derived expansion. False: it has no expansion there, and why says
 * what of. */
bool trial_prove(struct proof *proof, const struct trial *m, const struct scallop_formula *formula);

/* Of the crawler: the expansion of a quantity */
bool trial_is_steady(const struct trial *m);
const struct series *trial_series(const struct trial *m, enum scallop_quantity quantity);
/* Of a steady state */
slong trial_leading_power(const struct scallop_formula *formula);
/* x to two significant digits: fractions stay readable, and nothing depends on a library's square root. */
void trial_set_rounded(fmpq_t x, double value);

#endif
