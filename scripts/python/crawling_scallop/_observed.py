"""The observed order of a table. It needs no NumPy."""

from __future__ import annotations

import ctypes
import math
import reprlib
from fractions import Fraction
from typing import Any, Iterable, Mapping, NamedTuple, Sequence, Union

from . import _library as c
from ._errors import DomainError


class Order(NamedTuple):
    """The observed order of a table of step sizes and errors, and a verdict.

    Attributes
    ----------
    verdict : str
        ``'pass'``, ``'measured'``, ``'too-low'``, ``'drifting'``, ...: as ``scallop order`` prints it (docs/reference/order.md).
    passed : bool
        Whether the verdict is ``'pass'``.
    order, order_low, order_high : float
        The order and its interval; nan where there is none.
    interval : str
        What `order_low` and `order_high` are: ``'confidence-95'``, ``'slope-95'``, ``'limit'``, ``'pairwise'`` or ``'-'``.
    used : int
        Number of points behind the order.
    gci, asymptotic_ratio : float
        Grid convergence index of values, and the ratio that goes with it (ASME V&V 20).
    reason : str
        Why, in one line; row 1 is ``h[0]``.
    pairwise : list of float
        For each `h` the order to the next finer one; nan where there is none.
    uses : list of str
        For each `h` ``'used'``, or why it was left out.
    """

    verdict: str
    passed: bool
    order: float
    order_low: float
    order_high: float
    interval: str
    used: int
    gci: float
    asymptotic_ratio: float
    reason: str
    pairwise: list[float]
    uses: list[str]


def _floats(name: str, values: Iterable[float]) -> list[float]:
    if isinstance(values, (str, bytes)) or getattr(values, "ndim", 1) != 1:
        raise DomainError(f"{name}: a sequence of numbers is wanted, not {reprlib.repr(values)}")
    try:
        return [float(value) for value in values]
    except (TypeError, ValueError, OverflowError):
        raise DomainError(f"{name}: a sequence of numbers is wanted, not {reprlib.repr(values)}") from None


def _number(name: str, value: float) -> float:
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise DomainError(f"{name} = {value!r}: a number is wanted") from None


# An order: a number, or a text such as "3/2"
Expected = Union[float, str]


def _expected(name: str, value: Expected) -> float:
    if not isinstance(value, str):
        return _number(name, value)
    try:
        return float(Fraction(value))
    except (ValueError, ZeroDivisionError, OverflowError):
        raise DomainError(f"{name} = {value!r}: a number, or a fraction such as '3/2'") from None


def _wanted(expect: Expected | None, at_least: Expected | None, tol: float, values: bool) -> ctypes.Structure:
    if expect is not None and at_least is not None:
        raise DomainError("expect and at_least exclude each other")
    order = math.nan
    for name, value in (("expect", expect), ("at_least", at_least)):
        if value is not None:
            order = _expected(name, value)
            if not math.isfinite(order):
                raise DomainError(f"{name} = {value!r}: a finite number")
    tolerance = _number("tol", tol)
    if not 0 < tolerance < math.inf:
        raise DomainError(f"tol = {tol!r}: a finite number > 0")
    return c.OrderWanted(order, tolerance, at_least is not None, bool(values))


