#include "compare/answers/quantities.h"
#include "compare/book/book.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point.h"
#include "compare/text/message.h"

const struct quantity_row quantity_rows[NAMED_QUANTITIES] = {
  [Q_FROUDE] = { "froude", "1", "M L / (T^2 (F1 + F2))", OF_STEADY, false },
  [Q_V_START] = { "v_start", "length/time", "velocity of both bodies at the start of the extension", OF_STEADY, true },
  [Q_V_MID] = { "v_mid", "length/time", "velocity of both bodies at the start of the contraction", OF_STEADY, true },
  [Q_DISPLACEMENT] = { "displacement", "length", "displacement of the geometric centre over a period", OF_STEADY,
                       true },
  [Q_MEAN_VELOCITY] = { "mean_velocity", "length/time", "displacement / T", OF_STEADY, true },
  [Q_MULTIPLIER] = { "multiplier", "1",
                     "derivative of the period map: the factor by which a deviation decays in a period", OF_STEADY,
                     false },
  [Q_T1] = { "t1", "time", "first change of mode after the start of the phase; nan: the mode does not change", OF_PHASE,
             true },
  [Q_DT] = { "dT", "time", "from the last change of mode to the end of the phase; nan: the mode does not change",
             OF_PHASE, true },
  [Q_V_END] = { "v_end", "length/time", "velocity of both bodies at the end of the phase", OF_PHASE, true },
  [Q_DX1] = { "dx1", "length", "displacement of body 1", OF_PHASE, true },
  [Q_DX2] = { "dx2", "length", "displacement of body 2", OF_PHASE, true },
  [Q_DXC] = { "dxC", "length", "displacement of the geometric centre (x1 + x2)/2", OF_PHASE, true },
  [Q_FRICTION_WORK] = { "friction_work", "force length",
                        "energy that friction takes in a period: F1 and F2 times how far the bodies slide", OF_STEADY,
                        true },
  [Q_COST_OF_TRANSPORT] = { "cost_of_transport", "1",
                            "friction_work / ((F1 + F2) abs(displacement)); nan: the displacement is 0", OF_STEADY,
                            true },
};

const struct formula_row formula_rows[] = {
  { "mean_power", "force length/time", "friction_work / T: the power that friction takes", "friction_work/T" },
  { .name = NULL },
};
enum { FORMULA_ROWS = sizeof formula_rows / sizeof *formula_rows - 1 };

enum quantity_id quantity_first(enum quantity_of of) { return of == OF_STEADY ? Q_FROUDE : FIRST_OF_PHASE; }
enum quantity_id quantity_end(enum quantity_of of) { return of == OF_STEADY ? FIRST_OF_PHASE : QUANTITIES; }

enum quantity_id quantity_of_name(const char *name)
{
  int q = 0;
  while (q < NAMED_QUANTITIES && strcmp(quantity_rows[q].name, name) != 0)
    q++;
  return (enum quantity_id)q;
}

const struct column_meaning *quantity_meaning(const char *name)
{
  static const struct column_meaning modes = { "", "directions of bodies 1 and 2: + forward, - backward, 0 stuck", true,
                                               "| ends the extension" };
  static struct column_meaning meaning;
  if (strcmp(name, "modes") == 0)
    return &modes;
  enum quantity_id q = quantity_of_name(name);
  const struct formula_row *row = formula_rows;
  while (row->name && strcmp(row->name, name) != 0)
    row++;
  const char *unit = q < NAMED_QUANTITIES ? quantity_rows[q].unit : row->unit;
  if (q == NAMED_QUANTITIES && !row->name)
    return NULL;
  meaning = (struct column_meaning){ strcmp(unit, "1") == 0 ? "" : unit,
                                     q < NAMED_QUANTITIES ? quantity_rows[q].sentence : row->sentence, false, NULL };
  return &meaning;
}

/* What formulas are about, in an extension and in a contraction: the bodies exchange their roles. */
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
  [SCALLOP_CENTRE_AT_END] = { { Q_DXC, Q_DXC }, { "x_C(T)", "x_C(T)" } },
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

enum { MOST_ORDER = 1000, MOST_NAMES = 160 };

/* Names of one thing each. The crawler's numbers, labels, the rows of the table and formulas have lists of their
 * own. */
