/* asymptotics/symbolic: the expansions of derived.h as formulas: their coefficients are rational functions of named
 * symbols, exact.
 *
 * A crawler says which motion a formula is about: the modes that it has for T -> 0, and which derivatives of l at the
 * ends of a phase are not 0. The formula holds for every crawler of these modes. Never looks at numerics/. Needs FLINT;
 * prints nothing.
 *
 * Values never change once they are made: each belongs to the struct symbols that made it, and ends with that. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_SYMBOLIC_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_SYMBOLIC_H

#include "asymptotics/derived/derived.h"

enum { MOST_SYMBOLS = 56, SYMBOL_NAME = 12, SYMBOLIC_ORDERS = 16, SYMBOLIC_LIMIT_ORDERS = 10 };

/* What a symbol stands for. */
enum symbol_meaning {
  NAMED_m1,
  NAMED_m2,
  NAMED_M, /* m1 + m2, by a name of its own                                                         */
  NAMED_F1,
  NAMED_F2,
  NAMED_L,
  NAMED_v0,
  NAMED_alpha,
  NAMED_beta, /* 1 - alpha, likewise                                                                */
  NAMED_T,
  NAMED_pi,
  NAMED_AT_START, /* the n-th derivative of l by time at the start of a phase, times (duration)^n   */
  NAMED_AT_END
};

struct symbol {
  enum symbol_meaning meaning;
  int derivative; /* n >= 2, else 0                                                               */
  enum scallop_phase_kind kind;
  /* l0, l3_0, k0, l5_0, l6_0, ... for n = 2, 3, ..., and lT, l3_T, kT, ... at the end; _c of a second phase */
  char name[SYMBOL_NAME];
};

struct symbols {
  int count;
  struct symbol list[MOST_SYMBOLS];
  struct names names;  /* those of the list, in its order                                            */
  struct ratio **made; /* all values                                                                 */
  size_t made_count, made_room;
  slong most_terms; /* of symbolic_expand_limit, see struct names; 0: as many as take half a minute         */
};
/* An empty list; symbols_add appends what is not in the list, and symbols_begin makes the ring of what is then in the
 * list. symbols_end ends all three. */
void symbols_init(struct symbols *s);
void symbols_add(struct symbols *s, enum symbol_meaning meaning, int derivative, enum scallop_phase_kind kind);
/* The place in the list, -1: it is not there. kind: of a derivative */
int symbols_place(const struct symbols *s, enum symbol_meaning meaning, int derivative, enum scallop_phase_kind kind);
void symbols_begin(struct symbols *s);
void symbols_end(struct symbols *s);

/* What a symbol is for a crawler, as below */
void symbol_value(fmpq_t value, const struct symbol *symbol, const struct scallop_rational_crawler *crawler,
                  const fmpq_t v0, const fmpq_t pi_squared);
/* What the symbols are for a crawler: values, _fmpq_vec_init(s->count). v0 may be NULL where it is no symbol;
 * pi_squared as in scallop_expand_phase. */
void symbols_values(fmpq *values, const struct symbols *s, const struct scallop_rational_crawler *crawler,
                    const fmpq_t v0, const fmpq_t pi_squared);

/* A rational function of the symbols */
typedef const struct ratio *symbolic;

symbolic symbolic_number(struct symbols *s, slong over, ulong under);
symbolic symbolic_fraction(struct symbols *s, const fmpq_t x);
symbolic symbolic_polynomial(struct symbols *s, const fmpz_mpoly_t polynomial);
/* A symbol of the list, the first with this meaning */
symbolic symbolic_named(struct symbols *s, enum symbol_meaning meaning);
symbolic symbolic_place(struct symbols *s, int place);
symbolic symbolic_add(struct symbols *s, symbolic a, symbolic b);
symbolic symbolic_sub(struct symbols *s, symbolic a, symbolic b);
symbolic symbolic_mul(struct symbols *s, symbolic a, symbolic b);
/* b must not be 0. */
symbolic symbolic_div(struct symbols *s, symbolic a, symbolic b);
/* The coefficient of x^power of a series whose coefficients are rational functions of these symbols, or fractions.
 * NULL: it is not known. */
symbolic symbolic_coefficient(struct symbols *s, const struct series *series, slong power);
/* False: under is 0 there. */
bool symbolic_value(fmpq_t value, symbolic a, const struct symbols *s, const fmpq *values);
/* A value as a series in T, which is in the list: that many terms */
void symbolic_in_T(struct series *series, struct symbols *s, symbolic value, slong terms);

