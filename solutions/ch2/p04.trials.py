# %% wrong
a_observable = sp.Ne(1 + alpha + beta, 0)  # the root of 1 + s taken to be +1
a_observable = sp.Ne(1 - alpha - beta, 0)  # the sign of beta lost in the second row of N
a_observable = sp.And(sp.Ne(alpha - beta, 1), alpha > 0, beta > 0)  # stability asked for as well
# the double root taken for seen, since z is not zero there
a_observable = sp.Or(sp.Ne(alpha - beta, 1), sp.Eq(alpha, 2))
a_observable = sp.Eq(alpha - beta, 1)  # the line where the system is not observable
b_unobservable = sp.Or(sp.Eq(h, -1), sp.Eq(h, -2))  # the roots themselves instead of their opposites
b_unobservable = sp.And(sp.Ne(h, 1), sp.Ne(h, 2))  # the values for which the system is observable
b_unobservable = sp.Eq(h, 1)  # only the value known from item a
b_unobservable = sp.Eq(h, 0)  # without the position no way to know it, so h = 0
b_unseen = {1: [[1, -2]], 2: [[1, -1]]}  # the motions at the wrong values
b_unseen = {1: [[1, 1]], 2: [[2, 1]]}  # the rows of the output instead of the states
b_unseen = {1: [[1, -1]]}  # one of the two motions overlooked

# %% right
# the determinant as it comes, with plain symbols
p, q = sp.symbols("alpha beta")
a_observable = sp.Ne(1 - p + q, 0)
a_observable = sp.Or(alpha < 1 + beta, alpha > 1 + beta)  # two half-planes
a_observable = sp.Not(sp.Eq(beta, alpha - 1))  # a negation, solved for beta
b_unobservable = sp.Eq((h - 1)*(h - 2), 0)  # the determinant, factored
b_unobservable = sp.Eq(sp.Symbol("h")**2 + 2, 3*sp.Symbol("h"))  # the determinant multiplied out, with a plain symbol
b_unseen = {2: [[-3, 6]], 1: [[0.5, -0.5]]}  # other lengths, in the other order
b_unseen = {1: sp.Matrix([1, -1]), 2: sp.Matrix([1, -2])}  # columns
