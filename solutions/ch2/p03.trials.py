# %% wrong
a_observable = False  # one measurement cannot tell two numbers: the derivative forgotten
a_unseen = [[0, 1]]  # what one moment does not see: the states with x1 = 0
b_observable = False  # a speed taken to say nothing of the position, as for a free body
b_unseen = [[1, 0]]  # what one moment does not see: the states with x2 = 0
c_observable = True  # both states enter the measurement, so both are thought to be known
c_unseen = [[1, 1]]  # the eigenvector that is seen
c_unseen = [[0, 0]]  # the zero vector belongs to no basis
d_observable = False  # imaginary eigenvalues thought to hide a motion
d_unseen = [[0, 1]]  # a vector of the plane, where nothing is unseen
e_observable = False  # one measurement cannot tell two numbers
e_unseen = [[1, 0]]  # what one moment does not see
f_observable = False  # the output of item c, so its verdict too
f_unseen = [[1, -1]]  # the line where z vanishes for a moment
g_observable = True  # the system thought observable since A is regular
g_unseen = [[0, 1]]  # the measured direction instead of the unseen one
h_observable = False  # a double eigenvalue thought to spoil observability
h_unseen = [[1, -1]]  # the line where z vanishes for a moment
i_observable = True  # observable as soon as both states enter, so for a not 0
i_unseen = [[a, 1]]  # the sign lost
i_unseen = [[1, -1/a]]  # divided by a, which may vanish

# %% right
a_unseen = sp.zeros(2, 0)  # a matrix without columns
b_unseen = sp.zeros(2, 0)  # a matrix without columns
d_unseen = sp.zeros(2, 0)  # a matrix without columns
e_unseen = sp.zeros(2, 0)  # a matrix without columns
f_unseen = sp.zeros(2, 0)  # a matrix without columns
h_unseen = sp.zeros(2, 0)  # a matrix without columns
c_unseen = [(-2.5, 2.5)]  # another length and sign
c_unseen = sp.Matrix([1, -1])  # a column
g_unseen = [sp.Matrix([7, 0])]  # a list of columns
# floats
import numpy as np
g_unseen = [np.array([1.0, 0.0])]
i_unseen = [[-sp.Symbol("a"), 1]]  # the other sign, a plain symbol
i_unseen = [[a*(1 + a**2), -1 - a**2]]  # a multiple that is never zero
