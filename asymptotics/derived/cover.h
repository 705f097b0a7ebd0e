/* The proof that a branch is analytic up to its nearest branch points, and the search for these. Not public:
 * singularity.h is. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_COVER_H
#define SCALLOP_ASYMPTOTICS_DERIVED_COVER_H

#include "asymptotics/derived/continuation.h"

/* Part of the proof: for |z| up to r, in the directions from `from` pi to `to` pi, the branch is an analytic function
 * of z. */
struct sector {
  double r, step, from, to;
  double looked;      /* the step at which a branch point was last looked for                         */
  acb_ptr at, around; /* v at r in the middle direction, and a box in which it is the only solution for all of them */
};

enum { MOST_SECTORS = 4096, MOST_FOLDS = 8, MOST_PLACES = 64, MOST_WORK = 2500000, CELL_BITS = 64 };
struct search {
  const struct continuation *apart, *joined; /* without and with joined crossings                     */
  slong n, precision;
  double last;   /* direction over pi: the others mirror those from 0 to here                          */
  double disc;   /* proven around z = 0                                                               */
  acb_ptr start; /* and the box there                                                                 */
  struct sector sector[MOST_SECTORS];
  int sectors;
  struct fold fold[MOST_FOLDS]; /* those that the branch meets                                        */
  int folds;
  acb_ptr place; /* z of all that were found                                                          */
  int places;
  double reach; /* |z| of the nearest, rounded up                                                     */
};

/* both: the equations without and with joined crossings; last: the direction over pi that the others mirror */
struct search *search_new(const struct continuation both[2], double last, slong precision);
void search_free(struct search *s);
/* Carries that sector on which has come least far, until all reach the nearest fold. Returns |z| up to where the proof
 * has come. */
double search_cover(struct search *s);

#endif
