/* The texts of a row of a claim in words (decide.h). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/claims/decide.h"
#include "compare/claims/evidence.h"
#include "compare/text/table.h"

struct out {
  char *text;
  size_t size;
};

static void append(const struct out *out, const char *text, size_t length)
{
  size_t used = strlen(out->text);
  snprintf(out->text + used, out->size - used, "%.*s", (int)length, text);
}

/* but for those in the columns of a table */
static void append_options(const struct out *out, const struct scallop_crawler *c, const bool columns[CRAWLER_NUMBERS])
{
  const struct scallop_crawler d = scallop_crawler_default();
  double defaults[CRAWLER_NUMBERS], values[CRAWLER_NUMBERS];
  char option[2 * NUMBER_TEXT], number[NUMBER_TEXT];
  crawler_numbers(&d, defaults);
  crawler_numbers(c, values);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (values[i] != defaults[i] && !columns[i]) {
      number_text(number, values[i], 0);
      append(out, option, (size_t)snprintf(option, sizeof option, " --%s %s", crawler_parameters[i], number));
    }
  if (c->gait != d.gait) {
    append(out, " --gait ", 8);
    append(out, c->gait->name, strlen(c->gait->name));
  }
}

/* A command that prints the steady states: a column for each number in which they differ */
static void append_table(const struct question *q, const struct out *out)
{
  double number[MOTIONS][CRAWLER_NUMBERS];
  bool columns[CRAWLER_NUMBERS] = { false };
  int rows = 0;
  for (int k = 1; k <= q->motions && q->motion[k].of == OF_STEADY; k++) {
    crawler_numbers(&q->motion[k].crawler, number[rows]);
    for (int i = 0; i < CRAWLER_NUMBERS; i++)
      columns[i] = columns[i] || number[rows][i] != number[0][i];
    rows++;
  }
  append(out, "printf '", 8);
  for (int k = -1; k < rows; k++) {
    const char *between = "";
    for (int i = 0; i < CRAWLER_NUMBERS; i++)
      if (columns[i]) {
        char cell[NUMBER_TEXT];
        int length = k < 0 ? snprintf(cell, sizeof cell, "%s%s", between, crawler_parameters[i])
                           : snprintf(cell, sizeof cell, "%s%.10g", between, number[k][i]);
        append(out, cell, (size_t)length);
        between = "\\t";
      }
    append(out, "\\n", 2);
  }
  append(out, "' | scallop steady --points -", 29);
  append_options(out, &q->motion[1].crawler, columns);
}

/* 3f FORMULA */
static void append_number(struct question *q, const struct out *out, const char *inside)
{
  char *kind, number[64];
  int digits = (int)strtol(inside, &kind, 10);
  const char *format = *kind == 'f' ? "%.*f" : *kind == 'e' ? "%.*e" : "%.*g";
  append(out, number, (size_t)snprintf(number, sizeof number, format, digits, number_of(q, kind + 2)));
}

static const char *closing_brace(const char *at)
{
  for (int depth = 1; depth > 0; at++)
    depth += (*at == '{') - (*at == '}');
  return at - 1;
}

static void append_braced(struct question *q, const struct out *out, const char *inside)
{
  static const bool no_columns[CRAWLER_NUMBERS];
  char modes[MOTION_MODES_TEXT];
  const char *colon = strchr(inside, ':');
  const struct moved *m = &q->motion[colon ? atoi(colon + 1) : 1];
  const char *plain = strcmp(inside, "whose") == 0  ? q->of_the_paper ? "the paper's crawler" : "the ledger's crawler"
                      : strcmp(inside, "gait") == 0 ? q->crawler.gait->name
                      : strncmp(inside, "modes", 5) == 0 ? motion_modes_text(modes, m->of, m->modes)
                                                         : NULL;
  if (*inside == '+' || *inside == '-') {
    if (q->row.verdict == (*inside == '+' ? CLAIM_HOLDS : CLAIM_REFUTED))
      say(q, out->text, out->size, inside + 1);
  } else if (inside[0] && !inside[1])
    say(q, out->text, out->size, q->word[*inside - '1']);
  else if (plain)
    append(out, plain, strlen(plain));
  else if (strncmp(inside, "options", 7) == 0)
    append_options(out, &m->crawler, no_columns);
  else if (strcmp(inside, "table") == 0)
    append_table(q, out);
  else
    append_number(q, out, inside);
}

void say(struct question *q, char *text, size_t size, const char *format)
{
  const struct out out = { text, size };
  while (*format) {
    char inside[320];
    size_t length = strcspn(format, "{");
    append(&out, format, length);
    format += length;
    if (*format == '{') {
      const char *end = closing_brace(format + 1);
      snprintf(inside, sizeof inside, "%.*s", (int)(end - format - 1), format + 1);
      append_braced(q, &out, inside);
      format = end + 1;
    }
  }
}

void settle(struct question *q, bool holds, bool fails)
{
  struct claim_row *row = &q->row;
  row->verdict = !q->solved ? CLAIM_UNDECIDED : holds ? CLAIM_HOLDS : fails ? CLAIM_REFUTED : CLAIM_UNDECIDED;
  if (row->verdict == CLAIM_UNDECIDED)
    row->evidence = NO_EVIDENCE;
  else if (row->evidence == NO_EVIDENCE) /* no motion of the claim's own */
    row->evidence = MEASURED;
  if (row->verdict == CLAIM_HOLDS && q->claim->proven && scallop_gait_named(q->crawler.gait->name))
    row->evidence = PROVEN_FOR_ALL;
  say(q, row->conditions, sizeof row->conditions, q->claim->conditions);
  say(q, row->measured, sizeof row->measured, q->solved ? q->claim->measured : "not proven");
  if (row->verdict != CLAIM_HOLDS && q->claim->reason)
    say(q, row->reason, sizeof row->reason, q->claim->reason);
}

void conclude(struct question *q)
{
  const struct claim *claim = q->claim;
  arb_t x;
  arb_init(x);
  value_of(x, q,
           claim->says       ? claim->needs ? claim->needs : "1"
           : claim->shown_by ? claim->shown_by
                             : claim->refuted_by);
  int holds = !arb_is_positive(x) ? 0 : claim->says ? judge(q, x) : claim->shown_by ? 1 : -1;
  settle(q, holds > 0, holds < 0);
  arb_clear(x);
}

void proven(struct question *q)
{
  solve_motions(q, true);
  conclude(q);
}
