/* Values of the names in formulas, in double. */
#include "asymptotics/asymptotics.h"

#include <math.h>
#include <stddef.h>

#define SYMBOL_NAME(name) #name,
const char *const scallop_symbol_names[SCALLOP_SYMBOLS] = { SCALLOP_SYMBOL_LIST(SYMBOL_NAME) };
#define QUANTITY_WORD(word, name) #word,
const char *const scallop_quantity_words[SCALLOP_QUANTITIES] = { SCALLOP_QUANTITY_LIST(QUANTITY_WORD) };

/* Sets l'' and l'''' at the ends, and L_kin. */
static void set_shape(double *of, const struct scallop_crawler *c, enum scallop_phase_kind kind)
{
  const struct scallop_shape *shape = &c->gait->phase[kind];
  of[SCALLOP_SYMBOL_l0] = shape->l0 * c->L;
  of[SCALLOP_SYMBOL_lT] = shape->lT * c->L;
  of[SCALLOP_SYMBOL_k0] = scallop_fourth_derivative(shape, false) * c->L;
  of[SCALLOP_SYMBOL_kT] = scallop_fourth_derivative(shape, true) * c->L;
  of[SCALLOP_SYMBOL_L_kin] = scallop_kinematic_length(c->gait, kind, c->L);
}

static struct scallop_values values_of(const struct scallop_crawler *c, enum scallop_phase_kind kind, double T,
                                       double v0)
{
  struct scallop_values values = { .of = { [SCALLOP_SYMBOL_m1] = c->m1,
                                           [SCALLOP_SYMBOL_m2] = c->m2,
                                           [SCALLOP_SYMBOL_F1] = c->F1,
                                           [SCALLOP_SYMBOL_F2] = c->F2,
                                           [SCALLOP_SYMBOL_M] = c->m1 + c->m2,
                                           [SCALLOP_SYMBOL_L] = c->L,
                                           [SCALLOP_SYMBOL_alpha] = c->alpha,
                                           [SCALLOP_SYMBOL_T] = T,
                                           [SCALLOP_SYMBOL_v0] = v0,
                                           [SCALLOP_SYMBOL_t1] = NAN,
                                           [SCALLOP_SYMBOL_dT] = NAN,
                                           [SCALLOP_SYMBOL_x_switch] = NAN } };
  values.of[kind == SCALLOP_EXTENSION ? SCALLOP_SYMBOL_l_end : SCALLOP_SYMBOL_l_start] = c->L;
  set_shape(values.of, c, kind);
  return values;
}

struct scallop_values scallop_phase_values(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0)
{
  return values_of(c, kind, scallop_phase_duration(c, kind), v0);
}

struct scallop_values scallop_steady_values(const struct scallop_crawler *c)
{
  return values_of(c, SCALLOP_EXTENSION, c->T, NAN);
}

enum scallop_symbol scallop_symbol_exchanged(enum scallop_symbol symbol, int *sign)
{
  *sign = 1;
  switch (symbol) {
  case SCALLOP_SYMBOL_m1: return SCALLOP_SYMBOL_m2;
  case SCALLOP_SYMBOL_m2: return SCALLOP_SYMBOL_m1;
  case SCALLOP_SYMBOL_F1: return SCALLOP_SYMBOL_F2;
  case SCALLOP_SYMBOL_F2: return SCALLOP_SYMBOL_F1;
  case SCALLOP_SYMBOL_l_start: return SCALLOP_SYMBOL_l_end;
  case SCALLOP_SYMBOL_l_end: return SCALLOP_SYMBOL_l_start;
  case SCALLOP_SYMBOL_l0:
  case SCALLOP_SYMBOL_lT:
  case SCALLOP_SYMBOL_k0:
  case SCALLOP_SYMBOL_kT: *sign = -1; return symbol;
  default: return symbol;
  }
}

struct scallop_values scallop_exchanged(const struct scallop_values *values)
{
  struct scallop_values exchanged;
  for (int i = 0, sign; i < SCALLOP_SYMBOLS; i++) {
    enum scallop_symbol meant = scallop_symbol_exchanged((enum scallop_symbol)i, &sign);
    exchanged.of[i] = sign * values->of[meant];
  }
  return exchanged;
}
