"""Steady states, phases, trajectories and intervals: the exact motion, with NumPy arrays in and out."""

from __future__ import annotations

import ctypes
import math
from typing import Any, Callable, NamedTuple, Sequence, TypeVar

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._arrays import Array, Flags, Floats, Texts, count, texts
from ._errors import DomainError, UnsolvedError
from ._gaits import Columns, GaitLike, OneGait, together


def kind_of(kind: str) -> int:
    if not isinstance(kind, str) or kind not in c.KINDS:
        raise DomainError(f"kind = {kind!r}: 'extension' or 'contraction'")
    return c.KINDS[kind]


def crawler_of(columns: Columns, row: int) -> tuple[ctypes.Structure, dict[str, Any]]:
    values = {name: each.reshape(-1)[row].item() for name, each in columns.items()}
    return c.Crawler(*(values[name] for name in c.PARAMETERS + ("gait",))), values


def _where(shape: tuple[int, ...], row: int) -> str:
    place = tuple(int(i) for i in np.unravel_index(row, shape))
    return f"row {place[0] if len(shape) == 1 else place}: " if shape else ""


def complain(columns: Columns, row: int) -> None:
    """Raises what is wrong with that row of the columns, if anything is."""
    crawler, values = crawler_of(columns, row)
    complaint, where = c.Complaint(), _where(columns.shape, row)
    if c.library().scallop_crawler_check(ctypes.byref(crawler), ctypes.byref(complaint)) < 0:
        raise DomainError(f"{where}{complaint.name.decode()} = {complaint.given!r}: {complaint.allowed.decode()}")
    if not math.isfinite(values.get("v0", 0)):
        raise DomainError(f"{where}v0 = {values['v0']!r}: a finite number")


def _modes_text(lists: Any) -> str:
    data = lists.tobytes()
    return modes_text((c.Modes * (len(data) // ctypes.sizeof(c.Modes))).from_buffer_copy(data))


def modes_text(phases: Any) -> str:
    """Of an array of struct scallop_modes, one for each phase"""
    text = ctypes.create_string_buffer(3 * c.MODES_KEPT + 8)  # SCALLOP_MODES_TEXT
    parts = []
    for modes in phases:
        c.library().scallop_modes_text(ctypes.byref(modes), text)
        parts.append(text.value.decode())
    return " | ".join(parts)


_Self = TypeVar("_Self", bound="Solution")


class Solution:
    """Arrays of one shape, or numbers and texts where every parameter was a number."""

    def __init__(self, names: Sequence[str], shape: tuple[int, ...], phases: int) -> None:
        self._arrays = {name: np.empty(shape) for name in names}
        self._regime, self._status = np.empty(shape, np.int32), np.empty(shape, np.int32)
        self._modes: npt.NDArray[Any] = np.zeros(shape, np.dtype((np.void, phases * ctypes.sizeof(c.Modes))))

    def _addresses(self) -> list[int]:
        arrays: list[npt.NDArray[Any]] = [*self._arrays.values(), self._regime, self._modes, self._status]
        return [array.ctypes.data for array in arrays]

    def _publish(self: _Self) -> _Self:
        for name, array in self._arrays.items():
            setattr(self, name, array[()])
        return self

    @property
    def solved(self) -> Flags:
        """Where there is an answer: true or false."""
        flags: Flags = (self._status >= 0)[()]
        return flags

    @property
    def status(self) -> Texts:
        """'ok', or what there is to know of the answer, or why there is none."""
        found: Texts = texts(self._status, lambda code: c.status_text(int(code)))
        return found

    @property
    def regime(self) -> Texts:
        """'sliding', 'stick-slip' or 'at-rest', and '-' where there is no answer."""
        codes = np.where(self._status >= 0, self._regime, -1)
        found: Texts = texts(codes, lambda code: "-" if code < 0 else c.library().scallop_regime_text(int(code)).decode())
        return found

    @property
    def modes(self) -> Texts:
        """Directions of body 1 and body 2 in turn, 0 stuck: '++ -+ ++'; | parts the phases of a period; '-' where there
        is no answer."""
        found: Texts = np.where(self._status >= 0, texts(self._modes, _modes_text), "-")[()]
        return found

    def raise_for_status(self: _Self) -> _Self:
        """Raise for the first row without an answer.

        Returns
        -------
        Steady or Phase
            This object, if every row has an answer.

        Raises
        ------
        UnsolvedError
            With the row, and its status.
        """
        bad = np.flatnonzero(self._status < 0)
        if bad.size:
            status = c.status_text(int(self._status.reshape(-1)[bad[0]]))
            raise UnsolvedError(_where(self._status.shape, int(bad[0])) + status, status)
        return self

    def __repr__(self) -> str:
        names = (*self._arrays, "regime", "modes", "status")
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in names)})"


