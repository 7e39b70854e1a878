import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear

M, half = sp.Matrix, sp.Rational(1, 2)
# Two controls (example 7), and the same matrices transposed for two outputs.
A7, B7 = (
    M([[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 2, 1], [0, 0, 0, 2]]),
    M([[1, 0], [0, 1], [0, 1], [1, 0]]),
)
b1, b2 = B7[:, 0], B7[:, 1]
CONTROLS, OUTPUTS = (Linear(A7, B7),), (Linear(A7.T, H=B7.T),)
IN_TURN, BY_TURNS = M.hstack(b1, A7 * b1, A7**2 * b1, b2), M.hstack(b1, A7 * b1, b2, A7 * b2)
CANONICAL = M.hstack(A7 * b1 - 7 * half * b1 - b2 / 2, b1, A7 * b2 - 5 * half * b2 - b1 / 2, b2)
LEANING = M.hstack(b1, A7 * b1, A7**2 * b1, M([0, 1, 0, 0]))
# One combination of three coordinates is reached by no control, and u2 adds nothing to u1.
REST = (Linear(M([[0, 1, 0], [0, 0, 0], [0, 0, 1]]), M([[0, 1], [1, 0], [0, 0]])),)


def in_coordinates(P):
    """Return the system of two controls in the coordinates x = P xi."""
    return [P.inv() * A7 * P, P.inv() * B7]


CASES = [
    Case("sequential_decomposition", IN_TURN, CONTROLS, "right", "b1, A b1, A^2 b1, b2"),
    Case(
        "sequential_decomposition",
        IN_TURN * sp.diag(M([[1, 2, 0], [0, 1, 5], [0, 0, 1]]), 3),
        CONTROLS,
        "right",
        "another basis of part 1",
    ),
    Case(
        "sequential_decomposition",
        M([[0, 1, 0], [1, 0, 0], [0, 0, 1]]),
        REST,
        "right",
        "u2 adds nothing, one coordinate is left over",
    ),
    Case("sequential_decomposition", BY_TURNS, CONTROLS, "wrong", "the parallel one"),
    Case("sequential_decomposition", LEANING, CONTROLS, "wrong", "u2 enters part 1 too"),
    Case(
        "sequential_decomposition",
        IN_TURN[:, [3, 0, 1, 2]],
        CONTROLS,
        "wrong",
        "the parts in the opposite order",
    ),
    Case(
        "sequential_decomposition", [b1, b2], CONTROLS, "invalid", "the first columns of the chains"
    ),
    Case("parallel_decomposition", BY_TURNS, CONTROLS, "right", "b1, A b1, b2, A b2"),
    Case("parallel_decomposition", CANONICAL, CONTROLS, "right", "both parts in canonical form"),
    Case("parallel_decomposition", IN_TURN, CONTROLS, "wrong", "the sequential one"),
    Case(
        "parallel_decomposition",
        BY_TURNS[:, [0, 2, 1, 3]],
        CONTROLS,
        "wrong",
        "the columns as taken, not part by part",
    ),
    Case("parallel_decomposition", sp.eye(3), CONTROLS, "invalid", "another order"),
    Case("parallel_system", in_coordinates(BY_TURNS), CONTROLS, "right", "b1, A b1, b2, A b2"),
    Case("parallel_system", in_coordinates(CANONICAL), CONTROLS, "right", "canonical parts"),
    Case(
        "parallel_system",
        in_coordinates(BY_TURNS * sp.diag(2, 3, 5, 7)),
        CONTROLS,
        "right",
        "columns of other lengths",
    ),
    Case("parallel_system", in_coordinates(IN_TURN), CONTROLS, "wrong", "the sequential one"),
    Case("parallel_system", [A7, B7], CONTROLS, "wrong", "the system as given"),
    Case(
        "parallel_system",
        in_coordinates(BY_TURNS[:, [2, 3, 0, 1]]),
        CONTROLS,
        "wrong",
        "the part of u2 first",
    ),
    Case(
        "parallel_system",
        [
            sp.diag(in_coordinates(BY_TURNS)[0][:2, :2], in_coordinates(BY_TURNS)[0][2:, 2:]),
            in_coordinates(BY_TURNS)[1],
        ],
        CONTROLS,
        "wrong",
        "the coupling of the parts is left out",
    ),
    Case("parallel_system", [BY_TURNS], CONTROLS, "invalid", "one matrix"),
    Case(
        "parallel_system",
        [part.T for part in in_coordinates(BY_TURNS)],
        OUTPUTS,
        "right",
        "rows h1, h1 A, h2, h2 A",
    ),
    Case("sequential_decomposition", IN_TURN.T, OUTPUTS, "right", "rows h1, h1 A, h1 A^2, h2"),
    Case(
        "sequential_decomposition",
        np.array((IN_TURN.T * half).tolist(), dtype=float),
        OUTPUTS,
        "right",
        "floats",
    ),
    Case("sequential_decomposition", BY_TURNS.T, OUTPUTS, "wrong", "the parallel one"),
    Case("sequential_decomposition", LEANING.T, OUTPUTS, "wrong", "z2 contains part 1 too"),
    Case("sequential_decomposition", IN_TURN, OUTPUTS, "wrong", "transposed"),
    Case("sequential_decomposition", 1, OUTPUTS, "invalid", "a number"),
    Case("parallel_decomposition", BY_TURNS.T, OUTPUTS, "right", "rows h1, h1 A, h2, h2 A"),
    Case("parallel_decomposition", CANONICAL.T, OUTPUTS, "right", "both parts in canonical form"),
    Case("parallel_decomposition", IN_TURN.T, OUTPUTS, "wrong", "the sequential one"),
    Case("parallel_decomposition", sp.ones(4), OUTPUTS, "wrong", "no inverse"),
    Case("parallel_decomposition", [1, 2, 3, 4], OUTPUTS, "invalid", "a vector"),
]
LIMITS = [
    "A decomposition by components has its parts in the order in which the data name the outputs "
    "or the controls."
]
