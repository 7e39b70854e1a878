# %% wrong
# The mean is unbiased without a drift. Does it ignore one? (hint 1)
a_weights = [sp.Rational(1, 3)] * 3
# Two samples suffice for the conditions. Is their variance the least? (hint 1)
a_weights = [q / (q - 1), 1 / (1 - q), 0]
# Which sample does the drift affect most? (hint 2)
a_weights = [1 / (1 - q) / 2, sp.Rational(1, 2), q / (q - 1) / 2]
# Do the weights satisfy both conditions, also that their sum is 1? (hint 2)
s1, s2 = 1 + q + q**2, 1 + q**2 + q**4
a_weights = [1 - s1 * q**k / s2 for k in range(3)]
b_condition = q < 1  # Is a drift that grows worse than one that fades? Try $q = 2$. (hint 1)
b_condition = sp.true  # Try a drift that does not fade at all. (hint 1)
# Do these numbers minimise the sum of squares? (hint 1)
c_estimates = [(h0 + h1 + h2) / 3, h0 - (h0 + h1 + h2) / 3]
c_estimates = [(q * h0 - h1) / (q - 1), (h1 - h0) / (q - 1)]  # Was the third sample used? (hint 1)
# Is this inverted? (hint 2)
c_covariance = sigma**2 * sp.Matrix([[3, 1 + q + q**2], [1 + q + q**2, 1 + q**2 + q**4]])
# Are the errors of the two estimates uncorrelated? (hint 1)
c_covariance = sigma**2 * sp.diag(sp.Rational(1, 3), 1 / (1 + q**2 + q**4))
# Was the standard deviation used instead of the variance? (hint 2)
c_covariance = (
    sigma / (2 * (1 - q) ** 2) * sp.Matrix([[1 - q + q**2, -1], [-1, 3 / (1 + q + q**2)]])
)
# What do these weights give for the drift? (hint 2)
d_weights = [-sp.Rational(1, 2), 0, sp.Rational(1, 2)]
# Do these weights give 1 for a slope of 1? (hint 2)
d_weights = [q / (1 - q) ** 2, -(1 + q) / (1 - q) ** 2, 1 / (1 - q) ** 2]
d_weights = [q / (q - 1), 1 / (1 - q), 0]  # Is this a weighting for the level? (hint 1)

# %% right
# as lambda + mu q^k, a column
a_weights = sp.Matrix([(1 - q + q**2 - q**k) / (2 * (1 - q) ** 2) for k in range(3)])
b_condition = sp.Or(q < 1, q > 1)  # two intervals
b_condition = (1 - q) ** 2 > 0  # by the determinant
# by the pseudoinverse
G = sp.Matrix([[1, 1], [1, q], [1, q**2]])
c_estimates = list((G.T * G).inv() * G.T * sp.Matrix([h0, h1, h2]))
G = sp.Matrix([[1, 1], [1, q], [1, q**2]])
c_covariance = sigma**2 * (G.T * G).inv()  # as an inverse
d_weights = (-1 + 1 / (1 - q), 1 - 2 / (1 - q), 1 / (1 - q))  # as from the conditions
