#!/usr/bin/env python3
"""Long checks of what changes seldom. Each part guards some files, and runs when they have changed since it last passed.

    python3 checks/long.py              parts whose files have changed; a part that passes is recorded in checks/long.json
    python3 checks/long.py --short      of these the short ones, with the build of the tests (.ci/run)
    python3 checks/long.py --all        all parts (nightly, before a release)
    python3 checks/long.py NAME ...     parts by name
    python3 checks/long.py --list       parts, and whether their files have changed

`checks/long.json` holds a digest of the files of each part as they were when it passed. It is committed with the change: a fresh clone then
has nothing to do here.
"""

import argparse
import hashlib
import json
import os
import re
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RECORD = ROOT / "checks/long.json"
MANIFESTS = [r"(.*/)?Cargo\.toml", r"Cargo\.lock"]

# Parts of a minute or two (the page: five; pages: six; exports: four with their hosts installed), which need the build of the tests alone.
SHORT = (
    "golds",
    "figures",
    "programs",
    "pages",
    "server",
    "page",
    "python",
    "wasm",
    "exports",
)

# Name: what it checks, files that it guards (patterns of whole paths), text that a file must hold as well, commands.
PARTS = {
    "golds": (
        "tables and formulas that the program makes itself",
        [
            r"crates/mckibben(-core|-io|-units|-fit|-fem|-campaign)?/(src|data|examples)/.*",
            r"plans/.*",
            r"data/(campaign|silicones|treloar)/.*",
        ],
        None,
        ["cargo xtask golds --check"],
    ),
    "figures": (
        "figures of README and docs",
        [
            r"crates/.*/src/.*",
            r"crates/.*/data/.*",
            r"docs/figures/.*",
            r"examples/.*",
            r"data/.*\.csv",
            r"xtask/.*",
        ],
        None,
        ["cargo xtask figures --check", "node web/frames.mjs --check"],
    ),
    "programs": (
        "other programs read what is written",
        [
            r"crates/mckibben-(build|fem|motion|campaign|io|report)/src/.*",
            r"crates/mckibben-app/src/(figure|simulate)/.*",
            r"checks/.*\.py",
        ],
        None,
        ['bash checks/programs.sh "$MCKIBBEN"'],
    ),
    "pages": (
        "commands of all pages of the documentation, and what they print",
        [
            r"README\.md",
            r"docs/.*\.md",
            r"crates/mckibben-cli/src/.*",
        ],
        None,
        ["cargo xtask book --check"],
    ),
    "server": (
        "the server: two hundred clients",
        [
            r"crates/mckibben-(server|app)/src/.*",
            r"checks/server.*",
        ],
        None,
        ['python3 checks/server_load.py "$MCKIBBEN" --sessions 200 --seconds 5'],
    ),
    "page": (
        "the workbench in a browser: every page and form, axe, five minutes of use, speed",
        [
            r"web/(page|src|tests)/.*",
            r"web/.*\.(json|mjs|sh)",
            r"docs/contract\.txt",
            r"crates/mckibben-(server|wasm)/src/.*",
        ],
        None,
        ["bash web/test.sh serve"],
    ),
    "python": (
        "the Python package: all its tests",
        [
            r"python/.*",
            r"crates/mckibben-python/.*",
            r"docs/contract\.txt",
        ],
        None,
        ["bash checks/python.sh"],
    ),
    "wasm": (
        "all crates of the page for the browser",
        [*MANIFESTS, r"crates/mckibben-wasm/.*", r"checks/wasm\.sh"],
        None,
        ["bash checks/wasm.sh smoke", "bash checks/wasm.sh"],
    ),
    "exports": (
        "exported muscles in their hosts: compilers, emulated microcontrollers, MuJoCo, FMPy, Wine, JAX",
        [
            r"crates/mckibben-export/.*",
            r"crates/mckibben-app/src/export\.rs",
            r"crates/mckibben-app/tests/layer/truth/.*",
            r"checks/(exports.*|truth\.py)",
            r"checks/fmu.*",
            r"checks/mach_o\.py",
        ],
        None,
        ['bash checks/exports.sh "$MCKIBBEN"'],
    ),
    "campaigns": (
        "campaigns on Slurm, Dask and process pools",
        [
            r"crates/mckibben-campaign/src/campaign/.*",
            r"crates/mckibben-(io|units)/src/.*",
            r"crates/mckibben-cli/src/commands/campaign.*",
            r"python/mckibben/_campaign\.py",
            r"python/tests/test_executors\.py",
            r"checks/(slurm|campaigns)\.sh",
            r"docs/campaigns\.md",
        ],
        None,
        ['bash checks/campaigns.sh "$MCKIBBEN"'],
    ),
    "book": (
        "the book in a browser, at 400 and 1440 pixels",
        [
            r"docs/.*",
            r"web/(book.*|build\.sh|tests/book\.mjs)",
        ],
        None,
        [
            "bash web/build.sh --site target/site",
            "cd web && npm install --no-package-lock --no-audit --no-fund --silent && node tests/book.mjs ../target/site/docs",
        ],
    ),
    "release": (
        "the release build, README's first command, and a dry run of a release",
        [
            *MANIFESTS,
            r"\.github/workflows/release\.yml",
            r"packaging/.*",
            r"checks/release\.py",
            r"\.zenodo\.json",
        ],
        None,
        [
            "cargo build --release --locked",
            "python3 checks/release.py --binary target/release/mckibben",
            "cargo run --release --locked -- design --force 60N --stroke 12mm --max-pressure 2bar --length 160",
        ],
    ),
    "packages": (
        "every crate as it would be published",
        [*MANIFESTS, r"checks/package\.sh"],
        None,
        ["bash checks/package.sh"],
    ),
    "wheel": (
        "the Python package from its wheel: types, stubs, tests, notebooks",
        [
            r"pyproject\.toml",
            r"python/.*",
            r"crates/mckibben-python/.*",
            r"checks/wheel\.sh",
            r"docs/contract\.txt",
        ],
        None,
        ["bash checks/wheel.sh"],
    ),
    "engine": (
        "the page on its engine as WebAssembly",
        [
            r"web/(build|test)\.sh",
            r"web/page/js/engine/.*",
            r"crates/mckibben-wasm/.*",
            r"web/tests/engines\.mjs",
        ],
        None,
        ["bash web/build.sh", "bash web/test.sh static"],
    ),
    "studies": (
        "research scripts and benches build, their tests, the tables of the validation and prior.json, and their figures",
        [
            r"studies/.*",
            r"crates/mckibben-(core|fit|fem)/(src|data)/.*",
            r"examples/(measured|library)/.*",
        ],
        None,
        [
            "cargo clippy --manifest-path studies/Cargo.toml --target-dir target/studies --all-targets --locked -- -D warnings",
            "cargo study peers_figure -- target/peers.svg && cmp target/peers.svg docs/figures/peers.svg",
            "cargo study universal_errors -- 150 7 target/universal.svg && cmp target/universal.svg docs/figures/universal.svg",
            "cargo test --release --manifest-path studies/Cargo.toml --target-dir target/studies --bins --locked",
            "cargo study validation -- --check",
            "cargo study validation -- --plot target/measured.svg && cmp target/measured.svg docs/figures/measured.svg",
        ],
    ),
    "peers": (
        "finite elements beside FElupe and CalculiX",
        [
            r"crates/mckibben-fem/src/(three_dimensional|element|output)/.*",
            r"benches/peers/.*",
            r"data/peers/.*",
        ],
        None,
        [
            "python3 -m venv target/venv && target/venv/bin/python -m pip install --quiet numpy felupe pypardiso scipy",
            "target/venv/bin/python benches/peers/compare.py --quick",
        ],
    ),
}


