/* What the rivals on SUNDIALS share: the context, the vector of the state, the equation of motion, its events as roots,
 * and the way from one event to the next. A rival brings the calls of its integrator. Only where the program is built
 * with SUNDIALS, whose headers this one needs. Private to the rivals. */
#ifndef SCALLOP_NUMERICS_RIVALS_SUNDIALS_H
#define SCALLOP_NUMERICS_RIVALS_SUNDIALS_H

#include <nvector/nvector_serial.h>
#include <sundials/sundials_nonlinearsolver.h>

#include "numerics/rivals/rival.h"

#ifndef SUNDIALS_DOUBLE_PRECISION
#error "SUNDIALS is built for another precision than double"
#endif

#if SUNDIALS_VERSION_MAJOR < 6 /* there were no contexts */
typedef void *SUNContext;
#define N_VNew_Serial(length, context) N_VNew_Serial(length)
#endif

/* All integrators of SUNDIALS have the same numbers for what a call returns, and for the task of one step. */
enum { SUNDIALS_DONE = 0, SUNDIALS_AT_STOP = 1, SUNDIALS_AT_ROOT = 2, SUNDIALS_TOO_CLOSE = -27 };
enum { SUNDIALS_ONE_STEP = 2 };

struct sundials_rival {
  struct scallop_rival rival; /* first, so that the one is the other */
  const struct sundials_calls *calls;
  SUNContext context;
  N_Vector y;                /* x1' and x1                                     */
  void *memory;              /* of the integrator                              */
  SUNNonlinearSolver solver; /* of an implicit method; NULL: it needs none     */
  double tolerance;
};

/* The calls of an integrator, as the library has them behind its prefix; SUNDIALS_DONE is success. */
struct sundials_calls {
  bool (*create)(
      struct sundials_rival *rival); /* memory and solver, ready to restart; whatever it made is freed later */
  int (*restart)(void *memory, double t, N_Vector y);
  int (*set_tolerances)(void *memory, double relative, double absolute);
  int (*init_roots)(void *memory, int count, int (*roots)(double t, N_Vector y, double *value, void *context));
  int (*set_directions)(void *memory, int *direction);
  bool (*silence)(void *memory); /* after init_roots */
  int (*set_context)(void *memory, void *context);
  int (*set_stop)(void *memory, double stop);
  int (*evolve)(void *memory, double end, N_Vector y, double *t, int task);
  int (*get_roots)(void *memory, int *found);
  int (*get_rejected)(void *memory, long *count); /* steps tried in vain since the restart */
  void (*free)(void **memory);
};

/* y' by the equation of motion; context: that of set_context. */
int sundials_equation(double t, N_Vector y, N_Vector dydt, void *context);

#if SUNDIALS_VERSION_MAJOR < 7
/* In place of the library's messages; later versions have them by context, which sundials_make has silenced. */
void sundials_be_silent(int code, const char *module, const char *function, char *message, void *context);
#endif

/* NULL: not DBL_EPSILON <= tolerance <= 0.1, or memory is short. */
struct scallop_rival *sundials_make(const struct sundials_calls *calls, double tolerance);

#endif
