import sympy as sp
from case import Case

x, y, a, b, d = sp.symbols("x y a b d", real=True)
w = sp.symbols("w", positive=True)
n = sp.symbols("n", integer=True)
r = 1 / sp.sqrt(-b)
# The pendulum with friction: at rest at every multiple of pi.
PENDULUM = (sp.Matrix([y, -d * y - w**2 * sp.sin(x)]), [x, y], [d, w], d > 0, n)
# Duffing's equation: at rest at zero and, for b < 0, at two further places, which are saddles.
SOFT = (sp.Matrix([y, -a * y - x - b * x**3]), [x, y], [a, b], [a > 0, b < 0])
ANY = (SOFT[0], [x, y], [b])
DOWN, UP = sp.Matrix([[0, 1], [-(w**2), -d]]), sp.Matrix([[0, 1], [w**2, -d]])
SADDLE = (-d + sp.sqrt(d**2 + 4 * w**2)) / 2
# At rest at zero, where all slopes vanish, and at (1, 1).
TWICE = (sp.Matrix([x**2 * (x - 1), y**3 - x**3]), [x, y])
SIMPLE = (("zeros", [x * (x - 1), y - x]),)
PASS = sp.Matrix([[1, 0], [-3, 3]])
STABLE = (("kind", "asymptotically stable"),)
UNSTABLE = (("kind", "unstable"),)
UNIQUE = (("kind", "unique"),)

