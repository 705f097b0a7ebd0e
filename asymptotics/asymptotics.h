/* asymptotics/: the series of Wagner & Lauga, "Crawling scallop" (arXiv 1303.2669), as published.
 *
 * One function for each formula, scallop_ and its name, printed mistakes included: what a formula is worth is for compare/
 * to decide. Names say where it stands: equal_ section 4.1, rest_ section 4.3.1 (rest_dT_product: the appendices), text_ sections 4.3.2 and 4.3.3, A_ and B_
 * the appendices; equation numbers are the paper's. Never looks at numerics/.
 */
#ifndef SCALLOP_ASYMPTOTICS_H
#define SCALLOP_ASYMPTOTICS_H

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the formulas for one phase are functions of. T is the duration of the PHASE here, as in the
 * paper's sections 4.3.1 and 4.3.2 and its appendices. Any consistent units. */
struct scallop_phase_point {
  double m1, m2, F1, F2;   /* > 0                                                               */
  double T;                /* > 0                                                               */
  double l0, lT;           /* l'' at the start and end of the phase is l0/T^2, lT/T^2           */
  double l_start, l_end;   /* l at the start and end                                            */
  double v0;               /* velocity of both bodies at the start                              */
  double t1, dT, x_switch; /* first switching time, lag of the last one, and position there of the
                                body that turns: read by the formulas that take them as given     */
};

/* The point of one phase of a crawler; t1, dT and x_switch are nan. */
struct scallop_phase_point scallop_phase_point(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                               double v0);

/* The same motion with the names of the bodies exchanged: a contraction becomes an extension. The
 * paper prints the formulas from rest for an extension only; this carries them to a contraction. */
struct scallop_phase_point scallop_exchanged(const struct scallop_phase_point *point);

/* What a formula gives. "rear" is the body that turns: 1 in an extension, 2 in a contraction. */
enum scallop_quantity {
  SCALLOP_LAG,           /* Delta T                                                            */
  SCALLOP_FIRST_SWITCH,  /* t_1                                                                */
  SCALLOP_REAR_AT_FIRST, /* position of the rear body at t_1, from its start                   */
  SCALLOP_REAR_AT_LAST,  /* at T - Delta T                                                     */
  SCALLOP_REAR_AT_END,
  SCALLOP_FRONT_AT_END,
  SCALLOP_CENTRE_AT_END, /* geometric centre (x1 + x2)/2, from its start                       */
  SCALLOP_VELOCITY_AT_END,
  SCALLOP_VELOCITY_CHANGE,
  SCALLOP_STEADY_VELOCITY, /* at the start of the extension                                      */
  SCALLOP_STEADY_DISPLACEMENT,
  SCALLOP_VELOCITY_AT_FIRST, /* of the body that turns at t_1: 0                                    */
  SCALLOP_VELOCITY_AT_LAST   /* of the body that turns at T - Delta T: 0                            */
};

enum scallop_setting {
  SCALLOP_AT_REST_START,
  SCALLOP_MOVING_EXTENSION,
  SCALLOP_MOVING_CONTRACTION,
  SCALLOP_STEADY,
  SCALLOP_AT_REST_EQUAL_FORCES /* section 4.1: from rest, F1 = F2                                   */
};

/* For which limit of the steady state a formula is: one in which a body turns in both phases, or one in which none turns in one. */
enum scallop_turns { SCALLOP_TURNS_IN_BOTH, SCALLOP_NO_TURN_IN_CONTRACTION, SCALLOP_NO_TURN_IN_EXTENSION };

/* In the place of the remainder: the formula is printed as an equality. */
enum { SCALLOP_EQUALITY = -1 };

struct scallop_formula {
  const char *name;
  const char *equation;
  enum scallop_setting setting;
  enum scallop_quantity quantity;
  int remainder; /* printed "+ O(T^remainder)"; 0: none is printed, and the ledger passes the formula over */
  double (*phase)(const struct scallop_phase_point *); /* in a setting of one phase               */
  double (*steady)(const struct scallop_crawler *);    /* in the steady setting; T is the period  */
  const char *text;         /* the formula in the names of struct scallop_phase_point, M = m1 + m2, L_kin, alpha, L, and
                       k0, kT for the fourth derivative of l times T^4 at the start and the end; see evaluate.h               */
  const char *corrected;    /* where it is wrong: the name of the right one in scallop_corrected, or NULL  */
  enum scallop_turns turns; /* of a steady state                                                   */
};

/* Every formula, in the paper's order; the last has name NULL. */
extern const struct scallop_formula scallop_published[];
/* Section 4.1, from rest with F1 = F2, at the end of a phase; for an extension. */
extern const struct scallop_formula scallop_equal_forces[];
/* What should stand in place of those that are wrong. Texts only (no functions), for an extension: a contraction
 * is one with the bodies exchanged. equation: what they replace. */
