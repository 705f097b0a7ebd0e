/* A disk of complex z covered with boxes; in each the branch is proven to be analytic, or the box is divided. */
#include "asymptotics/derived/continuation.h"

#include <math.h>

#include "asymptotics/derived/scoped.h"

/* Computes the box of all r e^(i pi t). */
static void polar(acb_t z, double r0, double r1, double t0, double t1)
{
  SCOPED(arf, lo, hi);
  SCOPED(arb, r, t);
  arf_set_d(lo, r0);
  arf_set_d(hi, r1);
  arb_set_interval_arf(r, lo, hi, CELL_BITS);
  arf_set_d(lo, t0);
  arf_set_d(hi, t1);
  arb_set_interval_arf(t, lo, hi, CELL_BITS);
  arb_sin_cos_pi(acb_imagref(z), acb_realref(z), t, CELL_BITS);
  acb_mul_arb(z, z, r, CELL_BITS);
}

static bool is_within(acb_srcptr around, acb_srcptr v, slong count)
{
  for (slong j = 0; j < count; j++)
    if (!acb_contains(around + j, v + j))
      return false;
  return true;
}

/* Returns the equations to use around v: joined if crossings that may be joined are close; otherwise the plain ones,
 * with smaller balls. */
static const struct continuation *equations_at(const struct singularity_search *s, acb_srcptr v)
{
  SCOPED(acb, way);
  SCOPED(mag, size);
  for (slong i = 1; i < s->joined->m; i++) {
    acb_sub(way, v + i + 1, v + i, CELL_BITS);
    acb_get_mag(size, way);
    if (s->joined->crossing[i].joined && mag_cmp_2exp_si(size, -2) < 0)
      return s->joined;
  }
  return s->apart;
}

static struct sector *add_sector(struct singularity_search *s, double r, double step, double from, double to)
{
  struct sector *sector = &s->sector[s->sectors++];
  *sector = (struct sector){ r, step, from, to, r / 4, _acb_vec_init(s->n + 1), _acb_vec_init(s->n + 1) };
  return sector;
}

static void remove_sector(struct singularity_search *s, int i)
{
  _acb_vec_clear(s->sector[i].at, s->n + 1);
  _acb_vec_clear(s->sector[i].around, s->n + 1);
  s->sector[i] = s->sector[--s->sectors];
}

/* Computes v at r in the direction t on the branch in the box, from a place near it. */
static bool point_within(acb_ptr v, acb_srcptr near, acb_srcptr box, const struct singularity_search *s, double r,
                         double t)
{
  SCOPED_BALLS(around, s->n + 1);
  _acb_vec_set(v, near, s->n);
  polar(v + s->n, r, r, t, t);
  return continuation_enclose(v, around, equations_at(s, v), s->n, CELL_BITS) && is_within(box, v, s->n);
}

/* Finds the largest disc around z = 0, of 1/2, 1/4, ... */
static bool find_disc(struct singularity_search *s)
{
  enum { TRIES = 60 };
  SCOPED_BALLS(v, s->n + 1);
  s->disc = 1;
  for (int i = 0; i < TRIES; i++) {
    s->disc /= 2;
    _acb_vec_set(v, s->apart->start, s->n);
    acb_zero(v + s->n);
    mag_set_d(arb_radref(acb_realref(v + s->n)), s->disc);
    mag_set_d(arb_radref(acb_imagref(v + s->n)), s->disc);
    if (continuation_enclose(v, s->start, equations_at(s, v), s->n, CELL_BITS)
        && is_within(s->start, s->apart->start, s->n))
      return true;
  }
  return false;
}

/* Adds a sector that begins at the disc. */
static bool start_sector(struct singularity_search *s, double from, double to)
{
  struct sector *sector = add_sector(s, s->disc, s->disc / 4, from, to);
  _acb_vec_set(sector->around, s->start, s->n + 1);
  return point_within(sector->at, s->start, s->start, s, s->disc, (from + to) / 2);
}

