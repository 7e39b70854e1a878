"""Lines of code fit the site's column, a printed page and a notebook: 79 characters."""

import re
from pathlib import Path

from workbook.authoring import master_paths

ROOT = Path(__file__).resolve().parents[2]
CELL = re.compile(r"^(`{3,})\{code-cell\}[^\n]*\n(.*?)^\1[ \t]*$", re.M | re.S)
FILES = [
    *master_paths(ROOT / "solutions"),
    *sorted((ROOT / "book").glob("ch*/*.md")),
    *sorted((ROOT / "book" / "errata").glob("ch*.md")),
    ROOT / "book" / "guides" / "engineer.md",
    *sorted((ROOT / "book" / "guides" / "tutorials").glob("*.md")),
]
LONG = re.compile(r"^.{80,}$", re.M)


def long_lines(text, _):
    for cell in CELL.finditer(text):
        for line in LONG.finditer(text, *cell.span(2)):
            yield line.start(), line[0]


def test_lines_of_code_cells(lint):
    cells = [CELL.search(path.read_text(encoding="utf-8")) for path in FILES]
    assert len(list(filter(None, cells))) > 250
    assert lint(long_lines, FILES) == []
