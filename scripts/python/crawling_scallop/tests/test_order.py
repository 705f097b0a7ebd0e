"""order(), which needs no NumPy"""

from __future__ import annotations

import math
import subprocess
import sys
from typing import Any

import pytest

import crawling_scallop as s

H, ERR = [0.1, 0.05, 0.025, 0.0125], [0.011, 0.0026, 6.3e-4, 1.57e-4]


def test_verdicts() -> None:
    found = s.order(H, ERR, expect=2)
    assert found.passed and found.verdict == "pass" and found.used == 4 and abs(found.order - 2.0437) < 1e-4
    assert s.order(H, ERR, expect=3).verdict == "too-low"
    assert s.order(H, ERR, at_least=1).passed and not s.order(H, ERR).passed
    assert s.order(reversed(H), reversed(ERR), expect=2).pairwise[-1] == found.pairwise[0]
    assert s.order(H, [1, math.nan, 1, 1]).verdict == "invalid" and s.order([], []).verdict == "insufficient"
    assert s.order(H, [*ERR[:3], 1e-9], expect=2, noise=1e-9).uses[3] == "floor"


@pytest.mark.parametrize("arguments, wanted", [
    (dict(h=[1, 2], err=[1]), "one length"), (dict(h="abc", err=[1]), "h: a sequence"), (dict(h=1, err=2), "h: a sequence"),
    (dict(h=[1], err=[1j]), "err: a sequence"), (dict(h=[1], err=[None]), "err: a sequence"),
    (dict(h=H, err=ERR, expect=2, at_least=2), "exclude"), (dict(h=H, err=ERR, tol=0), "tol = 0"),
    (dict(h=H, err=ERR, expect=math.inf), "expect = inf"), (dict(h=H, err=ERR, expect="two"), "expect = 'two'"),
    (dict(h=H, err=ERR, noise=[1, 2]), "one length"), (dict(h=H, err=ERR, noise="x"), "noise"),
])
def test_bad_arguments(arguments: Any, wanted: str) -> None:
    with pytest.raises(s.DomainError, match=wanted) as caught:
        s.order(**arguments)
    assert caught.value.status


def test_without_numpy() -> None:
    program = ("import sys, importlib.util as u; find = u.find_spec\n"
               "u.find_spec = lambda name, *more: None if name == 'numpy' else find(name, *more)\n"
               "import crawling_scallop as s\n"
               f"assert s.order({H}, {ERR}, expect=2).passed and 'numpy' not in sys.modules\n"
               "try:\n    s.steady\nexcept ModuleNotFoundError as error:\n    print(error)\n")
    said = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, check=True).stdout.decode()
    assert said.strip() == "crawling_scallop.steady needs NumPy; without it there are order(), orders() and load()"


def test_fractions() -> None:
    h = [1, 0.5, 0.25, 0.125]
    assert s.order(h, [x**1.5 for x in h], expect="3/2").passed
    assert s.order(h, h, at_least="1/2").passed
    for wrong in "3/0", "two", "":
        with pytest.raises(s.DomainError, match="a fraction such as"):
            s.order(h, h, expect=wrong)


def test_tables() -> None:
    h = [1, 0.5, 0.25, 0.125]
    table = [[x**2, x] for x in h]
    assert {name: one.verdict for name, one in s.orders(h, table, expect=[2, 1]).items()} == {"0": "pass", "1": "pass"}
    assert [one.verdict for one in s.orders(h, table, expect=2).values()] == ["pass", "too-low"]
    columns = {"h": h, "L2": [x**2 for x in h], "H1": [None, *h[1:]]}
    found = s.orders("h", columns, expect={"L2": 2})
    assert found["L2"].passed and found["H1"].verdict == "invalid" and "h" not in found
    expects: list[tuple[Any, str]] = [({"L3": 2}, "no column 'L3'"), ([2], "1 orders for 2 columns")]
    for wrong, text in expects:
        with pytest.raises(s.DomainError, match=text):
            s.orders("h", columns, expect=wrong)
    with pytest.raises(s.DomainError, match="no such column"):
        s.orders("dx", columns)
    with pytest.raises(s.DomainError, match="different lengths"):
        s.orders(h, [[1, 2], [1]])


def test_frames() -> None:
    pandas = pytest.importorskip("pandas")
    h = [1, 0.5, 0.25, 0.125]
    frame = pandas.DataFrame({"L2": [x**2 for x in h], "H1": h}, index=h)
    assert all(one.passed for one in s.orders(frame.index, frame, expect={"L2": 2, "H1": 1}).values())
    assert s.order(frame.index, frame["L2"], expect=2).passed
    assert s.orders("h", frame.rename_axis("h").reset_index(), expect=[2, 1])["H1"].passed
