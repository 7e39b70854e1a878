import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Mechanical

b = sp.symbols("beta", real=True)
W, r = sp.symbols("Omega r0", positive=True)
# Loses exactly lambda = -1; loses the pair of the factor lambda^2 - 3; loses nothing.
GYRO = (Mechanical([[3, 0], [0, 1]], [[0, -1], [1, 0]], [[-2, 1], [1, -1]], H2=[[1, 2]]),)
PAIR = (Mechanical([[2, 1], [1, 1]], 0, [[-5, 0], [0, 6]], H1=[[1, 3]]),)
SEEN = (Mechanical([[2, 1], [1, 2]], 0, [[0, -1], [-1, 0]], H1=[[1, 0]], H2=[[1, 0]]),)
# One equation of the first order: M is singular.
SINGULAR = (Mechanical([[3, 0], [0, 0]], [[0, -1], [1, 1]], [[-2, 1], [1, -1]], H2=[[1, 2]]),)
# Motion near a circular orbit.
ORBIT = {"M": sp.eye(2), "D": [[0, 2 * W / r], [-2 * W * r, 0]], "K": sp.diag(0, -3 * W**2)}
ALONG, ACROSS = (
    (Mechanical(**ORBIT, H1=[[1, 0]]), [W, r]),
    (Mechanical(**ORBIT, H1=[[0, 1]]), [W, r]),
)
TANGENT, NORMAL = (Mechanical(**ORBIT, L=[1, 0]), [W, r]), (Mechanical(**ORBIT, L=[0, 1]), [W, r])
VALUE = (Mechanical([[1, 1], [1, 2]], 0, [[1, 1], [3, b]], L=[1, 3]), [b])
FREE = (Mechanical(sp.eye(2), 0, sp.diag(1, b), L=[1, 1]), [b])
DRIVEN = (Mechanical([[2, 1], [1, 3]], 0, [[3, 1], [1, -2]], L=[2, 1]),)
# Two masses between three equal springs: the sum swings with 1, the difference with sqrt(3).
STIFFNESS = [[2, -1], [-1, 2]]
SPRINGS = (Mechanical(sp.eye(2), 0, STIFFNESS),)
SUM = (Mechanical(sp.eye(2), 0, STIFFNESS, H1=[[1, 1]]),)
FIRST = (Mechanical(sp.eye(2), 0, STIFFNESS, H1=[[1, 0]]),)
# One mass repelled, displacement and velocity measured together: e^-t is lost.
REPELLED, MIXED = (
    (Mechanical([[2]], 0, [[-2]]),),
    (Mechanical([[2]], 0, [[-2]], H1=[[1]], H2=[[1]]),),
)
# Free masses with friction on the first: a triple root zero.
SLIDING = (Mechanical(sp.eye(2), sp.diag(1, 0), 0),)
i, root3 = sp.I, sp.sqrt(3)
# A spring whose stiffness is a parameter.
stiff = sp.symbols("kappa", real=True)
TUNED = (Mechanical([[1]], 0, [[stiff]]), [stiff])

