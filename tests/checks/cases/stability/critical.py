import numpy as np
import sympy as sp
from case import Case
from sympy import I

x, v, y, u, t, h, x0, v0 = sp.symbols("x v y u t h x0 v0", real=True)
w = sp.symbols("omega", positive=True)
a, b = sp.symbols("a b", real=True)
SPEED = sp.symbols("V0", positive=True)

SWING = ([v, -(w**2) * x], [x, v], [w])
# one oscillator drives another of the same frequency
PAIR = ([v, -x + y, u, -y], [x, v, y, u], [])
TWO = ([v, -x, u, -y], [x, v, y, u], [])
DRIFT = ([v, 0 * x], [x, v], [])
SETTLES = ([v, -w * v], [x, v], [w])
FALLS = ([-w * x, x - 2 * w * v], [x, v], [w])
SADDLE = ([v, w**2 * x], [x, v], [w])
# A point driven along a line at the speed V0: deviations of its place drift with its direction y.
DRIVEN = (
    [v * sp.cos(y), v * sp.sin(y), -v + u],
    [x, a, v],
    [SPEED],
    {x: SPEED * t, a: 0, v: SPEED},
    [x, v],
)
NONLINEAR = ([v, -sp.sin(w**2 * x) - v**2], [x, v], [w])
FRICTION = ([v, -b * v - a * x], [x, v], [a, b])

