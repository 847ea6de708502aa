"""Many finite-element tests from a plan, on disk."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from . import _api, _errors, _native
from ._request import heard, place

if TYPE_CHECKING:
    from concurrent.futures import Executor

    import pandas

    from ._request import FileLike, Json, PathLike, Progress


class Campaign(_api.CampaignCommands):
    """Many finite-element tests from a plan: a table (Parquet) that grows, and that a run resumes where it was ended. Its formula: ``mk.fit(campaign=…)``.

    Parameters
    ----------
    output
        The table: one file that ends in ``.parquet``, or a folder of parts.
    plan
        The plan (TOML): a path, or ``{"name": …, "text": …}``; of a campaign that is only read it may be left out.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.Campaign("campaign.parquet")
    Campaign('campaign.parquet', None)
    """

    def __init__(self, output: PathLike, plan: FileLike | None = None) -> None:
        self.output: str = place("output", output)
        if plan is not None and not isinstance(plan, Mapping):
            with _errors.blamed("plan"):
                plan = _native.read(place("plan", plan), "text")
        self.plan: Mapping[str, str] | None = plan

    @property
    def _parts(self) -> str:
        """Where the parts are while it is computed."""
        return (
            self.output + ".parts"
            if self.output.lower().endswith(".parquet")
            else self.output
        )

    @property
    def _table(self) -> str:
        """Where its points are: while it is not complete, in the folder of its parts."""
        return (
            self._parts
            if not os.path.exists(self.output) and os.path.isdir(self._parts)
            else self.output
        )

    def _files(self, command: str) -> Json:
        if command == "campaign-show":
            return {"campaign": self._table}
        return {"plan": self.plan, "output": self.output}

    def __fspath__(self) -> str:
        return self._table

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a ``pandas.DataFrame`` (by pyarrow); warnings that are not known are ``pandas.NA``."""
        import pandas as pd

        table = pd.read_parquet(self._table)
        flags = table.filter(regex="^warning_").columns
        return table.astype(dict.fromkeys(flags, "boolean"))

    def __repr__(self) -> str:
        return f"Campaign({self.output!r}, {self.plan!r})"


def _on(
    executor: Executor, made: Campaign, shards: int, progress: Progress, **request: Any
) -> None:
    """Computes the shards of a campaign on an executor, and waits for their end."""
    folder = os.path.abspath(made._parts)
    os.makedirs(folder, exist_ok=True)
    stop = os.path.join(folder, f".stop-{os.urandom(8).hex()}")
    request |= {"plan": made.plan, "output": folder}
    futures = [
        executor.submit(_shard, {**request, "shard": f"{i}/{shards}"}, stop)
        for i in range(1, shards + 1)
    ]

    hear = heard(progress, "campaign")
    try:
        for done, future in enumerate(futures, 1):
            future.result()
            if hear is not None:
                hear(done, shards)
    except BaseException:
        # Shards that wait are not begun, and those that run end within about a second.
        open(stop, "w").close()
        for future in futures:
            future.cancel()
        for future in futures:
            with suppress(Exception):
                future.exception()
        os.remove(stop)
        raise


def _shard(request: Json, stop: str) -> None:
    """Computes a shard in a worker's process; the file `stop` ends it."""

    def look(_done: int, _total: int) -> None:
        if os.path.exists(stop):
            raise KeyboardInterrupt

    while not os.path.exists(stop):
        try:
            _native.ask("campaign", request, look)
            return
        except KeyboardInterrupt:
            return
        except _errors.MckibbenError as error:
            # Another worker computes it, for a client that has left: what it leaves is computed after it.
            if error.kind != "locked":
                raise
            time.sleep(1)


def campaign(
    plan: FileLike,
    output: PathLike,
    *,
    executor: Executor | None = None,
    shards: int = 64,
    threads: int | None = None,
    progress: Progress = None,
    overwrite: bool = False,
) -> Campaign:
    """Runs a plan, or what is missing of it, on this machine or on any executor, and waits for its end. The table does not depend on the executor; the same
    call continues one that was cancelled or whose workers died.

    Parameters
    ----------
    plan, output
        As in :class:`Campaign`.
    executor
        Any ``concurrent.futures.Executor``: a process pool, that of Dask (``client.get_executor()``), whose workers have this package and the folder of
        `output`; without one the threads of this process.
    shards
        Number of tasks for the executor, several for each worker.
    threads
        Threads of each task; one where there is an executor, else as many as cores.
    progress
        True for a line on standard error, or a function that is called with (done, total); on an executor in shards.
    overwrite
        Replaces what is there and is not of this plan.

    Examples
    --------
    >>> from concurrent.futures import ProcessPoolExecutor
    >>> if __name__ == "__main__":                                                     # doctest: +SKIP
    ...     with ProcessPoolExecutor() as pool:
    ...         mk.campaign("plans/paper.toml", "campaign.parquet", executor=pool).to_pandas()
    """
    made = Campaign(output, plan)
    if executor is not None and not os.path.isfile(made.output):
        _on(
            executor,
            made,
            shards,
            progress,
            threads=threads or 1,
            overwrite=overwrite,
        )
    if executor is None or made._parts != made.output:
        # With an executor all parts are there, and this writes the file.
        made._run(
            threads=threads,
            progress=progress if executor is None else None,
            overwrite=overwrite,
        )
    return made
