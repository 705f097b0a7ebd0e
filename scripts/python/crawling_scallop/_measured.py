"""Gaits from recordings, and how far an answer from one may be off."""

from __future__ import annotations

import ctypes
import functools
import math
import weakref
from typing import Any, Callable, Generic, NamedTuple, Optional, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._arrays import Array, Floats, column
from ._errors import DomainError
from ._gaits import Gait
from ._motion import Phase, Steady, phase, steady

_Solved = TypeVar("_Solved", Steady, Phase)


class OtherGait(Gait):
    """One of the gaits of a :class:`Measured`, which it keeps alive; `L`, `T` and `alpha` are its own."""

    __slots__ = ("L", "T", "alpha", "_pointer", "_of")

    def __init__(self, view: Any, of: Optional[Measured] = None) -> None:
        self.name, self._of, self._pointer = "measured", of, int(view.gait)
        self.L, self.T, self.alpha = float(view.L), float(view.T), float(view.alpha)

    def _address(self) -> int:
        return self._pointer


class Estimate(Generic[_Solved]):
    """What a measured gait answers.

    Attributes
    ----------
    value : Steady or Phase
        The answer for the chosen curve.
    low, high : dict
        For each quantity the numbers between which the truth lies for some 95 of 100 recordings, as far as noise and gaps
        between samples are concerned.
    """

    def __init__(self, value: _Solved, low: dict[str, Floats], high: dict[str, Floats]) -> None:
        self.value: _Solved = value
        self.low, self.high = low, high

    def __repr__(self) -> str:
        return f"Estimate(value={self.value!r}, low={self.low!r}, high={self.high!r})"


class Measured(OtherGait):
    """A gait through a recording, made by :func:`measured`: a value for the parameter `gait`.

    Attributes
    ----------
    L, T, alpha : float
        Those of the recording.
    text : str
        How the recording was understood, and what was laid through it.
    """

    __slots__ = ("text", "_others", "_handle", "_library", "__weakref__")

    def __init__(self, handle: int, library: ctypes.CDLL) -> None:
        self._handle, self._library = handle, library
        self._others: Optional[list[Optional[OtherGait]]] = None
        weakref.finalize(self, library.scallop_measured_free, handle)
        super().__init__(library.scallop_measured_gait(handle, -1))
        text = ctypes.create_string_buffer(400)
        library.scallop_measured_text(handle, text, len(text))
        self.text = text.value.decode()

    def at(self, t: npt.ArrayLike) -> Floats:
        """The length of the curve at times `t`, in the units and from the origin of the recording.

        Parameters
        ----------
        t : array_like of float
            Times.

        Returns
        -------
        float or ndarray
        """
        times = column("t", t)
        values = [self._library.scallop_measured_length(self._handle, x) for x in times.ravel().tolist()]
        found: Floats = np.array(values, float).reshape(times.shape)[()]
        return found

    @property
    def samples(self) -> tuple[Array, Array]:
        """t and l of the samples within one period that the curve was laid through."""
        count = self._library.scallop_measured_samples(self._handle, None, None)
        table = np.empty((2, count))
        self._library.scallop_measured_samples(self._handle, table[0].ctypes.data, table[1].ctypes.data)
        return table[0], table[1]

    @property
    def others(self) -> list[Optional[OtherGait]]:
        """The other gaits that the recording admits as well, at most 17, and None where there is none."""
        if self._others is None:
            views = [self._library.scallop_measured_gait(self._handle, i) for i in range(c.OTHERS)]
            self._others = [OtherGait(view, self) if view.gait else None for view in views]
        return self._others

    def steady(self, **parameters: Any) -> Estimate[Steady]:
        """The steady state with this gait.

        Parameters
        ----------
        **parameters
            Those of :func:`steady` but `gait`. `L`, `T` and `alpha` are those of the recording where they are not given.

        Returns
        -------
        Estimate
            Of a :class:`Steady`.
        """
        return self._estimate(steady, c.STEADY_NUMBERS, parameters)

    def phase(self, kind: str, **parameters: Any) -> Estimate[Phase]:
        """One phase with this gait.

        Parameters
        ----------
        kind : {'extension', 'contraction'}
            The phase.
        **parameters
            Those of :func:`phase` but `gait`, as for :meth:`steady`.

        Returns
        -------
        Estimate
            Of a :class:`Phase`.
        """
        return self._estimate(functools.partial(phase, kind), c.PHASE_NUMBERS, parameters)

    def _estimate(self, solve: Callable[..., _Solved], names: tuple[str, ...], parameters: dict[str, Any]) -> Estimate[_Solved]:
        def solved(gait: OtherGait) -> _Solved:
            return solve(gait=gait, **{"L": gait.L, "T": gait.T, "alpha": gait.alpha, **parameters})

        value = solved(self)
        others = [solved(gait) if gait else None for gait in self.others]
        low, high = {}, {}
        for name in names:
            best = np.asarray(getattr(value, name))
            each = np.array([best * math.nan if other is None else getattr(other, name) for other in others])
            rows = zip(best.ravel().tolist(), each.reshape(c.OTHERS, -1).T)
            error = np.array([self._library.scallop_measured_error(x, (ctypes.c_double * c.OTHERS)(*row)) for x, row in rows],
                             float).reshape(best.shape)
            low[name], high[name] = (best - error)[()], (best + error)[()]
        return Estimate(value, low, high)


