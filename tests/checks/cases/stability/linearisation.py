import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Deviations

x, v, d, w, e, s = sp.symbols("x v delta omega epsilon sigma", real=True)
m = sp.symbols("m", positive=True)
# The pendulum with friction at the bottom and at the top.
PENDULUM = ([v, -d * v - w**2 * sp.sin(x)], [x, v])
BOTTOM = (*PENDULUM, [0, 0], [d, w])
TOP = (*PENDULUM, [sp.pi, 0], [d, w])
# An equilibrium that depends on a parameter.
MOVED = ([v, m - x**2 - v], [x, v], [sp.sqrt(m), 0], [m])
NUMBERS = ([sp.exp(x) - sp.exp(v), sp.log(2 - x**2)], [x, v], [1, 1])
FLAT = ([v**2, -(x**3)], [x, v], [0, 0])
VDP = (Deviations([v, e * (1 - x**2) * v - x], [x, v], {x: 0, v: 0}), [e])
UPRIGHT = (Deviations(*PENDULUM, {x: sp.pi, v: 0}), [d, w])
FOCUS = ([v - x, -x - v], [x, v])
REPELS = ([v + x, -x + v], [x, v])
CENTRE = ([v, -x], [x, v])
CUBIC = ([v, -x - v**3], [x, v])
HALF = ([-x, -(v**3)], [x, v])
DRIFT = ([v, 0], [x, v])
QUINTIC = ([v, -x - 10**3 * v**5], [x, v])
GROWS = ([v, -x + 20 * v**3], [x, v])

