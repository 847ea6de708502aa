"""Fitted formulas as files of JSON."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from os import PathLike

    from . import _answers
    from ._inputs import MuscleLike
    from ._model import Model


class Formula:
    """A fitted formula, as :func:`fit` makes it and its file (JSON) holds it. It is a model: ``muscle.model(formula)``.

    Parameters
    ----------
    text
        The content of its file.
    name
        How it is named as a model; the name in the file where it is left out.
    """

    __slots__ = ("_name", "_text")
    _name: str
    _text: str

    def __init__(self, text: str, name: str | None = None) -> None:
        from . import _native

        shown = _native.ask("formula-show", {"file": {"name": name or "the formula", "text": text}})
        object.__setattr__(self, "_text", text)
        object.__setattr__(self, "_name", name or str(shown["name"]))

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Formula:
        """The formula of a file."""
        import os

        from . import _native

        return cls(_native.read_formula(os.fspath(path)))

    @property
    def name(self) -> str:
        """Its name."""
        return self._name

    def to_json(self) -> str:
        """The content of its file."""
        return self._text

    def to_dict(self) -> dict[str, Any]:
        """The same as plain dicts and lists."""
        return dict(json.loads(self._text))

    def save(self, path: str | PathLike[str]) -> None:
        """Writes its file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self._text)

    def show(self) -> _answers.FormulaShowAnswer:
        """The formula with its equation in LaTeX, its range and its errors."""
        from ._commands import formula_show

        return formula_show(self, latex=True)

    def model(self, muscle: MuscleLike | None = None, **options: Any) -> Model:
        """The formula of a muscle; the arguments are those of :class:`Model`."""
        from ._model import Model

        return Model(muscle, self, **options)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a formula does not change: {name}")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Formula) and self._name == other._name and self.to_dict() == other.to_dict()

    def __hash__(self) -> int:
        return hash(("Formula", self._name, json.dumps(self.to_dict(), sort_keys=True)))

    def __reduce__(self) -> tuple[Any, ...]:
        return Formula, (self._text, self._name)

    def __repr__(self) -> str:
        return f"Formula({self._name!r})"

    def _repr_latex_(self) -> str | None:
        latex = self.show().latex
        return f"$${latex}$$" if latex and "\\begin{document}" not in latex else None
