import numpy as np
import sympy as sp
from case import Case

open_ray = sp.Interval.open(0, sp.oo)
P, m, g, k, k1, b, c = sp.symbols("P m g k k1 b c", positive=True)
v, theta, rho, beta, r, u = sp.symbols("v theta rho beta r u", real=True)

# A rocket, a projectile with thrust, a glider, a pursuit, a limit cycle: problems 1.7, 1.8, 1.9,
# 1.11, 1.12.
ROCKET = ([(P - k * v**2) / m - g], [v], [P, m, g, k], {v: open_ray})
PLAIN = {s: sp.Symbol(s.name) for s in ROCKET[2]}
CLIMB = sp.sqrt((P - m * g) / k)
ANY = {theta: sp.Interval.Lopen(-sp.pi, sp.pi), v: open_ray}
SHOT = ([-g * sp.cos(theta) / v, P - k * v**2 - g * sp.sin(theta)], [theta, v], [P, g, k], ANY)
UP = (*SHOT[:3], ANY | {theta: sp.Interval.open(0, sp.pi)})
DOWN = (*SHOT[:3], ANY | {theta: sp.Interval.open(-sp.pi, 0)})
DOWN_TO_ITS_BORDER = (*SHOT[:3], ANY | {theta: sp.Interval(-sp.pi / 2, 0)})
SLOWEST = (SHOT[0][1], v, [theta, P, g, k], ANY)
BOTH = [[-sp.pi / 2, sp.sqrt((P + g) / k)], [sp.pi / 2, sp.sqrt((P - g) / k)]]
GLIDER = (
    [k1 * v - g * sp.cos(theta) / v, -k * v**2 - g * sp.sin(theta)],
    [theta, v],
    [k, k1, g],
    ANY,
)
GLIDE = [-sp.atan(k / k1), (g**2 / (k**2 + k1**2)) ** sp.Rational(1, 4)]
CHASE = (
    [b - sp.cos(beta), sp.sin(beta) / rho + c],
    [rho, beta],
    [b, c],
    {rho: open_ray, beta: sp.Interval.Lopen(-sp.pi, sp.pi), b: sp.Interval.open(0, 1)},
)
RADIAL = ([(u - 2) * r - r**3], [r], [u], {r: open_ray})
ON_CYCLE = ([(u - 2) * r - r**3], [r], [u], {r: open_ray})
ROUND = ([-u * rho, -u * beta], [rho, beta], [u], {u: open_ray})
TOUCHING, SIMPLE = ([r**2 * (r - 1)], [r], []), (("zeros", [r * (r - 1)]),)
FOCUS = (("kind", "focus"),)
NODE = (("kind", "node"),)

