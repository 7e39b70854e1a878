"""What closed forms say of reachable sets, against the sets that support functions and motions
give."""

import numpy as np
import pytest
import sympy as sp

from trajlib.pontryagin import Problem
from workbook.checks.references.optima import reach
from workbook.checks.references.optima.linear_plant import Plant
from workbook.checks.references.optima.transfer_optima import Transfer

x1, x2, u, t = sp.symbols("x1 x2 u t", real=True)
STATE = [x1, x2]
HALF = sp.Rational(1, 2)


@pytest.mark.parametrize(
    "field, bounds",
    [
        ([x2, u], (-1, 1)),
        ([x2, u], (0, 1)),
        ([x2, u], (HALF, 2)),
        ([x2, u], (-3, 0)),
        ([x2, u], (-2, -HALF)),
        ([2 * x1 - 4 * x2 + 2 * u, x1 - 2 * x2 + 2 * u], (0, 2)),
        ([x2, u + x1], (-1, 1)),
        ([x2, u + x1], (-HALF, 2)),
        ([x2, u + x2], (-1, 1)),
        ([x2, u - x2], (-1, 1)),
        ([x2, u - x1], (-1, 1)),
        ([x1 + u, x2 - 3 * x2 + u], (-1, 2)),
    ],
)
def test_starts_that_can_be_brought_to_the_origin(field, bounds):
    plant = sp.Matrix(field)
    said = reach.to_origin(
        plant.jacobian(STATE), plant.diff(u), list(map(sp.sympify, bounds)), STATE
    )
    back = Plant([-f for f in field], STATE, u, bounds)
    random, claim = np.random.default_rng(3), sp.lambdify(STATE, said)
    angles = np.linspace(0, 2 * np.pi, 361)[:-1]
    normals = np.column_stack([np.cos(angles), np.sin(angles)])
    # Time running back, the sets of a double integrator with pushes to one side do not grow: all
    # times are looked at.
    times = np.geomspace(0.05, 40, 300)
    rest, long = bounds[0] <= 0 <= bounds[1], 25.0 if any(plant.jacobian(STATE) ** 2) else 4000.0
    support = np.array(
        [back.extreme(normals, np.full(360, T), 1) for T in ([long] if rest else times)]
    )
    inside = outside = 0
    for point in random.normal(size=(500, 2)) * np.array([0.5, 1.5, 4])[np.arange(500) % 3, None]:
        margin = (support - normals @ point).min(axis=1).max()
        if abs(margin) < 0.05 * (1 + np.linalg.norm(point)):
            continue
        holds = bool(claim(*point))
        assert holds == (margin > 0), (point, margin)
        inside, outside = inside + holds, outside + (not holds)
    assert inside >= 5 and (said == sp.true or outside > 10)


@pytest.mark.parametrize(
    "field, bounds",
    [
        ([x1 + u, x2 + u], (-1, 1)),
        ([x1 + u, 2 * x2 + u], (-1, 1)),
        ([x2, u + x1], (0, 1)),
        ([x1 - x2 + u, x1 + x2], (-1, 1)),
    ],
)
def test_where_no_closed_form_is_known_none_is_given(field, bounds):
    plant = sp.Matrix(field)
    assert (
        reach.to_origin(plant.jacobian(STATE), plant.diff(u), list(map(sp.sympify, bounds)), STATE)
        is None
    )


@pytest.mark.parametrize(
    "rate, bounds", [(x1 + u, (-1, 1)), (u, (-1, 2)), (2 - x1 + u, (-1, 1)), (u - x1, (HALF, 3))]
)
def test_transfers_on_a_line(rate, bounds):
    a, b = sp.symbols("a b", real=True)
    transfer = Transfer(Problem({x1: rate}, {u: bounds}, {x1: a}, [x1 - b]), [a, b])
    said, found = transfer.solvable_condition(), set()
    for start in np.arange(-3.3, 3.4, 0.6):
        for end in np.arange(-2.9, 3.4, 0.6):
            values = {a: sp.Rational(start), b: sp.Rational(end)}
            assert bool(said.subs(values)) == transfer.solvable(values)
            found.add(transfer.solvable(values))
    assert found == {True, False} or rate == u


@pytest.mark.parametrize("line", [x1, x2, x1 + x2 - 1])
def test_how_far_beyond_a_line_the_farthest_states_lie(line):
    plant = sp.Matrix([x2, u])
    bounds = (-1, 2)
    beyond = reach.beyond_line(
        plant.jacobian(STATE), plant.diff(u), list(map(sp.sympify, bounds)), STATE, line, t
    )
    numeric, normal = (
        Plant(plant, STATE, u, bounds),
        np.array([float(line.coeff(x)) for x in STATE]),
    )
    level = float(line.subs({x1: 0, x2: 0}))
    for point in ((1.5, -2.0), (-0.5, 0.25)):
        for time in (0.5, 3.0):
            moved = numeric.exponential(time) @ np.array(point)
            for sign, said in zip((1, -1), beyond):
                far = numeric.extreme(sign * normal[None], np.array([time]), 1)[0]
                true = sign * (normal @ moved + level) + far
                assert float(said.subs({x1: point[0], x2: point[1], t: time})) == pytest.approx(
                    true
                )


def test_beyond_a_line_a_control_that_switches_is_left_to_samples():
    plant = sp.Matrix([x2, u])
    given = plant.jacobian(STATE), plant.diff(u), [sp.Integer(-1), sp.Integer(1)], STATE
    assert reach.beyond_line(*given, x1 - x2, t) is None
    assert reach.beyond_line(sp.Matrix([[0, 1], [1, 0]]), *given[1:], x1, t) is None
