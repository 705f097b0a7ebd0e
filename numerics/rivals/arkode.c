/* ARKODE, where the program is built with SUNDIALS. */
#include "numerics/rivals/arkode.h"

#include <stddef.h>

#if !WITH_SUNDIALS
bool scallop_has_arkode(void) { return false; }

struct scallop_rival *scallop_arkode_rival(double tolerance)
{
  (void)tolerance;
  return NULL;
}
#else
#include <arkode/arkode_erkstep.h>

#include "numerics/rivals/sundials.h"

_Static_assert(ARK_SUCCESS == SUNDIALS_DONE && ARK_TSTOP_RETURN == SUNDIALS_AT_STOP
                   && ARK_ROOT_RETURN == SUNDIALS_AT_ROOT && ARK_TOO_CLOSE == SUNDIALS_TOO_CLOSE
                   && ARK_ONE_STEP == SUNDIALS_ONE_STEP,
               "numbers of ARKODE");

#if SUNDIALS_VERSION_MAJOR < 6
#define ERKStepCreate(equation, t, y, context) ERKStepCreate(equation, t, y)
#endif

/* From 7.1 on the calls that all steppers of ARKODE share have one name. */
#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 1)
#define ARKODE(call) ARKode##call
#else
#define ARKODE(call) ERKStep##call
#endif

/* Cash and Karp's method; roots are sought in its interpolant, of degree 4. At order 4, which the library takes by
 * itself, a tolerance of 1e-12 needs eight times as many steps. */
enum { ORDER = 5 };

static bool silence(void *memory)
{
#if SUNDIALS_VERSION_MAJOR < 7
  if (ERKStepSetErrHandlerFn(memory, sundials_be_silent, NULL) != ARK_SUCCESS)
    return false; /* GCOVR_EXCL_LINE: refused without memory only */
#endif
  return ARKODE(SetMaxHnilWarns)(memory, -1) == ARK_SUCCESS && ARKODE(SetNoInactiveRootWarn)(memory) == ARK_SUCCESS;
}

static bool create(struct sundials_rival *r)
{
  r->memory = ERKStepCreate(sundials_equation, 0, r->y, r->context);
  return r->memory && ARKODE(SetOrder)(r->memory, ORDER) == ARK_SUCCESS;
}

static int restart(void *memory, double t, N_Vector y) { return ERKStepReInit(memory, sundials_equation, t, y); }

bool scallop_has_arkode(void) { return true; }

struct scallop_rival *scallop_arkode_rival(double tolerance)
{
  static const struct sundials_calls calls = { .create = create,
                                               .restart = restart,
                                               .set_tolerances = ARKODE(SStolerances),
                                               .init_roots = ARKODE(RootInit),
                                               .set_directions = ARKODE(SetRootDirection),
                                               .silence = silence,
                                               .set_context = ARKODE(SetUserData),
                                               .set_stop = ARKODE(SetStopTime),
                                               .evolve = ARKODE(Evolve),
                                               .get_roots = ARKODE(GetRootInfo),
                                               .get_rejected = ARKODE(GetNumErrTestFails),
                                               .free = ARKODE(Free) };
  return sundials_make(&calls, tolerance);
}
#endif
