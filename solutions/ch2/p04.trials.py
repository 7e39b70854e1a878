# %% wrong
# Which root has the polynomial of the output? Mind its sign. (hint 2)
a_observable = sp.Ne(1 + alpha + beta, 0)
a_observable = sp.Ne(1 - alpha - beta, 0)  # Was a sign lost in the second row? (hint 1)
# Must the motions be stable in order to be seen? (hint 1)
a_observable = sp.And(sp.Ne(alpha - beta, 1), alpha > 0, beta > 0)
# Is the motion with the double root seen as a whole? One of the two vanishes in z. (hint 2)
a_observable = sp.Or(sp.Ne(alpha - beta, 1), sp.Eq(alpha, 2))
a_observable = sp.Eq(alpha - beta, 1)  # Is this where the system is not observable? (hint 2)
# Are these the roots themselves? Put one of them into z. (hint 1)
b_unobservable = sp.Or(sp.Eq(h, -1), sp.Eq(h, -2))
# Are these the values for which the system is observable? (hint 2)
b_unobservable = sp.And(sp.Ne(h, 1), sp.Ne(h, 2))
b_unobservable = sp.Eq(h, 1)  # Is this the only motion that can disappear? (hint 2)
# Does the output lose a motion without the position? The equation ties both together. (hint 1)
b_unobservable = sp.Eq(h, 0)
# Does each value hide this motion, or the other one? (hint 1)
b_unseen = {1: [[1, -2]], 2: [[1, -1]]}
# Are these the rows of the output instead of the states? (hint 1)
b_unseen = {1: [[1, 1]], 2: [[2, 1]]}
b_unseen = {1: [[1, -1]]}  # Was one of the two motions overlooked? (hint 1)

# %% right
# the determinant as it comes, with plain symbols
p, q = sp.symbols("alpha beta")
a_observable = sp.Ne(1 - p + q, 0)
a_observable = sp.Or(alpha < 1 + beta, alpha > 1 + beta)  # two half-planes
a_observable = sp.Not(sp.Eq(beta, alpha - 1))  # a negation, solved for beta
b_unobservable = sp.Eq((h - 1) * (h - 2), 0)  # the determinant, factored
# the determinant multiplied out, with a plain symbol
b_unobservable = sp.Eq(sp.Symbol("h") ** 2 + 2, 3 * sp.Symbol("h"))
b_unseen = {2: [[-3, 6]], 1: [[0.5, -0.5]]}  # other lengths, in the other order
b_unseen = {1: sp.Matrix([1, -1]), 2: sp.Matrix([1, -2])}  # columns