static bool advance(struct singularity_search *s, struct sector *sector)
{
  const double to = fmin(sector->r + sector->step, s->reach);
  SCOPED_BALLS(v, s->n + 1);
  SCOPED_BALLS(around, s->n + 1);
  _acb_vec_set(v, sector->at, s->n);
  polar(v + s->n, sector->r, to, sector->from, sector->to);
  const bool done = continuation_enclose(v, around, equations_at(s, v), s->n, CELL_BITS)
                    && is_within(around, sector->at, s->n)
                    && point_within(v, v, around, s, to, (sector->from + sector->to) / 2);
  sector->step *= done ? 1.25 : 0.5;
  if (done) {
    _acb_vec_swap(sector->at, v, s->n + 1);
    _acb_vec_swap(sector->around, around, s->n + 1);
    sector->r = to;
  }
  return done;
}

/* Splits a sector into halves. */
static bool split(struct singularity_search *s, int i)
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

static double upper_size(const acb_t z)
{
  SCOPED(arb, size);
  SCOPED(arf, end);
  acb_abs(size, z, CELL_BITS);
  arb_get_ubound_arf(end, size, CELL_BITS);
  return arf_get_d(end, ARF_RND_CEIL);
}

/* Adds a place, and returns true, unless it was found before. */
static bool is_new(struct singularity_search *s, const acb_t z)
{
  for (int i = 0; i < s->places; i++)
    if (acb_overlaps(s->place + i, z))
      return false;
  if (s->places == MOST_PLACES)
    return false;
  acb_set(s->place + s->places++, z);
  return true;
}

/* Returns the argument of z over pi. */
static double direction_of(const acb_t z)
{
  const double pi = 3.14159265358979323846;
  bool real = arb_contains_zero(acb_imagref(z));
  double re = arf_get_d(arb_midref(acb_realref(z)), ARF_RND_NEAR),
         im = arf_get_d(arb_midref(acb_imagref(z)), ARF_RND_NEAR);
  return atan2(real ? 0 : im, re) / pi;
}

/* Returns true if the branch, continued straight to the fold, reaches its neighbourhood: a sector of zero width. */
static bool is_met(struct singularity_search *s, const struct fold *f)
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

static void look_for_fold(struct singularity_search *s, struct sector *sector)
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

/* Returns true if the rest of the sector, up to reach, has no singularity except the fold. */
static bool ends_in_fold(const struct singularity_search *s, const struct sector *sector)
{
  SCOPED(acb, way);
  for (const struct fold *f = s->fold; f < s->fold + s->folds; f++) {
    polar(way, sector->r, s->reach, sector->from, sector->to);
    acb_sub(way, way, f->v + s->n, CELL_BITS);
    if (upper_size(way) < f->clear && fold_holds(f, sector->at))
      return true;
  }
  return false;
}

static int nearest_sector(const struct singularity_search *s)
{
  int best = 0;
  for (int i = 1; i < s->sectors; i++)
    if (s->sector[i].r < s->sector[best].r)
      best = i;
  return best;
}

double search_cover(struct singularity_search *s)
{
  enum { SECTORS = 8 };
  const double far = 0x1p40, narrow = 0x1p-36;
  const slong most_cells = MOST_WORK / (s->n * s->n * s->n); /* 20,000 for four crossings */
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

void search_free(struct singularity_search *s)
{
  while (s->sectors > 0)
    remove_sector(s, 0);
  for (int i = 0; i < s->folds; i++)
    fold_clear(&s->fold[i]);
  _acb_vec_clear(s->start, s->n + 1);
  _acb_vec_clear(s->place, MOST_PLACES);
  flint_free(s);
}

struct singularity_search *search_new(const struct continuation both[2], double last, slong precision)
{
  struct singularity_search *s = flint_malloc(sizeof *s);
  *s = (struct singularity_search){
    .apart = &both[0], .joined = &both[1], .n = both[0].n, .precision = precision, .last = last, .reach = INFINITY
  };
  s->start = _acb_vec_init(s->n + 1);
  s->place = _acb_vec_init(MOST_PLACES);
  return s;
}
