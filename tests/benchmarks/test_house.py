"""Lines are of code or of docstrings; calls are counted here and in children."""

import importlib.util
from pathlib import Path

import pytest

from workbook.notebooks import execution

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "house.py"
SOURCE = '''"""A module.

It doubles.
"""

# Why: twice is enough.
TEXT = """
not explained"""


def twice(x):
    """Return 2 x."""
    return 2 * x  # once


def four_times(x):
    return twice(twice(x)) + sum(0 for _ in "ab")
'''


@pytest.fixture
def house():
    spec = importlib.util.spec_from_file_location("house", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def four_times(tmp_path):
    (tmp_path / "package").mkdir()
    path = tmp_path / "package" / "doubling.py"
    path.write_text(SOURCE, encoding="utf-8")
    names = {}
    exec(compile(SOURCE, path, "exec"), names)
    return names["four_times"]


def test_lines(house, tmp_path, four_times):
    assert house.lines(tmp_path / "package" / "doubling.py") == (6, 5)


def test_calls_are_counted_in_children_too(house, tmp_path, four_times):
    calls = house.Calls(tmp_path, ["package"])
    with calls.counting():
        assert four_times(1) == execution.in_child(four_times, 1, timeout=60) == 4
    assert str(calls).split() == ["6", "2", "1"]
    four_times(1)
    assert str(calls).split() == ["6", "2", "1"]
