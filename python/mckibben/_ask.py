"""Questions to the compiled half: one function for every command."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Union

from . import _answers, _native, _plain, _quantity, _schema

Progress = Union[bool, Callable[[int, int], object], None]


def ask(command: str, request: dict[str, Any] | None = None, *, progress: Progress = None) -> dict[str, Any]:
    """The answer to a request in the words of JSON: dicts in, dicts out.

    Parameters
    ----------
    command
        Its name: the words of the command line, joined by a hyphen, such as ``force`` or ``parts-list``.
    request
        What ``mckibben schema`` says, numbers in mm, MPa, N and degrees.
    progress
        True for a line on standard error, or a function that is called with (done, total).

    Returns
    -------
    dict
        The answer, as JSON has it.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    with listening(progress, command) as heard:
        return _native.ask(command, {} if request is None else request, heard)


def answered(command: str, values: dict[str, Any], answer: str, progress: Progress = None) -> Any:
    """The answer to a request of keywords, as an object."""
    request = _plain.request(command, values)
    # With its figure, as the answer takes longer than to draw. A curve is drawn when it is wanted, and so are measured muscles, which may be rubbers alone.
    if command not in ("curve", "measured") and (figure := _schema.figure_in(command, "MPa")) is not None:
        request.setdefault("figure", figure)
    with listening(progress, command) as heard:
        return _answers.kind(answer)._asked_for(command, request, heard)


def units(system: object = None) -> Any:
    """How numbers are returned: ``"pint"`` as quantities of pint in the unit of their name, ``"plain"`` as numbers. A registry of pint may be
    given instead, so that its quantities go together with yours. With nothing: the answer of the command ``units``, all units that texts
    may have.
    """
    if system is None:
        return answered("units", {}, "UnitsAnswer")
    if system == "pint":
        import pint

        registry: Any = pint
        system = registry.get_application_registry()
    elif system == "plain":
        system = None
    elif not hasattr(system, "Quantity"):
        raise ValueError(f'units: "pint", "plain" or a registry of pint, not {system!r}')
    _quantity.REGISTRY = system
    return None


@contextmanager
def listening(progress: Progress, what: str) -> Iterator[Callable[[int, int], object] | None]:
    """The function that hears of progress: the caller's own, or one that writes a line on standard error."""
    if progress is True:
        try:
            yield lambda done, total: print(f"\r{what}: {done} of {total}", end="", file=sys.stderr, flush=True)
        finally:
            print(file=sys.stderr)
    else:
        yield progress or None
