"""Pictures with matplotlib, which must be installed. Each function draws into an Axes and returns it."""

from __future__ import annotations

import math
from typing import Any, Iterable, Optional, Sequence

import matplotlib.pyplot as plt

from ._observed import Order
from ._observed import order as judge
from ._studies import Transition, Reach
from ._motion import Trajectory

__all__ = ["order", "reach", "trajectory"]


def _axes(ax: Optional[Any]) -> Any:
    return plt.subplots(layout="constrained")[1] if ax is None else ax


def trajectory(motion: Trajectory, ax: Optional[Any] = None) -> Any:
    """Draw positions in time.

    Parameters
    ----------
    motion : Trajectory
        What :func:`crawling_scallop.trajectory` returns.
    ax : matplotlib.axes.Axes, optional
        Where to draw; else a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        What was drawn into.
    """
    ax = _axes(ax)
    for name, label, style in (("x1", "body 1", "-"), ("x2", "body 2", "-"), ("xC", "centre", "--")):
        ax.plot(motion.t, getattr(motion, name), style, label=label)
    ax.set(xlabel="time", ylabel="position", xlim=(motion.t[0], motion.t[-1]))
    ax.legend()
    return ax


def order(h: Iterable[float], err: Iterable[float], found: Optional[Order] = None, ax: Optional[Any] = None) -> Any:
    """Draw errors against step sizes, and a line of the observed order.

    Parameters
    ----------
    h, err : sequence of float
        As for :func:`crawling_scallop.order`.
    found : Order, optional
        What that returned, with the order that was expected; else the order is measured.
    ax : matplotlib.axes.Axes, optional
        Where to draw; else a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        Points that were left out are hollow; the line goes through the finest point that was used.
    """
    steps, errors = [float(x) for x in h], [abs(float(x)) for x in err]
    found, ax = found or judge(steps, errors), _axes(ax)
    points = [point for point in zip(steps, errors, found.uses) if point[0] > 0 and point[1] > 0]
    used = [(x, y) for x, y, use in points if use == "used"]
    left = [(x, y) for x, y, use in points if use != "used"]
    if left:
        ax.plot(*zip(*left), "o", color="C0", markerfacecolor="none", label="left out")
    if used:
        ax.plot(*zip(*used), "o", color="C0", label="used")
    if used and math.isfinite(found.order):
        finest, coarsest = min(used), max(used)
        end = finest[1] * (coarsest[0] / finest[0])**found.order
        ax.plot([finest[0], coarsest[0]], [finest[1], end], "-", color="C1", label=f"order {found.order:.3g}")
    ax.set(xscale="log", yscale="log", xlabel="h", ylabel="error")
    ax.set_title(f"{found.verdict}: {found.reason}", wrap=True, fontsize="medium")
    ax.legend()
    return ax


def reach(rows: Sequence[Reach], transitions: Sequence[Transition] = (), ax: Optional[Any] = None) -> Any:
    """Draw up to which period each series is good.

    Parameters
    ----------
    rows : sequence of Reach
        What :func:`crawling_scallop.reach` returns, of one tolerance or of several. Infinite and vanishing periods are
        not drawn.
    transitions : sequence of Transition, optional
        Periods at which the motion changes its form, as dashed lines.
    ax : matplotlib.axes.Axes, optional
        Where to draw; else a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        What was drawn into.
    """
    ax = _axes(ax)
    drawn = [row for row in rows if 0 < row.T < math.inf]
    for number, what in enumerate(dict.fromkeys((row.quantity, row.series) for row in drawn)):
        each = sorted((row.tolerance, row.T) for row in drawn if (row.quantity, row.series) == what)
        ax.plot([T for _, T in each], [tolerance for tolerance, _ in each], marker="o", label=", ".join(what),
                linestyle=("-", "--", ":", "-.")[number % 4])  # curves may lie upon each other
    for number, transition in enumerate(transition for transition in transitions if transition.T > 0):
        ax.axvline(transition.T, linestyle="--", color="0.6", linewidth=1, label="the motion changes" if number == 0 else None)
    ax.set(xscale="log", yscale="log", xlabel="period T", ylabel="relative error")
    ax.legend(fontsize="small")
    return ax
