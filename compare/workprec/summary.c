#include <math.h>
#include <string.h>

#include "compare/workprec/setting.h"

static bool is_any(enum method_kind kind) { return kind != METHOD_OTHER; }
static bool is_exact(enum method_kind kind) { return kind == METHOD_EXACT; }
static bool is_rival(enum method_kind kind) { return kind == METHOD_ROOT || kind == METHOD_SIMULATION; }
static bool is_simulation(enum method_kind kind) { return kind == METHOD_SIMULATION; }

/* What is compared: the cheapest of these kinds, by its time over that of the cheapest of all, or of the cheapest exact
 * one */
static const struct comparison {
  const char *columns[4];
  bool (*is_kind)(enum method_kind);
  bool of_another_method, over_exact;
} comparisons[] = {
  { { "next_method", "next_setting", "next_ratio", NULL }, is_any, true, false },
  { { "exact_method", "exact_setting", "exact_ratio", NULL }, is_exact, false, false },
  { { "rival_method", "rival_setting", "rival_over_exact", NULL }, is_rival, false, true },
  { { "simulation_method", "simulation_setting", "simulation_over_exact", NULL }, is_simulation, false, true },
};
enum { COMPARISONS = sizeof comparisons / sizeof *comparisons };

void summary_begin(struct table *t)
{
  static const char *const first[] = { "gait", "T", "quantity", "wanted_error", "method", "setting", "error", NULL };
  table_columns(t, first);
  for (int i = 0; i < COMPARISONS; i++)
    table_columns(t, comparisons[i].columns);
}

/* The one of a kind, and of a method other than this one, that reaches the error in the least time; NULL if none
 * does. */
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
  for (int i = 0; i < COMPARISONS; i++) {
    const struct comparison *c = &comparisons[i];
    const struct setting *to = c->over_exact ? exact : best;
    const struct setting *s = cheapest(settings, quantity, error_log10, c->is_kind,
                                       c->of_another_method ? best->method : NULL);
    table_text(t, s ? s->method : "-");
    table_text(t, s ? s->text : "-");
    table_rounded(t, s && to ? printed_seconds(s->time.median) / printed_seconds(to->time.median) : NAN, "%.3g");
  }
}

void summary_write(struct table *table, const struct settings *settings)
{
  static const double wanted[] = { -2, -4, -6, -8, -10, -12, -15, -30, -100 };
  for (int quantity = 0; quantity < COMPARED; quantity++)
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
      write_wanted(table, settings, quantity, wanted[i]);
}
