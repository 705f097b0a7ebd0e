/* The branch points nearest to T = 0: searched for along the branch, then proven to be the nearest. */
#include "asymptotics/derived/singularity.h"

#include "asymptotics/derived/continuation.h"
#include "asymptotics/derived/scoped.h"

void scallop_singularity_init(struct scallop_singularity *s)
{
  arb_init(s->low);
  arb_init(s->T);
  acb_init(s->place);
}

void scallop_singularity_clear(struct scallop_singularity *s)
{
  arb_clear(s->low);
  arb_clear(s->T);
  acb_clear(s->place);
}

/* Adds the values with a branch point at a fold. The mirror image of an even fold exchanges v_mid and v_start. */
static void add_shown(struct scallop_singularity *to, const struct singularity_search *s, const struct fold *f)
{
  SCOPED(acb, gain);
  for (int k = 0; k < CONTINUED_VALUES; k++) {
    continued_gain(gain, s->apart, (enum continued_value)k, f->v, f->first, s->precision);
    to->shows[k] = to->shows[k] || !acb_contains_zero(gain);
  }
  if (to->even)
    to->shows[AT_START] = to->shows[AFTER_FIRST_PHASE] = to->shows[AT_START] || to->shows[AFTER_FIRST_PHASE];
}

/* Sets the nearest place, and adds the values of all folds that may be nearest. */
static void set_place(struct scallop_singularity *to, const struct singularity_search *s)
{
  SCOPED(arb, size);
  arb_pos_inf(to->T);
  for (int i = 0; i < s->folds; i++) {
    acb_abs(size, s->fold[i].v + s->n, s->precision);
    if (arf_cmp(arb_midref(size), arb_midref(to->T)) < 0) {
      arb_set(to->T, size);
      acb_set(to->place, s->fold[i].v + s->n);
    }
  }
  for (int i = 0; i < s->folds; i++) {
    acb_abs(size, s->fold[i].v + s->n, s->precision);
    if (arb_overlaps(size, to->T))
      add_shown(to, s, &s->fold[i]);
  }
}

/* Undoes the scale of z, and takes the root of the sizes: low and T become times; place stays a T^power. */
static void unscale(struct scallop_singularity *to, const struct continuation *c, slong precision)
{
  arb_ptr sizes[2] = { to->low, to->T };
  for (int i = 0; i < 2; i++) {
    arb_mul_2exp_si(sizes[i], sizes[i], c->scale);
    arb_root_ui(sizes[i], sizes[i], (ulong)to->power, precision);
  }
  acb_mul_2exp_si(to->place, to->place, c->scale);
}

static void nothing_found(struct scallop_singularity *to, slong power, bool even)
{
  to->power = power;
  to->even = even;
  to->found = false;
  for (int k = 0; k < CONTINUED_VALUES; k++)
    to->shows[k] = false;
  arb_pos_inf(to->low);
  arb_pos_inf(to->T);
}

/* Finds the singularity; both: the equations without and with joined crossings. */
static void find(struct scallop_singularity *to, const struct continuation both[2], bool even, slong precision)
{
  struct singularity_search *s = search_new(both, even ? 0.5 : 1, precision);
  nothing_found(to, 3 - both[0].power, even);
  double covered = search_cover(s);
  to->found = s->folds > 0;
  set_place(to, s);
  if (to->found && covered >= s->reach)
    arb_set(to->low, to->T);
  else
    arb_set_d(to->low, covered);
  unscale(to, &both[0], precision);
  search_free(s);
}

static enum scallop_status find_with(struct scallop_singularity *s, struct continuation both[2], bool even,
                                     slong precision)
{
  find(s, both, even, precision);
  for (int join = 0; join < 2; join++)
    continuation_clear(&both[join]);
  return SCALLOP_OK;
}

enum scallop_status scallop_steady_singularity(struct scallop_singularity *s,
                                               const struct scallop_rational_crawler *crawler, slong precision,
                                               const char **why)
{
  struct continuation both[2];
  SCOPED(limit, l);
  SCOPED(fmpq, kappa);
  enum scallop_status status = limit_find(&l, crawler, precision, why);
  nothing_found(s, 2, l.even);
  if (status != SCALLOP_OK || l.at_rest)
    return status;
  set_kappa(kappa, crawler);
  for (int join = 0; join < 2; join++)
    continue_steady(&both[join], &l, kappa, join, precision);
  return find_with(s, both, l.even, precision);
}

enum scallop_status scallop_phase_singularity(struct scallop_singularity *s,
                                              const struct scallop_rational_crawler *crawler,
                                              enum scallop_phase_kind kind, const fmpq_t v0, int crossings,
                                              slong precision, const char **why)
{
  struct continuation both[2];
  SCOPED(phase_constants, p);
  SCOPED(branch, b);
  SCOPED(fmpq, kappa, velocity);
  const char *none = branch_of_phase(&b, &p, crawler, kind, v0, 1, precision);
  nothing_found(s, 1, false);
  if (none)
    return refused_for(SCALLOP_EDOMAIN, none, why);
  if (b.count == 0)
    return SCALLOP_OK;
  set_kappa(kappa, crawler);
  fmpq_div(velocity, v0, crawler->L);
  for (int join = 0; join < 2; join++)
    continue_phase(&both[join], &b, &p, crossings < b.count ? crossings : b.count, velocity, kappa, join, precision);
  return find_with(s, both, false, precision);
}
