/* A book of formulas, from its file. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/book/book.h"
#include "compare/config/config.h"
#include "compare/text/memory.h"

enum { MOST_PARTS = 16, MOST_CONDITIONS = 8, MOST_CLAIMED = 999 };

/* One formula, and what its texts stand for */
struct entry {
  struct scallop_formula formula;
  struct scallop_part parts[MOST_PARTS + 1];
  const char *when[MOST_CONDITIONS + 1];
  int conditions, start, phase, of;
  const char *path;
};

/* The books that were read, in the order of reading. The texts of a formula are those of its file. */
static struct entry **entries;
static int count;
static struct config **books;
static int book_count;

void books_forget(void)
{
  while (count > 0)
    free(entries[--count]);
  while (book_count > 0) {
    config_close(books[--book_count]);
    free(books[book_count]);
  }
  free(entries);
  free(books);
  entries = NULL;
  books = NULL;
}

const struct scallop_formula *book_formula(int i) { return i < count ? &entries[i]->formula : NULL; }

enum { FROM_REST, FROM_V0, FROM_STEADY };
static const char *const starts[] = { "rest", "v0", "steady", NULL };
static const char *const phases[] = { "extension", "contraction", NULL };
/* Those of a phase, then those of the steady state; dx1 and dx2 are of the body that turns and of the other one. */
static const char *const words[] = {
  "dx1",           "dx2",           "t1",         "dT",        "dxC",     "v_end", "v_change",
  "rear_at_first", "rear_at_last",  "v_at_first", "v_at_last", "v_start", "v_mid", "displacement",
  "mean_velocity", "friction_work", NULL
};
static const char first_steady[] = "v_start";

static const struct member members[] = { MEMBER(TEXT, "name", entry, formula.name, ),
                                         MEMBER(TEXT, "equation", entry, formula.equation, ),
                                         MEMBER(WORD, "start", entry, start, .words = starts),
                                         MEMBER(WORD, "phase", entry, phase, .words = phases),
                                         MEMBER(WORD, "of", entry, of, .words = words),
                                         OTHER("claimed"),
                                         MEMBER(TEXT, "text", entry, formula.text, ),
                                         OTHER("where"),
                                         MEMBER(TEXTS, "when", entry, when, .high = MOST_CONDITIONS,
                                                .count = offsetof(struct entry, conditions)),
                                         MEMBER(TEXT, "corrected", entry, formula.corrected, ),
                                         OTHER("turns"),
                                         { .name = NULL } };

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

/* The name that an unknown one in a formula resembles */
static const char *near_to(const struct scallop_formula *formula, const char *name)
{
  const char *names[SCALLOP_SYMBOLS + MOST_PARTS + 1] = { NULL };
  int n = 0;
  for (; n < SCALLOP_SYMBOLS; n++)
    names[n] = scallop_symbol_names[n];
  for (const struct scallop_part *p = formula->parts; p->name; p++)
    names[n++] = p->name;
  return nearest(name, names);
}

static bool read_parts(struct config *c, const config_setting_t *where, struct entry *e)
{
  if (where && !config_setting_is_group(where))
    return refuse_at(c, where, "where is a group of names and texts: { mstar = \"m1*m2/M\"; }");
  for (int i = 0; where && i < config_setting_length(where); i++) {
    const config_setting_t *at = member_at(where, i);
    const char *name = config_setting_name(at), *text = config_setting_get_string(at);
    if (i == MOST_PARTS)
      return refuse_at(c, at, "where has more than %d parts", MOST_PARTS);
    if (!text)
      return refuse_at(c, at, "%s takes a formula in quotes", name);
    if (!is_identifier(name) || is_symbol(name) || strcmp(name, "pi") == 0)
      return refuse_at(c, at, "'%s' cannot be the name of a part: %s", name,
                       is_identifier(name) ? "it has a meaning already" : "a name is of letters, digits and _");
    e->parts[i] = (struct scallop_part){ name, text };
  }
  e->formula.parts = e->parts;
  return true;
}

