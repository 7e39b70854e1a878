"""No verdict depends on the units of a problem or on a constant in its cost.

The references and wrong trials of problems of chapter 5 are judged in other units: of some problems
in `make test`, of all of them, in all units, where WORKBOOK_ALL_PROBLEMS is set (`make test-units`).
"""

import os

import pytest
from harness import solve
from rescaling import CHANGES, NoRule
from rescaling_rules import RULES, rescaled
from test_masters import PATHS

from workbook import checks
from workbook.authoring import read_master
from workbook.authoring.judged_problem import JudgedProblem, call_nodes
from workbook.notebooks.execution import in_child

pytestmark = pytest.mark.slow
CHAPTER = {f"5.{int(path.stem[1:])}": path for path in PATHS if path.parent.name == "ch5"}
#: Problems of several kinds, each with the changes of units by which it is judged in `make test`.
SAMPLE = {
    "5.1": ("cost * 1e9",),  # a transfer in least time
    "5.11": ("time * 1e4",),  # the state of the harmonic oscillator meets a line
    "5.18": ("cost * 1e-9", "length * 1e6"),  # a bounded control with a singular arc
    "5.21": ("time * 1e4",),  # a functional, the duration of which is asked for
    "5.23": ("cost + 1000",),  # a fixed end without bounds
    "5.27": ("cost * 1e-9", "length * 1e-6"),  # extrema of functionals
    "5.37": ("time * 1e-4", "length * 1e6"),  # the maximum principle, an angle as the control
    "5.48": ("cost * 1e-9",),  # a family of singular controls
    "5.57": ("length * 1e6",),  # several controls
    "5.59": ("cost * 1e9", "length * 1e-6"),  # singular arcs
}
#: Checks of chapter 5 that no rule rescales, and why.
NOT_RESCALED = {
    "controllability_matrix": "no cost, no time: a question of chapter 2",
    "controllable_parameters": "no cost, no time: a question of chapter 2",
    "uncontrollable_combinations": "no cost, no time: a question of chapter 2",
    "observable": "no cost, no time: a question of chapter 2",
    "output_gramian": "no cost: a question of chapter 2",
    "equilibrium_value": "its expression is a quotient of rates, with units of its own",
    "polar_angle_rate": "the direction of a state has no meaning for states in different units",
}


def test_each_check_of_the_chapter_has_a_rule_or_a_reason():
    asked = {
        check.func.attr
        for path in CHAPTER.values()
        for source in read_master(path).code("check")
        for check in call_nodes(source).values()
    }
    assert asked == (RULES.keys() | NOT_RESCALED.keys()) & asked
    assert not NOT_RESCALED.keys() & RULES.keys() and not NOT_RESCALED.keys() - asked


def _verdicts(master, answers, changes):
    """Return [answer, change of units, role, status] of each answer that a rule rescales."""
    problem, rows = JudgedProblem(master, answers), []
    for name in problem.calls:
        check, data, options = problem.check_arguments(name)
        if check not in RULES:
            continue
        values = [("right", problem.reference[name])]
        values += [
            ("wrong", problem.after(trial.source)[name])
            for trial in master.trials["wrong"]
            if trial.name == name
        ]
        for change in changes:
            for status, value in values:
                try:
                    answer, arguments = rescaled(check, value, data, options, CHANGES[change])
                except NoRule:
                    continue
                verdict = getattr(checks, check)(answer, **arguments)
                rows.append([name, change, status, verdict.status])
    return rows


@pytest.mark.parametrize(
    "number", CHAPTER if os.environ.get("WORKBOOK_ALL_PROBLEMS") else SAMPLE, ids="[{}]".format
)
def test_no_verdict_depends_on_units(number):
    master = read_master(CHAPTER[number])
    changes = CHANGES if os.environ.get("WORKBOOK_ALL_PROBLEMS") else SAMPLE[number]
    answers = in_child(solve, master, timeout=120)["answers"]
    rows = in_child(_verdicts, master, answers, tuple(changes), timeout=600)
    assert [row for row in rows if row[2] != row[3]] == []
    assert rows or number not in SAMPLE
