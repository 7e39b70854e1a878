# %% wrong
a_region = sp.false  # the minors of each control alone vanish identically, so the system is thought to be lost
a_region = sp.And(sp.Ne(alpha, 0), sp.Ne(alpha, 1))  # alpha = 0, for which no control enters the third equation
a_region = sp.Ne(alpha, -1)  # a sign lost
a_region = sp.Eq(alpha, 1)  # the exceptional value itself
a_uncontrolled = {1: [[-1, 0, 1], [-1, 1, 1]]}  # everything that u1 has lost, though u2 still drives one of the two
a_uncontrolled = {1: [[-1, 1, 0], [-1, 0, 1]]}  # the whole plane of the double eigenvalue
a_uncontrolled = {1: [[1, 0, 1]]}  # what can be reached: x1 and x3 alike
b_region = sp.true  # two controls thought to be always enough
b_region = sp.And(sp.Ne(alpha, 0), sp.Ne(alpha, -sp.Rational(1, 2)))  # a zero of one entry of W added
b_region = sp.false  # a triple eigenvalue thought to need three controls
b_uncontrolled = {0: [[-2, 1, 0], [-1, 0, 1]]}  # both left eigenvectors
b_uncontrolled = {0: [[0, 0, 1]]}  # the coordinate that u2 does not enter
b_uncontrolled = {0: [[1, 2, 0]]}  # an eigenvector for the left eigenvector
b_uncontrolled = {}  # nothing thought to be lost

# %% right
a_region = sp.Or(alpha < 1, alpha > 1)  # two intervals
# the sum of the squares of two minors, with a plain symbol
a_region = sp.Ne((sp.Symbol("alpha") - 1)**2 + (sp.Symbol("alpha") - 1)**4, 0)
a_uncontrolled = {1: [(1, 0, -1)]}  # the other sign, as a tuple
a_uncontrolled = {1.0: sp.Matrix([-3, 0, 3])}  # a decimal key and a column
b_region = sp.Or(sp.Ne(4*alpha, 0), sp.Ne(-2*alpha, 0))  # one minor or another one is not zero
b_uncontrolled = {0: sp.Matrix([[2, 0, -2]])}  # a row as a matrix of one row
# floats of length one
import numpy as np
b_uncontrolled = {0.0: [np.array([-1.0, 0.0, 1.0])/np.sqrt(2)]}
