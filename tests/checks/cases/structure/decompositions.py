import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear

w = sp.symbols("omega", positive=True)
M, half = sp.Matrix, sp.Rational(1, 2)
# Rank 2 of 3: the motion (1, 0, -1) is not seen; the same for control, where x1 + x3 cannot be
# changed.
SEEN = (Linear(M([[0, 1, 0], [1, 1, 1], [1, 0, 1]]), H=M([[0, 1, 0]])),)
T = M([[0, 1, 0], [1, 1, 1], [1, 0, -1]])
SPLIT = M([[0, 1, 0], [0, 2, 0], [2, -1, 0]])
DRIVEN = (Linear(M([[0, 1, 1], [1, 1, 0], [0, -1, -1]]), M([0, 1, 0])),)
P = M([[0, 1, 1], [1, 1, 0], [0, -1, 1]])
P_SPLIT = M([[0, 2, 0], [1, 0, 1], [0, 0, 0]])
# Two equal oscillators, of which the sum of the coordinates is measured.
TWINS = (
    Linear(
        M([[0, 1, 0, 0], [-(w**2), 0, 0, 0], [0, 0, 0, 1], [0, 0, -(w**2), 0]]), H=M([[1, 0, 1, 0]])
    ),
    [w],
)
SUM_AND_DIFFERENCE = M([[1, 0, 1, 0], [0, 1, 0, 1], [1, 0, -1, 0], [0, 1, 0, -1]])
SPIN, TURNED = Linear(M([[0, 1], [-1, 0]])), Linear(M([[1, 1], [-2, -1]]))

# Two equal pendulums, whose length may be zero; and two unknown gains, of which neither may be
# divided by.
LENGTH = sp.Symbol("l", real=True)
PENDULUMS = (
    Linear(sp.diag(M([[0, 1], [-1, 0]]), M([[0, 1], [-1, 0]])), H=M([[LENGTH, 0, LENGTH, 0]])),
    [LENGTH],
)
p, q = sp.symbols("p q", real=True)
GAINS = (Linear(sp.diag(1, 1, 2), H=M([[p, q, 1]])), [p, q])

