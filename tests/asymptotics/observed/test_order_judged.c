/* Tables of real methods, each judged by a person before the estimator saw it: finite differences, quadrature, and ODE
 * solvers (GSL's). */
#include "tests/support/check.h"

#include <stdlib.h>

#include "asymptotics/observed/order.h"

enum { MOST = 24 };
enum judgement { PASS, FAIL, PLATEAU }; /* FAIL: anything but a pass */

static const struct {
  const char *name;
  double expected;
  enum judgement judgement;
  bool differs; /* the estimator judges otherwise */
  const char *because, *rows;
} tables[] = {
  { "forward difference of exp at 1", 1, PASS, false, "slope 1 over six decades; then roundoff, which grows as 1/h",
    "0.1 1.406e-01  0.01 1.364e-02  0.001 1.360e-03  0.0001 1.359e-04  1e-05 1.359e-05  1e-06 1.359e-06 "
    "1e-07 1.399e-07  1e-08 6.603e-09  1e-09 2.154e-07  1e-10 1.548e-06  1e-11 3.263e-05  1e-12 4.323e-04 "
    "1e-13 4.559e-04  1e-14 9.338e-03 " },
  { "central difference of sin at 1", 2, PASS, false, "slope 2 down to 1e-11; then roundoff",
    "0.5 2.2233e-02  0.25 5.6106e-03  0.125 1.4059e-03  0.0625 3.5169e-04  0.03125 8.7936e-05  0.015625 "
    "2.1985e-05  0.0078125 5.4962e-06  0.00390625 1.3741e-06  0.001953125 3.4351e-07  0.0009765625 8.5879e-08 "
    "0.00048828125 2.1470e-08  0.000244140625 5.3673e-09  0.0001220703125 1.3417e-09  6.103515625e-05 "
    "3.3579e-10  3.051757812e-05 8.3860e-11  1.525878906e-05 2.2014e-11  7.629394531e-06 1.8607e-13 "
    "3.814697266e-06 7.0899e-12  1.907348633e-06 7.4620e-12  9.536743164e-07 2.1642e-11  4.768371582e-07 "
    "3.6566e-11  2.384185791e-07 1.5298e-10 " },
  { "trapezoidal rule, sqrt on [0, 1]", 1.5, PASS, false, "the orders settle slowly: 1.45, 1.47, ... 1.50",
    "0.25 2.338e-02  0.125 8.536e-03  0.0625 3.085e-03  0.03125 1.108e-03  0.015625 3.959e-04  0.0078125 "
    "1.410e-04  0.00390625 5.012e-05  0.001953125 1.779e-05  0.0009765625 6.304e-06  0.00048828125 2.233e-06 " },
  { "Simpson's rule, exp on [0, 1]", 4, PASS, false, "slope 4 down to roundoff",
    "0.5 5.793e-04  0.25 3.701e-05  0.125 2.326e-06  0.0625 1.456e-07  0.03125 9.103e-09  0.015625 5.690e-10 "
    "0.0078125 3.556e-11  0.00390625 2.222e-12  0.001953125 1.383e-13  0.0009765625 9.548e-15  0.00048828125 "
    "4.441e-16  0.000244140625 6.661e-16  0.0001220703125 2.442e-15 " },
  { "trapezoidal rule, exp(2 cos x) over its period", 2, FAIL, false, "spectral: the orders rise without limit",
    "2.0944 2.694e+00  1.5708 6.378e-01  1.25664 1.235e-01  1.0472 2.011e-02  0.897598 2.823e-03  0.785398 "
    "3.481e-04  0.698132 3.825e-05 " },
  { "Runge-Kutta (4), pendulum, t = 10", 4, PASS, false, "5.8, 5.1, 2.6 and then 3.6, 3.84, 3.93, 3.95: settles at 4",
    "1 6.11e-03  0.5 1.06e-04  0.25 3.04e-06  0.125 4.98e-07  0.0625 4.07e-08  0.03125 2.85e-09  0.015625 "
    "1.87e-10  0.0078125 1.21e-11 " },
  { "Runge-Kutta-Fehlberg (4, 5), Lotka-Volterra, error against tolerance", 1, PASS, false,
    "slope 1 over eight decades, with some scatter",
    "0.001 2.77e-02  0.0001 2.39e-03  1e-05 9.48e-05  1e-06 1.03e-05  1e-07 1.30e-06  1e-08 1.39e-07  1e-09 "
    "1.65e-08  1e-10 1.74e-09  1e-11 1.95e-10 " },
  { "Dormand-Prince (8, 9), the same", 1, PASS, false, "slope 1 over eight decades, with more scatter",
    "0.001 4.22e-04  0.0001 1.97e-05  1e-05 7.88e-06  1e-06 4.83e-07  1e-07 6.30e-08  1e-08 3.92e-09  1e-09 "
    "4.33e-10  1e-10 3.35e-11  1e-11 2.47e-12 " },
  { "midpoint rule across a jump at 1/pi, signed", 1, FAIL, false, "erratic: no order can be told",
    "0.1 6.064e-03  0.05 6.491e-03  0.025 -2.573e-03  0.0125 2.146e-03  0.00625 -1.673e-04  0.003125 "
    "-1.656e-04  0.0015625 -1.652e-04  0.00078125 1.277e-04  0.000390625 -1.856e-05  0.0001953125 -1.855e-05 "
    "9.765625e-05 1.805e-05 " },
  { "explicit Euler, stiff: y' = -50 (y - cos t)", 1, PASS, false, "unstable at the two coarsest steps; then slope 1",
    "0.1 1.049e+06  0.05 3.326e+03  0.025 1.416e-04  0.0125 7.124e-05  0.00625 3.573e-05  0.003125 1.789e-05 "
    "0.0015625 8.951e-06  0.00078125 4.477e-06  0.000390625 2.239e-06  0.0001953125 1.120e-06 " },
  { "boundary value problem, h^2 inside, a first-order condition at the end with a small factor", 2, FAIL, false,
    "2.1, 2.3, 1.4, 1.0, 1.0, 1.0: the first-order term takes over",
    "0.125 7.1401e-05  0.0625 1.6620e-05  0.03125 3.4731e-06  0.015625 1.3089e-06  0.0078125 6.5586e-07 "
    "0.00390625 3.2828e-07  0.001953125 1.6423e-07  0.0009765625 8.2137e-08 " },
  { "Runge-Kutta (4), pendulum, against a reference that is off by 4e-7", 4, PLATEAU, false,
    "falls as h^4, and then stays",
    "0.5 1.06e-04  0.25 2.68e-06  0.125 1.37e-07  0.0625 3.21e-07  0.03125 3.59e-07  0.015625 3.61e-07 "
    "0.0078125 3.61e-07 " },
  { "trapezoidal rule, x log x on [0, 1]", 2, FAIL, false, "1.79, 1.82, ... 1.89, 1.90: h^2 log h",
    "0.25 2.2773e-02  0.125 6.5947e-03  0.0625 1.8743e-03  0.03125 5.2497e-04  0.015625 1.4534e-04  0.0078125 "
    "3.9861e-05  0.00390625 1.0847e-05  0.001953125 2.9320e-06  0.0009765625 7.8809e-07 " },
  { "Runge-Kutta (4) across a kink of the right-hand side, signed", 3, PASS, true,
    "|err| falls as h^3; the sign depends on where the kink lies in its step",
    "0.2 -1.491e-05  0.1 1.911e-06  0.05 -2.359e-07  0.025 2.967e-08  0.0125 -3.698e-09  0.00625 4.629e-10 "
    "0.003125 -5.782e-11  0.0015625 7.237e-12 " },
  { "Runge-Kutta (2, 3), Lotka-Volterra, t = 20", 3, PASS, false, "3.3, 2.6, 2.95, 3.01, 3.01, 3.01: settles at 3",
    "0.4 8.005e-02  0.2 7.903e-03  0.1 1.347e-03  0.05 1.739e-04  0.025 2.160e-05  0.0125 2.678e-06  0.00625 "
    "3.329e-07 " },
};

TEST(as_a_person_judges)
{
  for (size_t k = 0; k < sizeof tables / sizeof *tables; k++) {
    struct scallop_order_point points[MOST];
    struct scallop_order_wanted wanted = { .order = tables[k].expected, .tolerance = 0.1 };
    struct scallop_order_result result;
    int count = 0;
    char *at = (char *)tables[k].rows;
    for (double h; (h = strtod(at, &at)) > 0; count++)
      points[count] = (struct scallop_order_point){ .h = h, .err = strtod(at, &at) };
    scallop_order(points, &count, &wanted, &result);
    enum judgement judgement = result.verdict == SCALLOP_ORDER_PASS      ? PASS
                               : result.verdict == SCALLOP_ORDER_PLATEAU ? PLATEAU
                                                                         : FAIL;
    bool same = judgement == tables[k].judgement || (tables[k].judgement == FAIL && judgement != PASS);
    if (same == tables[k].differs)
      fail_msg("%s (%s): %s: %s", tables[k].name, tables[k].because, scallop_order_verdict_text(result.verdict),
               result.reason);
  }
}
