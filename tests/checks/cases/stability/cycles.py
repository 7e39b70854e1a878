import math

import sympy as sp
from case import Case

x, y = sp.symbols("x y", real=True)
r, phi, t, r0 = sp.symbols("r phi t r0", positive=True)
q = x**2 + y**2
STABLE = (sp.Matrix([y - x * (q - 1), -x - y * (q - 1)]), [x, y])  # problem 1.13
UNSTABLE = (sp.Matrix([y + x * (q - 1), -x + y * (q - 1)]), [x, y])
SEMI = ([y - x * (q - 1) ** 2, -x - y * (q - 1) ** 2], [x, y])
# semistable the other way round
OUTWARDS = ([y + x * (q - 1) ** 2, -x + y * (q - 1) ** 2], [x, y])
# cycles of radius 1 and 2
TWO = ([y - x * (q - 1) * (q - 4), -x - y * (q - 1) * (q - 4)], [x, y])
# a stable cycle of radius 3
LARGE = ([2 * y + x * (9 - q), -2 * x + y * (9 - q)], [x, y])
SPIRAL = ([y - x, -x - y], [x, y])  # no cycle
# nothing but closed orbits
CENTRE = ([y, -x], [x, y])
POLAR = (*STABLE, [r, phi])
SHEAR = ([y, -x - y], [x, y], [r, phi])
MOTION = (*STABLE, t, r0)
BLOWUP = (*UNSTABLE, t, r0)
R = 1 / sp.sqrt(1 + (1 / r0**2 - 1) * sp.exp(-2 * t))

u = sp.Symbol("u", real=True)
radius = sp.Symbol("r", real=True)
TURNING = ((u - 2) * radius - radius**3, radius + 1, radius, [u])

