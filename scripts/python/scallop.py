"""Exact crawling-scallop motions from Python, with NumPy arrays in and out.

    import numpy, scallop
    state = scallop.steady(F1=numpy.linspace(1.1, 40, 1000), T=0.5, gait="sinusoidal")
    state.displacement          # 1000 numbers
    state.modes[0]              # '++ -+ ++ | ++ +- ++'

steady() and phase() solve many crawlers in one call of the C library: parameters are numbers or arrays that broadcast
together, and the results have their common shape. What comes back is bit for bit what `scallop steady` and `scallop
phase` give. float64 arrays in C order that have the common shape are handed over where they are; everything else is
copied.

A parameter outside its domain is a ValueError that names the first bad row; nothing is returned then. A row that is
well posed and has no answer in doubles is nan, and its status says why.

The library, libscallop or libscallop-core (which has no threads), is looked for at the first call, in this
order: the argument of load(), the environment variable SCALLOP_LIBRARY, the folder build/ next to that of this file
(installed: the folder where `make install` has put the libraries), and where the system's loader looks. The number after
.so is the version of the binary interface; this module wants the version that it came with and refuses any other.

ctypes releases the global interpreter lock while the library computes, so that other threads of Python run meanwhile;
they must leave the arrays alone that are being read. Needs Python 3.9 or later and NumPy.
"""

import collections
import ctypes
import difflib
import functools
import itertools
import math
import re
import reprlib
import weakref

import numpy

import scallop_exact
import scallop_library as c
from scallop_exact import Ball, Series, Terms
from scallop_library import load

__all__ = ["Ball", "Formula", "Gait", "Intervals", "Order", "Phase", "Series", "Steady", "Terms", "Trajectory",
           "Estimate", "Measured", "constant", "formula", "formulas", "gait_of", "gaits", "intervals", "load",
           "measured", "minimum_jerk", "order", "phase", "polynomial", "published", "series", "skewed", "steady", "trapezoidal", "trajectory"]


class Gait:
    """A gait made by gait_of(): a value for the parameter gait. Its name is what the option --gait of the command calls
    it."""

    __slots__ = ("name", "_bytes", "_memory")

    def __init__(self, name):
        self.name, self._bytes = name, name.encode()
        self._memory = ctypes.create_string_buffer(ctypes.c_size_t.in_dll(c.library(), "scallop_made_gait_size").value)

    def __repr__(self):
        return f"<Gait {self.name}>"


    def _address(self):
        return ctypes.addressof(self._memory)


class _Other(Gait):
    """One of the gaits of a Measured, which it keeps alive."""

    __slots__ = ("L", "T", "alpha", "_pointer", "_of")

    def __init__(self, view, of=None):
        self.name, self._of, self._pointer = "measured", of, view.gait
        self.L, self.T, self.alpha = view.L, view.T, view.alpha

    def _address(self):
        return self._pointer


class Measured(_Other):
    """A gait through a recording, made by measured(): a value for the parameter gait. L, T and alpha are its own; text says
    how the recording was understood and what was laid through it; at(t) is l of the curve."""

    __slots__ = ("text", "_others", "_handle", "_library", "__weakref__")

    def __init__(self, handle, library):
        self._handle, self._library, self._others = handle, library, None
        weakref.finalize(self, library.scallop_measured_free, handle)
        super().__init__(library.scallop_measured_gait(handle, -1))
        text = ctypes.create_string_buffer(400)
        library.scallop_measured_text(handle, text, len(text))
        self.text = text.value.decode()

    def at(self, t):
        """l of the curve at t, a number or an array, in the units and from the origin of the recording."""
        times = _column("t", t)
        values = [self._library.scallop_measured_length(self._handle, x) for x in times.ravel().tolist()]
        return numpy.array(values).reshape(times.shape)[()]

    @property
    def samples(self):
        """t and l of the samples within one period that the curve was laid through."""
        count = self._library.scallop_measured_samples(self._handle, None, None)
        table = numpy.empty((2, count))
        self._library.scallop_measured_samples(self._handle, table[0].ctypes.data, table[1].ctypes.data)
        return table[0], table[1]

    @property
    def others(self):
        """The other gaits that the recording admits as well, at most 17, and None where there is none."""
        if self._others is None:
            views = [self._library.scallop_measured_gait(self._handle, i) for i in range(c.OTHERS)]
            self._others = [_Other(view, self) if view.gait else None for view in views]
        return self._others

    def steady(self, **parameters):
        """steady() with this gait and its L, T and alpha, where they are not given, as an Estimate."""
        return self._estimate(steady, c.STEADY_NUMBERS, parameters)

    def phase(self, kind, **parameters):
        """phase() likewise."""
        return self._estimate(functools.partial(phase, kind), c.PHASE_NUMBERS, parameters)

    def _estimate(self, solve, names, parameters):
        def solved(gait):
            return solve(gait=gait, **{"L": gait.L, "T": gait.T, "alpha": gait.alpha, **parameters})

        value, others = solved(self), [solved(gait) if gait else None for gait in self.others]
        low, high = {}, {}
        for name in names:
            best = numpy.asarray(getattr(value, name))
            spread = numpy.array([best * math.nan if other is None else getattr(other, name) for other in others])
            rows = zip(best.ravel().tolist(), spread.reshape(c.OTHERS, -1).T)
            error = [self._library.scallop_measured_error(x, (ctypes.c_double * c.OTHERS)(*row)) for x, row in rows]
            error = numpy.array(error).reshape(best.shape)
            low[name], high[name] = (best - error)[()], (best + error)[()]
        return Estimate(value, low, high)


