# %% wrong
possible = sp.Ne(alpha, -2)  # a root -1 sought with the wrong sign: 1 + 1 + alpha
possible = sp.Eq(alpha, 2)  # the exceptional value itself
possible = sp.And(alpha > -sp.Rational(1, 4), sp.Ne(alpha, 2))  # real and different roots asked for
possible = sp.true  # the canonical matrix can be written down for every alpha, so the form exists
unseen = {2: [[1, 2]]}  # the motion that is seen
unseen = {-2: [[1, -1]]}  # the value of the sign slip
unseen = {2: [[1, -1]], 0: [[1, -1]]}  # z = 0 for a moment at another alpha taken for ever
canonical = sp.Matrix([[-1, 1], [-alpha, 0]])  # the coefficients of the polynomial with their own signs
canonical = sp.Matrix([[0, 1], [alpha, 1]])  # the matrix as given, with its coefficients in the last row
transformation = sp.Matrix([[1, 1], [alpha, 2]])  # the second coordinate taken to be dz/dt
transformation = sp.Matrix([[1, -1], [1 - alpha, 1]])/(2 - alpha)  # the way back, from xi to the state

# %% right
possible = sp.Or(alpha < 2, alpha > 2)  # two intervals
possible = sp.Ne(sp.Symbol("alpha") - 2, 0)  # by the determinant, with a plain symbol
unseen = {2: [(-0.5, 0.5)]}  # another length and sign
unseen = {2.0: sp.Matrix([3, -3])}  # a decimal key and a column
# the given matrix carried over, not simplified
T = sp.Matrix([[1, 1], [alpha - 1, 1]])
canonical = T*A*T.inv()