CASES = [
    Case("polar_form", [-r * (r**2 - 1), -1], POLAR, "right", "factored"),
    Case("polar_form", (r - r**3, -1.0), POLAR, "right", "expanded, a tuple"),
    Case("polar_form", sp.Matrix([r * (1 - r) * (1 + r), -1]), POLAR, "right", "a column"),
    Case(
        "polar_form", [sp.Symbol("r") - sp.Symbol("r") ** 3, -1], POLAR, "right", "a plain symbol"
    ),
    Case(
        "polar_form",
        [-r * sp.sin(phi) ** 2, -1 - sp.sin(2 * phi) / 2],
        SHEAR,
        "right",
        "with the angle",
    ),
    Case("polar_form", [-r * (r**2 - 1), 1], POLAR, "wrong", "the other sense of rotation"),
    Case("polar_form", [r * (r**2 - 1), -1], POLAR, "wrong", "the other sign of r'"),
    Case("polar_form", [-(r**2 - 1), -1], POLAR, "wrong", "a factor r lost"),
    Case("polar_form", [-r * r * (r**2 - 1), -1], POLAR, "wrong", "r r' given for r'"),
    Case("polar_form", [-1, -r * (r**2 - 1)], POLAR, "wrong", "interchanged"),
    Case("polar_form", [-r * (r**2 - 1), -r], POLAR, "wrong", "the speed r phi' given for phi'"),
    Case("polar_form", [sp.log(-r), -1], POLAR, "wrong", "not even real"),
    Case("polar_form", [r / (phi - phi), -1], POLAR, "invalid", "undefined"),
    Case(
        "polar_form", [sp.log(r - r, evaluate=False), -1], POLAR, "wrong", "undefined, unevaluated"
    ),
    Case("polar_form", ..., POLAR, "missing", "the untouched stub"),
    Case("polar_form", [r - r**3, ...], POLAR, "missing", "half of it"),
    Case("polar_form", r - r**3, POLAR, "invalid", "one rate"),
    Case("polar_form", [-x, -1], POLAR, "invalid", "in Cartesian coordinates"),
    Case("radial_motion", R, MOTION, "right", "as the problem book prints it"),
    Case(
        "radial_motion",
        r0 * sp.exp(t) / sp.sqrt(1 + r0**2 * (sp.exp(2 * t) - 1)),
        MOTION,
        "right",
        "with growing exponentials",
    ),
    Case(
        "radial_motion",
        R.subs({t: sp.Symbol("t"), r0: sp.Symbol("r0")}),
        MOTION,
        "right",
        "plain symbols",
    ),
    Case(
        "radial_motion",
        (1 + (1 - r0**2) / r0**2 * sp.exp(-2 * t)) ** -0.5,
        MOTION,
        "right",
        "a decimal power",
    ),
    Case(
        "radial_motion",
        1 / sp.sqrt(1 + (1 / r0**2 - 1) * sp.exp(2 * t)),
        BLOWUP,
        "right",
        "a motion that runs away in finite time",
    ),
    Case("radial_motion", R, BLOWUP, "wrong", "the motion of another system"),
    Case(
        "radial_motion",
        1 / sp.sqrt(1 + (1 / r0**2 - 1) * sp.exp(-t)),
        MOTION,
        "wrong",
        "a wrong rate in the exponent",
    ),
    Case(
        "radial_motion",
        1 / (1 + (1 / r0**2 - 1) * sp.exp(-2 * t)),
        MOTION,
        "wrong",
        "the square root forgotten",
    ),
    Case("radial_motion", -R, MOTION, "wrong", "the negative root"),
    Case(
        "radial_motion",
        1 / sp.sqrt(1 + (1 / r0 - 1) * sp.exp(-2 * t)),
        MOTION,
        "wrong",
        "the constant from 1/r0",
    ),
    Case("radial_motion", r0 * sp.exp(t), MOTION, "wrong", "the linear growth near zero"),
    Case(
        "radial_motion", 1 + (r0 - 1) * sp.exp(-2 * t), MOTION, "wrong", "linearised at the cycle"
    ),
    Case("radial_motion", sp.Integer(1), MOTION, "wrong", "the cycle itself"),
    Case("radial_motion", sp.sqrt(-R), MOTION, "wrong", "not real"),
    Case("radial_motion", r0 / t, MOTION, "wrong", "undefined at the start"),
    Case("radial_motion", ..., MOTION, "missing", "the untouched stub"),
    Case(
        "radial_motion",
        1 / sp.sqrt(1 + sp.Symbol("c0") * sp.exp(-2 * t)),
        MOTION,
        "invalid",
        "the constant not expressed by r0",
    ),
    Case("radial_motion", sp.Eq(r, R), MOTION, "invalid", "an equation"),
    Case("radial_motion", sp.zoo, MOTION, "invalid", "an undefined value"),
    Case("limit_cycles", [1], STABLE, "right", "a list"),
    Case("limit_cycles", 1.0, UNSTABLE, "right", "the number itself"),
    Case("limit_cycles", {1}, SEMI, "right", "a set, r' without change of sign"),
    Case("limit_cycles", [2, 1], TWO, "right", "two, in any order"),
    Case("limit_cycles", sp.FiniteSet(1, 2), TWO, "right", "two, as a SymPy set"),
    Case("limit_cycles", [sp.sqrt(9)], LARGE, "right", "another radius"),
    Case("limit_cycles", [], SPIRAL, "right", "none"),
    Case(
        "limit_cycles", [sp.Rational(1001, 1000)], STABLE, "wrong", "exact, and off by a thousandth"
    ),
    Case("limit_cycles", [0, 1], STABLE, "wrong", "the equilibrium counted as a cycle"),
    Case("limit_cycles", [-1, 1], STABLE, "wrong", "a negative radius"),
    Case("limit_cycles", [1], TWO, "wrong", "one overlooked"),
    Case("limit_cycles", [9], LARGE, "wrong", "the square of the radius"),
    Case("limit_cycles", [], STABLE, "wrong", "none"),
    Case("limit_cycles", [1], SPIRAL, "wrong", "a cycle where none is"),
    Case("limit_cycles", [1.01], STABLE, "wrong", "the third digit off"),
    Case("limit_cycles", ..., STABLE, "missing", "the untouched stub"),
    Case("limit_cycles", "the unit circle", STABLE, "invalid", "words"),
    Case("limit_cycles", sp.Eq(r, 1), STABLE, "invalid", "an equation"),
    Case("limit_cycles", [1], CENTRE, "refused", "a centre: the question makes no sense there"),
    Case("cycle_stability", "stable", STABLE, "right", "motions come from both sides"),
    Case("cycle_stability", "Unstable", UNSTABLE, "right", "a capital letter"),
    Case("cycle_stability", "semi-stable", SEMI, "right", "with a hyphen"),
    Case("cycle_stability", "semistable", SEMI, "right", "attracts from outside"),
    Case("cycle_stability", "semistable", OUTWARDS, "right", "attracts from inside"),
    Case("cycle_stability", "unstable", STABLE, "wrong", "the opposite"),
    Case("cycle_stability", "stable", UNSTABLE, "wrong", "the opposite, the other way"),
    Case("cycle_stability", "stable", SEMI, "wrong", "only the outside looked at"),
    Case(
        "cycle_stability",
        "unstable",
        OUTWARDS,
        "wrong",
        "only the outside looked at, the other way",
    ),
    Case("cycle_stability", "unstable", SEMI, "wrong", "only the inside looked at"),
    Case("cycle_stability", "semistable", STABLE, "wrong", "two sides said to differ that do not"),
    Case("cycle_stability", "unstable", (*TWO, 1), "right", "the inner one of two"),
    Case("cycle_stability", "stable", (*TWO, 1), "wrong", "the kind of the outer one"),
    Case(
        "cycle_stability", "stable", TWO, "refused", "two cycles: the question does not say which"
    ),
    Case("cycle_stability", ..., STABLE, "missing", "the untouched stub"),
    Case("cycle_stability", "attracting", STABLE, "invalid", "a word that was not offered"),
    Case("cycle_stability", 1, STABLE, "invalid", "a number"),
    Case("return_map_slope", sp.exp(-4 * sp.pi), STABLE, "right", "exact"),
    Case("return_map_slope", 3.49e-6, STABLE, "right", "three digits"),
    Case("return_map_slope", math.exp(4 * math.pi), UNSTABLE, "right", "a float"),
    Case("return_map_slope", 1, SEMI, "right", "neither grows nor decays to first order"),
    Case("return_map_slope", sp.exp(-18 * sp.pi), LARGE, "right", "another radius and speed"),
    Case("return_map_slope", sp.exp(-2), STABLE, "wrong", "after one unit of time, not one turn"),
    Case("return_map_slope", -4 * sp.pi, STABLE, "wrong", "the exponent"),
    Case("return_map_slope", sp.exp(4 * sp.pi), STABLE, "wrong", "the sign of the exponent"),
    Case("return_map_slope", 0, SEMI, "wrong", "the derivative of r' instead of the slope"),
    Case(
        "return_map_slope",
        sp.exp(-2 * sp.pi),
        STABLE,
        "wrong",
        "r' linearised with a factor 2 lost",
    ),
    Case("return_map_slope", 286751, UNSTABLE, "right", "rounded to a whole number"),
    Case(
        "return_map_slope",
        1 + sp.exp(4 * sp.pi),
        UNSTABLE,
        "wrong",
        "an exact expression, close but not equal",
    ),
    Case(
        "return_map_slope", sp.Rational(1001, 1000), SEMI, "wrong", "exact, and off by a thousandth"
    ),
    Case("return_map_slope", 1.01, SEMI, "wrong", "the third digit off"),
    Case("return_map_slope", ..., STABLE, "missing", "the untouched stub"),
    Case("return_map_slope", r, STABLE, "invalid", "an expression with a symbol"),
    Case("return_map_slope", "one", SEMI, "invalid", "a word"),
    Case("cycle_period", 2 * sp.pi / (1 + sp.sqrt(u - 2)), TURNING, "right", "one turn"),
    Case("cycle_period", 6.28 / (1 + sp.sqrt(u - 2)), TURNING, "right", "decimals"),
    Case(
        "cycle_period", 2 * sp.pi / sp.sqrt(u - 2), TURNING, "wrong", "a part of the rate forgotten"
    ),
    Case("cycle_period", 2 * sp.pi / (1 + radius), TURNING, "invalid", "the radius left in"),
    Case("cycle_period", sp.pi / (1 + sp.sqrt(u - 2)), TURNING, "wrong", "half a turn"),
]
LIMITS = [
    "Cycles are looked for among the circles around zero with radii between 0.013 and 20. A "
    "cycle of another form is not seen.",
    "Two cycles whose radii differ by less than two per cent may be taken for one.",
    "The time law of a motion is judged at twenty places (five starts, up to two units of time): "
    "one that is right there and wrong later would pass.",
    "Polar rates are judged at twenty random points of the ring 0.2 < r < 2.5.",
]
