import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear

a, b = sp.symbols("alpha beta", real=True)
w = sp.symbols("omega", positive=True)
r = sp.symbols("r", real=True)
p = sp.Symbol("alpha")
M = sp.Matrix
# A chain that is seen from its head, and one whose output loses the eigenvalue 0: the motion (1, 0,
# -1) is not seen.
CHAIN = (Linear(M([[0, 1, 0], [0, 0, 1], [2, 0, 0]]), H=M([[1, 0, 0]])),)
LOST = (Linear(M([[0, 1, 0], [1, 1, 1], [1, 0, 1]]), H=M([[0, 1, 0]])),)
# Two equal oscillators: their difference, a motion of two dimensions, is not seen.
TWINS = (
    Linear(
        M([[0, 1, 0, 0], [-(w**2), 0, 0, 0], [0, 0, 0, 1], [0, 0, -(w**2), 0]]), H=M([[1, 0, 1, 0]])
    ),
    [w],
)
# The eigenvalues 1 and 4 are lost for alpha = 1 and alpha = -4; the last example for irrational
# values.
VALUE = (M([[0, 1], [-4, 5]]), M([[1 - a, 4 + a]]), [a])
RATIONAL = (Linear(M([[1, 0], [0, 2]]), H=M([[a - 1, 2 * a + 3]])), [a])
ROOTS = (Linear(M([[0, 1], [2, 0]]), H=M([[a, 1]])), [a])
BLIND = (Linear(M([[0, 1], [2, 0]]), H=M([[0, 0]])),)
TWO_OUTPUTS = (Linear(M([[0, 1], [1, 0]]), H=M([[a, 0], [0, b]])), [a, b])
CURVE = (Linear(M([[0, 1], [-b, -a]]), H=M([[1, 1]])), [a, b])
MODES = (Linear(M([[a, 0], [0, b]]), H=M([[1, 1]])), [a, b])
EQUAL = (Linear(M([[1, 0], [0, 1]]), H=M([[1, r]])), [r])
GAINS = (Linear(M([[1, 0], [0, 1]]), H=M([[a, b]])), [a, b])
ALWAYS = (Linear(M([[0, 1], [-(w**2), 0]]), H=M([[1, 0]])), [w])
SOMETIMES = (Linear(M([[0, 1], [-(w**2), 0]]), H=M([[1 - w, 0]])), [w])
NEVER = (Linear(M([[a, 0], [0, a]]), H=M([[1, 1]])), [a])
u, v = [1, 0, -1, 0], [0, 1, 0, -1]
# A platform levelled by the speed that it shows, with a drift and a bias; names of its start.
g, R = sp.symbols("g R", positive=True)
PLATFORM = (
    Linear(M([[0, -g, 0, 1], [1 / R, 0, 1, 0], [0, 0, 0, 0], [0, 0, 0, 0]]), H=M([[1, 0, 0, 0]])),
    [g, R],
    sp.symbols("v phi eps b"),
)
# The range of a satellite that stands nearly still, along a direction neither in the plane of the
# orbit nor across it.
n1, n2, n3 = sp.symbols("n1", real=True), *sp.symbols("n2 n3", real=True, nonzero=True)
RANGE = (
    Linear(
        M(
            [
                [0, 0, 0, 1, 0, 0],
                [0, 0, 0, 0, 1, 0],
                [0, 0, 0, 0, 0, 1],
                [3 * w**2, 0, 0, 0, 2 * w, 0],
                [0, 0, 0, -2 * w, 0, 0],
                [0, 0, -(w**2), 0, 0, 0],
            ]
        ),
        H=M([[n1, n2, n3, 0, 0, 0]]),
    ),
    [w, n1, n2, n3],
)
FIRST, OTHER = (
    [1, 0, -n1 / n3, 0, -2 * w, 2 * n2 * w / n3],
    [0, 2, -2 * n2 / n3, w, 0, -n1 * w / n3],
)

