import sympy as sp
from case import Case

open_ray = sp.Interval.open(0, sp.oo)
P, m, g, k, k1, b, c = sp.symbols("P m g k k1 b c", positive=True)
v, theta, rho, beta, r, u = sp.symbols("v theta rho beta r u", real=True)

ANY = {theta: sp.Interval.Lopen(-sp.pi, sp.pi), v: open_ray}
GLIDER = (
    [k1 * v - g * sp.cos(theta) / v, -k * v**2 - g * sp.sin(theta)],
    [theta, v],
    [k, k1, g],
    ANY,
)
NO_DRAG = ([k1 * v - g * sp.cos(theta) / v, -g * sp.sin(theta)], [theta, v], [k1, g], ANY)
ENDS = [(-sp.pi / 2, 0), (sp.pi / 2, 0)]
FORWARDS = ANY | {theta: sp.Interval.open(-sp.pi / 2, sp.pi / 2)}
BORDER = (*NO_DRAG[:3], ENDS, FORWARDS)
CHASE = (
    [b - sp.cos(beta), sp.sin(beta) / rho + c],
    [rho, beta],
    [b, c],
    {rho: open_ray, beta: sp.Interval.Lopen(-sp.pi, sp.pi), b: sp.Interval.open(0, 1)},
)

CASES = [
    Case("dulac_function", [v, -3 * k * v**2], GLIDER, "right", "a multiplier"),
    Case("dulac_function", (-2 * rho, -2 * b), CHASE, "right", "another factor, a tuple"),
    Case(
        "dulac_function", [1, sp.cos(beta) / rho], CHASE, "wrong", "the divergence changes its sign"
    ),
    Case("dulac_function", [rho, 2 * b], CHASE, "wrong", "another divergence"),
    Case(
        "dulac_function",
        [v * (k - 1) ** 2, -3 * k * (k - 1) ** 2 * v**2],
        GLIDER,
        "wrong",
        "a multiplier that is zero for k = 1",
    ),
    Case(
        "dulac_function",
        [rho * (b - 2) ** 2, b * (b - 2) ** 2],
        CHASE,
        "right",
        "zero only for a b beyond those asked about",
    ),
    Case("dulac_function", [v, 0], NO_DRAG, "wrong", "a divergence that vanishes everywhere"),
    Case(
        "dulac_function",
        [sp.log(v - 1), -3 * k * v**2],
        GLIDER,
        "wrong",
        "a multiplier that is not real everywhere",
    ),
    Case("dulac_function", rho, CHASE, "invalid", "the multiplier alone"),
    Case(
        "first_integral",
        k1 * v**3 / 3 - g * v * sp.cos(theta),
        NO_DRAG,
        "right",
        "the stream function",
    ),
    Case(
        "first_integral",
        (k1 * v**3 - 3 * g * v * sp.cos(theta)) ** 2 + 5,
        NO_DRAG,
        "right",
        "a function of it",
    ),
    Case("first_integral", k1 * v**2 / 2 - g * sp.cos(theta), NO_DRAG, "wrong", "not kept"),
    Case(
        "first_integral",
        0.333 * k1 * v**3 - g * v * sp.cos(theta),
        NO_DRAG,
        "right",
        "three digits of a third",
    ),
    Case(
        "first_integral",
        0.337 * k1 * v**3 - g * v * sp.cos(theta),
        NO_DRAG,
        "wrong",
        "one per cent off",
    ),
    Case("first_integral", g * k1, NO_DRAG, "wrong", "a constant"),
    Case(
        "first_integral",
        (g - 1) * (k1 * v**3 - 3 * g * v * sp.cos(theta)),
        NO_DRAG,
        "wrong",
        "zero for g = 1",
    ),
    Case(
        "first_integral",
        sp.exp(k1 * v**3 / (3 * g) - v * sp.cos(theta)),
        NO_DRAG,
        "right",
        "too large for a float",
    ),
    Case("first_integral", sp.DiracDelta(v), NO_DRAG, "wrong", "what has no values"),
    Case("first_integral", sp.Eq(v, 0), NO_DRAG, "invalid", "an equation"),
    Case("phase_curve", sp.sqrt(3 * g * sp.cos(theta) / k1), BORDER, "right", "the curve"),
    Case(
        "phase_curve",
        sp.sqrt(3) * sp.sqrt(g / k1) * sp.sqrt(sp.cos(theta)),
        BORDER,
        "right",
        "separate roots",
    ),
    Case(
        "phase_curve",
        1.73 * sp.sqrt(g / k1) * sp.sqrt(sp.cos(theta)),
        BORDER,
        "right",
        "three digits of a root",
    ),
    Case(
        "phase_curve",
        1.75 * sp.sqrt(g / k1) * sp.sqrt(sp.cos(theta)),
        BORDER,
        "wrong",
        "one per cent off",
    ),
    Case("phase_curve", sp.sqrt(g * sp.cos(theta) / k1), BORDER, "wrong", "another slope"),
    Case(
        "phase_curve", -sp.sqrt(3 * g * sp.cos(theta) / k1), BORDER, "wrong", "outside the domain"
    ),
    Case(
        "phase_curve",
        v**3 - 3 * v * sp.cos(theta),
        BORDER,
        "invalid",
        "an equation without its right-hand side",
    ),
]
LIMITS = [
    "A multiplier is tried at 300 points of the domain: a divergence whose sign changes in a "
    "small part of it only may pass.",
    "The region of the Dulac test has to be simply connected; that it is one is for the data "
    "cell to see to.",
]
