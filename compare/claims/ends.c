/* (A.11), (A.12): l' and l near the end of an extension, T = L = 1. */
#include <math.h>
#include <stdio.h>

#include "compare/claims/evidence.h"
#include "compare/claims/ledger.h"

struct end_claim {
  const char *name, *equation, *quantity;
  int order;
  bool velocity;    /* l'(T-h) = -h l''(T); otherwise l(T-h) = [l(T) +] h^2/2 l''(T)             */
  bool with_length; /* l(T) is there                                                              */
  const char *corrected;
  bool ours;
};
static const struct end_claim end_claims[] = {
  { "A_dl_near_end", "(A.11)", "l'(T-h)", 2, true, true, "", false },
  { "A_l_near_end", "(A.12)", "l(T-h)", 3, false, false, "corrected_l_near_end", false },
  { "corrected_l_near_end", "(A.12)", "l(T-h)", 3, false, true, "", true },
};

/* |l'(T-h)| without its term in h, as a series in h */
static void speed_before_end(struct series *speed, const struct scallop_piece *last, const struct ring *ring)
{
  struct series back;
  series_init(&back);
  scallop_speed_series(speed, last, NULL, ring);
  series_set_x(&back);
  series_neg(&back, &back);
  series_compose(speed, speed, &back, ring);
  series_set_zero(speed, 1);
  series_clear(&back);
}

/* What the claim leaves out: its first coefficient that does not vanish */
static void prove(struct proof *proof, const struct end_claim *claim, const struct scallop_piece *last)
{
  const struct ring ring = { 40, 256 };
  struct series left_out, one;
  arb_t x;
  series_init(&left_out);
  series_init(&one);
  arb_init(x);
  speed_before_end(&left_out, last, &ring);
  if (!claim->velocity) {
    series_integral(&left_out, &left_out, &ring);
    series_set_si(&one, claim->with_length ? 0 : 1);
    series_sub(&left_out, &one, &left_out, &ring);
  }
  while (proof->order < ring.length && series_coefficient_is_zero(&left_out, proof->order))
    proof->order++;
  proof->known = ring.length;
  proof->general = proof->order;
  proof->found = proof->order < ring.length;
  proof_set_coefficient(proof, &left_out, proof->order);
  series_coefficient(x, &proof->coefficient, 0, ring.precision);
  proof->undecided = !arb_is_exact(x) && arb_contains_zero(x);
  series_clear(&left_out);
  series_clear(&one);
  arb_clear(x);
}

/* The same, measured at h = 4^-k */
static void measure(struct claim_row *row, const struct end_claim *claim, const struct scallop_piece *last)
{
  enum { PRECISION = 1400 };
  arb_t h, zero, error, rate, square;
  arb_ptr all[] = { h, zero, error, rate, square };
  for (int i = 0; i < 5; i++)
    arb_init(all[i]);
  scallop_ball_rate(rate, last, zero, PRECISION); /* l''(T) of an extension */
  for (int k = 1; k < CLAIM_POINTS; k++) {
    arb_one(h);
    arb_mul_2exp_si(h, h, -2 * k);
    if (claim->velocity) {
      scallop_ball_speed(error, last, h, PRECISION);
      arb_addmul(error, h, rate, PRECISION);
    } else {
      scallop_ball_way(error, last, h, zero, PRECISION);
      arb_neg(error, error);
      arb_add_si(error, error, claim->with_length ? 0 : 1, PRECISION);
      arb_mul(square, h, h, PRECISION);
      arb_mul_2exp_si(square, square, -1);
      arb_submul(error, square, rate, PRECISION);
    }
    row->points[row->count++] =
        (struct order_point){ .h = ldexp(1, -2 * k), .err = middle(error), .noise = mag_get_d(arb_radref(error)) };
  }
  const struct order_point *finest = &row->points[row->count - 1];
  row->slope = log(fabs(finest[-1].err / finest[0].err)) / log(4);
  for (int i = 0; i < 5; i++)
    arb_clear(all[i]);
}

void ledger_add_ends(struct ledger *ledger, const struct scallop_gait *gait, const char *only)
{
  const struct scallop_shape *shape = &gait->phase[SCALLOP_EXTENSION];
  const struct scallop_piece *last = &shape->pieces[shape->count - 1];
  for (size_t i = 0; i < sizeof end_claims / sizeof *end_claims; i++) {
    const struct end_claim *claim = &end_claims[i];
    struct proof proof;
    struct claim_row row = { .equation = claim->equation,
                             .quantity = claim->quantity,
                             .gait = gait->name,
                             .conditions = "h -> 0 at T = 1",
                             .inside = true,
                             .ours = claim->ours,
                             .claimed_order = claim->order };
    snprintf(row.claim, sizeof row.claim, "%s", claim->name);
    snprintf(row.corrected, sizeof row.corrected, "%s", claim->corrected);
    if (only && !claim_is_listed(only, claim->name))
      continue;
    proof_init(&proof);
    prove(&proof, claim, last);
    ledger_judge(&row, &proof);
    measure(&row, claim, last);
    ledger_enter(ledger, &row);
    proof_clear(&proof);
  }
}
