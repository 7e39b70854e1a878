import numpy as np
import sympy as sp
from case import Case

x, y, z = sp.symbols("x y z", real=True)
# Problem 1.1b: a saddle (3, 2) and a stable focus (0, -1); the field is defined above the parabola
# only.
PARABOLA = (sp.Matrix([sp.log(y**2 - x), x - y - 1]), [x, y])
# A double well with friction: stable nodes or foci at x = 1 and x = -1, a saddle at zero.
WELLS = ([y, x - x**3 - y], [x, y])
EMPTY = ([1, y - x], [x, y])
CENTRE = ([y, -x], [x, y])
NODE = ([-x, -y], [x, y])
CHAIN = ([y - x, z - y, x - x * z], [x, y, z])
LINE = ([x**2 - 2], [x])
root2 = sp.sqrt(2)
FOCUS = [-1 + root2 * sp.I, -1 - root2 * sp.I]
STABLE = (("kind", "asymptotically stable"),)

CASES = [
    Case(
        "equilibria",
        [[5, 5], [-5, -5]],
        ([sp.log(26 - y**2), sp.exp(x) - sp.exp(y)], [x, y]),
        "right",
        "where whole steps of Newton's method leave the region of the logarithm",
    ),
    Case(
        "equilibria",
        [[5, 5]],
        ([sp.log(26 - y**2), sp.exp(x) - sp.exp(y)], [x, y]),
        "wrong",
        "one of them is missing there",
    ),
    Case("equilibria", [(3, 2), (0, -1)], PARABOLA, "right", "tuples"),
    Case(
        "equilibria",
        [[0.0, -1.0], [3.0, 2.0]],
        PARABOLA,
        "right",
        "lists of floats in the other order",
    ),
    Case("equilibria", np.array([[3, 2], [0, -1]]), PARABOLA, "right", "an array"),
    Case(
        "equilibria", sp.Matrix([[3, 2], [0, -1]]), PARABOLA, "right", "a matrix, one row a point"
    ),
    Case("equilibria", {(3, 2), (0, -1)}, PARABOLA, "right", "a Python set"),
    Case("equilibria", [sp.Matrix([3, 2]), sp.Matrix([0, -1])], PARABOLA, "right", "columns"),
    Case("equilibria", sp.FiniteSet((3, 2), (0, -1)), PARABOLA, "right", "a set"),
    Case(
        "equilibria",
        [{sp.Symbol("y"): 2, sp.Symbol("x"): 3}, {x: 0, y: -1}],
        PARABOLA,
        "right",
        "dicts, as solve gives them",
    ),
    Case("equilibria", [(3, 2), (0, -1), (3, 2)], PARABOLA, "right", "one point twice"),
    Case("equilibria", [(0, 0, 0), (1, 1, 1)], CHAIN, "right", "three unknowns"),
    Case("equilibria", [(0, 0, 0)], CHAIN, "wrong", "one of two, three unknowns"),
    Case("equilibria", [0, 1000], ([x * (x - 1000)], [x]), "right", "one beyond all starts"),
    Case("equilibria", [root2, -root2], LINE, "right", "one unknown, exact"),
    Case("equilibria", [1.41, -1.41], LINE, "right", "one unknown, three digits"),
    Case("equilibria", [1.4, -1.4], LINE, "wrong", "two digits"),
    Case("equilibria", [], EMPTY, "right", "none exist"),
    Case("equilibria", sp.S.EmptySet, EMPTY, "right", "none exist, as the empty set"),
    Case("equilibria", [(0, 0)], EMPTY, "wrong", "a point where none exists"),
    Case("equilibria", [(3, 2)], PARABOLA, "wrong", "one overlooked"),
    Case("equilibria", [(2, 3), (-1, 0)], PARABOLA, "wrong", "coordinates interchanged"),
    Case("equilibria", [(3, 2), (0, -1), (5, 1)], PARABOLA, "wrong", "a point outside the domain"),
    Case("equilibria", [(3.02, 2), (0, -1)], PARABOLA, "wrong", "the third digit off"),
    Case(
        "equilibria",
        [(3, 2), (0, -sp.Rational(1001, 1000))],
        PARABOLA,
        "wrong",
        "exact, and off by a thousandth",
    ),
    Case("equilibria", [], PARABOLA, "wrong", "none at all"),
    Case(
        "equilibria", [(1, 0), (-1, 0)], WELLS, "wrong", "the saddle between the wells overlooked"
    ),
    Case("equilibria", ..., PARABOLA, "missing", "the untouched stub"),
    Case("equilibria", [(3, 2), ...], PARABOLA, "missing", "half of it"),
    Case("equilibria", [(3, 2, 0)], PARABOLA, "invalid", "three coordinates"),
    Case("equilibria", [(sp.I, 2)], PARABOLA, "invalid", "a complex coordinate"),
    Case("equilibria", [{x: 3}], PARABOLA, "invalid", "a dict without y"),
    Case("equilibria", sp.Eq(x, 3), PARABOLA, "invalid", "an equation"),
    Case("spectra", [[3, 2, 1, -3], [0, -1, *FOCUS]], PARABOLA, "right", "exact"),
    Case(
        "spectra",
        [[3, 2, sp.Rational(1001, 1000), -3], [0, -1, *FOCUS]],
        PARABOLA,
        "wrong",
        "exact, and off by a thousandth",
    ),
    Case(
        "equilibria",
        [(0, -sp.Rational(1001, 1000))],
        PARABOLA,
        "wrong",
        "exact, and off by a thousandth",
        STABLE,
    ),
    Case(
        "spectra",
        [(0, -1, -1 + 1.41j, -1 - 1.41j), (3, 2, -3, 1)],
        PARABOLA,
        "right",
        "decimals, another order",
    ),
    Case("spectra", sp.Matrix([[3, 2, 1, -3], [0, -1, *FOCUS]]), PARABOLA, "right", "a matrix"),
    Case(
        "spectra",
        np.array([[3, 2, 1, -3], [0, -1, -1 + 1.4142j, -1 - 1.4142j]]),
        PARABOLA,
        "right",
        "an array of complex numbers",
    ),
    Case(
        "spectra",
        [[(3, 2), [1, -3]], [(0, -1), FOCUS]],
        PARABOLA,
        "right",
        "pairs of point and eigenvalues",
    ),
    Case("spectra", [[0, 0, -1, -1]], NODE, "right", "a double eigenvalue"),
    Case("spectra", [0, 0, sp.I, -sp.I], CENTRE, "right", "imaginary ones, a single row"),
    Case("spectra", [[sp.sqrt(2), 2 * sp.sqrt(2)], [-1.414, -2.83]], LINE, "right", "one unknown"),
    Case("spectra", [[3, 2, 1, -3]], PARABOLA, "wrong", "one equilibrium left out"),
    Case(
        "spectra",
        [[3, 2, 1, -3], [0, -1, -1 + root2, -1 - root2]],
        PARABOLA,
        "wrong",
        "the imaginary unit lost",
    ),
    Case(
        "spectra",
        [[3, 2, *FOCUS], [0, -1, 1, -3]],
        PARABOLA,
        "wrong",
        "the two points interchanged",
    ),
    Case("spectra", [[0, 0, -1, -1.02]], NODE, "wrong", "a double eigenvalue taken apart"),
    Case("spectra", [[3, 2, 1, 1], [0, -1, *FOCUS]], PARABOLA, "wrong", "one root counted twice"),
    Case("spectra", [[3, 2, -1, 3], [0, -1, *FOCUS]], PARABOLA, "wrong", "signs turned"),
    Case("spectra", [[3, 2, 1.02, -3], [0, -1, *FOCUS]], PARABOLA, "wrong", "the third digit off"),
    Case(
        "spectra",
        [[1, 1, 1, -3], [0, -1, *FOCUS]],
        PARABOLA,
        "wrong",
        "at a point that is no equilibrium",
    ),
    Case("spectra", [], PARABOLA, "wrong", "no point at all"),
    Case("spectra", ..., PARABOLA, "missing", "the untouched stub"),
    Case("spectra", [[3, 2, 1, ...], [0, -1, *FOCUS]], PARABOLA, "missing", "half of it"),
    Case(
        "spectra",
        [[3, 2, 1], [0, -1, *FOCUS]],
        PARABOLA,
        "invalid",
        "one eigenvalue of a matrix of order two",
    ),
    Case("spectra", [1, -3], PARABOLA, "invalid", "eigenvalues without their points"),
    Case("spectra", {"saddle": [1, -3]}, PARABOLA, "invalid", "a dict"),
    Case("spectra", [[3, 2, "saddle", "saddle"]], PARABOLA, "invalid", "words"),
    Case("equilibria", [(0, -1)], PARABOLA, "right", "the focus", STABLE),
    Case("equilibria", (0, -1), PARABOLA, "right", "one point without the outer list", STABLE),
    Case("equilibria", {x: 0, y: -1}, PARABOLA, "right", "one dict", STABLE),
    Case("equilibria", sp.Matrix([0, -1]), PARABOLA, "right", "one column", STABLE),
    Case("equilibria", [[-1, 0], [1, 0]], WELLS, "right", "both wells", STABLE),
    Case("equilibria", [], EMPTY, "right", "none exist", STABLE),
    Case(
        "equilibria",
        [[0, 0]],
        ([y, -x - y - x**2], [x, y]),
        "right",
        "the origin, which a search finds but for rounding",
        STABLE,
    ),
    Case("equilibria", [(3, 2)], PARABOLA, "wrong", "the saddle", STABLE),
    Case("equilibria", [(3, 2), (0, -1)], PARABOLA, "wrong", "the saddle taken along", STABLE),
    Case("equilibria", [], PARABOLA, "wrong", "none", STABLE),
    Case("equilibria", [(1, 0)], WELLS, "wrong", "one of two", STABLE),
    Case("equilibria", [(0, 1)], PARABOLA, "wrong", "no equilibrium", STABLE),
    Case("equilibria", ..., PARABOLA, "missing", "the untouched stub", STABLE),
    Case("equilibria", "the lower one", PARABOLA, "invalid", "words", STABLE),
]
LIMITS = [
    "Equilibria are looked for from 240 random starts, spread over some twenty units around "
    "zero: one that lies far outside, or where the matrix of the linearisation is "
    "singular, may not be found, and a list that leaves it out would pass.",
    "Points and eigenvalues count to three significant digits; a coordinate or part that is "
    "small beside the others is measured by the size of the whole.",
    "An equilibrium whose linearisation has an eigenvalue on the imaginary axis leaves the "
    "list of stable ones unchecked.",
]