static const struct {
  const char *name;
  enum quantity_kind kind;
  int which;
} single[] = { { "v0", QUANTITY_V0, 0 },
               { "froude", QUANTITY_FROUDE, 0 },
               { "gait", QUANTITY_GAIT, 0 },
               { "status", QUANTITY_STATUS, 0 },
               { "sticking_onset", QUANTITY_ONSET, 0 },
               { "phase", QUANTITY_PHASE_NAME, 0 },
               { "F1_over_F2", QUANTITY_F1_OVER_F2, 0 },
               { "m1_over_m2", QUANTITY_M1_OVER_M2, 0 },
               { "regime", QUANTITY_REGIME, OF_STEADY },
               { "modes", QUANTITY_MODES, OF_STEADY },
               { "motion", QUANTITY_WORDS, OF_STEADY },
               { "phase_motion", QUANTITY_WORDS, OF_PHASE },
               { "phase_regime", QUANTITY_REGIME, OF_PHASE },
               { "phase_modes", QUANTITY_MODES, OF_PHASE },
               { "first_event", QUANTITY_STUDIED, STUDIED_EVENT },
               { "first_event_T", QUANTITY_STUDIED, STUDIED_EVENT_T },
               { "first_event_froude", QUANTITY_STUDIED, STUDIED_EVENT_FROUDE },
               { "reversals", QUANTITY_STUDIED, STUDIED_REVERSALS },
               { "best_order", QUANTITY_STUDIED, STUDIED_BEST_ORDER },
               { "best_error", QUANTITY_STUDIED, STUDIED_BEST_ERROR } };
enum { SINGLE = sizeof single / sizeof *single };

/* What a name begins with, if it is about a row of the table or about a series */
static const struct {
  const char *text;
  enum quantity_kind kind;
  int which;
} prefixes[] = { { "exact.", QUANTITY_EXACT, 0 },
                 { "error.", QUANTITY_ERROR, 0 },
                 { "relative.", QUANTITY_RELATIVE, 0 },
                 { "certified.", QUANTITY_CERTIFIED, 0 },
                 { "limit.", QUANTITY_LIMIT, 0 },
                 { "derived_", QUANTITY_DERIVED, 0 },
                 { "reach_", QUANTITY_STUDIED, STUDIED_REACH },
                 { "value.", QUANTITY_STUDIED, STUDIED_VALUE },
                 { "deviation.", QUANTITY_STUDIED, STUDIED_DEVIATION },
                 { "error_limit.", QUANTITY_STUDIED, STUDIED_ERROR_LIMIT },
                 { "verdict.", QUANTITY_STUDIED, STUDIED_VERDICT },
                 { "order.", QUANTITY_STUDIED, STUDIED_ORDER } };
enum { PREFIXES = sizeof prefixes / sizeof *prefixes };

const char *const quantity_samples[SAMPLE_VALUES + 1] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };

/* The name at place i among all names without a prefix, and what it means; NULL: there are no more. Where two are the
 * same, the first one counts. */
static const char *name_at(const struct quantities *all, int i, struct quantity *q)
{
  enum { LISTS = 7 };
  static const enum quantity_kind kinds[LISTS] = { QUANTITY_NUMBER, QUANTITY_STATUS, QUANTITY_LABEL,  QUANTITY_CARRIED,
                                                   QUANTITY_SAMPLE, QUANTITY_ANSWER, QUANTITY_FORMULA };
  const int counts[LISTS] = { CRAWLER_NUMBERS, SINGLE,           all->labels, all->carries,
                              SAMPLE_VALUES,   NAMED_QUANTITIES, FORMULA_ROWS };
  int list = 0;
  for (; list < LISTS && i >= counts[list]; list++)
    i -= counts[list];
  q->kind = list < LISTS ? kinds[list] : QUANTITY_PUBLISHED;
  q->which = i;
  switch (list) {
  case 0: return crawler_parameters[i];
  case 1:
    q->kind = single[i].kind;
    q->which = single[i].which;
    return single[i].name;
  case 2: return all->label[i];
  case 3: return all->carried[i];
  case 4: return quantity_samples[i];
  case 5: return quantity_rows[i].name;
  case 6: return formula_rows[i].name;
  default: q->formula = formula_at(i); return q->formula ? q->formula->name : NULL;
  }
}

/* "v_start_error" */
static bool estimate_named(struct quantity *q, const char *name)
{
  char of[QUANTITY_NAME];
  size_t length = strlen(name);
  bool is = length > 6 && length < QUANTITY_NAME && strcmp(name + length - 6, "_error") == 0;
  snprintf(of, sizeof of, "%.*s", is ? (int)length - 6 : 0, name);
  q->kind = QUANTITY_ESTIMATE;
  q->which = (int)quantity_of_name(of);
  return is && q->which < QUANTITIES;
}

