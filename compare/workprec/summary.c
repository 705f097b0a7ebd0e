/* Who is cheapest for a wanted error. */
#include <math.h>
#include <string.h>

#include "compare/text/table.h"
#include "compare/workprec/workprec.h"

const char *const summary_columns[] = { "gait",
                                        "T",
                                        "quantity",
                                        "wanted_error",
                                        "method",
                                        "setting",
                                        "error",
                                        "next_method",
                                        "next_setting",
                                        "next_ratio",
                                        "exact_method",
                                        "exact_setting",
                                        "exact_ratio",
                                        "rival_method",
                                        "rival_setting",
                                        "rival_over_exact",
                                        "simulation_method",
                                        "simulation_setting",
                                        "simulation_over_exact",
                                        NULL };

static bool is_any(enum way_kind kind) { return kind != WAY_ASIDE && kind != WAY_LEFT_OUT; }
static bool is_exact(enum way_kind kind) { return kind == WAY_EXACT; }
static bool is_rival(enum way_kind kind) { return kind == WAY_ROOT || kind == WAY_SIMULATION; }
static bool is_simulation(enum way_kind kind) { return kind == WAY_SIMULATION; }

/* The one of a kind, and of a method other than this one, that reaches the error in the least time; NULL if none does. */
static const struct way *cheapest(const struct ways *ways, int quantity, double error_log10, bool (*is_kind)(enum way_kind),
                                  const char *other_than)
{
  const struct way *best = NULL;
  for (int i = 0; i < ways->count; i++) {
    const struct way *way = &ways->list[i];
    if (!way->solved || !is_kind(way->kind) || !(way->error_log10[quantity] <= error_log10)
        || (other_than && strcmp(way->method, other_than) == 0))
      continue;
    if (!best || way_seconds(way->time.median) < way_seconds(best->time.median))
      best = way;
  }
  return best;
}

/* A way, and how many times as long as the other one it takes */
static void write_ratio(struct table *t, const struct way *way, const struct way *to)
{
  table_text(t, way ? way->method : "-");
  table_text(t, way ? way->setting : "-");
  table_rounded(t, way && to ? way_seconds(way->time.median) / way_seconds(to->time.median) : NAN, "%.3g");
}

static void write_wanted(struct table *t, const struct ways *ways, int quantity, double error_log10)
{
  const struct way *best = cheapest(ways, quantity, error_log10, is_any, NULL);
  const struct way *exact = cheapest(ways, quantity, error_log10, is_exact, NULL);
  char text[WAY_TEXT];
  if (!best)
    return;
  table_text(t, best->point->crawler.gait->name);
  table_number(t, best->point->crawler.T);
  table_text(t, way_quantities[quantity]);
  snprintf(text, sizeof text, "1e%.0f", error_log10);
  table_digits(t, text);
  table_text(t, best->method);
  table_text(t, best->setting);
  table_digits(t, best->error[quantity]);
  write_ratio(t, cheapest(ways, quantity, error_log10, is_any, best->method), best);
  write_ratio(t, exact, best);
  write_ratio(t, cheapest(ways, quantity, error_log10, is_rival, NULL), exact);
  write_ratio(t, cheapest(ways, quantity, error_log10, is_simulation, NULL), exact);
}

void summary_write(struct table *table, const struct ways *ways)
{
  static const double wanted[] = { -2, -4, -6, -8, -10, -12, -15, -30, -100 };
  for (int quantity = 0; quantity < WAY_QUANTITIES; quantity++)
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
      write_wanted(table, ways, quantity, wanted[i]);
}
