"""Questions to the compiled half: one function for every command."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Union

from . import _native, _plain, _quantity, _schema

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
        True for a progress bar, or a function that is called with (done, total).

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
    from . import _answers, _results

    request = _plain.request(command, values)
    # With its figure, as the answer takes longer than to draw. A curve is drawn when it is wanted, and so are measured muscles, which may be rubbers alone.
    if command not in ("curve", "measured") and (figure := _schema.figure_in(command, "MPa")) is not None:
        request.setdefault("figure", figure)
    own = getattr(_results, answer, None)
    with listening(progress, command) as heard:
        if own is not None:
            return own._asked_for(command, request, heard)
        return getattr(_answers, answer)(_native.ask(command, request, heard), (command, request))


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
    """The function that hears of progress: the caller's own, or that of a bar which is closed at the end."""
    if progress is None or progress is False:
        yield None
    elif callable(progress):
        yield progress
    else:
        bar = Bar(what)
        try:
            yield bar.moved
        finally:
            bar.close()


class Bar:
    """A progress bar: that of tqdm, or a line on standard error where it is not installed."""

    def __init__(self, what: str) -> None:
        self.what = what
        self.bar: Any = None
        try:
            from tqdm.auto import tqdm
        except ImportError:
            self.tqdm: Any = None
        else:
            self.tqdm = tqdm

    def moved(self, done: int, total: int) -> None:
        """So many of so many."""
        if self.tqdm is None:
            print(f"\r{self.what}: {done} of {total}", end="", file=sys.stderr, flush=True)
            return
        if self.bar is None:
            self.bar = self.tqdm(total=total or None, desc=self.what)
        if self.bar.total != total and total:
            self.bar.total = total
        self.bar.update(max(0, done - self.bar.n))

    def close(self) -> None:
        """The end."""
        if self.bar is not None:
            self.bar.close()
        elif self.tqdm is None:
            print(file=sys.stderr)
