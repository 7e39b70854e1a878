# %% wrong
# Must there be as many measurements as unknowns? What do the derivatives of the measurement show?
# (hint 1)
a_observable = False
# Are these the states with zero output at one instant? Follow them a little longer. (hint 1)
a_unseen = [[0, 1, 0], [0, 0, 1]]
# Is one sign in the equations read as in example 3 of the chapter? Write the derivatives of z out
# once more. (hint 1)
b_observable = False
# Is this the unobservable state of example 3? The system here differs from it in a sign. (hint 1)
b_unseen = [[1, 0, -1]]
# Is it enough that every coordinate acts on another one? Two of them may act in the same way
# always. (hint 1)
c_observable = True
# Was a sign lost when z and its derivative were put to zero? Test the vector with both equations.
# (hint 1)
c_unseen = [[0, 1, 1]]
# Do these states stay unobservable as time goes on, or only at the initial time? (hint 2)
c_unseen = [[0, 1, 0], [0, 0, 1]]
c_unseen = [[0, 0, 0]]  # Can the zero vector belong to a basis? (hint 1)
# Is it enough that all three coordinates enter z or its derivative? They may enter in one
# combination only. (hint 1)
d_observable = True
d_unseen = [[1, 0, -1]]  # Was a sign lost? Put this vector into the derivative of z. (hint 1)
# Does it follow from the eigenvalues that show in z that nothing is lost? Count the eigenvectors
# too. (hint 1)
e_observable = True
# Does the motion along this eigenvector really give zero for z? (hint 2)
e_unseen = [[2, -1, 1]]
# Is one vector too many here? Compute the output of each of them and its derivative. (hint 2)
e_unseen = [[1, 0, 1], [0, 1, 0]]
# Does a coordinate that listens to the others have to be seen? Ask whom it acts on. (hint 1)
f_observable = True
# Are these the states with zero output at the initial time only? (hint 1)
f_unseen = [[1, -1, 0], [0, 0, 1]]
g_region = sp.Ne(alpha, -1)  # Was one factor of the determinant overlooked? (hint 1)
# Are these the values at which something is lost, instead of those at which nothing is? (hint 1)
g_region = sp.Or(sp.Eq(alpha, -1), sp.Eq(alpha, sp.Rational(1, 5)))
# Does the sign of the determinant matter, or only whether it vanishes? (hint 1)
g_region = sp.And(sp.Ne(alpha, -1), alpha < sp.Rational(1, 5))
# Is one vector a whole basis at each of these values? Count the independent rows that are left.
# (hint 2)
g_unseen = {-1: [[1, 1, 1]], sp.Rational(1, 5): [[-1, 3, 5]]}
g_unseen = {-1: [[0, 1, 0], [1, 0, 1]]}  # Was one of the exceptional values left out? (hint 1)
# Have the two values changed places? Put each of them into the rows again. (hint 1)
g_unseen = {sp.Rational(1, 5): [[0, 1, 0], [1, 0, 1]], -1: [[-1, 3, 5]]}
h_region = sp.Ne(alpha, 2)  # Was a sign lost in the factor of the determinant? (hint 2)
# Is this the eigenvector alone? How many rows are still independent there? (hint 1)
h_unseen = {-2: [[-1, 2, 1]]}
# Is anything lost at all at each of the values named here? Compute the determinant there. (hint 1)
h_unseen = {-2: [[1, 0, 0], [0, 2, 1]], 0: [[1, 0, 0]]}
# Is this the condition of a single minor? All of them have to vanish together. (hint 1)
i_region = sp.And(sp.Ne(alpha, 1), sp.Ne(alpha, 3))
# Is this what the first output alone does not see? Ask the second output too, and check the value.
# (hint 1)
i_unseen = {3: [[0, 1, -1]]}
# Is this eigenvector really without any trace in both outputs? (hint 1)
i_unseen = {1: [[1, 1, 0]]}
# Is this the condition of a single minor? The others may still be different from zero there. (hint 1)
j_region = sp.And(sp.Ne(alpha, -1), sp.Ne(alpha, -sp.Rational(1, 2)))
j_region = True  # Does the minor really never vanish? Factor it. (hint 1)
# Is this the eigenvector that the first output alone does not see? Ask the second one at this
# value. (hint 1)
j_unseen = {-1: [[1, 0, 1]], -sp.Rational(1, 2): [[1, 3, 2]]}

# %% right
a_unseen = sp.zeros(3, 0)  # a matrix without columns
b_unseen = sp.zeros(3, 0)  # a matrix without columns
c_unseen = [(0, 2.5, -2.5)]  # another length and sign
c_unseen = sp.Matrix([0, 3, -3])  # a column
d_unseen = [sp.Matrix([-7, 0, -7])]  # a list of columns
# floats of length one
import numpy as np

e_unseen = [np.array([1.0, 0.0, 1.0]) / np.sqrt(2)]
e_unseen = ((-1, 0, -1),)  # a tuple of tuples
f_unseen = sp.Matrix([0, 0, -1])  # a column
# an array
import numpy as np

f_unseen = np.array([[0, 0, 4]])
g_region = sp.Ne((alpha + 1) ** 2 * (5 * alpha - 1), 0)  # the determinant
# a list of two conditions, a plain symbol and a decimal
g_region = [sp.Ne(sp.Symbol("alpha"), -1), sp.Ne(sp.Symbol("alpha"), 0.2)]
# eigenvectors as the basis, a float as the value
g_unseen = {-1.0: [[1, 1, 1], [1, 0, 1]], 0.2: [[1, -3, -5]]}
# matrices with the basis as columns
g_unseen = {
    sp.Rational(1, 5): sp.Matrix([-1, 3, 5]),
    sp.Integer(-1): sp.Matrix([[0, 1], [1, 0], [0, 1]]),
}
h_region = sp.Or(alpha < -2, alpha > -2)  # two intervals
h_unseen = {-2: [[-1, 2, 1], [0, 2, 1]]}  # the two eigenvectors
h_unseen = {-2: sp.Matrix([[0, 1, -2]]).nullspace()}  # a list of columns
# the sum of the squares of two minors
i_region = sp.Ne((alpha - 1) ** 2 + ((alpha - 3) * (alpha - 1)) ** 2, 0)
# one of several minors does not vanish
i_region = sp.Or(sp.Ne(alpha - 1, 0), sp.Ne((alpha - 3) * (alpha - 1), 0))
i_unseen = {1: [(0, -1, 1)]}  # the other sign, as a tuple
i_unseen = {1.0: sp.Matrix([0, 5, -5])}  # a column
j_region = sp.Ne((1 + alpha) * (1 + alpha**2), 0)  # a factor that never vanishes kept
j_unseen = {-1: [[2, 0, 2]]}  # another length
# an array of floats
import numpy as np

j_unseen = {-1: np.array([[-0.5, 0.0, -0.5]])}
