#include "asymptotics/singularity.h"

#include <math.h>

#include "asymptotics/continuation.h"

/* Part of the proof: for |z| up to r, in the directions from `from` pi to `to` pi, the branch is an analytic function of z. */
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

/* The box of all r e^(i pi t) */
static void polar(acb_t z, double r0, double r1, double t0, double t1)
{
  arf_t lo, hi;
  arb_t r, t;
  arf_init(lo);
  arf_init(hi);
  arb_init(r);
  arb_init(t);
  arf_set_d(lo, r0);
  arf_set_d(hi, r1);
  arb_set_interval_arf(r, lo, hi, CELL_BITS);
  arf_set_d(lo, t0);
  arf_set_d(hi, t1);
  arb_set_interval_arf(t, lo, hi, CELL_BITS);
  arb_sin_cos_pi(acb_imagref(z), acb_realref(z), t, CELL_BITS);
  acb_mul_arb(z, z, r, CELL_BITS);
  arf_clear(lo);
  arf_clear(hi);
  arb_clear(r);
  arb_clear(t);
}

static bool is_within(acb_srcptr around, acb_srcptr v, slong count)
{
  for (slong j = 0; j < count; j++)
    if (!acb_contains(around + j, v + j))
      return false;
  return true;
}

/* The equations to use around v: joined where crossings that may be joined are close; elsewhere the others, whose balls stay smaller. */
static const struct continuation *equations_at(const struct search *s, acb_srcptr v)
{
  const struct continuation *use = s->apart;
  acb_t way;
  mag_t size;
  acb_init(way);
  mag_init(size);
  for (slong i = 1; i < s->joined->m; i++)
    if (s->joined->crossing[i].joined) {
      acb_sub(way, v + i + 1, v + i, CELL_BITS);
      acb_get_mag(size, way);
      if (mag_cmp_2exp_si(size, -2) < 0)
        use = s->joined;
    }
  acb_clear(way);
  mag_clear(size);
  return use;
}

/* ---- sectors ---- */

static struct sector *add_sector(struct search *s, double r, double step, double from, double to)
{
  struct sector *sector = &s->sector[s->sectors++];
  *sector = (struct sector){ r, step, from, to, r / 4, _acb_vec_init(s->n + 1), _acb_vec_init(s->n + 1) };
  return sector;
}

static void remove_sector(struct search *s, int i)
{
  _acb_vec_clear(s->sector[i].at, s->n + 1);
  _acb_vec_clear(s->sector[i].around, s->n + 1);
  s->sector[i] = s->sector[--s->sectors];
}

/* v at r in the direction t on the branch in the box: from a place near it */
static bool point_within(acb_ptr v, acb_srcptr near, acb_srcptr box, const struct search *s, double r, double t)
{
  acb_ptr around = _acb_vec_init(s->n + 1);
  _acb_vec_set(v, near, s->n);
  polar(v + s->n, r, r, t, t);
  bool found = continuation_enclose(v, around, equations_at(s, v), s->n, CELL_BITS) && is_within(box, v, s->n);
  _acb_vec_clear(around, s->n + 1);
  return found;
}

/* The largest disc around z = 0, of 1/2, 1/4, ... */
static bool find_disc(struct search *s)
{
  enum { TRIES = 60 };
  acb_ptr v = _acb_vec_init(s->n + 1);
  bool found = false;
  s->disc = 1;
  for (int i = 0; i < TRIES && !found; i++) {
    s->disc /= 2;
    _acb_vec_set(v, s->apart->start, s->n);
    acb_zero(v + s->n);
    mag_set_d(arb_radref(acb_realref(v + s->n)), s->disc);
    mag_set_d(arb_radref(acb_imagref(v + s->n)), s->disc);
    found = continuation_enclose(v, s->start, equations_at(s, v), s->n, CELL_BITS)
            && is_within(s->start, s->apart->start, s->n);
  }
  _acb_vec_clear(v, s->n + 1);
  return found;
}

