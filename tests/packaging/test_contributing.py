"""The table "Where is ...?" of CONTRIBUTING.md: each place exists and names what it is."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
ROWS = re.findall(
    r"^\| ([\w ]+) \| `([\w/.]+)` \|$", (ROOT / "CONTRIBUTING.md").read_text("utf-8"), re.M
)


def test_the_table_is_found():
    assert len(ROWS) == 15


@pytest.mark.parametrize(("what", "where"), ROWS)
def test_one_grep_finds_the_place(what, where):
    words = [
        word for word in what.lower().split() if word not in ("of", "text", "solver", "import")
    ]
    head = (ast.get_docstring(ast.parse((ROOT / where).read_text("utf-8"))) or "").lower()
    assert all(word.rstrip("s") in where + " " + head for word in words), head
