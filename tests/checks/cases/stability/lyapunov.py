import sympy as sp
from case import Case

x, y, e, a, b = sp.symbols("x y e a b", real=True)
V = (x**2 + y**2) / 2
POL = (V, sp.Matrix([y, -e * (x**2 - 1) * y - x]), [x, y], [e])
# The damped linear oscillator with its energy, and Duffing's equation with the level 1/(4|b|)
# through its saddles.
w, d = sp.Symbol("w", positive=True), sp.Symbol("d", real=True)
ENERGY = (y**2 / 2 + w**2 * x**2 / 2, sp.Matrix([y, -d * y - w**2 * x]), [x, y], [d, w])
SPRING = ((b * x**4 + 2 * x**2 + 2 * y**2) / 4, sp.Matrix([y, -a * y - x - b * x**3]), [x, y])
ANY = (*SPRING, [b], a > 0)

CASES = [
    Case("lyapunov_derivative", -e * (x**2 - 1) * y**2, POL, "right", "factored"),
    Case("lyapunov_derivative", e * y**2 - e * x**2 * y**2, POL, "right", "expanded"),
    Case(
        "lyapunov_derivative",
        -sp.Symbol("e") * (sp.Symbol("x") ** 2 - 1) * sp.Symbol("y") ** 2,
        POL,
        "right",
        "plain symbols",
    ),
    Case("lyapunov_derivative", -e * (x**2 - 1) * y, POL, "wrong", "a factor lost"),
    Case("lyapunov_derivative", 0, POL, "wrong", "zero"),
    Case("lyapunov_derivative", x * y, POL, "wrong", "only one term"),
    Case("lyapunov_derivative", sp.Eq(x, 0), POL, "invalid", "an equation"),
    Case("lyapunov_derivative", a * y**2, POL, "invalid", "a symbol of another problem"),
    Case("vanishing_set", sp.Eq(y * (x**2 - 1), 0), POL, "right", "one equation"),
    Case(
        "vanishing_set", sp.Or(sp.Eq(y, 0), sp.Eq(x, 1), sp.Eq(x, -1)), POL, "right", "three lines"
    ),
    Case("vanishing_set", sp.Eq(y, 0), POL, "wrong", "two lines overlooked"),
    Case("vanishing_set", sp.And(sp.Eq(y, 0), sp.Eq(x, 1)), POL, "wrong", "and for or"),
    Case(
        "vanishing_set",
        sp.And(sp.Eq(y * (x**2 - 1), 0), sp.Or(sp.Ne(x, 0), sp.Ne(y, 0))),
        POL,
        "wrong",
        "without the origin",
    ),
    Case(
        "vanishing_set",
        sp.And(sp.Eq(y * (x**2 - 1), 0), sp.Abs(x) < 10**6),
        POL,
        "wrong",
        "cut off far out",
    ),
    Case(
        "vanishing_set",
        sp.Or(sp.Eq(y * (x**2 - 1), 0), sp.And(sp.Eq(x**2, 2), sp.Eq(y**2, 3))),
        POL,
        "wrong",
        "irrational points more",
    ),
    Case("vanishing_set", y, POL, "invalid", "an expression"),
    Case("asymptotic_stability_by_lyapunov", e < 0, POL, "right", "the right sign"),
    Case(
        "asymptotic_stability_by_lyapunov", sp.Interval.open(-sp.oo, 0), POL, "right", "an interval"
    ),
    Case(
        "asymptotic_stability_by_lyapunov",
        sp.Interval.open(0, sp.oo),
        ENERGY,
        "right",
        "an interval of the first of two parameters",
    ),
    Case(
        "asymptotic_stability_by_lyapunov",
        sp.And(e < 0, e > -(10**7)),
        POL,
        "wrong",
        "cut off far out",
    ),
    Case(
        "asymptotic_stability_by_lyapunov",
        sp.And(e < 0, sp.Ne(e**2, 2)),
        POL,
        "wrong",
        "an irrational value left out",
    ),
    Case(
        "global_stability_by_lyapunov", sp.And(b >= 0, b <= 1000), ANY, "wrong", "cut off far out"
    ),
    Case("asymptotic_stability_by_lyapunov", e > 0, POL, "wrong", "the other sign"),
    Case(
        "asymptotic_stability_by_lyapunov", e <= 0, POL, "wrong", "V' identically zero counted in"
    ),
    Case("asymptotic_stability_by_lyapunov", "negative", POL, "invalid", "a word"),
    Case("rate_on_vanishing_set", -(w**2) * x, ENERGY, "right", "on the set"),
    Case(
        "rate_on_vanishing_set",
        -d * y - w**2 * x,
        ENERGY,
        "right",
        "with a term that vanishes on the set",
    ),
    Case("rate_on_vanishing_set", w**2 * x, ENERGY, "wrong", "the sign turned"),
    Case("rate_on_vanishing_set", 0, ENERGY, "wrong", "as if motions stayed"),
    Case("rate_on_vanishing_set", sp.Eq(y, 0), ENERGY, "invalid", "the set itself"),
    Case(
        "asymptotic_stability_by_lyapunov",
        d > 0,
        ENERGY,
        "right",
        "whatever the positive frequency",
    ),
    Case("asymptotic_stability_by_lyapunov", d >= 0, ENERGY, "wrong", "no friction counted in"),
    Case("global_stability_by_lyapunov", b >= 0, ANY, "right", "zero counted in"),
    Case("global_stability_by_lyapunov", sp.Interval(0, sp.oo), ANY, "right", "an interval"),
    Case("global_stability_by_lyapunov", b > 0, ANY, "wrong", "the linear spring left out"),
    Case(
        "global_stability_by_lyapunov",
        b > -sp.Rational(1, 100),
        ANY,
        "wrong",
        "a little below zero",
    ),
    Case("global_stability_by_lyapunov", True, ANY, "wrong", "always"),
    Case("global_stability_by_lyapunov", "hard springs", ANY, "invalid", "words"),
]
LIMITS = [
    "The derivative is judged at 24 random states and parameters: an expression that agrees "
    "there and differs elsewhere would pass (none that a derivation gives does).",
    "That no motion stays where the derivative vanishes is not tested: the problem has to be such.",
    "Stability in the large is judged on circles of radius 0.01 to 10000.",
]
