"""Errata stand in the page of their chapter, with a cell each; other pages refer to their labels."""

import re
from pathlib import Path

import pytest

BOOK = Path(__file__).resolve().parents[2] / "book"
PAGES = sorted((BOOK / "errata").glob("ch*.md"))


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_entries_are_complete_and_in_their_chapter(path):
    entries = re.split(r"^\((err-[\w-]+)\)=\n### ", path.read_text(encoding="utf-8"), flags=re.M)
    assert len(entries) > 1 and "\n### " not in entries[0]
    for label, entry in zip(entries[1::2], entries[2::2]):
        assert label.startswith(f"err-{path.stem[2:]}-")
        assert re.findall(r"^(Printed|Right|Reason)$", entry, re.M) == [
            "Printed",
            "Right",
            "Reason",
        ], label
        assert "\n### " not in entry, label
        assert "{code-cell}" in entry, f"{label} has no cell that shows it"


def test_the_index_has_no_entry():
    assert PAGES and "(err-" not in (BOOK / "errata" / "index.md").read_text(encoding="utf-8")
