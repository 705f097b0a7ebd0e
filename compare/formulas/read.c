/* Reading of formula files, and checks that each formula has a meaning. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/formulas/formula_file.h"
#include "compare/config/config.h"
#include "compare/text/progress.h"
#include "compare/text/values.h"

/* dx1 and dx2 become rear_at_end and front_at_end, by the phase */
const char *const formula_quantities[] = {
  "dx1",           "dx2",           "t1",         "dT",        "dxC",     "v_end", "v_change",
  "rear_at_first", "rear_at_last",  "v_at_first", "v_at_last", "v_start", "v_mid", "displacement",
  "mean_velocity", "friction_work", NULL
};
const char *const formula_starts[] = { "rest", "v0", "steady", NULL };
const char *const phase_names[] = { "extension", "contraction", NULL };
static const char *const turns[] = { "in both phases", "not in the contraction", "not in the extension", NULL };
enum { DX1, DX2, NOTHING = -1 };
enum { FROM_REST, FROM_V0, FROM_STEADY };
enum { MAX_CLAIMED = 999 };

/* The files that were read; they own the texts of the formulas */
struct formula_file {
  struct formula_file *next;
  struct config config;
};
static struct formula_file *files;

enum { MAX_PARTS = 16, MAX_CONDITIONS = 8 };

struct formula_entry {
  struct scallop_formula formula;
  struct scallop_part parts[MAX_PARTS + 1];
  const char *when[MAX_CONDITIONS + 1];
  int conditions, start, phase, of; /* start, phase, of: places among the words of formula_file.h */
  const struct config *config;
  const config_setting_t *group;
};

static const struct member members[] = { MEMBER(TEXT, "name", formula_entry, formula.name, ),
                                         MEMBER(TEXT, "equation", formula_entry, formula.equation, ),
                                         MEMBER(WORD, "start", formula_entry, start, .words = formula_starts),
                                         MEMBER(WORD, "phase", formula_entry, phase, .words = phase_names),
                                         MEMBER(WORD, "of", formula_entry, of, .words = formula_quantities),
                                         OTHER("claimed"),
                                         MEMBER(TEXT, "text", formula_entry, formula.text, ),
                                         OTHER("where"),
                                         MEMBER(TEXTS, "when", formula_entry, when, .high = MAX_CONDITIONS,
                                                .count = offsetof(struct formula_entry, conditions)),
                                         MEMBER(TEXT, "corrected", formula_entry, formula.corrected, ),
                                         MEMBER(WORD, "turns", formula_entry, formula.turns, .words = turns),
                                         { .name = NULL } };

static const struct formula_entry *entry_named(const char *name)
{
  return (const void *)user_formula_named(name); /* the formula is the first member of its entry */
}

static const config_setting_t *member_of(const struct formula_entry *e, const char *name)
{
  return config_setting_get_member(e->group, name);
}

static bool is_symbol(const char *name)
{
  int i = 0;
  while (i < SCALLOP_SYMBOLS && strcmp(scallop_symbol_names[i], name) != 0)
    i++;
  return i < SCALLOP_SYMBOLS;
}

/* Checks a name; of: "formula" or "part"; other: another error of the name, or NULL. */
static bool check_name(const struct formula_entry *e, const config_setting_t *at, const char *name, const char *of,
                       const char *other)
{
  size_t length = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_");
  if (!isalpha((unsigned char)*name) || name[length] != '\0' || length >= FORMULA_NAME)
    return refuse_at(
        e->config, at,
        "'%s' cannot be the name of a %s: a name begins with a letter, has letters, digits and _, %d at most", name, of,
        FORMULA_NAME - 1);
  other = other || !formula_is_word(name) ? other : "it has a meaning in formulas";
  return !other || refuse_at(e->config, at, "'%s' cannot be the name of a %s: %s", name, of, other);
}

