# %% wrong
a_controllable = False  # the control is missing in the first equation
a_kalman = sp.Matrix([[1, 0], [0, 1]])  # the columns in the opposite order
a_kalman = sp.Matrix([[0, 1], [1, 1]])  # the second column is b + A b
b_region = sp.Ne(beta, 1)  # the root -1 of the determinant forgotten
b_region = sp.Ne(beta, -1)  # the loss of what dies out by itself not counted: the stick can be held up, but not steered
b_region = sp.Or(beta > 1, beta < -1)  # a determinant that has to be positive
# the directions in which the control acts, not the combinations that it leaves alone
b_lost = {1: [[1, 1]], -1: [[-1, 1]]}
b_lost = {-1: [[1, 1]]}  # only the combination that grows
b_lost = {1: [[-1, 1]], -1: [[1, 1]], 0: [[1, 0]]}  # what a torque does not change at once, without beta, counted too

# %% right
# column beside column, as floats
import numpy as np
a_kalman = np.column_stack([[0.0, 1.0], [1.0, 0.0]])
b_region = sp.Ne(sp.Symbol("beta")**2 - 1, 0)  # the determinant, with a plain symbol
b_region = sp.Or(beta < -1, sp.And(-1 < beta, beta < 1), beta > 1)  # three intervals
b_lost = {-1: [(0.5, 0.5)], 1: [(1, -1)]}  # other lengths and signs, tuples
b_lost = {1.0: sp.Matrix([[3, -3]]), -1.0: sp.Matrix([[2, 2]])}  # rows as matrices, decimal keys
