"""The code of the documentation runs, and prints what stands behind it."""

from __future__ import annotations

import contextlib
import doctest
import importlib
import io
import re
from pathlib import Path

import pytest


@pytest.mark.parametrize("page", ["docs/python.md", "README.md"])
def test_code_of_pages_runs(
    page: str, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    text = (root / page).read_text("utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, flags=re.DOTALL)
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(block, page, "exec"), names)
        expected = re.findall(r"print\(.*\)  # (.*)", block)
        assert out.getvalue().splitlines() == expected, block


@pytest.mark.parametrize(
    "module",
    [
        "",
        "._api",
        "._muscle",
        "._parts",
        "._motion",
        "._campaign",
        "._request",
        ".units",
    ],
)
def test_examples_of_docstrings(module: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if module == ".units":
        pytest.importorskip("pint")
    result = doctest.testmod(
        importlib.import_module(f"mckibben{module}"),
        optionflags=doctest.NORMALIZE_WHITESPACE,
    )
    assert result.failed == 0 and result.attempted > 0
