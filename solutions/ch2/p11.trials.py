# %% wrong
a_observable = True  # Is it enough that z and its derivative contain all states? (hint 1)
a_unseen = [[1, 0, -1]]  # Is this a row of what is seen instead of an unobservable state? (hint 1)
# Are these the states with zero output at a single instant only? (hint 1)
a_unseen = [[1, 0, 0], [0, 0, 1]]
a_split = sp.Matrix([[0, 1, 0], [1, 0, -1], [-1, 0, 1]])  # Has this matrix an inverse? (hint 1)
# Which coordinates have to stand first? (hint 1)
a_split = sp.Matrix([[0, 0, 1], [0, 1, 0], [1, 0, -1]])
b_observable = True  # Is it enough that the other states act on the measured one? (hint 1)
b_unseen = [[0, 1, 0]]  # Is this the measured coordinate? (hint 1)
b_unseen = [[1, 0, 1]]  # Was a sign lost? Put the state into z and its derivative. (hint 2)
# Does the integral of z belong to the observable part, or its derivative? (hint 1)
b_split = sp.Matrix([[0, 1, 0], [1, 0, 0], [1, 1, 1]])
c_observable = True  # Does it follow from a regular matrix that all is seen? (hint 1)
# Are these the states with zero output at a single instant only? (hint 1)
c_unseen = [[1, 0, -1], [0, 1, 0]]
# Were the new coordinates written into the columns? (hint 2)
c_split = sp.Matrix([[1, 1, 1], [0, 1, 0], [1, 0, 0]])
d_observable = True  # Can three rows hang on each other although no two do? (hint 2)
# Is nothing hidden as soon as all states occur? Look for a combination that never does. (hint 1)
d_unseen = []
# Does this lead from the new coordinates to the old ones, instead of the other way? (hint 1)
d_split = sp.Matrix([[0, 0, 1], [0, 1, -1], [1, 0, -1]])
# Was the last row computed with a slip? Test it with an unobservable state. (hint 1)
e_observable = True
e_unseen = [[1, 1, 1]]  # Were the signs lost? Put the state into z and its derivative. (hint 1)
# Are the other two coordinates fit to stand beside z as they are? (hint 1)
e_split = sp.Matrix([[1, 0, 1], [0, 1, 0], [0, 0, 1]])
# Is it observable if the state becomes known only in the long run? (hint 1)
f_observable = True
f_unseen = [[1, 0, -1], [0, 0, 0]]  # Can the zero vector belong to a basis? (hint 1)
f_unseen = [[0, 1, 0]]  # Is this what the second observable coordinate measures? (hint 1)
f_split = sp.eye(3)  # Can the variables be left as they are? (hint 1)
g_observable = True  # Do complex eigenvalues make everything visible? (hint 1)
g_unseen = [[1, 0, -1]]  # Is this the measured direction? (hint 1)
# Does the hidden coordinate stand last? (hint 2)
g_split = sp.Matrix([[1, 0, -1], [0, 0, 1], [0, 1, 0]])
h_observable = True  # Are different eigenvalues enough for one output? (hint 1)
h_unseen = [[1, -1, 0]]  # Is this the eigenvector that is seen? (hint 1)
# Were the eigenvectors written into the rows? (hint 1)
h_split = sp.Matrix([[1, -1, 0], [1, 0, 1], [1, 1, 0]])

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
# the sum of x1 and x3 in the place of the derivative
b_split = [[0, 1, 0], [1, 0, 1], [0, 0, 7]]
c_unseen = [1, -1, -1]  # a single vector without the outer list
c_unseen = ((-3, 3, 3),)  # another length, as a tuple
# without coupling: a left eigenvector for the hidden coordinate
c_split = sp.Matrix([[1, 0, 1], [1, 1, 0], [3, 2, 0]])
# the seen part in its own eigenvectors
c_split = sp.Matrix(
    [[1 + sp.sqrt(5), 2, sp.sqrt(5) - 1], [1 - sp.sqrt(5), 2, -sp.sqrt(5) - 1], [0, 1, 0]]
)
d_unseen = [[-1, 1, 1]]  # the other sign
d_unseen = sp.Matrix([[2], [-2], [-2]])  # a matrix with one column
# without coupling: a left eigenvector for the hidden coordinate
d_split = [[1, 0, 1], [1, 1, 0], [3, 1, -1]]
# differences of the observable coordinates
d_split = sp.Matrix([[0, 1, -1], [1, 1, 0], [0, 0, 1]])
e_unseen = [[sp.Rational(1, 3), -sp.Rational(1, 3), -sp.Rational(1, 3)]]  # fractions
e_unseen = [(5, -5, -5)]  # a tuple
# without coupling: a left eigenvector for the hidden coordinate
e_split = sp.Matrix([[1, 0, 1], [1, 1, 0], [4, 1, 5]])
# the third coordinate orthogonal to the others, floats
e_split = [[1.0, 0.0, 1.0], [1.0, 1.0, 0.0], [1.0, -1.0, -1.0]]
f_unseen = [[-1, 0, 1]]  # the other sign
f_unseen = sp.Matrix([1, 0, -1]) * sp.sqrt(2)  # a column
f_split = sp.Matrix([[1, 0, 1], [0, -1, 0], [0, 0, 1]])  # the derivative of z itself, and x3
# without coupling: a left eigenvector for the hidden coordinate
f_split = [[1, 0, 1], [0, 1, 0], [1, 1, -2]]
g_unseen = [[7, 0, 7]]  # another length
g_split = sp.Matrix([[1, 0, -1], [0, 1, 0], [0, 0, 1]])  # x3 for the hidden coordinate
g_split = [[0, 1, 0], [1, 0, -1], [1, 0, 0]]  # the observable coordinates exchanged
h_unseen = [[-1, -1, 0]]  # the other sign
h_unseen = [[0.25, 0.25, 0.0]]  # floats
# the derivative of z, and the sum of x1 and x2
h_split = sp.Matrix([[-1, 1, -1], [1, -1, 3], [1, 1, 0]])
# without coupling: a left eigenvector for the hidden coordinate
h_split = [[1, -1, 0], [0, 0, 3], [1, 1, -1]]