def measured(t: npt.ArrayLike, l: npt.ArrayLike, fit: str = "chosen", sigma: Union[float, int] = 0,
             period: Union[float, int] = 0) -> Measured:
    """Make a gait from a recording.

    Parameters
    ----------
    t, l : array_like of float
        Times and lengths, in any order, of one period or of several; rows with nan are left out.
    fit : {'chosen', 'monotone', 'cubic', 'smooth', 'phases'}
        ``'monotone'`` and ``'cubic'`` pass through every sample; ``'smooth'`` and ``'phases'`` are least-squares splines,
        in ``'phases'`` with jumps of the acceleration where l turns. ``'chosen'`` is the one of the last three whose error
        at unseen samples is estimated to be least.
    sigma : float, optional
        The noise of a sample; 0: it is estimated.
    period : float, optional
        The period; 0: it is found.

    Returns
    -------
    Measured
        A value for the parameter `gait`; its own `steady` and `phase` say how far an answer may be off.

    Raises
    ------
    DomainError
        The recording is no gait: the message says why.

    Examples
    --------
    >>> import numpy, crawling_scallop
    >>> t = numpy.linspace(0, 2, 60, endpoint=False)
    >>> gait = crawling_scallop.measured(t, 3 - 2 * numpy.cos(numpy.pi * t))
    >>> round(gait.L, 3), round(gait.T, 3)
    (4.0, 2.0)
    >>> answer = gait.steady(F1=3)
    >>> bool(answer.low["displacement"] < answer.value.displacement < answer.high["displacement"])
    True
    """
    times, lengths = column("t", t), column("l", l)
    if times.ndim != 1 or times.shape != lengths.shape:
        raise DomainError(f"t and l: two arrays of one length are wanted, not shapes {times.shape} and {lengths.shape}")
    fits = c.words(c.library(), "scallop_fit_names", c.FITS)
    if fit not in fits:
        raise DomainError(f"fit = {fit!r}: one of {', '.join(fits)}")
    for name, value in (("sigma", sigma), ("period", period)):
        if not (column(name, value).shape == () and 0 <= value < math.inf):
            raise DomainError(f"{name} = {value!r}: a number, 0 where it is not known")
    there = np.isfinite(times) & np.isfinite(lengths)
    times, lengths = np.ascontiguousarray(times[there]), np.ascontiguousarray(lengths[there])
    options, why, library = c.MeasuredOptions(fits.index(fit), sigma, period), ctypes.c_char_p(), c.library()
    handle = library.scallop_measured_new(times.ctypes.data, lengths.ctypes.data, times.size, ctypes.byref(options),
                                          b"measured", ctypes.byref(why))
    if not handle:
        raise DomainError(f"t and l: {(why.value or b'').decode()}")
    return Measured(handle, library)
