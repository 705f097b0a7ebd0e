"""What the command computes and the library has no call for: verdicts on formulas, and where the expansion breaks down.

Numbers are passed as texts that read back as the same double, and come back in the command's JSON."""

from __future__ import annotations

import functools
import json
import math
import os
import subprocess
from typing import Any, Mapping, NamedTuple, Optional, Sequence

from . import _library as c
from ._errors import CommandError, DomainError, MissingError
from ._gaits import Gait, OneGait


@functools.lru_cache(maxsize=None)
def _command_at(path: str) -> str:
    try:
        said = subprocess.run([path, "--version"], stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise MissingError(f"cannot run the command {path}: {error}") from None
    if said.decode().split() != ["scallop", c.VERSION]:
        raise MissingError(f"{path} is {said.decode().strip()!r}: version {c.VERSION} is wanted")
    return path


def command() -> str:
    """Find the command ``scallop`` that goes with this package.

    Returns
    -------
    str
        Its path: the environment variable ``SCALLOP_COMMAND``, or the one that was installed with this package (in the
        source tree: built in ``build/``).

    Raises
    ------
    MissingError
        It is not there, or is of another version.
    """
    return _command_at(os.environ.get("SCALLOP_COMMAND") or c.beside("command"))


def run(arguments: Sequence[str], text: str = "", codes: Sequence[int] = (0,)) -> list[dict[str, Any]]:
    """Run the command and read its table.

    Parameters
    ----------
    arguments : sequence of str
        The name of a command and its options, such as ``['breakdown', '--only', 'radius']``; ``--format json`` is added.
    text : str, optional
        What the command reads from standard input.
    codes : sequence of int, optional
        Exit codes that are no error.

    Returns
    -------
    list of dict
        One for each row.

    Raises
    ------
    CommandError
        With the message of the command, and its exit code.

    Examples
    --------
    >>> import crawling_scallop
    >>> crawling_scallop.run(["steady", "--F1", "3"])[0]["regime"]
    'sliding'
    """
    said = subprocess.run([command(), *arguments, "--format", "json"], input=text.encode(), stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, env={**os.environ, "LC_ALL": "C.UTF-8"})
    if said.returncode not in codes:
        raise CommandError(said.stderr.decode().strip() or f"scallop ended with code {said.returncode}", said.returncode)
    return [json.loads(line) for line in said.stdout.decode().splitlines()]


def _options(numbers: Mapping[str, Any], gait: OneGait) -> list[str]:
    """The crawler as options of the command"""
    if isinstance(gait, Gait) and gait.name == "measured" or not isinstance(gait, (str, Gait)):
        raise DomainError(f"gait = {gait!r}: a text that --gait takes, or a Gait made of numbers")
    options = ["--gait", gait if isinstance(gait, str) else gait.name]
    for name, value in numbers.items():
        try:
            options += [f"--{name}", repr(float(value))]
        except (TypeError, ValueError, OverflowError):
            raise DomainError(f"{name}: a real number is wanted, not {value!r}") from None
    return options


class Verdict(NamedTuple):
    """What is proven of a formula, made by :meth:`Formula.verdict`.

    Attributes
    ----------
    verdict : str
        ``'holds'``, ``'sharper'``, ``'refuted'`` or ``'undecided'``.
    holds : bool
        Whether the verdict is one of the first two.
    derived_order : int or None
        The first power of T that the formula leaves out; None: none was found, or it is not known.
    coefficient : str
        What the formula leaves out there, for the crawler tested: a fraction, or an enclosure.
    leading_error : str
        That term as a formula, or ``'-'``.
    evidence : str
        ``'proven for all parameters'``, ``'certified for the crawler named'``, or ``'-'``.
    reason, conditions, summary : str
        Why; what was assumed; and which numbers of the crawler were changed for that.
    """

    verdict: str
    holds: bool
    derived_order: Optional[int]
    coefficient: str
    leading_error: str
    evidence: str
    reason: str
    conditions: str
    summary: str


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def decide(text: str, parts: Mapping[str, str], motion: str, of: str, claimed: Optional[int], start: Optional[str],
           gait: OneGait, crawler: Mapping[str, Any]) -> Verdict:
    """See Formula.verdict: the formula as a formula file of its own."""
    if claimed is not None and (isinstance(claimed, bool) or not isinstance(claimed, int) or not 1 <= claimed < 1000):
        raise DomainError(f"claimed = {claimed!r}: a whole number from 1 to 999, or None for equality")
    unknown = set(crawler) - {"m1", "m2", "F1", "F2", "L", "alpha"}
    if unknown:
        raise DomainError(f"{min(unknown)}: m1, m2, F1, F2, L or alpha")
    members = {"name": "formula", "text": text, "of": of, "claimed": "equality" if claimed is None else claimed}
    if motion == "steady":
        members["start"] = start or "steady"
    else:
        members["start"] = start or ("rest" if motion == "extension" else "v0")
        if members["start"] == "v0":
            members["phase"] = motion
    body = "".join(f"{name} = {value if isinstance(value, int) else _quoted(str(value))}; " for name, value in members.items())
    where = "".join(f"{name} = {_quoted(part)}; " for name, part in parts.items())
    formulas = f"formulas = ( {{ {body}{f'where = {{ {where}}}; ' if where else ''}}} );"
    row = run(["claims", "--formulas", "-", *_options(crawler, gait)], formulas, (0, 1, 3))[0]
    order = row["derived_order"]
    return Verdict(row["verdict"], row["verdict"] in ("holds", "sharper"), int(order) if str(order).isdigit() else None,
                   str(row["coefficient"]), row["leading_error"], row["evidence"], row["reason"], row["conditions"],
                   row["summary"])


class Transition(NamedTuple):
    """A period at which the motion changes its form, made by :func:`transitions`.

    Attributes
    ----------
    T, froude : float
        The period (of a phase: its duration), and the Froude number there.
    modes : str
        The sequence of modes from there on.
    note : str
        What happens.
    evidence : str
        ``'certified'``, ``'binary128'`` or ``'double'``: what shows it.
    """

    T: float
    froude: float
    modes: str
    note: str
    evidence: str


class Reach(NamedTuple):
    """Up to which period a series is good to a tolerance, made by :func:`reach`.

    Attributes
    ----------
    quantity, series : str
        The quantity, and the series: the name of a formula of the paper, ``'derived'`` or ``'limit'``.
    order : int or None
        Of the derived series: all terms below ``T^order``.
    tolerance : float
        The relative error that is allowed.
    T, froude : float
        The largest period up to which the error stays below it, and the Froude number there. inf: at every period; 0: at
        none.
    error : float
        The relative error at T.
    modes, note, evidence : str
        The motion there, and how this is known.
    """

    quantity: str
    series: str
    order: Optional[int]
    tolerance: float
    T: float
    froude: float
    error: float
    modes: str
    note: str
    evidence: str


def _number(value: Any) -> float:
    return math.nan if value is None else float(value)


def _breakdown(only: str, phase: Optional[str], v0: Optional[float], crawler: Mapping[str, Any], gait: OneGait,
               more: Sequence[str] = ()) -> list[dict[str, Any]]:
    numbers = dict(crawler) if v0 is None else {**crawler, "v0": v0}
    return run(["breakdown", "--only", only, "--quiet", *_options(numbers, gait), *(["--phase", phase] if phase else []), *more])


def transitions(m1: float = 1, m2: float = 1, F1: float = 4, F2: float = 1, L: float = 10, alpha: float = 0.75,
           gait: OneGait = "quadratic", phase: Optional[str] = None, v0: Optional[float] = None) -> list[Transition]:
    """Find where the sequence of modes changes as T grows: above the first transition the expansion is not about the motion
    any more. Needs the command, built with FLINT.

    Parameters
    ----------
    m1, m2, F1, F2, L, alpha : float
        As for :func:`steady`, but numbers.
    gait : str or Gait
        As for :func:`steady`.
    phase : {'extension', 'contraction'}, optional
        Of one phase instead of the steady state.
    v0 : float, optional
        Velocity of both bodies at the start of the phase.

    Returns
    -------
    list of Transition
        In the order of T; the first is the limit T -> 0.

    Examples
    --------
    >>> import crawling_scallop
    >>> first = crawling_scallop.transitions()[1]
    >>> first.T, first.note
    (2.7889395095954335, 'start velocity changes sign')
    """
    rows = _breakdown("transition", phase, v0, dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, alpha=alpha), gait)
    return [Transition(_number(row["T"]), _number(row["froude"]), row["modes"], row["note"], row["evidence"]) for row in rows]


