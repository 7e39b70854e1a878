# %% wrong
a_observable = False  # one measurement thought too little for three unknowns
a_unseen = [[0, 1, 0], [0, 0, 1]]  # what one moment does not see: the states with x1 = 0
b_observable = False  # the sign of x3 overlooked, as in example 3
b_unseen = [[1, 0, -1]]  # the unseen state of example 3
c_observable = True  # every coordinate acts on another one, so all are thought to be seen
c_unseen = [[0, 1, 1]]  # what z and its derivative were solved for with a sign lost
c_unseen = [[0, 1, 0], [0, 0, 1]]  # the states that are unseen at the first moment only
c_unseen = [[0, 0, 0]]  # the zero vector belongs to no basis
d_observable = True  # all three coordinates enter z or its derivative
d_unseen = [[1, 0, -1]]  # the sign lost
e_observable = True  # the eigenvalues 0 and 1 both show in z, so nothing is thought to be lost
e_unseen = [[2, -1, 1]]  # the eigenvector that is seen
e_unseen = [[1, 0, 1], [0, 1, 0]]  # a vector too many
f_observable = True  # the third coordinate thought to be seen because it listens to the others
f_unseen = [[1, -1, 0], [0, 0, 1]]  # the states with z = 0 at the first moment
g_region = sp.Ne(alpha, -1)  # one factor of the determinant overlooked
g_region = sp.Or(sp.Eq(alpha, -1), sp.Eq(alpha, sp.Rational(1, 5)))  # the exceptional values given
# inequalities, as if the sign of the determinant mattered
g_region = sp.And(sp.Ne(alpha, -1), alpha < sp.Rational(1, 5))
g_unseen = {-1: [[1, 1, 1]], sp.Rational(1, 5): [[-1, 3, 5]]}  # one vector taken for the whole basis at -1
g_unseen = {-1: [[0, 1, 0], [1, 0, 1]]}  # one value overlooked
g_unseen = {sp.Rational(1, 5): [[0, 1, 0], [1, 0, 1]], -1: [[-1, 3, 5]]}  # the values interchanged
h_region = sp.Ne(alpha, 2)  # a sign lost
h_unseen = {-2: [[-1, 2, 1]]}  # only the eigenvector of the double eigenvalue
h_unseen = {-2: [[1, 0, 0], [0, 2, 1]], 0: [[1, 0, 0]]}  # a value at which nothing is lost added
i_region = sp.And(sp.Ne(alpha, 1), sp.Ne(alpha, 3))  # a single minor taken for the whole matrix
i_unseen = {3: [[0, 1, -1]]}  # the vector that the first output alone does not see, with a wrong value
i_unseen = {1: [[1, 1, 0]]}  # an eigenvector that is seen
j_region = sp.And(sp.Ne(alpha, -1), sp.Ne(alpha, -sp.Rational(1, 2)))  # a single minor taken for the whole matrix
j_region = True  # the minor thought never to vanish
# the eigenvector that z1 alone does not see, at another value
j_unseen = {-1: [[1, 0, 1]], -sp.Rational(1, 2): [[1, 3, 2]]}

# %% right
a_unseen = sp.zeros(3, 0)  # a matrix without columns
b_unseen = sp.zeros(3, 0)  # a matrix without columns
c_unseen = [(0, 2.5, -2.5)]  # another length and sign
c_unseen = sp.Matrix([0, 3, -3])  # a column
d_unseen = [sp.Matrix([-7, 0, -7])]  # a list of columns
# floats of length one
import numpy as np
e_unseen = [np.array([1.0, 0.0, 1.0])/np.sqrt(2)]
e_unseen = ((-1, 0, -1),)  # a tuple of tuples
f_unseen = sp.Matrix([0, 0, -1])  # a column
# an array
import numpy as np
f_unseen = np.array([[0, 0, 4]])
g_region = sp.Ne((alpha + 1)**2*(5*alpha - 1), 0)  # the determinant
# a list of two conditions, a plain symbol and a decimal
g_region = [sp.Ne(sp.Symbol("alpha"), -1), sp.Ne(sp.Symbol("alpha"), 0.2)]
g_unseen = {-1.0: [[1, 1, 1], [1, 0, 1]], 0.2: [[1, -3, -5]]}  # eigenvectors as the basis, a float as the value
# matrices with the basis as columns
g_unseen = {sp.Rational(1, 5): sp.Matrix([-1, 3, 5]), sp.Integer(-1): sp.Matrix([[0, 1], [1, 0], [0, 1]])}
h_region = sp.Or(alpha < -2, alpha > -2)  # two intervals
h_unseen = {-2: [[-1, 2, 1], [0, 2, 1]]}  # the two eigenvectors
h_unseen = {-2: sp.Matrix([[0, 1, -2]]).nullspace()}  # a list of columns
i_region = sp.Ne((alpha - 1)**2 + ((alpha - 3)*(alpha - 1))**2, 0)  # the sum of the squares of two minors
i_region = sp.Or(sp.Ne(alpha - 1, 0), sp.Ne((alpha - 3)*(alpha - 1), 0))  # one of several minors does not vanish
i_unseen = {1: [(0, -1, 1)]}  # the other sign, as a tuple
i_unseen = {1.0: sp.Matrix([0, 5, -5])}  # a column
j_region = sp.Ne((1 + alpha)*(1 + alpha**2), 0)  # a factor that never vanishes kept
j_unseen = {-1: [[2, 0, 2]]}  # another length
# an array of floats
import numpy as np
j_unseen = {-1: np.array([[-0.5, 0.0, -0.5]])}
