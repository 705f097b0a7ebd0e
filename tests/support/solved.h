/* Answers of the solver where there must be one, what the modes are as text, and the same crawler seen otherwise.
 * Header-only. */
#ifndef SCALLOP_TESTS_SUPPORT_SOLVED_H
#define SCALLOP_TESTS_SUPPORT_SOLVED_H

#include "numerics/wide/wide.h"
#include "tests/support/check.h"

/* The call, which gives its answer to &out, is refused with this status, and touches nothing. */
#define REFUSES(answer, call, wanted) \
  do { \
    struct answer out, before; \
    memset(&before, 0xa5, sizeof before); \
    memcpy(&out, &before, sizeof out); \
    assert_int_equal(call, wanted); \
    assert_memory_equal(&out, &before, sizeof out); \
  } while (0)

/* The default crawler with this gait */
static inline struct scallop_crawler with_gait(const struct scallop_gait *gait)
{
  struct scallop_crawler c = scallop_crawler_default();
  c.gait = gait;
  return c;
}

/* The same gait, which does not say what it is: no short cut is taken */
static inline struct scallop_gait walked_gait(const struct scallop_gait *gait)
{
  struct scallop_gait copy = *gait;
  for (int kind = 0; kind < 2; kind++)
    copy.phase[kind].concave = copy.phase[kind].ramps = false;
  return copy;
}

static inline struct scallop_phase_result phase_of(const struct scallop_crawler *c, int kind, double v0)
{
  struct scallop_phase_result r;
  assert_int_equal(scallop_phase(c, (enum scallop_phase_kind)kind, v0, &r), SCALLOP_OK);
  return r;
}

static inline struct scallop_period_result period_of(const struct scallop_crawler *c, double v0)
{
  struct scallop_period_result r;
  assert_int_equal(scallop_period(c, v0, &r), SCALLOP_OK);
  return r;
}

static inline struct scallop_steady_result steady_of(const struct scallop_crawler *c)
{
  struct scallop_steady_result r;
  assert_int_equal(scallop_steady(c, &r), SCALLOP_OK);
  return r;
}

static inline void modes_are(const struct scallop_modes *modes, const char *wanted)
{
  char text[SCALLOP_MODES_TEXT];
  scallop_modes_text(modes, text);
  assert_string_equal(text, wanted);
}

static inline bool modes_alike(const struct scallop_modes *a, const struct scallop_modes *b)
{
  char text[2][SCALLOP_MODES_TEXT];
  scallop_modes_text(a, text[0]);
  scallop_modes_text(b, text[1]);
  return strcmp(text[0], text[1]) == 0;
}

/* "extension | contraction" */
enum { BOTH_MODES_TEXT = 2 * SCALLOP_MODES_TEXT + 4 };
static inline const char *both_modes(const struct scallop_modes modes[2], char both[BOTH_MODES_TEXT])
{
  scallop_modes_text(&modes[0], both);
  strcat(both, " | ");
  scallop_modes_text(&modes[1], both + strlen(both));
  return both;
}

static inline double wide_apart(const struct scallop_wide *a, const struct scallop_wide *b)
{
  return fabs((a->high - b->high) + (a->low - b->low));
}

struct units {
  double mass, length, time;
};

static inline struct scallop_crawler in_units(const struct scallop_crawler *c, const struct units *u)
{
  double force = u->mass * u->length / u->time / u->time;
  return (struct scallop_crawler){ c->m1 * u->mass,  c->m2 * u->mass, c->F1 * force, c->F2 * force,
                                   c->L * u->length, c->T * u->time,  c->alpha,      c->gait };
}

/* m1, m2, F1, F2, L, T, alpha */
enum { PARAMETERS = 7 };
static inline double *parameter(struct scallop_crawler *c, int i)
{
  double *const all[PARAMETERS] = { &c->m1, &c->m2, &c->F1, &c->F2, &c->L, &c->T, &c->alpha };
  return all[i];
}

static inline struct scallop_crawler exchanged(const struct scallop_crawler *c)
{
  return (struct scallop_crawler){ c->m2, c->m1, c->F2, c->F1, c->L, c->T, c->alpha, c->gait };
}

#endif