def guarded(part):
    """A digest of the files of a part, by path and content."""
    _, patterns, text, _ = PARTS[part]
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
    digest = hashlib.sha256()
    for path in sorted(listed):
        if (
            not any(re.fullmatch(pattern, path) for pattern in patterns)
            or not (ROOT / path).is_file()
        ):
            continue
        content = (ROOT / path).read_bytes()
        if text and path.endswith(".rs") and not re.search(text.encode(), content):
            continue
        digest.update(path.encode() + b"\0" + hashlib.sha256(content).digest())
    return digest.hexdigest()


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("parts", nargs="*", metavar="NAME", help=", ".join(PARTS))
    for flag, about in (
        ("short", "the short ones of those that are due"),
        ("all", "all"),
        ("list", "only print them"),
    ):
        parser.add_argument(f"--{flag}", action="store_true", help=about)
    words = parser.parse_args()
    asked = words.parts
    unknown = [word for word in asked if word not in PARTS]
    if unknown:
        parser.error(
            f"no such part: {', '.join(unknown)}; there are {', '.join(PARTS)}"
        )
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    changed = [part for part in PARTS if record.get(part) != guarded(part)]
    if words.list:
        for part, (about, *_) in PARTS.items():
            print(f"{part:<11} {'changed' if part in changed else 'passed '}  {about}")
        return
    if words.short:
        changed = [part for part in changed if part in SHORT]
    os.environ.setdefault(
        "MCKIBBEN",
        str(
            Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug/mckibben"
        ),
    )
    due = asked or (list(PARTS) if words.all else changed)
    if due and not Path(os.environ["MCKIBBEN"]).exists():
        subprocess.run(
            [
                "cargo",
                "build",
                "--workspace",
                "--all-targets",
                "--profile",
                "test",
                "--locked",
            ],
            cwd=ROOT,
            check=True,
        )
    for part in due:
        about, *_, commands = PARTS[part]
        print(
            f"\n== {part}: {about}{'' if asked or words.all else ' (its files have changed)'}",
            flush=True,
        )
        begun, digest = time.monotonic(), guarded(part)
        for command in commands:
            subprocess.run(command, shell=True, cwd=ROOT, check=True, env=os.environ)
        record[part] = digest
        ordered = {name: record[name] for name in PARTS if name in record}
        RECORD.write_text(json.dumps(ordered, indent=1) + "\n")
        print(f"{part}: passed in {time.monotonic() - begun:.0f} s", flush=True)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"failed: {error.cmd}")