/* A whole number, or "equality"; none: nothing is claimed */
static bool read_claimed(struct config *c, const config_setting_t *at, struct entry *e)
{
  const char *text = at ? config_setting_get_string(at) : NULL;
  int type = at ? config_setting_type(at) : CONFIG_TYPE_NONE, n = at ? config_setting_get_int(at) : 0;
  e->formula.remainder = text ? SCALLOP_EQUALITY : n;
  return !at || (text ? strcmp(text, "equality") == 0 : type == CONFIG_TYPE_INT && n >= 1 && n <= MOST_CLAIMED)
         || refuse_at(c, at, "claimed is the power of T in \"+ O(T^n)\", from 1 to %d, or \"equality\"", MOST_CLAIMED);
}

static bool read_turns(struct config *c, const config_setting_t *at, struct entry *e)
{
  static const char *const turns[] = { "in both phases", "not in the contraction", "not in the extension", NULL };
  static const struct member member = { .name = "turns", .kind = MEMBER_WORD, .words = turns };
  int word = 0;
  bool read = !at || read_member(c, at, &member, &word);
  e->formula.turns = (enum scallop_turns)word;
  return read;
}

static void set_meaning(struct entry *e)
{
  static const enum scallop_setting moving[] = { SCALLOP_MOVING_EXTENSION, SCALLOP_MOVING_CONTRACTION };
  const char *word = words[e->of];
  bool of_1 = strcmp(word, "dx1") == 0, of_2 = strcmp(word, "dx2") == 0;
  e->formula.setting = e->start == FROM_STEADY ? SCALLOP_STEADY
                       : e->start == FROM_V0   ? moving[e->phase]
                                               : SCALLOP_AT_REST_START;
  if (of_1 || of_2)
    word = of_1 == (e->phase == SCALLOP_EXTENSION) ? "rear_at_end" : "front_at_end";
  for (int q = 0; q < SCALLOP_QUANTITIES; q++)
    if (strcmp(scallop_quantity_words[q], word) == 0)
      e->formula.quantity = (enum scallop_quantity)q;
  e->formula.when = e->conditions > 0 ? e->when : NULL;
}

/* Is the word that of a quantity of the steady state? */
static bool is_steady_word(const char *word)
{
  bool is_steady = false;
  for (int i = 0; word && words[i]; i++) {
    is_steady = is_steady || strcmp(words[i], first_steady) == 0;
    if (strcmp(words[i], word) == 0)
      return is_steady;
  }
  return false;
}

/* Does the text, and do the conditions, have a meaning? */
static bool check_texts(struct config *c, const config_setting_t *group, struct entry *e)
{
  char message[FORMULA_MESSAGE], sign;
  struct formula read;
  struct scallop_values ones;
  double left, right;
  for (int i = 0; i < SCALLOP_SYMBOLS; i++)
    ones.of[i] = 1;
  const char *wrong = scallop_formula_text(&read, &e->formula, near_to, message);
  if (wrong)
    return refuse_at(c, config_setting_get_member(group, "text"), "%s: %s", e->formula.name, wrong);
  int places[FORMULA_STEPS];
  for (int i = formula_places(&read, places); e->start == FROM_STEADY && i-- > 0;)
    if (places[i] >= SCALLOP_SYMBOL_v0)
      return refuse_at(c, config_setting_get_member(group, "text"), "%s: the steady state has no %s", e->formula.name,
                       scallop_symbol_names[places[i]]);
  for (int i = 0; i < e->conditions; i++)
    if ((wrong = scallop_condition_value(&left, &sign, &right, e->when[i], &e->formula, &ones, message)))
      return refuse_at(c, config_setting_get_member(group, "when"), "%s: \"%s\": %s", e->formula.name, e->when[i], wrong);
  return true;
}

static bool check_entry(struct config *c, const config_setting_t *group, const struct entry *e)
{
  const struct scallop_formula *f = &e->formula;
  if (!f->name || !f->text || e->of < 0)
    return refuse_at(c, group, "a formula has no %s",
                     !f->name   ? "name"
                     : !f->text ? "text"
                                : "'of', the quantity that it gives");
  if (!is_identifier(f->name))
    return refuse_at(c, group, "'%s' cannot be the name of a formula: a name is of letters, digits and _", f->name);
  for (int i = 0; i < count; i++)
    if (strcmp(entries[i]->formula.name, f->name) == 0)
      return refuse_at(c, group, "there is a formula '%s' already", f->name);
  if (e->start == FROM_REST && e->phase == SCALLOP_CONTRACTION)
    return refuse_at(c, group, "from rest a formula is for an extension: a contraction is one with the bodies exchanged");
  if (is_steady_word(words[e->of]) != (e->start == FROM_STEADY))
    return refuse_at(c, group, "%s is a quantity of %s", words[e->of],
                     is_steady_word(words[e->of]) ? "the steady state: start = \"steady\""
                                                  : "one phase: start = \"rest\" or \"v0\"");
  return true;
}

