# %% wrong
# Does an eigenvalue zero make its mode unobservable? (hint 2)
region = sp.And(sp.Ne(l1, l2), sp.Ne(l1, 0), sp.Ne(l2, 0))
region = sp.And(l1 < 0, l2 < 0)  # Is this stability instead of observability? (hint 1)
region = sp.Ne(l1**2, l2**2)  # Do opposite eigenvalues give equal modes? (hint 1)
unobservable_states = [[1, 1]]  # Is this the direction that is observed best? (hint 1)
unobservable_states = [
    [1, 0],
    [0, 1],
]  # The modes are equal, but is their sum unobservable too? (hint 1)
# Which of the two coordinates must come first? (hint 1)
split = sp.Matrix([[1, -1], [1, 1]])
split = sp.eye(2)  # Can the first coordinate be found from z? (hint 1)
split = sp.Matrix([[1, 1], [2, 2]])  # Can the second row be a multiple of the first? (hint 1)
# What is the output in the new coordinates? (hint 1)
split_system = [sp.diag(l, l), sp.Matrix([[1, 1]])]
# Is the unobservable coordinate constant? (hint 1)
split_system = [sp.diag(l, 0), sp.Matrix([[1, 0]])]

# %% right
# the determinant, with plain symbols
p, q = sp.symbols("l1 l2")
region = sp.Ne(q - p, 0)
region = sp.Or(l1 < l2, l1 > l2)  # two open half-planes
unobservable_states = [(-3, 3)]  # another length and sign, a tuple
unobservable_states = sp.Matrix([1, -1]) / 2  # a column
split = [[1, 1], [0, 1]]  # x2 as the second coordinate
# the half sum and a slanted second coordinate
split = sp.Matrix([[sp.Rational(1, 2), sp.Rational(1, 2)], [1, -5]])
# for the half sum as the observable coordinate
split_system = [sp.diag(l, l), sp.Matrix([[2, 0]])]