class Estimate(collections.namedtuple("Estimate", "value low high")):
    """What a measured gait answers: value, a Steady or a Phase, and {name: number or array} low and high, between which the
    truth lies for some 95 of 100 recordings, as far as noise and gaps between samples are concerned."""

    __slots__ = ()


def measured(t, l, fit="chosen", sigma=0, period=0):
    """A Measured gait from a recording of times t and lengths l, arrays in any order, of one period or of several; rows with
    nan are left out. fit: 'monotone' or 'cubic' pass through every sample, 'smooth' and 'phases' are least-squares splines,
    in 'phases' with jumps of l'' where l turns; 'chosen' is the one of the last three whose error at unseen samples is
    estimated to be least. sigma > 0: the noise of a sample; else it is estimated. period > 0: else it is found.

        gait = scallop.measured(t, l)
        answer = gait.steady(m1=0.8, m2=1.7, F1=2.2, F2=0.9)
        answer.value.displacement, answer.low["displacement"], answer.high["displacement"]
    """
    times, lengths = _column("t", t), _column("l", l)
    if times.ndim != 1 or times.shape != lengths.shape:
        raise ValueError(f"t and l: two arrays of one length are wanted, not shapes {times.shape} and {lengths.shape}")
    fits = c.words(c.library(), "scallop_fit_names", c.FITS)
    if fit not in fits:
        raise ValueError(f"fit = {fit!r}: one of {', '.join(fits)}")
    for name, value in (("sigma", sigma), ("period", period)):
        if not (_column(name, value).shape == () and 0 <= value < math.inf):
            raise ValueError(f"{name} = {value!r}: a number, 0 where it is not known")
    there = numpy.isfinite(times) & numpy.isfinite(lengths)
    times, lengths = numpy.ascontiguousarray(times[there]), numpy.ascontiguousarray(lengths[there])
    options, why, library = c.MeasuredOptions(fits.index(fit), sigma, period), ctypes.c_char_p(), c.library()
    handle = library.scallop_measured_new(times.ctypes.data, lengths.ctypes.data, times.size, ctypes.byref(options),
                                          b"measured", ctypes.byref(why))
    if not handle:
        raise ValueError(f"t and l: {why.value.decode()}")
    return Measured(handle, library)


def _families():
    entries = (c.library().scallop_gait_family(i) for i in itertools.count())
    return {entry[0].name.decode(): entry for entry in itertools.takewhile(bool, entries)}


def gaits():
    """{name: (numbers, usual, sentence)} of the families of gaits: what gait_of() takes, the numbers that hold where none
    are given, and what the gait is. numbers and usual are '' where there are none."""
    return {name: tuple((text or b"").decode() for text in (entry[0].numbers, entry[0].usual, entry[0].sentence))
            for name, entry in _families().items()}


