/* What the formulas share. Not public. */
#ifndef SCALLOP_TERMS_H
#define SCALLOP_TERMS_H

#include "asymptotics/asymptotics.h"

typedef const struct scallop_phase_point point;

static inline double mass(point *p) { return p->m1 + p->m2; }
static inline double drive(point *p) { return (p->F1 - p->F2) / mass(p); }
static inline double cube(double x) { return x * x * x; }

#endif
