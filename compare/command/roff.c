#include "compare/command/roff.h"

#include <ctype.h>
#include <string.h>

enum { LINE = 79 };

/* Writes text, or only counts its bytes where to is NULL. */
static size_t put(FILE *to, const char *text)
{
  if (to)
    fputs(text, to);
  return strlen(text);
}

/* A hyphen is written as a minus sign: those of options, numbers and names in a table must be found and copied as such. */
static size_t put_character(FILE *to, char c)
{
  switch (c) {
  case '\\': return put(to, "\\(rs");
  case '-': return put(to, "\\-");
  case '\'': return put(to, "\\(aq");
  case '"': return put(to, "\\(dq");
  case '`': return put(to, "\\(ga");
  case '^': return put(to, "\\(ha");
  case '~': return put(to, "\\(ti");
  default: return put(to, (const char[]){ c, '\0' });
  }
}

static size_t put_plain(FILE *to, const char *text)
{
  size_t bytes = 0;
  for (; *text; text++)
    bytes += put_character(to, *text);
  return bytes;
}

/* Bytes of the option at p, which is length long, or 0: there is none; after_name: behind a letter, a digit or a dash. */
static size_t option_at(const char *p, size_t length, bool after_name)
{
  size_t dashes = 0, n;
  while (dashes < length && p[dashes] == '-')
    dashes++;
  for (n = dashes; n < length && (isalnum((unsigned char)p[n]) || (p[n] == '-' && n > dashes)); n++)
    ;
  bool named = n > dashes && isalpha((unsigned char)p[dashes]);
  return !after_name && named && (dashes == 2 || (dashes == 1 && n == 2)) ? n : 0;
}

/* One word with its fonts. */
static size_t put_word(FILE *to, const char *word, size_t length, bool *quoted)
{
  size_t bytes = 0, option_end = 0;
  for (size_t i = 0; i < length; i++) {
    if (word[i] == '`') {
      bytes += put(to, *quoted ? "\\fR" : "\\fB");
      *quoted = !*quoted;
      continue;
    }
    size_t option = *quoted || i < option_end
                        ? 0
                        : option_at(word + i, length - i,
                                    i > 0 && (isalnum((unsigned char)word[i - 1]) || word[i - 1] == '-'));
    if (option > 0) {
      bytes += put(to, "\\fB");
      option_end = i + option;
    }
    bytes += put_character(to, word[i]);
    if (option_end == i + 1)
      bytes += put(to, "\\fR");
  }
  return bytes;
}

void roff_break(struct roff *roff)
{
  if (roff->column > 0)
    putc('\n', roff->to);
  roff->column = 0;
  roff->dotted = roff->stopped = false;
}

/* Makes room for a word of so many bytes that begins with first: a blank or a line break before it, and what keeps roff from
 * taking a full stop at the end of a line for that of a sentence, and one at the start for a request. */
static void make_room(struct roff *roff, size_t bytes, char first)
{
  bool new_sentence = roff->stopped && (isupper((unsigned char)first) || first == '-');
  bool full = roff->column + 1 + bytes > LINE;
  if (roff->column > 0 && (full || new_sentence)) {
    if (roff->dotted && !new_sentence)
      fputs("\\&", roff->to);
    roff_break(roff);
  }
  if (roff->column > 0)
    roff->column += put(roff->to, " ");
  else if (first == '.')
    roff->column += put(roff->to, "\\&");
}

/* Does the word end in dots, brackets and quotes that close behind them aside? In a full stop, if it is one dot. */
static void note_end(struct roff *roff, const char *word, size_t length)
{
  while (length > 0 && strchr(")'", word[length - 1]))
    length--;
  roff->dotted = length > 0 && word[length - 1] == '.';
  roff->stopped = roff->dotted && !(length > 1 && word[length - 2] == '.');
}

void roff_words(struct roff *roff, const char *text, size_t length)
{
  const char *end = text + length;
  for (const char *p = text; p < end;) {
    size_t n = 0;
    while (p + n < end && !isspace((unsigned char)p[n]))
      n++;
    if (n > 0) {
      bool quoted = roff->quoted;
      make_room(roff, put_word(NULL, p, n, &quoted), *p);
      roff->column += put_word(roff->to, p, n, &roff->quoted);
      note_end(roff, p, n);
    }
    p += n > 0 ? n : 1;
  }
}

void roff_text(struct roff *roff, const char *text) { roff_words(roff, text, strlen(text)); }

static size_t put_font(FILE *to, const char *before, char font, const char *text, const char *after)
{
  const char change[] = { '\\', 'f', font, '\0' };
  return put_plain(to, before) + put(to, change) + put_plain(to, text) + put(to, "\\fR") + put_plain(to, after);
}

void roff_font(struct roff *roff, const char *before, char font, const char *text, const char *after)
{
  make_room(roff, put_font(NULL, before, font, text, after), *before ? *before : *text);
  roff->column += put_font(roff->to, before, font, text, after);
  note_end(roff, after, strlen(after));
}

void roff_macro(struct roff *roff, const char *macro, const char *text)
{
  roff_break(roff);
  fprintf(roff->to, ".%s", macro);
  if (text) {
    fputs(" \"", roff->to);
    put_plain(roff->to, text);
    putc('"', roff->to);
  }
  putc('\n', roff->to);
}

void roff_bold_line(struct roff *roff, const char *text, size_t length)
{
  roff_break(roff);
  fputs("\\fB", roff->to);
  for (size_t i = 0; i < length; i++)
    put_character(roff->to, text[i]);
  fputs("\\fR\n", roff->to);
}

void roff_line(struct roff *roff, const char *text)
{
  roff_break(roff);
  put(roff->to, *text == '.' ? "\\&" : "");
  put_plain(roff->to, text);
  putc('\n', roff->to);
}