/* A sector that begins at the disc */
static bool start_sector(struct search *s, double from, double to)
{
  struct sector *sector = add_sector(s, s->disc, s->disc / 4, from, to);
  _acb_vec_set(sector->around, s->start, s->n + 1);
  return point_within(sector->at, s->start, s->start, s, s->disc, (from + to) / 2);
}

static bool advance(struct search *s, struct sector *sector)
{
  double to = fmin(sector->r + sector->step, s->reach), middle = (sector->from + sector->to) / 2;
  acb_ptr v = _acb_vec_init(s->n + 1), around = _acb_vec_init(s->n + 1);
  _acb_vec_set(v, sector->at, s->n);
  polar(v + s->n, sector->r, to, sector->from, sector->to);
  bool done = continuation_enclose(v, around, equations_at(s, v), s->n, CELL_BITS) && is_within(around, sector->at, s->n)
              && point_within(v, v, around, s, to, middle);
  if (done) {
    _acb_vec_swap(sector->at, v, s->n + 1);
    _acb_vec_swap(sector->around, around, s->n + 1);
    sector->r = to;
  }
  sector->step *= done ? 1.25 : 0.5;
  _acb_vec_clear(v, s->n + 1);
  _acb_vec_clear(around, s->n + 1);
  return done;
}

/* Into two halves */
static bool split(struct search *s, int i)
{
  if (s->sectors + 2 > MOST_SECTORS)
    return false;
  struct sector *old = &s->sector[i];
  double middle = (old->from + old->to) / 2;
  bool found = true;
  for (int k = 0; k < 2 && found; k++) {
    struct sector *part = add_sector(s, old->r, 2 * old->step, k ? middle : old->from, k ? old->to : middle);
    part->looked = old->looked;
    _acb_vec_set(part->around, old->around, s->n + 1);
    found = point_within(part->at, old->at, old->around, s, part->r, (part->from + part->to) / 2);
  }
  remove_sector(s, i);
  return found;
}

/* ---- branch points ---- */

static double upper_size(const acb_t z)
{
  arb_t size;
  arf_t end;
  arb_init(size);
  arf_init(end);
  acb_abs(size, z, CELL_BITS);
  arb_get_ubound_arf(end, size, CELL_BITS);
  double d = arf_get_d(end, ARF_RND_CEIL);
  arb_clear(size);
  arf_clear(end);
  return d;
}

/* Not found before; and from now on it is. */
static bool is_new(struct search *s, const acb_t z)
{
  for (int i = 0; i < s->places; i++)
    if (acb_overlaps(s->place + i, z))
      return false;
  if (s->places == MOST_PLACES)
    return false;
  acb_set(s->place + s->places++, z);
  return true;
}

/* Over pi */
static double direction_of(const acb_t z)
{
  const double pi = 3.14159265358979323846;
  bool real = arb_contains_zero(acb_imagref(z));
  double re = arf_get_d(arb_midref(acb_realref(z)), ARF_RND_NEAR), im = arf_get_d(arb_midref(acb_imagref(z)), ARF_RND_NEAR);
  return atan2(real ? 0 : im, re) / pi;
}

/* The branch, continued straight towards the fold, comes into its neighbourhood: a sector without width */
static bool is_met(struct search *s, const struct fold *f)
{
  enum { STEPS = 1000 };
  const double rounding = 1e-9;
  double direction = direction_of(f->v + s->n), size = upper_size(f->v + s->n);
  if (direction < 0 || direction > s->last + rounding || size > s->reach * (1 + rounding) || s->sectors == MOST_SECTORS)
    return false;
  bool begun = start_sector(s, direction, direction), met = false;
  struct sector *ray = &s->sector[s->sectors - 1];
  for (int i = 0; i < STEPS && begun && !met && ray->r < size; i++) {
    advance(s, ray);
    met = fold_holds(f, ray->at);
  }
  remove_sector(s, s->sectors - 1);
  return met;
}