def gait_of(family, *numbers):
    """A gait of a family that gaits() lists, of the numbers that --gait takes after its name: gait_of('skewed', 0.3) is
    --gait skewed:0.3. Those of one phase hold for both, unless those of the contraction follow."""
    known = {name: entry for name, entry in _families().items() if not entry[0].fixed}
    if family not in known:
        raise ValueError(f"family = {family!r}: {', '.join(known)}")
    row, given = known[family][0], [float(x) for x in _column("numbers", numbers)]
    if len(given) == 2 * row.each and given[:row.each] == given[row.each:]:
        given = given[:row.each]
    gait, why = Gait(family + (":" + _numbers_text(given) if given else "")), ctypes.c_char_p()
    if given and not row.numbers or not given and not row.usual:
        raise ValueError(f"numbers = {given}: {(row.allowed or b'none').decode()}")
    given = given or [float(text) for text in row.usual.split(b",")]
    array = (ctypes.c_double * len(given))(*given)
    if c.library().scallop_make_gait(gait._memory, row, gait._bytes, array, len(given), why) < 0:
        raise ValueError(f"numbers = {given}: {(why.value or row.allowed).decode()}")
    return gait


def _numbers_text(numbers):
    return ",".join(repr(float(x))[:-2] if float(x).is_integer() and abs(x) < 1e15 else repr(float(x)) for x in numbers)


def _pair(name, value):
    """A number for both phases, or one for the extension and one for the contraction."""
    numbers = _column(name, value)
    if numbers.shape not in ((), (2,)):
        raise ValueError(f"{name}: one number, or two for extension and contraction, not {reprlib.repr(value)}")
    return [float(x) for x in numpy.broadcast_to(numbers, 2)]


def trapezoidal(up=0.25, down=0.25):
    """gait_of('trapezoidal', ...): each number may be a pair for extension and contraction."""
    up, down = _pair("up", up), _pair("down", down)
    return gait_of("trapezoidal", up[0], down[0], up[1], down[1])


def skewed(beta=0.25):
    """gait_of('skewed', ...): a number, or a pair for extension and contraction."""
    return gait_of("skewed", *_pair("beta", beta))


def constant(ramp=0):
    """gait_of('constant', ...): a number, or a pair for extension and contraction. With 0, l' jumps, and a steady state
    can be one of an interval: v_low to v_high."""
    return gait_of("constant", *_pair("ramp", ramp))


def polynomial(coefficients):
    """gait_of('polynomial', *coefficients): C1, C2, ..., Cn with n from 3 to 16, such that l' = 0 at both ends."""
    numbers = _column("coefficients", coefficients)
    if numbers.ndim != 1 or not 3 <= numbers.size <= c.MOST_NUMBERS:
        raise ValueError(f"coefficients: a sequence of 3 to {c.MOST_NUMBERS} numbers, not {reprlib.repr(coefficients)}")
    return gait_of("polynomial", *numbers)


def minimum_jerk():
    """gait_of('minimum-jerk')"""
    return gait_of("minimum-jerk")


@functools.lru_cache(maxsize=64)
def _gait_of_text(text):
    """'skewed:0.3' as gait_of('skewed', 0.3), one of those made last where it is."""
    family, colon, numbers = text.partition(":")
    try:
        return gait_of(family, *(float(x) for x in numbers.split(",") if colon))
    except ValueError as error:
        raise ValueError(f"gait = {text!r}: {error}") from None


def _made(gait):
    """A gait, or what --gait calls one: its address, or the Gait to hold while the library reads it (_address)."""
    if not isinstance(gait, (Gait, str)):
        raise _no_gait(gait)
    named = c.library().scallop_gait_named(gait.encode()) if isinstance(gait, str) else None
    if not named and isinstance(gait, str) and gait.partition(":")[0] not in gaits():
        raise _no_gait(gait)
    return named or (gait if isinstance(gait, Gait) else _gait_of_text(gait))


def _address(made):
    return made._address() if isinstance(made, Gait) else made


def _no_gait(gait):
    return ValueError(f"gait = {reprlib.repr(gait)}: {', '.join(gaits())}, with numbers as in 'skewed:0.3', or a Gait")


class _Columns(dict):
    """{name: array}, the gaits as addresses. made: what keeps these valid."""


def _addresses(gait):
    """The array of addresses, and what keeps them valid."""
    gaits = numpy.asarray(gait)
    listed = gaits.ravel().tolist()
    try:
        made = {each: _made(each) for each in dict.fromkeys(listed)}
    except TypeError:  # unhashable
        raise _no_gait(gait) from None
    address = {each: _address(one) for each, one in made.items()}
    return numpy.array([address[each] for each in listed], numpy.uintp).reshape(gaits.shape), made


