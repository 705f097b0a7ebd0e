/* The CVODE integrator, if the program is built with SUNDIALS. */
#include "numerics/integrators/integrator.h"

#include <stddef.h>

#if !WITH_SUNDIALS
bool scallop_has_cvode(void) { return false; }

struct scallop_integrator *scallop_cvode_integrator(double tolerance)
{
  (void)tolerance;
  return NULL;
}
#else
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "numerics/integrators/integrator_motion.h"

#ifndef SUNDIALS_DOUBLE_PRECISION
#error "SUNDIALS is built for another precision than double"
#endif

#if SUNDIALS_VERSION_MAJOR < 6 /* without contexts */
typedef void *SUNContext;
#define N_VNew_Serial(length, context) N_VNew_Serial(length)
#define CVodeCreate(method, context) CVodeCreate(method)
#define SUNNonlinSol_FixedPoint(y, m, context) SUNNonlinSol_FixedPoint(y, m)
#endif

enum { DIMENSION = 2 };

struct cvode {
  struct scallop_integrator integrator; /* first member: a pointer to it is one to the struct */
  SUNContext context;
  N_Vector y; /* x1' and x1 */
  void *memory;
  SUNNonlinearSolver solver;
  double tolerance;
};

struct cvode_run {
  struct integrator_motion motion; /* first member: a pointer to it is one to the struct */
  const struct cvode *tools;
  bool let_go[2]; /* a body that was at rest at the start of the integration */
};

static int equation(double t, N_Vector y, N_Vector dydt, void *context)
{
  struct integrator_motion *m = context;
  m->phases.evaluations++;
  NV_Ith_S(dydt, 0) = integrator_acceleration(m, t);
  NV_Ith_S(dydt, 1) = NV_Ith_S(y, 0);
  return 0;
}

/* A root function that is zero where CVODE starts is left out of the search until CVODE sees it move; and a body that
 * has just been let go starts at zero. But it cannot be back before the forces turn on it, so until then its function
 * is far from zero; and from then on it is to fall behind zero by a tolerance, in case the forces have turned
 * already. */
static double slack(const struct cvode_run *r, double t, int body)
{
  if (!r->let_go[body])
    return 0;
  return integrator_ahead_rate(&r->motion, t, body) > 0 ? 1 : fmax(r->tools->tolerance, 4 * DBL_EPSILON);
}

static int velocities(double t, N_Vector y, double *ahead, void *context)
{
  const struct cvode_run *r = context;
  double v1 = NV_Ith_S(y, 0), v2 = v1 + integrator_gait_velocity(&r->motion, t);
  for (int body = 0; body < 2; body++)
    ahead[body] = integrator_ahead(&r->motion, v1, v2, body) + slack(r, t, body);
  return 0;
}

/* Restarts the integration at the current motion, without memory of earlier steps. */
static bool begin(struct cvode_run *r)
{
  const struct cvode *tools = r->tools;
  const struct integrator_motion *m = &r->motion;
  double v2 = m->y[0] + integrator_gait_velocity(m, m->t);
  for (int body = 0; body < 2; body++)
    r->let_go[body] = integrator_ahead(m, m->y[0], v2, body) <= 0;
  NV_Ith_S(tools->y, 0) = m->y[0];
  NV_Ith_S(tools->y, 1) = m->y[1];
  return CVodeReInit(tools->memory, m->t, tools->y) == CV_SUCCESS;
}

/* CVODE looks for a change of sign from step to step. It stops at the turning point of a velocity: a body cannot reach
 * zero and leave it within a step. */
static bool set_stop(const struct cvode_run *r, double end, double *stop)
{
  const struct integrator_motion *m = &r->motion;
  *stop = end;
  for (int body = 0; body < 2; body++)
    if (m->turn[body] > m->t && m->turn[body] < *stop)
      *stop = m->turn[body];
  return CVodeSetStopTime(r->tools->memory, *stop) == CV_SUCCESS;
}

/* To `stop` or the first event, whichever comes first: the body of that event, or -1. */
static int advance(struct cvode_run *r, double stop)
{
  struct integrator_motion *m = &r->motion;
  const struct cvode *tools = r->tools;
  int found[2] = { 0, 0 };
  while (integrator_motion_goes_on(m)) {
    int flag = CVode(tools->memory, stop, tools->y, &m->t, CV_ONE_STEP);
    m->phases.steps++;
    if (flag == CV_TOO_CLOSE) { /* a few units in the last place: nothing moves */
      m->t = stop;
      break;
    }
    if (flag < 0 || (flag == CV_ROOT_RETURN && CVodeGetRootInfo(tools->memory, found) != CV_SUCCESS)) {
      m->status = SCALLOP_ECONVERGE;
      return -1;
    }
    m->y[0] = NV_Ith_S(tools->y, 0);
    m->y[1] = NV_Ith_S(tools->y, 1);
    if (flag == CV_ROOT_RETURN)
      return found[0] != 0 ? 0 : 1;
    if (flag == CV_TSTOP_RETURN)
      break;
  }
  return -1;
}

