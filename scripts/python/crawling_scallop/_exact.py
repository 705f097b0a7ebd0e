"""Fractions and proven digits: crawlers with exact parameters, derived series, certified motion, formulas in balls.

Through libscallop only, built with FLINT; numbers of FLINT are passed by FLINT's own functions, which the loader finds
with libscallop."""

from __future__ import annotations

import ctypes
import decimal
import fractions
import importlib
import numbers
import re
import reprlib
from typing import Any, Callable, Dict, Iterator, Mapping, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._arrays import Floats
from ._errors import DomainError, UnsolvedError
from ._gaits import OneGait, address_of, made
from ._motion import kind_of, modes_text

Exact = Union[int, float, str, fractions.Fraction, decimal.Decimal]

QUANTITIES = {  # of a motion: names, and the words of SCALLOP_QUANTITY_LIST
    "extension": dict(t1="t1", dT="dT", v_end="v_end", dx1="rear_at_end", dx2="front_at_end", dxC="dxC"),
    "contraction": dict(t1="t1", dT="dT", v_end="v_end", dx1="front_at_end", dx2="rear_at_end", dxC="dxC"),
    "steady": {name: name for name in ("v_start", "v_mid", "displacement", "mean_velocity", "friction_work")},
}
MOST_TERMS = 1000  # SCALLOP_MOST_TERMS
SPARE_DIGITS = 2  # printed by FLINT beyond those that are asked for


class Ball(NamedTuple):
    """A number that is proven to lie within `radius` of `middle`.

    Attributes
    ----------
    middle, radius : decimal.Decimal
        Exactly; ``float(ball)`` is that of the middle.

    Examples
    --------
    >>> from decimal import Decimal
    >>> import crawling_scallop
    >>> third = crawling_scallop.Ball(Decimal("0.33333"), Decimal("4e-6"))
    >>> str(third), third.digits()
    ('0.33333 +/- 0.000004', '0.33333')
    """

    middle: decimal.Decimal
    radius: decimal.Decimal

    def __float__(self) -> float:
        return float(self.middle)

    def __str__(self) -> str:
        return f"{self.middle} +/- {self.radius}"

    def _ends(self) -> tuple[fractions.Fraction, fractions.Fraction]:
        middle, radius = fractions.Fraction(self.middle), fractions.Fraction(self.radius)
        return middle - radius, middle + radius

    def digits(self) -> str:
        """The decimal with the most digits to which every number of the ball rounds.

        Returns
        -------
        str
            ``'0'`` where there is none, because the ball contains 0 or is wider than its middle.
        """
        low, high = self._ends()
        for count in range(len(self.middle.as_tuple().digits), 0, -1):
            rounded = {decimal.Context(prec=count).divide(decimal.Decimal(end.numerator), decimal.Decimal(end.denominator))
                       for end in (low, high)}
            if len(rounded) == 1:
                return str(rounded.pop())
        return "0"

    def mpf(self) -> Any:
        """The middle as a number of mpmath, rounded to its working precision.

        Returns
        -------
        mpmath.mpf
        """
        mpmath = importlib.import_module("mpmath")  # which is wanted here alone
        return mpmath.mpf(str(self.middle))

    def mpi(self) -> Any:
        """The ball as an interval of mpmath, rounded outwards to its working precision.

        Returns
        -------
        mpmath.iv.mpf
        """
        mpmath = importlib.import_module("mpmath")  # which is wanted here alone
        low, high = (mpmath.iv.mpf(end.numerator) / mpmath.iv.mpf(end.denominator) for end in self._ends())
        return mpmath.iv.mpf([low.a, high.b])


