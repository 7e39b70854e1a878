# %% wrong
controllable = sp.Ne(beta, 0)  # Is it enough that the control enters both equations? (hint 2)
# Has the left eigenvector the right sign? (hint 1)
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, -1))
# Does the output matter for controllability? (hint 1)
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, 1), sp.Ne(alpha, -1))
# Does a constant numerator mean that control is lost? (hint 1)
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, 1), sp.Ne(alpha * beta, -1))
# Are these columns, directions that can be controlled, in the place of rows? (hint 1)
uncontrolled = {0: [[1, 0]], 1: [[1, 1]]}
uncontrolled = {0: [[0, 1]]}  # Was one of the two left eigenvectors overlooked? (hint 2)
uncontrolled = {0: [[1, -1]], 1: [[0, 1]]}  # Have the two combinations changed places? (hint 1)
observable = sp.Ne(alpha, 0)  # Must both coordinates stand in z? (hint 1)
# Is it enough that $x_2$ acts on $x_1$? Think of the motions that $z$ may lose. (hint 2)
observable = sp.true
observable = sp.Ne(alpha, 1)  # Was a sign lost in the row h A? (hint 2)
# Does the control matter for what is seen? (hint 2)
observable = sp.And(sp.Ne(alpha, -1), sp.Ne(beta, 0))
# Is this the row of the output in the place of a state that it does not see? (hint 1)
unseen = {-1: [[1, -1]]}
unseen = {-1: [[1, 0]]}  # Is this the eigenvector of the other eigenvalue? (hint 1)
unseen = {0: [[0, 1]]}  # Is a coordinate lost as soon as it is not measured? (hint 1)
# Was the derivative of the control forgotten? (hint 1)
equation = sp.Eq(z.diff(t, 2) + 3 * z.diff(t) + 2 * z, (2 - beta + alpha * beta) * u)
# Which sign has the action of $x_2$ on $x_1$? (hint 1)
equation = sp.Eq(
    z.diff(t, 2) + 3 * z.diff(t) + 2 * z,
    (1 + alpha * beta) * u.diff(t) + (2 + beta + alpha * beta) * u,
)
# Does this equation hold for one special value only? It has to be of second order. (hint 2)
equation = sp.Eq(z.diff(t) + z, (1 - beta) * u)
# Were the two fractions added without a common denominator? (hint 1)
equation = sp.Eq(z.diff(t, 2) + 3 * z.diff(t) + 2 * z, (1 + alpha * beta) * u)

# %% right
controllable = sp.Ne(beta**2 - beta, 0)  # the determinant
# three intervals, with a plain symbol
v = sp.Symbol("beta")
controllable = sp.Or(v < 0, sp.And(v > 0, v < 1), v > 1)
# other lengths and signs, columns for rows
uncontrolled = {1: sp.Matrix([-2, 2]), 0: sp.Matrix([0, 5])}
uncontrolled = {0.0: [(0, -0.25)], 1.0: [(0.5, -0.5)]}  # decimals
observable = sp.Or(alpha < -1, alpha > -1)  # two half-planes
observable = sp.Ne(-1 - sp.Symbol("alpha"), 0)  # the determinant, with a plain symbol
unseen = {-1: [(-3, -3)]}  # another length and sign
unseen = {-1.0: sp.Matrix([0.5, 0.5])}  # a decimal key and a column
# solved for the second derivative, sorted by the parameters, plain symbols
a, b = sp.symbols("alpha beta")
equation = sp.Eq(
    z.diff(t, 2), -3 * z.diff(t) - 2 * z + u.diff(t) + 2 * u + b * (a * (u.diff(t) + u) - u)
)
# factors as operators
first, second = z.diff(t) + z, (1 - beta) * u
equation = sp.Eq(
    first.diff(t) + 2 * first, second.diff(t) + 2 * second + (1 + alpha) * beta * (u.diff(t) + u)
)
