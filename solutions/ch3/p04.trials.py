# %% wrong
# At what rate does a constant change? (hint 1)
a_augmented = [sp.diag(A, 1), sp.Matrix([[1, 0, 1]])]
# Is the third coordinate the error itself, or a part of it?
a_augmented = [sp.Matrix([[0, 1, 0], [-k, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 3]])]
# Does the error of an instrument act on the pendulum? (hint 1)
a_augmented = [sp.Matrix([[0, 1, 0], [-k, 0, 1], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# Were the coefficients compared as in a canonical form? (hint 1)
a_gain = sp.Matrix([beta1, beta2 - k, beta3])
# Was k forgotten in the last coefficient? (hint 2)
a_gain = sp.Matrix([beta1 - beta3, beta2 - k, beta3])
a_region = sp.And(l1 + l3 > 0, l3 > 0)  # Are positive coefficients enough for a cubic? (hint 1)
a_region = l1 > 0  # Does the estimated offset converge without its own correction? (hint 1)
# Was the offset subtracted from the expected measurement? (hint 2)
a_observer = [e2 + (z - e1), -k * e1, z - e1]
# Does the estimate of the offset stay at its initial value here? (hint 2)
a_observer = [e2 + (z - e1 - e3), -k * e1, 0]
a_observer = [e2, -k * e1, z - e1 - e3]  # Is it enough to correct the offset alone? (hint 2)
b_augmented = [sp.diag(A, 0), sp.Matrix([[1, 0, 1]])]  # Is this the output of item a? (hint 1)
# Is this the gain of item a? (hint 1)
b_gain = sp.Matrix([beta1 - beta3 / k, beta2 - k, beta3 / k])
b_gain = sp.Matrix([1 - beta2, beta1 - beta3, beta3])  # Was k forgotten? (hint 1)
b_region = sp.And(l2 + l3 > 0, l3 > 0)  # Are positive coefficients enough for a cubic? (hint 1)
b_region = sp.And(l2 > 0, l3 < 0)  # What is the sign of the correction of the offset? (hint 1)
# Was the offset subtracted from the expected measurement? (hint 1)
b_observer = [e2, -k * e1 + z - e2, z - e2]
# Does a correction of the first equation damp the errors here? (hint 1)
b_observer = [e2 + z - e2 - e3, -k * e1, z - e2 - e3]

# %% right
a_gain = sp.Matrix([(k * beta1 - beta3) / k, beta2 - k, beta3 / k])  # over one denominator
a_region = sp.And(l1 * l3 > 0, l1 + l3 > 0)  # product and sum
a_observer = [z - e1 - e3 + e2, -k * e1, sp.Rational(1, 2) * (z - e1 - e3)]  # a slower average
b_gain = [(k - beta2) / k, beta1 - beta3 / k, beta3 / k]  # a flat list
b_region = sp.Not(sp.Or(l2 <= 0, l3 <= 0))  # the complement
b_observer = [e2, 3.5 * (z - e2 - e3) - k * e1, 0.5 * (z - e2 - e3)]  # decimals
