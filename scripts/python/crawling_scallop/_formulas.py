"""Formulas: those of the paper as printed, and one's own."""

from __future__ import annotations

import ctypes
import difflib
import itertools
import math
import re
import weakref
from typing import Any, Mapping, Optional

import numpy as np
import numpy.typing as npt

from . import _exact as exact, _library as c, _studies as studies
from ._arrays import Floats
from ._errors import DomainError
from ._gaits import GaitLike, OneGait, address_of, made, together
from ._motion import complain

_SETTINGS = {"steady": c.STEADY, "extension": c.MOVING_EXTENSION, "contraction": c.MOVING_CONTRACTION}


class Formula:
    """A formula that was read, made by :func:`formula`: call it for its values.

    Attributes
    ----------
    text : str
        The formula.
    motion : str
        What it is about: ``'steady'``, ``'extension'`` or ``'contraction'``.
    parts : dict
        Names for parts of the text.
    """

    __slots__ = ("text", "motion", "parts", "_library", "_read", "__weakref__")

    def __init__(self, row: Any, motion: str, parts: Optional[Mapping[str, str]] = None) -> None:
        message = ctypes.create_string_buffer(c.MESSAGE)
        self.text, self.motion, self.parts = row.text.decode(), motion, dict(parts or {})
        self._library = c.library()
        self._read = self._library.scallop_formula_read(row, message)
        if not self._read:
            raise DomainError(f"text = {self.text!r}: {message.value.decode()}")
        weakref.finalize(self, self._library.scallop_formula_free, self._read)

    def __repr__(self) -> str:
        return f"<Formula {self.text!r} of {self.motion!r}>"

    def __call__(self, v0: npt.ArrayLike = 0, m1: npt.ArrayLike = 1, m2: npt.ArrayLike = 1, F1: npt.ArrayLike = 4,
                 F2: npt.ArrayLike = 1, L: npt.ArrayLike = 10, T: npt.ArrayLike = 1, alpha: npt.ArrayLike = 0.75,
                 gait: GaitLike = "quadratic", t1: npt.ArrayLike = math.nan, dT: npt.ArrayLike = math.nan,
                 x_switch: npt.ArrayLike = math.nan) -> Floats:
        """The values of the formula, row by row: some microseconds for each.

        Parameters
        ----------
        v0, m1, m2, F1, F2, L, T, alpha : array_like of float
            As for :func:`phase`. `T` is the period, as everywhere here; in the text of a formula about a phase, ``T`` is
            the duration of that phase.
        gait : str, Gait or array_like of these
            As for :func:`steady`.
        t1, dT, x_switch : array_like of float
            For formulas that take these as given.

        Returns
        -------
        float or ndarray
            nan or an infinity off the domain of a quotient, a power or a function.
        """
        columns = together(
            dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0, t1=t1, dT=dT, x_switch=x_switch), gait)
        kind, check, value_of = self._kind(), self._library.scallop_crawler_check, self._library.scallop_formula_double
        values: list[float] = []
        for *numbers, start, first, last, place, address in zip(*(each.ravel().tolist() for each in columns.values())):
            crawler = c.Crawler(*numbers, address)
            if check(crawler, None) < 0 or not math.isfinite(start):
                complain(columns, len(values))
            values.append(value_of(self._read, crawler, kind, start, first, last, place))
        found: Floats = np.array(values, float).reshape(columns.shape)[()]
        return found

    def ball(self, digits: int = 17, v0: exact.Exact = 0, m1: exact.Exact = 1, m2: exact.Exact = 1, F1: exact.Exact = 4,
             F2: exact.Exact = 1, L: exact.Exact = 10, T: exact.Exact = 1, alpha: exact.Exact = 0.75,
             gait: OneGait = "quadratic") -> exact.Ball:
        """Enclose the value for one crawler with exact parameters. Needs libscallop with FLINT.

        Parameters
        ----------
        digits : int
            The relative radius is at most ``10**-digits``; a value that cannot be told from 0 has a small ball around 0.
        v0, m1, m2, F1, F2, L, T, alpha : exact number
            As for :func:`series`.
        gait : str or Gait
            As for :func:`steady`.

        Returns
        -------
        Ball

        Raises
        ------
        UnsolvedError
            There is no finite value, or the formula has t1, dT or x_switch.
        """
        one = made(gait)
        return exact.enclosed(self._library, self._read, self._kind(), v0, digits,
                              dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha), address_of(one))

    def verdict(self, of: str, claimed: Optional[int] = None, start: Optional[str] = None, gait: OneGait = "quadratic",
                **crawler: float) -> studies.Verdict:
        """Decide by proof of which order the error of this formula is. Needs the command, built with FLINT.

        Parameters
        ----------
        of : str
            What the formula gives: ``'displacement'``, ``'v_start'``, ``'v_end'``, ``'dxC'`` or another quantity of
            docs/reference/formulas.md.
        claimed : int, optional
            The n of its claim ``+ O(T^n)``; without it the formula claims equality.
        start : {'rest', 'v0'}, optional
            Where the motion of a phase starts.
        gait : str or Gait
            As for :func:`steady`.
        **crawler : float
            m1, m2, F1, F2, L, alpha. Without any of them the crawler has numbers without a coincidence.

        Returns
        -------
        Verdict

        Examples
        --------
        >>> import crawling_scallop
        >>> mine = crawling_scallop.formula("(F1 - F2)/M*T", "extension")
        >>> verdict = mine.verdict("v_end", claimed=3)
        >>> verdict.verdict, verdict.derived_order, verdict.leading_error
        ('holds', 3, '2*F1*T^3*(F1 - F2)/(m2*M*lT)')
        """
        return studies.decide(self.text, self.parts, self.motion, of, claimed, start, gait, crawler)

    def _kind(self) -> int:
        return c.KINDS.get(self.motion, 0)


