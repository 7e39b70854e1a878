# %% wrong
# Does instability rule out a filter, if the system is observable? (hint 1)
exists = sp.And(a > 0, b > 0)
# Can every position be found from the speed? Try a body without a spring. (hint 2)
exists = sp.true
exists = sp.Ne(a, 0)  # Is it the friction that makes the position observable? (hint 2)
# Are both variances of this matrix positive? Try the other root. (hint 2)
covariance = -R * (sp.sqrt(a**2 + Q / R) + a) * sp.diag(1 / b, 1)
# Is this the covariance without a measurement?
covariance = Q / (2 * a) * sp.diag(1 / b, 1)
# Were the two variances interchanged? Which of them does the spring reduce? (hint 2)
covariance = R * (sp.sqrt(a**2 + Q / R) - a) * sp.diag(1, 1 / b)
# Does the second equation hold with equal variances? (hint 1)
covariance = R * (sp.sqrt(a**2 + Q / R) - a) * sp.eye(2)
gain = [0, R * (sp.sqrt(a**2 + Q / R) - a)]  # Is this the column of the covariance itself? (hint 1)
# Which of the two columns belongs to the measured speed? (hint 1)
gain = [(sp.sqrt(a**2 + Q / R) - a) / b, 0]
gain = [0, sp.sqrt(a**2 + Q / R)]  # Was the friction of the system itself counted with the gain?
# With this gain, do the errors decay if b is negative? (hint 1)
gain_negative = [0, sp.sqrt(a**2 + Q / R) - a]
# Does the third equation contain the term with b? (hint 2)
gain_negative = [2, sp.sqrt(a**2 + Q / R) - a]
# What is the sign of b in the root? Here b is negative. (hint 2)
gain_negative = [2, sp.sqrt(a**2 + Q / R + 4 * b) - a]
limit_exists = b > 0  # Is a restoring force enough? Try $a = 0$. (hint 1)
# Does the covariance stay bounded if the position is pushed away from zero? (hint 2)
limit_exists = a > 0
# Is this the condition for a filter for each R? What happens as R grows? (hint 1)
limit_exists = sp.Ne(b, 0)
limit = sp.zeros(2)  # Are the errors zero if the measurement gives no information? (hint 1)
limit = Q / a * sp.diag(1 / b, 1)  # Was the factor 2 of the expansion lost? (hint 1)
limit = Q / (2 * a) * sp.diag(1, 1 / b)  # Were the two variances interchanged?
# Does the stiffness not affect the variance of the position? (hint 1)
free = Q / (2 * a) * sp.eye(2)
# Are position and speed correlated in a stationary process? (hint 1)
free = Q / (2 * a) * sp.Matrix([[1 / b, 1], [1, 1]])
# How many terms with the friction does the third equation have? (hint 1)
free = Q / a * sp.diag(1 / b, 1)

# %% right
exists = sp.Or(b < 0, b > 0)  # two cases
exists = b**2 > 0  # a square
# without a difference of large numbers
covariance = Q / (sp.sqrt(a**2 + Q / R) + a) * sp.diag(1 / b, 1)
gain = [0, -a + sp.sqrt((a**2 * R + Q) / R)]  # one fraction under the root
gain_negative = [2, (Q / R - 4 * b) / (sp.sqrt(a**2 + Q / R - 4 * b) + a)]  # without a difference
limit_exists = sp.And(a + b > 0, a * b > 0)  # by the sum and the product
