# %% wrong
# Was a sign lost in front of a coupling term? (hint 1)
a_roots = sp.solve(5 * sp.Symbol("q") ** 4 + 11 * sp.Symbol("q") ** 2 + 5)
# Are these the values of the square of s? (hint 2)
a_roots = [(-3 + sp.sqrt(149)) / 10, (-3 - sp.sqrt(149)) / 10]
# Are complex roots asked for as well?
a_roots = [sp.sqrt((sp.sqrt(149) - 3) / 10), -sp.sqrt((sp.sqrt(149) - 3) / 10)]
a_uncontrollable_eigenvalues = [1, -1]  # Are these numbers roots of the system at all? (hint 2)
# Is a mode uncontrollable because it grows? (hint 2)
a_uncontrollable_eigenvalues = [sp.sqrt((sp.sqrt(149) - 3) / 10)]
a_controllable = False  # Is one force not enough for two coordinates? (hint 1)
# Were the terms of first order left out? (hint 1)
b_roots = sp.solve(sp.Symbol("q") ** 4 + sp.Symbol("q") ** 2 - 5)
# Do both terms of first order have the same sign? (hint 1)
import numpy as np

b_roots = np.roots([1, -2, -4, 0, -5])
# Does a negative value of the square of s really give no root? (hint 2)
b_roots = [sp.sqrt(sp.sqrt(14) - 3), -sp.sqrt(sp.sqrt(14) - 3)]
# Must the difference of the two components vanish, or each of them? (hint 2)
b_uncontrollable_eigenvalues = [-1]
b_uncontrollable_eigenvalues = [
    sp.sqrt(sp.sqrt(14) - 3)
]  # Do gyroscopic terms distinguish s and -s here? (hint 1)
b_controllable = False  # Do gyroscopic terms exclude controllability? (hint 1)
c_controllable = False  # Must the verdict differ from that of item a? Compute it. (hint 1)
c_region = sp.Ne(k, (13 + sp.sqrt(149)) / 2)  # Was one of the values overlooked? (hint 2)
# Are these the exceptional values instead of the others? (hint 2)
c_region = sp.Eq(k**2 - 13 * k + 5, 0)
c_region = sp.Ne(k, 0)  # Must the force act on both coordinates? (hint 1)
c_region = sp.true  # Is no number excluded because no rational number is? (hint 2)
# Was the row taken with the two forces swapped? (hint 1)
c_region = sp.Ne(5 * k**2 - 13 * k + 1, 0)
# Were the roots of the other factor left out? (hint 1)
d_roots = [sp.sqrt(3 - beta), -sp.sqrt(3 - beta)]
# What is the sign of the parameter under the root? (hint 1)
d_roots = [sp.I, -sp.I, sp.sqrt(beta - 3), -sp.sqrt(beta - 3)]
d_region = sp.Ne(beta, 8)  # Was it tested with the shapes instead of the left mode shapes? (hint 1)
d_region = sp.Ne(beta, 3) & sp.Ne(beta, 4)  # Is a double root always uncontrollable? (hint 2)
d_region = beta > 3  # Does the stability of the motion without control matter? (hint 2)
d_region = sp.Eq(beta, 3)  # Is this the exceptional value instead of all others? (hint 2)
# Does the rank at the uncontrollable root give the full dimension? (hint 2)
d_uncontrolled = {3: [[0, 0, 2, 1]]}
# Does this row combine equations, where coordinates are required? (hint 1)
d_uncontrolled = {3: [[3, -1, 0, 0], [0, 0, 3, -1]]}
# Is this the shape of a motion instead of a row? (hint 1)
d_uncontrolled = {3: [[1, -1, 0, 0], [0, 0, 1, -1]]}
# Does this combination belong to another value of the parameter? (hint 1)
d_uncontrolled = {4: [[2, 1, 0, 0], [0, 0, 2, 1]]}

# %% right
a_roots = {0.9595, -0.9595, 1.2331j, -1.2331j}  # decimals, as a Python set
# as an array
import numpy as np

b_roots = np.roots([1, 0, 6, 0, -5])
# as a dictionary with multiplicities
b_roots = sp.roots(sp.Symbol("q") ** 4 + 6 * sp.Symbol("q") ** 2 - 5)
# the two values excluded one by one
c_region = sp.Ne(k, (13 + sp.sqrt(149)) / 2) & sp.Ne(k, (13 - sp.sqrt(149)) / 2)
c_region = (k**2 - 13 * k + 5 > 0) | (k**2 - 13 * k + 5 < 0)  # as the parts of the real axis
c_region = sp.Not(sp.Eq(13 * k, k**2 + 5))  # the condition negated
# the imaginary form of the second pair
d_roots = [sp.I, -sp.I, sp.I * sp.sqrt(beta - 3), -sp.I * sp.sqrt(beta - 3)]
d_region = (beta < 3) | (beta > 3)  # as two open rays
d_region = sp.Ne(4 * (beta - 3) ** 2, 0)  # from the determinant
d_uncontrolled = {3: [[2, 1, 2, 1], [0, 0, -4, -2]]}  # another basis of the same rows
# rows as a matrix
d_uncontrolled = {3: [sp.Matrix([[1, sp.Rational(1, 2), 0, 0]]), sp.Matrix([[2, 1, 4, 2]])]}
