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
PAGES = [path for path in FILES if "{code-cell}" in path.read_text(encoding="utf-8")]


def test_lines_of_code_cells():
    too_long = []
    for path in PAGES:
        cells = CELL.findall(path.read_text(encoding="utf-8"))
        assert cells, path
        too_long += [
            (path.relative_to(ROOT).as_posix(), line)
            for _, cell in cells
            for line in cell.splitlines()
            if len(line) > 79
        ]
    assert len(PAGES) > 250
    assert too_long == []
