# %% wrong
a_region = sp.Ne(alpha, 2)  # the complex eigenvalues left out
a_region = sp.Or(sp.Eq(alpha, 0), sp.Eq(alpha, 2))  # the exceptional values given
a_region = sp.And(sp.Ne(alpha, 0), alpha < 2)  # inequalities, as if the sign of the determinant mattered
a_uncontrolled = {0: [[1, 0, 0]], 2: [[-1, 1, 1]]}  # x1 alone taken for the whole oscillator at 0
a_uncontrolled = {0: [[1, 0, 0], [0, -1, 1]], 2: [[1, 1, 0], [1, 0, 1]]}  # at 2, a basis of what can be reached
b_uncontrolled = {-1: [[1, 0, 1]], 1: [[0, 1, 0], [-1, 0, 1]]}  # the eigenvector itself for the left one
b_region = sp.Ne(alpha, 1)  # one factor of the determinant overlooked
b_region = sp.And(alpha > -1, alpha < 1)  # the sign of a factor lost
b_uncontrolled = {-1: [[1, 2, 1]], 1: [[-1, 2, 1]]}  # one row taken for the whole basis at 1
b_uncontrolled = {1: [[1, 2, 1]], -1: [[0, 1, 0], [-1, 0, 1]]}  # the values interchanged
c_region = sp.And(sp.Ne(alpha, 1), sp.Ne(alpha, -2))  # signs of both roots lost
c_region = sp.Ne(alpha, -1)  # the double zero thought to be no danger, since nothing grows by it
# the square in the determinant taken for two lost combinations
c_uncontrolled = {-1: [[1, 1, 1]], 2: [[-2, 1, 4], [1, 0, -4]]}
c_uncontrolled = {-1: [[1, 1, 1]]}  # one value overlooked
d_region = sp.Ne(2*alpha**2 + 2*alpha + 1, 0)  # only the plane of s and x3 looked at, where nothing is lost
d_region = sp.Ne(alpha, 1)  # a single value guessed to be the trouble
d_region = sp.Ne(alpha, 0)  # alpha = 0, for which u enters two equations only
d_uncontrolled = []  # thought to be controllable in general
d_uncontrolled = [[1, 1, 0]]  # the sign lost: what the control moves most
d_uncontrolled = [[1, -1, 0], [0, 0, 1]]  # a row too many

# %% right
a_region = sp.Ne(alpha**2*(alpha - 2), 0)  # the determinant
a_uncontrolled = {0: [[1, 1, -1], [2, -1, 1]], 2.0: [[1, -1, -1]]}  # another basis at 0, another length at 2
# matrices with the basis as columns
a_uncontrolled = {sp.Integer(0): sp.Matrix([[0, 3], [1, 0], [-1, 0]]), 2: sp.Matrix([-2, 2, 2])}
b_region = sp.Ne(sp.Abs(alpha), 1)  # the absolute value
b_region = sp.Or(alpha < -1, sp.And(alpha > -1, alpha < 1), alpha > 1)  # three intervals
b_uncontrolled = {1: [(-1, -1, 1), (-1, 2, 1)], -1: [(1, 2, 1)]}  # the two left eigenvectors
# a list of rows, floats
import numpy as np
b_uncontrolled = {1.0: [sp.Matrix([[0, 1, 0]]), sp.Matrix([[1, 0, -1]])], -1.0: np.array([[0.5, 1.0, 0.5]])}
c_region = sp.Ne(alpha**2 - alpha - 2, 0)  # the roots of a parabola
# as a solver of linear equations gives it
c_uncontrolled = {-1: [[1, 1, 1]], 2: sp.Matrix([[1, 2, 0], [4, 4, 1], [12, 12, 3]]).nullspace()}
c_uncontrolled = {2: sp.Matrix([-1, sp.Rational(1, 2), 2]), -1: sp.Matrix([-1, -1, -1])}  # columns of another length
d_region = sp.S.EmptySet  # the empty set
d_region = sp.And(alpha < 0, alpha > 1)  # a condition that nothing satisfies
d_uncontrolled = ((-1, 1, 0),)  # the other sign, as a tuple
d_uncontrolled = [[1 + alpha**2, -1 - alpha**2, 0]]  # a length that depends on alpha but is never zero