def _column(name, value):
    """The value as float64, itself where it is that already."""
    try:
        array = numpy.asarray(value)
        if array.dtype == numpy.float64:
            return array
        if array.dtype.kind in "fiub":
            return array.astype(numpy.float64)
        if array.dtype.kind == "O":  # fractions and the like; astype would make nan of None
            return numpy.array([float(each) for each in array.flat], float).reshape(array.shape)
    except (TypeError, ValueError, OverflowError):
        pass
    raise ValueError(f"{name}: real numbers are wanted, not {reprlib.repr(value)}")


def _spread(array, shape):
    """The array in that shape as the library reads it, in order and without gaps: itself where it is so already."""
    if array.shape == shape and array.flags.c_contiguous and array.flags.aligned:
        return array
    full = numpy.empty(shape, array.dtype)
    full[...] = array
    return full


def _together(numbers, gait):
    """The columns of numbers, {name: value}, and the gait, all in their common shape."""
    columns = {name: _column(name, value) for name, value in numbers.items()}
    columns["gait"], made = _addresses(gait)
    try:
        shape = numpy.broadcast(*columns.values()).shape
    except ValueError:
        shapes = ", ".join(f"{name} {column.shape}" for name, column in columns.items() if column.shape)
        raise ValueError(f"these do not broadcast together: {shapes}") from None
    spread = _Columns((name, _spread(column, shape)) for name, column in columns.items())
    spread.made = made
    return spread, shape


def _count(name, value):
    if isinstance(value, bool) or not isinstance(value, (int, numpy.integer)) or not 1 <= value < 2**31:
        raise ValueError(f"{name} = {value!r}: a whole number from 1 to 2147483647")
    return int(value)


def _kind(kind):
    if not isinstance(kind, str) or kind not in c.KINDS:
        raise ValueError(f"kind = {kind!r}: 'extension' or 'contraction'")
    return c.KINDS[kind]


def _crawler(columns, row):
    values = {name: column.reshape(-1)[row].item() for name, column in columns.items()}
    return c.Crawler(*(values[name] for name in c.PARAMETERS + ("gait",))), values


def _complain(columns, shape, row):
    """Raises what is wrong with that row of the columns, if anything is."""
    crawler, values = _crawler(columns, row)
    complaint = c.Complaint()
    place = tuple(map(int, numpy.unravel_index(row, shape)))
    where = f"row {place[0] if len(shape) == 1 else place}: " if shape else ""
    if c.library().scallop_crawler_check(ctypes.byref(crawler), ctypes.byref(complaint)) < 0:
        raise ValueError(f"{where}{complaint.name.decode()} = {complaint.given!r}: {complaint.allowed.decode()}")
    if not math.isfinite(values.get("v0", 0)):
        raise ValueError(f"{where}v0 = {values['v0']!r}: a finite number")


def _texts(codes, text_of):
    """text_of each code, called once for each that is different."""
    different, which = numpy.unique(codes, return_inverse=True)
    return numpy.array([text_of(code) for code in different], dtype=str)[which.reshape(-1)].reshape(codes.shape)[()]


class _Solution:
    """Arrays of one shape, or numbers and texts where every parameter was a number."""

    def __init__(self, names, shape, phases):
        self._arrays = {name: numpy.empty(shape) for name in names}
        self._regime, self._status = numpy.empty(shape, numpy.int32), numpy.empty(shape, numpy.int32)
        self._modes = numpy.zeros(shape, numpy.dtype((numpy.void, phases * ctypes.sizeof(c.Modes))))

    def _addresses(self):
        return [array.ctypes.data for array in (*self._arrays.values(), self._regime, self._modes, self._status)]

    def _publish(self):
        for name, array in self._arrays.items():
            setattr(self, name, array[()])
        return self

    @property
    def solved(self):
        """Where there is an answer: true or false."""
        return (self._status >= 0)[()]

    @property
    def status(self):
        """'ok', or what there is to know of the answer, or why there is none."""
        return _texts(self._status, lambda code: c.library().scallop_status_text(int(code)).decode())

    @property
    def regime(self):
        """'sliding', 'stick-slip' or 'at-rest', and '-' where there is no answer."""
        codes = numpy.where(self._status >= 0, self._regime, -1)
        return _texts(codes, lambda code: "-" if code < 0 else c.library().scallop_regime_text(int(code)).decode())

    @property
    def modes(self):
        """Directions of body 1 and body 2 in turn, 0 stuck: '++ -+ ++'; | parts the phases of a period; '-' where there is
        no answer."""
        texts = _texts(self._modes, _modes_text)
        return numpy.where(self._status >= 0, texts, "-")[()]

    def __repr__(self):
        names = (*self._arrays, "regime", "modes", "status")
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in names)})"