static void look_for_fold(struct search *s, struct sector *sector)
{
  struct fold *f = &s->fold[s->folds];
  if (s->folds == MOST_FOLDS)
    return;
  sector->looked = sector->step;
  fold_init(f, equations_at(s, sector->at));
  if (fold_find(f, sector->at, sector->r, s->precision) && is_new(s, f->v + s->n) && is_met(s, f)) {
    s->reach = fmin(s->reach, upper_size(f->v + s->n));
    s->folds++;
  } else
    fold_clear(f);
}

/* What is left of the sector up to reach is where nothing but the fold is singular. */
static bool ends_in_fold(const struct search *s, const struct sector *sector)
{
  bool ends = false;
  acb_t way;
  acb_init(way);
  for (int i = 0; i < s->folds && !ends; i++) {
    const struct fold *f = &s->fold[i];
    polar(way, sector->r, s->reach, sector->from, sector->to);
    acb_sub(way, way, f->v + s->n, CELL_BITS);
    ends = upper_size(way) < f->clear && fold_holds(f, sector->at);
  }
  acb_clear(way);
  return ends;
}

/* ---- the search ---- */

static int nearest_sector(const struct search *s)
{
  int best = 0;
  for (int i = 1; i < s->sectors; i++)
    if (s->sector[i].r < s->sector[best].r)
      best = i;
  return best;
}

/* Carries that sector on which has come least far, until all reach the nearest fold. Returns |z| up to where the proof has come. */
static double cover(struct search *s)
{
  enum { SECTORS = 8 };
  const double far = 0x1p40, narrow = 0x1p-36;
  const slong most_cells = MOST_WORK / (s->n * s->n * s->n); /* 20,000 of four crossings */
  double covered = 0;
  bool sound = find_disc(s);
  for (int i = 0; i < SECTORS && sound; i++)
    sound = start_sector(s, i * s->last / SECTORS, (i + 1) * s->last / SECTORS);
  for (slong cells = 0; cells < most_cells && sound && s->sectors > 0; cells++) {
    int i = nearest_sector(s);
    struct sector *sector = &s->sector[i];
    covered = fmin(sector->r, s->reach);
    if (sector->r >= s->reach || ends_in_fold(s, sector)) {
      remove_sector(s, i);
      continue;
    }
    sound = sector->r < far && sector->step > narrow * sector->r;
    if (!sound || advance(s, sector))
      continue;
    if (sector->step < sector->looked / 4)
      look_for_fold(s, sector);
    if (sector->step < sector->r * (sector->to - sector->from))
      sound = split(s, i);
  }
  return sound && s->sectors == 0 ? s->reach : covered;
}

static void search_clear(struct search *s)
{
  while (s->sectors > 0)
    remove_sector(s, 0);
  for (int i = 0; i < s->folds; i++)
    fold_clear(&s->fold[i]);
  _acb_vec_clear(s->start, s->n + 1);
  _acb_vec_clear(s->place, MOST_PLACES);
  flint_free(s);
}

/* ---- the results ---- */

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

/* Which values have a branch point at a fold. Of an even one at its mirror image: v_mid there is v_start here, and the other way round. */
static void add_shown(struct scallop_singularity *to, const struct search *s, const struct fold *f)
{
  acb_t gain;
  acb_init(gain);
  for (int k = 0; k < CONTINUED_VALUES; k++) {
    continued_gain(gain, s->apart, (enum continued_value)k, f->v, f->first, s->precision);
    to->shows[k] = to->shows[k] || !acb_contains_zero(gain);
  }
  if (to->even)
    to->shows[AT_START] = to->shows[AFTER_FIRST_PHASE] = to->shows[AT_START] || to->shows[AFTER_FIRST_PHASE];
  acb_clear(gain);
}

/* The folds of which none is shown to be nearer than another */
static void set_place(struct scallop_singularity *to, const struct search *s)
{
  arb_t size;
  arb_init(size);
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
  arb_clear(size);
}