class Steady(Solution):
    """Periodic steady states, made by :func:`steady`.

    Attributes
    ----------
    froude : float or ndarray
        M L / (T^2 (F1 + F2)) [1]
    v_start : float or ndarray
        velocity of both bodies at the start of the extension [length/time]
    v_mid : float or ndarray
        velocity of both bodies at the start of the contraction [length/time]
    displacement : float or ndarray
        displacement of the geometric centre over a period [length]
    mean_velocity : float or ndarray
        displacement / T [length/time]
    multiplier : float or ndarray
        derivative of the period map: the factor by which a deviation decays in a period [1]
    v_low, v_high : float or ndarray
        All `v_start` between them are steady: the same number but for gaits whose speed jumps.
    solved, status, regime, modes
        Whether there is an answer, what is known of it, and the motion in words.
    """

    froude: Floats
    v_start: Floats
    v_mid: Floats
    displacement: Floats
    mean_velocity: Floats
    multiplier: Floats
    v_low: Floats
    v_high: Floats


class Phase(Solution):
    """Phases, made by :func:`phase`.

    Attributes
    ----------
    t1 : float or ndarray
        first change of mode after the start of the phase; nan: the mode does not change [time]
    dT : float or ndarray
        from the last change of mode to the end of the phase; nan: the mode does not change [time]
    v_end : float or ndarray
        velocity of both bodies at the end of the phase [length/time]
    dx1 : float or ndarray
        displacement of body 1 [length]
    dx2 : float or ndarray
        displacement of body 2 [length]
    dxC : float or ndarray
        displacement of the geometric centre (x1 + x2)/2 [length]
    solved, status, regime, modes
        Whether there is an answer, what is known of it, and the motion in words.
    """

    t1: Floats
    dT: Floats
    v_end: Floats
    dx1: Floats
    dx2: Floats
    dxC: Floats


def _refuse(solution: Solution, columns: Columns) -> None:
    """Raises what is wrong with the first row that has a parameter outside its domain, if there is one."""
    bad = np.flatnonzero(solution._status == c.OUTSIDE)
    if bad.size:
        complain(columns, int(bad[0]))


def _crawlers(columns: Columns) -> ctypes.Structure:
    gait = columns["gait"]
    return c.Crawlers(gait.size, *(columns[name].ctypes.data for name in c.PARAMETERS), gait.ctypes.data)


