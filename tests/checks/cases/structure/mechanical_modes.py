import numpy as np
import sympy as sp
from case import Case

# Two masses between three equal springs: the sum swings with 1, the difference with sqrt(3).
SPRINGS = (sp.eye(2), sp.zeros(2), sp.Matrix([[2, -1], [-1, 2]]))
SUM = (*SPRINGS, sp.Matrix([[1, 1]]), sp.zeros(1, 2))
FIRST = (*SPRINGS, sp.Matrix([[1, 0]]), sp.zeros(1, 2))
# One mass repelled, displacement and velocity measured together: e^-t is lost.
REPELLED = (sp.Matrix([[2]]), sp.zeros(1), sp.Matrix([[-2]]))
MIXED = (*REPELLED, sp.Matrix([[1]]), sp.Matrix([[1]]))
# Free masses with friction on the first: a triple root zero.
SLIDING = (sp.eye(2), sp.diag(1, 0), sp.zeros(2))
i, root3 = sp.I, sp.sqrt(3)
# A spring whose stiffness is a parameter.
stiff = sp.symbols("kappa", real=True)
TUNED = (sp.eye(1), sp.zeros(1), sp.Matrix([[stiff]]), [stiff])

CASES = [
    Case("mechanical_roots", [i, -i, i * root3, -i * root3], SPRINGS, "right", "exact"),
    Case("mechanical_roots", {1j, -1j, 1.732j, -1.732j}, SPRINGS, "right", "decimals in a Python set"),
    Case("mechanical_roots", sp.FiniteSet(i, -i, i * root3, -i * root3), SPRINGS, "right", "a SymPy set"),
    Case("mechanical_roots", np.roots([1, 0, 4, 0, 3]), SPRINGS, "right", "an array"),
    Case("mechanical_roots", {1: 1, -1: 1}, REPELLED, "right", "as sp.roots gives them"),
    Case("mechanical_roots", [0, -1], SLIDING, "right", "a multiple root once"),
    Case("mechanical_roots", [0, 0, 0, -1], SLIDING, "right", "a multiple root as often as it is one"),
    Case("mechanical_roots", [sp.sqrt(-stiff), -sp.sqrt(-stiff)], TUNED, "right", "with a parameter"),
    Case("mechanical_roots", [i * sp.sqrt(stiff), -i * sp.sqrt(stiff)], TUNED, "right",
         "the same with the imaginary unit"),
    Case("mechanical_roots", [sp.sqrt(stiff), -sp.sqrt(stiff)], TUNED, "wrong", "the sign of the stiffness"),
    Case("mechanical_roots", [i, -i], SPRINGS, "wrong", "two overlooked"),
    Case("mechanical_roots", [1, root3], SPRINGS, "wrong", "the frequencies"),
    Case("mechanical_roots", [-1, -3], SPRINGS, "wrong", "the squares"),
    Case("mechanical_roots", [-1], SLIDING, "wrong", "zero left out"),
    Case("mechanical_roots", [0, 1], SLIDING, "wrong", "a sign"),
    Case("mechanical_roots", [], SPRINGS, "wrong", "none"),
    Case("mechanical_roots", [1.01, -1], REPELLED, "wrong", "the third digit off"),
    Case("mechanical_roots", ..., SPRINGS, "missing", "the untouched stub"),
    Case("mechanical_roots", "i", SPRINGS, "invalid", "text"),
    Case("mechanical_roots", [sp.Symbol("s")], SPRINGS, "invalid", "a symbol"),
    Case("mechanical_unseen_states", [[1, -1, 0, 0], [0, 0, 1, -1]], SUM, "right",
         "a whole mode: displacement and velocity"),
    Case("mechanical_unseen_states", [[1, -1, 2, -2], [1, -1, -2.0, 2.0]], SUM, "right", "another basis, in decimals"),
    Case("mechanical_unseen_states", sp.Matrix([[1, 0], [-1, 0], [0, 1], [0, -1]]), SUM, "right", "as columns"),
    Case("mechanical_unseen_states", [[1, -1]], MIXED, "right", "one decreasing motion"),
    Case("mechanical_unseen_states", [], FIRST, "right", "an observable system"),
    Case("mechanical_unseen_states", [[1, -1, 0, 0]], SUM, "wrong", "displacements only"),
    Case("mechanical_unseen_states", [[1, 1, 0, 0], [0, 0, 1, 1]], SUM, "wrong", "the mode that is seen"),
    Case("mechanical_unseen_states", [[1, 1]], MIXED, "wrong", "the increasing motion"),
    Case("mechanical_unseen_states", [[1, 0], [0, 1]], MIXED, "wrong", "everything"),
    Case("mechanical_unseen_states", [[0, 1, 0, 0]], FIRST, "wrong", "unseen at the first moment only"),
    Case("mechanical_unseen_states", [], SUM, "wrong", "none"),
    Case("mechanical_unseen_states", ..., SUM, "missing", "the untouched stub"),
    Case("mechanical_unseen_states", [[1, -1], [1, -1]], SUM, "invalid", "shapes without velocities"),
    Case("mechanical_unseen_states", "none", SUM, "invalid", "text"),
]
LIMITS = ["M has to be invertible: otherwise the state is smaller than (x, x')."]
