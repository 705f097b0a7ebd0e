/* Truncated power series in T whose coefficients are rational functions. */
#include "asymptotics/symbolic/symbolic.h"

static struct symbolic_series zeros(struct symbols *s, slong length)
{
  struct symbolic_series series = { .length = length };
  symbolic zero = symbolic_number(s, 0, 1);
  for (slong k = 0; k < length; k++)
    series.term[k] = zero;
  return series;
}

struct symbolic_series symbolic_series_set(struct symbols *s, symbolic value, slong power, slong length)
{
  struct symbolic_series series = zeros(s, length);
  if (power < length)
    series.term[power] = value;
  return series;
}

static struct symbolic_series sum(struct symbols *s, const struct symbolic_series *a, const struct symbolic_series *b,
                                  bool sub, slong length)
{
  struct symbolic_series series = zeros(s, length);
  for (slong k = 0; k < length; k++) {
    if (k < a->length)
      series.term[k] = a->term[k];
    if (k < b->length && !symbolic_is_zero(b->term[k], s))
      series.term[k] = (sub ? symbolic_sub : symbolic_add)(s, series.term[k], b->term[k]);
  }
  return series;
}

struct symbolic_series symbolic_series_add(struct symbols *s, const struct symbolic_series *a,
                                           const struct symbolic_series *b, slong length)
{
  return sum(s, a, b, false, length);
}

struct symbolic_series symbolic_series_sub(struct symbols *s, const struct symbolic_series *a,
                                           const struct symbolic_series *b, slong length)
{
  return sum(s, a, b, true, length);
}

/* from +- the sum of a_i b_(k - i) with i >= first */
static symbolic convolve(struct symbols *s, symbolic from, bool sub, const struct symbolic_series *a, slong first,
                         const struct symbolic_series *b, slong k)
{
  for (slong i = first; i <= k && i < a->length; i++)
    if (k - i < b->length && !symbolic_is_zero(a->term[i], s) && !symbolic_is_zero(b->term[k - i], s))
      from = (sub ? symbolic_sub : symbolic_add)(s, from, symbolic_mul(s, a->term[i], b->term[k - i]));
  return from;
}

struct symbolic_series symbolic_series_mul(struct symbols *s, const struct symbolic_series *a,
                                           const struct symbolic_series *b, slong length)
{
  struct symbolic_series series = zeros(s, length);
  for (slong k = 0; k < length; k++)
    series.term[k] = convolve(s, series.term[k], false, a, 0, b, k);
  return series;
}

struct symbolic_series symbolic_series_scale(struct symbols *s, const struct symbolic_series *a, symbolic factor,
                                             slong length)
{
  struct symbolic_series series = symbolic_series_set(s, factor, 0, 1);
  return symbolic_series_mul(s, a, &series, length);
}

struct symbolic_series symbolic_series_div(struct symbols *s, const struct symbolic_series *a,
                                           const struct symbolic_series *b, slong length)
{
  struct symbolic_series series = zeros(s, length);
  for (slong k = 0; k < length; k++) {
    symbolic rest = convolve(s, k < a->length ? a->term[k] : series.term[k], true, b, 1, &series, k);
    if (!symbolic_is_zero(rest, s))
      series.term[k] = symbolic_div(s, rest, b->term[0]);
  }
  return series;
}

struct symbolic_series symbolic_series_shift(struct symbols *s, const struct symbolic_series *a, slong power,
                                             slong length)
{
  struct symbolic_series series = zeros(s, length);
  for (slong k = 0; k < length; k++)
    if (k >= power && k - power < a->length)
      series.term[k] = a->term[k - power];
  return series;
}

struct symbolic_series symbolic_series_of(struct symbols *s, symbolic value, slong first, slong length)
{
  struct symbolic_series over = zeros(s, length), under = over;
  slong lowest = 0;
  while (symbolic_is_zero(symbolic_coefficient(s, value, true, lowest), s))
    lowest++;
  for (slong k = 0; k < length; k++) {
    if (k + lowest + first >= 0)
      over.term[k] = symbolic_coefficient(s, value, false, k + lowest + first);
    under.term[k] = symbolic_coefficient(s, value, true, k + lowest);
  }
  return symbolic_series_div(s, &over, &under, length);
}
