"""Writes what is made of the Python package and its compiled half.

    python python/write.py stubs [FOLDER]       types of what the package makes from the schema, beside its modules
    python python/write.py reference FILE       the reference page, from the docstrings
    python python/write.py pages FOLDER         the same as pages for Sphinx (python/docs.sh makes HTML of them)

The compiled half is the library of the workspace's build (``cargo build --workspace --profile test``), or ``--native FILE``.
"""

from __future__ import annotations

import argparse
import ast
import inspect
import keyword
import os
import re
import sys
import textwrap
from collections.abc import Iterator
from functools import cache
from importlib.machinery import ExtensionFileLoader
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any
from unittest.mock import MagicMock

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "python" / "mckibben"
HEAD = "# Written by python/write.py from the schema.\n"
TYPES = """
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal

from . import _answers, _muscle, _results
from ._ask import Progress
from ._drives import Drive, Joint
from ._formula import Formula
from ._inputs import Choice, FileLike, FormulaLike, Measured, MuscleLike, Number, Numbers, Plain, TableLike
from ._muscle import Muscle
from ._rubber import Rubber
"""


def load(native: Path) -> None:
    """Makes a library the compiled half of the package in the sources."""
    sys.path.insert(0, str(ROOT / "python"))
    if any((PACKAGE / name).exists() for name in ("_native.abi3.so", "_native.pyd")):
        return
    spec = spec_from_file_location("mckibben._native", native, loader=ExtensionFileLoader("mckibben._native", str(native)))
    assert spec is not None and spec.loader is not None
    sys.modules["mckibben._native"] = module_from_spec(spec)
    spec.loader.exec_module(sys.modules["mckibben._native"])


@cache
def listed() -> list[str]:
    """The names that the package lists; before others stand in for libraries that are not installed."""
    import mckibben

    return mckibben.__all__


def documented(text: str | None, indent: str) -> str:
    return textwrap.indent(f'"""{text}\n"""' if "\n" in (text or "") else f'"""{text}"""', indent)


def function(name: str, made: Any, indent: str = "") -> str:
    from mckibben._commands import unit_free

    signature = inspect.signature(made)
    # A quantity is also given by its name without the unit, as a text or a quantity of pint.
    more = [inspect.Parameter(bare, inspect.Parameter.KEYWORD_ONLY, default=None, annotation="str | Measured | Sequence[str | Measured] | None") for bare in unit_free(signature.parameters)]
    signature = signature.replace(parameters=[*signature.parameters.values(), *more])
    return f"{indent}def {name}{signature}:\n{documented(made.__doc__, indent + '    ')}"


def commands() -> Iterator[str]:
    from mckibben import _commands

    yield HEAD + TYPES
    yield "def unit_free(names: Iterable[str]) -> dict[str, str]: ..."
    yield "def spelled(function: str, given: dict[str, Any], known: Iterable[str]) -> dict[str, Any]: ..."
    yield f"__all__ = {_commands.__all__}"
    for name in _commands.__all__:
        yield function(name, getattr(_commands, name))
    yield "CLASSES: dict[str, Any]"
    for name in _commands.CLASSES:
        made = getattr(_commands, name)
        yield f"class {name}:\n{documented(made.__doc__, '    ')}"
        for member, value in vars(made).items():
            if isinstance(value, property):
                yield "    @property\n" + function(member, value.fget, "    ").split('"""')[0].rstrip() + "\n" + documented(value.__doc__, "        ")
            elif inspect.isfunction(value):
                yield function(member, value, "    ")


def answers() -> Iterator[str]:
    from mckibben import _answers

    yield HEAD + "\nfrom typing import Any, Literal\n\nfrom ._record import Record\n"
    yield f"OWN: dict[str, type[Record]]\n\ndef kind(name: str) -> type[Record]: ...\n\n__all__ = {_answers.__all__}"
    for name in _answers.__all__:
        made = getattr(_answers, name)
        fields = "".join(f"\n    {field}: {kind}" for field, kind in made.__annotations__.items() if not keyword.iskeyword(field))
        yield f"class {name}(Record):\n{documented(made.__doc__, '    ')}{fields}"


def stubs(folder: Path) -> None:
    for name, lines in (("_commands", commands()), ("_answers", answers())):
        (folder / f"{name}.pyi").write_text("\n\n".join(lines) + "\n", "utf-8")


def classes(module: Any) -> Iterator[tuple[str, Any]]:
    """Functions and classes of a module in the order in which they are written; of one that is made from the schema, all there are."""
    made = module.__name__.rsplit(".", 1)[-1]
    if made in ("_commands", "_answers"):
        names = module.__all__
    else:
        names = [node.name for node in ast.parse(inspect.getsource(module)).body if isinstance(node, (ast.FunctionDef, ast.ClassDef))]
    for name in names:
        # Functions that the modules have for each other are not described.
        own = inspect.isfunction(getattr(module, name)) and made.startswith("_") and name not in listed()
        if not name.startswith("_") and not own and getattr(module, name).__doc__:
            yield name, getattr(module, name)


def members(made: type) -> Iterator[tuple[str, Any]]:
    """What a class has itself, and what a muscle has of its fields."""
    for part in (made, *(base for base in made.__mro__ if base.__name__.endswith(("Fields", "Asked", "Tabled")))):
        for name, value in vars(part).items():
            value = value.__func__ if isinstance(value, (classmethod, staticmethod)) else value
            if not name.startswith("_") and (inspect.isfunction(value) or isinstance(value, property)) and value.__doc__:
                yield name, value


