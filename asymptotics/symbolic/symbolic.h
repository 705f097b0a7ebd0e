/* asymptotics/symbolic: the expansions of derived.h as formulas, with rational functions of named symbols as exact
 * coefficients.
 *
 * A crawler selects the motion of a formula: its modes for T -> 0, and the derivatives of l at the ends of a phase that
 * are not 0. The formula holds for every crawler with these modes. Independent of numerics/. Needs FLINT; prints
 * nothing.
 *
 * Values never change: each belongs to the struct symbols that made it, and is freed with it. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_SYMBOLIC_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_SYMBOLIC_H

#include "asymptotics/derived/derived.h"

enum { MOST_SYMBOLS = 56, SYMBOL_NAME = 12, SYMBOLIC_ORDERS = 16, SYMBOLIC_LIMIT_ORDERS = 10 };

/* Meanings of symbols */
enum symbol_meaning {
  NAMED_m1,
  NAMED_m2,
  NAMED_M, /* m1 + m2, as an independent name */
  NAMED_F1,
  NAMED_F2,
  NAMED_L,
  NAMED_v0,
  NAMED_alpha,
  NAMED_beta, /* 1 - alpha, as an independent name */
  NAMED_T,
  NAMED_pi,
  NAMED_AT_START, /* n-th derivative of l with respect to time at the start of a phase, times (duration)^n */
  NAMED_AT_END
};

struct symbol {
  enum symbol_meaning meaning;
  int derivative; /* n >= 2, else 0                                                               */
  enum scallop_phase_kind kind;
  /* l0, l3_0, k0, l5_0, l6_0, ... for n = 2, 3, ..., and lT, l3_T, kT, ... at the end; suffix _c in a second phase */
  char name[SYMBOL_NAME];
};

struct symbols {
  int count;
  struct symbol list[MOST_SYMBOLS];
  struct names names;  /* names of the list, in its order */
  struct ratio **made; /* all values                                                                 */
  size_t made_count, made_allocated;
  slong most_terms; /* of symbolic_expand_limit, see struct names; 0: a limit for half a minute of work */
};
/* init: sets an empty list; add: appends a symbol unless it is in the list; begin: makes the ring of the list; end:
 * frees all. */
void symbols_init(struct symbols *s);
void symbols_add(struct symbols *s, enum symbol_meaning meaning, int derivative, enum scallop_phase_kind kind);
/* Returns the index in the list, -1 if absent. kind: of a derivative */
int symbols_place(const struct symbols *s, enum symbol_meaning meaning, int derivative, enum scallop_phase_kind kind);
void symbols_begin(struct symbols *s);
void symbols_end(struct symbols *s);

/* Computes the value of a symbol for a crawler, as below. */
void symbol_value(fmpq_t value, const struct symbol *symbol, const struct scallop_rational_crawler *crawler,
                  const fmpq_t v0, const fmpq_t pi_squared);
/* Computes the values of the symbols for a crawler: values, _fmpq_vec_init(s->count). v0 may be NULL if it is not a
 * symbol; pi_squared as in scallop_expand_phase. */
void symbols_values(fmpq *values, const struct symbols *s, const struct scallop_rational_crawler *crawler,
                    const fmpq_t v0, const fmpq_t pi_squared);

/* A rational function of the symbols */
typedef const struct ratio *symbolic;

symbolic symbolic_number(struct symbols *s, slong over, ulong under);
symbolic symbolic_fraction(struct symbols *s, const fmpq_t x);
symbolic symbolic_polynomial(struct symbols *s, const fmpz_mpoly_t polynomial);
/* Returns the first symbol of the list with this meaning. */
symbolic symbolic_named(struct symbols *s, enum symbol_meaning meaning);
symbolic symbolic_place(struct symbols *s, int place);
symbolic symbolic_add(struct symbols *s, symbolic a, symbolic b);
symbolic symbolic_sub(struct symbols *s, symbolic a, symbolic b);
symbolic symbolic_mul(struct symbols *s, symbolic a, symbolic b);
/* b must not be 0. */
symbolic symbolic_div(struct symbols *s, symbolic a, symbolic b);
/* Returns the coefficient of x^power of a series with fractions or rational functions of these symbols; NULL if it is
 * not known. */
symbolic symbolic_coefficient(struct symbols *s, const struct series *series, slong power);
/* Computes the value; returns false if the denominator is 0. */
bool symbolic_value(fmpq_t value, symbolic a, const struct symbols *s, const fmpq *values);
/* Expands a value as a series in T, a symbol of the list, with this many terms. */
void symbolic_in_T(struct series *series, struct symbols *s, symbolic value, slong terms);

