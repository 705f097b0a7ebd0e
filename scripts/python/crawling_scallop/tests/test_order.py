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
    assert said.strip() == "crawling_scallop.steady needs NumPy; without it there are order() and load()"
