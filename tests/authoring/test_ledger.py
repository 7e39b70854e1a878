"""The ledger says of every numbered statement of the sources where it stands, or why it does not."""

import re
import tomllib
from pathlib import Path

import pytest

from workbook.authoring import master_paths

ROOT = Path(__file__).resolve().parents[2]
LEDGER = tomllib.loads((ROOT / "book" / "source_ledger.toml").read_text(encoding="utf-8"))
PAGES = [*sorted((ROOT / "book").glob("**/*.md")), *master_paths(ROOT / "solutions")]
LABELS = {
    label
    for page in PAGES
    for found in re.findall(
        r"^[ \t]*\(([\w-]+)\)=$|^:label: ([\w-]+)$", page.read_text(encoding="utf-8"), re.M
    )
    for label in found
}
LEFT_OUT = "left out, because "
#: How the labels of numbered statements of the problem book begin.
KINDS = {"def": "definitions", "thm": "theorems", "eq": "formulas", "exm": "examples"}


def places(source):
    for kind, entries in LEDGER[source].items():
        if kind != "last":
            yield from ((f"{kind} {key}", value) for key, value in entries.items())


@pytest.mark.parametrize("source", LEDGER)
def test_every_number_up_to_the_last_has_an_entry(source):
    for kind, last in LEDGER[source]["last"].items():
        expected = {
            str(number) if part == "all" else f"{part}.{number}"
            for part, count in last.items()
            for number in range(1, count + 1)
        }
        assert {key for key in LEDGER[source][kind] if "§" not in key} == expected, kind


@pytest.mark.parametrize("source", LEDGER)
def test_places_exist_and_omissions_have_reasons(source):
    for key, value in places(source):
        if value.startswith(LEFT_OUT):
            assert len(value) > len(LEFT_OUT) + 10, key
        else:
            assert set(value.split(", ")) <= LABELS, key


def test_the_ledger_holds_all_errata_of_the_texts():
    known = {
        label for source in LEDGER for _, value in places(source) for label in value.split(", ")
    }
    for page in sorted((ROOT / "book" / "errata").glob("ch*.md")):
        texts = re.split(r"^## Problems", page.read_text(encoding="utf-8"), flags=re.M)[0]
        assert set(re.findall(r"^\((err-[\w-]+)\)=$", texts, re.M)) <= known, page.name


def test_numbered_labels_of_the_problem_book_are_in_the_ledger():
    for label in LABELS:
        parts = re.fullmatch(r"(def|thm|eq|exm)-([1-5])-(\d+)", label)
        if parts:
            number = f"{parts[2]}.{parts[3]}"
            assert number in LEDGER["problembook"][KINDS[parts[1]]], label
