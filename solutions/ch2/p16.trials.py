# %% wrong
# Does the error of an instrument act on the motion? (hint 2)
a_augmented = [sp.Matrix([[-rate_a, 0, 1], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 1]])]
# Where does the error enter? Look at the output. (hint 2)
a_augmented = [sp.diag(A_a, 0), sp.Matrix([[1, 0, 0]])]
# At what rate does a constant change? (hint 1)
a_augmented = [sp.diag(A_a, 1), sp.Matrix([[1, 0, 1]])]
a_observable = True  # Is everything found once $x_1$ and the error are? (hint 1)
# Can two constants be confused if only one of them is measured? (hint 1)
a_unobservable_states = [[0, 1, -1]]
a_unobservable_states = [[0, 1, 0], [0, 0, 1]]  # Is the error really unobservable too? (hint 1)
a_amplitude = z  # Is this the error only in the limit, when $x_1$ has decayed? (hint 1)
a_amplitude = z - z1 / rate_a  # What is the sign of the rate at which $x_1$ decays? (hint 1)
# Is the error constant here? (hint 1)
b_augmented = [sp.diag(A_b, 0), sp.Matrix([[0, 1, 1]])]
# Does a growing error make everything unobservable? Its form differs from that of the motions.
# (hint 1)
b_observable = False
# Was the error differentiated together with the motion? (hint 1)
b_amplitude = (stiffness_b * z + z2) * sp.exp(-growth_b * t)
# Does the error keep its size as time goes on? (hint 1)
b_amplitude = (stiffness_b * z + z2) / (growth_b**2 + stiffness_b)
# Does the exponent or its exponential belong in the matrix?
c_augmented = [sp.diag(A_c, 0), sp.Matrix([[1, 0, sp.exp(alpha)]])]
# Did the error take the place of a coordinate in the output?
c_augmented = [sp.diag(A_c, alpha), sp.Matrix([[1, 1, 0]])]
# Is only a decaying error harmless? Check instead whether it has the form of a motion. (hint 2)
c_region = alpha < 0
# How many independent motions does the system have? (hint 2)
c_region = sp.Ne(alpha, max(c_unobservable_states))
# What is the sign of the eigenvalues of the system? (hint 2)
c_region = sp.And(*(sp.Ne(alpha, -value) for value in c_unobservable_states))
# Does the error have the same size in both cases? Compute z for each eigenvector. (hint 2)
c_unobservable_states = {value: [[value, 1, 1]] for value in c_unobservable_states}
# Do motion and error cancel here, or add up? (hint 1)
c_unobservable_states = {value: [[value, 1, value]] for value in c_unobservable_states}
# Is the error unobservable alone, or together with a motion? (hint 1)
c_unobservable_states = {value: [[0, 0, 1]] for value in c_unobservable_states}
# Is one coordinate enough for a sine? (hint 1)
d_augmented = [sp.diag(A_d, omega), sp.Matrix([[1, 0, 1]])]
# Do these two equations give a sine, or exponentials? (hint 2)
d_augmented = [sp.diag(A_d, sp.Matrix([[0, omega], [omega, 0]])), sp.Matrix([[1, 0, 1, 0]])]
# Is this one of several exceptional values? (hint 2)
d_region = sp.Ne(omega, sp.sqrt(stiffness_d))
# Is there a frequency at which the error is zero? (hint 2)
d_region = sp.Ne(omega**2, stiffness_d)
d_region = sp.Ne(omega, 0)  # Is zero frequency the only exception? Think of resonance. (hint 1)
# Is this the condition for state and error together? (hint 2)
d_state = sp.And(sp.Ne(omega, 0), sp.Ne(omega**2, stiffness_d))
d_state = sp.true  # Does the known phase also make the state observable at resonance? (hint 1)
# Can the amplitude of an error be found where the error is zero? (hint 1)
d_amplitude = sp.Ne(omega**2, stiffness_d)
# Do both resonances have the same sign? (hint 1)
k = sp.sqrt(stiffness_d)
d_unobservable_states = {0: [[0, 0, 1]], k: [[0, k, -1]], -k: [[0, k, -1]]}
# Is the phase of the error unknown? (hint 2)
k = sp.sqrt(stiffness_d)
d_unobservable_states = {0: [[0, 0, 1]], k: [[0, k, -1], [1, 0, 0]], -k: [[0, k, 1], [1, 0, 0]]}
# Was one exceptional value forgotten? (hint 1)
k = sp.sqrt(stiffness_d)
d_unobservable_states = {k: [[0, k, -1]], -k: [[0, k, 1]]}