def reach(tol: float = 1e-2, quantity: Optional[str] = None, order: int = 8, m1: float = 1, m2: float = 1, F1: float = 4,
          F2: float = 1, L: float = 10, alpha: float = 0.75, gait: OneGait = "quadratic", phase: Optional[str] = None,
          v0: Optional[float] = None) -> list[Reach]:
    """Find up to which T each series is good. Needs the command, built with FLINT.

    Parameters
    ----------
    tol : float
        The relative error that is allowed.
    quantity : str, optional
        This quantity only, such as ``'displacement'``.
    order : int
        The derived series has all terms below ``T^order``.
    m1, m2, F1, F2, L, alpha : float
        As for :func:`steady`, but numbers.
    gait : str or Gait
        As for :func:`steady`.
    phase : {'extension', 'contraction'}, optional
        Of one phase instead of the steady state.
    v0 : float, optional
        Velocity of both bodies at the start of the phase.

    Returns
    -------
    list of Reach
        One for each quantity and series.

    Examples
    --------
    >>> import crawling_scallop
    >>> {each.series: round(each.T, 3) for each in crawling_scallop.reach(quantity="displacement")}
    {'eq28_displacement': 1.986, 'derived': 2.807, 'limit': 1.986}
    """
    more = ["--tol", repr(float(tol)), "--order", str(order), *(["--quantity", quantity] if quantity else [])]
    rows = _breakdown("reach", phase, v0, dict(m1=m1, m2=m2, F1=F1, F2=F2, L=L, alpha=alpha), gait, more)
    return [Reach(row["quantity"], row["series"], row["order"], row["tolerance"], _number(row["T"]), _number(row["froude"]),
                  _number(row["error"]), row["modes"], row["note"], row["evidence"]) for row in rows]
