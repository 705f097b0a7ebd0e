/* Does what a book says have a meaning? */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "compare/book/entry.h"

const char *const book_starts[] = { "rest", "v0", "steady", NULL }, *const book_phases[] = { "extension", "contraction",
                                                                                             NULL };
/* dx1 and dx2 are of the body that turns and of the other one */
const char *const book_quantities[] = {
  "dx1",           "dx2",           "t1",         "dT",        "dxC",     "v_end", "v_change",
  "rear_at_first", "rear_at_last",  "v_at_first", "v_at_last", "v_start", "v_mid", "displacement",
  "mean_velocity", "friction_work", NULL
};

static bool is_identifier(const char *name)
{
  size_t length = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_");
  return isalpha((unsigned char)*name) && name[length] == '\0' && length < FORMULA_NAME;
}

static bool is_symbol(const char *name)
{
  int i = 0;
  while (i < SCALLOP_SYMBOLS && strcmp(scallop_symbol_names[i], name) != 0)
    i++;
  return i < SCALLOP_SYMBOLS;
}

/* A member of the group of an entry, for its line; NULL for an option. */
static const config_setting_t *member_of(const struct entry *e, const char *name)
{
  return e->group ? config_setting_get_member(e->group, name) : NULL;
}

static bool refuse_name(const struct config *c, const config_setting_t *at, const char *name, const char *of,
                        bool taken)
{
  if (!is_identifier(name))
    return refuse_at(
        c, at, "'%s' cannot be the name of a %s: a name begins with a letter, has letters, digits and _, %d at most",
        name, of, FORMULA_NAME - 1);
  return refuse_at(c, at, "'%s' cannot be the name of a %s: %s", name, of,
                   taken ? "there is a quantity of this name" : "it has a meaning in formulas");
}

static bool check_name(const struct config *c, const struct entry *e, name_is_taken *taken)
{
  const char *name = e->formula.name;
  bool is_taken = taken && taken(name);
  if (!is_identifier(name) || formula_is_word(name) || is_taken)
    return refuse_name(c, member_of(e, "name"), name, "formula", is_taken);
  const struct entry *other = book_entry_named(name);
  bool here = other && strcmp(other->path, c->path) == 0;
  if (other)
    return refuse_at(c, member_of(e, "name"), "there is a formula '%s' already%s%s", name, here ? "" : ", in ",
                     here ? "" : other->path);
  return true;
}

static bool check_part_names(const struct config *c, const struct entry *e)
{
  for (const struct scallop_part *p = e->parts; p->name; p++)
    if (!is_identifier(p->name) || is_symbol(p->name) || formula_is_word(p->name))
      return refuse_name(c, config_setting_get_member(member_of(e, "where"), p->name), p->name, "part", false);
  return true;
}

bool is_steady_word(const char *word)
{
  for (int i = 0; book_quantities[i]; i++)
    if (strcmp(book_quantities[i], word) == 0)
      return i >= BOOK_STEADY;
  return false;
}

bool check_entry(const struct config *c, const struct entry *e, name_is_taken *taken)
{
  const struct scallop_formula *f = &e->formula;
  if (!f->name || !f->text || e->of < 0)
    return refuse_at(c, e->group, "a formula has no %s",
                     !f->name   ? "name"
                     : !f->text ? "text"
                                : "'of', the quantity that it gives");
  const char *of = book_quantities[e->of];
  if (!check_name(c, e, taken) || !check_part_names(c, e))
    return false;
  if (is_steady_word(of) != (e->start == FROM_STEADY))
    return refuse_at(c, member_of(e, "of"), "%s is a quantity of %s", of,
                     is_steady_word(of) ? "the steady state: give it start = \"steady\""
                                        : "one phase: give it start = \"rest\" or \"v0\"");
  if (e->phase == SCALLOP_CONTRACTION && e->start != FROM_V0)
    return refuse_at(c, member_of(e, "phase"), "%s",
                     e->start == FROM_REST
                         ? "from rest a formula is for an extension: a contraction is one with the bodies exchanged"
                         : "the steady state has both phases: leave phase out");
  if (f->turns != SCALLOP_TURNS_IN_BOTH && e->start != FROM_STEADY)
    return refuse_at(c, member_of(e, "turns"), "turns is about the steady state: start = \"steady\"");
  return true;
}