def _modes_text(lists):
    text = ctypes.create_string_buffer(3 * c.MODES_KEPT + 8)  # SCALLOP_MODES_TEXT
    parts = []
    for modes in (c.Modes * (len(lists.tobytes()) // ctypes.sizeof(c.Modes))).from_buffer_copy(lists):
        c.library().scallop_modes_text(ctypes.byref(modes), text)
        parts.append(text.value.decode())
    return " | ".join(parts)


class Steady(_Solution):
    """froude, v_start, v_mid, displacement, mean_velocity, multiplier, v_low, v_high; solved, status, regime, modes."""


class Phase(_Solution):
    """t1, dT, v_end, dx1, dx2, dxC; solved, status, regime, modes. t1 and dT are nan where the mode does not change."""


def _refuse(solution, columns, shape):
    """Raises what is wrong with the first row that has a parameter outside its domain, if there is one."""
    bad = numpy.flatnonzero(solution._status == c.DOMAIN)
    if bad.size:
        _complain(columns, shape, int(bad[0]))


def _crawlers(columns):
    gait = columns["gait"]
    return c.Crawlers(gait.size, *(columns[name].ctypes.data for name in c.PARAMETERS), gait.ctypes.data)


def steady(m1=1, m2=1, F1=4, F2=1, L=10, T=1, alpha=0.75, gait="quadratic", threads=1):
    """The periodic steady states of crawlers: a Steady.

    Its quantities, with their units:

        froude         M L / (T^2 (F1 + F2)) [1]
        v_start        velocity of both bodies at the start of the extension [length/time]
        v_mid          velocity of both bodies at the start of the contraction [length/time]
        displacement   displacement of the geometric centre over a period [length]
        mean_velocity  displacement / T [length/time]
        multiplier     derivative of the period map: the factor by which a deviation decays in a period [1]

    and v_low and v_high, between which all v_start are steady: the same number but for gaits whose l' jumps.

    m1, m2, F1, F2, L, T > 0 and finite, 0 < alpha < 1. gait: what --gait takes but measured, as 'skewed:0.3'; a Gait; or an array of these.
    threads: on how many the library may run, which does not change a bit of the result; libscallop-core runs on one.
    """
    threads = _count("threads", threads)
    columns, shape = _together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha), gait)
    solution = Steady(c.STEADY_NUMBERS, shape, 2)
    failed = c.library().scallop_steady_batch(_crawlers(columns), c.SteadyStates(*solution._addresses()), threads)
    if failed:
        _refuse(solution, columns, shape)
    return solution._publish()


def phase(kind, v0=0, m1=1, m2=1, F1=4, F2=1, L=10, T=1, alpha=0.75, gait="quadratic", threads=1):
    """One phase, 'extension' or 'contraction', of crawlers that start with velocity v0: a Phase.

    Its quantities, with their units:

        t1             first change of mode after the start of the phase; nan: the mode does not change [time]
        dT             from the last change of mode to the end of the phase; nan: the mode does not change [time]
        v_end          velocity of both bodies at the end of the phase [length/time]
        dx1            displacement of body 1 [length]
        dx2            displacement of body 2 [length]
        dxC            displacement of the geometric centre (x1 + x2)/2 [length]

    T is the period: the phase lasts alpha T or (1 - alpha) T. v0 is finite; the other parameters are as for steady().
    """
    threads, kind = _count("threads", threads), _kind(kind)
    columns, shape = _together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0), gait)
    solution = Phase(c.PHASE_NUMBERS, shape, 1)
    failed = c.library().scallop_phase_batch(_crawlers(columns), kind, columns["v0"].ctypes.data,
                                             c.Phases(*solution._addresses()), threads)
    if failed:
        _refuse(solution, columns, shape)
    return solution._publish()


Trajectory = collections.namedtuple("Trajectory", c.SAMPLE)


