"""Gaits made of numbers, and what the parameter `gait` takes."""

from __future__ import annotations

import ctypes
import functools
import itertools
import reprlib
from typing import Any, Dict, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._arrays import Array, column, spread
from ._errors import DomainError


class Gait:
    """A gait, made by :func:`gait_of` or its kin: a value for the parameter `gait`.

    Attributes
    ----------
    name : str
        What the option ``--gait`` of the command calls it.
    """

    __slots__ = ("name", "_bytes", "_memory")

    def __init__(self, name: str) -> None:
        self.name, self._bytes = name, name.encode()
        self._memory = ctypes.create_string_buffer(ctypes.c_size_t.in_dll(c.library(), "scallop_made_gait_size").value)

    def __repr__(self) -> str:
        return f"<Gait {self.name}>"

    def _address(self) -> int:
        return ctypes.addressof(self._memory)


OneGait = Union[str, Gait]
GaitLike = Union[str, Gait, Sequence[Any], npt.NDArray[Any]]


def _families() -> dict[str, Any]:
    entries = (c.library().scallop_gait_family(i) for i in itertools.count())
    return {entry[0].name.decode(): entry for entry in itertools.takewhile(bool, entries)}


def gaits() -> dict[str, tuple[str, str, str]]:
    """List the families of gaits.

    Returns
    -------
    dict
        ``{name: (numbers, usual, sentence)}``: the numbers that :func:`gait_of` takes, those that hold where none are
        given (``''`` where there are none), and what the gait is.
    """
    texts = {name: [(text or b"").decode() for text in (entry[0].numbers, entry[0].usual, entry[0].sentence)]
             for name, entry in _families().items()}
    return {name: (numbers, usual, sentence) for name, (numbers, usual, sentence) in texts.items()}


def gait_of(family: str, *numbers: float) -> Gait:
    """Make a gait of a family.

    Parameters
    ----------
    family : str
        One of those that :func:`gaits` lists.
    *numbers : float
        The numbers that ``--gait`` takes behind the name. Those of one phase hold for both, unless those of the
        contraction follow.

    Returns
    -------
    Gait
        A value for the parameter `gait`.

    Examples
    --------
    >>> import crawling_scallop
    >>> crawling_scallop.gait_of("skewed", 0.3)
    <Gait skewed:0.3>
    """
    known = {name: entry for name, entry in _families().items() if not entry[0].fixed}
    if family not in known:
        raise DomainError(f"family = {family!r}: {', '.join(known)}")
    row, given = known[family][0], [float(x) for x in column("numbers", numbers)]
    if len(given) == 2 * row.each and given[:row.each] == given[row.each:]:
        given = given[:row.each]
    gait, why = Gait(family + (":" + _numbers_text(given) if given else "")), ctypes.c_char_p()
    if given and not row.numbers or not given and not row.usual:
        raise DomainError(f"numbers = {given}: {(row.allowed or b'none').decode()}")
    given = given or [float(text) for text in row.usual.split(b",")]
    array = (ctypes.c_double * len(given))(*given)
    if c.library().scallop_make_gait(gait._memory, row, gait._bytes, array, len(given), why) < 0:
        raise DomainError(f"numbers = {given}: {(why.value or row.allowed).decode()}")
    return gait


def _numbers_text(numbers: Sequence[float]) -> str:
    return ",".join(repr(float(x))[:-2] if float(x).is_integer() and abs(x) < 1e15 else repr(float(x)) for x in numbers)


def _pair(name: str, value: npt.ArrayLike) -> list[float]:
    """A number for both phases, or one for the extension and one for the contraction."""
    numbers = column(name, value)
    if numbers.shape not in ((), (2,)):
        raise DomainError(f"{name}: one number, or two for extension and contraction, not {reprlib.repr(value)}")
    return [float(x) for x in np.broadcast_to(numbers, 2)]


def trapezoidal(up: npt.ArrayLike = 0.25, down: npt.ArrayLike = 0.25) -> Gait:
    """Make a gait whose speed rises for a fraction of each phase, stays, and falls.

    Parameters
    ----------
    up, down : float or pair of float
        The fractions in which the speed rises and falls; a pair is for extension and contraction.

    Returns
    -------
    Gait
        A value for the parameter `gait`.
    """
    ups, downs = _pair("up", up), _pair("down", down)
    return gait_of("trapezoidal", ups[0], downs[0], ups[1], downs[1])


