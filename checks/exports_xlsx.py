#!/usr/bin/env python3
"""Recalculates the exported workbook in LibreOffice at points of its own, and prints its row of the table of exports. Usage: exports_xlsx.py PROGRAM"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import zipfile

import numpy as np

program, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(__file__).resolve().parent.parent
SHEET = "xl/worksheets/sheet1.xml"
with tempfile.TemporaryDirectory() as folder:
    begun, folder = time.monotonic(), pathlib.Path(folder)
    for target in ("python", "xlsx"):
        done = subprocess.run([program, "export", "examples/prototype.toml", "--as", target, "-o", folder / target, "--format", "json"], cwd=ROOT, capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stderr
    answer = json.loads(done.stdout)
    form, blocked = answer["form"], answer["blocked_force_n"]
    sys.path.insert(0, str(folder / "python"))
    import mckibben_muscle as exported

    # Other pressures and lengths, in the box, outside of it and slack.
    with zipfile.ZipFile(folder / "xlsx/muscle.xlsx") as book:
        parts = {name: book.read(name) for name in book.namelist()}
    sheet, random = parts[SHEET].decode(), np.random.default_rng(1)
    rows = [int(r) for r in re.findall(r'<c r="C(\d+)"><f>', sheet)]
    pressures = random.uniform(-0.1, 1.2, len(rows)) * form["supply_pa"]
    lengths = (1 - random.uniform(-0.08, 0.32, len(rows))) * form["length_m"]
    for row, pressure, length in zip(rows, pressures.tolist(), lengths.tolist()):
        for column, value in (("A", pressure), ("B", length)):
            sheet, count = re.subn(rf'(<c r="{column}{row}"><v>)[^<]*', rf"\g<1>{value!r}", sheet)
            assert count == 1
    with zipfile.ZipFile(folder / "changed.xlsx", "w") as book:
        for name, data in parts.items():
            book.writestr(name, sheet if name == SHEET else data)
    done = subprocess.run(["soffice", "--headless", f"-env:UserInstallation=file://{folder}/office", "--convert-to", "csv", "--outdir", folder, folder / "changed.xlsx"], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    table = [row for row in csv.reader((folder / "changed.csv").open(newline="")) if re.fullmatch(r"-?[\d.Ee+-]+", row[0])]
    assert len(table) == len(rows) == 40, (len(table), len(rows))
    of = lambda k: np.array([float(row[k]) if row[k] else np.nan for row in table])
    near = lambda a, b: float(np.abs(a - b).max() / np.abs(b).max())
    pull = exported.force(pressures, lengths)
    pulls = pull > 0
    errors = [
        near(of(2), pull),
        near(of(3), exported.stiffness(pressures, lengths)),
        near(of(4), exported.force_per_pressure(pressures, lengths)),
        near(of(5)[pulls], exported.volume(pressures, lengths)[pulls]),
    ]
    assert pulls.sum() > 10 and not pulls.all() and np.isnan(of(5)[~pulls]).all()
    # The table has 15 digits.
    assert max(errors) < 1e-12 and (of(6) == exported.status(pressures, lengths)).all(), errors
    version = subprocess.run(["soffice", "--version"], capture_output=True, text=True, timeout=60).stdout.split()[1]
    size = (folder / "xlsx/muscle.xlsx").stat().st_size
    print(f"| xlsx | LibreOffice {version}, recalculated at other points | {max(errors):.1e} | {size} B | {time.monotonic() - begun:.1f} s |")
