# %% wrong
a_observable = True  # Is it enough that each block has a variable in z? (hint 1)
a_unobservable_states = [
    [0, 1, 0, 0],
    [0, 0, 1, 0],
]  # Must a variable appear in z to be observable? (hint 1)
a_unobservable_states = [
    [1, 0, 0, -1]
]  # Does z stay zero here, or only at the initial time? (hint 1)
a_split = sp.eye(4)  # Can the order stay as it is? Which coordinate is unobservable? (hint 1)
# Which variables are observable, though they do not appear in z? (hint 1)
a_split = sp.Matrix([[1, 0, 0, 0], [0, 0, 0, 1], [0, 0, 1, 0], [0, 1, 0, 0]])
# Was a coupling between two variables lost? (hint 1)
a_split_system = [sp.diag(sp.Matrix([[2, 1], [0, 2]]), 1, 1), sp.Matrix([[1, 0, 1, 0]])]
# Was the matrix written in the new order at all? (hint 1)
a_split_system = [a_matrix, a_output]
b_observable = True  # Is it enough that the eigenvalues of the blocks differ? (hint 1)
b_unobservable_states = [
    [0, 0, 1, 0]
]  # Is a variable unobservable because it is constant? (hint 1)
# Does z stay zero here, or only at the initial time? (hint 1)
b_unobservable_states = [[0, 0, 0, 1], [1, 0, 0, 0]]
# Which coordinates must come first? (hint 1)
b_split = sp.Matrix([[0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])
# Is an unobservable variable mixed into an observable coordinate here? (hint 1)
b_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]])
b_split_system = [b_matrix.T, b_output]  # Was the matrix transposed? (hint 1)
# Does the unobservable part have this eigenvalue? (hint 1)
b_split_system = [sp.diag(b_matrix[:3, :3], 3), b_output]
c_observable = True  # Is it enough that a path leads from every variable to z? (hint 1)
c_unobservable_states = [
    [1, -1, 0, 0]
]  # Does this difference appear in the second derivative? (hint 1)
c_unobservable_states = [
    [0, 0, 1, 1]
]  # Does this combination appear in the first derivative? (hint 1)
# Were the two differences swapped? The unobservable one must come last. (hint 1)
c_split = half * sp.Matrix([[1, 1, 0, 0], [0, 0, 1, 1], [0, 0, 1, -1], [-1, 1, 0, 0]])
# Are these the basis vectors instead of the coordinates? (hint 1)
c_split = sp.Matrix([[1, 0, -1, 0], [1, 0, 1, 0], [0, 1, 0, 1], [0, 1, 0, -1]])
# Does z act on the unobservable coordinate? (hint 1)
c_split_system = [
    sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
    sp.Matrix([[1, 0, 0, 0]]),
]
# Does an eigenvalue have the wrong sign? (hint 1)
c_split_system = [
    sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1, 0], [1, 0, 0, 1]]),
    sp.Matrix([[1, 0, 0, 0]]),
]

# %% right
a_unobservable_states = [(0, 0, -4, 0)]  # another length and sign
a_unobservable_states = sp.Matrix([0, 0, 1, 0])  # a column
a_split = [[1, 0, 0, 1], [2, 1, 0, 1], [4, 4, 0, 1], [0, 0, 1, 0]]  # z, its derivatives, and x3
# another order and another fourth coordinate
a_split = sp.Matrix([[0, 0, 0, 1], [0, 1, 0, 0], [1, 0, 0, 0], [1, 1, 1, 1]])
# in z and its derivatives
a_split_system = [
    sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [4, -8, 5, 0], [4, -4, 1, 1]]),
    sp.Matrix([[1, 0, 0, 0]]),
]
# lists, the order x4, x1, x2, x3
a_split_system = [[[1, 0, 0, 0], [0, 2, 1, 0], [0, 0, 2, 0], [1, 0, 0, 1]], [[1, 1, 0, 0]]]
b_unobservable_states = [[0, 0, 0, 7]]  # another length
# floats
import numpy as np

b_unobservable_states = [np.array([0, 0, 0, -1.0])]
# z, its derivatives, and x4
b_split = sp.Matrix([[0, 1, 1, 0], [1, 3, 0, 0], [6, 9, 2, 0], [0, 0, 0, 1]])
# the coordinate that nothing drives
b_split = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0.5, 1]]
b_split_system = [sp.diag(b_matrix[:3, :3], 2), b_output]  # with the two parts cut apart
# in z and its derivatives
b_split_system = [
    sp.Matrix(
        [
            [0, 1, 0, 0],
            [0, 0, 1, 0],
            [0, -9, 6, 0],
            [sp.Rational(9, 11), -sp.Rational(6, 11), sp.Rational(1, 11), 2],
        ]
    ),
    sp.Matrix([[1, 0, 0, 0]]),
]
c_unobservable_states = [[0, 0, -half, half]]  # another length and sign
c_unobservable_states = sp.Matrix([0, 0, 1, -1])  # a column
# whole sums and differences
c_split = [[1, 1, 0, 0], [0, 0, 1, 1], [1, -1, 0, 0], [0, 0, 1, -1]]
# a single variable as the fourth coordinate, the observable ones mixed
c_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]])
# with y4 instead of the half difference; y1 = xi1 - xi3 and y3 = 2 xi2 - y4
c_split_system = [
    sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 0], [-1, -1, 1, 1]]),
    sp.Matrix([[1, 0, 0, 0]]),
]
# in whole sums and differences
c_split_system = [
    sp.Matrix([[0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 1, 0], [1, 0, 0, 1]]),
    sp.Matrix([[half, 0, 0, 0]]),
]
