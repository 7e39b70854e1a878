"""Each check says for which data it can decide, and has an example that runs here.

Examples suppose `import sympy as sp` and `from workbook import checks`.
"""

import doctest
from pathlib import Path

import pytest
import sympy as sp
from case import CHECKS, check_named

from workbook import checks

#: Checks that do not yet say so. The list only becomes shorter.
UNDESCRIBED = Path(__file__).with_name("undescribed_checks.txt").read_text("utf-8").split()


def is_described(name):
    docstring = check_named(name).__doc__
    return "    Can decide " in docstring and "    Examples\n    --------\n" in docstring


@pytest.mark.parametrize("name", [name for name in CHECKS if is_described(name)])
def test_the_example_of_a_check_runs(name):
    names = {"sp": sp, "checks": checks}
    docstring = check_named(name).__doc__
    test = doctest.DocTestParser().get_doctest(docstring, names, name, None, 0)
    shown, runner = [], doctest.DocTestRunner(verbose=False)
    runner.run(test, out=shown.append)
    assert not runner.failures, "".join(shown)
    assert docstring.count(f"checks.{name}(") > 1


def test_the_checks_without_a_description_become_fewer():
    undescribed = {name for name in CHECKS if not is_described(name)}
    assert undescribed == set(UNDESCRIBED)
    assert len(UNDESCRIBED) <= 48