CASES = [
    Case("linearisation", [[0, 1], [-(w**2), -d]], BOTTOM, "right", "nested lists"),
    Case("linearisation", sp.Matrix([[0, 1], [w**2, -d]]), TOP, "right", "a matrix"),
    Case(
        "linearisation",
        [[0, 1], [-(sp.Symbol("omega") ** 2) * sp.cos(sp.pi), -sp.Symbol("delta")]],
        TOP,
        "right",
        "plain symbols",
    ),
    Case(
        "linearisation",
        [[0, 1], [-2 * sp.sqrt(m), -1]],
        MOVED,
        "right",
        "an equilibrium that depends on a parameter",
    ),
    Case(
        "linearisation",
        np.array([[np.e, -np.e], [-2.0, 0.0]]),
        NUMBERS,
        "right",
        "an array of floats",
    ),
    Case("linearisation", [[0, 0], [0, 0]], FLAT, "right", "nothing of first order"),
    Case(
        "linearisation",
        [[0, 1], [-(w**2), -d]],
        TOP,
        "wrong",
        "the matrix at the other equilibrium",
    ),
    Case("linearisation", [[0, -(w**2)], [1, -d]], BOTTOM, "wrong", "transposed"),
    Case("linearisation", [[0, 1], [-w, -d]], BOTTOM, "wrong", "omega for its square"),
    Case("linearisation", [[0, 1], [-(w**2), d]], BOTTOM, "wrong", "a sign"),
    Case(
        "linearisation", [[0, 1], [-m, -1]], MOVED, "wrong", "the square instead of its derivative"
    ),
    Case(
        "linearisation", [[0, 1], [0, 0]], FLAT, "wrong", "a term of second order taken for linear"
    ),
    Case("linearisation", ..., BOTTOM, "missing", "the untouched stub"),
    Case("linearisation", [[0, 1], [..., -d]], BOTTOM, "missing", "an element left open"),
    Case("linearisation", [[0, 1, 0], [1, 0, 0]], BOTTOM, "invalid", "the wrong shape"),
    Case(
        "linearisation",
        [[0, 1], [-(w**2) * sp.cos(x), -d]],
        BOTTOM,
        "invalid",
        "the equilibrium not put in",
    ),
    Case("linearisation", d + w, BOTTOM, "invalid", "an expression"),
    Case("stability_region", e < 0, VDP, "right", "the sign of the trace"),
    Case("stability_region", sp.Interval.open(-sp.oo, 0), VDP, "right", "an interval"),
    Case("stability_region", [sp.Symbol("epsilon") < 0], VDP, "right", "a list, a plain symbol"),
    Case("stability_region", e > 0, VDP, "wrong", "the other sign"),
    Case("stability_region", e <= 0, VDP, "wrong", "imaginary eigenvalues counted in"),
    Case("stability_region", True, VDP, "wrong", "always"),
    Case("stability_region", ..., VDP, "missing", "the untouched stub"),
    Case("stability_region", "negative", VDP, "invalid", "a word"),
    Case("linearisation_unstable", e > 0, VDP, "right", "the sign of the trace"),
    Case("linearisation_unstable", 0 < e, VDP, "right", "turned round"),
    Case(
        "linearisation_unstable",
        sp.Or(sp.Ne(w, 0), d < 0),
        UPRIGHT,
        "right",
        "the upper equilibrium, whatever the friction",
    ),
    Case("linearisation_unstable", d < 0, UPRIGHT, "wrong", "the saddle overlooked"),
    Case("linearisation_unstable", e >= 0, VDP, "wrong", "imaginary eigenvalues counted in"),
    Case("linearisation_unstable", sp.Or(e < 0, e > 0), VDP, "wrong", "both signs"),
    Case("linearisation_unstable", False, VDP, "wrong", "never"),
    Case("linearisation_unstable", ..., VDP, "missing", "the untouched stub"),
    Case("linearisation_unstable", 1, VDP, "invalid", "a number"),
    Case("zero_solution_stability", "asymptotically stable", FOCUS, "right", "by the spectrum"),
    Case(
        "zero_solution_stability",
        "Asymptotically-stable",
        FOCUS,
        "right",
        "a capital letter and a hyphen",
    ),
    Case("zero_solution_stability", "unstable", REPELS, "right", "by the spectrum"),
    Case(
        "zero_solution_stability",
        "stable",
        CENTRE,
        "right",
        "imaginary eigenvalues, a linear field",
    ),
    Case(
        "zero_solution_stability",
        "asymptotically stable",
        CUBIC,
        "right",
        "imaginary eigenvalues, a cubic friction",
    ),
    Case("zero_solution_stability", "asymptotically stable", HALF, "right", "one eigenvalue zero"),
    Case(
        "zero_solution_stability",
        "asymptotically stable",
        QUINTIC,
        "right",
        "a friction of fifth order",
    ),
    Case("zero_solution_stability", "unstable", DRIFT, "right", "a double eigenvalue zero"),
    Case("zero_solution_stability", "stable", ([-x, 0], [x, v]), "right", "a line of equilibria"),
    Case(
        "zero_solution_stability",
        "unstable",
        ([-x, v**2], [x, v]),
        "right",
        "attracts from one side only",
    ),
    Case(
        "zero_solution_stability",
        "stable",
        ([v, -sp.sin(x)], [x, v]),
        "right",
        "the pendulum without friction",
    ),
    Case(
        "zero_solution_stability",
        "unstable",
        GROWS,
        "right",
        "imaginary eigenvalues, a cubic excitation",
    ),
    Case("zero_solution_stability", "stable", FOCUS, "wrong", "stable means stable and no more"),
    Case("zero_solution_stability", "asymptotically stable", REPELS, "wrong", "the opposite"),
    Case(
        "zero_solution_stability", "asymptotically stable", CENTRE, "wrong", "circles do not shrink"
    ),
    Case("zero_solution_stability", "stable", CUBIC, "wrong", "the linear terms alone"),
    Case("zero_solution_stability", ..., FOCUS, "missing", "the untouched stub"),
    Case("zero_solution_stability", True, FOCUS, "invalid", "yes instead of a word"),
    Case("zero_solution_stability", "attracting", FOCUS, "invalid", "a word that was not offered"),
]
LIMITS = [
    "A matrix is compared at six rational values of the parameters: one that differs only at a "
    "single other value passes.",
    "Where the linearisation is critical, stability is decided by four motions that start "
    "at distance 0.05 and last 200 units of time; where their amplitudes then change by less "
    "than a hundredth of a per cent and yet not by zero, the answer stays unchecked.",
]