CASES = [
    Case("decomposition", T, SEEN, "right", "rows h, hA and one more"),
    Case(
        "decomposition",
        M([[1, 0, 1], [0, 3, 0], [0, 0, 1]]),
        SEEN,
        "right",
        "other observable coordinates, another rest",
    ),
    Case(
        "decomposition",
        np.array([[0, 1, 0], [0.333, 0.333, 0.333], [1, 0, 0]]),
        SEEN,
        "right",
        "decimals",
    ),
    Case(
        "decomposition",
        np.array([[0, 1, 0], [0.333, 0.333, 0.337], [1, 0, 0]]),
        SEEN,
        "wrong",
        "one per cent off",
    ),
    Case("decomposition", SUM_AND_DIFFERENCE, TWINS, "right", "with a parameter"),
    Case("decomposition", SUM_AND_DIFFERENCE, PENDULUMS, "right", "for every length but zero"),
    Case(
        "decomposition",
        (w**2 + 1) * SUM_AND_DIFFERENCE,
        TWINS,
        "right",
        "a factor that vanishes nowhere",
    ),
    Case("decomposition", (w - 1) * SUM_AND_DIFFERENCE, TWINS, "wrong", "singular at one value"),
    Case(
        "decomposition",
        SUM_AND_DIFFERENCE / (w**2 - 2),
        TWINS,
        "wrong",
        "undefined at an irrational value",
    ),
    Case(
        "decomposition",
        (sp.exp(w) - 3) * SUM_AND_DIFFERENCE,
        TWINS,
        "wrong",
        "singular at a logarithm",
    ),
    Case(
        "decomposition",
        sp.diag(1, 1, 1, sp.atan(w - 11)) * SUM_AND_DIFFERENCE,
        TWINS,
        "wrong",
        "a row that vanishes at one value",
    ),
    Case(
        "decomposition",
        sp.exp(w) * SUM_AND_DIFFERENCE,
        TWINS,
        "right",
        "a function that vanishes nowhere",
    ),
    Case(
        "decomposition",
        (LENGTH - 1) * SUM_AND_DIFFERENCE,
        PENDULUMS,
        "wrong",
        "singular at the length 1",
    ),
    Case(
        "decomposition",
        LENGTH * SUM_AND_DIFFERENCE,
        PENDULUMS,
        "right",
        "singular where nothing is measured",
    ),
    Case(
        "decomposition",
        M([[p, q, 0], [0, 0, 1], [-q, p, 0]]),
        GAINS,
        "right",
        "two parameters, singular where less is seen",
    ),
    Case(
        "decomposition",
        M([[p, q, 0], [0, 0, 1], [1, 0, 0]]),
        GAINS,
        "wrong",
        "two parameters, singular where one of them is zero",
    ),
    Case(
        "decomposition",
        M([[p, q, 0], [0, 0, 1], [-q, p, 0]]) * (p - q),
        GAINS,
        "wrong",
        "a factor that vanishes on a line",
    ),
    Case("decomposition", T.inv(), SEEN, "wrong", "the inverse"),
    Case("decomposition", T[[2, 0, 1], :], SEEN, "wrong", "the unobservable part first"),
    Case("decomposition", sp.eye(3), SEEN, "wrong", "the coordinates as given"),
    Case(
        "decomposition",
        M([[0, 1, 0], [1, 1, 1], [2, 2, 2]]),
        SEEN,
        "wrong",
        "Kalman's matrix: no inverse",
    ),
    Case(
        "decomposition", [[0, 1, 0], [1, 1, 1], [1, ..., -1]], SEEN, "missing", "an entry left open"
    ),
    Case("decomposition", T[:2, :], SEEN, "invalid", "the observable coordinates alone"),
    Case("decomposition", P, DRIVEN, "right", "columns b, Ab and one more"),
    Case(
        "decomposition",
        [[0, 1, 0], [1, 0, 0], [0, -1, 1]],
        DRIVEN,
        "right",
        "nested lists, other columns",
    ),
    Case("decomposition", (4 * P).inv().inv(), DRIVEN, "right", "other lengths"),
    Case("decomposition", P.inv() + sp.eye(3) * 0, DRIVEN, "wrong", "the inverse"),
    Case("decomposition", P[:, ::-1], DRIVEN, "wrong", "the uncontrollable part first"),
    Case(
        "decomposition",
        M([[0, 1, 0], [1, 1, 2], [0, -1, 0]]),
        DRIVEN,
        "wrong",
        "Kalman's matrix: no inverse",
    ),
    Case("decomposition", "P", DRIVEN, "invalid", "text"),
    Case(
        "decomposed_system",
        [SPLIT, M([[1, 0, 0]])],
        SEEN,
        "right",
        "in the coordinates of the rows h, hA",
    ),
    Case(
        "decomposed_system",
        (SPLIT.tolist(), [1, 0, 0]),
        SEEN,
        "right",
        "nested lists, a vector for H'",
    ),
    Case(
        "decomposed_system",
        [M([[2, 0, 0], [0, 0, 0], [1, 5, 0]]), M([[1, -1, 0]])],
        SEEN,
        "right",
        "modes, another A21",
    ),
    Case(
        "decomposed_system",
        [1.0 * SPLIT, M([[0.5, 0, 0]])],
        SEEN,
        "right",
        "floats, another length",
    ),
    Case("decomposed_system", [SEEN[0].A, SEEN[0].H], SEEN, "wrong", "the system as given"),
    Case(
        "decomposed_system",
        [M([[0, 1, 0], [0, 2, 0], [2, -1, 1]]), M([[1, 0, 0]])],
        SEEN,
        "wrong",
        "another eigenvalue",
    ),
    Case(
        "decomposed_system",
        [SPLIT, M([[0, 1, 0]])],
        SEEN,
        "wrong",
        "the second coordinate does not see the first",
    ),
    Case(
        "decomposed_system",
        [SPLIT, M([[1, 0, 1]])],
        SEEN,
        "wrong",
        "the output contains the unobservable part",
    ),
    Case(
        "decomposed_system",
        [M([[0, 1, 0], [0, 2.02, 0], [1, 1, 0]]), M([[1, 0, 0]])],
        SEEN,
        "wrong",
        "an eigenvalue one per cent off",
    ),
    Case("decomposed_system", SPLIT, SEEN, "invalid", "the matrix alone"),
    Case("decomposed_system", [SPLIT, M([[1, 0]])], SEEN, "invalid", "an output of another length"),
    Case("decomposed_system", [P_SPLIT, M([1, 0, 0])], DRIVEN, "right", "in the basis b, Ab"),
    Case(
        "decomposed_system",
        [P_SPLIT, [2, 0, 0]],
        DRIVEN,
        "right",
        "another length, a vector for B'",
    ),
    Case("decomposed_system", [P_SPLIT.T, M([1, 0, 0])], DRIVEN, "wrong", "transposed"),
    Case(
        "decomposed_system",
        [P_SPLIT, M([1, 0, 1])],
        DRIVEN,
        "wrong",
        "the control enters the uncontrollable part",
    ),
    Case("decomposed_system", [DRIVEN[0].A, DRIVEN[0].B], DRIVEN, "wrong", "the system as given"),
    Case("decomposed_system", [P_SPLIT], DRIVEN, "invalid", "one matrix"),
    Case(
        "canonical_observable_part",
        [M([[2, 1], [0, 0]]), M([[1, 0]])],
        SEEN,
        "right",
        "the form (2.5)",
    ),
    Case("canonical_observable_part", [[[2, 1], [0, 0]], [1, 0]], SEEN, "right", "lists"),
    Case(
        "canonical_observable_part",
        [M([[0, 1], [0, 2]]), M([[1, 0]])],
        SEEN,
        "wrong",
        "another shape",
    ),
    Case(
        "canonical_observable_part",
        [M([[0, 1], [2, 0]]), M([[1, 0]])],
        SEEN,
        "wrong",
        "another polynomial",
    ),
    Case(
        "canonical_observable_part",
        [M([[2, 1], [0, 0]]), M([[0, 1]])],
        SEEN,
        "wrong",
        "the output is not the first coordinate",
    ),
    Case("canonical_observable_part", M([[2, 1], [0, 0]]), SEEN, "invalid", "the matrix alone"),
    Case("similarity_matrix", M([[1, 0], [-1, 1]]), (SPIN, TURNED), "right", "one of many"),
    Case("similarity_matrix", M([[0, 1], [-1, -1]]), (SPIN, TURNED), "right", "another"),
    Case("similarity_matrix", M([[7.004, 0], [-7.0, 7]]), (SPIN, TURNED), "right", "three digits"),
    Case("similarity_matrix", M([[7.0, 0], [-7.03, 7]]), (SPIN, TURNED), "wrong", "two digits"),
    Case(
        "similarity_matrix",
        w * M([[1, 0], [-1, 1]]),
        (SPIN, TURNED, [w]),
        "right",
        "a positive factor",
    ),
    Case(
        "similarity_matrix",
        (w - 3) * M([[1, 0], [-1, 1]]),
        (SPIN, TURNED, [w]),
        "wrong",
        "a factor that vanishes",
    ),
    Case("similarity_matrix", M([[1, 0], [1, 1]]), (SPIN, TURNED), "wrong", "the inverse"),
    Case("similarity_matrix", sp.eye(2), (SPIN, TURNED), "wrong", "the variables as they are"),
    Case(
        "similarity_matrix",
        sp.zeros(2),
        (SPIN, TURNED),
        "wrong",
        "zero satisfies the equation, but has no inverse",
    ),
    Case("similarity_matrix", [[1, 0]], (SPIN, TURNED), "invalid", "a row too few"),
]
LIMITS = [
    "Decompositions with parameters are judged at six rational values in general position, and "
    "wherever they are "
    "undefined or without an inverse; those that are very long at the eight values alone.",
    "A system given by rounded decimals is compared with the given one to about three digits; "
    "where eigenvalues lie close together, rounding may turn it into another system, and it is "
    "refused.",
]
