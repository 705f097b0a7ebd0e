#include "compare/answers/quantities.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/formulas/formula_file.h"
#include "compare/points/point.h"
#include "compare/text/message.h"

const struct quantity_row quantity_rows[] = {
  [Q_FROUDE] = { "froude", "1", "M L / (T^2 (F1 + F2))", .kind = QUANTITY_RATIO, .which = FROUDE },
  [Q_V_START] = { "v_start", "length/time", "velocity of both bodies at the start of the extension", OF_STEADY,
                  .has_series = true },
  [Q_V_MID] = { "v_mid", "length/time", "velocity of both bodies at the start of the contraction", OF_STEADY,
                .has_series = true },
  [Q_DISPLACEMENT] = { "displacement", "length", "displacement of the geometric centre over a period", OF_STEADY,
                       .has_series = true },
  [Q_MEAN_VELOCITY] = { "mean_velocity", "length/time", "displacement / T", OF_STEADY, .has_series = true },
  [Q_MULTIPLIER] = { "multiplier", "1",
                     "derivative of the period map: the factor by which a deviation decays in a period",
                     .of = OF_STEADY },
  [Q_T1] = { "t1", "time", "first change of mode after the start of the phase; nan: the mode does not change", OF_PHASE,
             .has_series = true },
  [Q_DT] = { "dT", "time", "from the last change of mode to the end of the phase; nan: the mode does not change",
             OF_PHASE, .has_series = true },
  [Q_V_END] = { "v_end", "length/time", "velocity of both bodies at the end of the phase", OF_PHASE,
                .has_series = true },
  [Q_DX1] = { "dx1", "length", "displacement of body 1", OF_PHASE, .has_series = true },
  [Q_DX2] = { "dx2", "length", "displacement of body 2", OF_PHASE, .has_series = true },
  [Q_DXC] = { "dxC", "length", "displacement of the geometric centre (x1 + x2)/2", OF_PHASE, .has_series = true },
  [Q_FRICTION_WORK] = { "friction_work", "force length",
                        "energy that friction takes in a period: F1 and F2 times how far the bodies slide", OF_STEADY,
                        .has_series = true },
  [Q_COST_OF_TRANSPORT] = { "cost_of_transport", "1",
                            "friction_work / ((F1 + F2) abs(displacement)); nan: the displacement is 0", OF_STEADY,
                            .has_series = true },

  { "mean_power", "force length/time", "friction_work / T: the power that friction takes", OF_STEADY,
    .kind = QUANTITY_FORMULA, .formula = "friction_work/T" },

  { "m1", .kind = QUANTITY_NUMBER, .which = 0 },
  { "m2", .kind = QUANTITY_NUMBER, .which = 1 },
  { "F1", .kind = QUANTITY_NUMBER, .which = 2 },
  { "F2", .kind = QUANTITY_NUMBER, .which = 3 },
  { "L", .kind = QUANTITY_NUMBER, .which = 4 },
  { "T", .kind = QUANTITY_NUMBER, .which = 5 },
  { "alpha", .kind = QUANTITY_NUMBER, .which = 6 },
  { "v0", .kind = QUANTITY_NUMBER, .which = PLACE_OF_V0 },
  { "F1_over_F2", .kind = QUANTITY_RATIO, .which = F1_OVER_F2 },
  { "mu1", .kind = QUANTITY_RATIO, .which = MU1 },
  { "mu2", .kind = QUANTITY_RATIO, .which = MU2 },
  { "m1_over_m2", .kind = QUANTITY_RATIO, .which = M1_OVER_M2 },
  { "gait", .kind = QUANTITY_GAIT },
  { "phase", .kind = QUANTITY_PHASE_NAME },
  { "sticking_onset", NULL, "the longest period at which an extension from rest does not stick",
    .kind = QUANTITY_ONSET },
  { "status", NULL, "ok, or why there is no answer", .kind = QUANTITY_STATUS },
  { "regime", .kind = QUANTITY_REGIME },
  { "modes", "1", "directions of bodies 1 and 2: + forward, - backward, 0 stuck", .kind = QUANTITY_MODES },
  { "motion", NULL, "the modes in words, with their times", .kind = QUANTITY_WORDS },
  { "phase_regime", .of = OF_PHASE, .kind = QUANTITY_REGIME },
  { "phase_modes", .of = OF_PHASE, .kind = QUANTITY_MODES },
  { "phase_motion", .of = OF_PHASE, .kind = QUANTITY_WORDS },
  { "first_transition", NULL, "along T, as `breakdown` has it", .kind = QUANTITY_STUDIED_TEXT,
    .which = STUDIED_TRANSITION },
  { "first_transition_T", .kind = QUANTITY_STUDIED, .which = STUDIED_TRANSITION_T },
  { "first_transition_froude", .kind = QUANTITY_FORMULA,
    .formula = "(m1 + m2)/(F1 + F2)*L/first_transition_T/first_transition_T" },
  { "reversals", NULL, "reversals along T", .kind = QUANTITY_STUDIED_TEXT, .which = STUDIED_REVERSALS },
  { "best_order", NULL, "the terms below T^best_order have the least error of the displacement at this T",
    .kind = QUANTITY_STUDIED, .which = STUDIED_BEST_ORDER },
  { "best_error", NULL, "that error", .kind = QUANTITY_STUDIED, .which = STUDIED_BEST_ERROR },
  /* in a trajectory, at a time */
  { "t", .kind = QUANTITY_SAMPLE, .which = SAMPLE_T },
  { "x1", .kind = QUANTITY_SAMPLE, .which = SAMPLE_X1 },
  { "x2", .kind = QUANTITY_SAMPLE, .which = SAMPLE_X2 },
  { "xC", .kind = QUANTITY_SAMPLE, .which = SAMPLE_XC },
  { "v1", .kind = QUANTITY_SAMPLE, .which = SAMPLE_V1 },
  { "v2", .kind = QUANTITY_SAMPLE, .which = SAMPLE_V2 },
  { "l", .kind = QUANTITY_SAMPLE, .which = SAMPLE_L },
  { .name = NULL }
};

