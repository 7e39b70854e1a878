# %% wrong
a_region = sp.false  # Must a single control be enough? Take minors with columns of both. (hint 1)
# Must every equation contain a control? (hint 1)
a_region = sp.And(sp.Ne(alpha, 0), sp.Ne(alpha, 1))
a_region = sp.Ne(alpha, -1)  # Was a sign lost in the exceptional value? (hint 2)
# Is this the exceptional value itself, instead of all others? (hint 2)
a_region = sp.Eq(alpha, 1)
# Is this uncontrollable for one control alone? The other one still drives a part of it. (hint 2)
a_uncontrolled = {1: [[-1, 0, 1], [-1, 1, 1]]}
# Is the whole plane of the double eigenvalue uncontrollable? (hint 2)
a_uncontrolled = {1: [[-1, 1, 0], [-1, 0, 1]]}
# Is this the controllable part instead of the uncontrollable one? (hint 1)
a_uncontrolled = {1: [[1, 0, 1]]}
b_region = sp.true  # Are two controls always enough? Count the left eigenvectors. (hint 1)
# Does one vanishing entry of W matter? (hint 2)
b_region = sp.And(sp.Ne(alpha, 0), sp.Ne(alpha, -sp.Rational(1, 2)))
# Must there be as many controls as the eigenvalue has multiplicity? (hint 1)
b_region = sp.false
b_uncontrolled = {0: [[-2, 1, 0], [-1, 0, 1]]}  # Are both rows uncontrollable? (hint 2)
# Is a coordinate uncontrollable because one control does not enter it? (hint 1)
b_uncontrolled = {0: [[0, 0, 1]]}
b_uncontrolled = {0: [[1, 2, 0]]}  # Is this an eigenvector of A instead of a left one? (hint 2)
b_uncontrolled = {}  # Is the system controllable at every value? (hint 1)

# %% right
a_region = sp.Or(alpha < 1, alpha > 1)  # two intervals
# the sum of the squares of two minors, with a plain symbol
a_region = sp.Ne((sp.Symbol("alpha") - 1) ** 2 + (sp.Symbol("alpha") - 1) ** 4, 0)
a_uncontrolled = {1: [(1, 0, -1)]}  # the other sign, as a tuple
a_uncontrolled = {1.0: sp.Matrix([-3, 0, 3])}  # a decimal key and a column
b_region = sp.Or(sp.Ne(4 * alpha, 0), sp.Ne(-2 * alpha, 0))  # one minor or another one is not zero
b_uncontrolled = {0: sp.Matrix([[2, 0, -2]])}  # a row as a matrix of one row
# floats of length one
import numpy as np

b_uncontrolled = {0.0: [np.array([-1.0, 0.0, 1.0]) / np.sqrt(2)]}
