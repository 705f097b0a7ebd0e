/* CVODE, where the program is built with SUNDIALS. */
#include "numerics/rivals/cvode.h"

#include <stddef.h>

#if !WITH_SUNDIALS
bool scallop_has_cvode(void) { return false; }

struct scallop_rival *scallop_cvode_rival(double tolerance)
{
  (void)tolerance;
  return NULL;
}
#else
#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "numerics/rivals/sundials.h"

_Static_assert(CV_SUCCESS == SUNDIALS_DONE && CV_TSTOP_RETURN == SUNDIALS_AT_STOP && CV_ROOT_RETURN == SUNDIALS_AT_ROOT
                   && CV_TOO_CLOSE == SUNDIALS_TOO_CLOSE && CV_ONE_STEP == SUNDIALS_ONE_STEP,
               "numbers of CVODE");

#if SUNDIALS_VERSION_MAJOR < 6
#define CVodeCreate(method, context) CVodeCreate(method)
#define SUNNonlinSol_FixedPoint(y, m, context) SUNNonlinSol_FixedPoint(y, m)
#endif

static bool silence(void *memory)
{
#if SUNDIALS_VERSION_MAJOR < 7
  if (CVodeSetErrHandlerFn(memory, sundials_be_silent, NULL) != CV_SUCCESS)
    return false; /* GCOVR_EXCL_LINE: refused without memory only */
#endif
  return CVodeSetMaxHnilWarns(memory, -1) == CV_SUCCESS && CVodeSetNoInactiveRootWarn(memory) == CV_SUCCESS;
}

static bool create(struct sundials_rival *r)
{
  r->memory = CVodeCreate(CV_ADAMS, r->context);
  r->solver = SUNNonlinSol_FixedPoint(r->y, 0, r->context);
  return r->memory && r->solver && CVodeInit(r->memory, sundials_equation, 0, r->y) == CV_SUCCESS
         && CVodeSetNonlinearSolver(r->memory, r->solver) == CV_SUCCESS;
}

static int get_rejected(void *memory, long *count)
{
  long errors = 0, convergence = 0;
  int flag = CVodeGetNumErrTestFails(memory, &errors);
  if (flag == CV_SUCCESS)
    flag = CVodeGetNumNonlinSolvConvFails(memory, &convergence);
  *count = errors + convergence;
  return flag;
}

bool scallop_has_cvode(void) { return true; }

struct scallop_rival *scallop_cvode_rival(double tolerance)
{
  static const struct sundials_calls calls = { .create = create,
                                               .restart = CVodeReInit,
                                               .set_tolerances = CVodeSStolerances,
                                               .init_roots = CVodeRootInit,
                                               .set_directions = CVodeSetRootDirection,
                                               .silence = silence,
                                               .set_context = CVodeSetUserData,
                                               .set_stop = CVodeSetStopTime,
                                               .evolve = CVode,
                                               .get_roots = CVodeGetRootInfo,
                                               .get_rejected = get_rejected,
                                               .free = CVodeFree };
  return sundials_make(&calls, tolerance);
}
#endif
