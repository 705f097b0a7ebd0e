#include "asymptotics/expression.h"

#include <ctype.h>
#include <stdlib.h>

enum { LARGEST_NUMBER = 1000000000, LARGEST_POWER = 64 };

struct reader {
  const char *at;
  expression_lookup *lookup;
  void *context;
  const struct ring *ring;
};

static bool read_sum(struct reader *r, struct series *value);

static char peek(struct reader *r)
{
  while (*r->at == ' ')
    r->at++;
  return *r->at;
}

static bool read_name(struct reader *r, struct series *value)
{
  const char *name = r->at;
  while (isalnum((unsigned char)*r->at) || *r->at == '_')
    r->at++;
  return r->at > name && r->lookup(r->context, name, (size_t)(r->at - name), value);
}

static bool read_atom(struct reader *r, struct series *value)
{
  char c = peek(r);
  if (isdigit((unsigned char)c)) {
    char *end;
    long number = strtol(r->at, &end, 10);
    r->at = end;
    series_set_si(value, number);
    return number <= LARGEST_NUMBER;
  }
  if (c != '(')
    return read_name(r, value);
  r->at++;
  if (!read_sum(r, value) || peek(r) != ')')
    return false;
  r->at++;
  return true;
}

static bool read_power(struct reader *r, struct series *value)
{
  if (!read_atom(r, value))
    return false;
  if (peek(r) != '^')
    return true;
  r->at++;
  if (!isdigit((unsigned char)peek(r)))
    return false;
  char *end;
  long power = strtol(r->at, &end, 10);
  r->at = end;
  if (power > LARGEST_POWER)
    return false;
  struct series base;
  series_init(&base);
  series_set(&base, value);
  series_set_si(value, 1);
  for (long i = 0; i < power; i++)
    series_mul(value, value, &base, r->ring);
  series_clear(&base);
  return true;
}

static bool read_sign(struct reader *r, struct series *value)
{
  if (peek(r) != '-')
    return read_power(r, value);
  r->at++;
  bool read = read_sign(r, value);
  series_neg(value, value);
  return read;
}

static bool read_product(struct reader *r, struct series *value)
{
  bool read = read_sign(r, value);
  struct series factor;
  series_init(&factor);
  for (char c; read && ((c = peek(r)) == '*' || c == '/');) {
    r->at++;
    read = read_sign(r, &factor);
    if (read && c == '*')
      series_mul(value, value, &factor, r->ring);
    else if (read)
      read = series_div(value, value, &factor, r->ring);
  }
  series_clear(&factor);
  return read;
}

static bool read_sum(struct reader *r, struct series *value)
{
  bool read = read_product(r, value);
  struct series term;
  series_init(&term);
  for (char c; read && ((c = peek(r)) == '+' || c == '-');) {
    r->at++;
    read = read_product(r, &term);
    if (read)
      (c == '+' ? series_add : series_sub)(value, value, &term, r->ring);
  }
  series_clear(&term);
  return read;
}

bool expression_evaluate(struct series *value, const char *text, expression_lookup *lookup, void *context,
                         const struct ring *ring)
{
  struct reader r = { text, lookup, context, ring };
  struct series result;
  series_init(&result);
  bool read = read_sum(&r, &result) && peek(&r) == '\0';
  if (read)
    series_set(value, &result);
  series_clear(&result);
  return read;
}
