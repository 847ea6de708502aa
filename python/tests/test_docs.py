"""The code of the documentation runs, and prints what stands behind it."""

from __future__ import annotations

import contextlib
import doctest
import importlib.util
import io
import re
import subprocess
import sys
from pathlib import Path

import mckibben as mk
import pytest


PAGES = ["docs/python.md", "docs/python-arrays.md", "README.md"]


@pytest.mark.parametrize("page", PAGES)
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


def test_code_of_other_pages_runs(root: Path, tmp_path: Path) -> None:
    """In a process of its own, which begins others, beside a small plan."""
    (tmp_path / "plan.toml").write_text(
        '[sampling]\nmethod = "sobol"\nsamples = 4\nseed = 5\n[vary]\ntube.wall_ratio = "4..12%"\n'
        '[test]\ncontractions = "0,10%"\npressures = "0.1,0.2 MPa"\n',
        "utf-8",
    )
    pages = [root / "README.md", *sorted((root / "docs").glob("*.md"))]
    ran = 0
    for page in pages:
        if page.relative_to(root).as_posix() in PAGES:
            continue
        for block in re.findall(
            r"```python\n(.*?)```", page.read_text("utf-8"), flags=re.DOTALL
        ):
            (tmp_path / "block.py").write_text(block, "utf-8")
            subprocess.run(
                [sys.executable, "block.py"], cwd=tmp_path, check=True, timeout=300
            )
            ran += 1
    assert ran and (tmp_path / "campaign.parquet").exists()


def test_code_in_sentences_runs(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Names of the package exist in all pages; what reads an example of the repository runs."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(root / "examples")
    ran = 0
    for page in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
        text = re.sub(r"\n```.*?\n```", "", page.read_text("utf-8"), flags=re.DOTALL)
        for code in re.findall(r"`((?:mk|mckibben)\.[a-zA-Z_][^`]*)`", text):
            name = re.split(r"\W", code)[1]
            if name in ("toml", "h", "c", "py", "exe"):
                continue
            if hasattr(mk, name) and "examples/" in code and "(" in code:
                exec(compile(code, page.name, "eval"), {"mk": mk, "mckibben": mk})
                ran += 1
            elif "(" in code:
                known = hasattr(mk, name) or importlib.util.find_spec(
                    f"mckibben.{name}"
                )
                assert known, (page.name, code)
    assert ran >= 2


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
        ".jax",
        ".units",
    ],
)
def test_examples_of_docstrings(module: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip({".units": "pint", ".jax": "jax"}.get(module, "numpy"))
    result = doctest.testmod(
        importlib.import_module(f"mckibben{module}"),
        optionflags=doctest.NORMALIZE_WHITESPACE,
    )
    assert result.failed == 0 and result.attempted > 0
