/* A book of formulas, from its file. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/book/entry.h"
#include "compare/text/progress.h"
#include "compare/text/memory.h"
#include "compare/text/values.h"

static const struct member members[] = { MEMBER(TEXT, "name", entry, formula.name, ),
                                         MEMBER(TEXT, "equation", entry, formula.equation, ),
                                         MEMBER(WORD, "start", entry, start, .words = book_starts),
                                         MEMBER(WORD, "phase", entry, phase, .words = book_phases),
                                         MEMBER(WORD, "of", entry, of, .words = book_quantities),
                                         OTHER("claimed"),
                                         MEMBER(TEXT, "text", entry, formula.text, ),
                                         OTHER("where"),
                                         MEMBER(TEXTS, "when", entry, when, .high = MOST_CONDITIONS,
                                                .count = offsetof(struct entry, conditions)),
                                         MEMBER(TEXT, "corrected", entry, formula.corrected, ),
                                         OTHER("turns"),
                                         { .name = NULL } };

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
    e->parts[i] = (struct scallop_part){ name, text };
  }
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
  const char *word = book_quantities[e->of];
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

static bool take_entry(struct config *c, struct entry *e, name_is_taken *taken)
{
  if (!check_entry(c, e, taken))
    return false;
  set_meaning(e);
  return check_texts(c, e) && (book_keep(e) || refuse_at(c, NULL, "out of memory"));
}

static struct entry *new_entry(const struct config *c, const config_setting_t *group)
{
  struct entry *e = calloc(1, sizeof *e);
  if (!e) {
    refuse_at(c, group, "out of memory");
    return NULL;
  }
  e->of = -1;
  e->path = c->path;
  e->group = group;
  e->formula.equation = "-";
  e->formula.parts = e->parts;
  return e;
}

static bool read_entry(struct config *c, const config_setting_t *group, name_is_taken *taken)
{
  struct entry *e = new_entry(c, group);
  bool good = e
              && (config_setting_is_group(group)
                      ? read_members(c, group, members, e, "a formula", NULL)
                      : refuse_at(c, group, "a formula is a group: { name = \"...\"; text = \"...\"; }"))
              && read_parts(c, config_setting_get_member(group, "where"), e)
              && read_claimed(c, config_setting_get_member(group, "claimed"), e)
              && read_turns(c, config_setting_get_member(group, "turns"), e) && take_entry(c, e, taken);
  if (!good)
    free(e);
  return good;
}

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
  int before = book_count();
  if (!read_members(c, config_root(c), lists, NULL, "a book of formulas", NULL) || !read_list(c, "formulas", taken)
      || !read_list(c, "corrected", taken))
    return false;
  for (int i = before; i < book_count(); i++)
    if (!check_corrected(c, book_entry(i)))
      return false;
  return book_count() > before || refuse_at(c, NULL, "there is no formula: formulas = ( { name = \"...\"; ... } );");
}

enum exit_code book_read_text(const char *command, const char *path, const char *text, name_is_taken *taken)
{
  struct config *c = book_config();
  if (!c) {
    complain(command, "out of memory");
    return EXIT_UNSOLVED;
  }
  enum exit_code code = config_open(c, command, path, text, NULL);
  return code == EXIT_DONE && !read_root(c, taken) ? EXIT_USAGE : code;
}

/* Paths of one file may differ. */
static bool is_same_file(const char *a, const char *b)
{
  struct stat of_a, of_b;
  return strcmp(a, b) == 0
         || (stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino);
}

enum exit_code book_read(const char *command, const char *path, name_is_taken *taken)
{
  for (int i = 0; i < book_count(); i++)
    if (is_same_file(book_entry(i)->path, path))
      return EXIT_DONE;
  return book_read_text(command, path, NULL, taken);
}

/* -1: none of them */
static int place_of(const char *word, const char *const *words)
{
  for (int i = 0; word && words[i]; i++)
    if (strcmp(words[i], word) == 0)
      return i;
  return -1;
}

enum exit_code book_add(const char *command, const struct formula_given *given)
{
  static struct config option; /* of an option there is no file */
  long claimed = SCALLOP_EQUALITY;
  option = (struct config){ .command = command, .path = "--formula" };
  if (strcmp(given->claimed, "equality") != 0 && !read_count(given->claimed, 1, MOST_CLAIMED, &claimed)) {
    complain(command, "--claimed: %s",
             not_allowed(given->claimed, "n of the claim + O(T^n), from 1 to 999, or equality"));
    return EXIT_USAGE;
  }
  struct entry *e = new_entry(&option, NULL);
  if (!e)
    return EXIT_UNSOLVED;
  e->formula.name = "formula";
  e->formula.text = given->text;
  e->formula.remainder = (int)claimed;
  e->of = place_of(given->of, book_quantities);
  e->start = given->start ? place_of(given->start, book_starts) : is_steady_word(given->of) ? FROM_STEADY : FROM_REST;
  e->phase = given->phase ? place_of(given->phase, book_phases) : SCALLOP_EXTENSION;
  if (take_entry(&option, e, NULL))
    return EXIT_DONE;
  free(e);
  return EXIT_USAGE;
}
