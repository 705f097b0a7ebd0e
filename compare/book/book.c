#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "compare/book/entry.h"
#include "compare/text/memory.h"

/* The formulas of the books that were read, in the order of reading, and the files, which have their texts */
static struct entry **entries;
static int count;
enum { BUCKETS = 16384 };
static struct entry *buckets[BUCKETS]; /* the entries by their names */
static struct config **files;
static int file_count;

static struct entry **bucket_of(const char *name) { return &buckets[checksum(name) % BUCKETS]; }

const struct entry *book_entry_named(const char *name)
{
  const struct entry *e = *bucket_of(name);
  while (e && strcmp(e->formula.name, name) != 0)
    e = e->next;
  return e;
}

bool book_keep(struct entry *e)
{
  struct entry **more = with_room(entries, count, sizeof(struct entry *));
  if (!more)
    return false;
  entries = more;
  entries[count++] = e;
  struct entry **bucket = bucket_of(e->formula.name);
  e->next = *bucket;
  *bucket = e;
  return true;
}

struct config *book_config(void)
{
  struct config **more = with_room(files, file_count, sizeof(struct config *)), *c = more ? calloc(1, sizeof *c) : NULL;
  files = more ? more : files;
  if (c)
    files[file_count++] = c;
  return c;
}

int book_count(void) { return count; }
const struct entry *book_entry(int i) { return entries[i]; }
const struct scallop_formula *book_formula(int i) { return i < count ? &entries[i]->formula : NULL; }

/* The formula at place i of a list, or NULL; of the list behind it the place is then *i */
static const struct scallop_formula *in_list(const struct scallop_formula *list, int *i)
{
  for (; list->name; list++)
    if ((*i)-- == 0)
      return list;
  return NULL;
}

static const struct scallop_formula *in_books(int *i)
{
  const struct scallop_formula *f = book_formula(*i);
  *i -= f ? 0 : count;
  return f;
}

const struct scallop_formula *listed_formula(int i)
{
  const struct scallop_formula *f = in_books(&i), *list = scallop_published;
  for (; !f && list->name; list++)
    if (!list->when && i-- == 0)
      f = list;
  return f;
}

const struct scallop_formula *formula_at(int i)
{
  const struct scallop_formula *f = in_books(&i);
  f = f ? f : in_list(scallop_published, &i);
  return f ? f : in_list(scallop_corrected, &i);
}

const char *formula_place(char text[FORMULA_PLACE], const struct scallop_formula *formula)
{
  *text = '\0';
  for (int i = 0; i < count; i++)
    if (&entries[i]->formula == formula && entries[i]->group)
      snprintf(text, FORMULA_PLACE, "%s:%d: ", entries[i]->path, config_setting_source_line(entries[i]->group));
  return text;
}

/* The formula of the books and of the paper at place i that has the equation, alone or beside others, or NULL */
static const struct scallop_formula *of_equation(const char *equation, int i)
{
  const struct scallop_formula *f;
  bool is_equation = *equation == '(' && equation[strcspn(equation, ")")] == ')';
  for (int k = 0, place; is_equation; k++) {
    place = k;
    f = in_books(&place);
    f = f ? f : in_list(scallop_published, &place);
    if (!f || (strstr(f->equation, equation) && i-- == 0))
      return f;
  }
  return NULL;
}

const struct scallop_formula *formula_named(const char *name)
{
  const struct entry *e = book_entry_named(name);
  const struct scallop_formula *f = e ? &e->formula : scallop_formula_named(name);
  return f || of_equation(name, 1) ? f : of_equation(name, 0);
}

bool formula_is_listed(const char *list, const char *name)
{
  bool is = strcmp(list, "all") == 0;
  for (const char *end; !is && *list; list = end + (*end == ',')) {
    end = list + strcspn(list, ",");
    char item[FORMULA_PLACE];
    snprintf(item, sizeof item, "%.*s", (int)(end - list), list);
    const struct scallop_formula *f = *item == '(' ? formula_named(item) : NULL;
    is = strcmp(f ? f->name : item, name) == 0;
  }
  return is;
}

const char *formula_instead(const char *name)
{
  enum { MOST = 400 };
  static char text[MOST];
  const char *names[MOST + 1] = { NULL };
  const struct scallop_formula *f;
  size_t used = 0;
  for (int i = 0; (f = of_equation(name, i)) && used < sizeof text; i++)
    used += (size_t)snprintf(text + used, sizeof text - used, "%s %s", i == 0 ? ": of this equation there are" : ",",
                             f->name);
  for (int i = 0; i < MOST && formula_at(i); i++)
    names[i] = formula_at(i)->name;
  return used > 0 ? text : did_you_mean(nearest(name, names));
}

bool book_serves(const char *command, const char *file, formula_is_for *is_for, const void *context, const char *what)
{
  int found = 0;
  for (int i = 0; file && book_formula(i); i++)
    found += is_for(context, book_formula(i));
  if (file && found == 0)
    complain(command, "--book: no formula of %s is about %s", file, what);
  else if (found > BOOK_MOST)
    complain(command, "--book: more than %d formulas of %s are about %s", BOOK_MOST, file, what);
  return !file || (found > 0 && found <= BOOK_MOST);
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

void books_forget(void)
{
  for (struct read_once *first; (first = atomic_load(&all));) {
    atomic_store(&all, first->next);
    free(first);
  }
  while (count > 0)
    free(entries[--count]);
  memset(buckets, 0, sizeof buckets);
  while (file_count > 0) {
    config_close(files[--file_count]);
    free(files[file_count]);
  }
  free(entries);
  free(files);
  entries = NULL;
  files = NULL;
}
