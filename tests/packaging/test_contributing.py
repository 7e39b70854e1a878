"""What is said of places and packages: each place exists, and the picture has the layers."""

import ast
import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
ROWS = re.findall(
    r"^\| ([\w ]+) \| `([\w/.]+)` \|$", (ROOT / "CONTRIBUTING.md").read_text("utf-8"), re.M
)


def test_the_table_is_found():
    assert len(ROWS) == 16


@pytest.mark.parametrize(("what", "where"), ROWS)
def test_one_grep_finds_the_place(what, where):
    words = [
        word for word in what.lower().split() if word not in ("of", "text", "solver", "import")
    ]
    head = (ast.get_docstring(ast.parse((ROOT / where).read_text("utf-8"))) or "").lower()
    assert all(word.rstrip("s") in where + " " + head for word in words), head


def test_the_places_of_the_contributors_guide_exist():
    """In a row the names after the first lie beside it."""
    guide = (ROOT / "book" / "guides" / "contributor.md").read_text("utf-8")
    rows = re.findall(r"^\| (`[^|]+) \|", guide.partition("## A new problem")[0], re.M)
    assert len(rows) > 18
    for row in rows:
        first, *others = re.findall(r"`([^`]+)`", row)
        beside = (ROOT / first).parent if first.count("/") > 1 or "." in first else ROOT
        assert (ROOT / first).exists(), first
        assert all((beside / other).exists() for other in others), row


BUILT = (ROOT / "book" / "guides" / "how_it_is_built.md").read_text("utf-8")


def test_the_places_of_how_it_is_built_exist():
    """A name without a folder lies beside the one before it, or in its package."""
    text, folder = BUILT.rpartition("```\n")[2], ROOT
    names = re.findall(r"`([\w/]+(?:/|\.py|\.md|\.ipynb))`", text)
    assert len(names) > 20
    for name in names:
        path = next(base / name for base in (ROOT, folder, folder.parent) if (base / name).exists())
        folder = path.parent


def test_the_picture_has_the_layers_of_the_contract():
    tables = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"]
    [contract] = [c for c in tables["contracts"] if c["name"] == "The course machinery in layers"]
    layers = [
        {name.strip().removeprefix("workbook.") for name in re.split("[:|]", layer)}
        for layer in contract["layers"]
    ]
    drawn = ast.literal_eval(re.search(r"^layers = (.*?^\])$", BUILT, re.M | re.S)[1])
    assert [set(names) - {"book"} for names, _ in drawn] == layers
