# %% wrong
# In which direction of time does this equation run? (hint 1)
rate = sp.Matrix([[-(s12**2), s11 - s12 * s22], [s11 - s12 * s22, 2 * s12 - s22**2]])
# Is this the linear equation, with the square left out? (hint 1)
rate = sp.Matrix([[0, -s11], [-s11, -2 * s12]])
# Was A put in the place of its transpose? (hint 2)
rate = sp.Matrix([[s12**2 - 2 * s12, s12 * s22 - s22], [s12 * s22 - s22, s22**2]])
# Is the state paid for on the way? (hint 2)
rate = sp.Matrix([[s12**2 - 1, s12 * s22 - s11], [s12 * s22 - s11, s22**2 - 2 * s12 - 1]])
# Is this the cost with t left, instead of 1 - t? (hint 1)
S = sp.Matrix([[12 * (1 + t), 6 * t * (t + 2)], [6 * t * (t + 2), 4 * (t**3 + 3 * t**2 + 3)]]) / (
    t**4 + 4 * t**3 + 12 * t + 12
)
# Is the price of the end this one, without the factor that both terms of J have? (hint 1)
tau = 1 - t
S = (
    sp.Matrix([[1 + tau, tau + tau**2 / 2], [tau + tau**2 / 2, 1 + tau**2 + tau**3 / 3]])
    / (1 + tau + tau**3 / 3 + tau**4 / 12)
    / 2
)
S = sp.eye(2)  # Does the price of a state not change with the time that is left? (hint 1)
# Is this the inverse of the matrix that was asked for? (hint 2)
S = sp.Matrix(
    [
        [1 + (1 - t) ** 2 + (1 - t) ** 3 / 3, t - 1 - (1 - t) ** 2 / 2],
        [t - 1 - (1 - t) ** 2 / 2, 2 - t],
    ]
)
# Which sign has a feedback $u = Kx$ that brakes? (hint 1)
tau = 1 - t
gain = [
    (tau + tau**2 / 2) / (1 + tau + tau**3 / 3 + tau**4 / 12),
    (1 + tau**2 + tau**3 / 3) / (1 + tau + tau**3 / 3 + tau**4 / 12),
]
# Do these gains belong to the time that is left, or to the time that has gone? (hint 1)
gain = [
    -6 * t * (t + 2) / (t**4 + 4 * t**3 + 12 * t + 12),
    -4 * (t**3 + 3 * t**2 + 3) / (t**4 + 4 * t**3 + 12 * t + 12),
]
# Is this the first row of S? (hint 2)
tau = 1 - t
gain = [
    -(1 + tau) / (1 + tau + tau**3 / 3 + tau**4 / 12),
    -(tau + tau**2 / 2) / (1 + tau + tau**3 / 3 + tau**4 / 12),
]
# Is the gain at the initial time also right at the final time?
gain = [-sp.Rational(18, 29), -sp.Rational(28, 29)]
gain = [0, 0]  # The limit for very much time: how much is there? (hint 1)
cost = (
    24 * x10**2 + 36 * x10 * x20 + 28 * x20**2
) / 29  # Was a factor before the cost lost? (hint 1)
# How often does a product occur in a quadratic form? (hint 1)
cost = (12 * x10**2 + 9 * x10 * x20 + 14 * x20**2) / 29
cost = (x10**2 + x20**2) / 2  # Is this what is paid at the end if nothing moves? (hint 1)
cost = ((x10 + x20) ** 2 + x20**2) / 2  # Is this the price without any control? (hint 1)

# %% right
# the left-hand side of a symmetric product
rate = sp.Matrix([[s12**2, s12 * s22], [s12 * s22, s22**2]]) - sp.Matrix([[0, s11], [s11, 2 * s12]])
# the inverse of P
tau = 1 - t
S = sp.Matrix([[1 + tau**2 + tau**3 / 3, -tau - tau**2 / 2], [-tau - tau**2 / 2, 1 + tau]]).inv()
# the gains over the determinant of P
tau = 1 - t
gain = [
    -(tau + tau**2 / 2) / (1 + tau + tau**3 / 3 + tau**4 / 12),
    -(1 + tau**2 + tau**3 / 3) / (1 + tau + tau**3 / 3 + tau**4 / 12),
]
cost = sp.Rational(12, 29) * (x10 + sp.Rational(3, 4) * x20) ** 2 + x20**2 / 4  # a sum of squares
