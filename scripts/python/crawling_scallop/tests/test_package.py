"""The installed package: that each part of it works, and that what is bad is refused. The numbers are those of the C
tests of the repository, or are compared with another part of the package."""

from __future__ import annotations

import inspect
import math
from fractions import Fraction
from typing import Any

import pytest

import crawling_scallop as s

np = pytest.importorskip("numpy")


def test_every_function_has_a_manual() -> None:
    for name in s.__all__:
        thing = getattr(s, name)
        assert name == "__version__" or (thing.__doc__ and len(thing.__doc__) > 30), name
        if inspect.isfunction(thing):
            parameters = [p for p in inspect.signature(thing).parameters.values()]
            text = thing.__doc__ or ""
            head = text.split("Returns\n")[0]
            missing = [p.name for p in parameters if not any(
                p.name in line.split(" : ")[0].replace("*", "").split(", ") for line in head.replace("    ", "").split("\n"))]
            assert not missing and "Returns\n" in text, (name, missing)
            assert all(p.annotation is not p.empty for p in parameters), name


def test_steady_and_errors() -> None:
    F1 = np.linspace(1.5, 6, 7)
    state, error = s.steady(F1=F1), s.steady_errors(F1=F1)
    assert s.steady().v_start == 3.0166206576889527
    assert state.raise_for_status() is state and (state.status == "ok").all()
    assert (s.steady(F1=F1, threads=2).displacement == state.displacement).all()
    assert (error.displacement > 0).all() and (error.displacement < 1e-14).all()
    far = s.steady(m1=[1, 1e-300], T=[1, 1e200])
    with pytest.raises(s.UnsolvedError, match="row 1: out of range") as caught:
        far.raise_for_status()
    assert caught.value.status == far.status[1]


def test_interval_of_steady_states_has_no_error() -> None:
    assert math.isnan(s.steady_errors(gait=s.constant(), alpha=0.5).displacement)


def test_phase_trajectory_intervals() -> None:
    phase, error = s.phase("extension", F1=3), s.phase_errors("extension", F1=3)
    motion, parts = s.trajectory(F1=3, samples=4), s.intervals("extension", F1=3)
    assert abs(motion.xC[3] - motion.xC[0] - phase.dxC) < 1e-14 and error.dxC < 1e-14
    assert abs(parts.dx1.sum() - phase.dx1) < 1e-14


@pytest.mark.parametrize("bad", [[1, None], "3", 1j, [1, math.nan], [[1], [1, 2]], -1, math.inf,
                                 np.array(["2020-01-01"], "M8[D]"), np.ma.masked_equal([1, 2], 2)])
def test_bad_arrays(bad: Any) -> None:
    with pytest.raises(s.DomainError, match="F1"):
        s.steady(F1=bad)


@pytest.mark.parametrize("bad", [3 + 0j, np.array([3 + 0j]), ["3"], np.array([(3, 4)], "f8,f8"), {3: 4}])
def test_arrays_of_what_is_no_number(bad: Any) -> None:
    with pytest.raises(s.DomainError, match="F1: real numbers are wanted"):
        s.steady(F1=bad)


def test_arrays_in_memory() -> None:
    F1 = np.linspace(1.1, 5, 20)
    wanted = s.steady(F1=F1).displacement
    wide = np.zeros((20, 3))
    wide[:, 1] = F1
    read_only = F1.copy()
    read_only.flags.writeable = False
    unaligned = np.frombuffer(b"x" + F1.tobytes(), np.uint8)[1:].view(float)
    for same in (F1[::-1].copy()[::-1], wide[:, 1], read_only, F1.astype(">f8"), unaligned, F1.astype(object)):
        before = same.tolist()
        assert (s.steady(F1=same).displacement == wanted).all() and same.tolist() == before
    square = F1.reshape(4, 5)
    for same in (np.asfortranarray(square), np.tile(square, (2, 2))[:4, 5:]):
        assert (s.steady(F1=same).displacement == wanted.reshape(4, 5)).all()
    for kind in (np.float32, np.int64, np.uint8, np.longdouble):
        assert (s.steady(F1=np.array([2, 3, 5], kind)).displacement == s.steady(F1=[2.0, 3.0, 5.0]).displacement).all()
    with pytest.raises(s.DomainError, match="do not broadcast"):
        s.steady(F1=[1, 2, 3], T=[1, 2])


