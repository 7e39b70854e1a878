# %% wrong
possible = sp.Ne(alpha, -2)  # Was a root substituted with the wrong sign? (hint 2)
# Is this the exceptional value itself, instead of all others? (hint 1)
possible = sp.Eq(alpha, 2)
# Must the roots be real and different? (hint 1)
possible = sp.And(alpha > -sp.Rational(1, 4), sp.Ne(alpha, 2))
# The canonical matrix can always be written down. But can the system always be brought to it?
# (hint 1)
possible = sp.true
unobservable_states = {2: [[1, 2]]}  # Is this the observable motion? (hint 1)
unobservable_states = {-2: [[1, -1]]}  # Was a root substituted with the wrong sign? (hint 1)
# Does z stay zero here for ever, or only at one instant? (hint 1)
unobservable_states = {2: [[1, -1]], 0: [[1, -1]]}
# Which sign do the coefficients of the polynomial have in this form? (hint 1)
canonical = sp.Matrix([[-1, 1], [-alpha, 0]])
canonical = sp.Matrix([[0, 1], [alpha, 1]])  # Is this the matrix as it was given? (hint 1)
# Is the derivative of z the second coordinate, or must something be subtracted? (hint 2)
transformation = sp.Matrix([[1, 1], [alpha, 2]])
# Is this the inverse transformation, from the new coordinates to the state? (hint 1)
transformation = sp.Matrix([[1, -1], [1 - alpha, 1]]) / (2 - alpha)

# %% right
possible = sp.Or(alpha < 2, alpha > 2)  # two intervals
possible = sp.Ne(sp.Symbol("alpha") - 2, 0)  # by the determinant, with a plain symbol
unobservable_states = {2: [(-0.5, 0.5)]}  # another length and sign
unobservable_states = {2.0: sp.Matrix([3, -3])}  # a decimal key and a column
# the given matrix carried over, not simplified
T = sp.Matrix([[1, 1], [alpha - 1, 1]])
canonical = T * A * T.inv()