/* Returns the row called name, or the last row, with name NULL. */
static const struct quantity_row *row_named(const char *name)
{
  const struct quantity_row *row = quantity_rows;
  while (row->name && strcmp(row->name, name) != 0)
    row++;
  return row;
}

enum quantity_id quantity_of_name(const char *name)
{
  ptrdiff_t place = row_named(name) - quantity_rows;
  return place < NAMED_QUANTITIES ? (enum quantity_id)place : NAMED_QUANTITIES;
}

const struct column_meaning *quantity_meaning(const char *name)
{
  static struct column_meaning meaning;
  const struct quantity_row *row = row_named(name);
  bool is_modes = row->kind == QUANTITY_MODES;
  if (!row->unit)
    return NULL;
  meaning = (struct column_meaning){ strcmp(row->unit, "1") == 0 ? "" : row->unit, row->sentence, is_modes,
                                     is_modes ? "| ends the extension" : NULL };
  return &meaning;
}

/* The quantities of formulas in an extension and in a contraction, in which the bodies exchange their roles */
static const struct {
  enum quantity_id id[2];
  const char *text[2];
} about[] = {
  [SCALLOP_LAG] = { { Q_DT, Q_DT }, { "dT", "dT" } },
  [SCALLOP_FIRST_SWITCH] = { { Q_T1, Q_T1 }, { "t1", "t1" } },
  [SCALLOP_REAR_AT_FIRST] = { { Q_AT_FIRST, Q_AT_FIRST }, { "x1(t1)", "x2(t1)" } },
  [SCALLOP_REAR_AT_LAST] = { { Q_AT_LAST, Q_AT_LAST }, { "x1(T-dT)", "x2(T-dT)" } },
  [SCALLOP_REAR_AT_END] = { { Q_DX1, Q_DX2 }, { "x1(T)", "x2(T)" } },
  [SCALLOP_FRONT_AT_END] = { { Q_DX2, Q_DX1 }, { "x2(T)", "x1(T)" } },
  [SCALLOP_CENTRE_AT_END] = { { Q_DXC, Q_DXC }, { "dxC", "dxC" } },
  [SCALLOP_VELOCITY_AT_END] = { { Q_V_END, Q_V_END }, { "v(T)", "v(T)" } },
  [SCALLOP_VELOCITY_CHANGE] = { { Q_CHANGE, Q_CHANGE }, { "v(T)-v0", "v(T)-v0" } },
  [SCALLOP_STEADY_VELOCITY] = { { Q_V_START, Q_V_START }, { "v_start", "v_start" } },
  [SCALLOP_STEADY_V_MID] = { { Q_V_MID, Q_V_MID }, { "v_mid", "v_mid" } },
  [SCALLOP_STEADY_DISPLACEMENT] = { { Q_DISPLACEMENT, Q_DISPLACEMENT }, { "displacement", "displacement" } },
  [SCALLOP_STEADY_MEAN_VELOCITY] = { { Q_MEAN_VELOCITY, Q_MEAN_VELOCITY }, { "mean_velocity", "mean_velocity" } },
  [SCALLOP_STEADY_FRICTION_WORK] = { { Q_FRICTION_WORK, Q_FRICTION_WORK }, { "friction_work", "friction_work" } },
  [SCALLOP_VELOCITY_AT_FIRST] = { { Q_TURNING, Q_TURNING }, { "v(t1)", "v(t1)" } },
  [SCALLOP_VELOCITY_AT_LAST] = { { Q_TURNING, Q_TURNING }, { "v(T-dT)", "v(T-dT)" } },
};