def steady(m1: npt.ArrayLike = 1, m2: npt.ArrayLike = 1, F1: npt.ArrayLike = 4, F2: npt.ArrayLike = 1,
           L: npt.ArrayLike = 10, T: npt.ArrayLike = 1, alpha: npt.ArrayLike = 0.75, gait: GaitLike = "quadratic",
           threads: int = 1) -> Steady:
    """Solve for the periodic steady states of crawlers.

    Parameters
    ----------
    m1, m2, F1, F2, L, T, alpha : array_like of float
        Masses, Coulomb friction forces, amplitude, period, and the fraction of the period that the extension takes:
        positive and finite, `alpha` below 1. Numbers or arrays that broadcast together.
    gait : str, Gait or array_like of these
        What the option ``--gait`` takes but ``measured:FILE``, such as ``'skewed:0.3'``, or a :class:`Gait`.
    threads : int, optional
        Number of threads, which does not change a bit of the result; ``libscallop-core`` runs on one.

    Returns
    -------
    Steady
        Arrays of the common shape, or numbers where every parameter is a number. A row that has no answer in doubles is
        nan, and its `status` says why.

    Raises
    ------
    DomainError
        A parameter is outside its domain: the message names the first bad row.

    Examples
    --------
    >>> import crawling_scallop
    >>> state = crawling_scallop.steady(F1=[2, 4], T=0.5)
    >>> state.displacement.round(4).tolist()
    [2.1052, 3.2431]
    >>> str(state.modes[1])
    '++ -+ ++ | ++ +- ++'
    """
    threads = count("threads", threads)
    columns = together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha), gait)
    solution = Steady(c.STEADY_NUMBERS, columns.shape, 2)
    failed = c.library().scallop_steady_batch(_crawlers(columns), c.SteadyStates(*solution._addresses()), threads)
    if failed:
        _refuse(solution, columns)
    return solution._publish()


def phase(kind: str, v0: npt.ArrayLike = 0, m1: npt.ArrayLike = 1, m2: npt.ArrayLike = 1, F1: npt.ArrayLike = 4,
          F2: npt.ArrayLike = 1, L: npt.ArrayLike = 10, T: npt.ArrayLike = 1, alpha: npt.ArrayLike = 0.75,
          gait: GaitLike = "quadratic", threads: int = 1) -> Phase:
    """Solve one phase of crawlers that start with velocity `v0`.

    Parameters
    ----------
    kind : {'extension', 'contraction'}
        The phase.
    v0 : array_like of float
        Velocity of both bodies at its start.
    m1, m2, F1, F2, L, T, alpha : array_like of float
        As for :func:`steady`. `T` is the period: the phase lasts ``alpha*T`` or ``(1 - alpha)*T``.
    gait : str, Gait or array_like of these
        As for :func:`steady`.
    threads : int, optional
        As for :func:`steady`.

    Returns
    -------
    Phase
        Arrays of the common shape, or numbers where every parameter is a number; rows as for :func:`steady`.

    Raises
    ------
    DomainError
        A parameter is outside its domain: the message names the first bad row.
    """
    threads, number = count("threads", threads), kind_of(kind)
    columns = together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0), gait)
    solution = Phase(c.PHASE_NUMBERS, columns.shape, 1)
    failed = c.library().scallop_phase_batch(_crawlers(columns), number, columns["v0"].ctypes.data,
                                             c.Phases(*solution._addresses()), threads)
    if failed:
        _refuse(solution, columns)
    return solution._publish()


class SteadyErrors(NamedTuple):
    """Estimates of the rounding errors of what :func:`steady` returns, made by :func:`steady_errors`."""

    froude: Floats
    v_start: Floats
    v_mid: Floats
    displacement: Floats
    mean_velocity: Floats
    multiplier: Floats


class PhaseErrors(NamedTuple):
    """Estimates of the rounding errors of what :func:`phase` returns, made by :func:`phase_errors`."""

    t1: Floats
    dT: Floats
    v_end: Floats
    dx1: Floats
    dx2: Floats
    dxC: Floats


def _errors(columns: Columns, names: Sequence[str], estimate: Callable[[ctypes.Structure, float], Any]) -> list[Floats]:
    """estimate(crawler, v0) is the struct of errors, or None where there is no answer to estimate the errors of."""
    table = np.full((len(names), int(np.prod(columns.shape, dtype=int))), np.nan)
    for row in range(table.shape[1]):
        crawler, values = crawler_of(columns, row)
        complain(columns, row)
        found = estimate(crawler, values.get("v0", 0.0))
        if found is not None:
            table[:, row] = [getattr(found, name) for name in names]
    return [each.reshape(columns.shape)[()] for each in table]