# %% right
# twice C for the coordinate
a_augmented = [sp.diag(A_a, 0), sp.Matrix([[1, 0, sp.Rational(1, 2)]])]
a_augmented = [sp.diag(A_a, 0).tolist(), [1, 0, 1]]  # nested lists, the row flat
a_unobservable_states = [sp.Matrix([0, -3, 0])]  # another multiple, as a column
a_unobservable_states = [0.0, 1.0, 0.0]  # floats, without the outer list
# the error with the opposite sign
b_augmented = [sp.diag(A_b, growth_b), sp.Matrix([[0, 1, -1]])]
# written with hyperbolic functions
decay = sp.cosh(growth_b * t) - sp.sinh(growth_b * t)
b_amplitude = decay * (stiffness_b * z + z2) / (growth_b**2 + stiffness_b)
c_augmented = [sp.diag(A_c, alpha), sp.Matrix([[1, 0, 2]])]  # half the error
c_region = sp.Ne(alpha**2 + coefficients_c[0] * alpha + coefficients_c[1], 0)  # the polynomial
# intervals
lower, upper = sorted(c_unobservable_states)
c_region = sp.Or(alpha < lower, sp.And(alpha > lower, alpha < upper), alpha > upper)
# other multiples and order
c_unobservable_states = {
    value: [[3 * value, 3, -3 * value]] for value in sorted(c_unobservable_states)
}
# floats and columns
c_unobservable_states = {
    float(value): [sp.Matrix([1, 1 / value, -1])] for value in c_unobservable_states
}
# the error and its rate
d_augmented = [sp.diag(A_d, sp.Matrix([[0, 1], [-(omega**2), 0]])), sp.Matrix([[1, 0, 1, 0]])]
# cosine and sine interchanged, nested lists
d_augmented = [sp.diag(A_d, -S_d).tolist(), [1, 0, 0, 1]]
# the determinant of Kalman's matrix
d_region = sp.Ne(omega * (omega**2 - stiffness_d) ** 2, 0)
d_state = sp.Ne(omega**2, stiffness_d)  # the square
# the modulus
d_state = sp.Or(sp.Abs(omega) < sp.sqrt(stiffness_d), sp.Abs(omega) > sp.sqrt(stiffness_d))
d_amplitude = sp.Ne(omega**3 - stiffness_d * omega, 0)  # a product
# the complement of a set
exceptions = sp.FiniteSet(0, sp.sqrt(stiffness_d), -sp.sqrt(stiffness_d))
d_amplitude = sp.Complement(sp.S.Reals, exceptions).as_relational(omega)
# other multiples and order
k = sp.sqrt(stiffness_d)
d_unobservable_states = {-k: [[0, -2 * k, -2]], k: [[0, -k, 1]], 0: [[0, 0, 7]]}
# floats, without the outer lists
k = float(sp.sqrt(stiffness_d))
d_unobservable_states = {0.0: [0, 0, 1.0], k: [0, k / 2, -0.5], -k: [0, k / 2, 0.5]}

# %% numbers
rate_a, growth_b, stiffness_b, coefficients_c, stiffness_d = [
    (rate, growth, stiffness, [p + q, p * q], k**2)
    for rate, growth, stiffness, p, q, k in [
        *[(1, 1, 1, 1, 2, 1), (2, 1, 4, 1, 3, 2), (3, 2, 1, 2, 3, 3), (1, 2, 1, 2, 6, 7)],
        *[(5, 2, 3, 2, 5, 4), (3, 3, 2, 3, 4, 6), (3, 1, 3, 1, 5, 5), (1, 4, 1, 4, 5, 9)],
        *[(2, 4, 3, 3, 6, 8), (4, 1, 2, 1, 4, 14), (4, 1, 7, 3, 5, 10), (6, 2, 1, 2, 4, 13)],
        *[(4, 1, 4, 5, 6, 12), (1, 2, 3, 5, 7, 11), (7, 1, 4, 5, 9, 15)],
    ]
]
k = sp.sqrt(stiffness_d)
exponent = "t" if growth_b == 1 else f"{{{growth_b}t}}"
shown = [
    r"\dot x_1 = «-rate_a*»x_1,$",
    r"\dot x_2 = «-stiffness_b*»x_1,$ $\quad z = x_2 + Ce^«exponent».",
    r"\dot x_1 = «-coefficients_c[0]*»x_1 - «coefficients_c[1]*»x_2",
    r"\dot x_2 = «-stiffness_d*»x_1,$ $\quad z = x_1 + C\sin",
    r"x_1(0) \cos «k*»t + «1 / k*»x_2(0) \sin «k*»t",
]
a_augmented = [sp.diag(A_a, 0), sp.Matrix([[1, 0, 1]])]
a_amplitude = z + z1 / rate_a
b_augmented = [sp.diag(A_b, growth_b), sp.Matrix([[0, 1, 1]])]
b_amplitude = (stiffness_b * z + z2) * sp.exp(-growth_b * t) / (growth_b**2 + stiffness_b)
c_augmented = [sp.diag(A_c, alpha), sp.Matrix([[1, 0, 1]])]
c_unobservable_states = {value: [[value, 1, -value]] for value in A_c.eigenvals()}
c_region = sp.And(*(sp.Ne(alpha, value) for value in c_unobservable_states))
d_augmented = [sp.diag(A_d, S_d), sp.Matrix([[1, 0, 1, 0]])]
d_region = d_amplitude = sp.And(sp.Ne(omega, 0), sp.Ne(omega, k), sp.Ne(omega, -k))
d_state = sp.And(sp.Ne(omega, k), sp.Ne(omega, -k))
d_unobservable_states = {0: [[0, 0, 1]], k: [[0, k, -1]], -k: [[0, k, 1]]}
