#!/usr/bin/env python3
"""Lines of code against the limits of checks/size.toml.

    python3 checks/size.py            the table; exit 1 where a number is above its limit
    python3 checks/size.py --lower    write lower limits where a number is below its limit

A line of code is a line that rustfmt leaves, without comments and blank lines. Tests are files in tests/, examples/ and benches/, files that only
`#[cfg(test)]` declares, and items under `#[cfg(test)]`. Tokens are printed so that a shorter file of longer lines is seen; they have no limit.
A limit rises only in a commit of its own that names the issue which grants it.
"""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LIMITS = ROOT / "checks/size.toml"
# Comments, strings, characters and lifetimes of Rust: what must not be read as code or as braces.
LEXEMES = re.compile(
    r"//[^\n]*|/\*.*?\*/|b?r(#*)\".*?\"\1|b?\"(?:\\.|[^\"\\])*\"|b?'(?:\\[^\n]+?|[^\\'\n])'|'\w+",
    re.DOTALL,
)


def blanked(source):
    """Comments as spaces, strings as text without braces; lines stay where they are."""

    def replaced(found):
        text = found[0]
        fill = " " if text.startswith(("//", "/*")) else "s"
        return re.sub(r"[^\n]", fill, text)

    return LEXEMES.sub(replaced, source)


def test_lines(code):
    """Numbers of the lines under `#[cfg(test)]`, and names of the modules in other files that it declares."""
    lines, modules = set(), []
    for found in re.finditer(r"#\[cfg\(test\)\]\s*(?:#\[[^\n]*\]\s*)*", code):
        at = end = found.end()
        depth = 0
        while end < len(code) and not (depth == 0 and code[end] in ";}"):
            depth += {"{": 1, "}": -1}.get(code[end], 0)
            if depth == 0 and code[end] in "};":
                break
            end += 1
        declared = re.match(r"(?:pub(?:\([^)]*\))?\s+)?mod\s+(\w+)\s*;", code[at:])
        if declared:
            modules.append(declared[1])
        first, last = code.count("\n", 0, found.start()), code.count("\n", 0, end)
        lines.update(range(first, last + 1))
    return lines, modules


def rust(paths):
    """For each file: lines of code, lines of tests, all lines, tokens."""
    sources = {path: (ROOT / path).read_text() for path in paths}
    codes = {path: blanked(source) for path, source in sources.items()}
    marked = {path: test_lines(code) for path, code in codes.items()}
    tests = set()
    for path, (_, modules) in marked.items():
        here = Path(path)
        folder = (
            here.parent if here.stem in ("mod", "lib", "main") else here.with_suffix("")
        )
        tests.update(str(folder / name) for name in modules)
    counts = {}
    for path, code in codes.items():
        only_tests = re.search(r"(^|/)(tests|examples|benches)/", path) or any(
            path == f"{module}.rs" or path.startswith(f"{module}/") for module in tests
        )
        lines = [number for number, line in enumerate(code.split("\n")) if line.strip()]
        in_tests = (
            len(lines)
            if only_tests
            else sum(number in marked[path][0] for number in lines)
        )
        counts[path] = (
            len(lines) - in_tests,
            in_tests,
            sources[path].count("\n"),
            len(re.findall(r"\w+|[^\w\s]", code)),
        )
    return counts


def filled(paths):
    """Lines that are not blank."""
    return sum(
        bool(line.strip())
        for path in paths
        for line in (ROOT / path).read_text().split("\n")
    )


def measured():
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.split("\n")
    listed = [path for path in listed if path and (ROOT / path).is_file()]
    counts = rust([path for path in listed if path.endswith(".rs")])
    numbers, tokens = {}, 0
    for path, (code, tests, _, words) in counts.items():
        parts = path.split("/")
        crate = parts[1] if parts[0] == "crates" else parts[0]
        row = numbers.setdefault(crate, {"code": 0, "tests": 0})
        row["code"] += code
        row["tests"] += tests
        tokens += words
    flags = 0
    for path in counts:
        if path.startswith("crates/mckibben-cli/src/"):
            flags += len(
                re.findall(r"^\s*#\[arg\(", (ROOT / path).read_text(), re.MULTILINE)
            )
    tree = {
        "rust_all": sum(lines for _, _, lines, _ in counts.values()),
        "rust_code": sum(code for code, _, _, _ in counts.values()),
        "rust_tests": sum(tests for _, tests, _, _ in counts.values()),
        "contract": filled(["docs/contract.txt"]),
        "flags": flags,
        # What python/write.py makes is no line by hand.
        "python": sum(
            (ROOT / path).read_text().count("\n")
            for path in listed
            if re.fullmatch(r"python/mckibben/(?!_api\.py).*\.py", path)
        ),
        "page": filled(
            [
                path
                for path in listed
                if re.fullmatch(r"web/page/.*\.(js|html|css)", path)
            ]
        ),
    }
    return {"tree": tree, **dict(sorted(numbers.items()))}, tokens


def written(limits):
    text = "# Limits of lines, counted by checks/size.py. They only fall: `python3 checks/size.py --lower`.\n"
    for table, row in limits.items():
        text += f"\n[{table}]\n" + "".join(
            f"{key} = {value}\n" for key, value in row.items()
        )
    return text


def main():
    numbers, tokens = measured()
    limits = tomllib.loads(LIMITS.read_text()) if LIMITS.exists() else numbers
    over = 0
    print(f"{'':<20} {'':<11} {'lines':>8} {'limit':>8}")
    for table, row in numbers.items():
        for key, value in row.items():
            limit = limits.get(table, {}).get(key, 0)
            above = f"  {value - limit} above the limit" if value > limit else ""
            over += bool(above)
            print(f"{table:<20} {key:<11} {value:>8} {limit:>8}{above}")
    print(f"{'tree':<20} {'tokens':<11} {tokens:>8}")
    if "--lower" in sys.argv:
        lower = {
            table: {
                key: min(value, limits.get(table, {}).get(key, value))
                for key, value in row.items()
            }
            for table, row in numbers.items()
        }
        LIMITS.write_text(written(lower))
    elif over:
        sys.exit(
            f"{over} of the numbers are above their limits in checks/size.toml: remove lines, or ask for an issue that grants them"
        )


if __name__ == "__main__":
    main()