PARTS = {"Objects": "_muscle _rubber _model _points _drives _simulation _formula _campaign _table", "Commands": "_commands", "Answers": "_results _record _load", "Exceptions": "_errors", "For JAX": "jax"}


def parts() -> Iterator[tuple[str, str, str, Any]]:
    """What is documented: the page, the module, the name, and what it is."""
    from importlib import import_module

    for title, modules in PARTS.items():
        if modules == "jax" and "jax" not in sys.modules and not find_spec("jax"):
            continue
        for module in modules.split():
            yield from ((title, module, name, made) for name, made in classes(import_module(f"mckibben.{module}")))


def reference() -> str:
    """The reference page."""
    import mckibben._muscle

    fields = inspect.getdoc(mckibben._muscle.Muscle.__init__) or ""
    out, last = ["# Python reference\n", "Made from the docstrings of the package. [The Python package](python.md) tells how they go together.\n"], ""
    for title, module, name, made in parts():
        if title != last:
            out.append(f"## {title}\n")
        last, text = title, inspect.getdoc(made) or ""
        if name == "Muscle":
            text = text.replace("Examples\n", f"{fields}\n\nExamples\n")
        out += entry(f"jax.{name}" if module == "jax" else name, made, text, "###")
        if inspect.isclass(made):
            for member, value in members(made):
                out += entry(f"{name}.{member}", value, inspect.getdoc(value) or "", "####")
    return "\n".join(out).rstrip() + "\n"


def pages(folder: Path) -> None:
    """The pages for Sphinx, with their settings."""
    texts: dict[str, list[str]] = {}
    for title, module, name, made in parts():
        kind = "exception" if title == "Exceptions" else "class" if inspect.isclass(made) else "function"
        options = ["   :members:", "   :inherited-members: object, Exception, str, float", "   :class-doc-from: both"] if kind == "class" else []
        texts.setdefault(title, []).append("\n".join([f".. auto{kind}:: mckibben.{module}.{name}", *options, ""]))
    names = {title: title.lower().replace(" ", "-") for title in texts}
    for title, directives in texts.items():
        (folder / f"{names[title]}.rst").write_text("\n".join([title, "=" * len(title), "", *directives]), "utf-8")
    tree = [".. toctree::", "   :maxdepth: 2", "", *(f"   {name}" for name in names.values()), ""]
    (folder / "index.rst").write_text("\n".join(["mckibben for Python", "===================", "", *tree]), "utf-8")
    settings = [f"import sys; sys.path.insert(0, {str(ROOT / 'python')!r})", "import write; write.ready(None)", 'project = "mckibben"', 'extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon"]', "add_module_names = False", 'autodoc_typehints = "none"', 'html_theme = "alabaster"', ""]
    (folder / "conf.py").write_text("\n".join(settings), "utf-8")


def entry(heading: str, made: Any, text: str, level: str) -> list[str]:
    if inspect.isfunction(made):
        names = [name for name, p in inspect.signature(made).parameters.items() if name not in ("self", "cls") and p.kind not in (p.VAR_KEYWORD, p.VAR_POSITIONAL)]
        heading += "(" + ", ".join(names[:4] + (["…"] if len(names) > 4 else [])) + ")"
    lines, body = re.sub(r":\w+:`([^`]+)`", r"`\1`", text).splitlines(), []
    i = 0
    while i < len(lines):
        # An example, up to the next empty line.
        if lines[i].startswith(">>>"):
            body.append("```python")
            while i < len(lines) and lines[i]:
                body.append(lines[i])
                i += 1
            body.append("```")
            continue
        if i + 1 < len(lines) and set(lines[i + 1].strip()) == {"-"}:
            body += [f"**{lines[i].strip()}**", ""]
            i += 2
            continue
        # A name with its text below it becomes a point of a list.
        if i + 1 < len(lines) and lines[i] and not lines[i].startswith(" ") and lines[i + 1].startswith("    "):
            about = []
            j = i + 1
            while j < len(lines) and (lines[j].startswith("    ") or not lines[j]):
                about.append(lines[j].strip())
                j += 1
            name, _, kind = lines[i].partition(" : ")
            body.append(f"- `{name}`" + (f" ({kind})" if kind else "") + ": " + " ".join(a for a in about if a))
            if j < len(lines) and not about[-1]:
                body.append("")
            i = j
            continue
        body.append(lines[i])
        i += 1
    return [f"{level} `{heading}`\n", "\n".join(body).strip().replace("<module", "&lt;module"), ""]


def ready(native: Path | None) -> None:
    """Loads the package with its compiled half."""
    built = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug"
    load(native or next((path for name in ("lib_native.so", "lib_native.dylib", "_native.dll") if (path := built / name).exists()), built))
    listed()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["stubs", "reference", "pages"])
    parser.add_argument("place", type=Path, nargs="?", default=PACKAGE)
    parser.add_argument("--native", type=Path)
    args = parser.parse_args()
    ready(args.native)
    if args.what == "stubs":
        return stubs(args.place)
    if args.what == "pages":
        return pages(args.place)
    if not find_spec("jax"):
        # What it would be called with is described where it is not installed, too.
        sys.modules.update({"jax": MagicMock(), "jax.numpy": MagicMock()})
    args.place.write_text(reference(), "utf-8")


if __name__ == "__main__":
    main()
