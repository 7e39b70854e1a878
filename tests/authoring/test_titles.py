"""A title names the object and what is given, never the result or the method that the reader is to find."""

import re
from pathlib import Path

import pytest

from workbook.authoring.front_matter import read_front_matter

ROOT = Path(__file__).resolve().parents[2]
#: Results and methods; each stood in a title once.
TELLING = re.compile(
    r"singular (arc|control)|chattering|switchings|tangent law|(fixed|hidden) mode|stabilisable|limit cycle"
    r"|(observability|controllability) decomposition|uncontrollable|overdamped|fails|loses",
    re.IGNORECASE,
)


@pytest.mark.parametrize("page", sorted(ROOT.glob("solutions/ch*/p??.md")), ids=lambda p: p.stem)
def test_a_title_tells_no_result(page):
    about, _ = read_front_matter(page, page.read_text(encoding="utf-8"))
    assert not TELLING.search(about["title"]), about["title"]


@pytest.mark.parametrize(
    "title", ["Singular arc that is optimal", "Three systems and a fixed mode"]
)
def test_a_telling_title_is_found(title):
    assert TELLING.search(title)
