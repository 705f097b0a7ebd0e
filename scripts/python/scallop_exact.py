"""Fractions and proven digits for scallop.py: crawlers with exact parameters, derived series, formulas in balls.

Through libscallop only, built with FLINT; numbers of FLINT are passed by FLINT's own functions, which the loader finds
with libscallop."""

import ctypes
import decimal
import fractions
import numbers
import re
import reprlib
import typing

import numpy

import scallop_library as c

QUANTITIES = {  # of a motion: names, and the words of SCALLOP_QUANTITY_LIST
    "extension": dict(t1="t1", dT="dT", v_end="v_end", dx1="rear_at_end", dx2="front_at_end", dxC="dxC"),
    "contraction": dict(t1="t1", dT="dT", v_end="v_end", dx1="front_at_end", dx2="rear_at_end", dxC="dxC"),
    "steady": {name: name for name in ("v_start", "v_mid", "displacement", "mean_velocity", "friction_work")},
}
MOST_TERMS = 1000  # SCALLOP_MOST_TERMS
SPARE_DIGITS = 2  # printed by FLINT beyond those that are asked for


class Ball(typing.NamedTuple):
    """A number that is proven to lie within radius of middle; both are decimal.Decimal, exactly. float(ball) is that of
    the middle."""

    middle: decimal.Decimal
    radius: decimal.Decimal

    def __float__(self):
        return float(self.middle)

    def __str__(self):
        return f"{self.middle} +/- {self.radius}"


class Terms(dict):
    """{power: coefficient} of a series in T, without those that are 0: fractions.Fraction where the coefficient is exact,
    else a Ball. terms[power] is 0 for every other power below terms.order, and terms(T) is the sum of all terms, in double
    and for arrays of T too."""

    def __init__(self, order, coefficients):
        super().__init__(coefficients)
        self.order = order

    def __missing__(self, power):
        if isinstance(power, numbers.Integral) and power < self.order:
            return fractions.Fraction(0)
        raise KeyError(f"{power!r}: the terms below T^{self.order} are known")

    def __call__(self, T):
        T = numpy.asarray(T, float)
        return sum((float(a) * T ** float(power) for power, a in self.items()), numpy.zeros(T.shape))[()]

    def __repr__(self):
        return f"<{' + '.join(f'({a}) T^{power}' for power, a in self.items()) or '0'} + O(T^{self.order})>"


class Series:
    """The derived series of a motion, each quantity a Terms: in powers of the period for 'steady', of the duration of the
    phase for 'extension' and 'contraction'. modes: the sequence for which the series is."""

    def __init__(self, motion, modes, terms):
        self.motion, self.modes = motion, modes
        self.__dict__.update(terms)

    def __repr__(self):
        return "\n".join([f"Series of {self.motion!r}, modes {self.modes}",
                          *(f"{name} = {value!r}" for name, value in vars(self).items() if isinstance(value, Terms))])


LARGEST_EXPONENT = 100000  # as in model/exact/ball.c: a fraction has all digits of 10^exponent


def _exponent(value):
    if isinstance(value, decimal.Decimal):
        return value.adjusted() if value.is_finite() else 0
    found = re.search(r"[eE]([+-]?[0-9]+)\s*$", value) if isinstance(value, str) else None
    return int(found[1]) if found and len(found[1]) < 20 else LARGEST_EXPONENT + 1 if found else 0


def fraction(name, value):
    """The number as it is written: 0.1, a float that Python prints so, is 1/10. NumPy's numbers likewise."""
    if abs(_exponent(value)) > LARGEST_EXPONENT:
        raise ValueError(f"{name} = {reprlib.repr(value)}: the exponent is beyond {LARGEST_EXPONENT}")
    try:
        if isinstance(value, (str, numbers.Rational, decimal.Decimal)) and not isinstance(value, bool):
            return fractions.Fraction(value)
        if isinstance(value, numbers.Real) or isinstance(value, numpy.ndarray) and value.shape == ():
            return fractions.Fraction(repr(float(value)))
    except (ValueError, OverflowError, ZeroDivisionError):
        pass
    raise ValueError(f"{name}: a finite number is wanted, not {reprlib.repr(value)}")


def whole(name, value, most):
    if isinstance(value, bool) or not isinstance(value, numbers.Integral) or not 1 <= value <= most:
        raise ValueError(f"{name} = {value!r}: a whole number from 1 to {most}")
    return int(value)