class Terms(Dict[int, Union[fractions.Fraction, Ball]]):
    """The terms of a series in T: ``{power: coefficient}``, without those that are 0.

    A coefficient is a :class:`fractions.Fraction` where it is exact, else a :class:`Ball`. ``terms[power]`` is 0 for every
    other power below ``terms.order``; ``terms(T)`` is the sum of all terms, in double and for arrays of T too.
    """

    def __init__(self, order: int, coefficients: Mapping[int, Union[fractions.Fraction, Ball]]) -> None:
        super().__init__(coefficients)
        self.order = order

    def __missing__(self, power: Any) -> fractions.Fraction:
        if isinstance(power, numbers.Integral) and int(power) < self.order:
            return fractions.Fraction(0)
        raise KeyError(f"Terms below T^{self.order} are known, not {power!r}")

    def __call__(self, T: npt.ArrayLike) -> Floats:
        times = np.asarray(T, float)
        total: Floats = sum((float(a) * times ** float(power) for power, a in self.items()), np.zeros(times.shape))[()]
        return total

    def __repr__(self) -> str:
        return f"<{' + '.join(f'({a}) T^{power}' for power, a in self.items()) or '0'} + O(T^{self.order})>"


class Series:
    """The derived series of a motion, made by :func:`series`.

    Attributes
    ----------
    motion : str
        ``'steady'``, ``'extension'`` or ``'contraction'``.
    modes : str
        The sequence of modes for which the series is.
    v_start, v_mid, displacement, mean_velocity, friction_work : Terms
        Of the steady state, in powers of the period.
    t1, dT, v_end, dx1, dx2, dxC : Terms
        Of a phase, in powers of its duration.
    """

    def __init__(self, motion: str, modes: str, terms: Mapping[str, Terms]) -> None:
        self.motion, self.modes = motion, modes
        self.__dict__.update(terms)

    def __getattr__(self, name: str) -> Terms:
        raise AttributeError(f"the series of {self.__dict__.get('motion')!r} has no {name!r}")

    def __repr__(self) -> str:
        return "\n".join([f"Series of {self.motion!r}, modes {self.modes}",
                          *(f"{name} = {value!r}" for name, value in vars(self).items() if isinstance(value, Terms))])


LARGEST_EXPONENT = 100000  # as in model/exact/ball.c: a fraction has all digits of 10^exponent


def _exponent(value: Any) -> int:
    if isinstance(value, decimal.Decimal):
        return value.adjusted() if value.is_finite() else 0
    found = re.search(r"[eE]([+-]?[0-9]+)\s*$", value) if isinstance(value, str) else None
    return int(found[1]) if found and len(found[1]) < 20 else LARGEST_EXPONENT + 1 if found else 0


def fraction(name: str, value: Any) -> fractions.Fraction:
    """The number as it is written: 0.1, a float that Python prints so, is 1/10. NumPy's numbers likewise."""
    if abs(_exponent(value)) > LARGEST_EXPONENT:
        raise DomainError(f"{name} = {reprlib.repr(value)}: the exponent is beyond {LARGEST_EXPONENT}")
    try:
        if isinstance(value, (str, numbers.Rational, decimal.Decimal)) and not isinstance(value, bool):
            return fractions.Fraction(value)
        if isinstance(value, numbers.Real) or isinstance(value, np.ndarray) and value.shape == ():
            return fractions.Fraction(repr(float(value)))
    except (ValueError, OverflowError, ZeroDivisionError):
        pass
    raise DomainError(f"{name}: a finite number is wanted, not {reprlib.repr(value)}")


def whole(name: str, value: Any, most: int) -> int:
    if isinstance(value, bool) or not isinstance(value, numbers.Integral) or not 1 <= int(value) <= most:
        raise DomainError(f"{name} = {value!r}: a whole number from 1 to {most}")
    return int(value)


