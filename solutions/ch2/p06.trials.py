# %% wrong
a_observable = False  # the longitude thought to tell nothing of the height
a_unseen = [[0, 1, 0, 0]]  # a constant height taken to leave the longitude at rest
a_lost = {0, sp.I*Omega, -sp.I*Omega}  # the rank taken to fall wherever the upper square is singular
b_observable = True  # the height taken to tell everything, as the longitude does
b_unseen = [[1, 0, 0, 0], [0, 2*r0, -3*Omega, 0]]  # the circular orbit of another height, which an altimeter does see
b_unseen = [[0, 0, 1, 0]]  # a steady rate at height zero, which the equations do not allow
b_lost = {sp.I*Omega, -sp.I*Omega}  # the oscillation taken for unseen
c_observable = True  # the rate integrated, its constant forgotten
c_unseen = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]]  # everything that z does not contain at the first moment
c_lost = set()  # the row of the measurement written without its factor lambda
d_observable = True  # the vertical velocity integrated to the height, and this to the rest
d_unseen = [[1, 0, 0, 0]]  # as many states as Theorem 2.5 finds exceptions
d_unseen = [[1, 0, 0, 0], [0, 1, 0, 0]]  # the height changed and the rate left as it was
d_unseen = [[1, 0, 0, 0], [0, 2*r0, 3*Omega, 0]]  # the higher orbit taken to run ahead
d_lost = {0, sp.I*Omega}  # two unseen states, so two lost numbers sought
e_observable = False  # each of the two not enough, so neither their sum
e_unseen = [[1, -1, 0, 0]]  # the states where the sum vanishes for a moment
e_lost = {0}  # what the altimeter loses

# %% right
a_unseen = sp.zeros(4, 0)  # a matrix without columns
b_unseen = [[-3, 0, 0, 0]]  # another length and sign
b_unseen = sp.Matrix([r0, 0, 0, 0])  # a column
c_unseen = [sp.Matrix([7, 0, 0, 0])]  # a list of columns
# floats
import numpy as np
c_unseen = [np.array([1.0, 0.0, 0.0, 0.0])]
d_unseen = [[0, 1, -3*Omega/(2*r0), 0], [2, 0, 0, 0]]  # the other order, with the height as the unit
# a shift added to the drift, plain symbols
w, r = sp.symbols("Omega r0")
d_unseen = [[1, 0, 0, 0], [5, -2*r, 3*w, 0]]
d_unseen = sp.Matrix([[1, 1], [0, 2*r0], [0, -3*Omega], [0, 0]])  # the columns of a matrix
e_unseen = sp.zeros(4, 0)  # a matrix without columns