def order(h: Iterable[float], err: Iterable[float], expect: Expected | None = None, at_least: Expected | None = None,
          tol: float = 0.1, noise: float | Iterable[float] = 0, values: bool = False) -> Order:
    """Judge the order p of ``err ~ C h^p`` as h -> 0.

    Needs nothing but the C library: no NumPy.

    Parameters
    ----------
    h : sequence of float
        Step sizes > 0, in any order.
    err : sequence of float
        Errors; they may have signs.
    expect : float or str, optional
        The order that is expected, 1.5 or ``"3/2"``. Without it and `at_least` the order is measured, and nothing passes.
    at_least : float or str, optional
        The same, but a higher order passes, too.
    tol : float, optional
        How far the order may be off, and how wide its interval may be on either side.
    noise : float or sequence of float, optional
        The rounding error of `err`, where it is known.
    values : bool, optional
        `err` holds values and not errors: three refinements give one order (Richardson).

    Returns
    -------
    Order
        The order, its interval, and a verdict with its reason.

    Raises
    ------
    DomainError
        An argument is no sequence of numbers, or lengths differ. Numbers that no table of errors can have (nan,
        ``h <= 0``) are the verdict ``'invalid'`` instead.

    Examples
    --------
    >>> import crawling_scallop
    >>> found = crawling_scallop.order([0.1, 0.05, 0.025, 0.0125], [0.011, 0.0026, 6.3e-4, 1.57e-4], expect=2)
    >>> found.passed, found.reason
    (True, 'order 2.04 in rows 1 to 4')
    """
    wanted = _wanted(expect, at_least, tol, values)
    steps, errors = _floats("h", h), _floats("err", err)
    noises = _floats("noise", noise) if isinstance(noise, Iterable) else [_number("noise", noise)] * len(steps)
    count = len(steps)
    if len(errors) != count or len(noises) != count:
        raise DomainError("h and err: two sequences of one length")
    points = (c.OrderPoint * (count + 1))(*map(c.OrderPoint, steps, errors, noises, range(1, count + 1)))
    result, left, library = c.OrderResult(), ctypes.c_int(count), c.library()
    library.scallop_order(points, left, wanted, result)
    verdict = library.scallop_order_verdict_text(result.verdict).decode()
    pairwise, uses = [math.nan] * count, ["-"] * count
    for point in points[:left.value if verdict != "invalid" else 0]:
        pairwise[point.row - 1] = point.pairwise
        uses[point.row - 1] = library.scallop_order_use_text(point.use).decode()
    return Order(verdict, verdict == "pass", result.order, result.low, result.high,
                 library.scallop_order_interval_text(result.interval).decode(), result.used, result.gci,
                 result.asymptotic_ratio, result.reason.decode(), pairwise, uses)


def _series_of(h: Any, errors: Any) -> tuple[Any, dict[str, Any]]:
    """The step sizes, and the errors by their names"""
    if hasattr(errors, "items"):  # a mapping, or a frame of pandas
        named = {str(name): list(values) for name, values in errors.items()}
        if not isinstance(h, str):
            return h, named
        if h not in named:
            raise DomainError(f"h = {h!r}: there is no such column among {', '.join(named)}")
        return named.pop(h), named
    rows = [list(row) for row in errors]
    if len({len(row) for row in rows}) > 1:
        raise DomainError("errors: its rows have different lengths")
    return h, {str(i): list(column) for i, column in enumerate(zip(*rows))}


def orders(h: Iterable[float] | str, errors: Any,
           expect: Expected | Sequence[Expected] | Mapping[str, Expected] | None = None,
           **options: Any) -> dict[str, Order]:
    """Judge the order of each column of a table, as `order` does.

    Parameters
    ----------
    h : sequence of float or str
        Step sizes; of a mapping or a frame it may be the name of their column.
    errors : array of two dimensions, mapping, or pandas.DataFrame
        A column for each series: of an array a row for each `h`, whose columns are called ``'0'``, ``'1'``, ...
        Rows in which a series has None or a nan of a frame are invalid in this series, not left out.
    expect : float, str, sequence or mapping, optional
        The order of all columns, of each in turn, or by name: a column that is not named there is only measured.
    **options
        As in `order`.

    Returns
    -------
    dict of Order

    Examples
    --------
    >>> import crawling_scallop
    >>> found = crawling_scallop.orders("h", {"h": [1, 0.5, 0.25], "L2": [1, 0.25, 0.0625], "H1": [1, 0.5, 0.25]},
    ...                                 expect={"L2": 2, "H1": "2/2"})
    >>> all(one.passed for one in found.values())
    True
    """
    steps, named = _series_of(h, errors)
    steps = _floats("h", steps)
    wanted: Mapping[str, Expected | None]
    if isinstance(expect, Mapping):
        unknown = [name for name in expect if name not in named]
        if unknown:
            raise DomainError(f"expect: there is no column {unknown[0]!r} among {', '.join(named)}")
        wanted = expect
    elif isinstance(expect, Sequence) and not isinstance(expect, str):
        if len(expect) != len(named):
            raise DomainError(f"expect: {len(expect)} orders for {len(named)} columns")
        wanted = dict(zip(named, expect))
    else:
        wanted = {name: expect for name in named}
    return {name: order(steps, [math.nan if x is None else x for x in err], expect=wanted.get(name), **options)
            for name, err in named.items()}
