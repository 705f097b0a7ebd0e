/* Gaits in fractions: the gait of a family with the exact numbers instead of the nearest doubles; or the exact values
 * of a gait's doubles, converted once for all callers. Needs FLINT; allocates through it. */
#ifndef SCALLOP_MODEL_EXACT_FRACTIONS_H
#define SCALLOP_MODEL_EXACT_FRACTIONS_H

#include "model/exact/scoped.h"
#include "model/families.h"

#ifdef __cplusplus
extern "C" {
#endif

struct scallop_fractions { /* |l'| of a piece in powers of u - origin, for offsets u from least to most */
  fmpq_t origin, least, most;
  fmpq_poly_t speed;
};

#define FRACTIONS_PARTS(of) of(fmpq, s->origin) of(fmpq, s->least) of(fmpq, s->most) of(fmpq_poly, s->speed)
SCOPED_PARTS(fractions, struct scallop_fractions, FRACTIONS_PARTS)

/* Sets the fractions to the exact values of the doubles of a piece that is linear or has a law other than a sine. */
void fractions_of_doubles(struct scallop_fractions *fractions, const struct scallop_piece *piece);

/* A gait with the pieces of another gait and their fractions. It must not move while the gait is used. */
struct scallop_exact_gait {
  struct scallop_gait gait;
  struct scallop_piece *pieces;
  struct scallop_fractions *fractions; /* one for each piece */
  int count;
};
void scallop_exact_init(struct scallop_exact_gait *exact);
void scallop_exact_clear(struct scallop_exact_gait *exact);
SCOPED_KIND(scallop_exact, struct scallop_exact_gait)

/* Sets the gait to the exact values of the doubles of another gait, or to its fractions if it has them. Pieces
 * without rational coefficients (sines) have no fractions. */
void scallop_exact_of(struct scallop_exact_gait *exact, const struct scallop_gait *gait);

/* Sets the gait to the gait of a family with the numbers x[0..count), as for scallop_make_gait; `gait` was made with
 * the doubles nearest to them. As there, UP + DOWN is 1 if it is 1 within rounding. Returns false if *exact has the
 * values of the doubles instead: if l' of a polynomial is not exactly 0 at both ends, or changes its sign within a
 * phase. */
bool scallop_exact_made(struct scallop_exact_gait *exact, const struct scallop_gait_family *family,
                        const struct scallop_gait *gait, const fmpq *x, int count);
/* Compute the offsets at which a piece begins and ends. */
void scallop_rational_begin(fmpq_t u, const struct scallop_piece *piece);
void scallop_rational_end(fmpq_t u, const struct scallop_piece *piece);

#ifdef __cplusplus
}
#endif

#endif
