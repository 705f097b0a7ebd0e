"""Exact motions of the crawling scallop, and the order of any method's errors, from Python.

`order` needs nothing but the C library. All else takes and returns NumPy arrays: `steady` and `phase` solve many crawlers
in one call, and their results are bit for bit those of the commands ``scallop steady`` and ``scallop phase``.

Errors are subclasses of `ScallopError`, which have a `status`: `DomainError` (a ValueError) names the argument and the
first bad row; `UnsolvedError` (an ArithmeticError) says why there is no answer; `MissingError` (an OSError) and
`CommandError` are about the library and the command.

ctypes releases the global interpreter lock while the library computes, so that other threads of Python run meanwhile;
they must leave the arrays alone that are being read. docs/reference/python.md is the manual.
"""

from importlib.util import find_spec as _find_spec
from typing import TYPE_CHECKING

from ._errors import CommandError, DomainError, MissingError, ScallopError, UnsolvedError
from ._library import VERSION as __version__
from ._library import load
from ._observed import Order, order, orders

if TYPE_CHECKING or _find_spec("numpy"):
    from ._exact import Ball, Certified, Series, Terms, certified, series
    from ._formulas import Formula, formula, formulas, published
    from ._gaits import Gait, constant, gait_of, gaits, minimum_jerk, polynomial, skewed, trapezoidal
    from ._measured import Estimate, Measured, measured
    from ._motion import (Intervals, Phase, PhaseErrors, Steady, SteadyErrors, Trajectory, intervals, phase, phase_errors,
                         steady, steady_errors, trajectory)
    from ._studies import Reach, Transition, Verdict, command, reach, run, transitions
    from ._tables import table, tables
else:
    def __getattr__(name: str) -> object:
        if name.startswith("_"):
            raise AttributeError(name)
        raise ModuleNotFoundError(f"crawling_scallop.{name} needs NumPy; without it there are order(), orders() and load()")

__all__ = ["Ball", "Certified", "CommandError", "DomainError", "Estimate", "Formula", "Gait", "Intervals", "Measured",
           "MissingError", "Order", "Phase", "PhaseErrors", "Reach", "ScallopError", "Series", "Steady", "SteadyErrors",
           "Terms", "Trajectory", "Transition", "UnsolvedError", "Verdict", "__version__", "certified", "command", "constant",
           "formula", "formulas", "gait_of", "gaits", "intervals", "load", "measured", "minimum_jerk", "order", "orders", "phase",
           "phase_errors", "polynomial", "published", "reach", "run", "series", "skewed", "steady", "steady_errors",
           "table", "tables", "trajectory", "transitions", "trapezoidal"]
