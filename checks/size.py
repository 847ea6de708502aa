#!/usr/bin/env python3
"""What a reader must understand, in tokens, against the limits of checks/size.toml.

    python3 checks/size.py            the table; exit 1 where a number is above its limit
    python3 checks/size.py --lower    write lower limits where a number is below its limit

A token is a name, a number or a sign, of code as of what a text says. Comments, documentation and a comma behind the last
entry of a list are none, so that formatting changes nothing. Tests are files in tests/, examples/ and benches/, files that only
`#[cfg(test)]` declares, and items under `#[cfg(test)]`. Lines and tests have no limit, but no literal text of Rust's code is
longer than 300 characters. A limit rises only in a commit of its own that names the issue which grants it.
"""

import io
import re
import subprocess
import sys
import tokenize
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LIMITS = ROOT / "checks/size.toml"
LONGEST_TEXT = 300
RUST_TEXT = r"b?r(#*)\".*?\"\1|b?\"(?:\\.|[^\"\\])*\""
RUST = re.compile(
    rf"//[^\n]*|/\*.*?\*/|{RUST_TEXT}|b?'(?:\\[^\n]+?|[^\\'\n])'|'\w+", re.DOTALL
)
# Behind a sign that ends no value a slash begins a pattern.
PATTERN = r"(?<=[=(,:!&|?{;])\s*/(?![/*])(?:\\.|\[(?:\\.|[^\]\n])*\]|[^/\\\n])+/\w*"
SCRIPT = re.compile(
    rf"//[^\n]*|/\*.*?\*/|<!--.*?-->|{PATTERN}|`(?:\\.|[^`\\])*`|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'",
    re.DOTALL,
)
SIGNS = re.compile(r"\w+|[^\w\s]")


def signs(code):
    """Tokens of code without comments and texts."""
    return len(SIGNS.findall(re.sub(r",(\s*[)\]}])", r"\1", code)))


def words(text):
    """Tokens of a text, for the sign that stands for it in the code."""
    return len(SIGNS.findall(text)) - 1


def split(source, lexemes):
    """Code whose texts are `s` and whose comments are blank, the texts, and their places; lines stay where they are."""
    texts = []

    def replaced(found):
        text = found[0]
        if text.startswith(("//", "/*", "<!--")):
            return re.sub(r"[^\n]", " ", text)
        if '"' in text or "`" in text or lexemes is SCRIPT:
            texts.append((found.start(), text))
        return "s" + re.sub(r"[^\n]", " ", text[1:])

    return lexemes.sub(replaced, source), texts


def under_test(code):
    """Places in the code that stand under `#[cfg(test)]`, and names of the modules in other files that it declares."""
    places, modules = [], []
    for found in re.finditer(r"#\[cfg\(test\)\]\s*(?:#\[[^\n]*\]\s*)*", code):
        end, depth = found.end(), 0
        while end < len(code) and not (depth == 0 and code[end] in ";}"):
            depth += {"{": 1, "}": -1}.get(code[end], 0)
            if depth == 0 and code[end] in "};":
                break
            end += 1
        declared = re.match(
            r"(?:pub(?:\([^)]*\))?\s+)?mod\s+(\w+)\s*;", code[found.end() :]
        )
        if declared:
            modules.append(declared[1])
        places.append((found.start(), end + 1))
    return places, modules


def rust(paths):
    """For each file: tokens of its code, tokens of its tests, words in texts of its code; and texts that are too long."""
    parts = {path: split((ROOT / path).read_text(), RUST) for path in paths}
    marked = {path: under_test(code) for path, (code, _) in parts.items()}
    tests = set()
    for path, (_, modules) in marked.items():
        here = Path(path)
        folder = (
            here.parent if here.stem in ("mod", "lib", "main") else here.with_suffix("")
        )
        tests.update(str(folder / name) for name in modules)
    counts, long = {}, []
    for path, (code, texts) in parts.items():
        only_tests = re.search(r"(^|/)(tests|examples|benches)/", path) or any(
            path == f"{module}.rs" or path.startswith(f"{module}/") for module in tests
        )
        places = [(0, len(code))] if only_tests else marked[path][0]
        is_test = lambda at: any(first <= at < last for first, last in places)
        texts_of_code = [(at, text) for at, text in texts if not is_test(at)]
        spoken = sum(words(text) for _, text in texts_of_code)
        in_tests = sum(signs(code[first:last]) for first, last in places)
        in_tests += sum(words(text) for at, text in texts if is_test(at))
        own = code
        for first, last in reversed(places):
            own = own[:first] + own[last:]
        counts[path] = (signs(own) + spoken, in_tests, spoken)
        for at, text in texts_of_code:
            if len(re.sub(r"\\\n\s*", "", text)) > LONGEST_TEXT:
                long.append(f"{path}:{code.count(chr(10), 0, at) + 1}")
    return counts, long