CASES = [
    Case("equilibria", CLIMB, ROCKET, "right", "one equation: the bare expression"),
    Case("equilibria", [CLIMB.subs(PLAIN)], ROCKET, "right", "plain symbols, in a list"),
    Case(
        "equilibria",
        BOTH,
        SHOT,
        "right",
        "two points, one of which exists for some parameters only",
    ),
    Case("equilibria", BOTH[::-1], SHOT, "right", "another order"),
    Case("equilibria", sp.Matrix(BOTH), SHOT, "right", "the rows of a matrix"),
    Case(
        "equilibria",
        np.array([[0.0], [1.0]]),
        TOUCHING,
        "right",
        "an array with a point in each row",
        SIMPLE,
    ),
    Case(
        "equilibria",
        [[-1.5708, sp.sqrt((P + g) / k)]],
        DOWN_TO_ITS_BORDER,
        "right",
        "an angle at the border of the domain, rounded to its other side",
    ),
    Case(
        "equilibria",
        [[-1.58, sp.sqrt((P + g) / k)]],
        DOWN_TO_ITS_BORDER,
        "wrong",
        "too far beyond it",
    ),
    Case("equilibria", [0, 1], TOUCHING, "right", "a double zero", SIMPLE),
    Case("equilibria", [1], TOUCHING, "wrong", "a double zero overlooked", SIMPLE),
    Case(
        "equilibria",
        [{v: BOTH[0][1], theta: BOTH[0][0]}, dict(zip((theta, v), BOTH[1]))],
        SHOT,
        "right",
        "dicts",
    ),
    Case(
        "equilibria",
        [(BOTH[0][0] + 2 * sp.pi, BOTH[0][1]), BOTH[1]],
        SHOT,
        "wrong",
        "an angle a turn outside the domain",
    ),
    Case("equilibria", [-1.57, BOTH[0][1]], DOWN, "right", "a decimal angle"),
    Case("equilibria", GLIDE, GLIDER, "right", "an angle that depends on parameters"),
    Case("equilibria", BOTH[:1], SHOT, "wrong", "one of two"),
    Case("equilibria", BOTH + BOTH[:1], SHOT, "wrong", "one of them twice"),
    Case(
        "equilibria", [-1.5, BOTH[0][1]], DOWN, "wrong", "a decimal angle that is not close enough"
    ),
    Case("equilibria", -CLIMB, ROCKET, "wrong", "outside the domain"),
    Case(
        "equilibria",
        sp.sqrt((m * g - P) / k),
        ROCKET,
        "wrong",
        "real where no point exists, and not where one does",
    ),
    Case("equilibria", [BOTH[0][1], -sp.pi / 2], DOWN, "wrong", "the coordinates exchanged"),
    Case("equilibria", ..., ROCKET, "missing", "the untouched stub"),
    Case("equilibria", [[..., v], BOTH[0]], SHOT, "missing", "half of it"),
    Case("equilibria", [v], ROCKET, "invalid", "the state itself"),
    Case("equilibria", [BOTH[0][1]], DOWN, "invalid", "a single coordinate"),
    Case("equilibria", "CLIMB", ROCKET, "invalid", "text"),
    Case(
        "equilibria",
        sp.sqrt((P - g * sp.sin(theta)) / k),
        SLOWEST,
        "right",
        "the curve, real for some angles only",
    ),
    Case(
        "equilibria", [(P / k - g / k * sp.sin(theta)) ** 0.5], SLOWEST, "right", "a decimal power"
    ),
    Case("equilibria", sp.sqrt((P + g * sp.sin(theta)) / k), SLOWEST, "wrong", "a sign"),
    Case(
        "equilibria",
        sp.sqrt(sp.Abs(P - g * sp.sin(theta)) / k),
        SLOWEST,
        "wrong",
        "a curve where there is none",
    ),
    Case("equilibria", sp.sqrt((P + g) / k), SLOWEST, "wrong", "a constant"),
    Case("equilibria", sp.Eq(v, 1), SLOWEST, "invalid", "an equation"),
    Case("equilibrium_condition", P > m * g, ROCKET, "right", "the radicand"),
    Case(
        "equilibrium_condition",
        sp.Symbol("P") / sp.Symbol("g") > sp.Symbol("m"),
        ROCKET,
        "right",
        "plain symbols, a quotient",
    ),
    Case("equilibrium_condition", True, DOWN, "right", "always"),
    Case("equilibrium_condition", P > 1.0 * m * g, ROCKET, "right", "a decimal"),
    Case(
        "equilibrium_condition",
        P >= m * g,
        ROCKET,
        "wrong",
        "the border, where the point leaves the domain",
    ),
    Case(
        "equilibrium_condition",
        P > sp.Rational(1001, 1000) * m * g,
        ROCKET,
        "wrong",
        "off by a thousandth",
    ),
    Case(
        "equilibrium_condition",
        sp.And(P > m * g, sp.Or(k < 2, k > sp.Rational(21, 10))),
        ROCKET,
        "wrong",
        "a strip left out",
    ),
    Case("equilibrium_condition", False, ROCKET, "wrong", "never"),
    Case("equilibrium_condition", P - m * g, ROCKET, "invalid", "an expression"),
    Case(
        "equilibrium_linearisation",
        -2 * sp.sqrt(k * (P - m * g)) / m,
        ROCKET,
        "right",
        "one equation: a bare number",
    ),
    Case(
        "equilibrium_linearisation",
        [[-2.0 * k * CLIMB / m]],
        ROCKET,
        "right",
        "a matrix with one element, decimals",
    ),
    Case(
        "equilibrium_linearisation",
        sp.diag(-g / BOTH[0][1], -2 * k * BOTH[0][1]),
        DOWN,
        "right",
        "two equations",
    ),
    Case("equilibrium_linearisation", -sp.sqrt(k * (P - m * g)) / m, ROCKET, "wrong", "a factor 2"),
    Case(
        "equilibrium_linearisation",
        sp.diag(-2 * k * BOTH[0][1], -g / BOTH[0][1]),
        DOWN,
        "wrong",
        "the order of the state",
    ),
    Case(
        "equilibrium_linearisation",
        sp.diag(g / BOTH[0][1], -2 * k * BOTH[0][1]),
        DOWN,
        "wrong",
        "a sign",
    ),
    Case("equilibrium_linearisation", sp.eye(3), DOWN, "invalid", "three rows"),
    Case("equilibrium_linearisation", -2 * k * v / m, ROCKET, "invalid", "the state left in"),
    Case(
        "equilibrium_value",
        2 * (P - m * g) / m,
        ((P + k * v**2) / m - g, *ROCKET),
        "right",
        "simplified",
    ),
    Case(
        "equilibrium_value",
        (P + k * CLIMB**2) / m - g,
        ((P + k * v**2) / m - g, *ROCKET),
        "right",
        "not simplified",
    ),
    Case(
        "equilibrium_value",
        0.667 * (P - m * g) / m,
        ((P + k * v**2) / m / 3 - g / 3, *ROCKET),
        "right",
        "a coefficient to three digits",
    ),
    Case(
        "equilibrium_value",
        0.67 * (P - m * g) / m,
        ((P + k * v**2) / m / 3 - g / 3, *ROCKET),
        "wrong",
        "a coefficient to two digits",
    ),
    Case("equilibrium_value", 0, ((P + k * v**2) / m - g, *ROCKET), "wrong", "zero"),
    Case(
        "equilibrium_value",
        (P - m * g) / m,
        ((P + k * v**2) / m - g, *ROCKET),
        "wrong",
        "half of it",
    ),
    Case(
        "equilibrium_value",
        True,
        ((P + k * v**2) / m - g, *ROCKET),
        "invalid",
        "a word of another kind",
    ),
    Case("equilibrium_stability", "asymptotically stable", ROCKET, "right", "a negative root"),
    Case("equilibrium_stability", "Unstable", CHASE, "right", "a positive real part"),
    Case("equilibrium_stability", "stable", ROCKET, "wrong", "asymptotically as well"),
    Case("equilibrium_stability", "asymptotically stable", UP, "wrong", "one positive root"),
    Case("equilibrium_stability", "instable", UP, "invalid", "another word"),
    Case("equilibrium_type", "saddle", UP, "right", "roots of both signs"),
    Case("equilibrium_type", "stable-node", DOWN, "right", "a hyphen"),
    Case("equilibrium_type", "stable star", ROUND, "right", "a multiple of the unit matrix"),
    Case(
        "equilibrium_type",
        "stable star node",
        ROUND,
        "right",
        "a multiple of the unit matrix, its longer name",
    ),
    Case("equilibrium_type", "stable star", DOWN, "wrong", "two different roots"),
    Case("equilibrium_type", "unstable node", UP, "wrong", "a saddle"),
    Case("equilibrium_type", "node", DOWN, "invalid", "stability not said"),
    Case("equilibrium_condition", k**2 < 8 * k1**2, GLIDER, "right", "the discriminant", FOCUS),
    Case(
        "equilibrium_condition",
        k <= 2 * sp.sqrt(2) * k1,
        GLIDER,
        "right",
        "solved for k, the border counted in",
        FOCUS,
    ),
    Case("equilibrium_condition", k < 2.83 * k1, GLIDER, "right", "three digits", FOCUS),
    Case(
        "equilibrium_condition",
        sp.Interval.open(0, 2 / sp.sqrt(5)),
        CHASE,
        "right",
        "an interval of the first parameter",
        FOCUS,
    ),
    Case("equilibrium_condition", k < 2.828427 * k1, GLIDER, "right", "seven digits", FOCUS),
    Case(
        "equilibrium_condition",
        k <= float(sp.sqrt(8)) * k1,
        GLIDER,
        "right",
        "all digits of a float, the border counted in",
        FOCUS,
    ),
    Case(
        "equilibrium_condition",
        k < 2.9 * k1,
        GLIDER,
        "wrong",
        "decimals that are not close enough",
        FOCUS,
    ),
    Case("equilibrium_condition", k < 3 * k1, GLIDER, "wrong", "a rough value", FOCUS),
    Case("equilibrium_condition", k**2 < 8 * k1, GLIDER, "wrong", "a square forgotten", FOCUS),
    Case("equilibrium_condition", 2 * sp.sqrt(2), GLIDER, "invalid", "a number", FOCUS),
    Case("equilibrium_condition", sp.Not(k < sp.sqrt(8) * k1), GLIDER, "right", "a negation", NODE),
    Case(
        "equilibrium_condition",
        sp.And(b > 2 / sp.sqrt(5), b < 1),
        CHASE,
        "right",
        "with the range of the parameter",
        NODE,
    ),
    Case("equilibrium_condition", b > 0.894, CHASE, "right", "three digits", NODE),
    Case(
        "equilibrium_condition",
        b > sp.Rational(894, 1000),
        CHASE,
        "wrong",
        "a fraction counts as exact",
        NODE,
    ),
    Case("equilibrium_condition", k > k1, GLIDER, "wrong", "another slope", NODE),
    Case("equilibrium_condition", "k > 2.83 k1", GLIDER, "invalid", "text", NODE),
    Case("equilibrium_condition", u > 2, RADIAL, "right", "the radicand"),
    Case("equilibrium_condition", sp.Interval.open(2, sp.oo), RADIAL, "right", "an interval"),
    Case("equilibrium_condition", u >= 2, RADIAL, "wrong", "the radius zero"),
    Case("equilibrium_condition", u >= 2.0, RADIAL, "wrong", "the radius zero, as a decimal"),
    Case("equilibrium_condition", u > 2.004, RADIAL, "right", "to three digits"),
    Case(
        "equilibrium_condition", u >= 2.004, RADIAL, "wrong", "a decimal does not hide the border"
    ),
    Case("equilibrium_condition", u > 2.006, RADIAL, "wrong", "more than half a unit"),
    Case("equilibrium_condition", u > 2.02, RADIAL, "wrong", "off by one per cent"),
    Case("equilibrium_condition", sp.And(u > 2, u < 10**7), RADIAL, "wrong", "cut off far out"),
    Case("equilibrium_condition", u > 2.0, RADIAL, "right", "a decimal"),
    Case("equilibrium_condition", u >= 2.0, RADIAL, "wrong", "the radius zero, a decimal"),
    Case("equilibrium_condition", sp.Ne(u, 2), RADIAL, "wrong", "either sign of the radicand"),
    Case("equilibrium_condition", 2, RADIAL, "invalid", "the value alone"),
    Case("equilibria", sp.sqrt(u - 2), RADIAL, "right", "the root"),
    Case("equilibria", [(sp.Symbol("u") - 2) ** 0.5], RADIAL, "right", "plain symbols, a list"),
    Case("equilibria", u - 2, RADIAL, "wrong", "the square"),
    Case("equilibria", [0, sp.sqrt(u - 2)], RADIAL, "wrong", "the equilibrium counted"),
    Case("equilibria", sp.Eq(r**2, u - 2), RADIAL, "invalid", "an equation"),
    Case("equilibrium_linearisation", 4 - 2 * u, ON_CYCLE, "right", "a cycle in its radius"),
]
LIMITS = [
    "Equilibria are searched by Newton's method from 240 starts for up to 30 sample values "
    "of the parameters: a point that attracts none of them would not be missed in an answer.",
    "A condition with other terms than polynomials, roots, absolute values, sines and cosines is "
    "compared at points.",
    "The border between focus and node, where the roots are equal, is not judged.",
]