static bool check_names(const struct formula_entry *e, name_is_taken *taken)
{
  const char *name = e->formula.name;
  if (!name || !e->formula.text || e->of < 0)
    return refuse_at(e->config, e->group, "a formula has no %s",
                     !name              ? "name"
                     : !e->formula.text ? "text"
                                        : "'of', the quantity that it gives");
  const config_setting_t *at = member_of(e, "name");
  const struct formula_entry *other = entry_named(name);
  bool good = check_name(e, at, name, "formula", taken && taken(name) ? "there is a quantity of this name" : NULL);
  const bool elsewhere = other && other->config != e->config;
  return good
         && (!other
             || refuse_at(e->config, at, "there is a formula '%s' already%s%s", name, elsewhere ? ", in " : "",
                          elsewhere ? other->config->path : ""));
}

static bool check_motion(const struct formula_entry *e)
{
  bool is_steady = e->start == FROM_STEADY;
  if (is_steady != (e->of >= FORMULA_STEADY))
    return refuse_at(e->config, member_of(e, "of"), "%s is a quantity of %s", formula_quantities[e->of],
                     is_steady ? "one phase: give it start = \"rest\" or \"v0\""
                               : "the steady state: give it start = \"steady\"");
  if (e->phase == SCALLOP_CONTRACTION && e->start != FROM_V0)
    return refuse_at(e->config, member_of(e, "phase"), "%s",
                     is_steady
                         ? "the steady state has both phases: leave phase out"
                         : "from rest a formula is for an extension: a contraction is one with the bodies exchanged");
  return e->formula.turns == SCALLOP_TURNS_IN_BOTH || is_steady
         || refuse_at(e->config, member_of(e, "turns"), "turns is about the steady state: start = \"steady\"");
}

static void set_meaning(struct formula_entry *e)
{
  static const enum scallop_setting moving[] = { SCALLOP_MOVING_EXTENSION, SCALLOP_MOVING_CONTRACTION };
  const char *word = formula_quantities[e->of];
  if (e->of == DX1 || e->of == DX2)
    word = (e->of == DX1) == (e->phase == SCALLOP_EXTENSION) ? "rear_at_end" : "front_at_end";
  for (int q = 0; q < SCALLOP_QUANTITIES; q++)
    if (strcmp(scallop_quantity_words[q], word) == 0)
      e->formula.quantity = (enum scallop_quantity)q;
  e->formula.setting = e->start == FROM_STEADY ? SCALLOP_STEADY
                       : e->start == FROM_V0   ? moving[e->phase]
                                               : SCALLOP_AT_REST_START;
  e->formula.when = e->conditions > 0 ? e->when : NULL;
}

/* Symbols without a value in the steady state, or in a condition */
#define SYMBOL_BIT(symbol) (1U << SCALLOP_SYMBOL_##symbol)
enum {
  NOT_STEADY = SYMBOL_BIT(v0) | SYMBOL_BIT(t1) | SYMBOL_BIT(dT) | SYMBOL_BIT(x_switch),
  NOT_OF_CRAWLER = NOT_STEADY | SYMBOL_BIT(T)
};

/* Returns NULL or the error of a text of the formula. It must not use the symbols `lacking`. */
static const char *formula_text_error(const struct scallop_formula *formula, const char *text, unsigned lacking,
                                      char message[FORMULA_MESSAGE])
{
  const char *in = lacking == NOT_STEADY ? "the steady state" : "a condition is about the crawler, which";
  struct scallop_formula of = *formula;
  struct formula read;
  int places[FORMULA_STEPS];
  of.text = text;
  const char *wrong = scallop_formula_text(&read, &of, nearest, message);
  for (int i = wrong ? 0 : formula_places(&read, places); i-- > 0;)
    if (lacking >> places[i] & 1) {
      snprintf(message, FORMULA_MESSAGE, "%s has no %s", in, scallop_symbol_names[places[i]]);
      wrong = message;
    }
  return wrong;
}

