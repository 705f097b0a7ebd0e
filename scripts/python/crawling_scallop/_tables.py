"""The tables of the repository: what the command writes of the paper's figures and claims."""

from __future__ import annotations

import difflib
import os
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._errors import DomainError, MissingError


def tables() -> list[str]:
    """List the tables that come with this package.

    Returns
    -------
    list of str
        What :func:`table` takes, such as ``'figure4'`` and ``'claims'``.
    """
    try:
        return sorted(name[:-4] for name in os.listdir(c.beside("data")) if name.endswith(".tsv"))
    except FileNotFoundError:
        raise MissingError(f"no tables: there is no folder {c.beside('data')}") from None


def table(name: str) -> dict[str, npt.NDArray[Any]]:
    """Read a table that comes with this package.

    Parameters
    ----------
    name : str
        One of those that :func:`tables` lists.

    Returns
    -------
    dict
        ``{column: array}``, of numbers where every cell is one, else of texts.

    Examples
    --------
    >>> import crawling_scallop
    >>> figure = crawling_scallop.table("figure4")
    >>> figure["T"].shape == figure["dxC_over_L"].shape
    True
    """
    if name not in tables():
        near = difflib.get_close_matches(str(name), tables(), 1)
        raise DomainError(f"name = {name!r}: one of {', '.join(tables())}" + (f"; did you mean {near[0]!r}?" if near else ""))
    with open(os.path.join(c.beside("data"), name + ".tsv"), encoding="utf-8") as file:
        head, *rows = [line.rstrip("\n").split("\t") for line in file if not line.startswith("#")]
    return {title: _numbers_or_texts(list(cells)) for title, cells in zip(head, zip(*rows))}


def _numbers_or_texts(cells: list[str]) -> npt.NDArray[Any]:
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return np.array(cells)
