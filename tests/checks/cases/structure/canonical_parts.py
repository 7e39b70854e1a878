import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear

a = sp.symbols("a", real=True)
w = sp.symbols("omega", positive=True)
# The first two coordinates are seen, z'' = 3z' - 2z; the third is driven by them.
CHAIN = (Linear(sp.Matrix([[1, 1, 0], [0, 2, 0], [1, 1, 5]]), H=sp.Matrix([[1, 0, 0]])),)
CHAIN_F = sp.Matrix([[1, 0, 0], [-2, 1, 0]])
# Seen from both coordinates, so nothing is left out.
WHOLE = (Linear(sp.Matrix([[0, 1], [-6, 5]]), H=sp.Matrix([[2, 0]])),)
# An oscillator with a parameter beside a coordinate that grows with another one.
SWING = (Linear(sp.Matrix([[0, w, 0], [-w, 0, 0], [0, 0, a]]), H=sp.Matrix([[1, 0, 0]])), [a, w])
SWING_F = sp.Matrix([[1, 0, 0], [0, w, 0]])
SINGLE = (Linear(sp.diag(4, 7), H=sp.Matrix([[1, 0]])),)

CASES = [
    Case("canonical_part_coordinates", CHAIN_F, CHAIN, "right", "a matrix"),
    Case(
        "canonical_part_coordinates",
        np.array([[1.0, 0, 0], [-2.0, 1, 0]]),
        CHAIN,
        "right",
        "floats",
    ),
    Case(
        "canonical_part_coordinates",
        [[2, 0], [-10, 2]],
        WHOLE,
        "right",
        "an observable system: the whole",
    ),
    Case("canonical_part_coordinates", SWING_F, SWING, "right", "a parameter"),
    Case("canonical_part_coordinates", [[1, 0]], SINGLE, "right", "of first order"),
    Case(
        "canonical_part_coordinates", [[1, 0, 0], [1, 1, 0]], CHAIN, "wrong", "z and its derivative"
    ),
    Case("canonical_part_coordinates", [[2, 0, 0], [-4, 2, 0]], CHAIN, "wrong", "a factor"),
    Case(
        "canonical_part_coordinates",
        [[-2, 1, 0], [1, 0, 0]],
        CHAIN,
        "wrong",
        "the rows in the other order",
    ),
    Case(
        "canonical_part_coordinates",
        [[1, 0, 0], [-2, 1, 0.2]],
        CHAIN,
        "wrong",
        "an unseen coordinate mixed in",
    ),
    Case(
        "canonical_part_coordinates",
        [[1, 0, 0], [-2, 1, 0], [0, 0, 1]],
        CHAIN,
        "wrong",
        "the unseen coordinate as a third row",
    ),
    Case("canonical_part_coordinates", [[1, 0, 0]], CHAIN, "wrong", "one row too few"),
    Case(
        "canonical_part_coordinates",
        [[1, 0, 0], [0, -w, 0]],
        SWING,
        "wrong",
        "a sign, with a parameter",
    ),
    Case(
        "canonical_part_coordinates",
        [[1, 0, 0], [-2, sp.oo, 0]],
        CHAIN,
        "wrong",
        "an infinite entry",
    ),
    Case("canonical_part_coordinates", ..., CHAIN, "missing", "the untouched stub"),
    Case("canonical_part_coordinates", CHAIN_F.T, CHAIN, "invalid", "the coordinates as columns"),
    Case("canonical_part_coordinates", "z and its derivative", CHAIN, "invalid", "words"),
]
LIMITS = ["One output only: for several there is no single form (2.5)."]
