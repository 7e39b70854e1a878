# %% wrong
a_observable = True  # each of the two blocks has a variable in z, so all is thought to be seen
a_unseen = [[0, 1, 0, 0], [0, 0, 1, 0]]  # x2 taken for unseen because it does not stand in z
a_unseen = [[1, 0, 0, -1]]  # z = 0 at the first moment, but not later
a_split = sp.eye(4)  # nothing changed: the third coordinate is the unseen one
# the measured variables first and the others after them, x2 too
a_split = sp.Matrix([[1, 0, 0, 0], [0, 0, 0, 1], [0, 0, 1, 0], [0, 1, 0, 0]])
# the action of x4 on x3 lost on the way
a_split_system = [sp.diag(sp.Matrix([[2, 1], [0, 2]]), 1, 1), sp.Matrix([[1, 0, 1, 0]])]
a_split_system = [a_matrix, a_output]  # the matrix left as it is
b_observable = True  # all eigenvalues of the blocks differ, which is not enough
b_unseen = [[0, 0, 1, 0]]  # the variable at rest thought to be unseen
b_unseen = [[0, 0, 0, 1], [1, 0, 0, 0]]  # z = 0 at the first moment, but not later
b_split = sp.Matrix([[0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])  # the unseen variable first
b_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]])  # x4 mixed into an observable coordinate
b_split_system = [b_matrix.T, b_output]  # the transposed matrix
b_split_system = [sp.diag(b_matrix[:3, :3], 3), b_output]  # a wrong eigenvalue for the unseen part
c_observable = True  # from every variable a way leads to z
c_unseen = [[1, -1, 0, 0]]  # the difference that is seen in the second derivative
c_unseen = [[0, 0, 1, 1]]  # the combination that is seen in the first derivative
# the differences exchanged: the unseen one stands third
c_split = half*sp.Matrix([[1, 1, 0, 0], [0, 0, 1, 1], [0, 0, 1, -1], [-1, 1, 0, 0]])
# the basis vectors y = T (xi, eta) instead of the coordinates
c_split = sp.Matrix([[1, 0, -1, 0], [1, 0, 1, 0], [0, 1, 0, 1], [0, 1, 0, -1]])
# the action of z on the unseen coordinate lost
c_split_system = [sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), sp.Matrix([[1, 0, 0, 0]])]
# the sign of an eigenvalue turned
c_split_system = [sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1, 0], [1, 0, 0, 1]]), sp.Matrix([[1, 0, 0, 0]])]

# %% right
a_unseen = [(0, 0, -4, 0)]  # another length and sign
a_unseen = sp.Matrix([0, 0, 1, 0])  # a column
a_split = [[1, 0, 0, 1], [2, 1, 0, 1], [4, 4, 0, 1], [0, 0, 1, 0]]  # z, its derivatives, and x3
# another order and another fourth coordinate
a_split = sp.Matrix([[0, 0, 0, 1], [0, 1, 0, 0], [1, 0, 0, 0], [1, 1, 1, 1]])
# in z and its derivatives
a_split_system = [sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [4, -8, 5, 0], [4, -4, 1, 1]]), sp.Matrix([[1, 0, 0, 0]])]
# lists, the order x4, x1, x2, x3
a_split_system = [[[1, 0, 0, 0], [0, 2, 1, 0], [0, 0, 2, 0], [1, 0, 0, 1]], [[1, 1, 0, 0]]]
b_unseen = [[0, 0, 0, 7]]  # another length
# floats
import numpy as np
b_unseen = [np.array([0, 0, 0, -1.0])]
b_split = sp.Matrix([[0, 1, 1, 0], [1, 3, 0, 0], [6, 9, 2, 0], [0, 0, 0, 1]])  # z, its derivatives, and x4
b_split = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0.5, 1]]  # the coordinate that nothing drives
b_split_system = [sp.diag(b_matrix[:3, :3], 2), b_output]  # with the two parts cut apart
# in z and its derivatives
b_split_system = [sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, -9, 6, 0],
                             [sp.Rational(9, 11), -sp.Rational(6, 11), sp.Rational(1, 11), 2]]),
                  sp.Matrix([[1, 0, 0, 0]])]
c_unseen = [[0, 0, -half, half]]  # another length and sign
c_unseen = sp.Matrix([0, 0, 1, -1])  # a column
c_split = [[1, 1, 0, 0], [0, 0, 1, 1], [1, -1, 0, 0], [0, 0, 1, -1]]  # whole sums and differences
# a single variable as the fourth coordinate, the observable ones mixed
c_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]])
# with y4 instead of the half difference; y1 = xi1 - xi3 and y3 = 2 xi2 - y4
c_split_system = [sp.Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 0], [-1, -1, 1, 1]]), sp.Matrix([[1, 0, 0, 0]])]
# in whole sums and differences
c_split_system = [sp.Matrix([[0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 1, 0], [1, 0, 0, 1]]), sp.Matrix([[half, 0, 0, 0]])]
