"""Without z3 conditions are decided by cells, and z3 agrees: thin sets, nested roots, poles, unions."""

import sys

import pytest
import sympy as sp

from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.conditions import Case, ReferenceCondition, compare, exactly
from workbook.checks.tools.conditions.decomposition import Cell, Decomposition
from workbook.checks.tools.conditions.real_roots import cells_of_line

x, y, z = sp.symbols("x y z", real=True)
p, q = sp.symbols("p q", positive=True)
angle = sp.Symbol("alpha", real=True)
And, Or, Ne, Eq, Not, Abs, sqrt = sp.And, sp.Or, sp.Ne, sp.Eq, sp.Not, sp.Abs, sp.sqrt

#: Each condition with others that mean the same, and others that do not.
#: Where the first is undefined either is accepted.
ROWS = [
    # one variable: thin sets, irrational values, strictness
    (x**2 < 2, [Abs(x) < sqrt(2)], [x**2 <= 2, And(x**2 < 2, Ne(x, 1)), x < sqrt(2)]),
    (Ne(x**2, 2), [Or(x**2 < 2, x**2 > 2)], [Ne(x, sqrt(2)), sp.true, And(Ne(x**2, 2), Ne(x, 7))]),
    (Ne(x**3 - x, 1), [Not(Eq(x**3, x + 1))], [sp.true, Ne(x**6, (x + 1) ** 2)]),
    (x**5 - x > 1, [x * (x**4 - 1) > 1], [x**5 - x >= 1, x > sp.Rational(7, 6)]),
    (Eq(x, 0), [Eq(x**2, 0), Abs(x) <= 0], [Eq(x**3, x), sp.false]),
    # poles
    (1 / x > 1, [And(x > 0, x < 1)], [x < 1, And(x > 0, x <= 1)]),
    ((x**2 - 1) / (x - 1) > 0, [And(x > -1, Ne(x, 1)), x > -1], [x >= -1, And(x > -1, Ne(x, 3))]),
    (Ne(1 / (x - 2), 1), [And(Ne(x, 2), Ne(x, 3)), Ne(x, 3)], [Ne(x, 2), And(Ne(x, 3), Ne(x, 1))]),
    # absolute values and unions
    (Or(x < -1, x > 1), [Abs(x) > 1, x**2 > 1], [Abs(x) >= 1, Or(x < -1, x > 1, Eq(x, 0))]),
    (Abs(Abs(x) - 2) < 1, [Or(And(x > 1, x < 3), And(x < -1, x > -3))], [Abs(x - 2) < 1]),
    (sp.Max(x, -x, 1) > 1, [x**2 > 1], [Abs(x) > 0]),
    # nested roots
    (sqrt(x) < 2, [And(x >= 0, x < 4), x < 4], [x <= 4, And(x > 0, x < 4)]),
    (x < sqrt(1 + sqrt(3)), [Or(x < 0, x**4 - 2 * x**2 < 2)], [x <= sqrt(1 + sqrt(3)), x**4 - 2 * x**2 < 2]),
    (sqrt(x + sqrt(x)) > 1, [2 * x > 3 - sqrt(5)], [x > sp.Rational(38, 100), 2 * x >= 3 - sqrt(5)]),
    # two variables: curves, points, borders
    (x**2 + y**2 < 1, [Abs(y) < sqrt(1 - x**2)], [x**2 + y**2 <= 1, Or(x**2 + y**2 < 1, Eq(x - 2, y) & Eq(y, 0))]),
    (Or(Ne(x, 1), Ne(y, 2)), [(x - 1) ** 2 + (y - 2) ** 2 > 0], [sp.true, Ne(x, 1), Ne((x - 1) * (y - 2), 0)]),
    (Ne(x * y, 1), [Or(Eq(x, 0), Ne(y, 1 / x))], [Ne(y, 1 / x), sp.true, And(Ne(x * y, 1), Ne(x, y))]),
    (y > x**2, [And(y > 0, Abs(x) < sqrt(y))], [y >= x**2, Or(y > x**2, Eq(y**2, 2 * x**4))]),
    (y**2 < x**3, [And(x > 0, Abs(y) < x * sqrt(x))], [y**2 <= x**3, And(y**2 < x**3, Ne(x**2 + y**2, 2))]),
    (x * y > 0, [Eq(sp.sign(x), sp.sign(y)) & Ne(x, 0)], [x * y >= 0, And(x > 0, y > 0)]),
    (Eq(y, sqrt(x)), [And(Eq(y**2, x), y >= 0)], [Eq(y**2, x), And(Eq(y**2, x), y > 0)]),
    (x / y < 1, [Or(And(y > 0, x < y), And(y < 0, x > y))], [x < y, Ne(y, 0)]),
    (p > q, [p**2 > q**2, sqrt(p) > sqrt(q), 1 / p < 1 / q], [p >= q, And(p > q, Ne(p * q, 2))]),
    (Ne(p * q, 1), [Ne(p, 1 / q)], [Or(Ne(p * q, 1), Eq(p, 3)), sp.true]),
    # a square and its root
    (sqrt(x**2 - 2 * x + 1) < y, [Abs(x - 1) < y], [x - 1 < y, Abs(x - 1) <= y]),
    # three variables and more
    (And(p > 0, z > 0, p * q > z), [And(z > 0, p > z / q)], [p * q > z, And(z > 0, p * q >= z)]),
    (
        Abs(x - y) <= z,
        [And(z >= 0, (x - y) ** 2 <= z**2), And(x - y <= z, y - x <= z)],
        [Abs(x - y) < z, x - y <= z, (x - y) ** 2 <= z**2],
    ),
    (Or(Ne(x, 0), Ne(y, 0), Ne(z, 0)), [x**2 + y**2 + z**2 > 0], [Or(Ne(x, 0), Ne(y, 0)), sp.true]),
    (x * y * z > 0, [Or(And(x * y > 0, z > 0), And(x * y < 0, z < 0))], [And(x > 0, y > 0, z > 0), x * y * z >= 0]),
    (Ne(x * z, y), [Or(And(Eq(z, 0), Ne(y, 0)), And(Ne(z, 0), Ne(x, y / z)))], [Ne(x, y / z), sp.true]),
    (Eq(x**2 + y**2 + z**2, 2 * x * y), [And(Eq(x, y), Eq(z, 0))], [Eq(x, y), And(Eq(x, 0), Eq(y, 0), Eq(z, 0))]),
    # a rational number whose multiple is a border, numbers with names
    (x < sp.pi, [2 * x < 2 * sp.pi], [x <= sp.Rational(22, 7), x < sp.Rational(314159, 100000)]),
    # angles: the point pi has no tangent of its half
    (sp.cos(angle) > -1, [Ne(sp.cos(angle), -1)], [sp.true, sp.sin(angle) > -1]),
    (sp.sin(2 * angle) > 0, [sp.sin(angle) * sp.cos(angle) > 0], [sp.tan(angle) >= 0, sp.sin(angle) > 0]),
]  # fmt: skip
PAIRS = [(truth, claim, "right") for truth, rights, _ in ROWS for claim in rights]
PAIRS += [(truth, claim, "wrong") for truth, _, wrongs in ROWS for claim in wrongs]


