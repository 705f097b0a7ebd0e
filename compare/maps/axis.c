#include "compare/maps/maps.h"

#include <math.h>

double axis_value(struct axis a, double u)
{
  double from = a.varies->from.number, to = a.varies->to.number;
  if (u == 0 || u == 1)
    return u == 0 ? from : to;
  return a.varies->is_log ? from * pow(to / from, u) : from + u * (to - from);
}

double axis_scale(struct axis a)
{
  double from = a.varies->from.number, to = a.varies->to.number;
  return fabs(a.varies->is_log ? log(to / from) : (to - from) / fmax(from, to));
}

struct scallop_crawler axes_crawler(const struct axis axes[2], const struct scallop_crawler *base, double x, double y)
{
  struct scallop_crawler c = *base;
  const double value[] = { x, y };
  double froude = 0;
  for (int i = 0; i < 2; i++)
    switch (axes[i].varies->target) {
    case TARGET_F1_OVER_F2: c.F1 = value[i] * c.F2; break;
    case TARGET_M1_OVER_M2: c.m1 = value[i] * c.m2; break;
    case TARGET_FROUDE: froude = value[i]; break;
    default: *(axes[i].name[0] == 'T' ? &c.T : &c.alpha) = value[i]; break;
    }
  if (froude > 0)
    c.T = sqrt((c.m1 + c.m2) * c.L / ((c.F1 + c.F2) * froude));
  return c;
}