def script(path):
    code, texts = split((ROOT / path).read_text(), SCRIPT)
    return signs(code) + sum(words(text) for _, text in texts)


def python(path):
    """Tokens without comments and docstrings."""
    skipped = {
        tokenize.COMMENT,
        tokenize.NL,
        tokenize.NEWLINE,
        tokenize.INDENT,
        tokenize.DEDENT,
        tokenize.ENCODING,
        tokenize.ENDMARKER,
    }
    total, at_start, comma = 0, True, False
    for token in tokenize.generate_tokens(
        io.StringIO((ROOT / path).read_text()).readline
    ):
        if token.type in skipped:
            at_start |= token.type in (tokenize.NEWLINE, tokenize.INDENT)
            continue
        if token.type == tokenize.STRING:
            total += 0 if at_start else 1 + words(token.string)
        else:
            total += signs(token.string) - (comma and token.string in ")]}")
        comma, at_start = token.string == ",", False
    return total


def measured():
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.split("\n")
    listed = [path for path in listed if path and (ROOT / path).is_file()]
    counts, long = rust([path for path in listed if path.endswith(".rs")])
    crates = {}
    for path, (code, tests, _) in counts.items():
        parts = path.split("/")
        crate = parts[1] if parts[0] == "crates" else parts[0]
        row = crates.setdefault(crate, {"code": 0, "tests": 0})
        row["code"] += code
        row["tests"] += tests
    code = sum(code for code, _, _ in counts.values())
    program = sum(n for path, (n, _, _) in counts.items() if path.startswith("crates/"))
    of = lambda pattern: [path for path in listed if re.fullmatch(pattern, path)]
    tree = {
        "code": code,
        "crates": program,
        "tests": sum(tests for _, tests, _ in counts.values()),
        # What python/write.py makes is not written by hand.
        "python": sum(map(python, of(r"python/(write|mckibben/(?!_api).*)\.py"))),
        "page": sum(map(script, of(r"web/page/(?!js/vendor/).*\.(js|html|css)"))),
    }
    spoken = sum(spoken for _, _, spoken in counts.values())
    return {"tree": tree, **dict(sorted(crates.items()))}, spoken, long


def written(limits):
    text = "# Limits of tokens, counted by checks/size.py. They only fall: `python3 checks/size.py --lower`.\n"
    for table, row in limits.items():
        text += f"\n[{table}]\n" + "".join(
            f"{key} = {value}\n" for key, value in row.items()
        )
    return text


def main():
    numbers, spoken, long = measured()
    limits = tomllib.loads(LIMITS.read_text()) if LIMITS.exists() else numbers
    over = 0
    print(f"{'':<20} {'':<15} {'tokens':>8} {'limit':>8}")
    for table, row in numbers.items():
        for key, value in row.items():
            # Tests have no limit: nobody shall cut them to pass one.
            if key == "tests":
                print(f"{table:<20} {key:<15} {value:>8}")
                continue
            limit = limits.get(table, {}).get(key, 0)
            above = f"  {value - limit} above the limit" if value > limit else ""
            over += bool(above)
            print(f"{table:<20} {key:<15} {value:>8} {limit:>8}{above}")
    print(f"{'tree':<20} {'words in texts':<15} {spoken:>8}")
    if "--lower" in sys.argv:
        lower = {
            table: {
                key: min(value, limits.get(table, {}).get(key, value))
                for key, value in row.items()
                if key != "tests"
            }
            for table, row in numbers.items()
        }
        LIMITS.write_text(written(lower))
    elif over:
        sys.exit(
            f"{over} of the numbers are above their limits in checks/size.toml: "
            "simplify, or ask for an issue that grants them"
        )
    if long:
        sys.exit(f"texts above {LONGEST_TEXT} characters: {', '.join(long)}")


if __name__ == "__main__":
    main()
