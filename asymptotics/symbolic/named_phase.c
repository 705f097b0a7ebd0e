/* The constants of a phase as symbols, and the law of l' near its ends. */
#include "asymptotics/symbolic/named_phase.h"

#include "asymptotics/derived/scoped.h"

void add_derivatives(struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind, slong order)
{
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, at_anchor, one);
  fmpq_one(one);
  scallop_rational_speed_series(speed, piece, at_anchor, order > 2 ? order : 2, one);
  for (slong k = 1; k == 1 || k < order - 1; k++)
    if (k < fmpq_poly_length(speed) && !fmpz_is_zero(fmpq_poly_numref(speed) + k))
      symbols_add(s, piece->anchor == SCALLOP_FROM_START ? NAMED_AT_START : NAMED_AT_END, (int)k + 1, kind);
}

void named_law(struct series *law, struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind)
{
  const struct ring all = { SYMBOLIC_ORDERS + 2, 2 };
  const enum symbol_meaning at = piece->anchor == SCALLOP_FROM_END ? NAMED_AT_END : NAMED_AT_START;
  SCOPED(series, term);
  series_set_si(law, 0);
  for (int place = 0; place < s->count; place++) {
    const struct symbol *symbol = &s->list[place];
    const int power = symbol->derivative - 1;
    if (symbol->meaning != at || symbol->kind != kind)
      continue;
    symbolic coefficient = symbolic_place(s, place);
    for (int i = 2; i <= power; i++)
      coefficient = symbolic_mul(s, coefficient, symbolic_number(s, 1, (ulong)i));
    series_set_ratio(&term, coefficient);
    series_shift(&term, &term, power);
    (kind == SCALLOP_EXTENSION ? series_add : series_sub)(law, law, &term, &all);
  }
}

void named_phase(struct phase_series *to, struct symbols *s, enum scallop_phase_kind kind)
{
  const bool extension = kind == SCALLOP_EXTENSION;
  symbolic none = symbolic_number(s, 0, 1), F1 = symbolic_named(s, NAMED_F1), F2 = symbolic_named(s, NAMED_F2);
  symbolic m1 = symbolic_named(s, NAMED_m1), m2 = symbolic_named(s, NAMED_m2), both = symbolic_add(s, F1, F2);
  to->kind = kind;
  to->has_laws = true;
  series_set_ratio(&to->curve[0], extension ? m2 : m1);
  series_set_ratio(&to->curve[1], symbolic_sub(s, none, extension ? m1 : m2));
  series_set_ratio(&to->beta[0], symbolic_sub(s, none, both));
  series_set_ratio(&to->beta[1], extension ? symbolic_sub(s, F1, F2) : symbolic_sub(s, F2, F1));
  series_set_ratio(&to->beta[2], both);
  series_set_ratio(&to->whole, symbolic_named(s, NAMED_L));
  series_set_ratio(&to->unit, symbolic_div(s, symbolic_number(s, 1, 1), symbolic_named(s, NAMED_M)));
}