CASES = [
    Case("observable", "yes", SEEN, "right", "the rank is full everywhere"),
    Case("observable", "no", GYRO, "right", "one value is lost"),
    Case("observable", True, SINGULAR, "right", "M is singular"),
    Case("observable", True, ALONG, "right", "for all positive values of the parameters"),
    Case("observable", False, ACROSS, "right", "for none"),
    Case("observable", "yes", PAIR, "wrong", "irrational values overlooked"),
    Case("observable", "no", SEEN, "wrong", "the opposite"),
    Case("observable", "yes", ACROSS, "wrong", "the root 0 overlooked"),
    Case("observable", ..., SEEN, "missing", "the untouched stub"),
    Case("observable", -1, GYRO, "invalid", "the value that is lost"),
    Case("fixed_eigenvalues", [-1], GYRO, "right", "one value"),
    Case("fixed_eigenvalues", {sp.sqrt(3), -sp.sqrt(3)}, PAIR, "right", "an irrational pair"),
    Case("fixed_eigenvalues", [1.73, -1.73], PAIR, "right", "decimals"),
    Case("fixed_eigenvalues", [0], ACROSS, "right", "with parameters"),
    Case("fixed_eigenvalues", [], SEEN, "right", "none"),
    Case("fixed_eigenvalues", [sp.sqrt(3)], PAIR, "wrong", "one of the pair"),
    Case("fixed_eigenvalues", [-1, 1], GYRO, "wrong", "a root that is seen, or none at all"),
    Case("fixed_eigenvalues", [3], PAIR, "wrong", "the square"),
    Case("fixed_eigenvalues", [], GYRO, "wrong", "overlooked"),
    Case("fixed_eigenvalues", True, GYRO, "invalid", "yes"),
    Case("controllable", "yes", DRIVEN, "right", "the rank is full everywhere"),
    Case("controllable", "yes", TANGENT, "right", "for all positive values of the parameters"),
    Case("controllable", "no", NORMAL, "right", "for none"),
    Case("controllable", "no", VALUE, "right", "not for all values"),
    Case("controllable", "no", DRIVEN, "wrong", "the opposite"),
    Case("controllable", "yes", VALUE, "wrong", "one value overlooked"),
    Case("controllable", sp.Ne(b, 3), VALUE, "invalid", "the condition where yes or no is asked"),
    Case("controllable_parameters", sp.Ne(b, 3), VALUE, "right", "one value left out"),
    Case(
        "controllable_parameters",
        sp.Ne(sp.Symbol("beta"), 1),
        FREE,
        "right",
        "equal frequencies, a plain symbol",
    ),
    Case("controllable_parameters", sp.S.Reals - sp.FiniteSet(3), VALUE, "right", "a set"),
    Case("controllable_parameters", sp.Ne(b, 0), VALUE, "wrong", "another value"),
    Case("controllable_parameters", b > 1, FREE, "wrong", "one side only"),
    Case("controllable_parameters", True, FREE, "wrong", "the value overlooked"),
    Case("controllable_parameters", [b, 3], VALUE, "invalid", "a list of numbers"),
    Case("fixed_eigenvalues", [0], NORMAL, "right", "with parameters"),
    Case("fixed_eigenvalues", [], TANGENT, "right", "none"),
    Case("fixed_eigenvalues", sp.S.EmptySet, DRIVEN, "right", "none, as the empty set"),
    Case("fixed_eigenvalues", [sp.I * W], NORMAL, "wrong", "a root that is controlled"),
    Case("fixed_eigenvalues", [], NORMAL, "wrong", "overlooked"),
    Case("fixed_eigenvalues", "0", NORMAL, "invalid", "text"),
    Case("mechanical_eigenvalues", [i, -i, i * root3, -i * root3], SPRINGS, "right", "exact"),
    Case(
        "mechanical_eigenvalues",
        {1j, -1j, 1.732j, -1.732j},
        SPRINGS,
        "right",
        "decimals in a Python set",
    ),
    Case(
        "mechanical_eigenvalues",
        sp.FiniteSet(i, -i, i * root3, -i * root3),
        SPRINGS,
        "right",
        "a SymPy set",
    ),
    Case("mechanical_eigenvalues", np.roots([1, 0, 4, 0, 3]), SPRINGS, "right", "an array"),
    Case("mechanical_eigenvalues", {1: 1, -1: 1}, REPELLED, "right", "as sp.roots gives them"),
    Case("mechanical_eigenvalues", [0, -1], SLIDING, "right", "a multiple root once"),
    Case(
        "mechanical_eigenvalues",
        [0, 0, 0, -1],
        SLIDING,
        "right",
        "a multiple root as often as it is one",
    ),
    Case(
        "mechanical_eigenvalues",
        [sp.sqrt(-stiff), -sp.sqrt(-stiff)],
        TUNED,
        "right",
        "with a parameter",
    ),
    Case(
        "mechanical_eigenvalues",
        [i * sp.sqrt(stiff), -i * sp.sqrt(stiff)],
        TUNED,
        "right",
        "the same with the imaginary unit",
    ),
    Case(
        "mechanical_eigenvalues",
        [sp.sqrt(stiff), -sp.sqrt(stiff)],
        TUNED,
        "wrong",
        "the sign of the stiffness",
    ),
    Case(
        "mechanical_eigenvalues",
        [i * sp.sqrt(sp.Abs(stiff - 4) + 4), -i * sp.sqrt(sp.Abs(stiff - 4) + 4)],
        TUNED,
        "wrong",
        "right for stiff springs alone",
    ),
    Case(
        "mechanical_eigenvalues",
        [i * sp.sqrt(4 - sp.Abs(stiff - 4)), -i * sp.sqrt(4 - sp.Abs(stiff - 4))],
        TUNED,
        "wrong",
        "right for soft springs alone",
    ),
    Case("mechanical_eigenvalues", [i, -i], SPRINGS, "wrong", "two overlooked"),
    Case("mechanical_eigenvalues", [1, root3], SPRINGS, "wrong", "the frequencies"),
    Case("mechanical_eigenvalues", [-1, -3], SPRINGS, "wrong", "the squares"),
    Case("mechanical_eigenvalues", [-1], SLIDING, "wrong", "zero left out"),
    Case("mechanical_eigenvalues", [0, 1], SLIDING, "wrong", "a sign"),
    Case("mechanical_eigenvalues", [], SPRINGS, "wrong", "none"),
    Case("mechanical_eigenvalues", [1.01, -1], REPELLED, "wrong", "the third digit off"),
    Case("mechanical_eigenvalues", ..., SPRINGS, "missing", "the untouched stub"),
    Case("mechanical_eigenvalues", "i", SPRINGS, "invalid", "text"),
    Case("mechanical_eigenvalues", [sp.Symbol("s")], SPRINGS, "invalid", "a symbol"),
    Case(
        "unobservable_states",
        [[1, -1, 0, 0], [0, 0, 1, -1]],
        SUM,
        "right",
        "a whole mode: displacement and velocity",
    ),
    Case(
        "unobservable_states",
        [[1, -1, 2, -2], [1, -1, -2.0, 2.0]],
        SUM,
        "right",
        "another basis, in decimals",
    ),
    Case(
        "unobservable_states",
        sp.Matrix([[1, 0], [-1, 0], [0, 1], [0, -1]]),
        SUM,
        "right",
        "as columns",
    ),
    Case("unobservable_states", [[1, -1]], MIXED, "right", "one decreasing motion"),
    Case("unobservable_states", [], FIRST, "right", "an observable system"),
    Case("unobservable_states", [[1, -1, 0, 0]], SUM, "wrong", "displacements only"),
    Case(
        "unobservable_states", [[1, 1, 0, 0], [0, 0, 1, 1]], SUM, "wrong", "the mode that is seen"
    ),
    Case("unobservable_states", [[1, 1]], MIXED, "wrong", "the increasing motion"),
    Case("unobservable_states", [[1, 0], [0, 1]], MIXED, "wrong", "everything"),
    Case(
        "unobservable_states",
        [[0, 1, 0, 0]],
        FIRST,
        "wrong",
        "no effect on the measurement at the initial time only",
    ),
    Case("unobservable_states", [], SUM, "wrong", "none"),
    Case("unobservable_states", ..., SUM, "missing", "the untouched stub"),
    Case("unobservable_states", [[1, -1], [1, -1]], SUM, "invalid", "shapes without velocities"),
    Case("unobservable_states", "none", SUM, "invalid", "text"),
]
LIMITS = [
    "The roots and the unobservable states (x, x') are asked of systems with invertible M alone.",
    "Where M is singular for some values of the parameters, these values are left out; where it "
    "is singular for all, only systems without parameters are judged.",
    "Values of lambda that depend on parameters are compared at eight values of them in general "
    "position, two of them large.",
]
