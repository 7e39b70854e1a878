# %% wrong
a_roots = sp.solve(5*sp.Symbol('q')**4 + 11*sp.Symbol('q')**2 + 5)  # the sign in front of 2 x2 lost: 5 s^4 + 11 s^2 + 5
a_roots = [(-3 + sp.sqrt(149))/10, (-3 - sp.sqrt(149))/10]  # the values of s^2
a_roots = [sp.sqrt((sp.sqrt(149) - 3)/10), -sp.sqrt((sp.sqrt(149) - 3)/10)]  # only the real roots
a_lost = [1, -1]  # the zeros of one component of the equation without the force, which are no roots
a_lost = [sp.sqrt((sp.sqrt(149) - 3)/10)]  # a mode that runs away thought to be out of control
a_controllable = False  # one force thought not to be enough for two coordinates
b_roots = sp.solve(sp.Symbol('q')**4 + sp.Symbol('q')**2 - 5)  # the terms of first order left out: 5 s^4 + 5 s^2 - 25
# both terms of first order with a plus: 5 (s^4 - 2 s^3 - 4 s^2 - 5)
import numpy as np
b_roots = np.roots([1, -2, -4, 0, -5])
b_roots = [sp.sqrt(sp.sqrt(14) - 3), -sp.sqrt(sp.sqrt(14) - 3)]  # the negative value of s^2 thought to give no root
b_lost = [-1]  # the zero of the difference of the two components
b_lost = [sp.sqrt(sp.sqrt(14) - 3)]  # one of the two real roots, because gyroscopic terms treat s and -s differently
b_controllable = False  # gyroscopic terms thought to stand in the way
c_controllable = False  # expected to be different from a, or the book would not ask twice
c_region = sp.Ne(k, (13 + sp.sqrt(149))/2)  # one value overlooked
c_region = sp.Eq(k**2 - 13*k + 5, 0)  # the exceptional values in place of the others
c_region = sp.Ne(k, 0)  # force on the second coordinate needed
c_region = sp.true  # no whole number is excluded, so none at all
c_region = sp.Ne(5*k**2 - 13*k + 1, 0)  # the row (1, -k) multiplied with P, as if L were (k, 1)
d_roots = [sp.sqrt(3 - beta), -sp.sqrt(3 - beta)]  # only the factor with beta
d_roots = [sp.I, -sp.I, sp.sqrt(beta - 3), -sp.sqrt(beta - 3)]  # the sign of beta
d_region = sp.Ne(beta, 8)  # tested with the shapes, not with the left shapes
d_region = sp.Ne(beta, 3) & sp.Ne(beta, 4)  # a double root thought to be lost
d_region = beta > 3  # where the motion without control does not run away
d_region = sp.Eq(beta, 3)  # where control is lost
d_uncontrolled = {3: [[0, 0, 2, 1]]}  # only what the rank at the lost root shows
d_uncontrolled = {3: [[3, -1, 0, 0], [0, 0, 3, -1]]}  # the row p, which combines equations and not coordinates
d_uncontrolled = {3: [[1, -1, 0, 0], [0, 0, 1, -1]]}  # the shape of the motion in place of the row
d_uncontrolled = {4: [[2, 1, 0, 0], [0, 0, 2, 1]]}  # another value of beta

# %% right
a_roots = {0.9595, -0.9595, 1.2331j, -1.2331j}  # decimals, as a Python set
# as an array
import numpy as np
b_roots = np.roots([1, 0, 6, 0, -5])
b_roots = sp.roots(sp.Symbol('q')**4 + 6*sp.Symbol('q')**2 - 5)  # as a dictionary with multiplicities
c_region = sp.Ne(k, (13 + sp.sqrt(149))/2) & sp.Ne(k, (13 - sp.sqrt(149))/2)  # the two values excluded one by one
c_region = (k**2 - 13*k + 5 > 0) | (k**2 - 13*k + 5 < 0)  # as the parts of the real axis
c_region = sp.Not(sp.Eq(13*k, k**2 + 5))  # the condition negated
d_roots = [sp.I, -sp.I, sp.I*sp.sqrt(beta - 3), -sp.I*sp.sqrt(beta - 3)]  # the imaginary form of the second pair
d_region = (beta < 3) | (beta > 3)  # as two open rays
d_region = sp.Ne(4*(beta - 3)**2, 0)  # from the determinant
d_uncontrolled = {3: [[2, 1, 2, 1], [0, 0, -4, -2]]}  # another basis of the same rows
d_uncontrolled = {3: [sp.Matrix([[1, sp.Rational(1, 2), 0, 0]]), sp.Matrix([[2, 1, 4, 2]])]}  # rows as a matrix
