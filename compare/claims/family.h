/* Crawlers that differ in one number, and what is proven of their mean velocity. Needs FLINT. Not public. */
#ifndef SCALLOP_CLAIMS_FAMILY_H
#define SCALLOP_CLAIMS_FAMILY_H

#include <stddef.h>

#include "model/ball.h"
#include "numerics/numerics.h"

/* x: F1/F2, F1 varied; F2, with F1/F2 kept; T. */
enum varied { VARY_RATIO, VARY_FORCES, VARY_PERIOD };
struct family {
  struct scallop_crawler crawler;
  enum varied varied;
};

/* "F1/F2", "F2", "T" */
const char *family_name(const struct family *f);
struct scallop_crawler family_member(const struct family *f, double x);
/* Mean velocity T/L, T that of the family's crawler, even where T is varied; nan where there is none */
double family_speed(const struct family *f, double x);

/* A member proven. The family's numbers are the shortest decimals that read back, x is exactly what it is. */
struct member {
  arb_t v_start, speed;
  bool solved, sliding;
};
void member_init(struct member *m);
void member_clear(struct member *m);
void member_solve(struct member *m, const struct family *f, const fmpq_t x);
/* Is the mean velocity at x proven to be lower than that at y? */
bool family_rises(const struct family *f, double x, double y);

/* The scan: x, and mean velocity and regime there, at `count` places 1 % apart: F1/F2 from 1.01 to 7838; 1/Froude from 1e-3 to
 * 92 (forces) or, T 1 % apart, 91. coarse: F1/F2 alone, 4 % apart, to 7732. */
enum { SCAN_MOST = 1150 };
struct scan {
  int count;
  double x[SCAN_MOST], speed[SCAN_MOST], v_start[SCAN_MOST];
  bool sliding[SCAN_MOST];
};
void family_scan(struct scan *scan, const struct family *f, bool coarse);

/* The boundary where v_start vanishes, in the first place from the left. found: v_start is proven to be positive at
 * at (1 - 2^-60) and not to be positive at at (1 + 2^-60). before, after: by how much the mean velocity rises from
 * at (1 - 2^-39) to at (1 - 2^-40), and from at (1 + 2^-40) to at (1 + 2^-39), over 2^-40: its derivative by ln x somewhere there,
 * proven; speed: at (1 + 2^-40). */
struct boundary {
  bool found;
  double at, before, after, speed;
  bool rises_before, falls_after; /* proven */
};
/* In doubles, to rounding; nan if there is none */
double rough_boundary(const struct family *f, const struct scan *scan);
struct boundary family_boundary(const struct family *f, const struct scan *scan);

/* The local maxima of mean velocity: proven to be higher than 1 % to either side. The one at the boundary among them. */
enum { PEAKS_MOST = 6 };
struct peaks {
  int count, highest;
  double at[PEAKS_MOST], speed[PEAKS_MOST];
};
/* prove: in doubles alone if not */
struct peaks family_peaks(const struct family *f, const struct scan *scan, bool prove);
/* Is the boundary the highest point of the scan? */
bool peaks_at(const struct peaks *p, double x);

/* The number with so many digits: what a command says */
double short_number(double x, int digits);
/* " --F1 2 --gait sinusoidal": what differs from the default, but what is left out (NULL: nothing is) */
void crawler_options(char *text, size_t size, const struct scallop_crawler *c, const bool left_out[7]);
/* "scallop COMMAND" on that crawler, between two texts */
void crawler_command(char *text, size_t size, const char *before, const char *command, const struct scallop_crawler *c,
                     const char *after);
/* A command that prints the steady states of some members */
void family_points(char *text, size_t size, const struct family *f, const double *x, int count);
/* A command that prints x, v_start (VARY_PERIOD: also) and mean velocity of some members. */
void family_command(char *text, size_t size, const struct family *f, const double *x, int count);

#endif