def test_formulas() -> None:
    text = s.formulas()["eq21_dxC"][1]
    assert text
    mine = s.formula("a*T", "extension", {"a": "(F1 - F2)/M"})
    assert mine(F1=3, T=2, alpha=0.5) == 1
    with pytest.raises(s.DomainError, match="did you mean 'alpha'"):
        s.formula("alfa*T")


def test_series_and_certified(proven: bool) -> None:
    if not proven:
        with pytest.raises((s.MissingError, s.CommandError)):
            s.series()
            s.transitions()
        return
    assert s.series().displacement[4] == Fraction(-711, 350464)
    ball, number = s.certified(F1=3, digits=40).displacement, float(s.steady(F1=3).displacement)
    assert abs(float(ball) - number) < 1e-15 * abs(number) and 0 < ball.radius < 1e-39
    assert len(ball.digits()) > 40
    low, high = (Fraction(ball.middle) + sign * Fraction(ball.radius) for sign in (-1, 1))
    assert low < high
    still = s.certified("extension", F1=2, F2=2)
    assert not hasattr(still, "t1") and still.regime == "sliding"
    with pytest.raises(s.DomainError):
        s.certified(T=0)
    with pytest.raises(s.UnsolvedError, match="interval|decide|undecided|boundary"):
        s.certified(gait="constant:0", alpha="1/2")
    mpmath = pytest.importorskip("mpmath")
    assert abs(ball.mpf() - number) < 1e-14 and mpmath.mpf(number) - 1e-14 in ball.mpi() + mpmath.iv.mpf([-1e-13, 1e-13])


def test_verdicts(proven: bool) -> None:
    if not proven:
        pytest.skip("this command was built without FLINT")
    wrong = s.formula("(F1 - F2)/M*T*1.01", "extension").verdict("v_end", 3)
    assert not wrong.holds and wrong.verdict == "refuted" and wrong.derived_order == 1
    named = s.formula("c*T", "extension", {"c": "(F1 - F2)/M"}).verdict("v_end", 3, m1=1, F1=3)
    assert named.holds and named.derived_order == 3
    with pytest.raises(s.CommandError, match="of"):
        s.formula("T").verdict("nonsense", 3)
    with pytest.raises(s.DomainError, match="T: m1"):
        s.formula("T").verdict("displacement", 3, T=1)


def test_breakdown(proven: bool) -> None:
    if not proven:
        pytest.skip("this command was built without FLINT")
    transitions = s.transitions()
    assert transitions[0].T == 0 and transitions[1].T == 2.7889395095954335
    one = s.reach(1e-2, "displacement")
    assert [row.series for row in one] == ["eq28_displacement", "derived", "limit"]
    T = one[0].T
    error = abs(float(s.published("eq28_displacement", T=T)) / float(s.steady(T=T).displacement) - 1)
    assert abs(error - 1e-2) < 1e-12
    with pytest.raises(s.CommandError) as caught:
        s.reach(-1)
    assert caught.value.code == 2 and "--tol" in str(caught.value)


def test_measured() -> None:
    t = np.linspace(0, 2, 60, endpoint=False)
    gait = s.measured(t, 3 - 2 * np.cos(np.pi * t))
    answer = gait.steady(F1=[3.0])
    assert (answer.low["displacement"] < answer.high["displacement"]).all()
    with pytest.raises(s.DomainError, match="one length"):
        s.measured([1, 2], [1])


def test_tables() -> None:
    assert "figure4" in s.tables()
    figure = s.table("figure4")
    T = figure["T"]
    rows = s.phase("extension", F1=figure["F1_over_F2"], T=2 * T, alpha=0.5)
    assert np.allclose(rows.dxC / 10, figure["dxC_over_L"], rtol=1e-10, atol=0)
    with pytest.raises(s.DomainError, match="did you mean 'figure4'"):
        s.table("figure44")


def test_plots() -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from crawling_scallop import plot
    assert len(plot.trajectory(s.trajectory()).lines) == 3
    h = [0.1 / 2**i for i in range(6)]
    axes = plot.order(h, [x**2 for x in h], s.order(h, [x**2 for x in h], expect=2))
    assert axes.get_title().startswith("pass")
    row = s.Reach("displacement", "derived", 8, 1e-2, 2.5, 0.5, 1e-2, "-", "-", "certified")
    lines = plot.reach([row, row._replace(T=math.inf)], [s.Transition(2.7, 0.5, "-", "-", "certified")]).lines
    assert [len(line.get_xdata()) for line in lines] == [1, 2]