/* From z to T */
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

/* both: without and with joined crossings */
static void find(struct scallop_singularity *to, const struct continuation both[2], bool even, slong precision)
{
  slong n = both[0].n;
  struct search *s = flint_malloc(sizeof *s);
  nothing_found(to, 3 - both[0].power, even);
  *s = (struct search){ .apart = &both[0],
                        .joined = &both[1],
                        .n = n,
                        .precision = precision,
                        .last = even ? 0.5 : 1,
                        .start = _acb_vec_init(n + 1),
                        .place = _acb_vec_init(MOST_PLACES),
                        .reach = INFINITY };
  double covered = cover(s);
  to->found = s->folds > 0;
  set_place(to, s);
  if (to->found && covered >= s->reach)
    arb_set(to->low, to->T);
  else
    arb_set_d(to->low, covered);
  unscale(to, &both[0], precision);
  search_clear(s);
}

/* eps/T^2 = (F1 + F2)/(M L) */
static void set_kappa(fmpq_t kappa, const struct scallop_rational_crawler *c)
{
  fmpq_t M;
  fmpq_init(M);
  fmpq_add(M, c->m1, c->m2);
  fmpq_add(kappa, c->F1, c->F2);
  fmpq_div(kappa, kappa, M);
  fmpq_div(kappa, kappa, c->L);
  fmpq_clear(M);
}

enum scallop_status scallop_steady_singularity(struct scallop_singularity *s, const struct scallop_rational_crawler *crawler,
                                               slong precision, const char **why)
{
  struct limit l;
  const char *reason = NULL;
  limit_init(&l, crawler);
  enum scallop_status status = limit_find(&l, crawler, precision, &reason);
  nothing_found(s, 2, l.even);
  if (status == SCALLOP_OK && !l.at_rest) {
    struct continuation both[2];
    fmpq_t kappa;
    fmpq_init(kappa);
    set_kappa(kappa, crawler);
    for (int join = 0; join < 2; join++)
      continue_steady(&both[join], &l, kappa, join, precision);
    find(s, both, l.even, precision);
    for (int join = 0; join < 2; join++)
      continuation_clear(&both[join]);
    fmpq_clear(kappa);
  } else if (status != SCALLOP_OK && why)
    *why = reason;
  limit_clear(&l);
  return status;
}

enum scallop_status scallop_phase_singularity(struct scallop_singularity *s, const struct scallop_rational_crawler *crawler,
                                              enum scallop_phase_kind kind, const fmpq_t v0, int crossings, slong precision,
                                              const char **why)
{
  struct phase_constants p;
  struct branch b;
  phase_constants_init(&p, crawler, kind);
  branch_init(&b);
  int at_start = fmpq_sgn(v0), at_end = at_start != 0 ? at_start : fmpq_sgn(p.beta[1]);
  bool possible = branch_is_possible(crawler->gait), has_ends = possible && branch_from_ends(&b, &p, at_start, at_end);
  nothing_found(s, 1, false);
  if (!has_ends && why)
    *why = possible ? branch_without_ends : branch_impossible;
  if (has_ends && b.count > 0) {
    struct continuation both[2];
    fmpq_t kappa, velocity;
    fmpq_init(kappa);
    fmpq_init(velocity);
    set_kappa(kappa, crawler);
    fmpq_div(velocity, v0, crawler->L);
    for (int join = 0; join < 2; join++)
      continue_phase(&both[join], &b, &p, crossings < b.count ? crossings : b.count, velocity, kappa, join, precision);
    find(s, both, false, precision);
    for (int join = 0; join < 2; join++)
      continuation_clear(&both[join]);
    fmpq_clear(kappa);
    fmpq_clear(velocity);
  }
  branch_clear(&b);
  phase_constants_clear(&p);
  return has_ends ? SCALLOP_OK : SCALLOP_EDOMAIN;
}