CASES = [
    Case(
        "eigenvalue_multiplicities",
        [[I * w, 1, 1], [-I * w, 1, 1]],
        SWING,
        "right",
        "a simple pair",
    ),
    Case(
        "eigenvalue_multiplicities",
        [(-I * sp.Symbol("omega"), 1, 1), (I * sp.Symbol("omega"), 1.0, 1)],
        SWING,
        "right",
        "tuples, a plain symbol, floats for whole numbers",
    ),
    Case(
        "eigenvalue_multiplicities",
        [[I * w, 1, 1], [-I * w, 1, 1]],
        NONLINEAR,
        "right",
        "of the linearisation",
    ),
    Case(
        "eigenvalue_multiplicities",
        {I: (2, 1), -I: (2, 1)},
        PAIR,
        "right",
        "a dict; Jordan blocks at imaginary eigenvalues",
    ),
    Case(
        "eigenvalue_multiplicities",
        sp.Matrix([[I, 2, 2], [-I, 2, 2]]),
        TWO,
        "right",
        "a matrix; semisimple",
    ),
    Case(
        "eigenvalue_multiplicities",
        np.array([[1j, 2, 2], [-1j, 2, 2]]),
        TWO,
        "right",
        "an array of complex numbers",
    ),
    Case("eigenvalue_multiplicities", [[0, 2, 1]], DRIFT, "right", "a single eigenvalue"),
    Case(
        "eigenvalue_multiplicities",
        sp.Matrix([[0, 1], [0, 0]]).eigenvects(),
        DRIFT,
        "right",
        "as eigenvects returns them",
    ),
    Case(
        "eigenvalue_multiplicities",
        [[0, 1, 1], [-1, 1, 1]],
        DRIVEN,
        "right",
        "a part of the deviations from a nominal motion",
    ),
    Case(
        "eigenvalue_multiplicities",
        [[I, 2, 2], [-I, 2, 2]],
        PAIR,
        "wrong",
        "Jordan blocks overlooked",
    ),
    Case(
        "eigenvalue_multiplicities",
        [[I, 2, 1], [-I, 2, 1]],
        TWO,
        "wrong",
        "Jordan blocks where there are none",
    ),
    Case("eigenvalue_multiplicities", [[0, 2, 2]], DRIFT, "wrong", "one eigenvector too many"),
    Case("eigenvalue_multiplicities", [[0, 1, 1]], DRIFT, "wrong", "one multiplicity lost"),
    Case("eigenvalue_multiplicities", [[0, 1, 1], [0, 1, 1]], DRIFT, "wrong", "listed twice"),
    Case("eigenvalue_multiplicities", [[0, 1, 1], [-2, 1, 1]], DRIVEN, "wrong", "no eigenvalue"),
    Case("eigenvalue_multiplicities", ..., DRIFT, "missing", "the untouched stub"),
    Case("eigenvalue_multiplicities", [[0, 2]], DRIFT, "invalid", "two numbers in a row"),
    Case("eigenvalue_multiplicities", [0, 0], DRIFT, "invalid", "the eigenvalues alone"),
    Case(
        "eigenvalue_multiplicities",
        [[0, sp.Rational(3, 2), 1]],
        DRIFT,
        "invalid",
        "half a multiplicity",
    ),
    Case("critical_stability", "stable", SWING, "right", "a swing"),
    Case("critical_stability", "unstable", PAIR, "right", "Jordan blocks"),
    Case(
        "critical_stability",
        "Asymptotically stable",
        FALLS,
        "right",
        "all on the left, in capitals",
    ),
    Case("critical_stability", "unstable", SADDLE, "right", "a root on the right"),
    Case(
        "critical_stability",
        "stable",
        DRIVEN,
        "right",
        "a part of the deviations from a nominal motion",
    ),
    Case("critical_stability", "stable", PAIR, "wrong", "Jordan blocks overlooked"),
    Case("critical_stability", "asymptotically stable", SETTLES, "wrong", "a simple zero"),
    Case("critical_stability", "unstable", TWO, "wrong", "semisimple double roots"),
    Case("critical_stability", ..., TWO, "missing", "the untouched stub"),
    Case("critical_stability", True, TWO, "invalid", "a truth value"),
    Case(
        "stable_parameters",
        sp.Or(sp.And(a > 0, b >= 0), sp.And(sp.Eq(a, 0), b > 0)),
        FRICTION,
        "right",
        "the borders as they are",
    ),
    Case(
        "stable_parameters",
        sp.And(a >= 0, b >= 0, sp.Ne(a**2 + b**2, 0)),
        FRICTION,
        "right",
        "in one formula",
    ),
    Case("stable_parameters", sp.And(a > 0, b > 0), FRICTION, "wrong", "asymptotic stability only"),
    Case("stable_parameters", a > 0, FRICTION, "wrong", "the sign of the friction forgotten"),
    Case("stable_parameters", ..., FRICTION, "missing", "the untouched stub"),
    Case("stable_parameters", a, FRICTION, "invalid", "an expression"),
    Case("unbounded_motion", [h * t, h], (*DRIFT, t, [h]), "right", "a drift"),
    Case("unbounded_motion", sp.Matrix([t, 1]), (*DRIFT, t), "right", "without a size"),
    Case(
        "unbounded_motion",
        [sp.exp(w * t), w * sp.exp(w * t)],
        (*SADDLE, t),
        "right",
        "exponential growth",
    ),
    Case(
        "unbounded_motion",
        [(sp.sin(t) - t * sp.cos(t)) / 2, t * sp.sin(t) / 2, sp.sin(t), sp.cos(t)],
        (*PAIR, t),
        "right",
        "resonance",
    ),
    Case(
        "unbounded_motion",
        [sp.sin(t), sp.cos(t), 0, 0],
        (*PAIR, t),
        "wrong",
        "a motion that does not grow",
    ),
    Case("unbounded_motion", [t, 2], (*DRIFT, t), "wrong", "not a motion"),
    Case("unbounded_motion", [0, 0], (*DRIFT, t), "wrong", "the equilibrium"),
    Case(
        "unbounded_motion",
        [sp.exp(-w * t), -w * sp.exp(-w * t)],
        (*SADDLE, t),
        "wrong",
        "it grows backwards only",
    ),
    Case("unbounded_motion", [I * t, I], (*DRIFT, t), "wrong", "not real"),
    Case("unbounded_motion", ..., (*DRIFT, t), "missing", "the untouched stub"),
    Case("unbounded_motion", t, (*DRIFT, t), "invalid", "one component"),
    Case("limit_state", [x0 + v0 / w, 0], (*SETTLES, [x0, v0]), "right", "a list"),
    Case(
        "limit_state", sp.Matrix([(w * x0 + v0) / w, 0]), (*SETTLES, [x0, v0]), "right", "a column"
    ),
    Case("limit_state", [0, 0], (*FALLS, [x0, v0]), "right", "everything decays"),
    Case("limit_state", [x0, 0], (*SETTLES, [x0, v0]), "wrong", "the way covered forgotten"),
    Case("limit_state", [0, 0], (*SETTLES, [x0, v0]), "wrong", "it does not come back"),
    Case("limit_state", ..., (*SETTLES, [x0, v0]), "missing", "the untouched stub"),
    Case(
        "limit_state",
        [x0 + v0 * sp.exp(-t), 0],
        (*SETTLES, [x0, v0]),
        "invalid",
        "a function of time",
    ),
    Case("conserved_quadratic_form", v**2 / 2 + w**2 * x**2 / 2, SWING, "right", "the energy"),
    Case("conserved_quadratic_form", 3 * (v**2 + w**2 * x**2), SWING, "right", "a multiple of it"),
    Case(
        "conserved_quadratic_form",
        (x**2 + v**2) + 2 * (y**2 + u**2) + x * y + v * u,
        TWO,
        "right",
        "with mixed terms",
    ),
    Case("conserved_quadratic_form", v**2 - w**2 * x**2, SWING, "wrong", "a sign"),
    Case("conserved_quadratic_form", -(v**2) - w**2 * x**2, SWING, "wrong", "negative definite"),
    Case("conserved_quadratic_form", x**2 + v**2, TWO, "wrong", "one oscillator only"),
    Case(
        "conserved_quadratic_form",
        x**2 + v**2 + y**2 + u**2 + 3 * (x * y + v * u),
        TWO,
        "wrong",
        "conserved but indefinite",
    ),
    Case(
        "conserved_quadratic_form",
        (w - 3) ** 2 * (v**2 + w**2 * x**2),
        SWING,
        "wrong",
        "zero for omega = 3",
    ),
    Case(
        "conserved_quadratic_form",
        sp.exp(-w) * (v**2 + w**2 * x**2),
        SWING,
        "right",
        "times what is positive everywhere",
    ),
    Case("conserved_quadratic_form", v**2 + w**2 * x**2 + 1, SWING, "wrong", "not zero at zero"),
    Case(
        "conserved_quadratic_form", (v**2 + w**2 * x**2) ** 2, SWING, "wrong", "no quadratic form"
    ),
    Case("conserved_quadratic_form", ..., SWING, "missing", "the untouched stub"),
    Case("conserved_quadratic_form", sp.Eq(v**2 + w**2 * x**2, 1), SWING, "invalid", "an equation"),
]
LIMITS = [
    "Multiplicities and the verdict are judged at six sets of values of the parameters: a "
    "special value at which eigenvalues meet by chance is not looked at, and the answer is to "
    "hold for the others.",
    "Eigenvalues closer together than 2e-5 of the size of the matrix count as one.",
    "A motion that grows slower than by a factor of 1000 between t = 10 and t = 1000000 (such as "
    "log t) is taken not to grow.",
]