def steady_errors(m1: npt.ArrayLike = 1, m2: npt.ArrayLike = 1, F1: npt.ArrayLike = 4, F2: npt.ArrayLike = 1,
                  L: npt.ArrayLike = 10, T: npt.ArrayLike = 1, alpha: npt.ArrayLike = 0.75,
                  gait: GaitLike = "quadratic") -> SteadyErrors:
    """Estimate how far what :func:`steady` returns is off, from binary128 arithmetic.

    Row by row: 0.05 ms of processor time each for the default gait, as measured on one machine.

    Parameters
    ----------
    m1, m2, F1, F2, L, T, alpha : array_like of float
        As for :func:`steady`; exactly these doubles.
    gait : str, Gait or array_like of these
        As for :func:`steady`.

    Returns
    -------
    SteadyErrors
        A number is nan where :func:`steady` has no answer, where steady states fill an interval, and for a gait without an exact law.

    Examples
    --------
    >>> import crawling_scallop
    >>> bool(0 < crawling_scallop.steady_errors(F1=3).displacement < 1e-14)
    True
    """
    columns = together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha), gait)

    def estimate(crawler: ctypes.Structure, _: float) -> Any:
        result, error, library = c.SteadyResult(), c.SteadyError(), c.library()
        good = library.scallop_steady(crawler, result) >= 0 and library.scallop_steady_error(crawler, result, error) >= 0
        return error if good else None

    return SteadyErrors(*_errors(columns, SteadyErrors._fields, estimate))


def phase_errors(kind: str, v0: npt.ArrayLike = 0, m1: npt.ArrayLike = 1, m2: npt.ArrayLike = 1, F1: npt.ArrayLike = 4,
                 F2: npt.ArrayLike = 1, L: npt.ArrayLike = 10, T: npt.ArrayLike = 1, alpha: npt.ArrayLike = 0.75,
                 gait: GaitLike = "quadratic") -> PhaseErrors:
    """Estimate how far what :func:`phase` returns is off, from binary128 arithmetic.

    Parameters
    ----------
    kind : {'extension', 'contraction'}
        The phase.
    v0 : array_like of float
        Velocity of both bodies at its start.
    m1, m2, F1, F2, L, T, alpha : array_like of float
        As for :func:`phase`; exactly these doubles.
    gait : str, Gait or array_like of these
        As for :func:`steady`.

    Returns
    -------
    PhaseErrors
        A number is nan where :func:`phase` has no answer, and for a gait without an exact law.
    """
    number = kind_of(kind)
    columns = together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0), gait)

    def estimate(crawler: ctypes.Structure, start: float) -> Any:
        result, error, library = c.PhaseResult(), c.PhaseError(), c.library()
        good = (library.scallop_phase(crawler, number, start, result) >= 0
                and library.scallop_phase_error(crawler, number, start, result, error) >= 0)
        return error if good else None

    return PhaseErrors(*_errors(columns, PhaseErrors._fields, estimate))


class Trajectory(NamedTuple):
    """The motion of one crawler in time, made by :func:`trajectory`: times, positions of the bodies and of the geometric
    centre, velocities, and the separation l."""

    t: Array
    x1: Array
    x2: Array
    xC: Array
    v1: Array
    v2: Array
    l: Array


def _one(columns: Columns, what: str) -> tuple[ctypes.Structure, dict[str, Any]]:
    if columns.shape:
        raise DomainError(f"{what} of one crawler: its parameters are numbers")
    return crawler_of(columns, 0)


def _unsolved(columns: Columns, status: int) -> None:
    if status < 0:
        complain(columns, 0)
        raise UnsolvedError(c.status_text(status), c.status_text(status))


