/* What stands in the tables of a scene: '#' lines, columns and rows. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/scenes/parts.h"

/* Has the table a column of that name with something else in it, as "T = alpha*T"? */
static bool is_renamed(const struct scene *s, const struct scene_want *w, const char *parameter)
{
  for (int i = 0; i < w->sheet.count; i++) {
    const struct sheet_column *c = &w->sheet.column[i];
    if (strcmp(c->name, parameter) == 0
        && (c->quantity < 0 || strcmp(s->asked.quantities.item[c->quantity].name, parameter) != 0))
      return true;
  }
  return false;
}

/* What was given on the command line in place of the scene's; false: nothing was. */
static bool note_given(struct table *t, const struct running *r, const struct scene_want *w)
{
  const struct scene_options *o = r->options;
  char text[1024];
  size_t used = 0;
  for (int i = 0; i <= CRAWLER_NUMBERS && used < sizeof text; i++) {
    const char *given = i < CRAWLER_NUMBERS         ? o->request.point.written[i]
                        : o->request.point.has_gait ? o->request.point.crawler.gait->name
                                                    : NULL;
    if (given)
      used += (size_t)snprintf(text + used, sizeof text - used, " %s=%s%s", crawler_parameters[i], given,
                               is_renamed(r->scene, w, crawler_parameters[i]) ? " (of the crawler, not the column)"
                                                                              : "");
  }
  if (used > 0)
    table_note(t, "in place of what the scene says of them:%s", text);
  return used > 0;
}

/* Is the parameter the same in all rows? Not where it varies; nor L, T and alpha among gaits of which a measured one
 * brings its own. */
static bool is_held(const struct scene *s, const char *parameter)
{
  const struct sweep_variable *v;
  int place = crawler_place(parameter);
  bool is_own = place < CRAWLER_NUMBERS && strchr("LTa", *parameter) && !s->base.written[place];
  for (int i = 0; (v = sweep_variable(&s->sweep, i)); i++) {
    if (v->target != TARGET_LABEL && strcmp(v->sets, parameter) == 0)
      return false;
    for (long k = 0; is_own && v->target == TARGET_GAIT && k < v->count; k++)
      if (strncmp(v->texts[k], "measured:", 9) == 0)
        return false;
  }
  return true;
}

static void note_held(struct output *o, const struct scene *s)
{
  const char *not_held[CRAWLER_NUMBERS + 2] = { NULL };
  int count = 0;
  for (const char *const *name = crawler_parameters; *name; name++)
    if (!is_held(s, *name) || is_renamed(s, o->want, *name))
      not_held[count++] = *name;
  note_parameters(&o->table, &s->base, not_held, false);
}

/* Does anything in this table depend on the phase and its start? */
static bool has_start(const struct scene *s, const struct scene_want *w)
{
  bool has = w->kind == WANT_TRAJECTORY;
  int places[WANT_QUANTITIES];
  for (int i = want_quantities(w, places); i-- > 0 && !has;) {
    const struct quantity *q = &s->asked.quantities.item[places[i]];
    has = quantity_is_of_phase(&s->asked.quantities, q) || q->kind == QUANTITY_V0 || q->kind == QUANTITY_PHASE_NAME;
  }
  return has;
}

static void note_start(struct table *t, const struct scene *s, const struct scene_want *w)
{
  char v0[NUMBER_TEXT];
  if (!has_start(s, w))
    return;
  number_text(v0, s->base.v0, 0);
  const char *start = s->varies_v0 ? "v0" : s->start == START_REST ? "rest" : s->start == START_STEADY ? "steady" : v0;
  if (w->kind == WANT_TRAJECTORY)
    table_note(t, "start: %s", start);
  else
    table_note(t, "phase: %s, from %s", s->phase == SCALLOP_EXTENSION ? "extension" : "contraction", start);
}

void output_begin(const struct running *r, struct output *o)
{
  struct table *t = &o->table;
  const struct scene *s = r->scene;
  table_command(t, "run %s%s", s->name, strcmp(s->name, "-") == 0 ? "" : ".cfg");
  if (s->title)
    table_note(t, "%s", s->title);
  bool given = note_given(t, r, o->want);
  for (int i = 0; i < s->notes && !given; i++) /* with other parameters they may be wrong */
    table_note(t, "%s", s->note[i]);
  note_held(o, s);
  note_start(t, s, o->want);
  sheet_head(&o->want->sheet, t);
  if (o->want->kind == WANT_ORDERS)
    table_columns(t, order_columns);
  table_begin_rows(t);
}
