import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear

a = sp.symbols("alpha", real=True)
g, l1, l2 = sp.symbols("g l1 l2", positive=True)
w = sp.symbols("omega", positive=True)
M = sp.Matrix
DRIVEN = (Linear(M([[0, 1], [2, 1]]), M([0, 1])),)
# The sum x1 + x2 obeys an equation of its own, with the eigenvalue 2.
SUM = (Linear(M([[1, 2], [1, 0]]), M([1, -1])),)
TWO_INPUTS = (Linear(M([[1, 0], [0, 1]]), M([[1, 0], [0, 1]])),)
VALUE = (Linear(M([[1, a], [-3, -2]]), M([1, 1])), [a])
NEVER = (Linear(M([[2, -1], [1, 0]]), M([1, 1])), [a])
# Two pendulums on one carriage, its acceleration being the control.
CARRIAGE = (
    Linear(
        M([[0, 0, 1, 0], [0, 0, 0, 1], [g / l1, 0, 0, 0], [0, g / l2, 0, 0]]),
        M([0, 0, 1 / l1, 1 / l2]),
    ),
    [g, l1, l2],
)
ORBIT = (
    Linear(
        M([[0, -w, 1, 0], [w, 0, 0, 1], [-(w**2), 0, 0, -w], [0, 2 * w**2, w, 0]]), M([0, 0, 1, 0])
    ),
    [w],
)
RADIAL = (Linear(ORBIT[0].A, M([0, 0, 0, 1])), [w])
AXES = (Linear(sp.diag(1, 2, 1), M([1, 0, -1])),)
LOST = (VALUE[0], a)
TWICE = (Linear(sp.diag(1, 2, 3), M([a - 2, 2 * a - 1, 1 - 2 * a])), a)
STEERED = (Linear(M([[0, 1], [-1, 0]]), M([1, a])), a)
TWO_LOST = {2: [[1, 0, 0]], 0.5: [[0, 1, 0], [0, 0, 1]]}

# Two bodies on one table: control is lost where they have both coefficients in common.
s, q = sp.symbols("s q", real=True)
SHAKEN = (
    Linear(M([[0, 1, 0, 0], [-5, -2, 0, 0], [0, 0, 0, 1], [0, 0, -q, -s]]), M([0, -1, 0, -1])),
    [s, q],
)

