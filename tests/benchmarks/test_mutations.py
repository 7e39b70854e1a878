"""Mutants differ from the function in one token, and the nearest tests run its line."""

import ast
import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "mutations.py"
SOURCE = '''"""Not 1 of these."""
LIMIT = 1

@cached(2)
def area(a, b: "1 + 1" = 3):
    """Return 1."""
    if not a < b:
        raise ValueError(f"{a + 1}")
    return norm(a @ b, -a), b
'''
MUTANTS = {
    "3  ->  4",
    "not a < b  ->  not not a < b",
    "a < b  ->  a <= b",
    "a < b  ->  a >= b",
    "return (norm(a @ b, -a), b)  ->  return (b, norm(a @ b, -a))",
    "norm(a @ b, -a)  ->  norm(-a, a @ b)",
    "a @ b  ->  b @ a",
    "-a  ->  +a",
}


@pytest.fixture(scope="module")
def mutations():
    spec = importlib.util.spec_from_file_location("mutations", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_each_token_of_a_function_is_changed_once(mutations):
    found = [
        (mutations.mutant(SOURCE, index, number), lines)
        for index, number, lines in mutations.sites(ast.parse(SOURCE))
    ]
    assert {text for (_, _, text), _ in found} == MUTANTS and len(found) == len(MUTANTS)
    plain = ast.unparse(ast.parse(SOURCE))
    assert plain not in {changed for (changed, _, _), _ in found}
    assert all(first <= line <= last for (_, line, _), (first, last) in found)


def test_the_quickest_tests_of_the_line_fill_the_budget(mutations):
    tests = [(1, "a", {"f.py:3"}), (2, "b", {"f.py:9"}), (4, "c", {"f.py:2"}), (9, "d", {"f.py:3"})]
    assert mutations.nearest(tests, "f.py", (2, 3), 10) == (["a", "c"], 5)
    assert mutations.nearest(tests, "f.py", (5, 6), 10) == ([], 0)


def test_a_loop_without_end_is_stopped(mutations):
    def endless():
        while True:
            pass

    assert mutations.in_child(endless, 1) < 0
    assert mutations.in_child(lambda: 0) == 0 and mutations.in_child(lambda: 1) == 1
