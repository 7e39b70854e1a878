# %% wrong
possible = sp.Ne(beta, 1)  # Was one of the two roots overlooked? (hint 2)
# The form does not depend on the parameter. But can the system always be brought to it? (hint 1)
possible = True
# Are these the values at which one element of P vanishes? (hint 2)
possible = sp.And(sp.Ne(beta, sp.Rational(2, 5)), sp.Ne(beta, sp.Rational(1, 4)))
# Have the two combinations changed places? (hint 1)
lost = {sp.Rational(1, 2): [[1, -1]], 1: [[2, -1]]}
# Are these right eigenvectors where left ones are needed? (hint 2)
lost = {sp.Rational(1, 2): [[1, 1]], 1: [[1, 2]]}
canonical = sp.Matrix([[-4, 1], [-3, 0]])  # Is this the form by observation?
# In which order do the coefficients stand in the last row? (hint 1)
canonical = sp.Matrix([[0, 1], [-4, -3]])
# Was a coefficient of the polynomial added instead of subtracted? (hint 1)
basis = sp.Matrix([[-3 * beta - 2, beta], [-9, 1]])
# Does this lead from x to the new coordinates, instead of from them to x? (hint 1)
basis = sp.Matrix([[1, -beta], [1 - 4 * beta, 5 * beta - 2]]) / (-2 * (2 * beta - 1) * (beta - 1))
# Which sign must c A b have?
coordinate = sp.Matrix([[1, -beta]]) / (2 * (2 * beta - 1) * (beta - 1))
# Must c be parallel to b, or such that u drops out? (hint 1)
coordinate = sp.Matrix([[beta, 1]]) / (2 * (2 * beta - 1) * (beta - 1))
# Is this the equation of one of the given coordinates? (hint 1)
equation = sp.Eq(y.diff(t, 2) + 4 * y.diff(t) + 3 * y, u.diff(t) + (4 * beta - 1) * u)
# Did the terms change their sign when they were moved to the left? (hint 1)
equation = sp.Eq(y.diff(t, 2) - 4 * y.diff(t) - 3 * y, u)
# Is this the equation of a single mode? (hint 1)
equation = sp.Eq(y.diff(t) + 3 * y, (beta - 1) * u)

# %% right
possible = sp.Ne(4 * beta**2 - 6 * beta + 2, 0)  # the determinant
# three intervals
possible = sp.Union(
    sp.Interval.open(-sp.oo, 0.5), sp.Interval.open(0.5, 1), sp.Interval.open(1, sp.oo)
)
lost = {1: [[-3, 3]], 0.5: [[1, -0.5]]}  # a decimal as the value, other lengths
lost = {sp.S.Half: [sp.Matrix([[-2, 1]])], sp.S.One: [sp.Matrix([[1, -1]])]}  # rows as matrices
# an array
import numpy as np

canonical = np.array([[0.0, 1], [-3, -4]])
# multiplied out, a list
coordinate = [1 / (6 * beta - 4 * beta**2 - 2), beta / (4 * beta**2 - 6 * beta + 2)]
# by the modes
coordinate = sp.Matrix([[2, -1]]) / (4 * beta - 2) - sp.Matrix([[1, -1]]) / (2 * beta - 2)
equation = sp.Eq(u, 3 * y + 4 * y.diff(t) + y.diff(t, 2))  # solved for u
# in factors, one bracket after the other
inner = y.diff(t) + 3 * y
equation = sp.Eq(inner.diff(t) + inner - u, 0)