class _Exact:
    """A struct scallop_rational_crawler and a v0 of FLINT, for as long as a `with` lasts."""

    def __init__(self, library, parameters, v0, gait):
        self.library = c.proven(library)
        exact = {name: fraction(name, value) for name, value in parameters.items()}
        for name, value in exact.items():
            if value <= 0 or name == "alpha" and value >= 1:
                allowed = "a number between 0 and 1, both excluded" if name == "alpha" else "a finite number > 0"
                raise ValueError(f"{name} = {parameters[name]!r}: {allowed}")
        self.numbers = [*exact.values(), fraction("v0", v0)]
        self.gait = gait

    def __enter__(self):
        self.crawler, self.v0 = c.RationalCrawler(), c.Fmpq()
        self.library.scallop_rational_init(self.crawler)
        self.library.fmpq_init(self.v0)
        self.crawler.gait = self.gait
        places = [getattr(self.crawler, name) for name in c.PARAMETERS] + [self.v0]
        for place, number in zip(places, self.numbers):
            self.library.fmpq_set_str(place, str(number).encode(), 10)
        return self

    def __exit__(self, *_):
        self.library.scallop_rational_clear(self.crawler)
        self.library.fmpq_clear(self.v0)


def _text(library, pointer):
    """Of a text that FLINT made, which is then freed"""
    text = ctypes.string_at(pointer).decode()
    library.flint_free(pointer)
    return text


def _ball(library, set_ball, digits):
    """The Ball that set_ball(arb) sets; None: not finite."""
    arb = c.Arb()
    library.arb_init(arb)
    set_ball(arb)
    text = _text(library, library.arb_get_str(arb, digits + SPARE_DIGITS, 0))
    library.arb_clear(arb)
    parts = re.fullmatch(r"\[?(-?[\d.e+-]+)?(?: ?\+/- ([\d.e+-]+)\])?", text)  # "0.5", "[0.33 +/- 4e-3]", "[+/- 0.1]"
    return Ball(decimal.Decimal(parts[1] or 0), decimal.Decimal(parts[2] or 0)) if parts else None


def _is_sharp(ball, digits):
    """Is the ball as small as the digits take, or is it around 0?"""
    size = abs(fractions.Fraction(ball.middle))
    radius = fractions.Fraction(ball.radius)
    return radius * 10**digits <= size or radius >= size


def _precisions(digits):
    """Bits to try, one after the other"""
    first = 64 + 4 * digits
    return (first << doubled for doubled in range(8))


def _coefficient(library, handle, quantity, power, digits):
    number = c.Fmpq()
    library.fmpq_init(number)
    is_exact = library.scallop_series_rational(number, handle, quantity, power)
    text = _text(library, library.fmpq_get_str(None, 10, number)) if is_exact else None
    library.fmpq_clear(number)
    if is_exact:
        return fractions.Fraction(text)
    return _ball(library, lambda arb: library.scallop_series_ball(arb, handle, quantity, power), digits)


def _terms(library, handle, quantity, order, digits):
    first = library.scallop_series_first(handle, quantity)
    every = {power: _coefficient(library, handle, quantity, power, digits) for power in range(first, order)}
    return Terms(order, {power: a for power, a in every.items() if a != 0})


def _derive(exact, motion, order, precision):
    """The handle of a series, or None and why there is none, for this precision."""
    handle, why, library = ctypes.c_void_p(), ctypes.c_char_p(), exact.library
    if motion == "steady":
        status = library.scallop_series_of_steady(handle, exact.crawler, order, precision, why)
    else:
        status = library.scallop_series_of_phase(handle, exact.crawler, c.KINDS[motion], exact.v0, order, precision, why)
    if status == c.DOMAIN:
        raise ValueError((why.value or b"no series").decode())
    return (handle, None) if status == 0 else (None, (why.value or library.scallop_status_text(status)).decode())


def series(motion, v0, order, digits, parameters, gait):
    """See scallop.series()."""
    if not isinstance(motion, str) or motion not in QUANTITIES:
        raise ValueError(f"motion = {motion!r}: 'steady', 'extension' or 'contraction'")
    order, digits = whole("order", order, MOST_TERMS), whole("digits", digits, 1000)
    with _Exact(c.library(), parameters, v0, gait) as exact:
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
    raise ArithmeticError(why or f"the coefficients do not have {digits} digits")


def enclosed(library, read, kind, v0, digits, parameters, gait):
    """The Ball of a formula that this library has read (see scallop.Formula.ball)."""
    digits = whole("digits", digits, 1000)
    with _Exact(library, parameters, v0, gait) as exact:
        for precision in _precisions(digits):
            status = []
            ball = _ball(exact.library, lambda arb: status.append(exact.library.scallop_formula_ball(
                arb, read, exact.crawler, kind, exact.v0, None, precision)), digits)
            if status[0] < 0:
                raise ValueError("the gait has no exact law")
            if ball is not None and (ball.radius == 0 or _is_sharp(ball, digits) and ball.radius < abs(ball.middle)):
                break
    if ball is None:
        raise ArithmeticError("the formula has no finite value here, or none that is proven")
    return ball
