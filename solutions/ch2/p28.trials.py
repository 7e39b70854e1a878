# %% wrong
controllable = True  # Is it enough that every equation contains the control? (hint 1)
uncontrolled = []  # Is there no combination without the control? (hint 1)
uncontrolled = [list(b)]  # Is this the direction in which the control acts? (hint 1)
# Is this an eigenvector of A instead of its transpose? (hint 2)
uncontrolled = [list((A - uncontrollable_eigenvalues[0] * sp.eye(2)).nullspace()[0])]
# Is this the eigenvalue of the direction in which the control acts? (hint 1)
uncontrollable_eigenvalues = [A.trace() - uncontrollable_eigenvalues[0]]
uncontrollable_eigenvalues = list(A.eigenvals())  # Are all eigenvalues uncontrollable? (hint 1)
uncontrollable_eigenvalues = []  # Is every eigenvalue controllable, though one combination is not? (hint 1)
# Does this lead from x to the new coordinates, instead of from them to x? (hint 1)
split = sp.Matrix.hstack(b, (A - uncontrollable_eigenvalues[0] * sp.eye(2)).nullspace()[0]).inv()
# Which coordinate must come first? (hint 1)
split = sp.Matrix.hstack((A - uncontrollable_eigenvalues[0] * sp.eye(2)).nullspace()[0], b)
split = sp.Matrix.hstack(b, 2 * b)  # Does this matrix have an inverse? (hint 1)
split = sp.eye(2)  # Can the coordinates be left as they are? (hint 1)
# Does the control still enter the uncontrollable equation? (hint 2)
split_system = [
    sp.diag(A.trace() - uncontrollable_eigenvalues[0], uncontrollable_eigenvalues[0]),
    sp.Matrix([1, 1]),
]
# Is the coupling on the correct side of the diagonal? (hint 1)
split_system = [
    sp.Matrix([[A.trace() - uncontrollable_eigenvalues[0], 0], [2, uncontrollable_eigenvalues[0]]]),
    sp.Matrix([1, 0]),
]
# Were the two eigenvalues swapped? (hint 1)
split_system = [
    sp.diag(uncontrollable_eigenvalues[0], A.trace() - uncontrollable_eigenvalues[0]),
    sp.Matrix([1, 0]),
]

# %% right
uncontrolled = [[5 * w for w in uncontrolled[0]]]  # another length and sign
uncontrollable_eigenvalues = [float(uncontrollable_eigenvalues[0])]  # a decimal
split = sp.Matrix.hstack(b, sp.Matrix([1, 0]))  # b and the first axis
split = sp.Matrix.hstack(-3 * b, sp.Matrix([0, 7]))  # another length of b, the second axis
# with the first axis: eta acts on xi
P = sp.Matrix.hstack(b, sp.Matrix([1, 0]))
split_system = [P.inv() * A * P, sp.Matrix([1, 0])]
# other lengths
split_system = [
    sp.Matrix(
        [[A.trace() - uncontrollable_eigenvalues[0], -5], [0, uncontrollable_eigenvalues[0]]]
    ),
    sp.Matrix([3, 0]),
]


# %% numbers
from workbook.authoring.numbers import linear_form


def system(reached, coupling, last, ratio):
    """A matrix with the eigenvector (1, ratio) of the eigenvalue `reached`, and this vector."""
    first = reached - coupling * ratio
    return sp.Matrix([[first, coupling], [ratio * (reached - last), last]]), sp.Matrix([1, ratio])


A, b = [
    system(*parts)
    for parts in [
        (2, 1, 0, 1),
        (3, 1, 2, 2),
        (1, 1, 1, -3),
        (2, 2, 1, -1),
        (-1, 1, 1, 3),
        (-1, -1, 2, 4),
        (2, 1, -1, -2),
        (-2, 1, -1, 5),
        (-1, 1, 3, -4),
        (-2, 1, 1, 6),
        (-1, 1, 1, -7),
        (1, -2, -1, -6),
        (-2, 2, -1, 7),
        (3, 2, -1, -5),
    ]
]
sides = [linear_form([*A.row(k), b[k]], ["x_1", "x_2", "u"]) for k in range(2)]
shown = [
    r"\dot x_1 = «sides[0]», \qquad \dot x_2 = «sides[1]»",
    "both equations«' alike' if b[0] == b[1] else ''»",
]
uncontrollable_eigenvalues = [(sp.Matrix([[b[1], -b[0]]]) * A)[0] / b[1]]
uncontrolled = [[b[1], -b[0]]]
split = sp.Matrix.hstack(b, sp.Matrix([0, 1]))
split_system = [split.inv() * A * split, sp.Matrix([1, 0])]
