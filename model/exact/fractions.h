/* Gaits in fractions: what a gait's own numbers make of it as they were written, where the doubles nearest to them make
 * another one; or what the doubles make of it, once for all who ask. Needs FLINT; allocates through it.
 */
#ifndef SCALLOP_MODEL_EXACT_FRACTIONS_H
#define SCALLOP_MODEL_EXACT_FRACTIONS_H

#include "model/exact/scoped.h"
#include "model/families.h"

#ifdef __cplusplus
extern "C" {
#endif

struct scallop_fractions { /* of a piece: |l'| in powers of u - origin, for offsets u from least to most */
  fmpq_t origin, least, most;
  fmpq_poly_t speed;
};

#define FRACTIONS_PARTS(of) of(fmpq, s->origin) of(fmpq, s->least) of(fmpq, s->most) of(fmpq_poly, s->speed)
SCOPED_PARTS(fractions, struct scallop_fractions, FRACTIONS_PARTS)

/* Of a piece that is linear or has a law that is no sine: the very numbers that its doubles are */
void fractions_of_doubles(struct scallop_fractions *fractions, const struct scallop_piece *piece);

/* A gait whose pieces are those of another one, with fractions. It must stay where it is while the gait is used. */
struct scallop_exact_gait {
  struct scallop_gait gait;
  struct scallop_piece *pieces;
  struct scallop_fractions *fractions; /* one for each piece */
  int count;
};
void scallop_exact_init(struct scallop_exact_gait *exact);
void scallop_exact_clear(struct scallop_exact_gait *exact);
SCOPED_KIND(scallop_exact, struct scallop_exact_gait)

/* What the doubles of the gait say, or its fractions where it has them. Pieces without rational coefficients (sines)
 * have no fractions. */
void scallop_exact_of(struct scallop_exact_gait *exact, const struct scallop_gait *gait);

/* The gait of a family with these numbers instead of the doubles nearest to them, which `gait` was made with: count of
 * them, as for scallop_make_gait. As there, UP + DOWN within a rounding of 1 is 1. False: *exact is what the doubles
 * say, as where l' of a polynomial is not exactly 0 at both ends, or changes its sign within a phase. */
bool scallop_exact_made(struct scallop_exact_gait *exact, const struct scallop_gait_family *family,
                        const struct scallop_gait *gait, const fmpq *x, int count);
/* Where a piece begins and ends, as offsets */
void scallop_rational_begin(fmpq_t u, const struct scallop_piece *piece);
void scallop_rational_end(fmpq_t u, const struct scallop_piece *piece);

#ifdef __cplusplus
}
#endif

#endif
