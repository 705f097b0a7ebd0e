/* Many crawlers at once, with the chosen gait, in the order of the rows */
#include "explorer/core.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "numerics/digits.h"

enum { CLASSES = 256 };

/* The last class collects all further classes. */
static char class_text[CLASSES][2 * SCALLOP_MODES_TEXT + 16];
static struct scallop_modes class_modes[CLASSES][2];
static enum scallop_regime class_regime[CLASSES];
static int classes;

static bool same_modes(const struct scallop_modes *a, const struct scallop_modes *b)
{
  int kept = a->count < SCALLOP_MODES_KEPT ? a->count : SCALLOP_MODES_KEPT;
  return a->count == b->count && memcmp(a->kept, b->kept, (size_t)kept * sizeof *a->kept) == 0;
}

static int class_of(enum scallop_regime regime, const struct scallop_modes modes[2])
{
  static int last;
  for (int k = 0; k < classes; k++) {
    int i = (last + k) % classes; /* usually the neighbour's */
    if (class_regime[i] == regime && same_modes(&modes[0], &class_modes[i][0])
        && same_modes(&modes[1], &class_modes[i][1]))
      return last = i;
  }
  if (classes >= CLASSES - 1) {
    classes = CLASSES;
    strcpy(class_text[CLASSES - 1], "other modes");
    return CLASSES - 1;
  }
  char phases[2][SCALLOP_MODES_TEXT];
  for (int i = 0; i < 2; i++)
    scallop_modes_text(&modes[i], phases[i]);
  snprintf(class_text[classes], sizeof class_text[classes], "%s: %s | %s", scallop_regime_text(regime), phases[0],
           phases[1]);
  memcpy(class_modes[classes], modes, sizeof class_modes[classes]);
  class_regime[classes] = regime;
  return last = classes++;
}

const char *class_name(int i) { return class_text[i]; }
void forget_classes(void) { classes = 0; }

void steady_states(int count, int with_work, int digits)
{
  static const struct scallop_gait *gaits[EXPLORER_MOST];
  static enum scallop_regime regime[EXPLORER_MOST];
  static struct scallop_modes modes[EXPLORER_MOST][2];
  static enum scallop_status status[EXPLORER_MOST];
  double(*at)[EXPLORER_MOST] = explorer_rows;
  for (int i = 0; i < count; i++)
    gaits[i] = explorer_crawler.gait;
  const struct scallop_crawlers crawlers = { count, at[0], at[1], at[2], at[3], at[4], at[5], at[6], gaits };
  const struct scallop_steady_states states = { .froude = at[7],
                                                .v_start = at[8],
                                                .v_mid = at[9],
                                                .displacement = at[10],
                                                .mean_velocity = at[11],
                                                .multiplier = at[12],
                                                .regime = regime,
                                                .modes = modes,
                                                .status = status };
  steady_batch_in(&crawlers, &states, (enum digits)digits, 1);
  for (int i = 0; i < count; i++) {
    const struct scallop_crawler c = explorer_row_crawler(i);
    at[13][i] = status[i] < 0 ? -1 : class_of(regime[i], modes[i]);
    at[14][i] = NAN;
    if (with_work && status[i] >= 0)
      scallop_friction_work(&c, at[8][i], at[9][i], &at[14][i]);
  }
}