enum quantity_id quantity_of_formula(const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  return about[f->quantity].id[kind];
}

const char *formula_quantity_text(const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  return about[f->quantity].text[kind];
}

bool formula_takes_given(const struct scallop_formula *f)
{
  return formula_takes(f, SCALLOP_SYMBOL_t1) || formula_takes(f, SCALLOP_SYMBOL_dT)
         || formula_takes(f, SCALLOP_SYMBOL_x_switch);
}

/* The prefixes of names, and the kind of name that follows each: a number of a motion, or a series */
static const struct prefix {
  const char *text;
  enum quantity_kind kind;
  int which;
  enum { OF_ANSWER, OF_NUMBER, OF_SERIES, OF_STEADY_SERIES, OF_STEADY_FORMULA } of;
} prefixes[] = {
  { "certified.", QUANTITY_CERTIFIED, 0, OF_ANSWER },
  { "derived_", QUANTITY_DERIVED, 0, OF_ANSWER }, /* followed by the order and a dot */
  { "limit.", QUANTITY_LIMIT, 0, OF_ANSWER },
  { "exact.", QUANTITY_EXACT, 0, OF_SERIES },
  { "error.", QUANTITY_ERROR, 0, OF_SERIES },
  { "relative.", QUANTITY_RELATIVE, 0, OF_SERIES },
  { "low.", QUANTITY_DATA, -1, OF_NUMBER },
  { "high.", QUANTITY_DATA, 1, OF_NUMBER },
  { "reach_", QUANTITY_STUDIED, STUDIED_REACH, OF_STEADY_SERIES }, /* followed by the tolerance and a dot */
  { "value.", QUANTITY_STUDIED, STUDIED_VALUE, OF_STEADY_SERIES },
  { "deviation.", QUANTITY_STUDIED, STUDIED_DEVIATION, OF_STEADY_SERIES },
  { "error_limit.", QUANTITY_STUDIED, STUDIED_ERROR_LIMIT, OF_STEADY_SERIES },
  { "verdict.", QUANTITY_STUDIED_TEXT, STUDIED_VERDICT, OF_STEADY_FORMULA },
  { "order.", QUANTITY_STUDIED, STUDIED_ORDER, OF_STEADY_FORMULA },
  { .text = NULL },
};

/* Returns the prefix of the name, or the last one, with text NULL. */
static const struct prefix *prefix_of(const char *name)
{
  const struct prefix *p = prefixes;
  while (p->text && strncmp(name, p->text, strlen(p->text)) != 0)
    p++;
  return p;
}

/* Reads the number at the end of a prefix. Returns the text behind its dot, or NULL. */
static const char *read_number_of(struct quantity *q, const char *text)
{
  enum { MAX_ORDER = 1000 };
  char *end;
  double x = strtod(text, &end);
  if (*text < '0' || *text > '9')
    return NULL;
  end -= end[-1] == '.'; /* the dot of "8." ends the prefix */
  bool fits = x > 0;
  if (q->kind == QUANTITY_DERIVED) {
    q->order = x <= MAX_ORDER ? (long)x : 0;
    fits = q->order > 0 && x == (double)q->order;
  } else
    q->tolerance = x;
  return fits && *end == '.' ? end + 1 : NULL;
}