/* Steps tried in vain since CVODE began. */
static bool count_rejected(struct integrator_motion *m, void *memory)
{
  long errors = 0, convergence = 0;
  bool known = CVodeGetNumErrTestFails(memory, &errors) == CV_SUCCESS
               && CVodeGetNumNonlinSolvConvFails(memory, &convergence) == CV_SUCCESS;
  m->phases.steps += errors + convergence;
  return known;
}

static int slide(struct integrator_motion *m, double end)
{
  struct cvode_run *r = (struct cvode_run *)m;
  int body = -1;
  double stop;
  bool heeded = begin(r); /* refused without memory only, and so the others */
  while (heeded && body < 0 && m->t < end && m->status == SCALLOP_OK) {
    heeded = set_stop(r, end, &stop);
    if (heeded)
      body = advance(r, stop);
  }
  if (!count_rejected(m, r->tools->memory) || !heeded)
    m->status = SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE */
  return body;
}

static enum scallop_status period(struct scallop_integrator *self, const struct scallop_crawler *crawler, double v0,
                                  const struct scallop_patience *patience, struct scallop_integrator_period *result)
{
  struct cvode *tools = (struct cvode *)self;
  struct cvode_run r = { .motion = { .slide = slide }, .tools = tools };
  if (CVodeSetUserData(tools->memory, &r) != CV_SUCCESS)
    return SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE */
  return integrator_motion_period(&r.motion, crawler, v0, patience, result);
}

#if SUNDIALS_VERSION_MAJOR < 7
static void say_nothing(int code, const char *module, const char *function, char *message, void *context)
{
  (void)code, (void)module, (void)function, (void)message, (void)context;
}
#endif

static bool create_context(struct cvode *r)
{
#if SUNDIALS_VERSION_MAJOR < 6
  return !r->context;
#elif SUNDIALS_VERSION_MAJOR < 7
  return SUNContext_Create(NULL, &r->context) == 0;
#else
  return SUNContext_Create(SUN_COMM_NULL, &r->context) == 0 && SUNContext_ClearErrHandlers(r->context) == 0;
#endif
}

static bool silence(void *memory)
{
#if SUNDIALS_VERSION_MAJOR < 7
  if (CVodeSetErrHandlerFn(memory, say_nothing, NULL) != CV_SUCCESS)
    return false; /* GCOVR_EXCL_LINE: refused without memory only */
#endif
  return CVodeSetMaxHnilWarns(memory, -1) == CV_SUCCESS && CVodeSetNoInactiveRootWarn(memory) == CV_SUCCESS;
}

static bool prepare(struct cvode *r)
{
  int falling[2] = { -1, -1 };
  r->y = create_context(r) ? N_VNew_Serial(DIMENSION, r->context) : NULL;
  if (!r->y)
    return false;
  N_VConst(0, r->y);
  r->memory = CVodeCreate(CV_ADAMS, r->context);
  r->solver = SUNNonlinSol_FixedPoint(r->y, 0, r->context);
  return r->memory && r->solver && CVodeInit(r->memory, equation, 0, r->y) == CV_SUCCESS
         && CVodeSetNonlinearSolver(r->memory, r->solver) == CV_SUCCESS
         && CVodeSStolerances(r->memory, r->tolerance, r->tolerance) == CV_SUCCESS
         && CVodeRootInit(r->memory, 2, velocities) == CV_SUCCESS
         && CVodeSetRootDirection(r->memory, falling) == CV_SUCCESS && silence(r->memory);
}

static void destroy(struct scallop_integrator *self)
{
  struct cvode *r = (struct cvode *)self;
  if (r->memory)
    CVodeFree(&r->memory);
  if (r->solver)
    (void)SUNNonlinSolFree(r->solver);
  if (r->y)
    N_VDestroy(r->y);
#if SUNDIALS_VERSION_MAJOR >= 6
  if (r->context)
    (void)SUNContext_Free(&r->context);
#endif
  free(r);
}

bool scallop_has_cvode(void) { return true; }

struct scallop_integrator *scallop_cvode_integrator(double tolerance)
{
  bool good = tolerance >= DBL_EPSILON && tolerance <= 0.1;
  struct cvode *r = good ? calloc(1, sizeof *r) : NULL;
  if (!r)
    return NULL;
  r->integrator = (struct scallop_integrator){ period, destroy };
  r->tolerance = tolerance;
  if (prepare(r))
    return &r->integrator;
  destroy(&r->integrator);
  return NULL;
}
#endif
