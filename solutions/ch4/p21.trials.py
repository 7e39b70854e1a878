# %% wrong
# What is the sign of the second row of the matrix? (hint 2)
limit = sp.Matrix([[20, 8], [8, 32]]) / 27
# Are the two coordinates decoupled? (hint 2)
limit = sp.diag(sp.Rational(4, 3), sp.Rational(4, 3))
limit = sp.zeros(2)  # The influence of the initial state vanishes. And that of the noise? (hint 1)
exponents = [half]  # Is this the factor of the mean? (hint 1)
exponents = [1]  # Constant terms are not counted. Which terms are not constant? (hint 1)
# Does $\Phi$ only halve? (hint 2)
motion = sp.Matrix([[20, -8], [-8, 32]]) / 27 * (1 - sp.Rational(1, 4) ** k) + start / 4**k
# Was the difference from the limit multiplied, or the initial covariance? (hint 1)
F = sp.Matrix([[1 + k, k], [-k, 1 - k]]) / 2**k
motion = sp.Matrix([[20, -8], [-8, 32]]) / 27 + F * start * F.T

# %% right
limit = (sp.Matrix([[20, -8], [-8, 32]]) / sp.Integer(27)).T  # one denominator
# entry by entry
rest = start - sp.Matrix([[20, -8], [-8, 32]]) / 27
a, b, c = rest[0, 0], rest[0, 1], rest[1, 1]
first = (1 + k) ** 2 * a + 2 * k * (1 + k) * b + k**2 * c
second = -k * (1 + k) * a + (1 - 2 * k**2) * b + k * (1 - k) * c
third = k**2 * a - 2 * k * (1 - k) * b + (1 - k) ** 2 * c
motion = sp.Matrix([[20, -8], [-8, 32]]) / 27 + sp.Matrix([[first, second], [second, third]]) / 4**k
