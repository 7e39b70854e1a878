# %% wrong
a_observable = True  # z and its derivative contain all three states, so all seem to be known
a_unseen = [[1, 0, -1]]  # a row of N, which is what is seen, taken for the unseen state
a_unseen = [[1, 0, 0], [0, 0, 1]]  # what one moment does not see: the states with x2 = 0
a_split = sp.Matrix([[0, 1, 0], [1, 0, -1], [-1, 0, 1]])  # the matrix N itself, which has no inverse
a_split = sp.Matrix([[0, 0, 1], [0, 1, 0], [1, 0, -1]])  # z and its derivative, but the hidden coordinate put first
b_observable = True  # the unknown states act on the measured one, which is taken to suffice
b_unseen = [[0, 1, 0]]  # the measured coordinate
b_unseen = [[1, 0, 1]]  # the sign lost
b_split = sp.Matrix([[0, 1, 0], [1, 0, 0], [1, 1, 1]])  # z and its integral taken for the observable part
c_observable = True  # A is regular and all states act on each other, so all is thought to be seen
c_unseen = [[1, 0, -1], [0, 1, 0]]  # what one moment does not see: the plane x1 + x3 = 0
c_split = sp.Matrix([[1, 1, 1], [0, 1, 0], [1, 0, 0]])  # new coordinates written into the columns
d_observable = True  # no two rows of N are proportional, so they are thought to be independent
d_unseen = []  # none, since z and its derivatives contain all states
d_split = sp.Matrix([[0, 0, 1], [0, 1, -1], [1, 0, -1]])  # x = T (xi; eta), the inverse of what is asked
e_observable = True  # one slip in the last row of N, and its determinant is not zero
e_unseen = [[1, 1, 1]]  # the signs lost
e_split = sp.Matrix([[1, 0, 1], [0, 1, 0], [0, 0, 1]])  # z kept, the other two coordinates as they were
f_observable = True  # in the long run the state becomes known, which is not observability
f_unseen = [[1, 0, -1], [0, 0, 0]]  # the zero vector added to the basis
f_unseen = [[0, 1, 0]]  # the state that the second observable coordinate measures
f_split = sp.eye(3)  # the variables left as they are
g_observable = True  # complex eigenvalues thought to make everything visible
g_unseen = [[1, 0, -1]]  # the measured direction
g_split = sp.Matrix([[1, 0, -1], [0, 0, 1], [0, 1, 0]])  # the hidden coordinate between the two observable ones
h_observable = True  # three different eigenvalues thought to suffice for one output
h_unseen = [[1, -1, 0]]  # the eigenvector with the eigenvalue -1, which is seen
h_split = sp.Matrix([[1, -1, 0], [1, 0, 1], [1, 1, 0]])  # the eigenvectors written into the rows

# %% right
a_unseen = [(-2, 0, -2)]  # another length and sign
a_unseen = sp.Matrix([1, 0, 1])  # a column
a_split = [[0, 1, 0], [1, 0, -1], [1, 0, 0]]  # x1 for the hidden coordinate, nested lists
# the observable coordinates mixed and halved
a_split = sp.Matrix([[1, 1, -1], [sp.Rational(1, 2), 0, -sp.Rational(1, 2)], [1, 1, 1]])
b_unseen = [sp.Matrix([-1, 0, 1])]  # a list of columns
b_unseen = [[0.5, 0.0, -0.5]]  # floats
# the third coordinate orthogonal to the others, as in example 3
b_split = sp.Matrix([[0, 1, 0], [1, 1, 1], [1, 0, -1]])
b_split = [[0, 1, 0], [1, 0, 1], [0, 0, 7]]  # the sum of x1 and x3 in the place of the derivative
c_unseen = [1, -1, -1]  # a single vector without the outer list
c_unseen = ((-3, 3, 3),)  # another length, as a tuple
c_split = sp.Matrix([[1, 0, 1], [1, 1, 0], [3, 2, 0]])  # without coupling: a left eigenvector for the hidden coordinate
# the seen part in its own eigenvectors
c_split = sp.Matrix([[1 + sp.sqrt(5), 2, sp.sqrt(5) - 1], [1 - sp.sqrt(5), 2, -sp.sqrt(5) - 1], [0, 1, 0]])
d_unseen = [[-1, 1, 1]]  # the other sign
d_unseen = sp.Matrix([[2], [-2], [-2]])  # a matrix with one column
d_split = [[1, 0, 1], [1, 1, 0], [3, 1, -1]]  # without coupling: a left eigenvector for the hidden coordinate
d_split = sp.Matrix([[0, 1, -1], [1, 1, 0], [0, 0, 1]])  # differences of the observable coordinates
e_unseen = [[sp.Rational(1, 3), -sp.Rational(1, 3), -sp.Rational(1, 3)]]  # fractions
e_unseen = [(5, -5, -5)]  # a tuple
e_split = sp.Matrix([[1, 0, 1], [1, 1, 0], [4, 1, 5]])  # without coupling: a left eigenvector for the hidden coordinate
e_split = [[1.0, 0.0, 1.0], [1.0, 1.0, 0.0], [1.0, -1.0, -1.0]]  # the third coordinate orthogonal to the others, floats
f_unseen = [[-1, 0, 1]]  # the other sign
f_unseen = sp.Matrix([1, 0, -1])*sp.sqrt(2)  # a column
f_split = sp.Matrix([[1, 0, 1], [0, -1, 0], [0, 0, 1]])  # the derivative of z itself, and x3
f_split = [[1, 0, 1], [0, 1, 0], [1, 1, -2]]  # without coupling: a left eigenvector for the hidden coordinate
g_unseen = [[7, 0, 7]]  # another length
g_split = sp.Matrix([[1, 0, -1], [0, 1, 0], [0, 0, 1]])  # x3 for the hidden coordinate
g_split = [[0, 1, 0], [1, 0, -1], [1, 0, 0]]  # the observable coordinates exchanged
h_unseen = [[-1, -1, 0]]  # the other sign
h_unseen = [[0.25, 0.25, 0.0]]  # floats
h_split = sp.Matrix([[-1, 1, -1], [1, -1, 3], [1, 1, 0]])  # the derivative of z, and the sum of x1 and x2
h_split = [[1, -1, 0], [0, 0, 3], [1, 1, -1]]  # without coupling: a left eigenvector for the hidden coordinate
