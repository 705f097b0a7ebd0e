#include "compare/answers/quantities.h"

#include <string.h>

const struct quantity_row quantity_rows[QUANTITIES] = {
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
  while (q < QUANTITIES && strcmp(quantity_rows[q].name, name) != 0)
    q++;
  return (enum quantity_id)q;
}
