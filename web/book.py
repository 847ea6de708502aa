#!/usr/bin/env python3
"""Makes a copy of docs ready for mdBook: equations between $$ become MathML, a number stays on one line with its unit, and a file outside
of docs that a page links to comes into the book. A link that leads nowhere is an error.

    python3 web/book.py FOLDER      (needs latex2mathml)
"""

import re
import shutil
import sys
from pathlib import Path

from latex2mathml.converter import convert

DOCS = Path(__file__).resolve().parent.parent / "docs"


UNITS = "%|N|mm|bar|MPa|kPa|kg|g|s|ms|min|J|Hz|°"


def unbroken(text: str) -> str:
    """Sentences whose numbers are joined to their units and their ± by a no-break space; code stays as it is."""
    parts = re.split(r"(^```.*?^```$|`[^`\n]*`)", text, flags=re.M | re.S)
    parts[::2] = [
        re.sub(rf"(?<=\d) (?=(?:{UNITS}|±)(?!\w))|(?<=±) (?=\d)", "\u00a0", part)
        for part in parts[::2]
    ]
    return "".join(parts)


def main(book: Path) -> None:
    dead = []
    for page in sorted(book.rglob("*.md")):
        beside = page.relative_to(book).parent

        def linked(found: re.Match[str]) -> str:
            path, anchor = found[1], found[2] or ""
            if (book / beside / path).resolve().exists():
                return found[0]
            outside = (DOCS / beside / path).resolve()
            if not outside.exists():
                dead.append(f"{page.relative_to(book)}: {path}")
                return found[0]
            copied = "source" / outside.relative_to(DOCS.parent)
            # A page of the repository is read as text.
            copied = (
                copied.with_suffix(".txt")
                if copied.suffix in (".md", ".rs", ".toml", ".bib")
                else copied
            )
            (book / copied).parent.mkdir(parents=True, exist_ok=True)
            if outside.is_file():
                shutil.copy(outside, book / copied)
            else:
                listing = "\n".join(sorted(f.name for f in outside.iterdir()))
                copied = copied / "index.txt"
                (book / copied).parent.mkdir(parents=True, exist_ok=True)
                (book / copied).write_text(f"{listing}\n", "utf-8")
            return f"]({'../' * len(beside.parts)}{copied.as_posix()}{anchor})"

        text = page.read_text("utf-8")
        text = re.sub(r"\]\((?!https?:|#|mailto:)([^)#\s]+)(#[^)\s]*)?\)", linked, text)
        text = unbroken(text)
        equation = lambda m: (
            f'<div class="equation">\n{convert(m[1], display="block")}\n</div>'
        )
        page.write_text(
            re.sub(r"^\$\$(.+?)\$\$$", equation, text, flags=re.M | re.S), "utf-8"
        )
    if dead:
        raise SystemExit("links that lead nowhere:\n" + "\n".join(dead))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
