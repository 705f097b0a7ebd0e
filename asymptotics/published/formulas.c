/* Every formula of the paper once more, in a form that can be evaluated in any arithmetic, and those that are right where
 * the paper's are not. The tests hold each text against the function of the same name. */
#include <stddef.h>

#include "asymptotics/asymptotics.h"

#define PHASE(f, where, setting, quantity, order, corrected, text) \
  { \
#f, where, setting, quantity, order, scallop_##f, NULL, text, corrected, SCALLOP_TURNS_IN_BOTH \
  }
#define STEADY(f, where, quantity, order, text) \
  { \
#f, where, SCALLOP_STEADY, quantity, order, NULL, scallop_##f, text, NULL, SCALLOP_TURNS_IN_BOTH \
  }
#define NEW(name, wrong, setting, quantity, order, text) \
  { \
    name, wrong, setting, quantity, order, NULL, NULL, text, NULL, SCALLOP_TURNS_IN_BOTH \
  }
#define NEW_STEADY(name, wrong, turns, quantity, order, text) \
  { \
    name, wrong, SCALLOP_STEADY, quantity, order, NULL, NULL, text, NULL, turns \
  }

const struct scallop_formula scallop_published[] = {
  PHASE(rest_v1_switch, "(12)", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_LAST, 6, "corrected_rest_v_switch",
        "dT*(m2*lT/T^2 - F1 + F2) + (F1 - F2)*T"),
  PHASE(rest_dT_unexpanded, "(13)", SCALLOP_AT_REST_START, SCALLOP_LAG, 0, NULL, "-(F1 - F2)/(m2*lT/T^2 - F1 + F2)*T"),
  PHASE(rest_dT, "(14)", SCALLOP_AT_REST_START, SCALLOP_LAG, 5, NULL, "-(F1 - F2)/(m2*lT)*T^3"),
  PHASE(rest_x1_switch, "(15)", SCALLOP_AT_REST_START, SCALLOP_REAR_AT_LAST, 3, NULL, "-m2/M*l_end + (F1 - F2)/M*T^2/2"),
  PHASE(rest_v1_end, "(18)", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 3, NULL, "(F1 - F2)/M*T"),
  PHASE(rest_x1_end, "(19)", SCALLOP_AT_REST_START, SCALLOP_REAR_AT_END, 4, NULL, "-m2/M*l_end + (F1 - F2)/M*T^2/2"),
  PHASE(rest_x2_end, "(20)", SCALLOP_AT_REST_START, SCALLOP_FRONT_AT_END, 4, NULL, "m1/M*l_end + (F1 - F2)/(2*M)*T^2"),
  PHASE(rest_xC_end, "(21)", SCALLOP_AT_REST_START, SCALLOP_CENTRE_AT_END, 4, NULL,
        "(m1 - m2)/(2*M)*l_end + (F1 - F2)/(2*M)*T^2"),
  PHASE(text_extension_velocity_change, "(22)", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_CHANGE, 3, NULL,
        "(F1 - F2)/M*T - v0*2*F1/m2*(1/l0 - 1/lT)*T^2"),
  PHASE(text_extension_xC_end, "(23)", SCALLOP_MOVING_EXTENSION, SCALLOP_CENTRE_AT_END, 4, NULL,
        "(m1 - m2)/(2*M)*l_end + v0*T + (F1 - F2)/(2*M)*T^2 - v0*2*F1/(m2*l0)*T^3"),
  PHASE(text_contraction_velocity_change, "(24)", SCALLOP_MOVING_CONTRACTION, SCALLOP_VELOCITY_CHANGE, 3, NULL,
        "-(F1 - F2)/M*T + v0*2*F2/m1*(1/l0 - 1/lT)*T^2"),
  PHASE(text_contraction_xC_end, "(25)", SCALLOP_MOVING_CONTRACTION, SCALLOP_CENTRE_AT_END, 4, NULL,
        "-(m1 - m2)/(2*M)*l_start + v0*T - (F1 - F2)/(2*M)*T^2 + v0*2*F2/(m1*l0)*T^3"),
  STEADY(text_steady_velocity_l0_lT, "(26)", SCALLOP_STEADY_VELOCITY, 1,
         "(F1 - F2)*(2*alpha - 1)/(2*T*(1/l0 - 1/lT)*(alpha^2*F1*m1 + (1 - alpha)^2*F2*m2))*m1*m2/M"),
  STEADY(text_steady_velocity, "(27)", SCALLOP_STEADY_VELOCITY, 1,
         "(F1 - F2)*(2*alpha - 1)*L_kin*m1*m2/M/(alpha^2*F1*m1 + (1 - alpha)^2*F2*m2)/T"),
  STEADY(text_steady_xC, "(28)", SCALLOP_STEADY_DISPLACEMENT, 4,
         "(F1 - F2)*(2*alpha - 1)*L_kin*m1*m2/M/(alpha^2*F1*m1 + (1 - alpha)^2*F2*m2)"),
  PHASE(A_v1_first_switch, "(A.4)", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_AT_FIRST, 4, "corrected_v_first_switch",
        "-m2/M*t1*l0/T^2 - (F1 + F2)/M*t1 + v0"),
  PHASE(A_t1_unexpanded, "(A.5)", SCALLOP_MOVING_EXTENSION, SCALLOP_FIRST_SWITCH, 0, NULL, "v0*M/(m2*l0/T^2 + F1 + F2)"),
  PHASE(A_t1, "(A.6)", SCALLOP_MOVING_EXTENSION, SCALLOP_FIRST_SWITCH, 6, "corrected_t1",
        "v0*M/(m2*l0)*T^2*(1 - T^2*(F1 + F2)/(m2*l0))"),
  PHASE(A_x1_first_switch, "(A.7)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_FIRST, 0, NULL, "v0*t1/2"),
  PHASE(A_v1_switch, "(A.13)", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_AT_LAST, SCALLOP_EQUALITY, "corrected_v_switch",
        "dT*(m2*lT/T^2 - (F1 - F2)) + t1*(m2*l0/T^2 - (F1 - F2)) + (F1 - F2)*T"),
  PHASE(A_v1_switch_from_v0, "(A.13)", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_AT_LAST, SCALLOP_EQUALITY,
        "corrected_v_switch", "dT*(m2*lT/T^2 - (F1 - F2)) + v0*M*(m2*l0/T^2 - F1 + F2)/(m2*l0/T^2 + F1 + F2) + (F1 - F2)*T"),
  PHASE(A_dT_unexpanded, "(A.14)", SCALLOP_MOVING_EXTENSION, SCALLOP_LAG, 0, NULL,
        "-(v0*M*(m2*l0/T^2 - F1 + F2)/(m2*l0/T^2 + F1 + F2) + (F1 - F2)*T)/(m2*lT/T^2 - F1 + F2)"),
  PHASE(rest_dT_product, "(A.15), (B.6)", SCALLOP_AT_REST_START, SCALLOP_LAG, 7, NULL,
        "-T^3*(F1 - F2)/(m2*lT)*(1 + T^2*(F1 - F2)/(m2*lT))"),
  PHASE(A_dT_product, "(A.15)", SCALLOP_MOVING_EXTENSION, SCALLOP_LAG, 6, "corrected_dT_longer",
        "-T^3*(F1 - F2)/(m2*lT)*(1 + T^2*(F1 - F2)/(m2*lT)) - T^2*v0*M/(m2*lT)*(1 + T^2*(F1 - F2)/(m2*lT))*(1 - T^2*(F1 - "
        "F2)/(m2*l0))*(1 - T^2*(F1 + F2)/(m2*l0))"),
  PHASE(A_dT, "(A.16)", SCALLOP_MOVING_EXTENSION, SCALLOP_LAG, 5, "corrected_dT",
        "-v0*M/(m2*lT)*T^2 - (F1 - F2)/(m2*lT)*T^3 - v0*M/(m2*lT)*((F1 - F2)/(m2*lT) - 2*F1/(m2*l0))*T^4"),
  PHASE(A_x1_switch_from_times, "(A.17)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_LAST, 4,
        "corrected_rear_switch_from_times",
        "-m2/M*l_end - m2/M*(dT^2*lT/T^2 - t1^2*l0/T^2)/2 + m2/M*t1*l0/T^2*(T - dT - t1) + (F1 - F2)/(2*M)*(T - dT - t1)^2"
        " + v0*t1/2"),
  PHASE(A_x1_switch_collected, "(A.17)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_LAST, 4,
        "corrected_rear_switch_from_times",
        "-m2/M*l_end + T^2*(F1 - F2)/(2*M) + dT^2*(-m2*lT/T^2/(2*M) + (F1 - F2)/(2*M)) + t1^2*(-m2*l0/T^2/(2*M) + (F1 - "
        "F2)/(2*M)) - T*dT*(F1 - F2)/M + t1*T*(m2*l0/T^2/M - (F1 - F2)/M) + t1*dT*(-m2*l0/T^2/M + (F1 - F2)/M) + v0*t1/2"),
  PHASE(A_x1_switch, "(A.18)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_LAST, 4, NULL,
        "-m2/M*l_end + v0*T + ((F1 - F2)/M + v0^2*M/(m2*lT))/2*T^2 + v0/m2*((F1 - F2)/lT - 2*F1/l0)*T^3"),
  PHASE(A_v1_end_from_dT, "(A.22)", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_AT_END, 4, "corrected_v_end_from_dT",
        "-dT*(m2/M*lT/T^2 + (F1 + F2)/M)"),
  PHASE(A_v1_end, "(A.22)", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_AT_END, 3, NULL,
        "v0 + (F1 - F2)/M*T - v0*2*F1/m2*(1/l0 - 1/lT)*T^2"),
  PHASE(A_x1_end_from_dT, "(A.23)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_END, 6, "corrected_rear_end_from_dT",
        "-m2/M*lT*dT^2/T^2/2 - (F1 + F2)/M*dT^2/2 + x_switch"),
  PHASE(A_x1_end_from_dT_short, "(A.23)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_END, 4, NULL,
        "-m2/M*lT*dT^2/T^2/2 + x_switch"),
  PHASE(A_x1_end, "(A.23)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_END, 4, "corrected_rear_end",
        "-m2/M*l_end + v0*T + (F1 - F2)/(2*M)*T^2 + v0*2*F1/(m2*l0)*T^3"),
  PHASE(A_vC_end, "(A.24)", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_AT_END, 3, NULL,
        "v0 + (F1 - F2)/M*T - v0*2*F1/m2*(1/l0 - 1/lT)*T^2"),
  PHASE(A_xC_end, "(A.25)", SCALLOP_MOVING_EXTENSION, SCALLOP_CENTRE_AT_END, 4, "corrected_xC_end",
        "(m1 - m2)/(2*M)*l_end + v0*T + (F1 - F2)/(2*M)*T^2 + v0*2*F1/(m2*l0)*T^3"),
  PHASE(B_t1_unexpanded, "(B.2)", SCALLOP_MOVING_CONTRACTION, SCALLOP_FIRST_SWITCH, 0, NULL, "v0*M/(-m1*l0/T^2 + F1 + F2)"),
  PHASE(B_t1, "(B.2)", SCALLOP_MOVING_CONTRACTION, SCALLOP_FIRST_SWITCH, 6, "corrected_t1",
        "-v0*M/(m1*l0)*T^2*(1 + T^2*(F1 + F2)/(m1*l0))"),
  PHASE(B_x2_first_switch, "(B.3)", SCALLOP_MOVING_CONTRACTION, SCALLOP_REAR_AT_FIRST, 2, NULL, "v0*t1/2"),
  PHASE(B_dT_unexpanded, "(B.5)", SCALLOP_MOVING_CONTRACTION, SCALLOP_LAG, 0, NULL,
        "(v0*M*(m1*l0/T^2 - F1 + F2)/(m1*l0/T^2 - F1 - F2) - (F1 - F2)*T)/(m1*lT/T^2 - F1 + F2)"),
  PHASE(B_dT_product, "(B.6)", SCALLOP_MOVING_CONTRACTION, SCALLOP_LAG, 6, "corrected_dT_longer",
        "-(F1 - F2)/(m1*lT)*T^3*(1 + T^2*(F1 - F2)/(m1*lT)) + T^2*v0*M/(m1*lT)*(1 + T^2*(F1 - F2)/(m1*lT))*(1 - T^2*(F1 - "
        "F2)/(m1*l0))*(1 + T^2*(F1 + F2)/(m1*l0))"),
  PHASE(B_dT, "(B.6)", SCALLOP_MOVING_CONTRACTION, SCALLOP_LAG, 5, "corrected_dT",
        "v0*M/(m1*lT)*T^2 - (F1 - F2)/(m1*lT)*T^3 + v0*M/(m1*lT)*((F1 - F2)/(m1*lT) + 2*F2/(m1*l0))*T^4"),
  PHASE(B_x2_switch_from_times, "(B.7)", SCALLOP_MOVING_CONTRACTION, SCALLOP_REAR_AT_LAST, 4,
        "corrected_rear_switch_from_times",
        "-m1/M*l_start + m1/M*(dT^2*lT/T^2 - t1^2*l0/T^2)/2 - m1/M*t1*l0/T^2*(T - dT - t1) - (F1 - F2)/(2*M)*(T - dT - t1)^2"
        " + v0*t1/2"),
  PHASE(
      B_x2_switch_collected, "(B.7)", SCALLOP_MOVING_CONTRACTION, SCALLOP_REAR_AT_LAST, 4,
      "corrected_rear_switch_from_times",
      "-m1/M*l_start - T^2*(F1 - F2)/(2*M) - t1*T*(m1*l0/T^2/M - (F1 - F2)/M) + T*dT*(F1 - F2)/M + dT^2*(m1*lT/T^2/(2*M) - "
      "(F1 - F2)/(2*M)) + t1^2*(m1*l0/T^2/M - (F1 - F2)/(2*M)) + t1*dT*(m1*l0/T^2/M - (F1 - F2)/M) + v0*t1/2"),
  PHASE(B_x2_switch, "(B.8)", SCALLOP_MOVING_CONTRACTION, SCALLOP_REAR_AT_LAST, 4, NULL,
        "-m1/M*l_start + v0*T - ((F1 - F2)/M + v0^2*M/(m1*lT))/2*T^2 + v0/m1*((F1 - F2)/lT + 2*F2/l0)*T^3"),
  PHASE(B_v2_end_from_dT, "(B.10)", SCALLOP_MOVING_CONTRACTION, SCALLOP_VELOCITY_AT_END, 0, NULL,
        "m1/M*dT*lT/T^2 - (F1 + F2)/M*dT"),
  PHASE(B_v2_end, "(B.10)", SCALLOP_MOVING_CONTRACTION, SCALLOP_VELOCITY_AT_END, 3, "corrected_v_end",
        "v0 - (F1 - F2)/M*T + v0*2*F2/m1*(1/l0 - 1/lT)"),
  PHASE(B_x2_end_from_dT, "(B.11)", SCALLOP_MOVING_CONTRACTION, SCALLOP_REAR_AT_END, 4, "corrected_rear_end_from_dT_short",
        "m1/M*dT^2*lT/T^2/2"),
  PHASE(B_x2_end, "(B.11)", SCALLOP_MOVING_CONTRACTION, SCALLOP_REAR_AT_END, 4, NULL,
        "-m1/M*l_start + v0*T - (F1 - F2)/(2*M)*T^2 + v0*2*F2/(m1*l0)*T^3"),
  PHASE(B_vC_end, "(B.12)", SCALLOP_MOVING_CONTRACTION, SCALLOP_VELOCITY_AT_END, 3, "corrected_v_end",
        "v0 - (F1 - F2)/M*T + v0*2*F2/m1*(1/l0 - 1/lT)"),
  PHASE(B_xC_end, "(B.13)", SCALLOP_MOVING_CONTRACTION, SCALLOP_CENTRE_AT_END, 4, NULL,
        "-(m1 - m2)/(2*M)*l_start + v0*T - (F1 - F2)/(2*M)*T^2 + v0*2*F2/(m1*l0)*T^3"),
  { .name = NULL },
};

#define EQUAL(f, where, quantity, corrected, text) \
  { \
#f, where, SCALLOP_AT_REST_EQUAL_FORCES, quantity, SCALLOP_EQUALITY, scallop_##f, NULL, text, corrected, \
        SCALLOP_TURNS_IN_BOTH \
  }
const struct scallop_formula scallop_equal_forces[] = {
  EQUAL(equal_v1_end, "(6)", SCALLOP_VELOCITY_AT_END, NULL, "0"), /* l'(T) = 0 */
  EQUAL(equal_x1_end, "(7)", SCALLOP_REAR_AT_END, NULL, "-m2/M*(l_end - l_start)"),
  EQUAL(equal_xC_end, "(8)", SCALLOP_CENTRE_AT_END, "corrected_equal_xC_end", "(m1/m2 - 1)/2*(-m2/M*(l_end - l_start))"),
  { .name = NULL },
};

/* For an extension; a contraction is one with the bodies exchanged, and v0 < 0 one with the bodies exchanged and mirrored. The third
 * derivative of l is 0 at both ends of a phase; for _rear_end and _xC_end lT = -l0, else they end with O(T^4). _no_turn: for the
 * quadratic gait, where in the limit no body turns in the contraction, or in the extension. */
#define MOVING SCALLOP_MOVING_EXTENSION
const struct scallop_formula scallop_corrected[] = {
  NEW("corrected_equal_xC_end", "(8)", SCALLOP_AT_REST_EQUAL_FORCES, SCALLOP_CENTRE_AT_END, SCALLOP_EQUALITY,
      "(1 - m1/m2)/2*(-m2/M*(l_end - l_start))"),
  NEW("corrected_rest_v_switch", "(12)", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_LAST, 9,
      "dT*(m2*lT/T^2 - F1 + F2) + (F1 - F2)*T + m2*kT*dT^3/(6*T^4)"),
  NEW("corrected_v_first_switch", "(A.4)", MOVING, SCALLOP_VELOCITY_AT_FIRST, 4,
      "-m2/M*(t1*l0/T^2 + k0*t1^3/(6*T^4)) - (F1 + F2)/M*t1 + v0"),
  NEW("corrected_t1", "(A.6), (B.2)", MOVING, SCALLOP_FIRST_SWITCH, 6,
      "v0*M/(m2*l0)*T^2*(1 - T^2*(F1 + F2)/(m2*l0)) - k0/(6*l0)*(v0*M/(m2*l0))^3*T^4"),
  NEW("corrected_v_switch", "(A.13)", MOVING, SCALLOP_VELOCITY_AT_LAST, 4,
      "dT*(m2*lT/T^2 - F1 + F2) + m2*kT*dT^3/(6*T^4) + t1*(m2*l0/T^2 - F1 + F2) + m2*k0*t1^3/(6*T^4) + (F1 - F2)*T"),
  NEW("corrected_dT", "(A.16), (B.6)", MOVING, SCALLOP_LAG, 5,
      "-v0*M/(m2*lT)*T^2 - (F1 - F2)/(m2*lT)*T^3"
      " - v0*M/(m2*lT)*((F1 - F2)/(m2*lT) - 2*F1/(m2*l0) - kT/(6*lT)*(v0*M/(m2*lT))^2)*T^4"),
  NEW("corrected_dT_longer", "(A.15), (B.6)", MOVING, SCALLOP_LAG, 6,
      "-v0*M/(m2*lT)*T^2 - (F1 - F2)/(m2*lT)*T^3"
      " - v0*M/(m2*lT)*((F1 - F2)/(m2*lT) - 2*F1/(m2*l0) - kT/(6*lT)*(v0*M/(m2*lT))^2)*T^4"
      " - (F1 - F2)/(m2*lT)*((F1 - F2)/(m2*lT) - kT/(2*lT)*(v0*M/(m2*lT))^2)*T^5"),
  NEW("corrected_rear_switch_from_times", "(A.17), (B.7)", MOVING, SCALLOP_REAR_AT_LAST, 4,
      "-m2/M*l_end - m2/M*(dT^2*lT/T^2 - t1^2*l0/T^2)/2 + m2/M*t1*(l0/T^2 + k0*t1^2/(6*T^4))*(T - dT - t1)"
      " + (F1 - F2)/(2*M)*(T - dT - t1)^2 + v0*t1/2"),
  NEW("corrected_v_end", "(B.10), (B.12)", MOVING, SCALLOP_VELOCITY_AT_END, 3,
      "v0 + (F1 - F2)/M*T - v0*2*F1/m2*(1/l0 - 1/lT)*T^2"),
  NEW("corrected_v_end_from_dT", "(A.22)", MOVING, SCALLOP_VELOCITY_AT_END, 4,
      "-dT*(m2/M*lT/T^2 + (F1 + F2)/M) - m2/M*kT*dT^3/(6*T^4)"),
  NEW("corrected_rear_end_from_dT", "(A.23)", MOVING, SCALLOP_REAR_AT_END, 6,
      "-m2/M*lT*dT^2/T^2/2 - (F1 + F2)/M*dT^2/2 - m2/M*kT*dT^4/(8*T^4) + x_switch"),
  NEW("corrected_rear_end_from_dT_short", "(B.11)", MOVING, SCALLOP_REAR_AT_END, 4, "-m2/M*lT*dT^2/T^2/2 + x_switch"),
  NEW("corrected_rear_end", "(A.23)", MOVING, SCALLOP_REAR_AT_END, 5,
      "-m2/M*l_end + v0*T + (F1 - F2)/(2*M)*T^2 - v0*2*F1/(m2*l0)*T^3"),
  NEW("corrected_xC_end", "(A.25)", MOVING, SCALLOP_CENTRE_AT_END, 5,
      "(m1 - m2)/(2*M)*l_end + v0*T + (F1 - F2)/(2*M)*T^2 - v0*2*F1/(m2*l0)*T^3"),
  NEW_STEADY("corrected_steady_velocity_no_turn", "(26), (27)", SCALLOP_NO_TURN_IN_CONTRACTION, SCALLOP_STEADY_VELOCITY, 1,
             "m2*L_kin*((F1 - F2)*alpha - (F1 + F2)*(1 - alpha))/(F1*M*alpha^2)/T"),
  NEW_STEADY("corrected_steady_xC_no_turn", "(28)", SCALLOP_NO_TURN_IN_CONTRACTION, SCALLOP_STEADY_DISPLACEMENT, 4,
             "m2*L_kin*((F1 - F2)*alpha - (F1 + F2)*(1 - alpha))/(F1*M*alpha^2)"),
  NEW_STEADY("corrected_steady_velocity_no_turn_extension", "(26), (27)", SCALLOP_NO_TURN_IN_EXTENSION,
             SCALLOP_STEADY_VELOCITY, 1, "m1*L_kin*((F2 - F1)*(1 - alpha) - (F1 + F2)*alpha)/(F2*M*(1 - alpha)^2)/T"),
  NEW_STEADY("corrected_steady_xC_no_turn_extension", "(28)", SCALLOP_NO_TURN_IN_EXTENSION, SCALLOP_STEADY_DISPLACEMENT, 4,
             "m1*L_kin*((F2 - F1)*(1 - alpha) - (F1 + F2)*alpha)/(F2*M*(1 - alpha)^2)"),
  { .name = NULL },
};