/* The name that an unknown one in a formula resembles */
static const char *near_to(const struct scallop_formula *formula, const char *name, const char *const *functions)
{
  const char *names[SCALLOP_SYMBOLS + MOST_PARTS + 1] = { NULL };
  int n = 0;
  for (; n < SCALLOP_SYMBOLS; n++)
    names[n] = scallop_symbol_names[n];
  for (const struct scallop_part *p = formula->parts; p->name; p++)
    names[n++] = p->name;
  return nearest(name, functions ? functions : names);
}

/* Symbols that have no value there */
#define SYMBOL_BIT(symbol) (1U << SCALLOP_SYMBOL_##symbol)
enum {
  NOT_STEADY = SYMBOL_BIT(v0) | SYMBOL_BIT(t1) | SYMBOL_BIT(dT) | SYMBOL_BIT(x_switch),
  NOT_OF_CRAWLER = NOT_STEADY | SYMBOL_BIT(T)
};

/* What is wrong with a text of the formula, or NULL. in: "the steady state", which has none of the symbols `lacking` */
static const char *wrong_with(const struct scallop_formula *formula, const char *text, unsigned lacking, const char *in,
                              char message[FORMULA_MESSAGE])
{
  struct scallop_formula of = *formula;
  struct formula read;
  int places[FORMULA_STEPS];
  of.text = text;
  const char *wrong = scallop_formula_text(&read, &of, near_to, message);
  for (int i = wrong ? 0 : formula_places(&read, places); i-- > 0;)
    if (lacking >> places[i] & 1) {
      snprintf(message, FORMULA_MESSAGE, "%s has no %s", in, scallop_symbol_names[places[i]]);
      wrong = message;
    }
  return wrong;
}

/* A condition is about the crawler: T goes to 0, and v0 is not looked at. */
static const char *wrong_with_condition(const struct scallop_formula *formula, const char *when,
                                        char message[FORMULA_MESSAGE])
{
  static const char in[] = "a condition is about the crawler, which";
  struct scallop_sides sides;
  if (!scallop_condition_split(&sides, when))
    return "a condition is LEFT < RIGHT, LEFT > RIGHT or LEFT = RIGHT, of 399 characters at most";
  const char *wrong = wrong_with(formula, sides.left, NOT_OF_CRAWLER, in, message);
  return wrong ? wrong : wrong_with(formula, sides.right, NOT_OF_CRAWLER, in, message);
}

bool check_texts(const struct config *c, const struct entry *e)
{
  const struct scallop_formula *f = &e->formula;
  char message[FORMULA_MESSAGE];
  const char *name = e->group ? f->name : "", *colon = e->group ? ": " : "", *wrong;
  const unsigned lacking = e->start == FROM_STEADY ? NOT_STEADY : 0;
  if ((wrong = wrong_with(f, f->text, lacking, "the steady state", message)))
    return refuse_at(c, member_of(e, "text"), "%s%s%s", name, colon, wrong);
  for (const struct scallop_part *p = e->parts; p->name; p++) /* those that the text does not use, too */
    if ((wrong = wrong_with(f, p->name, lacking, "the steady state", message)))
      return refuse_at(c, config_setting_get_member(member_of(e, "where"), p->name), "%s: %s", name, wrong);
  for (int i = 0; i < e->conditions; i++)
    if ((wrong = wrong_with_condition(f, e->when[i], message)))
      return refuse_at(c, member_of(e, "when"), "%s: \"%s\": %s", name, e->when[i], wrong);
  return true;
}

bool check_corrected(const struct config *c, const struct entry *e)
{
  const char *corrected = e->formula.corrected;
  if (!corrected || formula_named(corrected))
    return true;
  return refuse_at(c, member_of(e, "corrected"), "%s: there is no formula '%s'%s", e->formula.name, corrected,
                   formula_instead(corrected));
}
