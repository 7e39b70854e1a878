import sympy as sp
from case import Case

x, y, f, s, u, w, t = sp.symbols("x y varphi s u w t", real=True)
phi, rate, psi, dpsi, at = sp.symbols("phi rate psi dpsi phi0", real=True)
n = sp.Symbol("n", integer=True)
V, g, c = sp.symbols("V g c", positive=True)
m, e = sp.symbols("m e", real=True)

# A pendulum turned by a moment m, with friction.
TURNED = ([rate, -g * sp.sin(phi) - c * rate + m], [phi, rate], [m, g, c])
PUMPED = ([rate, -g * sp.sin(phi) + e * rate], [phi, rate], [g, e])
TOP, BOTTOM = sp.pi - sp.asin(m / g), sp.asin(m / g)

CASES = [
    Case("equilibrium_angles_exist", sp.Abs(m) <= g, TURNED, "right", "by the modulus"),
    Case(
        "equilibrium_angles_exist",
        [m <= g, -sp.Symbol("g") <= sp.Symbol("m")],
        TURNED,
        "right",
        "a list, plain symbols",
    ),
    Case(
        "equilibrium_angles_exist",
        sp.Interval(-1, 1),
        ([rate, m - sp.sin(phi)], [phi, rate], [m, c]),
        "right",
        "a set of values of the first parameter",
    ),
    Case("equilibrium_angles_exist", True, PUMPED, "right", "always"),
    Case("equilibrium_angles_exist", sp.Abs(m) < g, TURNED, "wrong", "the border left out"),
    Case("equilibrium_angles_exist", m <= g, TURNED, "wrong", "one side only"),
    Case("equilibrium_angles_exist", 2 * sp.Abs(m) <= g, TURNED, "wrong", "a factor"),
    Case("equilibrium_angles_exist", ..., TURNED, "missing", "the untouched stub"),
    Case("equilibrium_angles_exist", 1, TURNED, "invalid", "a number"),
    Case(
        "equilibrium_angles",
        [BOTTOM + 2 * sp.pi * n, TOP + 2 * sp.pi * n],
        (*TURNED, n),
        "right",
        "two families",
    ),
    Case("equilibrium_angles", [BOTTOM, TOP], (*TURNED, n), "wrong", "those of one turn alone"),
    Case(
        "equilibrium_angles",
        [BOTTOM + 4 * sp.pi * n, TOP + 2 * sp.pi * n],
        (*TURNED, n),
        "wrong",
        "one in every other turn alone",
    ),
    Case(
        "equilibrium_angles",
        [BOTTOM + 4 * sp.pi * n, BOTTOM + 2 * sp.pi + 4 * sp.pi * n, TOP + 2 * sp.pi * n],
        (*TURNED, n),
        "right",
        "even turns and odd ones",
    ),
    Case(
        "equilibrium_angles", (-1) ** n * BOTTOM + sp.pi * n, (*TURNED, n), "right", "one formula"
    ),
    Case(
        "equilibrium_angles",
        sp.ImageSet(sp.Lambda(x, sp.pi * x), sp.S.Integers),
        (*PUMPED, n),
        "right",
        "a set as solveset gives it",
    ),
    Case(
        "equilibrium_angles",
        [(sp.Float(3.14159) * n, 0)],
        (*PUMPED, n),
        "right",
        "points of the phase plane, with decimals",
    ),
    Case("equilibrium_angles", [BOTTOM + 2 * sp.pi * n], (*TURNED, n), "wrong", "one family lost"),
    Case("equilibrium_angles", [BOTTOM + sp.pi * n], (*TURNED, n), "wrong", "the wrong period"),
    Case("equilibrium_angles", [sp.asin(g / m), TOP], (*TURNED, n), "wrong", "not real"),
    Case("equilibrium_angles", [], (*PUMPED, n), "wrong", "none"),
    Case("equilibrium_angles", ..., (*PUMPED, n), "missing", "the untouched stub"),
    Case("equilibrium_angles", sp.Eq(sp.sin(phi), m / g), (*TURNED, n), "invalid", "an equation"),
    Case(
        "stable_equilibrium_angles",
        [BOTTOM + 2 * sp.pi * n],
        (*TURNED, n),
        "right",
        "the lower ones",
    ),
    Case("stable_equilibrium_angles", {BOTTOM}, (*TURNED, n), "wrong", "that of one turn alone"),
    Case(
        "stable_equilibrium_angles",
        [],
        ([rate, g * sp.sin(phi) + c * rate], [phi, rate], [g, c], n),
        "right",
        "none",
    ),
    Case("stable_equilibrium_angles", [TOP], (*TURNED, n), "wrong", "the upper ones"),
    Case("stable_equilibrium_angles", [], (*TURNED, n), "wrong", "none, though there are some"),
    Case("stable_equilibrium_angles", ..., (*TURNED, n), "missing", "the untouched stub"),
    Case("stable_equilibrium_angles", "none", (*TURNED, n), "invalid", "a word"),
    Case(
        "unstable_equilibrium_angles",
        [TOP + 2 * sp.pi * n],
        (*TURNED, n),
        "right",
        "the upper ones",
    ),
    Case(
        "unstable_equilibrium_angles",
        sp.Matrix([TOP + 2 * sp.pi * n, TOP - 2 * sp.pi * n]),
        (*TURNED, n),
        "right",
        "a column, one family twice",
    ),
    Case("unstable_equilibrium_angles", [BOTTOM, TOP], (*TURNED, n), "wrong", "all of them"),
    Case("unstable_equilibrium_angles", [], (*TURNED, n), "wrong", "none"),
    Case("unstable_equilibrium_angles", ..., (*TURNED, n), "missing", "the untouched stub"),
    Case(
        "unstable_equilibrium_angles", [t], (*TURNED, n), "invalid", "a symbol of another problem"
    ),
    Case(
        "angle_linearisation",
        -g * sp.cos(at) * psi - c * dpsi,
        (*TURNED, at, [psi, dpsi]),
        "right",
        "by the angle",
    ),
    Case(
        "angle_linearisation",
        -m * sp.cot(at) * psi - c * dpsi,
        (*TURNED, at, [psi, dpsi]),
        "right",
        "a parameter eliminated by the equation of rest",
    ),
    Case(
        "angle_linearisation",
        g * sp.cos(at) * psi - c * dpsi,
        (*TURNED, at, [psi, dpsi]),
        "wrong",
        "a sign",
    ),
    Case(
        "angle_linearisation",
        -g * sp.cos(at) * psi,
        (*TURNED, at, [psi, dpsi]),
        "wrong",
        "the friction lost",
    ),
    Case(
        "angle_linearisation",
        -g * sp.cos(at) * psi - c * dpsi + m,
        (*TURNED, at, [psi, dpsi]),
        "wrong",
        "the moment kept",
    ),
    Case("angle_linearisation", ..., (*TURNED, at, [psi, dpsi]), "missing", "the untouched stub"),
    Case(
        "angle_linearisation",
        -g * sp.sin(at + psi) - c * dpsi + m,
        (*TURNED, at, [psi, dpsi]),
        "invalid",
        "not linear",
    ),
    Case(
        "stable_angle_condition",
        sp.cos(at) > 0,
        (*TURNED, at),
        "right",
        "the lower half of the circle",
    ),
    Case(
        "stable_angle_condition",
        sp.sin(at) ** 2 < sp.cos(at) * sp.Abs(sp.cos(at)) + sp.sin(at) ** 2,
        (*TURNED, at),
        "right",
        "in a clumsy way",
    ),
    Case(
        "stable_angle_condition", sp.cos(at) >= 0, (*TURNED, at), "wrong", "the border counted in"
    ),
    Case("stable_angle_condition", sp.cos(at) < 0, (*TURNED, at), "wrong", "the upper half"),
    Case(
        "stable_angle_condition",
        sp.cos(at) > sp.Rational(1, 20),
        (*TURNED, at),
        "wrong",
        "a little too few",
    ),
    Case("stable_angle_condition", ..., (*TURNED, at), "missing", "the untouched stub"),
    Case("stable_angle_condition", sp.cos(at), (*TURNED, at), "invalid", "an expression"),
    Case(
        "saddle_angle_condition",
        sp.cos(at) < 0,
        (*TURNED, at),
        "right",
        "the upper half of the circle",
    ),
    Case("saddle_angle_condition", sp.Not(sp.cos(at) >= 0), (*TURNED, at), "right", "a negation"),
    Case(
        "saddle_angle_condition", sp.cos(at) <= 0, (*TURNED, at), "wrong", "the border counted in"
    ),
    Case("saddle_angle_condition", sp.sin(at) < 0, (*TURNED, at), "wrong", "the sine"),
    Case("saddle_angle_condition", ..., (*TURNED, at), "missing", "the untouched stub"),
    Case("saddle_angle_condition", 2, (*TURNED, at), "invalid", "a number"),
    Case("focus_region", c**4 < 16 * (g**2 - m**2), TURNED, "right", "squared"),
    Case(
        "focus_region",
        sp.And(sp.Abs(m) < g, c**2 <= 4 * sp.sqrt(g**2 - m**2)),
        TURNED,
        "right",
        "with a root, the border counted in",
    ),
    Case("focus_region", c**2 < 4 * g, TURNED, "wrong", "the moment forgotten"),
    Case("focus_region", c**4 < 4 * (g**2 - m**2), TURNED, "wrong", "a factor"),
    Case("focus_region", ..., TURNED, "missing", "the untouched stub"),
    Case("focus_region", "focus", TURNED, "invalid", "a word"),
    Case("node_region", c**4 >= 16 * (g**2 - m**2), TURNED, "right", "squared"),
    Case(
        "node_region",
        sp.Abs(e) > 2 * sp.sqrt(g),
        PUMPED,
        "right",
        "whatever the sign of the friction",
    ),
    Case("node_region", c**4 < 16 * (g**2 - m**2), TURNED, "wrong", "the foci"),
    Case("node_region", e > 2 * sp.sqrt(g), PUMPED, "wrong", "one sign only"),
    Case("node_region", ..., TURNED, "missing", "the untouched stub"),
    Case("node_region", g, TURNED, "invalid", "an expression"),
]
LIMITS = [
    "Stationary angles are sought from the signs on a grid of one degree: pairs closer together "
    "than this are overlooked.",
    "A condition that names an angle beside its sines and cosines is compared at sample angles.",
]