/* "rest_dT:contraction", of a formula that both phases have; others are of the one that they are printed for */
static bool published_named(struct quantity *q, const char *name)
{
  static const char *const phases[] = { [SCALLOP_EXTENSION] = ":extension", [SCALLOP_CONTRACTION] = ":contraction" };
  char formula[QUANTITY_NAME];
  const char *colon = strrchr(name, ':');
  q->kind = QUANTITY_PUBLISHED;
  for (int i = 0; colon && i < 2 && q->phase < 0; i++)
    q->phase = strcmp(colon, phases[i]) == 0 ? i : -1;
  snprintf(formula, sizeof formula, "%.*s", q->phase < 0 ? (int)strlen(name) : (int)(colon - name), name);
  q->formula = formula_named(formula);
  if (q->formula && q->phase >= 0 && q->formula->setting != SCALLOP_AT_REST_START)
    q->formula = NULL;
  if (q->formula && q->formula->setting == SCALLOP_MOVING_EXTENSION)
    q->phase = SCALLOP_EXTENSION;
  if (q->formula && q->formula->setting == SCALLOP_MOVING_CONTRACTION)
    q->phase = SCALLOP_CONTRACTION;
  return q->formula != NULL;
}

static bool plain_named(struct quantity *q, const struct quantities *all, const char *name)
{
  const char *other;
  for (int i = 0; (other = name_at(all, i, q)) && q->kind != QUANTITY_PUBLISHED; i++)
    if (strcmp(other, name) == 0)
      return true;
  return published_named(q, name) || estimate_named(q, name);
}

bool quantity_is_other(const char *name)
{
  static const struct quantities none = { .count = 0 };
  struct quantity q = { .phase = -1 };
  for (int i = 0; i < PREFIXES; i++)
    if (strncmp(name, prefixes[i].text, strlen(prefixes[i].text)) == 0)
      return true;
  return plain_named(&q, &none, name) && q.kind != QUANTITY_PUBLISHED;
}

/* Past the N. of derived_N., or NULL */
static const char *read_order(struct quantity *q, const char *text)
{
  char *end;
  if (*text < '1' || *text > '9')
    return NULL;
  q->order = strtol(text, &end, 10);
  return *end == '.' && q->order <= MOST_ORDER ? end + 1 : NULL;
}

/* Past the tolerance of a reach, or NULL */
static const char *read_tolerance(struct quantity *q, const char *text)
{
  char *end = NULL;
  q->tolerance = strtod(text, &end);
  if (*text < '0' || *text > '9')
    return NULL;
  return q->tolerance > 0 && *end == '.' ? end + 1 : NULL;
}

/* A study along T of a series of the steady state */
static int studied_about(struct quantity *q, struct quantities *all, const char *rest)
{
  if (q->which == STUDIED_REACH && !(rest = read_tolerance(q, rest)))
    return -1;
  q->series = quantity_named(all, rest);
  const struct quantity *series = q->series >= 0 ? &all->item[q->series] : NULL;
  bool of_formula = q->which == STUDIED_VERDICT || q->which == STUDIED_ORDER;
  bool fits = series && quantity_is_series(series) && !quantity_is_of_phase(all, series)
              && (!of_formula || series->kind == QUANTITY_PUBLISHED);
  return q->series < -1 ? q->series : fits ? 0 : -1;
}

/* The quantity of this kind about the one with the rest of the name. Returns 0, or what quantity_named returns where
 * there is none. */
static int named_about(struct quantity *q, struct quantities *all, const char *rest)
{
  if (q->kind == QUANTITY_EXACT || q->kind == QUANTITY_ERROR || q->kind == QUANTITY_RELATIVE) {
    q->of = quantity_named(all, rest);
    return q->of < 0 ? q->of : quantity_is_series(&all->item[q->of]) ? 0 : -1;
  }
  if (q->kind == QUANTITY_STUDIED)
    return studied_about(q, all, rest);
  if (q->kind == QUANTITY_DERIVED && !(rest = read_order(q, rest)))
    return -1;
  q->which = (int)quantity_of_name(rest);
  return q->which < NAMED_QUANTITIES && (q->kind == QUANTITY_CERTIFIED || quantity_rows[q->which].has_series) ? 0 : -1;
}