extern const struct scallop_formula scallop_corrected[];

/* Section 4.1: from rest, F1 = F2, at the end of a phase */
double scallop_equal_v1_end(const struct scallop_phase_point *p); /* (6) -(m2/M) l'(T), and l'(T) = 0                  */
double scallop_equal_x1_end(const struct scallop_phase_point *p); /* (7) -(m2/M) (l(T) - l(0))                         */
double scallop_equal_xC_end(const struct scallop_phase_point *p); /* (8) (m1/m2 - 1)/2 (x1(T) - x1(0))                 */

/* Section 4.3.1: from rest */
double
scallop_rest_v1_switch(const struct scallop_phase_point *p); /* (12) 0 = dT (m2 l''(T) - F1 + F2) + (F1-F2) T + O(dT^2) */
double scallop_rest_dT_unexpanded(const struct scallop_phase_point *p); /* (13) -(F1-F2) T / (m2 l''(T) - F1 + F2)    */
double scallop_rest_dT(const struct scallop_phase_point *p);            /* (14) -(F1-F2) T^3 / (m2 l_T) + O(T^5)      */
double scallop_rest_x1_switch(const struct scallop_phase_point *p);     /* (15) -(m2/M) l(T) + (F1-F2)/M T^2/2 + O(T^3) */
double scallop_rest_v1_end(const struct scallop_phase_point *p);        /* (18) (F1-F2)/M T + O(T^3)                  */
double scallop_rest_x1_end(const struct scallop_phase_point *p);        /* (19) -(m2/M) l(T) + (F1-F2)/M T^2/2 + O(T^4) */
double scallop_rest_x2_end(const struct scallop_phase_point *p);        /* (20)  (m1/M) l(T) + (F1-F2)/M T^2/2 + O(T^4) */
double scallop_rest_xC_end(const struct scallop_phase_point *p); /* (21) (m1-m2)/(2M) l(T) + (F1-F2)/M T^2/2 + O(T^4) */

/* Sections 4.3.2 and 4.3.3: with a start velocity */
double scallop_text_extension_velocity_change(const struct scallop_phase_point *p);
/* (22) (F1-F2)/M T - v0 (2 F1/m2)(1/l0 - 1/lT) T^2 + O(T^3) */
double scallop_text_extension_xC_end(const struct scallop_phase_point *p);
/* (23) (m1-m2)/(2M) l(T) + v0 T + (F1-F2)/M T^2/2 - v0 2 F1/(m2 l0) T^3 + O(T^4); (A.25) has + in front of T^3 */
double scallop_text_contraction_velocity_change(const struct scallop_phase_point *p);
/* (24) -(F1-F2)/M T + v0 (2 F2/m1)(1/l0 - 1/lT) T^2 + O(T^3); (B.12) lacks T^2 */
double scallop_text_contraction_xC_end(const struct scallop_phase_point *p);
/* (25) -(m1-m2)/(2M) L + v0 T - (F1-F2)/M T^2/2 + v0 2 F2/(m1 l0) T^3 + O(T^4), L printed l(T) */

/* Section 4.3.3: steady state; T is the period */
double scallop_text_steady_velocity_l0_lT(const struct scallop_crawler *c);
/* (26) (F1-F2)(2 alpha-1) m* / (2 T (1/l0 - 1/lT) [alpha^2 F1 m1 + (1-alpha)^2 F2 m2]) + O(T), m* = m1 m2/M */
double scallop_text_steady_velocity(const struct scallop_crawler *c);
/* (27) (F1-F2)(2 alpha-1) L_kin m* / (alpha^2 F1 m1 + (1-alpha)^2 F2 m2) / T + O(T) */
double scallop_text_steady_xC(const struct scallop_crawler *c);
/* (28) (27) without 1/T, + O(T^4) */
double scallop_text_froude(const struct scallop_crawler *c);
/* section 2: M L / (T^2 (F1 + F2)) */

/* Appendix A: an extension with v0 > 0 */
double scallop_A_v1_first_switch(
    const struct scallop_phase_point *p); /* (A.4) -m2/M t1 l''(0) - (F1+F2)/M t1 + v0 + O(t1^2), t1 given */
