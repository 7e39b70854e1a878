"""All masters, read once for the tests of their texts, and what a rule finds in texts."""

from pathlib import Path

import pytest

from workbook.authoring import read_all

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def masters():
    return read_all(ROOT / "solutions")


@pytest.fixture(scope="session")
def lint():
    """Return "file:line: what" for each (position, what) that `rule(text, name)` yields of a file."""

    def findings(rule, paths):
        found = []
        for path in paths:
            text, name = path.read_text(encoding="utf-8"), path.relative_to(ROOT).as_posix()
            found += [
                f"{name}:{text.count(chr(10), 0, position) + 1}: {what}"
                for position, what in rule(text, name)
            ]
        return found

    return findings