class _Exact:
    """A struct scallop_rational_crawler and a v0 of FLINT, for as long as a `with` lasts."""

    def __init__(self, library: ctypes.CDLL, parameters: Mapping[str, Any], v0: Any, gait: int) -> None:
        self.library = c.proven(library)
        exact = {name: fraction(name, value) for name, value in parameters.items()}
        for name, value in exact.items():
            if value <= 0 or name == "alpha" and value >= 1:
                allowed = "a number between 0 and 1, both excluded" if name == "alpha" else "a finite number > 0"
                raise DomainError(f"{name} = {parameters[name]!r}: {allowed}")
        self.numbers = [*exact.values(), fraction("v0", v0)]
        self.gait = gait

    def __enter__(self) -> _Exact:
        self.crawler, self.v0 = c.RationalCrawler(), c.Fmpq()
        self.library.scallop_rational_init(self.crawler)
        self.library.fmpq_init(self.v0)
        self.crawler.gait = self.gait
        places = [getattr(self.crawler, name) for name in c.PARAMETERS] + [self.v0]
        for place, number in zip(places, self.numbers):
            self.library.fmpq_set_str(place, str(number).encode(), 10)
        return self

    def __exit__(self, *_: Any) -> None:
        self.library.scallop_rational_clear(self.crawler)
        self.library.fmpq_clear(self.v0)


def _text(library: ctypes.CDLL, pointer: int) -> str:
    """Of a text that FLINT made, which is then freed"""
    text = ctypes.string_at(pointer).decode()
    library.flint_free(pointer)
    return text


def _ball_of(library: ctypes.CDLL, arb: Any, digits: int) -> Optional[Ball]:
    """None: not finite"""
    text = _text(library, library.arb_get_str(arb, digits + SPARE_DIGITS, 0))
    parts = re.fullmatch(r"\[?(-?[\d.e+-]+)?(?: ?\+/- ([\d.e+-]+)\])?", text)  # "0.5", "[0.33 +/- 4e-3]", "[+/- 0.1]"
    return Ball(decimal.Decimal(parts[1] or 0), decimal.Decimal(parts[2] or 0)) if parts else None


def _ball(library: ctypes.CDLL, set_ball: Callable[[Any], Any], digits: int) -> Optional[Ball]:
    """The Ball that set_ball(arb) sets; None: not finite."""
    arb = c.Arb()
    library.arb_init(arb)
    set_ball(arb)
    ball = _ball_of(library, arb, digits)
    library.arb_clear(arb)
    return ball


def _is_sharp(ball: Ball, digits: int) -> bool:
    """Is the ball as small as the digits take, or is it around 0?"""
    size = abs(fractions.Fraction(ball.middle))
    radius = fractions.Fraction(ball.radius)
    return radius * 10**digits <= size or radius >= size


def _precisions(digits: int) -> Iterator[int]:
    """Bits to try, one after the other"""
    first = 64 + 4 * digits
    return (first << doubled for doubled in range(8))


def _coefficient(library: ctypes.CDLL, handle: Any, quantity: int, power: int,
                 digits: int) -> Union[fractions.Fraction, Ball, None]:
    number = c.Fmpq()
    library.fmpq_init(number)
    is_exact = library.scallop_series_rational(number, handle, quantity, power)
    text = _text(library, library.fmpq_get_str(None, 10, number)) if is_exact else ""
    library.fmpq_clear(number)
    if is_exact:
        return fractions.Fraction(text)
    return _ball(library, lambda arb: library.scallop_series_ball(arb, handle, quantity, power), digits)


def _terms(library: ctypes.CDLL, handle: Any, quantity: int, order: int, digits: int) -> Terms:
    first = library.scallop_series_first(handle, quantity)
    every = {power: _coefficient(library, handle, quantity, power, digits) for power in range(first, order)}
    return Terms(order, {power: a for power, a in every.items() if a is not None and a != 0})


def _derive(exact: _Exact, motion: str, order: int, precision: int) -> tuple[Any, str]:
    """The handle of a series, or None and why there is none, for this precision."""
    handle, why, library = ctypes.c_void_p(), ctypes.c_char_p(), exact.library
    if motion == "steady":
        status = library.scallop_series_of_steady(handle, exact.crawler, order, precision, why)
    else:
        status = library.scallop_series_of_phase(handle, exact.crawler, c.KINDS[motion], exact.v0, order, precision, why)
    if status == c.OUTSIDE:
        raise DomainError((why.value or b"no series").decode())
    return (handle, "") if status == 0 else (None, why.value.decode() if why.value else c.status_text(status))


