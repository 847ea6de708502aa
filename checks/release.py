#!/usr/bin/env python3
"""Makes and checks the files of a release.

    python3 checks/release.py                dry run: what runs here runs here; lists all that a release would publish
    python3 checks/release.py recipes        checksums, Homebrew formula and conda recipe (--dist, --tag, --repository)

The workflow `release` runs the second, after `packaging/build.sh` for each target; the first is `python3 checks/long.py release`.
"""

import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def run(*line, **more):
    return subprocess.run(
        [str(word) for word in line], check=True, capture_output=True, text=True, **more
    ).stdout


def version():
    return re.search(
        r'^\[workspace\.package\]\nversion = "(.+)"',
        (ROOT / "Cargo.toml").read_text(),
        re.M,
    )[1]


def targets():
    """The targets of the workflow, where they are declared."""
    return re.findall(
        r"target: ([\w-]+) \}", (ROOT / ".github/workflows/release.yml").read_text()
    )


def recipes(dist, tag, repository):
    """SHA256SUMS of all files, and the formula and recipe with them."""
    sums = {
        file.name: hashlib.sha256(file.read_bytes()).hexdigest()
        for file in sorted(dist.iterdir())
        if file.name != "SHA256SUMS"
    }
    values = {"VERSION": tag.removeprefix("v"), "REPOSITORY": repository}
    for target in targets():
        of = [total for name, total in sums.items() if f"-{target}." in name]
        values[target] = of[0] if of else None
    for recipe in [
        ROOT / "packaging/homebrew/mckibben.rb",
        ROOT / "packaging/conda/recipe.yaml",
    ]:
        text = recipe.read_text("utf-8")
        for key, value in values.items():
            text = text.replace(f"@{key}@", value) if value else text
        left = set(re.findall(r"@([\w-]+)@", text)) - {"SOURCE"}
        if left:
            print(
                f"{recipe.name}: without {', '.join(sorted(left))}, whose archives are not in {dist}"
            )
        (dist / recipe.name).write_text(text, "utf-8")
        sums[recipe.name] = hashlib.sha256(text.encode()).hexdigest()
    (dist / "SHA256SUMS").write_text(
        "".join(f"{total}  {name}\n" for name, total in sorted(sums.items())), "utf-8"
    )
    return sums


def crates():
    """Crates that are published, each after those that it needs."""
    found = json.loads(
        run("cargo", "metadata", "--no-deps", "--format-version", "1", cwd=ROOT)
    )["packages"]
    ours = {package["name"]: package for package in found if package["publish"] is None}
    order = []
    while len(order) < len(ours):
        ready = [
            name
            for name, package in sorted(ours.items())
            if name not in order
            and all(
                need["name"] not in ours
                or need["name"] in order
                or need["kind"] == "dev"
                for need in package["dependencies"]
            )
        ]
        assert ready, "crates need each other in a ring"
        order += ready
    for package in ours.values():
        assert (
            package["version"] == version()
            and package["license"]
            and package["description"]
        ), package["name"]
    return order


def agreed():
    """What a release states in several places is the same in all of them."""
    now = version()
    cited = re.search(
        r"^version: (.+)$", (ROOT / "CITATION.cff").read_text("utf-8"), re.M
    )[1]
    assert cited == now, f"CITATION.cff has version {cited}, Cargo.toml {now}"
    deposit = json.loads((ROOT / ".zenodo.json").read_text("utf-8"))
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    assert deposit["title"] in citation and all(
        word in citation for word in deposit["keywords"]
    ), ".zenodo.json and CITATION.cff differ"
    return now


def dry_run(binary):
    now = agreed()
    tag, host = f"v{now}", run("rustc", "-vV").split("host: ")[1].split()[0]
    out = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "xtask/release"
    shutil.rmtree(out, ignore_errors=True)
    print(
        f"a release {tag} would publish\n\narchives, each checked by its own program:"
    )
    program = binary or ROOT / f"target/{host}/release/mckibben"
    made, *held = run(
        "bash", ROOT / "packaging/archive.sh", host, program, out
    ).splitlines()
    for target in targets():
        size = (
            f"{Path(made).stat().st_size / 1e6:.1f} MB, made here"
            if target == host
            else "made by its runner"
        )
        print(
            f"  mckibben-{tag}-{target}{'.zip' if 'windows' in target else '.tar.gz'}  ({size})"
        )
    print(
        f"  each with {len(held)} files: "
        + ", ".join(sorted({file.split("/")[0] for file in held}))
    )
    sums = recipes(out, tag, "OWNER/REPOSITORY")
    print(
        "\nbeside them: SHA256SUMS, a statement of provenance for each file, "
        + ", ".join(name for name in sums if name.startswith(("mckibben.rb", "recipe")))
    )
    print(
        f"\nPyPI, by trusted publishing:\n  mckibben {now}: a wheel (abi3) for each target, and mckibben-{now}.tar.gz"
    )
    print(
        "\ncrates.io, in this order:\n  "
        + "\n  ".join(f"{name} {now}" for name in crates())
    )
    print(
        "\nthe project's pages (branch gh-pages): workbench, book, API of the crates, JSON Schemas\nZenodo: .zenodo.json"
    )
    if "## [Unreleased]" in (ROOT / "CHANGELOG.md").read_text("utf-8"):
        print(
            f"\nbefore the tag: give [Unreleased] in CHANGELOG.md the heading [{now}] and a date"
        )


def main():
    words = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    words.add_argument(
        "task", nargs="?", default="dry-run", choices=["dry-run", "recipes"]
    )
    for flag in ["tag", "repository", "binary"]:
        words.add_argument(f"--{flag}")
    words.add_argument("--dist", type=Path)
    given = words.parse_args()
    if given.task == "recipes":
        agreed()
        recipes(given.dist, given.tag, given.repository)
    else:
        dry_run(given.binary or os.environ.get("MCKIBBEN"))


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"failed: {' '.join(map(str, error.cmd))}\n{error.stderr}")
