# %% wrong
controllable = sp.Ne(beta, 0)  # the control enters both equations, and that is thought to be enough
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, -1))  # the left eigenvector of -1 with a wrong sign: (1, 1)
# the condition of observability mixed in, as the transfer function would have it
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, 1), sp.Ne(alpha, -1))
# the hyperbola on which the numerator is a constant
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, 1), sp.Ne(alpha*beta, -1))
uncontrolled = {0: [[1, 0]], 1: [[1, 1]]}  # the controllable directions (columns) in place of what is not controlled
uncontrolled = {0: [[0, 1]]}  # the equal push overlooked
uncontrolled = {0: [[1, -1]], 1: [[0, 1]]}  # the combinations exchanged
observable = sp.Ne(alpha, 0)  # both coordinates have to stand in z
observable = sp.true  # x2 acts on x1, and x1 stands in z: always observable
observable = sp.Ne(alpha, 1)  # a sign lost in h A
observable = sp.And(sp.Ne(alpha, -1), sp.Ne(beta, 0))  # what the control does not move is thought not to be seen
unseen = {-1: [[1, -1]]}  # the output row in place of the state it does not see
unseen = {-1: [[1, 0]]}  # the eigenvector of the other eigenvalue
unseen = {0: [[0, 1]]}  # x2 is thought to be lost where it is not measured
equation = sp.Eq(z.diff(t, 2) + 3*z.diff(t) + 2*z, (2 - beta + alpha*beta)*u)  # the derivative of the control forgotten
# the sign of the action of x2 on x1
equation = sp.Eq(z.diff(t, 2) + 3*z.diff(t) + 2*z, (1 + alpha*beta)*u.diff(t) + (2 + beta + alpha*beta)*u)
equation = sp.Eq(z.diff(t) + z, (1 - beta)*u)  # what is left on the line alpha = -1, taken for all alpha
# the two fractions added without a common denominator
equation = sp.Eq(z.diff(t, 2) + 3*z.diff(t) + 2*z, (1 + alpha*beta)*u)

# %% right
controllable = sp.Ne(beta**2 - beta, 0)  # the determinant
# three intervals, with a plain symbol
v = sp.Symbol("beta")
controllable = sp.Or(v < 0, sp.And(v > 0, v < 1), v > 1)
uncontrolled = {1: sp.Matrix([-2, 2]), 0: sp.Matrix([0, 5])}  # other lengths and signs, columns for rows
uncontrolled = {0.0: [(0, -0.25)], 1.0: [(0.5, -0.5)]}  # decimals
observable = sp.Or(alpha < -1, alpha > -1)  # two half-planes
observable = sp.Ne(-1 - sp.Symbol("alpha"), 0)  # the determinant, with a plain symbol
unseen = {-1: [(-3, -3)]}  # another length and sign
unseen = {-1.0: sp.Matrix([0.5, 0.5])}  # a decimal key and a column
# solved for the second derivative, sorted by the parameters, plain symbols
a, b = sp.symbols("alpha beta")
equation = sp.Eq(z.diff(t, 2), -3*z.diff(t) - 2*z + u.diff(t) + 2*u + b*(a*(u.diff(t) + u) - u))
# factors as operators
first, second = z.diff(t) + z, (1 - beta)*u
equation = sp.Eq(first.diff(t) + 2*first, second.diff(t) + 2*second + (1 + alpha)*beta*(u.diff(t) + u))