def series(motion: str = "steady", v0: Exact = 0, order: int = 8, digits: int = 17, m1: Exact = 1, m2: Exact = 1,
           F1: Exact = 4, F2: Exact = 1, L: Exact = 10, alpha: Exact = 0.75, gait: OneGait = "quadratic") -> Series:
    """Derive the series that follow from the equations of motion, all terms below ``T^order``. Needs libscallop with FLINT.

    Parameters
    ----------
    motion : {'steady', 'extension', 'contraction'}
        The steady state, in powers of the period, or a phase, in powers of its duration.
    v0 : exact number
        Velocity of both bodies at the start of a phase.
    order : int
        From 1 to 1000.
    digits : int
        Where a coefficient is no fraction, the relative radius of its :class:`Ball` is at most ``10**-digits``.
    m1, m2, F1, F2, L, alpha : exact number
        An int, a Fraction, a Decimal, a text such as ``'0.7'`` or ``'1/3'``, or a float, which stands for the decimal that
        Python prints: 0.7 is 7/10.
    gait : str or Gait
        As for :func:`steady`; the numbers of a :class:`Gait` are the doubles that they are.

    Returns
    -------
    Series
        Each quantity a :class:`Terms`. `t1` and `dT` are nothing but 0 where the mode does not change.

    Raises
    ------
    DomainError
        A parameter is outside its domain, or the gait has no series in T.
    UnsolvedError
        The limit T -> 0 is not decided.

    Examples
    --------
    >>> import crawling_scallop
    >>> crawling_scallop.series().displacement
    <(120/37) T^0 + (-711/350464) T^4 + O(T^8)>
    >>> crawling_scallop.series().displacement[4]
    Fraction(-711, 350464)
    """
    if not isinstance(motion, str) or motion not in QUANTITIES:
        raise DomainError(f"motion = {motion!r}: 'steady', 'extension' or 'contraction'")
    order, digits = whole("order", order, MOST_TERMS), whole("digits", digits, 1000)
    one, why = made(gait), ""
    parameters = dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=1, alpha=alpha)
    with _Exact(c.library(), parameters, v0, address_of(one)) as exact:
        words = c.words(exact.library, "scallop_quantity_words", c.QUANTITIES)
        for precision in _precisions(digits):
            handle, why = _derive(exact, motion, order, precision)
            if not handle:
                continue
            modes = exact.library.scallop_series_modes(handle).decode()
            terms = {name: _terms(exact.library, handle, words.index(word), order, digits)
                     for name, word in QUANTITIES[motion].items()}
            exact.library.scallop_series_free(handle)
            balls = [a for each in terms.values() for a in each.values() if isinstance(a, Ball)]
            if all(_is_sharp(ball, digits) for ball in balls):
                return Series(motion, modes, terms)
    raise UnsolvedError(why or f"the coefficients do not have {digits} digits", c.status_text(c.UNDECIDED))


def enclosed(library: ctypes.CDLL, read: Any, kind: int, v0: Any, digits: Any, parameters: Mapping[str, Any],
             gait: int) -> Ball:
    """The Ball of a formula that this library has read (see Formula.ball)."""
    digits, ball = whole("digits", digits, 1000), None
    with _Exact(library, parameters, v0, gait) as exact:
        for precision in _precisions(digits):
            status: list[int] = []
            ball = _ball(exact.library, lambda arb: status.append(exact.library.scallop_formula_ball(
                arb, read, exact.crawler, kind, exact.v0, None, precision)), digits)
            if status[0] < 0:
                raise DomainError("the gait has no exact law")
            if ball is not None and (ball.radius == 0 or _is_sharp(ball, digits) and ball.radius < abs(ball.middle)):
                break
    if ball is None:
        raise UnsolvedError("the formula has no finite value here, or none that is proven", c.status_text(c.UNDECIDED))
    return ball


