"""Each check says for which data it can decide, and has an example.

The examples run as those of all modules do; they suppose `import sympy as sp` and `from workbook import
checks`.
"""

from pathlib import Path

from case import CHECKS, check_named

#: Checks that do not yet say so. The list only becomes shorter.
UNDESCRIBED = Path(__file__).with_name("undescribed_checks.txt").read_text("utf-8").split()


def is_described(name):
    docstring = check_named(name).__doc__
    return "    Can decide " in docstring and "    Examples\n    --------\n" in docstring


def test_an_example_shows_more_than_one_verdict_of_its_check():
    calls = {
        name: check_named(name).__doc__.count(f"checks.{name}(")
        for name in CHECKS
        if is_described(name)
    }
    assert len(calls) > 150 and not [name for name, count in calls.items() if count < 2]


def test_the_checks_without_a_description_become_fewer():
    undescribed = {name for name in CHECKS if not is_described(name)}
    assert undescribed == set(UNDESCRIBED)
    assert len(UNDESCRIBED) <= 48
