"""Every check judges records of the kinds that its docstring names, and refuses all others.

A refusal is one sentence that names the argument; data of any kind are never left unchecked.
"""

import functools
import inspect

import pytest
import sympy as sp
from case import CHECKS, check_named
from case_tables import CASES

from trajlib.pontryagin import Problem
from workbook import checks
from workbook.checks.contract.data_kinds import RECORDS
from workbook.checks.contract.verdict import UnsuitableData
from workbook.systems import (
    Coloured,
    Controlled,
    Deviations,
    FilterErrors,
    Functional,
    Linear,
    Measurements,
    Mechanical,
    Process,
    Quadratic,
    Scalar,
    Varying,
    WithError,
)

x1, x2, u, s, t = sp.symbols("x1 x2 u s t")
y = sp.Function("y")
A, B, H, UNIT = [[0, 1], [-2, -3]], [[0], [1]], [[1, 0]], [[1, 0], [0, 1]]
PROCESS = Process(A, Q=UNIT, H=H, R=1, covariance=UNIT)
MOTION, BOUNDS = {x1: x2, x2: u}, {u: (-1, 1)}
REST = {x1: -3, x2: 0}
#: One record of each kind.
ONE_OF_EACH = (
    *(Linear(A, B, H), WithError(A, B, H, S=[[0]], c=[[1]], start=[1])),
    *(Varying(A, [[sp.cos(t), 0]], t), Mechanical([[1]], [[3]], [[2]], [[1]], [[1]])),
    *(Measurements([x1 + x2], [x1, x2]), Deviations([x2, -x1], [x1, x2], {x1: 0, x2: 0})),
    *(Scalar(s**2 - s - 2, s + 1, 1, s), Controlled(MOTION, BOUNDS)),
    *(Quadratic(A, B, UNIT, 1), Functional(y(t).diff(t) ** 2, y(t), (t, 0, 1))),
    *(PROCESS, Coloured(sp.exp(-sp.Abs(t)), t), FilterErrors(PROCESS, [[1], [1]])),
    Problem(MOTION, BOUNDS, REST, [x1, x2]),
)
#: Problems with what no check takes into account.
CONSTRAINED = {
    "inequalities along the path": Problem(MOTION, BOUNDS, REST, [x1, x2], path=[x2 <= 1]),
    "inequalities at the end": Problem(MOTION, BOUNDS, REST, [x1, x2 <= 1]),
    "bounds of the control that depend on the state": Problem(
        MOTION, {u: (-1 - x2**2, 1)}, REST, [x1, x2]
    ),
}
#: The right answer of each check's table, for its own record.
RIGHT = {case.check: case for case in reversed(CASES) if case.verdict == "right"}


def arguments_of(name):
    """Return a check with a right answer, its data, and the descriptions of records among them."""
    case, check = RIGHT[name], check_named(name)
    bound = inspect.signature(check).bind(case.answer, *case.data, **dict(case.options)).arguments
    check = functools.partial(check, bound.pop(next(iter(bound))))
    described = {
        line.partition(" : ")[0].strip(): line.partition(" : ")[2]
        for line in check.func.__doc__.splitlines()
    }
    records = [n for n in bound if any(kind in described.get(n, "") for kind in RECORDS)]
    return check, bound, {n: described[n] for n in records}


WITH_RECORDS = [name for name in CHECKS if arguments_of(name)[2]]


def test_the_records_are_all_that_there_are():
    assert {type(record).__name__ for record in ONE_OF_EACH} == set(RECORDS)


@pytest.mark.parametrize("name", WITH_RECORDS)
def test_other_records_are_refused_in_one_sentence(name):
    check, bound, records = arguments_of(name)
    for argument, description in records.items():
        others = [r for r in ONE_OF_EACH if type(r).__name__ not in description]
        assert len(others) + len([k for k in RECORDS if k in description]) == len(ONE_OF_EACH)
        for other in others:
            with pytest.raises(UnsuitableData, match=rf"^{argument}: expected .*, got \w+$"):
                check(**bound | {argument: other})
        for what, problem in CONSTRAINED.items() if "Problem" in description else ():
            with pytest.raises(UnsuitableData, match=f"^{argument}: .* problem with {what}"):
                check(**bound | {argument: problem})


@pytest.mark.parametrize("name", WITH_RECORDS)
def test_records_of_the_kinds_that_are_described_are_judged(name):
    """The other data belong to another record, so that the answer is seldom right here."""
    check, bound, records = arguments_of(name)
    for argument, description in records.items():
        for record in ONE_OF_EACH:
            if type(record).__name__ in description and type(record) is not type(bound[argument]):
                try:
                    verdict = check(**bound | {argument: record})
                except UnsuitableData as refusal:
                    assert "\n" not in str(refusal) and len(str(refusal)) > 20
                else:
                    assert verdict.status != "unchecked", (argument, record, verdict.message)


k = sp.Symbol("k")
RUN = Problem({x1: x2, x2: u}, BOUNDS, REST, [x1, x2])
SYSTEM = Controlled(MOTION, BOUNDS)
PARABOLIC = Problem({x1: u}, BOUNDS, {x1: k}, running=x1**2 + u**2, duration=1)
REFUSED = [
    (checks.controllable_parameters, (k > 0, Scalar(s**2 + k, 1, 1, s), [k]), "got Scalar"),
    (
        checks.controllable_parameters,
        (k > 0, Mechanical([[0]], [[1]], [[k]], [[1]]), [k]),
        "M that has an inverse",
    ),
    (checks.controllable_parameters, (k > 0, Linear([[k]]), [k]), "without controls"),
    (checks.observable_parameters, (k > 0, Linear([[k]]), [k]), "without outputs"),
    (checks.optimal_duration, (4, CONSTRAINED["inequalities along the path"]), "along the path"),
    (checks.optimal_cost, (4, CONSTRAINED["inequalities along the path"]), "along the path"),
    (checks.optimal_control, (1, CONSTRAINED["inequalities at the end"], t), "at the end"),
    (checks.optimal_motion, ([t, t], CONSTRAINED["inequalities at the end"], t), "at the end"),
    (checks.optimal_cost, (4, PARABOLIC), "intervals of all symbols, got none of k"),
    (checks.optimal_cost, (k, PARABOLIC, [k]), r"a solution: `\{k: ...\}` with"),
    (checks.extremal_control, (1, RUN, t), "a free duration"),
    (checks.optimal_switching, (1, RUN, t), "a transfer to a line"),
    (checks.initial_arc_duration, (1, RUN, u, -1, {}), "with several controls"),
    (checks.switching_curve, (x2, SYSTEM, [x1], {x2: (-1, 1)}), "domain: .*to other values"),
    (checks.switching_curve, (x2, SYSTEM, [x1], (x2, -1, 1)), "domain: .* got tuple"),
    (checks.switching_curve, (x2, SYSTEM, {x1: 0}, {x2: sp.Interval(0, 1)}), "target: .*got dict"),
    (checks.stationary_covariance, (-sp.Rational(1, 2), Process(A=1, Q=1)), "does not hold"),
    (checks.stationary_covariance, (1, Process(A=2, Q=1, discrete=True)), "does not hold"),
]


@pytest.mark.parametrize("check, arguments, reason", REFUSED)
def test_data_that_cannot_be_judged_are_refused(check, arguments, reason):
    with pytest.raises(UnsuitableData, match=reason):
        check(*arguments)
