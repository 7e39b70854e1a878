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
STABLE = (("kind", "asymptotically stable"),)
UNSTABLE = (("kind", "unstable"),)
FOCUS = (("kind", "focus"),)
NODE = (("kind", "node"),)
SADDLE_AT = (("kind", "saddle"), ("angle", at))
STABLE_AT = (("kind", "asymptotically stable"), ("angle", at))

CASES = [
    Case("equilibrium_condition", sp.Abs(m) <= g, TURNED, "right", "by the modulus"),
    Case(
        "equilibrium_condition",
        [m <= g, -sp.Symbol("g") <= sp.Symbol("m")],
        TURNED,
        "right",
        "a list, plain symbols",
    ),
    Case(
        "equilibrium_condition",
        sp.Interval(-1, 1),
        ([rate, m - sp.sin(phi)], [phi, rate], [m, c]),
        "right",
        "a set of values of the first parameter",
    ),
    Case("equilibrium_condition", True, PUMPED, "right", "always"),
    Case("equilibrium_condition", sp.Abs(m) < g, TURNED, "wrong", "the border left out"),
    Case("equilibrium_condition", m <= g, TURNED, "wrong", "one side only"),
    Case("equilibrium_condition", 2 * sp.Abs(m) <= g, TURNED, "wrong", "a factor"),
    Case("equilibrium_condition", ..., TURNED, "missing", "the untouched stub"),
    Case("equilibrium_condition", 1, TURNED, "invalid", "a number"),
    Case(
        "equilibrium_values",
        [BOTTOM + 2 * sp.pi * n, TOP + 2 * sp.pi * n],
        (*TURNED, (), n),
        "right",
        "two families",
    ),
    Case("equilibrium_values", [BOTTOM, TOP], (*TURNED, (), n), "wrong", "those of one turn alone"),
    Case(
        "equilibrium_values",
        [BOTTOM + 4 * sp.pi * n, TOP + 2 * sp.pi * n],
        (*TURNED, (), n),
        "wrong",
        "one in every other turn alone",
    ),
    Case(
        "equilibrium_values",
        [BOTTOM + 4 * sp.pi * n, BOTTOM + 2 * sp.pi + 4 * sp.pi * n, TOP + 2 * sp.pi * n],
        (*TURNED, (), n),
        "right",
        "even turns and odd ones",
    ),
    Case(
        "equilibrium_values",
        (-1) ** n * BOTTOM + sp.pi * n,
        (*TURNED, (), n),
        "right",
        "one formula",
    ),
    Case(
        "equilibrium_values",
        sp.ImageSet(sp.Lambda(x, sp.pi * x), sp.S.Integers),
        (*PUMPED, (), n),
        "right",
        "a set as solveset gives it",
    ),
    Case(
        "equilibrium_values",
        [(sp.Float(3.14159) * n, 0)],
        (*PUMPED, (), n),
        "right",
        "points of the phase plane, with decimals",
    ),
    Case(
        "equilibrium_values", [BOTTOM + 2 * sp.pi * n], (*TURNED, (), n), "wrong", "one family lost"
    ),
    Case("equilibrium_values", [BOTTOM + sp.pi * n], (*TURNED, (), n), "wrong", "the wrong period"),
    Case("equilibrium_values", [sp.asin(g / m), TOP], (*TURNED, (), n), "wrong", "not real"),
    Case("equilibrium_values", [], (*PUMPED, (), n), "wrong", "none"),
    Case("equilibrium_values", ..., (*PUMPED, (), n), "missing", "the untouched stub"),
    Case(
        "equilibrium_values", sp.Eq(sp.sin(phi), m / g), (*TURNED, (), n), "invalid", "an equation"
    ),
    Case(
        "equilibrium_values",
        [BOTTOM + 2 * sp.pi * n],
        (*TURNED, (), n),
        "right",
        "the lower ones",
        STABLE,
    ),
    Case(
        "equilibrium_values", {BOTTOM}, (*TURNED, (), n), "wrong", "that of one turn alone", STABLE
    ),
    Case(
        "equilibrium_values",
        [],
        ([rate, g * sp.sin(phi) + c * rate], [phi, rate], [g, c], (), n),
        "right",
        "none",
        STABLE,
    ),
    Case("equilibrium_values", [TOP], (*TURNED, (), n), "wrong", "the upper ones", STABLE),
    Case(
        "equilibrium_values", [], (*TURNED, (), n), "wrong", "none, though there are some", STABLE
    ),
    Case("equilibrium_values", ..., (*TURNED, (), n), "missing", "the untouched stub", STABLE),
    Case("equilibrium_values", "none", (*TURNED, (), n), "invalid", "a word", STABLE),
    Case(
        "equilibrium_values",
        [TOP + 2 * sp.pi * n],
        (*TURNED, (), n),
        "right",
        "the upper ones",
        UNSTABLE,
    ),
    Case(
        "equilibrium_values",
        sp.Matrix([TOP + 2 * sp.pi * n, TOP - 2 * sp.pi * n]),
        (*TURNED, (), n),
        "right",
        "a column, one family twice",
        UNSTABLE,
    ),
    Case("equilibrium_values", [BOTTOM, TOP], (*TURNED, (), n), "wrong", "all of them", UNSTABLE),
    Case("equilibrium_values", [], (*TURNED, (), n), "wrong", "none", UNSTABLE),
    Case("equilibrium_values", ..., (*TURNED, (), n), "missing", "the untouched stub", UNSTABLE),
    Case(
        "equilibrium_values",
        [t],
        (*TURNED, (), n),
        "invalid",
        "a symbol of another problem",
        UNSTABLE,
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
        "equilibrium_condition",
        sp.cos(at) > 0,
        TURNED,
        "right",
        "the lower half of the circle",
        STABLE_AT,
    ),
    Case(
        "equilibrium_condition",
        sp.sin(at) ** 2 < sp.cos(at) * sp.Abs(sp.cos(at)) + sp.sin(at) ** 2,
        TURNED,
        "right",
        "in a clumsy way",
        STABLE_AT,
    ),
    Case(
        "equilibrium_condition",
        sp.cos(at) >= 0,
        TURNED,
        "wrong",
        "the border counted in",
        STABLE_AT,
    ),
    Case("equilibrium_condition", sp.cos(at) < 0, TURNED, "wrong", "the upper half", STABLE_AT),
    Case(
        "equilibrium_condition",
        sp.cos(at) > sp.Rational(1, 20),
        TURNED,
        "wrong",
        "a little too few",
        STABLE_AT,
    ),
    Case("equilibrium_condition", ..., TURNED, "missing", "the untouched stub", STABLE_AT),
    Case("equilibrium_condition", sp.cos(at), TURNED, "invalid", "an expression", STABLE_AT),
    Case(
        "equilibrium_condition",
        sp.cos(at) < 0,
        TURNED,
        "right",
        "the upper half of the circle",
        SADDLE_AT,
    ),
    Case(
        "equilibrium_condition", sp.Not(sp.cos(at) >= 0), TURNED, "right", "a negation", SADDLE_AT
    ),
    Case(
        "equilibrium_condition",
        sp.cos(at) <= 0,
        TURNED,
        "wrong",
        "the border counted in",
        SADDLE_AT,
    ),
    Case("equilibrium_condition", sp.sin(at) < 0, TURNED, "wrong", "the sine", SADDLE_AT),
    Case("equilibrium_condition", ..., TURNED, "missing", "the untouched stub", SADDLE_AT),
    Case("equilibrium_condition", 2, TURNED, "invalid", "a number", SADDLE_AT),
    Case("equilibrium_condition", c**4 < 16 * (g**2 - m**2), TURNED, "right", "squared", FOCUS),
    Case(
        "equilibrium_condition",
        sp.And(sp.Abs(m) < g, c**2 <= 4 * sp.sqrt(g**2 - m**2)),
        TURNED,
        "right",
        "with a root, the border counted in",
        FOCUS,
    ),
    Case("equilibrium_condition", c**2 < 4 * g, TURNED, "wrong", "the moment forgotten", FOCUS),
    Case("equilibrium_condition", c**4 < 4 * (g**2 - m**2), TURNED, "wrong", "a factor", FOCUS),
    Case("equilibrium_condition", ..., TURNED, "missing", "the untouched stub", FOCUS),
    Case("equilibrium_condition", "focus", TURNED, "invalid", "a word", FOCUS),
    Case("equilibrium_condition", c**4 >= 16 * (g**2 - m**2), TURNED, "right", "squared", NODE),
    Case(
        "equilibrium_condition",
        sp.Abs(e) > 2 * sp.sqrt(g),
        PUMPED,
        "right",
        "whatever the sign of the friction",
        NODE,
    ),
    Case("equilibrium_condition", c**4 < 16 * (g**2 - m**2), TURNED, "wrong", "the foci", NODE),
    Case("equilibrium_condition", e > 2 * sp.sqrt(g), PUMPED, "wrong", "one sign only", NODE),
    Case("equilibrium_condition", ..., TURNED, "missing", "the untouched stub", NODE),
    Case("equilibrium_condition", g, TURNED, "invalid", "an expression", NODE),
]
LIMITS = [
    "Equilibria are searched as for the check of all equilibria: a pair that attracts none of the "
    "starts is overlooked.",
    "A condition that names an angle beside its sines and cosines is compared at sample angles.",
]
