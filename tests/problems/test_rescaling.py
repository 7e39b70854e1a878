"""No verdict depends on the units of a problem or on a constant in its cost.

The references and wrong trials of some problems of chapter 5 are judged in other units.
"""

import pytest
from harness import JudgedProblem, solve
from rescaling import CHANGES, RULES, NoRule, rescaled
from test_masters import PATHS

from workbook import checks
from workbook.authoring import read
from workbook.notebooks.execution import in_child

pytestmark = pytest.mark.slow
#: Problems of several kinds: a transfer with a formula, a bounded control with a singular arc, a
#: fixed end without bounds, a free duration, a greatest cost.
SAMPLE = {"5.3", "5.18", "5.23", "5.24"}


def _verdicts(master, answers):
    """Return [answer, change of units, role, status] of each answer that a rule rescales."""
    problem, found = JudgedProblem(master, answers), []
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
        for change, units in CHANGES.items():
            for status, value in values:
                try:
                    answer, arguments = rescaled(check, value, data, options, units)
                except NoRule:
                    continue
                verdict = getattr(checks, check)(answer, **arguments)
                found.append([name, change, status, verdict.status])
    return found


@pytest.mark.parametrize(
    "path", [p for p in PATHS if read(p).number in SAMPLE], ids=lambda path: path.stem
)
def test_no_verdict_depends_on_units(path):
    master = read(path)
    found = in_child(
        _verdicts, master, in_child(solve, master, timeout=120)["answers"], timeout=300
    )
    assert len(found) > 20
    assert [row for row in found if row[2] != row[3]] == []
