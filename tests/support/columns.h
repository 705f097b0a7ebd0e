/* Many crawlers column by column, as the batch calls take them, and one of them alone. Header-only. */
#ifndef SCALLOP_TESTS_SUPPORT_COLUMNS_H
#define SCALLOP_TESTS_SUPPORT_COLUMNS_H

#include "numerics/numerics.h"

enum { MOST_ROWS = 4000 };

struct columns {
  double m1[MOST_ROWS], m2[MOST_ROWS], F1[MOST_ROWS], F2[MOST_ROWS], L[MOST_ROWS], T[MOST_ROWS], alpha[MOST_ROWS];
  const struct scallop_gait *gait[MOST_ROWS];
};

static inline void columns_put(struct columns *in, long i, const struct scallop_crawler *c)
{
  in->m1[i] = c->m1;
  in->m2[i] = c->m2;
  in->F1[i] = c->F1;
  in->F2[i] = c->F2;
  in->L[i] = c->L;
  in->T[i] = c->T;
  in->alpha[i] = c->alpha;
  in->gait[i] = c->gait;
}

static inline struct scallop_crawler columns_row(const struct columns *in, long i)
{
  return (struct scallop_crawler){ in->m1[i], in->m2[i], in->F1[i],    in->F2[i],
                                   in->L[i],  in->T[i],  in->alpha[i], in->gait[i] };
}

static inline struct scallop_crawlers columns_all(const struct columns *in, long count)
{
  return (struct scallop_crawlers){ count, in->m1, in->m2, in->F1, in->F2, in->L, in->T, in->alpha, in->gait };
}

#endif