CASES = [
    Case("observable", "yes", CHAIN, "right", "nothing stays unseen"),
    Case("observable", False, LOST, "right", "a motion stays unseen"),
    Case("observable", True, ALWAYS, "right", "for every positive omega"),
    Case("observable", "no", SOMETIMES, "right", "not for all values of the parameter"),
    Case("observable", "no", NEVER, "right", "for no value of the parameter"),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a, 1.41), sp.Ne(a, -1.41)),
        ROOTS,
        "right",
        "irrational values in decimals",
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a, 1.42), sp.Ne(a, -1.41)),
        ROOTS,
        "wrong",
        "three digits are asked",
    ),
    Case(
        "observable_parameters",
        sp.Ne(a, sp.sqrt(2)),
        ROOTS,
        "wrong",
        "one of the irrational values",
    ),
    Case("observable", "no", CHAIN, "wrong", "the opposite"),
    Case("observable", "yes", LOST, "wrong", "the opposite"),
    Case("observable", "yes", SOMETIMES, "wrong", "one value overlooked"),
    Case("observable", ..., CHAIN, "missing", "the untouched stub"),
    Case("observable", 3, CHAIN, "invalid", "the rank"),
    Case("observable", sp.Ne(w, 1), SOMETIMES, "invalid", "the condition where yes or no is asked"),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a, 1), sp.Ne(a, -sp.Rational(3, 2))),
        RATIONAL,
        "right",
        "two values left out",
    ),
    Case(
        "observable_parameters",
        sp.Ne((p - 1) * (2 * p + 3), 0),
        RATIONAL,
        "right",
        "the determinant, a plain symbol",
    ),
    Case(
        "observable_parameters",
        sp.S.Reals - sp.FiniteSet(1, -1.5),
        RATIONAL,
        "right",
        "a set, with a decimal",
    ),
    Case(
        "observable_parameters",
        sp.Or(a < -1.41, sp.And(a > -1.41, a < 1.41), a > 1.41),
        ROOTS,
        "right",
        "decimals left out by intervals",
    ),
    Case(
        "observable_parameters",
        sp.S.Reals - sp.FiniteSet(-1.414, 1.414),
        ROOTS,
        "right",
        "a set that leaves out decimals",
    ),
    Case(
        "observable_parameters",
        sp.Or(a < -1.41, sp.And(a >= -1.41, a < 1.41), a > 1.41),
        ROOTS,
        "wrong",
        "one of the decimals not left out",
    ),
    Case(
        "observable_parameters",
        sp.Or(a < -1.41, sp.And(a > -1.41, a < 1.4), a > 1.41),
        ROOTS,
        "wrong",
        "an interval with two digits",
    ),
    Case("observable_parameters", sp.Ne(a**2, 2), ROOTS, "right", "two irrational values"),
    Case(
        "observable_parameters", sp.Ne(sp.Abs(a), sp.sqrt(2)), ROOTS, "right", "an absolute value"
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a, sp.sqrt(2)), sp.Ne(a, -sp.sqrt(2))),
        ROOTS,
        "right",
        "irrational values, named",
    ),
    Case(
        "observable_parameters",
        sp.Or(sp.Ne(a, 0), sp.Ne(b, 0)),
        TWO_OUTPUTS,
        "right",
        "a single point left out",
    ),
    Case("observable_parameters", sp.Ne(1 - a + b, 0), CURVE, "right", "a line left out"),
    Case("observable_parameters", sp.Ne(a, b), MODES, "right", "different eigenvalues"),
    Case("observable_parameters", True, ALWAYS, "right", "all values"),
    Case("observable_parameters", w > 0, ALWAYS, "right", "all values that the data allow"),
    Case("observable_parameters", False, NEVER, "right", "none"),
    Case("observable_parameters", sp.Ne(a, 1), RATIONAL, "wrong", "the other value overlooked"),
    Case(
        "observable_parameters",
        sp.Ne(a, sp.sqrt(2)),
        ROOTS,
        "wrong",
        "the negative root overlooked",
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a**2, 2), sp.Ne(a**2, 3)),
        ROOTS,
        "wrong",
        "irrational values left out in vain",
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a, 1.414), sp.Ne(a, -1.414)),
        ROOTS,
        "right",
        "irrational values, rounded to four digits",
    ),
    Case("observable_parameters", True, ROOTS, "wrong", "the exceptional values overlooked"),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a, 0), sp.Ne(b, 0)),
        TWO_OUTPUTS,
        "wrong",
        "two lines in the place of a point",
    ),
    Case("observable_parameters", True, TWO_OUTPUTS, "wrong", "the point overlooked"),
    Case("observable_parameters", sp.Ne(1 + a + b, 0), CURVE, "wrong", "a sign"),
    Case(
        "observable_parameters",
        sp.Or(sp.Ne(a - b, 1), sp.Eq(a, 2)),
        CURVE,
        "wrong",
        "a single point of the line taken along",
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(a - b, 1), sp.Or(sp.Ne(a, 3), sp.Ne(b, 0))),
        CURVE,
        "wrong",
        "a point too many left out",
    ),
    Case("observable_parameters", a > b, MODES, "wrong", "half of the plane"),
    Case("observable_parameters", ..., RATIONAL, "missing", "the untouched stub"),
    Case("observable_parameters", 1, RATIONAL, "invalid", "the value alone"),
    Case(
        "observable_parameters",
        sp.Ne(sp.Symbol("gamma"), 1),
        RATIONAL,
        "invalid",
        "a symbol that the problem does not have",
    ),
    Case(
        "unobservable_parameters",
        sp.Or(sp.Eq(a, 1), sp.Eq(a, -sp.Rational(3, 2))),
        RATIONAL,
        "right",
        "equations",
    ),
    Case("unobservable_parameters", {1, -1.5}, RATIONAL, "right", "a set of values"),
    Case(
        "unobservable_parameters",
        [sp.sqrt(2), -sp.sqrt(2)],
        ROOTS,
        "right",
        "a list of irrational values",
    ),
    Case(
        "unobservable_parameters",
        sp.FiniteSet(1, -sp.Rational(3, 2)),
        RATIONAL,
        "right",
        "a finite set of SymPy",
    ),
    Case("unobservable_parameters", [], ALWAYS, "right", "none"),
    Case("unobservable_parameters", sp.Eq(a, b), MODES, "right", "a line"),
    Case("unobservable_parameters", [1], RATIONAL, "wrong", "one value alone"),
    Case(
        "unobservable_parameters",
        [sp.Eq(a, 1), sp.Eq(2 * a, -3)],
        RATIONAL,
        "wrong",
        "conditions in a list hold together",
    ),
    Case("unobservable_parameters", [1, -1.5, 2], RATIONAL, "wrong", "a value too many"),
    Case("unobservable_parameters", sp.Ne(a, b), MODES, "wrong", "where it is observable"),
    Case("unobservable_parameters", "alpha = 1", RATIONAL, "invalid", "text"),
    Case("unobservable_states", [[1, 0, -1]], LOST, "right", "a list of one vector"),
    Case("unobservable_states", [-2, 0, 2], LOST, "right", "the vector itself, another length"),
    Case("unobservable_states", M([1, 0, -1]), LOST, "right", "a column"),
    Case("unobservable_states", np.array([[0.707, 0, -0.707]]), LOST, "right", "decimals"),
    Case("unobservable_states", np.array([[0.707, 0, -0.716]]), LOST, "wrong", "one per cent off"),
    Case("unobservable_states", [M(u), M(v)], TWINS, "right", "as nullspace() gives them"),
    Case(
        "unobservable_states",
        M([u, [1, w, -1, -w]]).T,
        TWINS,
        "right",
        "columns of a matrix, one with a parameter",
    ),
    Case("unobservable_states", {tuple(u), (0, 1, 0, -1)}, TWINS, "right", "a set of tuples"),
    Case("unobservable_states", [], CHAIN, "right", "none"),
    Case(
        "unobservable_states", sp.zeros(3, 0), CHAIN, "right", "none, as a matrix without columns"
    ),
    Case("unobservable_states", [[1, 0, 1]], LOST, "wrong", "a vector that is seen"),
    Case("unobservable_states", [[0, 0, 0]], LOST, "wrong", "zero"),
    Case("unobservable_states", [], LOST, "wrong", "one overlooked"),
    Case("unobservable_states", [u], TWINS, "wrong", "one of two"),
    Case("unobservable_states", [u, v, [1, 1, -1, -1]], TWINS, "wrong", "dependent"),
    Case("unobservable_states", [[1, 0.02, -1]], LOST, "wrong", "the second digit off"),
    Case("unobservable_states", [[r, -1]], EQUAL, "right", "for every value of the parameter"),
    Case(
        "unobservable_states",
        [[r * (1 + r**2), -1 - r**2]],
        EQUAL,
        "right",
        "a factor that is never zero",
    ),
    Case("unobservable_states", [[1, -1 / r]], EQUAL, "wrong", "not defined at one value"),
    Case("unobservable_states", [[r**2 - 2 * r, 2 - r]], EQUAL, "wrong", "zero at one value"),
    Case(
        "unobservable_states",
        [[r**3 - 2 * r, 2 - r**2]],
        EQUAL,
        "wrong",
        "zero at irrational values",
    ),
    Case(
        "unobservable_states",
        [[-b, a]],
        GAINS,
        "right",
        "two parameters: zero only where another vector is unseen too",
    ),
    Case(
        "unobservable_states",
        [[-b * (1 + a**2), a + a**3]],
        GAINS,
        "right",
        "two parameters, a factor that is never zero",
    ),
    Case(
        "unobservable_states",
        [[-b / a, 1]],
        GAINS,
        "wrong",
        "two parameters: divided by one of them",
    ),
    Case(
        "unobservable_states",
        [[-b * (a - b), a * (a - b)]],
        GAINS,
        "wrong",
        "two parameters: zero on a line",
    ),
    Case(
        "unobservable_states",
        {"v": 0, "phi": 1, "eps": 0, "b": g},
        PLATFORM,
        "right",
        "a dict by the names of the start",
    ),
    Case(
        "unobservable_states",
        [{"v": 0, "phi": -3 / g, "eps": 0, "b": -3}],
        PLATFORM,
        "right",
        "in a list, a multiple",
    ),
    Case("unobservable_states", {"v": 0, "phi": 1, "eps": 0, "b": -g}, PLATFORM, "wrong", "a sign"),
    Case("unobservable_states", [0, g - R, 0, g * (g - R)], PLATFORM, "wrong", "zero for g = R"),
    Case(
        "unobservable_states", {"v": 0, "phi": 1, "b": g}, PLATFORM, "invalid", "three components"
    ),
    Case(
        "unobservable_states",
        {"v": 0, "phi": 1},
        LOST,
        "invalid",
        "names that the data do not have",
    ),
    Case("unobservable_states", [FIRST, OTHER], RANGE, "right", "in six coordinates"),
    Case(
        "unobservable_states",
        [[p + q for p, q in zip(FIRST, OTHER)], OTHER],
        RANGE,
        "right",
        "another basis",
    ),
    Case(
        "unobservable_states",
        [[n2 * n3 * p for p in FIRST], OTHER],
        RANGE,
        "right",
        "zero where it is not asked",
    ),
    Case("unobservable_states", [FIRST, [0] * 6], RANGE, "wrong", "one of them zero"),
    Case(
        "unobservable_states",
        [[n1 * p for p in FIRST], OTHER],
        RANGE,
        "wrong",
        "zero for a sight across",
    ),
    Case(
        "unobservable_states",
        [[-n2, n1, 0, 0, 0, 0], [0, -n3, n2, 0, 0, 0]],
        RANGE,
        "wrong",
        "displacements across",
    ),
    Case("unobservable_states", [[1, 0, -1, 0]], LOST, "invalid", "four components"),
    Case("unobservable_states", sp.eye(2), LOST, "invalid", "a matrix of another order"),
    Case("fixed_eigenvalues", [0], LOST, "right", "a list"),
    Case("fixed_eigenvalues", 0, LOST, "right", "the number itself"),
    Case(
        "fixed_eigenvalues",
        {sp.I * w, -sp.I * w},
        TWINS,
        "right",
        "a pair that depends on a parameter",
    ),
    Case("fixed_eigenvalues", sp.FiniteSet(sp.I * w, -sp.I * w), TWINS, "right", "a finite set"),
    Case(
        "fixed_eigenvalues",
        {sp.I * w: 2, -sp.I * w: 2},
        TWINS,
        "right",
        "as eigenvals() gives them",
    ),
    Case("fixed_eigenvalues", sp.S.EmptySet, CHAIN, "right", "none"),
    Case("fixed_eigenvalues", np.array([1.41, -1.41]), BLIND, "right", "decimals"),
    Case("fixed_eigenvalues", [0, 2], LOST, "wrong", "an eigenvalue that is seen"),
    Case("fixed_eigenvalues", [1], LOST, "wrong", "no eigenvalue"),
    Case("fixed_eigenvalues", [], LOST, "wrong", "overlooked"),
    Case("fixed_eigenvalues", [sp.I * w], TWINS, "wrong", "one of the pair"),
    Case("fixed_eigenvalues", [w, -w], TWINS, "wrong", "real in the place of imaginary"),
    Case("fixed_eigenvalues", [1.4, -1.4], BLIND, "wrong", "two digits"),
    Case("fixed_eigenvalues", "none", CHAIN, "invalid", "a word"),
]
LIMITS = [
    "A condition with other terms than rational functions, roots and absolute values (a "
    "logarithm, say) is compared at points; the verdict says at how many.",
    "Matrices, vectors and eigenvalues with parameters are judged at six rational values in "
    "general position; a basis has to be one at all values at which as much is unseen as there.",
    "The numbers of the data have to be rational.",
]
