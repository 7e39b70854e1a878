"""Former names of checks: notebooks that were handed out before still work."""

import inspect

import pytest
import sympy as sp
from case import CHECKS

from workbook import checks
from workbook.checks.contract.former_checks import FORMER
from workbook.systems import Controlled, Linear

x, v, p = sp.symbols("x v p", real=True)
s = sp.Symbol("s")
n, k = sp.Symbol("n", integer=True), sp.Symbol("k", positive=True)
PENDULUM = [v, -k * sp.sin(x) - v], [x, v], [k]
WELL = [v, -x - k * v], [x, v], [k]
WELL_ALONE = [v, -x - v], [x, v]
mu = sp.Symbol("mu", positive=True)
UP, DOWN = sp.pi + 2 * sp.pi * n, 2 * sp.pi * n
x1, x2, u = sp.symbols("x1 x2 u", real=True)
MASS = Controlled({x1: x2, x2: u}, {u: (-1, 1)})
LINE = MASS, [x1 - x2]
PARABOLA = MASS, [x2**2 - x1], {x2: sp.Interval.open(0, 2)}, {}, x1 > x2**2
HANGING = sp.Matrix([[0, 1], [-k, -1]])
STANDING = sp.Matrix([[0, 1], [k, -1]])


@pytest.mark.parametrize(
    ("name", "right", "wrong", "data"),
    [
        ("barrier", (1 + x2**2) / 2, x2, (*LINE, {x2: sp.Interval.open(0, 1)}, {}, x1 < x2)),
        ("dispersal_curve", 13 * x2**2, 12 * x2**2, PARABOLA),
        ("delay_margin", sp.pi / 2, 1, (1 / s,)),
        ("disk_margin", 1, 2, (1 / s,)),
        ("equilibrium_angles", [UP, DOWN], [UP], (*PENDULUM, n)),
        ("equilibrium_angles_exist", True, k > 1, PENDULUM),
        ("equilibrium_exists", True, k > 1, PENDULUM),
        ("equilibrium_types", {0: "stable focus"}, {0: "saddle"}, WELL_ALONE),
        ("focus_region", k < 2, k < 3, WELL),
        ("linearisation_matrices", [HANGING, STANDING], [HANGING], (*PENDULUM, k < 2, n)),
        ("node_region", k > 2, k > 3, WELL),
        ("nullcline", k, -k, (x - k, x, [k])),
        ("possible_margins", mu <= 3, mu <= 4, (Linear([[1, 0], [0, -3]], [[1], [0]]), mu)),
        ("phase_margin", sp.pi / 2, 1, (1 / s,)),
        ("saddle_angle_condition", sp.cos(p) < 0, sp.cos(p) > 0, (*PENDULUM, p)),
        ("stable_angle_condition", sp.cos(p) > 0, sp.cos(p) < 0, (*PENDULUM, p)),
        ("stable_equilibria", [(0, 0)], [], ([v, -x - v], [x, v])),
        ("stable_equilibrium_angles", [DOWN], [UP], (*PENDULUM, n)),
        ("stable_equilibrium_values", [DOWN], [UP], (*PENDULUM, k < 2, n)),
        (
            "stationary_exists",
            k > 1,
            k > 2,
            ([k - 1 - x], [x], [k], {x: sp.Interval.open(0, sp.oo)}),
        ),
        ("stationary_linearisation", [[0, 1], [-1, -k]], [[0, 1], [1, -k]], WELL),
        ("stationary_points", [0, 0], [0, 1], (*WELL, {x: sp.Interval(-1, 1)}, [x, v])),
        ("stationary_stability", "asymptotically stable", "unstable", WELL),
        ("stationary_type", "saddle", "centre", ([v, k * x], [x, v], [k])),
        ("stationary_value", 1 + k, k, (x + k, [1 - x], [x], [k])),
        ("unique_equilibrium", p >= 0, p > 0, ([v, -x - p * x**3], [x, v], [p])),
        ("unstable_equilibrium_angles", [UP], [DOWN], (*PENDULUM, n)),
        ("unstable_equilibrium_values", [UP], [DOWN], (*PENDULUM, k < 2, n)),
    ],
)
def test_a_former_name_takes_its_data_in_their_former_order(name, right, wrong, data):
    check = getattr(checks, name)
    assert check(right, *data).status == "right", check(right, *data).message
    assert check(wrong, *data).status == "wrong", check(wrong, *data).message


def test_each_former_name_has_a_present_check_with_its_data():
    assert not FORMER.keys() & set(CHECKS)
    for new, order, fixed in FORMER.values():
        assert {*order.split(), *fixed} <= inspect.signature(getattr(checks, new)).parameters.keys()
