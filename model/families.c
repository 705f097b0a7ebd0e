#include "model/families.h"

#include <string.h>

#define ADDRESS(family, law) &scallop_family_##family,
static const struct scallop_gait_family *const families[] = { SCALLOP_GAIT_FAMILIES(ADDRESS) };
enum { FAMILIES = sizeof families / sizeof *families };

const size_t scallop_made_gait_size = sizeof(union scallop_made_gait);

const struct scallop_gait_family *scallop_gait_family(int i) { return i >= 0 && i < FAMILIES ? families[i] : NULL; }

const struct scallop_gait *scallop_gait_named(const char *name)
{
  for (int i = 0; i < FAMILIES; i++)
    if (families[i]->fixed && strcmp(name, families[i]->name) == 0)
      return families[i]->fixed;
  return NULL;
}

const char *scallop_gait_name(int i) { return i >= 0 && i < FAMILIES && families[i]->fixed ? families[i]->name : NULL; }

static bool is_count(const struct scallop_gait_family *family, int count)
{
  if (!family->make)
    return false;
  return family->each == 0 ? count >= 1 && count <= SCALLOP_GAIT_NUMBERS
                           : count == family->each || count == 2 * family->each;
}

enum scallop_status scallop_make_gait(union scallop_made_gait *made, const struct scallop_gait_family *family,
                                      const char *name, const double *x, int count, const char **why)
{
  double both[SCALLOP_GAIT_NUMBERS];
  *why = NULL;
  if (!is_count(family, count))
    return SCALLOP_EDOMAIN;
  int all = family->each == 0 ? count : 2 * family->each;
  for (int i = 0; i < all; i++)
    both[i] = x[i % count];
  return family->make(made, name, both, all, why);
}