CASES = [
    Case(
        "equilibrium_values",
        [2 * sp.pi * n, 2 * sp.pi * n + sp.pi],
        PENDULUM,
        "right",
        "two families",
    ),
    Case("equilibrium_values", sp.pi * n, PENDULUM, "right", "one family"),
    Case(
        "equilibrium_values", [(sp.pi * n, 0)], PENDULUM, "right", "as a point of the phase plane"
    ),
    Case("equilibrium_values", sp.Symbol("n") * sp.pi, PENDULUM, "right", "a plain symbol"),
    Case(
        "equilibrium_values",
        -sp.pi * (n + 100),
        PENDULUM,
        "right",
        "counted from elsewhere, downwards",
    ),
    Case("equilibrium_values", 3.142 * n, PENDULUM, "right", "decimals"),
    Case(
        "equilibrium_values",
        sp.solveset(sp.sin(x), x, sp.S.Reals),
        PENDULUM,
        "right",
        "the set that solveset gives",
    ),
    Case(
        "equilibrium_values",
        [k * sp.pi for k in range(-3, 4)],
        PENDULUM,
        "wrong",
        "seven of infinitely many",
    ),
    Case("equilibrium_values", [0, sp.pi], PENDULUM, "wrong", "one period only"),
    Case("equilibrium_values", 2 * sp.pi * n, PENDULUM, "wrong", "one of the two families"),
    Case("equilibrium_values", sp.pi * n / 2, PENDULUM, "wrong", "the quarters taken along"),
    Case("equilibrium_values", [(sp.pi * n, 1)], PENDULUM, "wrong", "a point that moves"),
    Case("equilibrium_values", [0, r, -r], SOFT, "right", "parameters"),
    Case(
        "equilibrium_values",
        {0, sp.sqrt(-1 / b), -sp.sqrt(-1 / b)},
        SOFT,
        "right",
        "as a Python set",
    ),
    Case("equilibrium_values", sp.FiniteSet(0, r, -r), SOFT, "right", "as a SymPy set"),
    Case(
        "equilibrium_values",
        [0, sp.Rational(1001, 1000) * r, -r],
        SOFT,
        "wrong",
        "exact, and off by a thousandth",
    ),
    Case("equilibrium_values", [0, r], SOFT, "wrong", "a sign lost"),
    Case(
        "equilibrium_values",
        [0, r + sp.Max(0, -b - 10**6), -r],
        SOFT,
        "wrong",
        "another value, far out alone",
    ),
    Case(
        "equilibrium_values",
        [0, sp.Max(r, sp.Rational(1, 10**6)), -r],
        SOFT,
        "wrong",
        "never smaller than a millionth",
    ),
    Case(
        "equilibrium_values",
        [0, 1 / sp.sqrt(b), -1 / sp.sqrt(b)],
        SOFT,
        "wrong",
        "values that are not real",
    ),
    Case("equilibrium_values", [], SOFT, "wrong", "none at all"),
    Case("equilibrium_values", [0, ...], SOFT, "missing", "half of it"),
    Case(
        "equilibrium_values",
        sp.Eq(sp.sin(x), 0),
        PENDULUM,
        "invalid",
        "the equation, not its solutions",
    ),
    Case(
        "equilibrium_values",
        sp.ConditionSet(x, sp.Eq(sp.sin(x), 0), sp.S.Reals),
        PENDULUM,
        "invalid",
        "the equation as a set",
    ),
    Case(
        "equilibrium_values",
        sp.Symbol("k") * sp.pi,
        PENDULUM,
        "invalid",
        "another letter for the integer",
    ),
    Case("equilibrium_values", 2 * sp.pi * n, PENDULUM, "right", "hanging", STABLE),
    Case(
        "equilibrium_values",
        sp.ImageSet(sp.Lambda(n, 2 * n * sp.pi), sp.S.Integers),
        PENDULUM,
        "right",
        "as a set",
        STABLE,
    ),
    Case("equilibrium_values", 0, SOFT, "right", "a number", STABLE),
    Case("equilibrium_values", sp.pi * n, PENDULUM, "wrong", "upright taken along", STABLE),
    Case("equilibrium_values", [0], PENDULUM, "wrong", "one turn only", STABLE),
    Case("equilibrium_values", "hanging", PENDULUM, "invalid", "a word", STABLE),
    Case("equilibrium_values", sp.pi * (2 * n - 1), PENDULUM, "right", "upright", UNSTABLE),
    Case("equilibrium_values", [r, -r], SOFT, "right", "the saddles", UNSTABLE),
    Case("equilibrium_values", [sp.pi], PENDULUM, "wrong", "one turn only", UNSTABLE),
    Case("equilibrium_values", [0, r, -r], SOFT, "wrong", "the stable one taken along", UNSTABLE),
    Case("equilibrium_values", True, SOFT, "invalid", "yes", UNSTABLE),
    Case(
        "equilibrium_linearisation",
        [DOWN, UP],
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "right",
        "both",
    ),
    Case(
        "equilibrium_linearisation",
        [[[0, 1], [w**2, -d]], [[0, 1], [-(w**2), -d]]],
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "right",
        "nested lists, the other order",
    ),
    Case(
        "equilibrium_linearisation",
        sp.Matrix([[0, 1], [-((-1) ** n) * w**2, -d]]),
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "right",
        "one matrix with the integer",
    ),
    Case(
        "equilibrium_linearisation",
        {"down": DOWN, "up": UP},
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "right",
        "under names",
    ),
    *(
        Case(
            "equilibrium_linearisation",
            [sp.Matrix([[0, 1], [slope, 0]]) for slope in (first, -first)],
            ([y, sp.Rational(2, 3) * sp.sin(x)], [x, y]),
            verdict,
            note,
        )
        for first, verdict, note in (
            (0.667, "right", "three digits"),
            (0.67, "wrong", "two digits"),
            (0.6667, "right", "four digits"),
        )
    ),
    Case(
        "equilibrium_linearisation",
        [DOWN],
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "wrong",
        "one overlooked",
    ),
    Case(
        "equilibrium_linearisation",
        [DOWN, UP, sp.eye(2)],
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "wrong",
        "one too many",
    ),
    Case(
        "equilibrium_linearisation",
        [DOWN, sp.Matrix([[0, 1], [w**2, d]])],
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "wrong",
        "a sign of the friction",
    ),
    Case(
        "equilibrium_linearisation",
        [sp.eye(3)],
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "invalid",
        "of order three",
    ),
    Case(
        "equilibrium_linearisation",
        w**2,
        (*PENDULUM[:3], None, *PENDULUM[3:]),
        "invalid",
        "an expression",
    ),
    Case(
        "equilibrium_linearisation",
        [sp.zeros(2, 2), PASS],
        TWICE,
        "right",
        "a point at which the slope vanishes",
        SIMPLE,
    ),
    Case("equilibrium_linearisation", [PASS], TWICE, "wrong", "that point overlooked", SIMPLE),
    Case("growth_rate", SADDLE, PENDULUM[:4], "right", "the formula for a quadratic"),
    Case(
        "growth_rate",
        2 * w**2 / (d + sp.sqrt(d**2 + 4 * w**2)),
        PENDULUM[:4],
        "right",
        "the root in the denominator",
    ),
    Case("growth_rate", (-a + sp.sqrt(a**2 + 8)) / 2, SOFT, "right", "Duffing"),
    Case(
        "growth_rate", (-d - sp.sqrt(d**2 + 4 * w**2)) / 2, PENDULUM[:4], "wrong", "the other root"
    ),
    Case(
        "growth_rate",
        sp.Piecewise((SADDLE, d < 100), (w**2 / d, True)),
        PENDULUM[:4],
        "wrong",
        "a series where friction is strong",
    ),
    Case("growth_rate", w, PENDULUM[:4], "wrong", "without friction"),
    Case(
        "growth_rate",
        (-d + sp.sqrt(d**2 - 4 * w**2)) / 2,
        PENDULUM[:4],
        "wrong",
        "the sign of the hanging pendulum",
    ),
    Case("growth_rate", [SADDLE], PENDULUM[:4], "invalid", "a list"),
    Case("equilibrium_condition", b >= 0, ANY, "right", "zero counted in", UNIQUE),
    Case("equilibrium_condition", sp.Interval(0, sp.oo), ANY, "right", "an interval", UNIQUE),
    Case("equilibrium_condition", b > 0, ANY, "wrong", "the linear spring left out", UNIQUE),
    Case("equilibrium_condition", b < 0, ANY, "wrong", "the other sign", UNIQUE),
    Case("equilibrium_condition", True, ANY, "wrong", "always", UNIQUE),
    Case("equilibrium_condition", 0, ANY, "invalid", "a number", UNIQUE),
]
LIMITS = [
    "Values are compared between -12 and 12 for a few samples of the parameters, with those that a "
    "search from 240 starts finds.",
    "A family is followed in one integer; a family in two integers is not read.",
    "An equilibrium at which the linearisation is critical counts as of neither kind: Theorem 1.4 "
    "proves nothing there.",
]
