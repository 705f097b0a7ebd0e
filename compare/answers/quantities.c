#include "compare/answers/quantities.h"

#include <string.h>

const struct quantity_row quantity_rows[NAMED_QUANTITIES] = {
  [Q_FROUDE] = { "froude", "1", "M L / (T^2 (F1 + F2))", OF_STEADY, false },
  [Q_V_START] = { "v_start", "L/T", "velocity of both bodies at the start of the extension", OF_STEADY, true },
  [Q_V_MID] = { "v_mid", "L/T", "velocity of both bodies at the start of the contraction", OF_STEADY, true },
  [Q_DISPLACEMENT] = { "displacement", "L", "displacement of the geometric centre over a period", OF_STEADY, true },
  [Q_MEAN_VELOCITY] = { "mean_velocity", "L/T", "displacement / T", OF_STEADY, true },
  [Q_MULTIPLIER] = { "multiplier", "1", "derivative of the period map: the factor by which a deviation decays in a period",
                     OF_STEADY, false },
  [Q_T1] = { "t1", "T", "first change of mode after the start of the phase; nan: the mode does not change", OF_PHASE, true },
  [Q_DT] = { "dT", "T", "from the last change of mode to the end of the phase; nan: the mode does not change", OF_PHASE,
             true },
  [Q_V_END] = { "v_end", "L/T", "velocity of both bodies at the end of the phase", OF_PHASE, true },
  [Q_DX1] = { "dx1", "L", "displacement of body 1", OF_PHASE, true },
  [Q_DX2] = { "dx2", "L", "displacement of body 2", OF_PHASE, true },
  [Q_DXC] = { "dxC", "L", "displacement of the geometric centre (x1 + x2)/2", OF_PHASE, true },
  [Q_FRICTION_WORK] = { "friction_work", "F L",
                        "energy that friction takes in a period: F1 and F2 times how far the bodies slide", OF_STEADY,
                        true },
  [Q_COST_OF_TRANSPORT] = { "cost_of_transport", "1",
                            "friction_work / ((F1 + F2) |displacement|); nan: the displacement is 0", OF_STEADY, true },
};

enum quantity_id quantity_first(enum quantity_of of)
{
  int q = 0;
  while (quantity_rows[q].of != of)
    q++;
  return (enum quantity_id)q;
}

enum quantity_id quantity_end(enum quantity_of of)
{
  int q = QUANTITIES;
  while (quantity_rows[q - 1].of != of)
    q--;
  return (enum quantity_id)q;
}

enum quantity_id quantity_of_name(const char *name)
{
  int q = 0;
  while (q < NAMED_QUANTITIES && strcmp(quantity_rows[q].name, name) != 0)
    q++;
  return (enum quantity_id)q;
}

enum quantity_id quantity_of_formula(const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  bool extension = kind == SCALLOP_EXTENSION;
  switch (f->quantity) {
  case SCALLOP_LAG: return Q_DT;
  case SCALLOP_FIRST_SWITCH: return Q_T1;
  case SCALLOP_REAR_AT_FIRST: return Q_AT_FIRST;
  case SCALLOP_REAR_AT_LAST: return Q_AT_LAST;
  case SCALLOP_REAR_AT_END: return extension ? Q_DX1 : Q_DX2;
  case SCALLOP_FRONT_AT_END: return extension ? Q_DX2 : Q_DX1;
  case SCALLOP_CENTRE_AT_END: return Q_DXC;
  case SCALLOP_VELOCITY_AT_END: return Q_V_END;
  case SCALLOP_VELOCITY_CHANGE: return Q_CHANGE;
  case SCALLOP_STEADY_VELOCITY: return Q_V_START;
  case SCALLOP_STEADY_DISPLACEMENT: return Q_DISPLACEMENT;
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: break;
  }
  return Q_TURNING;
}

const char *formula_quantity_text(const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  static const char *const of_contraction[] = { "dT",    "t1",     "x2(t1)", "x2(T-dT)", "x2(T)",
                                                "x1(T)", "x_C(T)", "v(T)",   "v(T)-v0" };
  static const char *const of_extension[] = {
    "dT", "t1", "x1(t1)", "x1(T-dT)", "x1(T)", "x2(T)", "x_C(T)", "v(T)", "v(T)-v0"
  };
  if (f->quantity == SCALLOP_VELOCITY_AT_FIRST || f->quantity == SCALLOP_VELOCITY_AT_LAST)
    return f->quantity == SCALLOP_VELOCITY_AT_FIRST ? "v(t1)" : "v(T-dT)";
  if (f->setting == SCALLOP_STEADY)
    return f->quantity == SCALLOP_STEADY_VELOCITY ? "v_start" : "displacement";
  return (kind == SCALLOP_EXTENSION ? of_extension : of_contraction)[f->quantity];
}

bool formula_takes_given(const struct scallop_formula *f)
{
  return strstr(f->text, "t1") || strstr(f->text, "dT") || strstr(f->text, "x_switch");
}
