/* Crawlers that differ in one number, and what is proven of their mean velocity. Needs FLINT. Not public. */
#ifndef SCALLOP_COMPARE_CLAIMS_FAMILY_H
#define SCALLOP_COMPARE_CLAIMS_FAMILY_H

#include "compare/claims/decide.h"

struct place {
  double x, speed, v_start; /* nan where there is no steady state                                    */
  bool sliding;
};

enum { SCAN_MOST = 1150, PEAKS_MOST = 6 };

struct family {
  struct scallop_crawler crawler;
  enum varied varied;
  int count; /* of the scan: x from the smallest                                                    */
  struct place scan[SCAN_MOST];
  /* Where v_start vanishes, in the first place from the left; nan if there is none. found: v_start is proven to be
   * positive at boundary (1 - 2^-60) and not to be positive at boundary (1 + 2^-60). before, after: the certified
   * derivative of mean velocity by ln x between (1 - 2^-39) and (1 - 2^-40), and between (1 + 2^-40) and (1 + 2^-39),
   * with its sign proven; speed: at the latter. */
  double boundary, before, after, boundary_speed;
  bool found, rises_before, falls_after;
  /* The local maxima of mean velocity; the one at the boundary among them */
  int maxima, highest;
  struct place maximum[PEAKS_MOST];
};

/* Begins a family with its scan: mean velocity and regime 1 % apart, F1/F2 from 1.01 to 7838; 1/Froude from 1e-3 to 92
 * (forces) or, T 1 % apart, 91. coarse: F1/F2 alone, 4 % apart, to 7732. In doubles, its boundary and its maxima
 * too. */
void family_scan(struct family *f, const struct scallop_crawler *crawler, enum varied varied, bool coarse);
/* Proves the boundary, to 2^-60 of it. */
void family_prove_boundary(struct family *f);
/* Keeps the maxima that are proven to be higher than 1 % to either side. */
void family_prove_maxima(struct family *f);
/* In doubles: is the boundary the highest point of the scan? */
bool family_peaks_at_boundary(const struct family *f);
/* Proven: v_start vanishes, mean velocity rises up to there and falls behind, and nowhere in the scan is it higher. */
bool family_peak_is_proven(const struct family *f);

#endif
