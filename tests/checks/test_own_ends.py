"""A control that is a list of arcs ends by itself: what the student reads then is true of it, and
tells no cost that is the best one up to the digits shown."""

import pytest
import sympy as sp

from trajlib.pontryagin import Problem
from workbook import checks

pytestmark = pytest.mark.slow
x, v, u = sp.symbols("x v u", real=True)
t = sp.Symbol("t", positive=True)
CARRIAGE = {x: v, v: u}
#: From rest at 5/2: 1 s on the bound, 3/2 s without, 1 s on the other one; the cost is 5.
FUEL = Problem(
    CARRIAGE, {u: (-1, 1)}, {x: sp.Rational(5, 2), v: 0}, [x, v], running=1 + 3 * sp.Abs(u) / 4
)
SOONEST = Problem(CARRIAGE, {u: (-1, 1)}, {x: 1, v: 0}, [x, v])
GIVEN = Problem(CARRIAGE, {u: (-1, 1)}, {x: 0, v: 0}, [v], running=x + v, duration=2)
FAST = sp.sqrt(sp.Rational(5, 2))
#: Not what it costs, which next to the optimum is hardly more than the least cost.
BETTER = "your control keeps to the ends; there is an admissible process with the same ends that costs less"
SLOW = sp.sqrt(sp.Rational(5, 6))


@pytest.mark.parametrize(
    "problem, arcs, said",
    [
        (FUEL, [[-1, FAST], [1, 2 * FAST]], BETTER),
        (
            FUEL,
            [[-1, SLOW], [0, 3 * SLOW], [1, 4 * SLOW]],
            BETTER,
        ),
        (
            FUEL,
            [[-1, 1], [0, 2], [1, 3]],
            "the state is (0.5, 0) when your last arc ends, which is not on the target",
        ),
        (
            SOONEST,
            [[-1, sp.Rational(1, 2)], [1, 1]],
            "the state is (0.75, 0) when your last arc ends",
        ),
        (
            SOONEST,
            [[-sp.Rational(1, 2), sp.sqrt(2)], [sp.Rational(1, 2), 2 * sp.sqrt(2)]],
            BETTER,
        ),
        (GIVEN, [[-1, 1]], "your last arc ends at 1, and the process lasts longer"),
        (
            GIVEN,
            [[-1, 1], [1, 2], [0, 3], [1, 4]],
            "your last arc begins at 3, when the process should be over",
        ),
        (
            GIVEN,
            [[-1, sp.Rational(99, 100)], [0, sp.Rational(101, 100)], [1, 2]],
            BETTER,
        ),
    ],
)
def test_a_list_of_arcs_is_judged_by_where_it_ends(problem, arcs, said):
    with checks.collecting() as verdicts:
        checks.report(control=checks.optimal_control(arcs, problem, t))
    verdict = verdicts["control"]
    assert verdict.status == "wrong" and said in verdict.message


@pytest.mark.parametrize(
    "problem, arcs",
    [(SOONEST, [[-1, 1], [1, 3]]), (FUEL, [[-1, 1], [0, sp.Rational(5, 2)], [1, 9]])],
)
def test_the_last_arc_may_go_on_behind_the_end(problem, arcs):
    with checks.collecting() as verdicts:
        checks.report(control=checks.optimal_control(arcs, problem, t))
    assert verdicts["control"].status == "right"