def judged(claim, truth, parameters=None):
    """Return how the agreement is known, or the exact point where the claim is wrong."""
    symbols = parameters or sorted(truth.free_symbols | claim.free_symbols, key=str)
    reference = truth if isinstance(truth, ReferenceCondition) else exactly(truth)
    points = []

    def message(values, holds):
        points.append((values, holds))
        return "wrong"

    try:
        return compare(claim, symbols, reference, message), None
    except Wrong:
        return "wrong", points[0]


@pytest.mark.parametrize("solver", ["z3", "cells"])
@pytest.mark.parametrize("truth, claim, verdict", PAIRS, ids=str)
def test_a_condition_is_decided(truth, claim, verdict, solver, monkeypatch):
    if solver == "cells":
        monkeypatch.setitem(sys.modules, "z3", None)
    outcome, point = judged(claim, truth)
    assert outcome == ("proved for all values" if verdict == "right" else "wrong")
    if point and not truth.has(Abs, sp.sign, sp.Max, sp.cos, sp.sin, 1 / x, 1 / y):
        values, holds = point
        near = {symbol: value.evalf(40) for symbol, value in values.items()}
        off_border = all(
            abs((r.lhs - r.rhs).subs(near)) > 1e-20
            for r in truth.atoms(sp.core.relational.Relational)
        )
        assert not off_border or bool(truth.subs(values)) == holds


@pytest.mark.parametrize(
    "claim, verdict",
    [
        (Abs(x) < 2, "proved"),
        (x**2 < 4, "proved"),
        (Abs(x) <= 2, "wrong"),
        (And(Abs(x) < 2, Ne(x, 0)), "wrong"),
    ],
)
def test_what_holds_for_every_value_of_an_unknown(claim, verdict, monkeypatch):
    """y^2 + x y + 1 > 0 for all y exactly if |x| < 2."""
    monkeypatch.setitem(sys.modules, "z3", None)
    above = y**2 + x * y + 1 > 0
    truth = ReferenceCondition(
        (Case(above, (y,), every=True),),
        (Case(Not(above), (y,)),),
        lambda values: bool(values[x] ** 2 < 4),
    )
    assert judged(claim, truth, [x])[0].startswith(verdict)


def test_a_circle_meets_its_tangent_in_one_cell():
    circle, tangent = x**2 + y**2 - 1, y - 1
    space = Decomposition([circle, tangent], [x, y])
    columns = space.above(Cell())
    cells = [cell for column in columns for cell in space.above(column)]
    assert space.is_complete
    both = [cell for cell in cells if {circle, tangent} <= cell.vanishing]
    assert [[c.exact for c in cell.coordinates] for cell in both] == [[0, 1]]


def test_a_polynomial_that_vanishes_on_a_whole_line():
    """x z - y vanishes for x = y = 0 whatever z is."""
    f = x * z - y
    space = Decomposition([f], [x, y, z])
    cells = [Cell()]
    for _ in range(3):
        cells = [upper for cell in cells for upper in space.above(cell)]
    assert space.is_complete
    above_origin = [c for c in cells if [a.number for a in c.coordinates[:2]] == [0, 0]]
    assert above_origin and all(f in c.vanishing for c in above_origin)


def test_roots_and_the_intervals_between_them():
    cells = cells_of_line([sp.Poly(x**2 - 2, x), sp.Poly(x * (x**2 - 2), x), sp.Poly(3 * x - 1, x)])
    assert [c.exact for c, indices in cells if indices] == [-sqrt(2), 0, sp.Rational(1, 3), sqrt(2)]
    assert [sorted(indices) for _, indices in cells if indices] == [[0, 1], [1], [2], [0, 1]]
    numbers = [c.number for c, _ in cells]
    assert numbers == sorted(numbers) and len(cells) == 9
