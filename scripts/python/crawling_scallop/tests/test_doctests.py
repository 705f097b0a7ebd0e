"""The examples in the docstrings, of the package as it is installed, and those of the pages that SCALLOP_PAGES names."""

from __future__ import annotations

import doctest
import importlib
import os

import pytest

MODULES = ("_library", "_observed", "_gaits", "_motion", "_measured", "_formulas", "_exact", "_studies", "_tables")


@pytest.mark.parametrize("name", MODULES)
def test_docstrings(name: str, proven: bool) -> None:
    """What needs FLINT or the command is in the last modules."""
    if name != "_observed":
        pytest.importorskip("numpy")
    if name in ("_formulas", "_exact", "_studies") and not proven:
        pytest.skip("this library or command was built without FLINT")
    module = importlib.import_module(f"crawling_scallop.{name}")
    result = doctest.testmod(module)
    assert result.failed == 0 and result.attempted > 0


@pytest.mark.parametrize("page", [page for page in os.environ.get("SCALLOP_PAGES", "").split(os.pathsep) if page])
def test_pages(page: str, proven: bool) -> None:
    if not proven:
        pytest.skip("this library or command was built without FLINT")
    with open(page, encoding="utf-8") as file:
        blocks = file.read().split("```")[1::2]
    text = "\n".join(block for block in blocks if block.startswith("python\n>>>"))
    test = doctest.DocTestParser().get_doctest(text, {}, page, page, 0)
    runner = doctest.DocTestRunner()
    runner.run(test)
    assert runner.summarize(verbose=False).failed == 0 and test.examples
