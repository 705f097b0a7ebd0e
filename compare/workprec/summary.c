#include <math.h>
#include <string.h>

#include "compare/workprec/setting.h"

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

static bool is_any(enum method_kind kind) { return kind != METHOD_OTHER; }
static bool is_exact(enum method_kind kind) { return kind == METHOD_EXACT; }
static bool is_rival(enum method_kind kind) { return kind == METHOD_ROOT || kind == METHOD_SIMULATION; }
static bool is_simulation(enum method_kind kind) { return kind == METHOD_SIMULATION; }

/* The one of a kind, and of a method other than this one, that reaches the error in the least time; NULL if none does. */
static const struct setting *cheapest(const struct settings *settings, int quantity, double error_log10,
                                      bool (*is_kind)(enum method_kind), const char *other_than)
{
  const struct setting *best = NULL;
  for (int i = 0; i < settings->count; i++) {
    const struct setting *s = &settings->list[i];
    if (!s->solved || !is_kind(s->kind) || !(s->error_log10[quantity] <= error_log10)
        || (other_than && strcmp(s->method, other_than) == 0))
      continue;
    if (!best || printed_seconds(s->time.median) < printed_seconds(best->time.median))
      best = s;
  }
  return best;
}

/* A s, and how many times as long as the other one it takes */
static void write_ratio(struct table *t, const struct setting *s, const struct setting *to)
{
  table_text(t, s ? s->method : "-");
  table_text(t, s ? s->text : "-");
  table_rounded(t, s && to ? printed_seconds(s->time.median) / printed_seconds(to->time.median) : NAN, "%.3g");
}

static void write_wanted(struct table *t, const struct settings *settings, int quantity, double error_log10)
{
  const struct setting *best = cheapest(settings, quantity, error_log10, is_any, NULL);
  const struct setting *exact = cheapest(settings, quantity, error_log10, is_exact, NULL);
  char text[SETTING_TEXT];
  if (!best)
    return;
  table_text(t, best->reference->crawler.gait->name);
  table_number(t, best->reference->crawler.T);
  table_text(t, quantity_rows[compared[quantity]].name);
  snprintf(text, sizeof text, "1e%.0f", error_log10);
  table_digits(t, text);
  table_text(t, best->method);
  table_text(t, best->text);
  table_digits(t, best->error[quantity]);
  write_ratio(t, cheapest(settings, quantity, error_log10, is_any, best->method), best);
  write_ratio(t, exact, best);
  write_ratio(t, cheapest(settings, quantity, error_log10, is_rival, NULL), exact);
  write_ratio(t, cheapest(settings, quantity, error_log10, is_simulation, NULL), exact);
}

void summary_write(struct table *table, const struct settings *settings)
{
  static const double wanted[] = { -2, -4, -6, -8, -10, -12, -15, -30, -100 };
  for (int quantity = 0; quantity < COMPARED; quantity++)
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
      write_wanted(table, settings, quantity, wanted[i]);
}
