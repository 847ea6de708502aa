"""What the package lists: help, inspection, star imports, with and without JAX."""

from __future__ import annotations

import inspect
import pickle
import pydoc
import subprocess
import sys
from typing import Any

import pytest

import mckibben as mk

# As where it is not installed.
WITHOUT = """
import sys
sys.modules["jax"] = None
import mckibben as mk
"""


def run(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_help_and_inspection_work_without_jax() -> None:
    code = WITHOUT + """
import inspect, pydoc
names = [name for name, _ in inspect.getmembers(mk)]
assert "Muscle" in names and "force" in names and "jax" not in names, names
text = pydoc.plain(pydoc.render_doc(mk))
assert "class Muscle" in text and "design(" in text
assert not hasattr(mk, "jax")
try:
    mk.jax
except AttributeError as error:
    assert "pip install jax" in str(error), error
else:
    raise SystemExit("jax")
print("well")
"""
    assert run(code).strip() == "well"


def test_all_that_is_listed_is_there() -> None:
    for name in mk.__all__:
        assert getattr(mk, name) is not None and name in dir(mk)
    assert {"Muscle", "Model", "force", "design", "MckibbenError", "ask"} <= set(mk.__all__)
    assert not {"jax", "import_module", "annotations"} & set(mk.__all__)
    assert "Muscle" in dict(inspect.getmembers(mk, inspect.isclass))
    assert "class Muscle" in pydoc.plain(pydoc.render_doc(mk))


def test_a_star_import_gives_what_is_listed() -> None:
    assert run("from mckibben import *\nimport mckibben\nassert all(n in globals() for n in mckibben.__all__)\nassert 'import_module' not in globals()\nprint(Muscle.prototype().wall_mm)").strip() == "3.0"


def test_what_is_made_from_the_schema_is_as_if_it_were_written() -> None:
    """Functions and classes with names, signatures and documentation, found by pickle, refused arguments named."""
    muscle = mk.Muscle.prototype()
    for thing in (mk.force, mk.Muscle.state, mk.OutOfRangeError, type(muscle.state(0.2, 0.1, model="ideal"))):
        assert pickle.loads(pickle.dumps(thing)) is thing and thing.__doc__ and thing.__module__.startswith("mckibben")
    assert inspect.isfunction(mk.force) and mk.force.__name__ == "force" and mk.Muscle.state.__qualname__ == "MuscleCommands.state"
    assert "pressure_mpa : MPa\n    Gauge pressure P in MPa." in (inspect.getdoc(mk.force) or "")
    assert "pressure_mpa : MPa" in pydoc.plain(pydoc.render_doc(mk.force)) and "force_per_pressure_n_per_mpa : N/MPa" in (type(muscle.state(0.2, 0.1, model="ideal")).__doc__ or "")
    ask: Any = mk.force
    with pytest.raises(TypeError, match=r"force\(\) got an unexpected keyword argument 'presure_mpa'"):
        ask(presure_mpa=1)
    with pytest.raises(TypeError, match=r"force\(\) too many positional"):
        ask(muscle, 0.2, 0.1, "ideal")
    with pytest.raises(AttributeError):
        mk.report
    assert muscle.state(0.2, contraction=0.1, model="ideal") == mk.force(muscle, 0.2, 0.1, model="ideal")


def test_the_schema_is_not_asked_for_by_the_import() -> None:
    """What takes time is done when it is used first."""
    code = "import sys, mckibben; print([m for m in sys.modules if m.startswith(('mckibben.', 'numpy'))])"
    assert run(code).strip() == "[]"


def test_a_name_that_is_none_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="did you mean 'Muscle'"):
        mk.Muscl
    assert not hasattr(mk, "__path_of__")


def test_what_is_given_has_a_type() -> None:
    """Arguments of every command, of what makes objects and of their methods. Those of JSON and of tables are of any type; pulls have overloads."""
    anything = {("Record", "__init__"), ("Solution", "__init__"), ("Table", "__init__"), ("ask", "ask"), ("Design", "__init__"), ("Fit", "__init__")}
    for name in mk.__all__:
        made = getattr(mk, name)
        own = [made] if inspect.isfunction(made) else [f for f in vars(made).values() if inspect.isfunction(f)] if inspect.isclass(made) else []
        for function in own:
            hidden = function.__name__.startswith("_") and function.__name__ != "__init__"
            if not hidden and function.__name__ not in ("force", "pressure", "contraction") and (name, function.__name__) not in anything:
                loose = [p for p in inspect.signature(function).parameters.values() if "Any" in str(p.annotation)]
                assert not loose, (name, function.__name__, loose)
