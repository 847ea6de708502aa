"""Executes the notebooks of python/examples, each in a kernel of its own; what they assert holds, or this fails.

python python/notebooks.py
"""

from __future__ import annotations

import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

FOLDER = Path(__file__).resolve().parent / "examples"


def executed(path: Path) -> str:
    """A line on a notebook that ran."""
    begun = time.monotonic()
    files: Any = nbformat
    notebook = files.read(path, as_version=4)
    NotebookClient(
        notebook,
        timeout=300,
        kernel_name="python3",
        resources={"metadata": {"path": str(FOLDER)}},
    ).execute()
    size = len(files.writes(notebook)) / 1e6
    return (
        f"{path.name}: {time.monotonic() - begun:.1f} s, {size:.1f} MB with its outputs"
    )


if __name__ == "__main__":
    with ThreadPoolExecutor(2) as pool:
        for line in pool.map(executed, sorted(FOLDER.glob("*.ipynb"))):
            print(line)
            sys.stdout.flush()