def trajectory(v0=0, periods=1, samples=100, m1=1, m2=1, F1=4, F2=1, L=10, T=1, alpha=0.75, gait="quadratic"):
    """The motion of one crawler that starts with velocity v0: a Trajectory of the arrays t, x1, x2, xC, v1, v2, l, at
    `samples` equally spaced times in each period and once more at the end. Parameters as for phase(), but numbers.
    ArithmeticError: it cannot be computed."""
    periods, samples = _count("periods", periods), _count("samples", samples)
    columns, shape = _together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0), gait)
    if shape:
        raise ValueError("a trajectory is that of one crawler: its parameters are numbers")
    crawler, values = _crawler(columns, 0)
    table = numpy.empty((periods * samples + 1, len(c.SAMPLE)))
    rows, error = iter(range(table.ctypes.data, table.ctypes.data + table.nbytes, table.strides[0])), []

    def keep(_, sample):
        try:
            ctypes.memmove(next(rows), sample, table.strides[0])
            return True
        except BaseException as what:  # an interrupt, which would be lost in C
            error.append(what)
            return False

    status = c.library().scallop_trajectory(ctypes.byref(crawler), values["v0"], periods, samples, c.Sampler(keep), None)
    if error:
        raise error[0]
    if status < 0:
        _complain(columns, shape, 0)
        raise ArithmeticError(c.library().scallop_status_text(status).decode())
    return Trajectory(*numpy.ascontiguousarray(table.T))


Intervals = collections.namedtuple("Intervals", (*c.SPAN, "s1", "s2"))


def intervals(phase, v0=0, m1=1, m2=1, F1=4, F2=1, L=10, T=1, alpha=0.75, gait="quadratic"):
    """The intervals of one phase of one crawler in which the mode does not change: an Intervals of arrays, in the order of
    time. t_begin and t_end count from the start of the phase, duration is t_end - t_begin unrounded; v1_begin, ... are velocities of the bodies just after the
    beginning and just before the end, dx1 and dx2 their displacements, s1 and s2 whether each slides backward (-1),
    is stuck (0) or slides forward (1). Parameters as for phase(), but numbers. ArithmeticError: it cannot be computed."""
    columns, shape = _together(dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0), gait)
    if shape:
        raise ValueError("intervals are those of one crawler: its parameters are numbers")
    crawler, values = _crawler(columns, 0)
    kind, rows = _kind(phase), []

    def keep(_, interval):
        span = c.library().scallop_interval_span(interval, ctypes.byref(crawler), kind)
        rows.append([getattr(span, name) for name in c.SPAN] + [span.mode.s1, span.mode.s2])

    status = c.library().scallop_phase_intervals(ctypes.byref(crawler), kind, values["v0"], c.Visitor(keep), None)
    if status < 0:
        _complain(columns, shape, 0)
        raise ArithmeticError(c.library().scallop_status_text(status).decode())
    return Intervals(*numpy.array(rows).T)


def _published():
    table = ctypes.pointer(c.Formula.in_dll(c.library(), "scallop_published"))
    entries = itertools.takewhile(lambda formula: formula.name, map(table.__getitem__, itertools.count()))
    return {formula.name.decode(): formula for formula in entries}


def formulas():
    """{name: (equation, formula)} of the paper's formulas, in its order; asymptotics/asymptotics.h says what they are of."""
    return {name: (formula.equation.decode(), formula.text.decode()) for name, formula in _published().items()}


