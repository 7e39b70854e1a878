"""The cost of tests is summed by layer and by problem, each test once."""

import importlib.util
import re
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "suite_cost.py"
CASES = [
    ("tests.problems.test_masters", "test_a[1.2]", {"": 7.0}),
    ("tests.problems.test_exercises", "test_b[1.2]", {"": 1.0}),
    ("tests.problems.test_masters", "test_a[1.10]", {"": 2.0}),
    ("tests.checks.test_cases", "test_case[loops: 2.5]", {"": 0.5}),
    (
        "tests.site.test_every_page",
        "test_fits[1.10-full]",
        {"": 30.0, " of a build": 20.0, " of a browser": 4.0, " in Chromium": 2.5},
    ),
    ("tests.library.test_riccati", "test_c", {"": 1.5}),
    ("tests.live.test_polls", "test_d", {"": 2.5}),
    ("trajlib.stability.hurwitz", "trajlib.stability.hurwitz.minors", {"": 0.25}),
]


@pytest.fixture
def printed(tmp_path, capsys):
    spec = importlib.util.spec_from_file_location("suite_cost", SCRIPT)
    suite_cost = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(suite_cost)
    suite_cost.pages = lambda since: {"1.2": 3.0}
    cases = "".join(
        f'<testcase classname="{module}" name="{name}"><properties>'
        + "".join(
            f'<property name="core seconds{what}" value="{seconds}"/>'
            for what, seconds in noted.items()
        )
        + "</properties></testcase>"
        for module, name, noted in CASES
    )
    (tmp_path / "all.xml").write_text(
        f'<testsuites><testsuite timestamp="2026-01-01T00:00:00">{cases}</testsuite></testsuites>'
    )
    suite_cost.main(tmp_path / "all.xml")
    return capsys.readouterr().out.splitlines()


def test_a_layer_has_its_tests_and_separately_noted_costs(printed):
    lines = [re.fullmatch(r"(\D+?) +(\d+ +)?([\d.]+) +\d+%", text) for text in printed]
    assert {match[1]: float(match[3]) for match in lines if match} == {
        "proofs": 9,
        "exercises": 1,
        "cases of the checks": 0.5,
        "doctests": 0.2,
        "tests/library": 1.5,
        "tests/live": 2.5,
        "site in the browser": 10,
        "site builds": 17,
        "pages executed": 3,
    }


def test_a_problem_has_its_proof_its_page_and_its_share_of_builds(printed):
    costs = {
        words[0]: [float(word) for word in words[1:]]
        for words in map(str.split, printed)
        if len(words) == 7 and words[0] in ("1.2", "1.10")
    }
    # The build of 20 less the page, halved; the visit of 1.10 is 6, and 2.5 in Chromium.
    assert costs == {"1.2": [8, 3, 8.5, 0, 0, 19.5], "1.10": [2, 0, 8.5, 8.5, 0, 19]}


def test_the_costliest_problems_are_named_with_their_largest_part(printed):
    lines = [" ".join(text.split()) for text in printed]
    assert "2 of 2 problems cost more than 6 core-seconds; the costliest:" in lines
    assert "1.2 19.5, 3.2 times the bar, of which built 8.5" in lines
