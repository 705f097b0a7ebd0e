#include "numerics/event/held.h"

static void modes_of_phase(enum scallop_phase_kind kind, int starts, int ends, bool stuck, bool held,
                           struct scallop_modes *modes)
{
  struct scallop_mode *m = modes->kept, opposite = { -1, 1 };
  if (kind == SCALLOP_CONTRACTION)
    opposite = (struct scallop_mode){ 1, -1 };
  if (starts != 0)
    *m++ = (struct scallop_mode){ (signed char)starts, (signed char)starts };
  if (!stuck)
    *m++ = opposite;
  *m = (struct scallop_mode){ (signed char)ends, (signed char)ends };
  if (held && opposite.s1 != ends) /* it is the other body that goes on */
    m->s1 = 0;
  else if (held)
    m->s2 = 0;
  modes->count = (int)(m - modes->kept) + 1;
}

void held_modes(const double starts[2], const double ends[2], const double stuck[2], const double grip[2],
                struct scallop_modes modes[2])
{
  for (int kind = 0; kind < 2; kind++)
    modes_of_phase((enum scallop_phase_kind)kind, (int)starts[kind], (int)ends[kind], stuck[kind] > 0, grip[kind] >= 0,
                   &modes[kind]);
}

/* One body is stuck throughout: the same in both phases, which is at the rear in one and in front in the other. */
enum scallop_regime held_regime(const double starts[2], const double ends[2], const double stuck[2])
{
  bool never_moves = starts[0] == 0 && starts[1] == 0 && stuck[0] > 0 && stuck[1] > 0 && ends[0] == -ends[1];
  return never_moves ? SCALLOP_AT_REST : SCALLOP_STICK_SLIP;
}
