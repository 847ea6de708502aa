"""Campaigns on executors: pools, Dask; workers killed in the middle; cancel and rejoin. All give the bytes of one run."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from typing import Any

import pytest

import mckibben as mk

# A hundred parts, some seconds of one core.
PLAN = {
    "name": "plan.toml",
    "text": """
[sampling]
method = "sobol"
samples = 200
seed = 5
[vary]
tube.outer_diameter = "20..50 mm"
tube.wall_ratio = "4..12%"
[test]
contractions = "0,5,10%"
pressures = "0.05..0.3:0.05"
""",
}


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The bytes of one uninterrupted run."""
    return Path(
        mk.campaign(PLAN, tmp_path_factory.mktemp("one") / "one.parquet").output
    ).read_bytes()


def test_a_process_pool_gives_the_same_bytes(tmp_path: Path, expected: bytes) -> None:
    heard: list[tuple[int, int]] = []
    out = tmp_path / "pool.parquet"
    with ProcessPoolExecutor(2) as pool:
        table = mk.campaign(
            PLAN,
            out,
            executor=pool,
            shards=8,
            progress=lambda done, total: heard.append((done, total)),
        )
    assert out.read_bytes() == expected and heard[-1] == (8, 8)
    assert os.listdir(tmp_path) == ["pool.parquet"], "the parts are in the file"
    assert len(table.to_pandas()) == 200 * 18
    # What is there is not computed again, and no executor is asked.
    assert mk.campaign(PLAN, out, executor=Broken()).summary().complete


class Broken(Executor):
    """One that takes nothing."""

    def submit(self, *_: Any, **__: Any) -> Future[Any]:
        raise AssertionError("nothing is to be computed")


def once_begun(
    tmp_path: Path, part: str, then: Callable[[], object]
) -> Callable[[int, int], None]:
    """A progress that does something once the first part is written."""
    begun: list[Path] = []

    def look(_done: int, _total: int) -> None:
        if not begun:
            begun.extend(tmp_path.glob(part))
            if begun:
                then()

    return look


def test_a_killed_pool_is_joined_again(tmp_path: Path, expected: bytes) -> None:
    out = tmp_path / "parts"
    with ProcessPoolExecutor(2) as pool:

        def kill() -> None:
            for process in list(pool._processes.values()):
                process.kill()

        with pytest.raises(BrokenProcessPool):
            mk.campaign(
                PLAN,
                out,
                executor=pool,
                shards=10,
                progress=once_begun(tmp_path, "parts/part-*", kill),
            )
    before = mk.Campaign(out).summary()
    assert 0 < before.muscles < 200 and before.missing_parts and not before.complete
    with ProcessPoolExecutor(2) as pool:
        campaign = mk.campaign(PLAN, out, executor=pool, shards=10)
    after = campaign.summary()
    assert after.complete and [shard.state for shard in after.shards] == ["done"] * 10
    request = {"folders": [str(out)], "output": str(tmp_path / "merged.parquet")}
    mk.ask("campaign-merge", request)
    assert (tmp_path / "merged.parquet").read_bytes() == expected


def test_a_cancelled_campaign_is_joined_again(tmp_path: Path, expected: bytes) -> None:
    out = tmp_path / "c.parquet"

    def leave() -> None:
        raise KeyboardInterrupt

    with ProcessPoolExecutor(2) as pool:
        with pytest.raises(KeyboardInterrupt):
            mk.campaign(
                PLAN,
                out,
                executor=pool,
                shards=4,
                progress=once_begun(tmp_path, "c.parquet.parts/part-*", leave),
            )
        assert not out.exists() and not list(tmp_path.glob("c.parquet.parts/.stop*"))
        assert mk.Campaign(tmp_path / "c.parquet.parts").summary().muscles < 200
        mk.campaign(PLAN, out, executor=pool, shards=4)
    assert out.read_bytes() == expected


def test_an_error_of_a_worker_is_that_of_the_campaign(tmp_path: Path) -> None:
    mk.campaign(PLAN, tmp_path / "parts")
    other = {"name": "other.toml", "text": PLAN["text"].replace("seed = 5", "seed = 6")}
    with (
        ProcessPoolExecutor(1) as pool,
        pytest.raises(mk.MckibbenError, match="another plan"),
    ):
        mk.campaign(other, tmp_path / "parts", executor=pool, shards=2)


def test_dask_gives_the_same_bytes_while_its_workers_are_killed(
    tmp_path: Path, expected: bytes
) -> None:
    distributed = pytest.importorskip("distributed")
    out = tmp_path / "dask.parquet"
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        # The cluster starts another one in its place.
        kill = lambda: next(
            iter(cluster.workers.values())
        ).process.process._process.kill()
        mk.campaign(
            PLAN,
            out,
            executor=client.get_executor(),
            shards=20,
            progress=once_begun(tmp_path, "dask.parquet.parts/part-*", kill),
        )
    assert out.read_bytes() == expected
