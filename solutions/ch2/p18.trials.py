# %% wrong
a_controllable = False  # Must the control appear in every equation? (hint 1)
a_kalman = sp.Matrix([[1, 0], [0, 1]])  # Are the columns in the usual order? (hint 1)
# What is the second column made of, besides A and b? (hint 1)
a_kalman = sp.Matrix([[0, 1], [1, 1]])
b_region = sp.Ne(beta, 1)  # Does the determinant have another root? (hint 2)
b_region = sp.Ne(beta, -1)  # Is a combination controllable because it decays by itself? (hint 2)
# Must the determinant be positive, or only different from zero? (hint 2)
b_region = sp.Or(beta > 1, beta < -1)
# Are these the directions in which the control acts? (hint 1)
b_uncontrollable_rows = {1: [[1, 1]], -1: [[-1, 1]]}
b_uncontrollable_rows = {-1: [[1, 1]]}  # Is only the growing combination uncontrollable? (hint 1)
# Is something uncontrollable if the control does not change it at once? (hint 1)
b_uncontrollable_rows = {1: [[-1, 1]], -1: [[1, 1]], 0: [[1, 0]]}

# %% right
# column beside column, as floats
import numpy as np

a_kalman = np.column_stack([[0.0, 1.0], [1.0, 0.0]])
b_region = sp.Ne(sp.Symbol("beta") ** 2 - 1, 0)  # the determinant, with a plain symbol
b_region = sp.Or(beta < -1, sp.And(-1 < beta, beta < 1), beta > 1)  # three intervals
b_uncontrollable_rows = {-1: [(0.5, 0.5)], 1: [(1, -1)]}  # other lengths and signs, tuples
# rows as matrices, decimal keys
b_uncontrollable_rows = {1.0: sp.Matrix([[3, -3]]), -1.0: sp.Matrix([[2, 2]])}