static bool name_among_carried(const struct quantities *all, const char *name)
{
  int i = 0;
  while (i < all->carries && strcmp(all->carried[i], name) != 0)
    i++;
  return i < all->carries;
}

static int place_of(void *quantities, const char *name) { return quantity_named(quantities, name); }

int quantity_of_text(struct quantities *all, const char *name, const char *text)
{
  const struct formula_names names = { .place = place_of, .context = all };
  struct quantity q = { .kind = QUANTITY_FORMULA, .of = -1, .phase = -1, .series = -1 };
  char wrong[FORMULA_MESSAGE];
  snprintf(q.name, sizeof q.name, "%s", name);
  for (int i = 0; i < all->count; i++)
    if (all->item[i].own && strcmp(all->item[i].name, q.name) == 0)
      return i;
  q.own = malloc(sizeof *q.own);
  if (!q.own || formula_read(q.own, text, &names, wrong) || all->count == MOST_QUANTITIES) {
    free(q.own);
    return -1;
  }
  all->item[all->count] = q;
  return all->count++;
}

void quantities_free(struct quantities *all)
{
  for (int i = 0; i < all->count; i++)
    free(all->item[i].own);
}

int quantity_named(struct quantities *all, const char *name)
{
  for (const struct formula_row *row = formula_rows; row->name; row++)
    if (strcmp(row->name, name) == 0)
      return quantity_of_text(all, row->name, row->formula);

  struct quantity q = { .of = -1, .phase = -1, .series = -1 };
  int found = -1;
  for (int i = 0; i < all->count; i++)
    if (strcmp(all->item[i].name, name) == 0)
      return i;
  if (strlen(name) >= QUANTITY_NAME)
    return -1;
  snprintf(q.name, sizeof q.name, "%s", name);
  bool is_carried = name_among_carried(all, name);
  for (int i = 0; i < PREFIXES && found < 0 && !is_carried; i++) {
    size_t length = strlen(prefixes[i].text);
    q.kind = prefixes[i].kind;
    q.which = prefixes[i].which;
    if (strncmp(name, prefixes[i].text, length) == 0 && (found = named_about(&q, all, name + length)) < 0)
      return found;
  }
  if (found < 0 && !plain_named(&q, all, name))
    return -1;
  if (all->count == MOST_QUANTITIES)
    return -2;
  all->item[all->count] = q;
  return all->count++;
}

const char *quantity_near(const struct quantities *all, const char *name)
{
  const char *names[MOST_NAMES], *dot = strrchr(name, '.');
  struct quantity q;
  int n = 0;
  while (n < MOST_NAMES - 1 && (names[n] = name_at(all, n, &q)))
    n++;
  names[n] = NULL;
  return nearest(dot ? dot + 1 : name, names); /* the last part is mistyped most often */
}

bool quantity_is_text(const struct quantity *q)
{
  return q->kind == QUANTITY_GAIT || q->kind == QUANTITY_LABEL || q->kind == QUANTITY_CERTIFIED
         || q->kind == QUANTITY_STATUS || q->kind == QUANTITY_PHASE_NAME || q->kind == QUANTITY_REGIME
         || q->kind == QUANTITY_MODES || q->kind == QUANTITY_WORDS || q->kind == QUANTITY_CARRIED
         || (q->kind == QUANTITY_STUDIED && q->which >= STUDIED_TEXTS);
}

bool quantity_is_series(const struct quantity *q)
{
  return q->kind == QUANTITY_PUBLISHED || q->kind == QUANTITY_DERIVED || q->kind == QUANTITY_LIMIT;
}

bool quantity_is_compared(const struct quantities *all, const struct quantity *series)
{
  for (int i = 0; i < all->count; i++)
    if (all->item[i].of >= 0 && &all->item[all->item[i].of] == series)
      return true;
  return false;
}

bool quantity_is_of_phase(const struct quantities *all, const struct quantity *q)
{
  if (q->of >= 0)
    return quantity_is_of_phase(all, &all->item[q->of]);
  switch (q->kind) {
  case QUANTITY_REGIME:
  case QUANTITY_WORDS:
  case QUANTITY_MODES: return q->which == OF_PHASE;
  case QUANTITY_PUBLISHED: return q->formula->setting != SCALLOP_STEADY;
  case QUANTITY_ANSWER:
  case QUANTITY_ESTIMATE:
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT:
  case QUANTITY_CERTIFIED: return quantity_rows[q->which].of == OF_PHASE;
  default: return false;
  }
}
