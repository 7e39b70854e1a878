# %% wrong
a_region = sp.Ne(alpha, 2)  # Were the complex eigenvalues left out? (hint 1)
# Are these the exceptional values instead of all others? (hint 1)
a_region = sp.Or(sp.Eq(alpha, 0), sp.Eq(alpha, 2))
# Does the sign of the determinant matter, or only whether it vanishes? (hint 1)
a_region = sp.And(sp.Ne(alpha, 0), alpha < 2)
# Is one combination the whole basis at each of these values? (hint 2)
a_uncontrolled = {0: [[1, 0, 0]], 2: [[-1, 1, 1]]}
# Is one of these bases a basis of what can be reached? (hint 1)
a_uncontrolled = {0: [[1, 0, 0], [0, -1, 1]], 2: [[1, 1, 0], [1, 0, 1]]}
# Is one of these an eigenvector of A instead of a left one? (hint 1)
b_uncontrolled = {-1: [[1, 0, 1]], 1: [[0, 1, 0], [-1, 0, 1]]}
b_region = sp.Ne(alpha, 1)  # Was one factor of the determinant overlooked? (hint 1)
# Did the sign of a factor decide here, where only its zero should? (hint 1)
b_region = sp.And(alpha > -1, alpha < 1)
# Is one row the whole basis at each of these values? (hint 2)
b_uncontrolled = {-1: [[1, 2, 1]], 1: [[-1, 2, 1]]}
# Have the two values changed places? (hint 2)
b_uncontrolled = {1: [[1, 2, 1]], -1: [[0, 1, 0], [-1, 0, 1]]}
# Were the roots taken with the wrong sign? (hint 1)
c_region = sp.And(sp.Ne(alpha, 1), sp.Ne(alpha, -2))
c_region = sp.Ne(alpha, -1)  # Is a double eigenvalue without growth no danger? (hint 1)
# Does a squared factor always mean two lost combinations? (hint 1)
c_uncontrolled = {-1: [[1, 1, 1]], 2: [[-2, 1, 4], [1, 0, -4]]}
c_uncontrolled = {-1: [[1, 1, 1]]}  # Was one of the values overlooked? (hint 1)
# Was only a part of the coordinates looked at? (hint 1)
d_region = sp.Ne(2 * alpha**2 + 2 * alpha + 1, 0)
# Is there a single value at which something is lost? Look at the columns of W first. (hint 1)
d_region = sp.Ne(alpha, 1)
# Is it the value at which the control enters fewer equations that matters? (hint 1)
d_region = sp.Ne(alpha, 0)
# Is nothing lost? Look for a combination whose derivative does not hold u. (hint 1)
d_uncontrolled = []
# Was a sign lost? Does the control enter this combination? (hint 1)
d_uncontrolled = [[1, 1, 0]]
d_uncontrolled = [[1, -1, 0], [0, 0, 1]]  # Is one row too many here? (hint 2)

# %% right
a_region = sp.Ne(alpha**2 * (alpha - 2), 0)  # the determinant
# another basis at 0, another length at 2
a_uncontrolled = {0: [[1, 1, -1], [2, -1, 1]], 2.0: [[1, -1, -1]]}
# matrices with the basis as columns
a_uncontrolled = {sp.Integer(0): sp.Matrix([[0, 3], [1, 0], [-1, 0]]), 2: sp.Matrix([-2, 2, 2])}
b_region = sp.Ne(sp.Abs(alpha), 1)  # the absolute value
b_region = sp.Or(alpha < -1, sp.And(alpha > -1, alpha < 1), alpha > 1)  # three intervals
b_uncontrolled = {1: [(-1, -1, 1), (-1, 2, 1)], -1: [(1, 2, 1)]}  # the two left eigenvectors
# a list of rows, floats
import numpy as np

b_uncontrolled = {
    1.0: [sp.Matrix([[0, 1, 0]]), sp.Matrix([[1, 0, -1]])],
    -1.0: np.array([[0.5, 1.0, 0.5]]),
}
c_region = sp.Ne(alpha**2 - alpha - 2, 0)  # the roots of a parabola
# as a solver of linear equations gives it
c_uncontrolled = {-1: [[1, 1, 1]], 2: sp.Matrix([[1, 2, 0], [4, 4, 1], [12, 12, 3]]).nullspace()}
# columns of another length
c_uncontrolled = {2: sp.Matrix([-1, sp.Rational(1, 2), 2]), -1: sp.Matrix([-1, -1, -1])}
d_region = sp.S.EmptySet  # the empty set
d_region = sp.And(alpha < 0, alpha > 1)  # a condition that nothing satisfies
d_uncontrolled = ((-1, 1, 0),)  # the other sign, as a tuple
# a length that depends on alpha but is never zero
d_uncontrolled = [[1 + alpha**2, -1 - alpha**2, 0]]