/* Returns NULL or the error of a condition. A condition is about the crawler: it cannot use T (it tends to 0) or v0. */
static const char *condition_error(const struct scallop_formula *formula, const char *when,
                                   char message[FORMULA_MESSAGE])
{
  struct scallop_sides sides;
  if (!scallop_condition_split(&sides, when))
    return "a condition is LEFT < RIGHT, LEFT > RIGHT or LEFT = RIGHT, of 399 characters at most";
  const char *wrong = formula_text_error(formula, sides.left, NOT_OF_CRAWLER, message);
  return wrong ? wrong : formula_text_error(formula, sides.right, NOT_OF_CRAWLER, message);
}

static bool check_texts(const struct formula_entry *e)
{
  const struct scallop_formula *f = &e->formula;
  char message[FORMULA_MESSAGE];
  const unsigned lacking = e->start == FROM_STEADY ? NOT_STEADY : 0;
  const bool of_file = config_setting_source_line(e->group) > 0; /* false: from an option */
  const char *wrong = formula_text_error(f, f->text, lacking, message);
  if (wrong)
    return refuse_at(e->config, member_of(e, "text"), "%s%s%s", of_file ? f->name : "", of_file ? ": " : "", wrong);
  for (const struct scallop_part *p = e->parts; p->name; p++) /* includes unused parts */
    if ((wrong = formula_text_error(f, p->name, lacking, message)))
      return refuse_at(e->config, config_setting_get_member(member_of(e, "where"), p->name), "%s: %s", f->name, wrong);
  for (int i = 0; i < e->conditions; i++)
    if ((wrong = condition_error(f, e->when[i], message)))
      return refuse_at(e->config, member_of(e, "when"), "%s: \"%s\": %s", f->name, e->when[i], wrong);
  return true;
}

static bool read_parts(struct formula_entry *e)
{
  const config_setting_t *where = member_of(e, "where");
  if (where && !config_setting_is_group(where))
    return refuse_at(e->config, where, "where is a group of names and texts: { mstar = \"m1*m2/M\"; }");
  for (int i = 0; where && i < config_setting_length(where); i++) {
    const config_setting_t *at = member_at(where, i);
    const char *name = config_setting_name(at), *text = config_setting_get_string(at);
    if (i == MAX_PARTS)
      return refuse_at(e->config, at, "where has more than %d parts", MAX_PARTS);
    if (!text)
      return refuse_at(e->config, at, "%s takes a formula in quotes", name);
    if (!check_name(e, at, name, "part", is_symbol(name) ? "it has a meaning in formulas" : NULL))
      return false;
    e->parts[i] = (struct scallop_part){ name, text };
  }
  return true;
}

/* Reads the claim: n, "equality", or no claim. */
static bool read_claimed(struct config *c, struct formula_entry *e)
{
  const config_setting_t *at = member_of(e, "claimed");
  const char *text = at ? text_of(c, at) : NULL;
  long n = SCALLOP_EQUALITY;
  bool good = !at || (text && (strcmp(text, "equality") == 0 || read_count(text, 1, MAX_CLAIMED, &n)));
  e->formula.remainder = at ? (int)n : 0;
  return good
         || refuse_at(c, at, "claimed is the power of T in \"+ O(T^n)\", from 1 to %d, or \"equality\"", MAX_CLAIMED);
}

/* Adds the formula of a group. Returns false after a message if it has no meaning. */
static bool read_entry(struct config *c, const config_setting_t *group, name_is_taken *taken)
{
  if (!config_setting_is_group(group))
    return refuse_at(c, group, "a formula is a group: { name = \"...\"; text = \"...\"; }");
  struct formula_entry *e = calloc(1, sizeof *e);
  if (!e)
    return refuse_at(c, group, "out of memory");
  *e = (struct formula_entry){
    .formula = { .equation = "-", .parts = e->parts }, .of = NOTHING, .config = c, .group = group
  };
  bool good = read_members(c, group, members, e, "a formula") && read_parts(e) && read_claimed(c, e)
              && check_names(e, taken) && check_motion(e);
  if (good) {
    set_meaning(e);
    good = check_texts(e) && (user_formula_keep(&e->formula) || refuse_at(c, NULL, "out of memory"));
  }
  if (!good)
    free(e);
  return good;
}

