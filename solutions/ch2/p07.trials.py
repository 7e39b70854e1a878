# %% wrong
# Was the sign of the stiffness lost? (hint 2)
a_roots = [1, -1, sp.I / sp.sqrt(3), -sp.I / sp.sqrt(3)]
a_roots = [1 / sp.sqrt(3), -1 / sp.sqrt(3)]  # Are complex roots asked for as well?
a_roots = [sp.Rational(1, 3), -1]  # Are these the values of the square of s? (hint 2)
a_unobservable_eigenvalues = [-1]  # Is this number a root of the system at all? (hint 1)
a_observable = False  # Does only one coordinate enter the output? (hint 1)
a_unobservable_states = [
    [1, -1, -1, 1]
]  # Does a motion with this shape exist? It needs a root. (hint 1)
# Was the printed equation used, with the misprint that the problem mentions? (hint 1)
b_roots = [0, sp.sqrt(11), -sp.sqrt(11)]
b_roots = [sp.sqrt(3), -sp.sqrt(3)]  # Does a negative value of the square of s give no root?
b_unobservable_eigenvalues = [
    sp.sqrt(3)
]  # Does the output treat s and -s differently here? (hint 2)
b_unobservable_eigenvalues = [
    sp.I * sp.sqrt(10),
    -sp.I * sp.sqrt(10),
]  # Is this the observable mode? (hint 1)
b_observable = True  # Is it enough that both coordinates enter the output? (hint 1)
# Are there only displacements along this line, or velocities too? (hint 1)
b_unobservable_states = [[-3, 1, 0, 0]]
# Is this the row of the output instead of the vector that it maps to zero? (hint 1)
b_unobservable_states = [[1, 3, 0, 0], [0, 0, 1, 3]]
c_roots = [1, -1]  # Which root is lost in a division by the square of s? (hint 1)
c_unobservable_eigenvalues = [
    1,
    -1,
]  # Are both roots of an unobservable shape unobservable? (hint 2)
# Is this the root of the coordinate without stiffness? Compute the output of its shape. (hint 1)
c_unobservable_eigenvalues = [0]
c_observable = True  # Can a displacement and a velocity never cancel? (hint 1)
c_unobservable_states = [[1, 1, 0, 0]]  # What is the initial velocity of this motion? (hint 1)
c_unobservable_states = [
    [1, 1, 1, 1]
]  # Is this the growing motion, and is it unobservable? (hint 1)
# Was the printed equation used, with the derivative that the problem corrects?
d_roots = [1, (-1 + sp.sqrt(13)) / 6, (-1 - sp.sqrt(13)) / 6]
# Were the gyroscopic terms left out? (hint 1)
d_roots = list(sp.solve((3 * sp.Symbol("q") ** 2 - 2) * (sp.Symbol("q") ** 2 - 1) - 1))
d_unobservable_eigenvalues = [0]  # Is this number a root of the system at all? (hint 1)
d_unobservable_eigenvalues = [
    1,
    -1,
]  # Do both signs go together when there are gyroscopic terms? (hint 1)
d_observable = True  # Is it enough that the velocities of both coordinates enter? (hint 1)
d_unobservable_states = [[-2, 1, -2, 1]]  # Was a sign lost in the initial velocity? (hint 1)
# Are all initial states along this line unobservable, or only one? (hint 1)
d_unobservable_states = [[-2, 1, 0, 0], [0, 0, -2, 1]]

# %% right
a_roots = {0.57735, -0.57735, 1j, -1j}  # decimals, as a Python set
a_unobservable_states = sp.zeros(4, 0)  # a matrix without columns
# as an array
import numpy as np

b_roots = np.roots([1, 0, 7, 0, -30])
b_unobservable_eigenvalues = [-1.732, 1.732]  # decimals
# the motions of the two roots
b_unobservable_states = [[-3, 1, -3 * sp.sqrt(3), sp.sqrt(3)], [-3, 1, 3 * sp.sqrt(3), -sp.sqrt(3)]]
b_unobservable_states = sp.Matrix(
    [[3, 0], [-1, 0], [0, 6], [0, -2]]
)  # a matrix with the basis as columns
c_roots = [0, 0, 1, -1]  # the double root twice
c_unobservable_states = [(-2.5, -2.5, 2.5, 2.5)]  # another length and sign
c_unobservable_states = sp.Matrix([1, 1, -1, -1])  # a column
d_roots = [1, -1, 0.577, -0.577]  # decimals
d_unobservable_states = [[2, -1, -2, 1]]  # divided by the second component
# an array of floats
import numpy as np

d_unobservable_states = np.array([[-1.0, 0.5, 1.0, -0.5]])
