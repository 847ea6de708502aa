"""Many finite-element tests from a plan, on disk."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from . import _answers, _files, _native
from ._ask import Progress, listening
from ._base import Fixed, _any

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

    from os import PathLike

    from ._inputs import FileLike, Option
    from ._results import Fitted


class Campaign(Fixed):
    """Many finite-element tests from a plan: a table (Parquet) that grows, and that a run resumes where it was ended.

    Parameters
    ----------
    output
        The table: one file that ends in ``.parquet``, or a folder of parts.
    plan
        The plan (TOML): a path, or ``{"name": …, "text": …}``; of a campaign that is only read it may be left out.

    Examples
    --------
    >>> campaign = Campaign("campaign.parquet", "plans/paper.toml")  # doctest: +SKIP
    >>> campaign.run(progress=True)                                  # doctest: +SKIP
    >>> campaign.to_pandas()                                         # doctest: +SKIP
    """

    __slots__ = ("_output", "_plan")
    _output: str
    _plan: dict[str, str] | None

    def __init__(self, output: str | PathLike[str], plan: FileLike | None = None) -> None:
        object.__setattr__(self, "_output", os.fspath(output))
        object.__setattr__(self, "_plan", None if plan is None else _files.text(plan))

    @property
    def output(self) -> str:
        """Where the table is."""
        return self._output

    @property
    def _table(self) -> str:
        """Where its points are: while it is not complete, in the folder of its parts."""
        parts = self._output + ".parts"
        return parts if not os.path.exists(self._output) and os.path.isdir(parts) else self._output

    def run(self, *, shard: str | None = None, threads: int | None = None, overwrite: bool = False, yes: bool = False, progress: Progress = None) -> _answers.Outcome:
        """Runs the plan, or what is missing of it. Ctrl-C ends it well: what was computed stays, and another run resumes it.

        Parameters
        ----------
        shard
            Only share i of n of the plan, as ``"i/n"``, as parts in a folder; :meth:`merge` joins them.
        threads
            As many as cores where it is left out. The table does not depend on them.
        overwrite
            Overwrite a file at ``output`` that is not of this plan.
        yes
            A plan of more than 10 GB or a day is begun.
        progress
            True for a progress bar, or a function that is called with (done, total).

        Returns
        -------
        Outcome
            What was computed.
        """
        request = {"plan": self._plan, "output": self._output, "shard": shard, "threads": threads, "overwrite": overwrite, "yes": yes}
        request = {name: value for name, value in request.items() if value is not None}
        with listening(progress, "campaign") as heard:
            return _answers.Outcome(_native.ask("campaign", request, heard))

    def summary(self) -> _answers.Summary:
        """What the table holds: muscles, points, failures by cause, ranges, where it comes from."""
        return _answers.Summary(_native.ask("campaign-show", {"campaign": self._table}))

    @staticmethod
    def merge(folders: list[str | PathLike[str]], output: str | PathLike[str], *, overwrite: bool = False) -> Campaign:
        """Joins folders of parts into one file, the same bytes as those of a single run."""
        _native.ask("campaign-merge", {"folders": [os.fspath(f) for f in folders], "output": os.fspath(output), "overwrite": overwrite})
        return Campaign(output)

    def fit(self, method: str | None = None, *, progress: Progress = None, **options: Option) -> Fitted:
        """The formula that a method makes of the table; the other arguments are those of :func:`fit`."""
        from ._commands import fit

        return fit(campaign=self._table, progress=progress, **_any({**options, "method": method}))

    def to_arrow(self) -> pyarrow.Table:
        """The table as a ``pyarrow.Table``."""
        import pyarrow.parquet as pq

        return pq.read_table(self._table)

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a ``pandas.DataFrame`` (by pyarrow or fastparquet)."""
        import pandas as pd

        return pd.read_parquet(self._table)

    def to_polars(self) -> polars.DataFrame:
        """The table as a ``polars.DataFrame``."""
        import polars as pl

        path = self._table
        return pl.read_parquet(os.path.join(path, "**", "*.parquet") if os.path.isdir(path) else path)

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Campaign) and (self._output, self._plan) == (other._output, other._plan)

    def __hash__(self) -> int:
        return hash(("Campaign", self._output, None if self._plan is None else self._plan["text"]))

    def __reduce__(self) -> tuple[Any, ...]:
        return Campaign, (self._output, self._plan)

    def __repr__(self) -> str:
        return f"Campaign({self._output!r}" + (f", {self._plan['name']!r})" if self._plan else ")")