class Certified:
    """Proven digits of a motion, made by :func:`certified`.

    Attributes
    ----------
    motion, regime, modes : str
        The motion in words.
    froude, v_start, v_mid, displacement, mean_velocity, multiplier, friction_work : Ball
        Of the steady state.
    t1, dT, v_end, dx1, dx2, dxC, multiplier : Ball
        Of a phase. `t1` and `dT` are missing where the mode does not change.
    """

    def __init__(self, motion: str, regime: str, modes: str, balls: Mapping[str, Ball]) -> None:
        self.motion, self.regime, self.modes = motion, regime, modes
        self.__dict__.update(balls)

    def __getattr__(self, name: str) -> Ball:
        raise AttributeError(f"this motion, {self.__dict__.get('motion')!r}, has no {name!r}")

    def __repr__(self) -> str:
        return f"<Certified {', '.join(f'{name}={value}' for name, value in vars(self).items())}>"


def _certify(exact: _Exact, motion: str, digits: int) -> Certified:
    library, why = exact.library, ctypes.c_char_p()
    if motion == "steady":
        found, name = c.CertifiedSteady(), "steady"
        names = (*c.STEADY_ERRORS, "friction_work")
    else:
        found, name = c.CertifiedPhase(), "phase"
        names = (*c.PHASE_NUMBERS, "multiplier")
    getattr(library, f"scallop_certified_{name}_init")(found)
    try:
        if motion == "steady":
            status = library.scallop_certified_steady(exact.crawler, digits, found, why)
        else:
            status = library.scallop_certified_phase(exact.crawler, c.KINDS[motion], exact.v0, digits, found, why)
        if status < 0:
            said = c.status_text(status)
            reason = f"{said}: {why.value.decode()}" if why.value else said
            raise DomainError(reason) if status == c.OUTSIDE else UnsolvedError(reason, said)
        moves = motion == "steady" or found.switches
        balls = {each: _ball_of(library, getattr(found, each), digits)
                 for each in names if moves or each not in ("t1", "dT")}
        modes = modes_text(found.modes if motion == "steady" else [found.modes])
        regime = library.scallop_regime_text(found.regime).decode()
    finally:
        getattr(library, f"scallop_certified_{name}_clear")(found)
    return Certified(motion, regime, modes, {each: ball for each, ball in balls.items() if ball is not None})


def certified(motion: str = "steady", v0: Exact = 0, digits: int = 30, m1: Exact = 1, m2: Exact = 1, F1: Exact = 4,
              F2: Exact = 1, L: Exact = 10, T: Exact = 1, alpha: Exact = 0.75, gait: OneGait = "quadratic") -> Certified:
    """Solve one crawler with proven digits. Needs libscallop with FLINT.

    Parameters
    ----------
    motion : {'steady', 'extension', 'contraction'}
        The steady state, or a phase.
    v0 : exact number
        Velocity of both bodies at the start of a phase.
    digits : int
        Digits that are proven, from 1 to 100000.
    m1, m2, F1, F2, L, T, alpha : exact number
        As for :func:`series`.
    gait : str or Gait
        As for :func:`steady`; a gait with an exact law.

    Returns
    -------
    Certified
        Each quantity a :class:`Ball`: ``str(ball)``, ``ball.digits()``, ``ball.mpf()`` and ``ball.mpi()`` for mpmath.

    Raises
    ------
    DomainError
        A parameter is outside its domain, or the gait has no exact law.
    UnsolvedError
        No precision decides the motion: a body touches a boundary exactly.

    Examples
    --------
    >>> import crawling_scallop
    >>> crawling_scallop.certified(F1="10/3", digits=25).displacement.digits()
    '3.00914699911437524023292911'
    """
    if motion != "steady":
        kind_of(motion)
    digits, one = whole("digits", digits, c.MOST_DIGITS), made(gait)
    parameters = dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha)
    with _Exact(c.library(), parameters, v0, address_of(one)) as exact:
        return _certify(exact, motion, digits)
