/* Lists of formulas, searched by name and by place. */
#include <search.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "compare/formulas/formula_file.h"
#include "compare/text/memory.h"
#include "compare/text/values.h"

/* The formulas of the formula files, in the order of reading, and as a tree by their names */
static struct scallop_formula **formulas;
static int count;
static void *by_name;

static int compare(const void *a, const void *b)
{
  return strcmp(((const struct scallop_formula *)a)->name, ((const struct scallop_formula *)b)->name);
}

const struct scallop_formula *user_formula_named(const char *name)
{
  const struct scallop_formula key = { .name = name };
  struct scallop_formula *const *found = tfind(&key, &by_name, compare);
  return found ? *found : NULL;
}

bool user_formula_keep(struct scallop_formula *f)
{
  struct scallop_formula **more = list_grown(formulas, count, sizeof(struct scallop_formula *));
  formulas = more ? more : formulas;
  if (!more || !tsearch(f, &by_name, compare))
    return false;
  formulas[count++] = f;
  return true;
}

const struct scallop_formula *user_formula(int i) { return i < count ? formulas[i] : NULL; }

/* Returns formula i of the paper's and their corrections; listed: of those that listed_formula returns. */
static const struct scallop_formula *of_tool(int i, bool listed)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    if (!(listed && f->when) && i-- == 0)
      return f;
  for (const struct scallop_formula *f = scallop_corrected; !listed && f->name; f++)
    if (i-- == 0)
      return f;
  return NULL;
}

const struct scallop_formula *listed_formula(int i) { return i < count ? formulas[i] : of_tool(i - count, true); }
const struct scallop_formula *formula_at(int i) { return i < count ? formulas[i] : of_tool(i - count, false); }

/* Returns formula i of the formula files and the paper with the equation, alone or among others, or NULL. */
static const struct scallop_formula *of_equation(const char *equation, int i)
{
  const struct scallop_formula *f = NULL;
  bool is_equation = *equation == '(' && equation[strcspn(equation, ")")] == ')';
  for (int k = 0; is_equation && (f = formula_at(k)) && f != scallop_corrected; k++)
    if (strstr(f->equation, equation) && i-- == 0)
      return f;
  return NULL;
}

const struct scallop_formula *formula_named(const char *name)
{
  const struct scallop_formula *of_user = user_formula_named(name),
                               *f = of_user ? of_user : scallop_formula_named(name);
  return f || of_equation(name, 1) ? f : of_equation(name, 0);
}

bool formula_is_listed(const char *list, const char *name)
{
  bool is = strcmp(list, "all") == 0;
  char item[FORMULA_PLACE];
  while (!is && next_item(item, sizeof item, &list)) {
    const struct scallop_formula *f = *item == '(' ? formula_named(item) : NULL;
    is = strcmp(f ? f->name : item, name) == 0;
  }
  return is;
}

const char *formula_hint(const char *name)
{
  enum { MAX_NAMES = 400, SIZE = 400 };
  static char text[SIZE];
  const char *names[MAX_NAMES + 1] = { NULL };
  const struct scallop_formula *f;
  size_t used = 0;
  for (int i = 0; (f = of_equation(name, i)) && used < sizeof text; i++)
    used += (size_t)snprintf(text + used, sizeof text - used, "%s %s", i == 0 ? ": of this equation there are" : ",",
                             f->name);
  for (int i = 0; i < MAX_NAMES && (f = formula_at(i)); i++)
    names[i] = f->name;
  return used > 0 ? text : did_you_mean(nearest(name, names));
}

bool formula_file_applies(const char *command, const char *file, formula_is_for *is_for, const void *context,
                          const char *what)
{
  int found = 0;
  for (int i = 0; file && i < count; i++)
    found += is_for(context, user_formula(i));
  if (file && found == 0)
    return complain(command, "--formulas: no formula of %s is about %s", file, what);
  return found <= MAX_USER_FORMULAS
         || complain(command, "--formulas: more than %d formulas of %s are about %s", MAX_USER_FORMULAS, file, what);
}

struct read_once {
  struct read_once *next;
  const struct scallop_formula *formula;
  struct formula read;
};
static _Atomic(struct read_once *) all;

const struct formula *formula_read_once(const struct scallop_formula *formula)
{
  char message[FORMULA_MESSAGE];
  struct read_once *first = atomic_load(&all);
  for (const struct read_once *k = first; k; k = k->next)
    if (k->formula == formula)
      return &k->read;
  struct read_once *made = malloc(sizeof *made);
  if (!made || scallop_formula_text(&made->read, formula, NULL, message)) {
    free(made);
    return NULL;
  }
  made->formula = formula;
  made->next = first;
  while (!atomic_compare_exchange_weak(&all, &made->next, made))
    ;
  return &made->read;
}

bool formula_takes(const struct scallop_formula *formula, enum scallop_symbol symbol)
{
  const struct formula *read = formula_read_once(formula);
  int places[FORMULA_STEPS];
  bool takes = false;
  for (int i = read ? formula_places(read, places) : 0; i-- > 0;)
    takes = takes || places[i] == (int)symbol;
  return takes;
}

void user_formulas_free(void)
{
  for (struct read_once *first; (first = atomic_load(&all));) {
    atomic_store(&all, first->next);
    free(first);
  }
  while (count > 0) {
    tdelete(formulas[--count], &by_name, compare);
    free(formulas[count]);
  }
  free(formulas);
  formulas = NULL;
}