/* Sets the quantity with this prefix and the rest of its name. Returns 0, or the negative result of quantity_named. */
static int prefixed_named(struct quantity *q, struct quantities *all, const struct prefix *p, const char *rest)
{
  q->kind = p->kind;
  q->which = p->which;
  if (p->text[strlen(p->text) - 1] == '_' && !(rest = read_number_of(q, rest)))
    return -1;
  if (p->of == OF_ANSWER) {
    const struct quantity_row *row = &quantity_rows[q->which = (int)quantity_of_name(rest)];
    q->motion = row->of;
    return q->which < NAMED_QUANTITIES && (row->has_series || q->kind == QUANTITY_CERTIFIED) ? 0 : -1;
  }
  q->of = quantity_named(all, rest);
  if (q->of < 0)
    return q->of;
  struct quantity *series = &all->item[q->of];
  q->motion = series->motion;
  q->phase = series->phase;
  q->from_rest = series->from_rest;
  if (p->of == OF_NUMBER)
    return quantity_is_text(series) ? -1 : 0;
  bool fits = quantity_is_series(series) && (p->of == OF_SERIES || series->motion == OF_STEADY)
              && (p->of != OF_STEADY_FORMULA || series->kind == QUANTITY_PUBLISHED);
  series->is_compared |= fits && p->of == OF_SERIES;
  return fits ? 0 : -1;
}

/* Sets the quantity if name is like "v_start_error". Returns false if it is not. */
static bool estimate_named(struct quantity *q, const char *name)
{
  char of[QUANTITY_NAME];
  int length = (int)strlen(name) - (int)strlen("_error");
  if (length < 0 || strcmp(name + length, "_error") != 0)
    return false;
  snprintf(of, sizeof of, "%.*s", length, name);
  q->kind = QUANTITY_ESTIMATE;
  q->which = (int)quantity_of_name(of);
  q->motion = quantity_rows[q->which].of;
  return q->which < QUANTITIES;
}

/* Sets the quantity if name is a formula, with ":contraction" behind a formula that holds for both phases. Returns
 * false if it is not. */
static bool published_named(struct quantity *q, const char *name)
{
  static const char *const phases[] = { "extension", "contraction", NULL };
  char text[QUANTITY_NAME];
  const char *colon = strrchr(name, ':');
  q->phase = colon ? word_place(colon + 1, phases) : -1;
  snprintf(text, sizeof text, "%.*s", q->phase < 0 ? (int)strlen(name) : (int)(colon - name), name);
  const struct scallop_formula *f = formula_named(text);
  if (!f || (q->phase >= 0 && f->setting != SCALLOP_AT_REST_START))
    return false;
  if (f->setting == SCALLOP_MOVING_EXTENSION || f->setting == SCALLOP_MOVING_CONTRACTION)
    q->phase = f->setting == SCALLOP_MOVING_EXTENSION ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
  q->kind = QUANTITY_PUBLISHED;
  q->formula = f;
  q->motion = f->setting == SCALLOP_STEADY ? OF_STEADY : OF_PHASE;
  q->from_rest = f->setting == SCALLOP_AT_REST_START;
  return true;
}

/* Returns the place of the name in the list, or -1. */
static int place_among(const char *const *names, int count, const char *name)
{
  int i = count - 1;
  while (i >= 0 && strcmp(names[i], name) != 0)
    i--;
  return i;
}

/* Sets the quantity if name is a label, a column of a file, or a plain name. A label or column hides a number of a
 * motion, but not a parameter. */
static bool plain_named(struct quantity *q, const struct quantities *all, const char *name)
{
  const struct quantity_row *row = row_named(name);
  bool gives_way = !row->name || row->kind == QUANTITY_ANSWER || row->kind == QUANTITY_SAMPLE
                   || row->kind == QUANTITY_FORMULA;
  int label = place_among(all->label, all->labels, name), carried = place_among(all->carried, all->carries, name);
  if (gives_way && (label >= 0 || carried >= 0)) {
    q->kind = label >= 0 ? QUANTITY_LABEL : QUANTITY_CARRIED;
    q->which = label >= 0 ? label : carried;
    return true;
  }
  q->kind = row->kind;
  q->which = row->kind == QUANTITY_ANSWER ? (int)(row - quantity_rows) : row->which;
  q->motion = row->of;
  return row->name || published_named(q, name) || estimate_named(q, name);
}

bool quantity_is_other(const char *name)
{
  static const struct quantities none = { .count = 0 };
  struct quantity q = { .phase = -1 };
  return prefix_of(name)->text || (plain_named(&q, &none, name) && q.kind != QUANTITY_PUBLISHED);
}

