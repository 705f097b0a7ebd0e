#if WITH_SUNDIALS
#include "numerics/rivals/sundials.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "numerics/rivals/rival_motion.h"

enum { DIMENSION = 2 };

struct run {
  struct rival_motion motion; /* first, so that the one is the other */
  const struct sundials_rival *tools;
  bool let_go[2]; /* a body that was at rest where the integration began */
};

int sundials_equation(double t, N_Vector y, N_Vector dydt, void *context)
{
  struct rival_motion *m = context;
  m->phases.evaluations++;
  NV_Ith_S(dydt, 0) = rival_acceleration(m, t);
  NV_Ith_S(dydt, 1) = NV_Ith_S(y, 0);
  return 0;
}

/* A root function that is zero where SUNDIALS starts is left out of the search until SUNDIALS sees it move; and a body
 * that has just been let go starts at zero. But it cannot be back before the forces turn on it, so until then its
 * function is far from zero; and from then on it is to fall behind zero by a tolerance, in case the forces have turned
 * already. */
static double slack(const struct run *r, double t, int body)
{
  if (!r->let_go[body])
    return 0;
  return rival_ahead_rate(&r->motion, t, body) > 0 ? 1 : fmax(r->tools->tolerance, 4 * DBL_EPSILON);
}

static int velocities(double t, N_Vector y, double *ahead, void *context)
{
  const struct run *r = context;
  double v1 = NV_Ith_S(y, 0), v2 = v1 + rival_gait_velocity(&r->motion, t);
  for (int body = 0; body < 2; body++)
    ahead[body] = rival_ahead(&r->motion, v1, v2, body) + slack(r, t, body);
  return 0;
}

/* From where the motion stands, with no memory of what was before. */
static bool begin(struct run *r)
{
  const struct sundials_rival *tools = r->tools;
  const struct rival_motion *m = &r->motion;
  double v2 = m->y[0] + rival_gait_velocity(m, m->t);
  for (int body = 0; body < 2; body++)
    r->let_go[body] = rival_ahead(m, m->y[0], v2, body) <= 0;
  NV_Ith_S(tools->y, 0) = m->y[0];
  NV_Ith_S(tools->y, 1) = m->y[1];
  return tools->calls->restart(tools->memory, m->t, tools->y) == SUNDIALS_DONE;
}

/* SUNDIALS looks for a change of sign from step to step. So that no body can come to zero and be off again within one,
 * it stops where a velocity turns. */
static bool set_stop(const struct run *r, double end, double *stop)
{
  const struct rival_motion *m = &r->motion;
  *stop = end;
  for (int body = 0; body < 2; body++)
    if (m->turn[body] > m->t && m->turn[body] < *stop)
      *stop = m->turn[body];
  return r->tools->calls->set_stop(r->tools->memory, *stop) == SUNDIALS_DONE;
}

/* To `stop` or the first event, whichever comes first: the body of that event, or -1. */
static int advance(struct run *r, double stop)
{
  struct rival_motion *m = &r->motion;
  const struct sundials_rival *tools = r->tools;
  int found[2] = { 0, 0 };
  while (rival_motion_goes_on(m)) {
    int flag = tools->calls->evolve(tools->memory, stop, tools->y, &m->t, SUNDIALS_ONE_STEP);
    m->phases.steps++;
    if (flag == SUNDIALS_TOO_CLOSE) { /* a few units in the last place: nothing moves */
      m->t = stop;
      break;
    }
    if (flag < 0 || (flag == SUNDIALS_AT_ROOT && tools->calls->get_roots(tools->memory, found) != SUNDIALS_DONE)) {
      m->status = SCALLOP_ECONVERGE;
      return -1;
    }
    m->y[0] = NV_Ith_S(tools->y, 0);
    m->y[1] = NV_Ith_S(tools->y, 1);
    if (flag == SUNDIALS_AT_ROOT)
      return found[0] != 0 ? 0 : 1;
    if (flag == SUNDIALS_AT_STOP)
      break;
  }
  return -1;
}

static int slide(struct rival_motion *m, double end)
{
  struct run *r = (struct run *)m;
  int body = -1;
  double stop;
  long rejected = 0;
  if (!begin(r))
    m->status = SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE: refused without memory only, and so the three below */
  while (body < 0 && m->t < end && m->status == SCALLOP_OK) {
    if (!set_stop(r, end, &stop))
      m->status = SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE */
    else
      body = advance(r, stop);
  }
  if (r->tools->calls->get_rejected(r->tools->memory, &rejected) != SUNDIALS_DONE)
    m->status = SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE */
  m->phases.steps += rejected;
  return body;
}

static enum scallop_status period(struct scallop_rival *self, const struct scallop_crawler *crawler, double v0,
                                  const struct scallop_patience *patience, struct scallop_rival_period *result)
{
  struct sundials_rival *tools = (struct sundials_rival *)self;
  struct run r = { .motion = { .slide = slide }, .tools = tools };
  if (tools->calls->set_context(tools->memory, &r) != SUNDIALS_DONE)
    return SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE */
  return rival_motion_period(&r.motion, crawler, v0, patience, result);
}

#if SUNDIALS_VERSION_MAJOR < 7
void sundials_be_silent(int code, const char *module, const char *function, char *message, void *context)
{
  (void)code, (void)module, (void)function, (void)message, (void)context;
}
#endif

static bool create_context(struct sundials_rival *r)
{
#if SUNDIALS_VERSION_MAJOR < 6
  return !r->context;
#elif SUNDIALS_VERSION_MAJOR < 7
  return SUNContext_Create(NULL, &r->context) == 0;
#else
  return SUNContext_Create(SUN_COMM_NULL, &r->context) == 0 && SUNContext_ClearErrHandlers(r->context) == 0;
#endif
}

static bool watch(const struct sundials_rival *r)
{
  int falling[2] = { -1, -1 };
  return r->calls->init_roots(r->memory, 2, velocities) == SUNDIALS_DONE
         && r->calls->set_directions(r->memory, falling) == SUNDIALS_DONE && r->calls->silence(r->memory);
}

static bool prepare(struct sundials_rival *r)
{
  r->y = create_context(r) ? N_VNew_Serial(DIMENSION, r->context) : NULL;
  if (!r->y)
    return false;
  N_VConst(0, r->y);
  return r->calls->create(r) && r->calls->set_tolerances(r->memory, r->tolerance, r->tolerance) == SUNDIALS_DONE
         && watch(r);
}

static void destroy(struct scallop_rival *self)
{
  struct sundials_rival *r = (struct sundials_rival *)self;
  if (r->memory)
    r->calls->free(&r->memory);
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

struct scallop_rival *sundials_make(const struct sundials_calls *calls, double tolerance)
{
  bool good = tolerance >= DBL_EPSILON && tolerance <= 0.1;
  struct sundials_rival *r = good ? calloc(1, sizeof *r) : NULL;
  if (!r)
    return NULL;
  r->rival = (struct scallop_rival){ period, destroy };
  r->calls = calls;
  r->tolerance = tolerance;
  if (prepare(r))
    return &r->rival;
  destroy(&r->rival);
  return NULL;
}
#endif
