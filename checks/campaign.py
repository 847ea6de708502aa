#!/usr/bin/env python3
"""Runs the paper's campaign and opens its table with pandas and with DuckDB, as one file and as a folder of parts.

Usage: campaign.py PROGRAM [PLAN]
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import duckdb
import pandas
import pyarrow.parquet

program = pathlib.Path(sys.argv[1]).resolve()
root = pathlib.Path(__file__).resolve().parent.parent
plan = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else root / "plans" / "paper.toml"

COLUMNS = [
    "muscle",
    "outer_diameter_mm",
    "wall_mm",
    "length_mm",
    "angle_deg",
    "rubber",
    "law",
    "c10_mpa",
    "c01_mpa",
    "braid_stiffness_n_per_mm",
    "pressure_mpa",
    "contraction",
    "force_n",
    "volume_mm3",
    "stiffness_n_per_mm",
    "force_per_pressure_n_per_mpa",
    "braid_tension_n",
    "strand_tension_n",
    "bulged_diameter_mm",
    "max_stretch",
    "warning_burst",
    "warning_allowed_pressure",
    "warning_strand_strain",
    "warning_rubber_stretch",
    "warning_not_measured",
    "status",
    "cause",
    "iterations",
]

with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    one, parts = folder / "campaign.parquet", folder / "parts"

    def campaign(*words):
        subprocess.run(
            [program, "campaign", *map(str, words)], check=True, capture_output=True
        )

    campaign(plan, "-o", one)
    campaign(plan, "-o", parts, "--shard", "1/2")
    campaign(plan, "-o", parts, "--shard", "2/2")

    table = pandas.read_parquet(one)
    assert list(table.columns) == COLUMNS, list(table.columns)
    # Readers skip groups of rows by the extremes of a column, where these are there.
    file = pyarrow.parquet.ParquetFile(one)
    group = file.metadata.row_group(0)
    for column in map(group.column, range(group.num_columns)):
        values = table[column.path_in_schema].dropna()
        if len(values) and column.physical_type != "BYTE_ARRAY":
            found = column.statistics.min, column.statistics.max
            assert found == (values.min(), values.max()), column.path_in_schema
    assert list(json.loads(file.metadata.metadata[b"mckibben.columns"])) == COLUMNS
    assert len(table) == 2600, len(table)
    ok = table[table.status == "ok"]
    assert len(ok) > 2500 and not ok.force_n.isna().any(), (
        "a point with an answer has a force"
    )
    assert table[table.status != "ok"].force_n.isna().all(), "a failure has none"
    assert (ok.bulged_diameter_mm > 0.9 * ok.outer_diameter_mm).all() and (
        ok.max_stretch >= 1 - 1e-9
    ).all()
    assert ok.strand_tension_n.isna().all(), (
        "the paper's braid has no number of strands"
    )
    assert (ok.cause == "").all() and (table[table.status != "ok"].cause != "").all()
    # 4 diameters x 5 walls x 5 contractions x 26 pressures, each once, in the order of the plan.
    keys = ["outer_diameter_mm", "wall_mm", "contraction", "pressure_mpa"]
    assert [table[k].nunique() for k in keys] == [4, 5, 5, 26]
    assert not table.duplicated(keys).any()
    assert table[keys].equals(table.sort_values(keys, ignore_index=True)[keys])

    # DuckDB reads the folder as the same table.
    both = duckdb.sql(
        f"select count(*), count(*) filter (a.force_n is not distinct from b.force_n) "
        f"from '{one}' a join '{parts}/part-*.parquet' b using (muscle, contraction, pressure_mpa)"
    ).fetchall()
    assert both == [(2600, 2600)], both

    metadata = {
        k.decode(): v.decode()
        for k, v in pyarrow.parquet.read_metadata(one).metadata.items()
    }
    assert metadata["mckibben.plan"] == plan.read_text(), "the plan is in the file"
    assert len(metadata["mckibben.plan_sha256"]) == 64 and metadata["mckibben.version"]
    largest = ok.loc[ok.force_n.idxmax()]
    print(
        f"{len(table)} rows, {len(table) - len(ok)} without an answer; the largest pull {largest.force_n:.0f} N "
        f"(D0 {largest.outer_diameter_mm:.0f}, s {largest.wall_mm:.0f}, P {largest.pressure_mpa}); "
        f"pandas {pandas.__version__}, DuckDB {duckdb.__version__}"
    )
