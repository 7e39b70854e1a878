# %% wrong
# Does the error of an instrument push the motion? (hint 2)
a_augmented = [sp.Matrix([[-1, 0, 1], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 1]])]
# Where does the error enter? Look at the output. (hint 2)
a_augmented = [sp.Matrix([[-1, 0, 0], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# At which rate does a constant change? (hint 1)
a_augmented = [sp.Matrix([[-1, 0, 0], [1, 0, 0], [0, 0, 1]]), sp.Matrix([[1, 0, 1]])]
a_observable = True  # Does it follow that all is found once $x_1$ and the error are? (hint 1)
# Can two constants be confused if only one of them is measured? (hint 1)
a_unseen = [[0, 1, -1]]
a_unseen = [[0, 1, 0], [0, 0, 1]]  # Is the error really hidden, too? (hint 1)
a_amplitude = z  # Is this the error only in the end, when $x_1$ has died out? (hint 1)
a_amplitude = z - z1  # Which sign has the rate at which $x_1$ decays? (hint 1)
# Is the error constant here? (hint 1)
b_augmented = [sp.Matrix([[0, 1, 0], [-1, 0, 0], [0, 0, 0]]), sp.Matrix([[0, 1, 1]])]
# Does a growing error cover everything? It moves in another way than the system. (hint 1)
b_observable = False
# Was the error differentiated along with the motion? (hint 1)
b_amplitude = (z + z2) * sp.exp(-t)
b_amplitude = (z + z2) / 2  # Does the error keep its size as time goes on? (hint 1)
# Does the exponent or its exponential belong into the matrix?
c_augmented = [sp.diag(A_c, 0), sp.Matrix([[1, 0, sp.exp(alpha)]])]
# Did the error take the place of a coordinate in the output?
c_augmented = [sp.Matrix([[-3, -2, 0], [1, 0, 0], [0, 0, alpha]]), sp.Matrix([[1, 1, 0]])]
# Is only a decaying error harmless? Ask instead whether it looks like a motion. (hint 2)
c_region = alpha < 0
c_region = sp.Ne(alpha, -1)  # How many motions of its own has the system? (hint 2)
# Which sign have the eigenvalues of the system? (hint 2)
c_region = sp.And(sp.Ne(alpha, 1), sp.Ne(alpha, 2))
# Does the error have the same size in both cases? Ask what z shows of each eigenvector. (hint 2)
c_unseen = {-1: [[-1, 1, 1]], -2: [[-2, 1, 1]]}
# Do motion and error cancel here, or add up? (hint 1)
c_unseen = {-1: [[-1, 1, -1]], -2: [[-2, 1, -2]]}
# Is the error lost alone, or together with a motion? (hint 1)
c_unseen = {-1: [[0, 0, 1]], -2: [[0, 0, 1]]}
# Is one coordinate enough for a sine? (hint 1)
d_augmented = [sp.diag(A_d, omega), sp.Matrix([[1, 0, 1]])]
# Do these two equations give a sine, or exponentials? (hint 2)
d_augmented = [sp.diag(A_d, sp.Matrix([[0, omega], [omega, 0]])), sp.Matrix([[1, 0, 1, 0]])]
d_region = sp.Ne(omega, 1)  # Is this the exceptional value of the example alone? (hint 2)
# Is there a frequency at which the error is not there at all? (hint 2)
d_region = sp.Ne(omega**2, 1)
d_region = sp.Ne(omega, 0)  # Is zero frequency the only danger? Think of resonance. (hint 1)
# Is this the condition for state and error together? (hint 2)
d_state = sp.And(sp.Ne(omega, 0), sp.Ne(omega**2, 1))
d_state = sp.true  # Does the known phase save the state at resonance as well? (hint 1)
# Can the amplitude be found from an error that is not there? (hint 1)
d_amplitude = sp.And(sp.Ne(omega, 1), sp.Ne(omega, -1))
# Have both resonances the same sign? (hint 1)
d_unseen = {0: [[0, 0, 1]], 1: [[0, 1, -1]], -1: [[0, 1, -1]]}
# Is the phase of the error unknown? (hint 2)
d_unseen = {0: [[0, 0, 1]], 1: [[0, 1, -1], [1, 0, 0]], -1: [[0, 1, 1], [1, 0, 0]]}
d_unseen = {1: [[0, 1, -1]], -1: [[0, 1, 1]]}  # Was one exceptional value forgotten? (hint 1)

# %% right
# twice C for the coordinate
a_augmented = [
    sp.Matrix([[-1, 0, 0], [1, 0, 0], [0, 0, 0]]),
    sp.Matrix([[1, 0, sp.Rational(1, 2)]]),
]
a_augmented = [[[-1, 0, 0], [1, 0, 0], [0, 0, 0]], [1, 0, 1]]  # nested lists, the row flat
a_unseen = [sp.Matrix([0, -3, 0])]  # another multiple, as a column
a_unseen = [0.0, 1.0, 0.0]  # floats, without the outer list
# the error with the opposite sign
b_augmented = [sp.Matrix([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]), sp.Matrix([[0, 1, -1]])]
b_amplitude = (sp.cosh(t) - sp.sinh(t)) * (z + z2) / 2  # written with hyperbolic functions
c_augmented = [sp.diag(A_c, alpha), sp.Matrix([[1, 0, 2]])]  # half the error
c_region = sp.Ne(alpha**2 + 3 * alpha + 2, 0)  # the polynomial
c_region = sp.Or(alpha < -2, sp.And(alpha > -2, alpha < -1), alpha > -1)  # intervals
c_unseen = {-2: [[2, -1, -2]], -1: [[3, -3, -3]]}  # other multiples and order
c_unseen = {-1.0: [sp.Matrix([1, -1, -1])], -2.0: [(-1.0, 0.5, 1.0)]}  # floats and columns
# the error and its rate
d_augmented = [sp.diag(A_d, sp.Matrix([[0, 1], [-(omega**2), 0]])), sp.Matrix([[1, 0, 1, 0]])]
# cosine and sine interchanged, nested lists
d_augmented = [[[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, -omega], [0, 0, omega, 0]], [1, 0, 0, 1]]
d_region = sp.Ne(omega * (omega**2 - 1) ** 2, 0)  # the determinant of Kalman's matrix
d_state = sp.Ne(omega**2, 1)  # the square
d_state = sp.Or(sp.Abs(omega) < 1, sp.Abs(omega) > 1)  # the modulus
d_amplitude = sp.Ne(omega**3 - omega, 0)  # a product
# the complement of a set
d_amplitude = sp.Complement(sp.S.Reals, sp.FiniteSet(0, 1, -1)).as_relational(omega)
d_unseen = {-1: [[0, -2, -2]], 1: [[0, -1, 1]], 0: [[0, 0, 7]]}  # other multiples and order
# floats, without the outer lists
d_unseen = {0.0: [0, 0, 1.0], 1.0: [0, 0.5, -0.5], -1.0: [0, 0.5, 0.5]}