static int place_in(const struct quantities *all, const char *name)
{
  int i = all->count - 1;
  while (i >= 0 && strcmp(all->item[i].name, name) != 0)
    i--;
  return i;
}

/* Returns the place, or -2: the list is full. */
static int add(struct quantities *all, const struct quantity *q)
{
  if (all->count == MAX_QUANTITIES)
    return -2;
  all->item[all->count] = *q;
  return all->count++;
}

static int place_of(void *quantities, const char *name) { return quantity_named(quantities, name); }

int quantity_of_text(struct quantities *all, const char *name, const char *text)
{
  const struct formula_names names = { .place = place_of, .context = all };
  struct quantity q = { .kind = QUANTITY_FORMULA, .of = -1, .phase = -1, .own = malloc(sizeof *q.own) };
  char wrong[FORMULA_MESSAGE];
  snprintf(q.name, sizeof q.name, "%s", name);
  int place = place_in(all, q.name);
  if (place < 0 && q.own && !formula_read(q.own, text, &names, wrong))
    place = add(all, &q);
  if (place < 0 || all->item[place].own != q.own)
    free(q.own);
  return place;
}

int quantity_named(struct quantities *all, const char *name)
{
  struct quantity q = { .of = -1, .phase = -1 };
  const struct prefix *prefix = prefix_of(name);
  int place = place_in(all, name);
  if (place >= 0 || strlen(name) >= QUANTITY_NAME)
    return place;
  snprintf(q.name, sizeof q.name, "%s", name);
  int found = prefix->text && place_among(all->carried, all->carries, name) < 0
                  ? prefixed_named(&q, all, prefix, name + strlen(prefix->text))
                  : (int)plain_named(&q, all, name) - 1;
  if (found < 0)
    return found;
  return q.kind == QUANTITY_FORMULA ? quantity_of_text(all, name, row_named(name)->formula) : add(all, &q);
}

const char *quantity_near(const struct quantities *all, const char *name)
{
  enum { MAX_NAMES = 160 };
  const char *names[MAX_NAMES + 1], *dot = strrchr(name, '.');
  const struct scallop_formula *f;
  int n = 0;
  for (const struct quantity_row *row = quantity_rows; row->name; row++)
    names[n++] = row->name;
  for (int i = 0; i < all->labels; i++)
    names[n++] = all->label[i];
  for (int i = 0; i < all->carries && n < MAX_NAMES; i++)
    names[n++] = all->carried[i];
  for (int i = 0; n < MAX_NAMES && (f = formula_at(i)); i++)
    names[n++] = f->name;
  names[n] = NULL;
  return nearest(dot ? dot + 1 : name, names); /* compares the last part */
}

struct requirements *requirements_new(const char *command)
{
  struct requirements *required = malloc(sizeof *required);
  if (required) {
    memset(required, 0, offsetof(struct requirements, quantities.item));
    required->command = command;
    required->accuracy = ACCURACY_OF_DOUBLES;
    required->digits = DIGITS_OF_DOUBLE;
  }
  return required;
}

void requirements_free(struct requirements *required)
{
  for (int i = 0; required && i < required->quantities.count; i++)
    free(required->quantities.item[i].own);
  for (int i = 0; required && i < required->quantities.labels; i++)
    free((char *)required->quantities.label[i]);
  free(required);
}

/* A change of velocity in doubles is a small difference of large numbers: its error is less accurate than 1e-10. */
bool errors_are_certified(const struct requirements *r)
{
  bool certifies = false, has = false;
  for (const struct quantity *q = r->quantities.item; q < r->quantities.item + r->quantities.count; q++) {
    has |= q->is_compared;
    certifies |= q->is_compared && q->formula && q->formula->quantity == SCALLOP_VELOCITY_CHANGE && r->accuracy > 0;
  }
  return certifies || (has && r->certified_errors);
}

const char *quantity_needing_flint(const struct requirements *r)
{
  bool certifies = errors_are_certified(r);
  for (const struct quantity *q = r->quantities.item; q < r->quantities.item + r->quantities.count; q++)
    if (q->kind == QUANTITY_CERTIFIED || q->kind == QUANTITY_DERIVED || q->kind == QUANTITY_LIMIT
        || q->kind == QUANTITY_STUDIED || q->kind == QUANTITY_STUDIED_TEXT || (certifies && quantity_is_comparison(q)))
      return q->name;
  return NULL;
}