/* Adds the derivatives of l at the end of a phase at which its first or last piece has its anchor: f^(n), 2 <= n <
 * order, except zeros, and n = 2 in any case. */
void add_derivatives(struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind, slong order);
/* Computes |f'| near this end, a polynomial in the derivatives of the list. */
void named_law(struct series *law, struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind);

/* Sets a phase in names, without its laws and its fraction, in the units of symbolic_motion.c. */
void named_phase(struct phase_series *to, struct symbols *s, enum scallop_phase_kind kind);

/* Expands one phase below T^order, 1 <= order <= SYMBOLIC_ORDERS, in m1, m2, M, F1, F2, L, v0 and the derivatives of l
 * at the ends that are not 0 for this gait. s: after symbols_init, filled here. v0: only its sign is used. Statuses and
 * why as scallop_expand_phase. */
enum scallop_status symbolic_expand_phase(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum scallop_phase_kind kind, const fmpq_t v0, slong order,
                                          struct scallop_expansion *phase, const char **why);

/* The steady state in closed form if l' is linear at every crossing: rational functions of m1, m2, M, F1, F2, L, alpha,
 * beta and T. */
struct symbolic_steady {
  symbolic v_start, v_mid, displacement;
  char modes[sizeof((struct scallop_expansion *)0)->modes];
};
/* Solves for the steady state, valid for 0 < T as long as it has the modes that the crawler has for T -> 0. s: as
 * above. Statuses as scallop_expand_steady; SCALLOP_EDOMAIN also if a crossing is in a piece with nonlinear l', and for
 * alpha = 1/2 or F1 = F2. */
enum scallop_status symbolic_solve_steady(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          struct symbolic_steady *steady, const char **why);

/* Parameters of an expansion of U = v_start T of the limit T -> 0, for any gait. With F_a, F_b = F1, F2 for U > 0 and
 * F2, F1 for U < 0, U is the root of
 *
 *     |(F1 - F2)(2 alpha - 1)| = 2 F_a alpha share_e + 2 F_b (1 - alpha) share_c,
 *
 * share_e the fraction of the extension, and share_c of the contraction, in which both bodies move in the same
 * direction: mu |l'| < M |U|, mu = m2 and m1 for U > 0, m1 and m2 for U < 0. */
enum limit_parameter {
  /* (F1 - F2)(2 alpha - 1)/(F1 + F2), all else fixed: the first term is (26), and (27) for the paper's gaits */
  LIMIT_IN_PRODUCT,
  LIMIT_IN_ALPHA,    /* 2 alpha - 1                                                         */
  LIMIT_IN_FRICTION, /* (F1 - F2)/(F1 + F2)                                                 */
  LIMIT_PARAMETERS
};
struct symbolic_limit {
  int sign;                 /* sign of U */
  bool mirrors, reversible; /* of the gait: see model.h                                             */
  const char *modes;        /* a body turns in both phases, as for a small parameter */
  symbolic small;           /* the parameter                                                        */
  struct series term;       /* terms of the expansion, including the powers of the parameter */
  char why[160];            /* the reason of a failure */
};
#define SYMBOLIC_LIMIT(of) of(series, &s->term)
SCOPED_PARTS(symbolic_limit, struct symbolic_limit, SYMBOLIC_LIMIT)
/* Returns the equation for U as text "LEFT = RIGHT": in the language of formula.h for the sinusoidal gait, with share =
 * 2/pi asin(...) and asin = pi/2 beyond 1; otherwise with a sentence that defines share_e and share_c. NULL: alpha =
 * 1/2 or F1 = F2, and U = 0. */
const char *symbolic_limit_equation(const struct scallop_rational_crawler *crawler);
/* Expands U below parameter^order, 1 <= order <= SYMBOLIC_LIMIT_ORDERS, in m1, m2, M, F1, F2, L, alpha, beta and the
 * derivatives of l at the ends of the extension (at its start alone for a reversible gait), and of the contraction,
 * with names that end in _c, unless the phases mirror each other. s: after symbols_init, filled here. SCALLOP_EDOMAIN
 * also if l'' = 0 or l' jumps at an end of a phase, and for alpha = 1/2 or F1 = F2. */
enum scallop_status symbolic_expand_limit(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum limit_parameter in, slong order, struct symbolic_limit *limit,
                                          const char **why);

#endif
