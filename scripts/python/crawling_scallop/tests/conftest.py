from __future__ import annotations

import crawling_scallop as s
import pytest


@pytest.fixture(scope="session")
def proven() -> bool:
    """Whether library and command were built with FLINT"""
    try:
        s.series(order=1)
        s.run(["claims", "--formula", "T", "--of", "v_end", "--claimed", "1", "--gait", "quadratic"], codes=(0, 1))
    except (s.MissingError, s.CommandError, ModuleNotFoundError):
        return False
    return True