class Formula:
    """A formula that was read: made by formula(). Call it for its values.

        f = scallop.formula("(F1 - F2)/M*T/4", "extension")
        f(F1=numpy.linspace(1, 40, 1000), T=0.5)        # 1000 numbers

    f(v0, m1, m2, F1, F2, L, T, alpha, gait, t1, dT, x_switch) takes numbers or arrays that broadcast together, and the
    result has their common shape. T is the period, as everywhere here; in the text of a formula about a phase, T is the
    duration of that phase. t1, dT and x_switch are for formulas that take these as given. Off the domain of a quotient, a
    power or a function the value is nan or an infinity. Called in Python row by row: some microseconds for each.
    """

    __slots__ = ("text", "motion", "_library", "_read", "__weakref__")

    def __init__(self, row, motion):
        message = ctypes.create_string_buffer(c.MESSAGE)
        self.text, self.motion = row.text.decode(), motion
        self._library = c.library()
        self._read = self._library.scallop_formula_read(row, message)
        if not self._read:
            raise ValueError(f"text = {self.text!r}: {message.value.decode()}")
        weakref.finalize(self, self._library.scallop_formula_free, self._read)

    def __repr__(self):
        return f"<Formula {self.text!r} of {self.motion!r}>"

    def __call__(self, v0=0, m1=1, m2=1, F1=4, F2=1, L=10, T=1, alpha=0.75, gait="quadratic", t1=numpy.nan, dT=numpy.nan,
                 x_switch=numpy.nan):
        columns, shape = _together(
            dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha, v0=v0, t1=t1, dT=dT, x_switch=x_switch), gait)
        kind, check, value_of = self._kind(), self._library.scallop_crawler_check, self._library.scallop_formula_double
        values = []
        for *numbers, start, first, last, place, address in zip(*(column.ravel().tolist() for column in columns.values())):
            crawler = c.Crawler(*numbers, address)
            if check(crawler, None) < 0 or not math.isfinite(start):
                _complain(columns, shape, len(values))
            values.append(value_of(self._read, crawler, kind, start, first, last, place))
        return numpy.array(values, float).reshape(shape)[()]

    def ball(self, digits=17, v0=0, m1=1, m2=1, F1=4, F2=1, L=10, T=1, alpha=0.75, gait="quadratic"):
        """The Ball that encloses the value for one crawler with exact parameters, to a relative radius of 10^-digits; a
        value that cannot be told from 0 has a small ball around 0. Parameters as for series(). ArithmeticError: no finite
        value, or t1, dT or x_switch in the formula. Needs libscallop with FLINT."""
        made = _made(gait)
        return scallop_exact.enclosed(self._library, self._read, self._kind(), v0, digits,
                                      dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=T, alpha=alpha), _address(made))

    def _kind(self):
        return c.KINDS.get(self.motion, 0)


def formula(text, motion="steady", parts=None):
    """A Formula of one's own, read once: call it for its values.

    text: in the names of the paper's formulas, m1 m2 F1 F2 M L L_kin alpha T l0 lT k0 kT l_start l_end v0 t1 dT x_switch
    (asymptotics/asymptotics.h says what they are; formulas() has examples), with decimal numbers, + - * / ^, parentheses,
    pi, abs sqrt exp log log10 sin cos asin and min max. motion: what it is about, 'steady', 'extension' or 'contraction';
    the steady state has no v0, t1, dT and x_switch. parts: {name: text}, names for parts of the text.
    """
    settings = {"steady": c.STEADY, "extension": c.MOVING_EXTENSION, "contraction": c.MOVING_CONTRACTION}
    if not isinstance(motion, str) or motion not in settings:
        raise ValueError(f"motion = {motion!r}: 'steady', 'extension' or 'contraction'")
    if not isinstance(text, str) or not all(isinstance(each, str) for pair in dict(parts or {}).items() for each in pair):
        raise ValueError(f"text = {text!r}, parts = {parts!r}: a text, and a dict of texts")
    if any("\0" in each for each in (text, *dict(parts or {}).values())):
        raise ValueError(f"text = {text!r}: it has a NUL")
    known = c.words(c.library(), "scallop_symbol_names", c.SYMBOLS)
    for name in parts or {}:
        if not re.fullmatch("[A-Za-z][A-Za-z0-9_]{0,62}", name) or name in (*known, "pi"):
            raise ValueError(f"parts: {name!r} cannot be the name of a part")
    pairs = [(name.encode(), part.encode()) for name, part in (parts or {}).items()]
    row = c.Formula(setting=settings[motion], text=text.encode(), parts=0)
    listed = (c.Part * (len(pairs) + 1))(*(c.Part(*pair) for pair in pairs))
    row.parts = ctypes.addressof(listed)
    try:
        return Formula(row, motion)
    except ValueError as error:
        unknown = re.search(r"'(\w+)' is no quantity known here$", str(error))
        near = difflib.get_close_matches(unknown[1], (*known, *(parts or {})), 1, 0.5) if unknown else []
        raise ValueError(f"{error}; did you mean {near[0]!r}?" if near else str(error)) from None


