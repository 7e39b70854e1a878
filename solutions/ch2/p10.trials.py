# %% wrong
observable = True  # Is it enough that every state acts on another one? (hint 1)
# Was a sign lost when z and its derivative were set to zero? (hint 1)
unobservable_states = [
    [unobservable_states[0][0], unobservable_states[0][1], -unobservable_states[0][2]]
]
# Are all states unobservable that are not measured directly? (hint 1)
unobservable_states = [[1, 0, 0], [0, 0, 1]]
# Is the measured coordinate alone the observable part? (hint 1)
split = sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 1]])
# Is this the matrix of the basis instead of that of the coordinates? (hint 1)
split = sp.Matrix.vstack(H, H * A, sp.Matrix([unobservable_states[0]])).inv()
split = sp.Matrix.vstack(H, H * A, H * A**2)  # Are the three rows independent? (hint 2)
# Does the unobservable coordinate act on the observable ones here? Was the matrix transposed? (hint
# 1)
split_system = [sp.Matrix(split_system[0]).T, sp.Matrix([[1, 0, 0]])]
# Was a sign lost in the second equation? (hint 1)
split_system = [sp.diag(1, -1, 1) * sp.Matrix(split_system[0]), sp.Matrix([[1, 0, 0]])]
# Are the coefficients in the right order? (hint 2)
p, q = sp.Matrix(canonical[0])[:, 0]
canonical = [sp.Matrix([[q, 1], [p, 0]]), sp.Matrix([[1, 0]])]
# Does the whole system have a canonical form, or only its observable part? (hint 1)
p, q = sp.Matrix(canonical[0])[:, 0]
canonical = [sp.Matrix([[p, 1, 0], [q, 0, 1], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# Which coordinate is measured in the canonical form?
canonical = [canonical[0], sp.Matrix([[0, 1]])]
# Was a factor lost? The first coordinate has to be the output itself. (hint 1)
canonical_coordinates = 2 * sp.Matrix(canonical_coordinates)
# Which coefficient is subtracted in the second coordinate? (hint 1)
canonical_coordinates = sp.Matrix([[1, 0], [-1, 1]]) * sp.Matrix(canonical_coordinates)

# %% right
unobservable_states = [[-2 * v for v in unobservable_states[0]]]  # another length and sign
unobservable_states = sp.Matrix(unobservable_states[0]) / 3  # a column
# another last coordinate
split = sp.Matrix.vstack(H, H * A, sp.Matrix([unobservable_states[0]]))
# another second coordinate
split = sp.Matrix.vstack(H, H * A - 3 * H, sp.Matrix([unobservable_states[0]])).tolist()
# floats, the sum and the difference as coordinates of the observable part
import numpy as np

h, rate, v = (np.array(row, dtype=float).ravel() for row in (H, H * A, unobservable_states[0]))
split = np.array([h + rate, h - rate, v])
# with another last coordinate
P = sp.Matrix.vstack(H, H * A, sp.Matrix([unobservable_states[0]]))
split_system = [P * A * P.inv(), sp.Matrix([[1, 0, 0]])]
# with another second coordinate, as lists
P = sp.Matrix.vstack(H, H * A - 3 * H, sp.Matrix([unobservable_states[0]]))
split_system = [(P * A * P.inv()).tolist(), [[1, 0, 0]]]
# lists, the output as a plain list
canonical = [sp.Matrix(canonical[0]).tolist(), [1, 0]]
# floats
import numpy as np

canonical = [np.array(canonical[0], dtype=float), np.array([[1.0, 0]])]
# floats
import numpy as np

canonical_coordinates = np.array(canonical_coordinates, dtype=float)

# %% numbers
from workbook.authoring.numbers import linear_form

A = [
    sp.Matrix(rows)
    for rows in [
        [[0, 1, 0], [1, 1, -1], [1, 0, -1]],
        [[1, -2, 0], [1, -2, 2], [0, -2, 1]],
        [[0, 1, -2], [-1, 0, 2], [-1, 0, 1]],
        [[-2, 0, 0], [1, 0, 1], [0, -1, -2]],
        [[-1, 2, -2], [1, 1, -2], [0, 0, -2]],
        [[2, -1, -1], [-2, 0, -2], [-1, 0, 2]],
        [[2, 0, 0], [1, -1, 1], [-2, 1, 0]],
        [[0, 1, 2], [-1, 1, -2], [0, 1, -1]],
        [[-1, 0, 0], [-1, -1, -1], [0, -1, -1]],
        [[0, -1, 0], [-2, -2, -2], [-1, 1, -1]],
        [[1, 0, 2], [-1, -2, -2], [0, 2, 0]],
    ]
]
sides = [linear_form(A.row(k), ["x_1", "x_2", "x_3"]) for k in range(3)]
shown = [
    r"\dot x_1 = «sides[0]», \qquad \dot x_2 = «sides[1]», \qquad \dot x_3 = «sides[2]»,",
]
rows = sp.Matrix.vstack(H, H * A)
unobservable_states = [list(rows.nullspace()[0])]
split = sp.Matrix.vstack(rows, sp.Matrix([unobservable_states[0]]))
split_system = [split * A * split.inv(), sp.Matrix([[1, 0, 0]])]
last, first = split_system[0][1, 0], split_system[0][1, 1]  # hA^2 = first hA + last h
canonical = [sp.Matrix([[first, 1], [last, 0]]), sp.Matrix([[1, 0]])]
canonical_coordinates = sp.Matrix.vstack(H, H * A - first * H)
