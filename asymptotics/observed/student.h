/* Quantiles of Student's t. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_STUDENT_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_STUDENT_H

/* The t > 0 with P(|T| <= t) = share, for 0 < share < 1 and dof >= 1 degrees of freedom, to 2e-14 t. The probability is
 * the finite sum in theta = atan(t/sqrt(dof)) that holds for whole dof (Abramowitz & Stegun 26.7.3 and 26.7.4); beyond
 * 200 degrees of freedom t is the expansion in 1/dof about the normal quantile (26.7.5), to 2e-11 t for share <=
 * 0.999. */
double student_quantile(double share, long dof);

#endif
