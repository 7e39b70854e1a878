# %% wrong
# Does a measurement make the errors larger? Look at the sign of the quadratic term. (hint 1)
rate = sp.Matrix(
    [[2 * p12 + p11**2 / R, p22 + p11 * p12 / R], [p22 + p11 * p12 / R, Q + p12**2 / R]]
)
# Which of the two equations contains the noise? (hint 2)
rate = sp.Matrix(
    [[2 * p12 + Q - p11**2 / R, p22 - p11 * p12 / R], [p22 - p11 * p12 / R, -(p12**2) / R]]
)
# Does the equation have both terms of the motion, one the transpose of the other? (hint 1)
rate = sp.Matrix([[p12 - p11**2 / R, p22 - p11 * p12 / R], [p22 - p11 * p12 / R, Q - p12**2 / R]])
# Is this matrix positive definite, and do all three equations hold with it? (hint 2)
covariance = sp.Matrix([[0, sp.sqrt(Q * R)], [sp.sqrt(Q * R), 0]])
# Are the errors of position and speed uncorrelated? (hint 1)
covariance = sp.diag(
    sp.sqrt(2) * (Q * R**3) ** sp.Rational(1, 4), sp.sqrt(2) * (Q**3 * R) ** sp.Rational(1, 4)
)
# Was a factor of two lost in the equation of the first entry? (hint 1)
covariance = sp.Matrix(
    [
        [(Q * R**3) ** sp.Rational(1, 4), sp.sqrt(Q * R)],
        [sp.sqrt(Q * R), (Q**3 * R) ** sp.Rational(1, 4)],
    ]
)
# Is this the column of the covariance itself? (hint 1)
gain = [sp.sqrt(2) * (Q * R**3) ** sp.Rational(1, 4), sp.sqrt(Q * R)]
# Which of the two columns belongs to the measured position? (hint 1)
gain = [sp.sqrt(Q / R), sp.sqrt(2) * (Q / R) ** sp.Rational(3, 4)]
# Do these errors grow? What is the sign of the gain in the equation of the errors? (hint 1)
eigenvalues = [
    (Q / R) ** sp.Rational(1, 4) * (1 + sp.I) / sp.sqrt(2),
    (Q / R) ** sp.Rational(1, 4) * (1 - sp.I) / sp.sqrt(2),
]
eigenvalues = [0, 0]  # Are these the eigenvalues of the motion, without a filter?

# %% right
# the fourth roots apart
covariance = sp.Matrix(
    [
        [sp.sqrt(2 * R * sp.sqrt(Q * R)), sp.sqrt(Q) * sp.sqrt(R)],
        [sp.sqrt(Q) * sp.sqrt(R), sp.sqrt(2 * Q * sp.sqrt(Q * R))],
    ]
)
gain = [sp.sqrt(2 * sp.sqrt(Q / R)), sp.sqrt(Q / R)]  # a root of a root
# in polar form
eigenvalues = [
    (Q / R) ** sp.Rational(1, 4) * sp.exp(3 * sp.pi * sp.I / 4),
    (Q / R) ** sp.Rational(1, 4) * sp.exp(-3 * sp.pi * sp.I / 4),
]