def trajectory(v0: float = 0, periods: int = 1, samples: int = 100, m1: float = 1, m2: float = 1, F1: float = 4,
               F2: float = 1, L: float = 10, T: float = 1, alpha: float = 0.75, gait: OneGait = "quadratic") -> Trajectory:
    """Follow one crawler in time.

    Parameters
    ----------
    v0 : float
        Velocity of both bodies at the start.
    periods : int
        Number of periods.
    samples : int
        Number of equally spaced times in each period; the end is one more.
    m1, m2, F1, F2, L, T, alpha : float
        As for :func:`steady`.
    gait : str or Gait
        As for :func:`steady`.

    Returns
    -------
    Trajectory
        Arrays of ``periods*samples + 1`` numbers.

    Raises
    ------
    DomainError
        A parameter is outside its domain.
    UnsolvedError
        The motion cannot be computed in doubles.

    Examples
    --------
    >>> import crawling_scallop
    >>> motion = crawling_scallop.trajectory(v0=2.5, periods=3, samples=50)
    >>> motion.xC.shape
    (151,)
    """
    periods, samples = count("periods", periods), count("samples", samples)
    columns = together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0), gait)
    crawler, values = _one(columns, "a trajectory is that")
    table = np.empty((periods * samples + 1, len(c.SAMPLE)))
    rows = iter(range(table.ctypes.data, table.ctypes.data + table.nbytes, table.strides[0]))
    error: list[BaseException] = []

    def keep(_: Any, sample: Any) -> bool:
        try:
            ctypes.memmove(next(rows), sample, table.strides[0])
            return True
        except BaseException as what:  # an interrupt, which would be lost in C
            error.append(what)
            return False

    status = c.library().scallop_trajectory(ctypes.byref(crawler), values["v0"], periods, samples, c.Sampler(keep), None)
    if error:
        raise error[0]
    _unsolved(columns, status)
    return Trajectory(*np.ascontiguousarray(table.T))


class Intervals(NamedTuple):
    """The intervals of a phase in which no body changes its direction or sticks, made by :func:`intervals`.

    Attributes
    ----------
    t_begin, t_end, duration : ndarray
        Times since the start of the phase; `duration` is ``t_end - t_begin`` unrounded.
    v1_begin, v1_end, v2_begin, v2_end : ndarray
        Velocities of the bodies just after the beginning and just before the end.
    dx1, dx2 : ndarray
        Displacements of the bodies.
    s1, s2 : ndarray
        Whether each body slides backward (-1), is stuck (0) or slides forward (1).
    """

    t_begin: Array
    t_end: Array
    duration: Array
    v1_begin: Array
    v1_end: Array
    v2_begin: Array
    v2_end: Array
    dx1: Array
    dx2: Array
    s1: Array
    s2: Array


def intervals(phase: str, v0: float = 0, m1: float = 1, m2: float = 1, F1: float = 4, F2: float = 1, L: float = 10,
              T: float = 1, alpha: float = 0.75, gait: OneGait = "quadratic") -> Intervals:
    """Split one phase of one crawler into intervals of constant mode.

    Parameters
    ----------
    phase : {'extension', 'contraction'}
        The phase.
    v0 : float
        Velocity of both bodies at its start.
    m1, m2, F1, F2, L, T, alpha : float
        As for :func:`steady`.
    gait : str or Gait
        As for :func:`steady`.

    Returns
    -------
    Intervals
        In the order of time.

    Raises
    ------
    DomainError
        A parameter is outside its domain.
    UnsolvedError
        The motion cannot be computed in doubles.
    """
    columns = together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0), gait)
    crawler, values = _one(columns, "intervals are those")
    kind, rows = kind_of(phase), []

    def keep(_: Any, interval: Any) -> None:
        span = c.library().scallop_interval_span(interval, ctypes.byref(crawler), kind)
        rows.append([getattr(span, name) for name in c.SPAN] + [span.mode.s1, span.mode.s2])

    _unsolved(columns, c.library().scallop_phase_intervals(ctypes.byref(crawler), kind, values["v0"], c.Visitor(keep), None))
    return Intervals(*np.array(rows).T)
