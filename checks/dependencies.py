"""What the program is built from: every licence is one that its own (MIT OR Apache-2.0) can stand beside, every crate comes from
crates.io, and no crate is there in two versions but those that are named here.

    python3 checks/dependencies.py
"""

import re
import subprocess
import sys
from pathlib import Path

LICENCES = set(
    "MIT Apache-2.0 BSD-2-Clause BSD-3-Clause ISC Zlib 0BSD BSL-1.0 Unlicense MIT-0 Unicode-3.0 CC0-1.0".split()
    + ["Apache-2.0 WITH LLVM-exception"]
)
# Those of data that our own crates carry: their terms stand in NOTICE, in the metadata of the crate, and beside the data.
OF_OUR_DATA = {"ODbL-1.0", "CC-BY-4.0", "Bitstream-Vera"}
# Our crates with such data, and what their metadata must say.
WITH_DATA = {
    "mckibben": {"ODbL-1.0"},
    "mckibben-fit": {"ODbL-1.0", "CC-BY-4.0"},
    "mckibben-report": {"Bitstream-Vera"},
}
# Crates that nobody maintains any more, and how they come here; off the list when they are gone.
UNMAINTAINED = {
    "paste": "RUSTSEC-2024-0436: a macro without run time, through nalgebra and its simba",
    "ttf-parser": "it reads one font, which the program carries; no file of a user comes to it",
}
# Two versions at a time, until those that ask for the older one follow.
TWICE = set("getrandom miniz_oxide r-efi syn".split())


def fits(expression, allowed):
    """Whether one of the choices of a licence is open to us."""

    def word(match):
        text = match.group()
        return text.lower() if text in ("AND", "OR") else str(text in allowed)

    expression = expression.replace("/", " OR ") or "None"
    tree = re.sub(
        r"[A-Za-z0-9][A-Za-z0-9.\-]*(?: WITH [A-Za-z0-9.\-]+)?", word, expression
    )
    return eval(tree)  # only and, or, brackets, True, False


# What is built into the program on any system, without what only tests and builds need.
command = "cargo tree --locked --package mckibben-cli --edges normal --target all --prefix none --format {p}|{l}"
lines = subprocess.run(
    command.split(), check=True, capture_output=True, text=True
).stdout.split("\n")
built = {line.removesuffix(" (*)") for line in lines if line}

wrong, versions = [], {}
for package, licence in (line.split("|") for line in sorted(built)):
    name, version, *source = package.replace(" (proc-macro)", "").split(" ", 2)
    versions.setdefault(name, []).append(version)
    ours = name.startswith("mckibben")
    if source and not ours:
        wrong.append(f"{name} comes from {source[0]}")
    if not fits(licence, LICENCES | OF_OUR_DATA if ours else LICENCES):
        wrong.append(f"{name} has the licence {licence or 'none'}")
    if missing := WITH_DATA.get(name, set()) - set(re.findall(r"[\w.\-]+", licence)):
        wrong.append(
            f"{name} carries data under {' and '.join(sorted(missing))}, which its licence {licence} does not say"
        )
double = {name: v for name, v in versions.items() if len(v) > 1}
wrong += [
    f"{name} is there as {' and '.join(v)}"
    for name, v in double.items()
    if name not in TWICE
]
wrong += [
    f"{name} is no longer there twice: take it off the list"
    for name in TWICE - set(double)
]
wrong += [
    f"{name} is gone: take it off the list of what nobody maintains"
    for name in UNMAINTAINED
    if name not in versions
]
# What makes a release is what was looked at: locked, to the version, and without scripts of its own.
for path in sorted(Path(".github/workflows").glob("*.yml")):
    for number, line in enumerate(path.read_text().split("\n"), 1):
        installed = re.search(r"pip install ((?:--?[\w-]+ )*)(.*)", line)
        is_pinned = (
            installed is None
            or "-r " in installed[1]
            or re.match(r"wheels/|[\w.\-]+==\d", installed[2])
        )
        if (
            "npm install" in line
            or ("npm ci" in line and "--ignore-scripts" not in line)
            or not is_pinned
        ):
            wrong.append(
                f"{path}:{number} installs what is not pinned, or runs its scripts: {line.strip()}"
            )
print(f"{len(built)} crates, {len(double)} in two versions")
sys.exit("\n".join(wrong) if wrong else 0)