def published(name, v0=0, m1=1, m2=1, F1=4, F2=1, L=10, T=1, alpha=0.75, gait="quadratic", t1=numpy.nan, dT=numpy.nan,
              x_switch=numpy.nan):
    """A formula of the paper as printed, mistakes included: 'rest_xC_end' is equation (21). Values and parameters as those
    of a Formula.

    A formula for one phase is that of the extension or of the contraction that it was printed for, from rest or from
    v0. Where a gait has l'' = 0 at the start or end of a phase most formulas are not finite.
    """
    known = _published()
    if not isinstance(name, str) or name not in known:
        near = difflib.get_close_matches(str(name), known, 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise ValueError(f"name = {name!r}: a formula that formulas() lists{hint}")
    motion = {c.STEADY: "steady", c.MOVING_CONTRACTION: "contraction"}.get(known[name].setting, "extension")
    return Formula(known[name], motion)(v0, m1, m2, F1, F2, L, T, alpha, gait, t1, dT, x_switch)


def series(motion="steady", v0=0, order=8, digits=17, m1=1, m2=1, F1=4, F2=1, L=10, alpha=0.75, gait="quadratic"):
    """The series that follow from the equations of motion, all terms below T^order: a Series, of the steady state in powers
    of the period, of an 'extension' or a 'contraction' from v0 in powers of the duration of the phase.

        scallop.series().displacement               # <(120/37) T^0 + (-711/350464) T^4 + O(T^8)>
        scallop.series().displacement[4]            # Fraction(-711, 350464)

    Quantities: v_start v_mid displacement mean_velocity friction_work of 'steady'; t1 dT v_end dx1 dx2 dxC of a phase (t1
    and dT are nothing but 0 where the mode does not change). A coefficient is a fractions.Fraction where gait and
    parameters are rational, else, and for friction_work, a Ball with a relative radius of at most 10^-digits, or around 0.

    Parameters are exact numbers: int, Fraction, Decimal, a text such as '0.7' or '1/3', or a float, which stands for the
    decimal that Python prints: 0.7 is 7/10. The numbers of a Gait are the doubles that they are. order and digits are from
    1 to 1000. ValueError: a parameter outside its domain, or a gait for which there is no series in T; ArithmeticError: the
    limit T -> 0 is not decided. Needs libscallop with FLINT (OSError).
    """
    made = _made(gait)
    return scallop_exact.series(motion, v0, order, digits, dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, T=1, alpha=alpha),
                                _address(made))


Order = collections.namedtuple("Order", "verdict passed order low high interval used gci asymptotic_ratio reason pairwise "
                                        "uses")


def order(h, err, expect=None, at_least=None, tol=0.1, noise=0, values=False):
    """The observed order of err ~ C h^p as h -> 0, and a verdict on the order that is expected: an Order.

    h, err: sequences of one length; err may have signs. expect: the order that is expected; at_least: the same, but a
    higher one passes, too; neither: the order is measured. tol: how far the order may be off, and how wide its interval
    on either side. noise: the rounding error of err, where it is known. values: err holds values and not errors.

        verdict, passed    'pass', 'too-low', ... as `scallop order` prints it; is it 'pass'?
        order, low, high   nan where there is none; interval says what low and high are
        used, reason       how many points are behind the order; why, in words; row 1 is h[0]
        gci                grid convergence index of values; asymptotic_ratio goes with it
        pairwise, uses     of each h: the order to the next finer one, and 'used', or why it was left out
    """
    if expect is not None and at_least is not None:
        raise ValueError("expect and at_least exclude each other")
    if not tol > 0 or not math.isfinite(tol):
        raise ValueError(f"tol = {tol!r}: a finite number > 0")
    rows = numpy.broadcast_arrays(_column("h", h), _column("err", err), _column("noise", noise))
    if rows[0].ndim != 1 or numpy.shape(h) != numpy.shape(err):
        raise ValueError("h and err: two sequences of one length")
    count = rows[0].size
    points = (c.OrderPoint * (count + 1))(*(c.OrderPoint(*row, number) for number, row in enumerate(zip(*rows), 1)))
    wanted = next((float(p) for p in (expect, at_least) if p is not None), math.nan)
    result, left, library = c.OrderResult(), ctypes.c_int(count), c.library()
    library.scallop_order(points, left, c.OrderWanted(wanted, tol, at_least is not None, values), result)
    verdict = library.scallop_order_verdict_text(result.verdict).decode()
    pairwise, uses = numpy.full(count, numpy.nan), ["-"] * count
    for point in points[:left.value if verdict != "invalid" else 0]:
        pairwise[point.row - 1] = point.pairwise
        uses[point.row - 1] = library.scallop_order_use_text(point.use).decode()
    return Order(verdict, verdict == "pass", result.order, result.low, result.high,
                 library.scallop_order_interval_text(result.interval).decode(), result.used, result.gci,
                 result.asymptotic_ratio, result.reason.decode(), pairwise, uses)