/* Adds the derivatives of l at the end of a phase where its first or last piece has its anchor: f^(n), 2 <= n < order,
 * that are not 0, and n = 2 in any case. */
void add_derivatives(struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind, slong order);
/* |f'| near that end, a polynomial in the derivatives of the list. */
void named_law(struct series *law, struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind);

/* A phase in names but for its laws and its fraction, in the units of symbolic_motion.c */
void named_phase(struct phase_series *to, struct symbols *s, enum scallop_phase_kind kind);

/* All coefficients of one phase below T^order, 1 <= order <= SYMBOLIC_ORDERS, in m1, m2, M, F1, F2, L, v0 and the
 * derivatives of l at the ends that are not 0 for this gait. s: from symbols_init on, made here. v0: its sign counts.
 * Statuses and why as scallop_expand_phase. */
enum scallop_status symbolic_expand_phase(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum scallop_phase_kind kind, const fmpq_t v0, slong order,
                                          struct scallop_expansion *phase, const char **why);

/* The steady state in closed form: rational functions of m1, m2, M, F1, F2, L, alpha, beta and T, where l' is linear at
 * every crossing. */
struct symbolic_steady {
  symbolic v_start, v_mid, displacement;
  char modes[sizeof((struct scallop_expansion *)0)->modes];
};
/* s: as above. For 0 < T up to where the steady state leaves the modes that the crawler has for T -> 0. Statuses as
 * scallop_expand_steady; SCALLOP_EDOMAIN also where a crossing is in a piece of l' that is not linear, and for alpha =
 * 1/2 or F1 = F2. */
enum scallop_status symbolic_solve_steady(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          struct symbolic_steady *steady, const char **why);

/* U = v_start T of the limit T -> 0, for any gait. With F_a, F_b = F1, F2 where U > 0 and F2, F1 where U < 0, it is the
 * root of
 *
 *     |(F1 - F2)(2 alpha - 1)| = 2 F_a alpha share_e + 2 F_b (1 - alpha) share_c,
 *
 * share_e the part of the extension, and share_c of the contraction, in which both bodies move alike: mu |l'| < M |U|,
 * mu = m2 and m1 where U > 0, m1 and m2 where U < 0. */
enum limit_parameter {
  /* (F1 - F2)(2 alpha - 1)/(F1 + F2), all else fixed: the first term is (26), and (27) for the paper's gaits */
  LIMIT_IN_PRODUCT,
  LIMIT_IN_ALPHA,    /* 2 alpha - 1                                                         */
  LIMIT_IN_FRICTION, /* (F1 - F2)/(F1 + F2)                                                 */
  LIMIT_PARAMETERS
};
struct symbolic_limit {
  int sign;                 /* of U                                                                 */
  bool mirrors, reversible; /* of the gait: see model.h                                             */
  const char *modes;        /* a body turns in both phases, as where the parameter is small         */
  symbolic small;           /* the parameter                                                        */
  struct series term;       /* the expansion's terms, the powers of the parameter included          */
  char why[160];            /* where there were: the reason                                         */
};
#define SYMBOLIC_LIMIT(of) of(series, &s->term)
SCOPED_PARTS(symbolic_limit, struct symbolic_limit, SYMBOLIC_LIMIT)
/* The equation of which U is the root, as text "LEFT = RIGHT": in the language of formula.h for the sinusoidal gait,
 * where share = 2/pi asin(...) with asin = pi/2 beyond 1; else with a sentence that says what share_e and share_c are.
 * NULL: alpha = 1/2 or F1 = F2, and U = 0. */
const char *symbolic_limit_equation(const struct scallop_rational_crawler *crawler);
/* All terms below parameter^order, 1 <= order <= SYMBOLIC_LIMIT_ORDERS, in m1, m2, M, F1, F2, L, alpha, beta and the
 * derivatives of l at the ends of the extension, or at its start alone where the gait is reversible, and with names
 * that end in _c at those of the contraction unless the phases mirror each other. s: from symbols_init on, made here.
 * SCALLOP_EDOMAIN also where l'' = 0 or l' jumps at an end of a phase, and for alpha = 1/2 or F1 = F2. */
enum scallop_status symbolic_expand_limit(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum limit_parameter in, slong order, struct symbolic_limit *limit,
                                          const char **why);

#endif