def skewed(beta: npt.ArrayLike = 0.25) -> Gait:
    """Make a gait whose speed rises for a fraction `beta` of each phase and falls for the rest.

    Parameters
    ----------
    beta : float or pair of float
        The fraction; a pair is for extension and contraction.

    Returns
    -------
    Gait
        A value for the parameter `gait`.
    """
    return gait_of("skewed", *_pair("beta", beta))


def constant(ramp: npt.ArrayLike = 0) -> Gait:
    """Make a gait of constant speed, but for ramps at both ends of each phase.

    Parameters
    ----------
    ramp : float or pair of float
        The fraction of the phase that each ramp takes; a pair is for extension and contraction. With 0 the speed jumps,
        and steady states can fill an interval, `v_low` to `v_high`.

    Returns
    -------
    Gait
        A value for the parameter `gait`.
    """
    return gait_of("constant", *_pair("ramp", ramp))


def polynomial(coefficients: npt.ArrayLike) -> Gait:
    """Make a gait whose length is a polynomial in time.

    Parameters
    ----------
    coefficients : sequence of float
        C1, C2, ..., Cn with n from 3 to 16, such that l' = 0 at both ends of a phase.

    Returns
    -------
    Gait
        A value for the parameter `gait`.
    """
    numbers = column("coefficients", coefficients)
    if numbers.ndim != 1 or not 3 <= numbers.size <= c.MOST_NUMBERS:
        raise DomainError(f"coefficients: a sequence of 3 to {c.MOST_NUMBERS} numbers, not {reprlib.repr(coefficients)}")
    return gait_of("polynomial", *numbers.tolist())


def minimum_jerk() -> Gait:
    """Make the gait of minimum jerk.

    Returns
    -------
    Gait
        A value for the parameter `gait`.
    """
    return gait_of("minimum-jerk")


@functools.lru_cache(maxsize=64)
def _gait_of_text(text: str) -> Gait:
    """'skewed:0.3' as gait_of('skewed', 0.3), one of those made last where it is."""
    family, colon, numbers = text.partition(":")
    try:
        return gait_of(family, *(float(x) for x in numbers.split(",") if colon))
    except ValueError as error:
        raise DomainError(f"gait = {text!r}: {error}") from None


def made(gait: Any) -> Union[int, Gait]:
    """A gait, or what --gait calls one: its address, or the Gait to hold while the library reads it (address_of)."""
    if not isinstance(gait, (Gait, str)):
        raise _no_gait(gait)
    if isinstance(gait, Gait):
        return gait
    named: Union[int, None] = c.library().scallop_gait_named(gait.encode())
    if not named and gait.partition(":")[0] not in gaits():
        raise _no_gait(gait)
    return named or _gait_of_text(gait)


def address_of(gait: Union[int, Gait]) -> int:
    return gait._address() if isinstance(gait, Gait) else gait


def _no_gait(gait: Any) -> DomainError:
    return DomainError(f"gait = {reprlib.repr(gait)}: {', '.join(gaits())}, with numbers as in 'skewed:0.3', or a Gait")


class Columns(Dict[str, npt.NDArray[Any]]):
    """{name: array}, the gaits as addresses; and what keeps these valid."""

    made: Dict[Any, Union[int, Gait]]
    shape: tuple[int, ...]


def _addresses(gait: GaitLike) -> tuple[npt.NDArray[np.uintp], dict[Any, Union[int, Gait]]]:
    """The array of addresses, and what keeps them valid."""
    array = np.asarray(gait)
    listed = array.ravel().tolist()
    try:
        each_made = {each: made(each) for each in dict.fromkeys(listed)}
    except TypeError:  # unhashable
        raise _no_gait(gait) from None
    address = {each: address_of(one) for each, one in each_made.items()}
    return np.array([address[each] for each in listed], np.uintp).reshape(array.shape), each_made


def together(numbers: Mapping[str, npt.ArrayLike], gait: GaitLike) -> Columns:
    """The columns of numbers, {name: value}, and the gait, all in their common shape."""
    columns: dict[str, npt.NDArray[Any]] = {name: column(name, value) for name, value in numbers.items()}
    columns["gait"], kept = _addresses(gait)
    try:
        shape = np.broadcast(*columns.values()).shape
    except ValueError:
        shapes = ", ".join(f"{name} {each.shape}" for name, each in columns.items() if each.shape)
        raise DomainError(f"these do not broadcast together: {shapes}") from None
    result = Columns((name, spread(each, shape)) for name, each in columns.items())
    result.made, result.shape = kept, shape
    return result


__all__ = ["Array", "Columns", "Gait", "GaitLike", "OneGait", "address_of", "constant", "gait_of", "gaits", "made",
           "minimum_jerk", "polynomial", "skewed", "together", "trapezoidal"]