CASES = [
    Case("controllable", "yes", DRIVEN, "right", "every combination is reached"),
    Case("controllable", "no", SUM, "right", "one combination is not"),
    Case("controllable", True, ORBIT, "right", "for every positive omega"),
    Case("controllable", "no", CARRIAGE, "right", "not for equal lengths"),
    Case("controllable", False, DRIVEN, "wrong", "the opposite"),
    Case("controllable", "yes", CARRIAGE, "wrong", "equal lengths overlooked"),
    Case("controllable", ..., DRIVEN, "missing", "the untouched stub"),
    Case(
        "controllable", sp.Ne(l1, l2), CARRIAGE, "invalid", "the condition where yes or no is asked"
    ),
    Case("controllable_parameters", sp.Ne(a, -6), VALUE, "right", "one value left out"),
    Case("controllable_parameters", sp.Or(a < -6, -6 < a), VALUE, "right", "both sides of it"),
    Case("controllable_parameters", sp.Ne(l1 / l2, 1), CARRIAGE, "right", "a quotient"),
    Case(
        "controllable_parameters",
        sp.Ne(l1**2, l2**2),
        CARRIAGE,
        "right",
        "squares of what is positive",
    ),
    Case("controllable_parameters", False, NEVER, "right", "for no value"),
    Case(
        "controllable_parameters",
        sp.And(sp.Ne(a, -6), sp.Ne(a, 10**6)),
        VALUE,
        "wrong",
        "a value far out",
    ),
    Case(
        "controllable_parameters",
        sp.And(sp.Ne(l1, l2), sp.Ne(l1**2 + l2**2, 5)),
        CARRIAGE,
        "wrong",
        "a circle left out",
    ),
    Case("controllable_parameters", sp.Ne(a, 6), VALUE, "wrong", "a sign"),
    Case("controllable_parameters", a > -6, VALUE, "wrong", "one side only"),
    Case("controllable_parameters", True, CARRIAGE, "wrong", "equal lengths overlooked"),
    Case("controllable_parameters", sp.Ne(a, 1), NEVER, "wrong", "a factor that does not matter"),
    Case("controllable_parameters", -6, VALUE, "invalid", "the value alone"),
    Case("controllability_matrix", [[0, 1], [1, 1]], DRIVEN, "right", "nested lists"),
    Case(
        "controllability_matrix",
        np.array([[1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 1.0]]),
        TWO_INPUTS,
        "right",
        "two controls",
    ),
    Case(
        "controllability_matrix",
        M.hstack(*[ORBIT[0].A ** k * ORBIT[0].B for k in range(4)]),
        ORBIT,
        "right",
        "with a parameter",
    ),
    Case("controllability_matrix", [[1, -1], [-1, 1]], SUM, "right", "of rank 1"),
    Case("controllability_matrix", [[1, 1], [-1, 1]], SUM, "wrong", "one entry"),
    Case(
        "controllability_matrix",
        M.hstack(*[ORBIT[0].A ** k * ORBIT[0].B for k in range(4)]).T,
        ORBIT,
        "wrong",
        "the transpose",
    ),
    Case(
        "controllability_matrix",
        [[1, 1, 0, 0], [0, 0, 1, 1]],
        TWO_INPUTS,
        "wrong",
        "control by control",
    ),
    Case("controllability_matrix", [[0, 1, 1], [1, 1, 3]], DRIVEN, "invalid", "a power too many"),
    Case("uncontrollable_combinations", [[1, 1]], SUM, "right", "a list"),
    Case(
        "uncontrollable_combinations",
        [M([[-0.5, -0.5]])],
        SUM,
        "right",
        "a row, of another length and sign",
    ),
    Case("uncontrollable_combinations", M([2, 2]), SUM, "right", "a column"),
    Case(
        "controllable_parameters",
        sp.Or(sp.Ne(s, 2), sp.Ne(q, 5)),
        SHAKEN,
        "right",
        "all but one point of the plane",
    ),
    Case("controllable_parameters", True, SHAKEN, "wrong", "an isolated point overlooked"),
    Case("uncontrollable_combinations", [], DRIVEN, "right", "none"),
    Case("uncontrollable_combinations", [[0, w, 1, 0]], RADIAL, "right", "with a parameter"),
    Case("uncontrollable_combinations", [[1, 0, 1], [0, 1, 0]], AXES, "right", "two of them"),
    Case("uncontrollable_combinations", [[1, -1]], SUM, "wrong", "what the control changes alone"),
    Case(
        "uncontrollable_combinations", [[1, 0]], DRIVEN, "wrong", "changed by its second derivative"
    ),
    Case("uncontrollable_combinations", [[0, 1, 0], [0, 2, 0]], AXES, "wrong", "dependent"),
    Case("uncontrollable_combinations", [[1, 0, 1]], AXES, "wrong", "one of two"),
    Case("uncontrollable_combinations", [], SUM, "wrong", "overlooked"),
    Case("uncontrollable_combinations", [[0, -w, 1, 0]], RADIAL, "wrong", "a sign"),
    Case("uncontrollable_combinations", [[1, 0]], TWO_INPUTS, "wrong", "with two controls"),
    Case("uncontrollable_combinations", ..., SUM, "missing", "the untouched stub"),
    Case("uncontrollable_combinations", [[1, 1, 0]], SUM, "invalid", "three components"),
    Case("uncontrollable_combinations", "x1 + x2", SUM, "invalid", "text"),
    Case("uncontrollable_combinations_at", {-6: [[1, -1]]}, LOST, "right", "one value"),
    Case("uncontrollable_combinations_at", {}, STEERED, "right", "no such value"),
    Case(
        "uncontrollable_combinations_at",
        TWO_LOST,
        TWICE,
        "right",
        "two values, one of them a decimal",
    ),
    Case(
        "uncontrollable_combinations_at",
        {2.0: M([[-3, 0, 0]]), sp.S.Half: M([[0, 1, 1], [0, 1, 2]])},
        TWICE,
        "right",
        "rows of a matrix",
    ),
    Case(
        "uncontrollable_combinations_at",
        {-6: [[1, 1]]},
        LOST,
        "wrong",
        "the combination that the control changes",
    ),
    Case("uncontrollable_combinations_at", {6: [[1, -1]]}, LOST, "wrong", "a sign"),
    Case("uncontrollable_combinations_at", {2: [[1, 0, 0]]}, TWICE, "wrong", "a value overlooked"),
    Case(
        "uncontrollable_combinations_at",
        TWO_LOST | {0: [[0, 1, 1]]},
        TWICE,
        "wrong",
        "w b = 0 without the next condition",
    ),
    Case("uncontrollable_combinations_at", {}, LOST, "wrong", "overlooked"),
    Case("uncontrollable_combinations_at", [[1, -1]], LOST, "invalid", "a basis without its value"),
    Case("fixed_eigenvalues", [2], SUM, "right", "a list"),
    Case("fixed_eigenvalues", {0}, RADIAL, "right", "a set"),
    Case("fixed_eigenvalues", [], CARRIAGE, "right", "none for lengths in general position"),
    Case("fixed_eigenvalues", [-1], SUM, "wrong", "the controlled one"),
    Case("fixed_eigenvalues", [0, sp.I * w], RADIAL, "wrong", "one too many"),
    Case("fixed_eigenvalues", [], RADIAL, "wrong", "overlooked"),
    Case("fixed_eigenvalues", "2", SUM, "invalid", "text"),
]
LIMITS = ["As for observability, since the transposed matrices are judged."]