double scallop_A_t1_unexpanded(const struct scallop_phase_point *p); /* (A.5) v0 M / (m2 l''(0) + F1 + F2)                */
double scallop_A_t1(const struct scallop_phase_point *p); /* (A.6) v0 M T^2/(m2 l0) [1 - T^2 (F1+F2)/(m2 l0)] + O(T^6) */
double
scallop_A_x1_first_switch(const struct scallop_phase_point *p); /* (A.7) v0 t1/2, t1 given                           */
double
scallop_A_v1_switch(const struct scallop_phase_point *p); /* (A.13), second line, the first one times M; t1 and dT given */
double
scallop_A_v1_switch_from_v0(const struct scallop_phase_point *p);    /* (A.13), third line, t1 by (A.5); dT given         */
double scallop_A_dT_unexpanded(const struct scallop_phase_point *p); /* (A.14)                                            */
double scallop_rest_dT_product(
    const struct scallop_phase_point *p); /* (A.15) and (B.6), the part without v0, + O(T^7): from rest */
double scallop_A_dT_product(const struct scallop_phase_point *p); /* (A.15) products of factors, + O(T^6)              */
double scallop_A_dT(const struct scallop_phase_point *p);         /* (A.16) terms in T^2, T^3, T^4, + O(T^5)           */
double
scallop_A_x1_switch_from_times(const struct scallop_phase_point *p); /* (A.17), second line, + O(T^4), t1 and dT given   */
double
scallop_A_x1_switch_collected(const struct scallop_phase_point *p); /* (A.17), third line, + O(T^4), t1 and dT given    */
double scallop_A_x1_switch(const struct scallop_phase_point *p);    /* (A.18) + O(T^4)                                   */
double
scallop_A_v1_end_from_dT(const struct scallop_phase_point *p); /* (A.22) -dT (m2 l_T/T^2 + F1 + F2)/M + O(T^4), dT given */
double scallop_A_v1_end(const struct scallop_phase_point *p);  /* (A.22) v0 + the change of (22), + O(T^3)          */
double
scallop_A_x1_end_from_dT(const struct scallop_phase_point *p); /* (A.23), second line, + O(T^6), dT and x_switch given */
double
scallop_A_x1_end_from_dT_short(const struct scallop_phase_point *p); /* (A.23), third line, + O(T^4)                  */
double scallop_A_x1_end(const struct scallop_phase_point *p);        /* (A.23) ... + v0 2 F1/(m2 l0) T^3 + O(T^4)         */
double scallop_A_vC_end(const struct scallop_phase_point *p);        /* (A.24) = (A.22)                                   */
double scallop_A_xC_end(const struct scallop_phase_point *p);        /* (A.25) as (23) but + v0 2 F1/(m2 l0) T^3, + O(T^4) */

/* Appendix B: a contraction with v0 > 0; l0 < 0 < lT */
double scallop_B_t1_unexpanded(const struct scallop_phase_point *p); /* (B.2) v0 M / (-m1 l''(0) + F1 + F2)               */
double scallop_B_t1(const struct scallop_phase_point *p); /* (B.2) -v0 M T^2/(m1 l0) [1 + T^2 (F1+F2)/(m1 l0)] + O(T^6) */
double
scallop_B_x2_first_switch(const struct scallop_phase_point *p);      /* (B.3) v0 t1/2 + O(T^2), t1 given                  */
double scallop_B_dT_unexpanded(const struct scallop_phase_point *p); /* (B.5)                                             */
double scallop_B_dT_product(const struct scallop_phase_point *p);    /* (B.6), products of factors, + O(T^6)              */
double scallop_B_dT(const struct scallop_phase_point *p);            /* (B.6), terms in T^2, T^3, T^4, + O(T^5)           */
double
scallop_B_x2_switch_from_times(const struct scallop_phase_point *p); /* (B.7), second line, + O(T^4), t1 and dT given    */
double
scallop_B_x2_switch_collected(const struct scallop_phase_point *p);   /* (B.7), third line, + O(T^4), t1 and dT given     */
double scallop_B_x2_switch(const struct scallop_phase_point *p);      /* (B.8) + O(T^4)                                    */
double scallop_B_v2_end_from_dT(const struct scallop_phase_point *p); /* (B.10) dT (m1 l_T/T^2 - F1 - F2)/M, dT given      */
double scallop_B_v2_end(const struct scallop_phase_point *p);         /* (B.10) last term printed without T^2, + O(T^3)    */
double
scallop_B_x2_end_from_dT(const struct scallop_phase_point *p); /* (B.11), second line, x2' for x2(T - dT), + O(T^4)     */
double scallop_B_x2_end(const struct scallop_phase_point *p);  /* (B.11) + O(T^4)                                   */
double scallop_B_vC_end(const struct scallop_phase_point *p);  /* (B.12) last term printed without T^2, + O(T^3)    */
double scallop_B_xC_end(const struct scallop_phase_point *p);  /* (B.13) + O(T^4)                                   */

#ifdef __cplusplus
}
#endif

#endif
