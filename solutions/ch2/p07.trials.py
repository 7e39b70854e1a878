# %% wrong
a_roots = [1, -1, sp.I/sp.sqrt(3), -sp.I/sp.sqrt(3)]  # the sign of the stiffness lost: 4 s^4 - (s^2 + 1)^2
a_roots = [1/sp.sqrt(3), -1/sp.sqrt(3)]  # only the real roots
a_roots = [sp.Rational(1, 3), -1]  # the values of s^2
a_lost = [-1]  # the zero of the output row, though it is no root
a_observable = False  # only the first coordinate enters the output
a_unseen = [[1, -1, -1, 1]]  # the shape that would be lost if -1 were a root
b_roots = [0, sp.sqrt(11), -sp.sqrt(11)]  # the printed equation with 6 x1
b_roots = [sp.sqrt(3), -sp.sqrt(3)]  # the negative value of s^2 thought to give no root
b_lost = [sp.sqrt(3)]  # one root of the lost pair
b_lost = [sp.I*sp.sqrt(10), -sp.I*sp.sqrt(10)]  # the mode that is seen
b_observable = True  # both coordinates enter the output, so both are thought to be known
b_unseen = [[-3, 1, 0, 0]]  # displacements only
b_unseen = [[1, 3, 0, 0], [0, 0, 1, 3]]  # the output row itself
c_roots = [1, -1]  # the double root zero overlooked after dividing by s^2
c_lost = [1, -1]  # a lost shape thought to take both its roots along
c_lost = [0]  # the root of the coordinate without stiffness
c_observable = True  # a displacement and a velocity of different coordinates thought never to cancel
c_unseen = [[1, 1, 0, 0]]  # the initial velocity forgotten
c_unseen = [[1, 1, 1, 1]]  # the growing motion, which is seen
d_roots = [1, (-1 + sp.sqrt(13))/6, (-1 - sp.sqrt(13))/6]  # the printed equation with the first derivative of x2
# the gyroscopic terms left out
d_roots = [s0 for s0 in sp.solve((3*sp.Symbol('q')**2 - 2)*(sp.Symbol('q')**2 - 1) - 1)]
d_lost = [0]  # the zero of the output row, though it is no root
d_lost = [1, -1]  # both signs, as without gyroscopic terms
d_observable = True  # the velocities of both coordinates thought to be enough
d_unseen = [[-2, 1, -2, 1]]  # the sign of the velocity lost
d_unseen = [[-2, 1, 0, 0], [0, 0, -2, 1]]  # both directions of the line, as in item b

# %% right
a_roots = {0.57735, -0.57735, 1j, -1j}  # decimals, as a Python set
a_unseen = sp.zeros(4, 0)  # a matrix without columns
# as an array
import numpy as np
b_roots = np.roots([1, 0, 7, 0, -30])
b_lost = [-1.732, 1.732]  # decimals
b_unseen = [[-3, 1, -3*sp.sqrt(3), sp.sqrt(3)], [-3, 1, 3*sp.sqrt(3), -sp.sqrt(3)]]  # the motions of the two roots
b_unseen = sp.Matrix([[3, 0], [-1, 0], [0, 6], [0, -2]])  # a matrix with the basis as columns
c_roots = [0, 0, 1, -1]  # the double root twice
c_unseen = [(-2.5, -2.5, 2.5, 2.5)]  # another length and sign
c_unseen = sp.Matrix([1, 1, -1, -1])  # a column
d_roots = [1, -1, 0.577, -0.577]  # decimals
d_unseen = [[2, -1, -2, 1]]  # divided by the second component
# an array of floats
import numpy as np
d_unseen = np.array([[-1.0, 0.5, 1.0, -0.5]])