/* Reads a list of formulas; it may be missing. */
static bool read_list(struct config *c, const char *name, name_is_taken *taken)
{
  const config_setting_t *list = config_setting_get_member(config_root(c), name);
  if (list && !config_setting_is_list(list))
    return refuse_at(c, list, "%s is a list of formulas: ( { ... }, { ... } )", name);
  for (int i = 0; list && i < config_setting_length(list); i++)
    if (progress_count(i, config_setting_length(list)), !read_entry(c, element_at(list, i), taken))
      return false;
  progress_count(0, 0);
  return true;
}

static bool read_root(struct config *c, name_is_taken *taken)
{
  static const struct member lists[] = { OTHER("formulas"), OTHER("corrected"), { .name = NULL } };
  int first = 0, i;
  while (user_formula(first))
    first++;
  if (!read_members(c, config_root(c), lists, NULL, "a formula file") || !read_list(c, "formulas", taken)
      || !read_list(c, "corrected", taken))
    return false;
  for (i = first; user_formula(i); i++) {
    const char *name = user_formula(i)->name, *corrected = user_formula(i)->corrected;
    if (corrected && !formula_named(corrected))
      return refuse_at(c, member_of(entry_named(name), "corrected"), "%s: there is no formula '%s'%s", name, corrected,
                       formula_hint(corrected));
  }
  return i > first || refuse_at(c, NULL, "there is no formula: formulas = ( { name = \"...\"; ... } );");
}

/* Opens a file, or a text of that name, and adds it to the files that were read. */
static enum exit_code open_file(struct config **config, const char *command, const char *path, const char *text)
{
  struct formula_file *file = calloc(1, sizeof *file);
  if (!file)
    return complain(command, "out of memory"), EXIT_UNSOLVED;
  file->next = files;
  files = file;
  *config = &file->config;
  return config_open(*config, command, path, text, NULL);
}

/* Returns true if the paths lead to the same file. */
static bool is_same_file(const char *a, const char *b)
{
  struct stat of_a, of_b;
  return strcmp(a, b) == 0
         || (stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino);
}

enum exit_code formula_file_read(const char *command, const char *path, const char *text, name_is_taken *taken)
{
  for (const struct formula_file *f = files; f; f = f->next)
    if (!text && is_same_file(f->config.path, path))
      return EXIT_DONE;
  struct config *c;
  const enum exit_code code = open_file(&c, command, path, text);
  return code == EXIT_DONE && !read_root(c, taken) ? EXIT_USAGE : code;
}

enum exit_code user_formula_add(const char *command, const struct formula_option *given)
{
  bool is_steady = word_place(given->of, formula_quantities) >= FORMULA_STEADY;
  const char *const texts[][2] = {
    { "name", "formula" },     { "text", given->text },
    { "of", given->of },       { "start", given->start || !is_steady ? given->start : "steady" },
    { "phase", given->phase }, { "claimed", given->claimed }
  };
  struct config *c;
  if (open_file(&c, command, "--formula", "") != EXIT_DONE)
    return EXIT_UNSOLVED;
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
    if (texts[i][1])
      config_setting_set_string(config_setting_add(c->file.root, texts[i][0], CONFIG_TYPE_STRING), texts[i][1]);
  return read_entry(c, config_root(c), NULL) ? EXIT_DONE : EXIT_USAGE;
}

const char *formula_place(char text[FORMULA_PLACE], const struct scallop_formula *formula)
{
  const struct formula_entry *e = entry_named(formula->name);
  const int line = e && &e->formula == formula ? config_setting_source_line(e->group) : 0;
  *text = '\0';
  if (line > 0) /* else from an option */
    snprintf(text, FORMULA_PLACE, "%s:%d: ", e->config->path, line);
  return text;
}

void formula_files_free(void)
{
  user_formulas_free();
  for (struct formula_file *first; (first = files);) {
    files = first->next;
    config_close(&first->config);
    free(first);
  }
}