static bool keep_entry(struct config *c, struct entry *e)
{
  struct entry **more = with_room(entries, count, sizeof(struct entry *));
  if (!more)
    return refuse_at(c, NULL, "out of memory");
  entries = more;
  entries[count++] = e;
  return true;
}

static bool read_entry(struct config *c, const config_setting_t *group)
{
  struct entry *e = calloc(1, sizeof *e);
  if (!e)
    return refuse_at(c, group, "out of memory");
  e->of = -1;
  e->path = c->path;
  e->formula.equation = "-";
  bool good = config_setting_is_group(group)
                  ? read_members(c, group, members, e, "a formula", NULL)
                  : refuse_at(c, group, "a formula is a group: { name = \"...\"; text = \"...\"; }");
  good = good && read_parts(c, config_setting_get_member(group, "where"), e)
         && read_claimed(c, config_setting_get_member(group, "claimed"), e)
         && read_turns(c, config_setting_get_member(group, "turns"), e) && check_entry(c, group, e);
  if (good)
    set_meaning(e);
  good = good && check_texts(c, group, e) && keep_entry(c, e);
  if (!good)
    free(e);
  return good;
}

static bool read_list(struct config *c, const char *name)
{
  const config_setting_t *list = config_setting_get_member(config_root(c), name);
  if (list && !config_setting_is_list(list))
    return refuse_at(c, list, "%s is a list of formulas: ( { ... }, { ... } )", name);
  for (int i = 0; list && i < config_setting_length(list); i++)
    if (!read_entry(c, element_at(list, i)))
      return false;
  return true;
}

static bool read_root(struct config *c)
{
  static const struct member lists[] = { OTHER("formulas"), OTHER("corrected"), { .name = NULL } };
  int before = count;
  if (!read_members(c, config_root(c), lists, NULL, "a book of formulas", NULL) || !read_list(c, "formulas")
      || !read_list(c, "corrected"))
    return false;
  return count > before || refuse_at(c, NULL, "there is no formula: formulas = ( { name = \"...\"; ... } );");
}

enum exit_code book_read_text(const char *command, const char *path, const char *text)
{
  struct config **more = with_room(books, book_count, sizeof(struct config *)), *c = more ? malloc(sizeof *c) : NULL;
  books = more ? more : books;
  if (!c) {
    complain(command, "out of memory");
    return EXIT_UNSOLVED;
  }
  enum exit_code code = config_open(c, command, path, text);
  if (code == EXIT_DONE && !read_root(c))
    code = EXIT_USAGE;
  books[book_count++] = c;
  return code;
}

enum exit_code book_read(const char *command, const char *path)
{
  for (int i = 0; i < count; i++)
    if (strcmp(entries[i]->path, path) == 0)
      return EXIT_DONE;
  return book_read_text(command, path, NULL);
}

/* name = "value"; as libconfig reads it */
static void write_member(FILE *text, const char *name, const char *value)
{
  bool is_number = value && strspn(value, "0123456789") == strlen(value);
  if (!value)
    return;
  fprintf(text, is_number ? " %s = " : " %s = \"", name);
  for (; *value; value++)
    fprintf(text, *value == '"' || *value == '\\' ? "\\%c" : "%c", *value);
  fprintf(text, is_number ? ";" : "\";");
}

enum exit_code book_add(const char *command, const struct formula_given *given)
{
  char *text = NULL;
  size_t size;
  FILE *file = open_memstream(&text, &size);
  if (!file) {
    complain(command, "out of memory");
    return EXIT_UNSOLVED;
  }
  fprintf(file, "formulas = ( { name = \"formula\";");
  write_member(file, "text", given->text);
  write_member(file, "of", given->of);
  write_member(file, "start", given->start ? given->start : is_steady_word(given->of) ? "steady" : NULL);
  write_member(file, "phase", given->phase);
  write_member(file, "claimed", given->claimed);
  fprintf(file, " } );");
  fclose(file);
  enum exit_code code = book_read_text(command, "--formula", text);
  free(text);
  return code;
}