def formula(text: str, motion: str = "steady", parts: Optional[Mapping[str, str]] = None) -> Formula:
    """Read a formula of your own.

    Parameters
    ----------
    text : str
        In the names of the paper's formulas, m1 m2 F1 F2 M L L_kin alpha T l0 lT k0 kT l_start l_end v0 t1 dT x_switch
        (docs/reference/formulas.md says what they are; :func:`formulas` has examples), with decimal numbers, ``+ - * / ^``,
        parentheses, pi, abs sqrt exp log log10 sin cos asin and min max.
    motion : {'steady', 'extension', 'contraction'}
        What it is about. The steady state has no v0, t1, dT and x_switch.
    parts : dict, optional
        ``{name: text}``, names for parts of the text.

    Returns
    -------
    Formula
        Call it for its values.

    Raises
    ------
    DomainError
        The text has a mistake: the message says where.

    Examples
    --------
    >>> import crawling_scallop
    >>> mine = crawling_scallop.formula("(F1 - F2)/M*T/4", "extension")
    >>> mine(F1=[2, 3], T=0.5, alpha=0.5).tolist()
    [0.03125, 0.0625]
    """
    if not isinstance(motion, str) or motion not in _SETTINGS:
        raise DomainError(f"motion = {motion!r}: 'steady', 'extension' or 'contraction'")
    given = dict(parts or {})
    if not isinstance(text, str) or not all(isinstance(each, str) for pair in given.items() for each in pair):
        raise DomainError(f"text = {text!r}, parts = {parts!r}: a text, and a dict of texts")
    if any("\0" in each for each in (text, *given.values())):
        raise DomainError(f"text = {text!r}: it has a NUL")
    known = c.words(c.library(), "scallop_symbol_names", c.SYMBOLS)
    for name in given:
        if not re.fullmatch("[A-Za-z][A-Za-z0-9_]{0,62}", name) or name in (*known, "pi"):
            raise DomainError(f"parts: {name!r} cannot be the name of a part")
    pairs = [(name.encode(), part.encode()) for name, part in given.items()]
    row = c.Formula(setting=_SETTINGS[motion], text=text.encode(), parts=0)
    listed = (c.Part * (len(pairs) + 1))(*(c.Part(*pair) for pair in pairs))
    row.parts = ctypes.addressof(listed)
    try:
        return Formula(row, motion, given)
    except DomainError as error:
        unknown = re.search(r"'(\w+)' is no quantity known here$", str(error))
        near = difflib.get_close_matches(unknown[1], (*known, *given), 1, 0.5) if unknown else []
        raise DomainError(f"{error}; did you mean {near[0]!r}?" if near else str(error)) from None


def _published() -> dict[str, Any]:
    table = ctypes.pointer(c.Formula.in_dll(c.library(), "scallop_published"))
    entries = itertools.takewhile(lambda formula: bool(formula.name), map(table.__getitem__, itertools.count()))
    return {formula.name.decode(): formula for formula in entries}


def formulas() -> dict[str, tuple[str, str]]:
    """List the paper's formulas.

    Returns
    -------
    dict
        ``{name: (equation, formula)}``, in the order of the paper.

    Examples
    --------
    >>> import crawling_scallop
    >>> crawling_scallop.formulas()["eq21_dxC"][0]
    '(21)'
    """
    return {name: (formula.equation.decode(), formula.text.decode()) for name, formula in _published().items()}


def published(name: str, v0: npt.ArrayLike = 0, m1: npt.ArrayLike = 1, m2: npt.ArrayLike = 1, F1: npt.ArrayLike = 4,
              F2: npt.ArrayLike = 1, L: npt.ArrayLike = 10, T: npt.ArrayLike = 1, alpha: npt.ArrayLike = 0.75,
              gait: GaitLike = "quadratic", t1: npt.ArrayLike = math.nan, dT: npt.ArrayLike = math.nan,
              x_switch: npt.ArrayLike = math.nan) -> Floats:
    """Evaluate a formula of the paper as printed, mistakes included.

    Parameters
    ----------
    name : str
        One of those that :func:`formulas` lists: ``'eq21_dxC'`` is equation (21).
    v0, m1, m2, F1, F2, L, T, alpha : array_like of float
        As for a :class:`Formula`.
    gait : str, Gait or array_like of these
        As for :func:`steady`.
    t1, dT, x_switch : array_like of float
        For formulas that take these as given.

    Returns
    -------
    float or ndarray
        A formula for one phase is that of the extension or of the contraction that it was printed for, from rest or from
        `v0`. Where a gait has l'' = 0 at the start or end of a phase most formulas are not finite.
    """
    known = _published()
    if not isinstance(name, str) or name not in known:
        near = difflib.get_close_matches(str(name), known, 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise DomainError(f"name = {name!r}: a formula that formulas() lists{hint}")
    motion = {c.STEADY: "steady", c.MOVING_CONTRACTION: "contraction"}.get(known[name].setting, "extension")
    return Formula(known[name], motion)(v0, m1, m2, F1, F2, L, T, alpha, gait, t1, dT, x_switch)
