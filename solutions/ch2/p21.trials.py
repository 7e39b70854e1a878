# %% wrong
possible = sp.Ne(beta, 1)  # one of the two roots overlooked
possible = True  # the form itself is free of beta, so it is thought to exist always
# the values at which a coefficient of P vanishes
possible = sp.And(sp.Ne(beta, sp.Rational(2, 5)), sp.Ne(beta, sp.Rational(1, 4)))
lost = {sp.Rational(1, 2): [[1, -1]], 1: [[2, -1]]}  # the two combinations exchanged
lost = {sp.Rational(1, 2): [[1, 1]], 1: [[1, 2]]}  # right eigenvectors
canonical = sp.Matrix([[-4, 1], [-3, 0]])  # the form by observation
canonical = sp.Matrix([[0, 1], [-4, -3]])  # the coefficients of the last row in the order of the polynomial
basis = sp.Matrix([[-3*beta - 2, beta], [-9, 1]])  # p1 = Ab - 4b: the sign of alpha_2 turned
basis = sp.Matrix([[1, -beta], [1 - 4*beta, 5*beta - 2]])/(-2*(2*beta - 1)*(beta - 1))  # xi in terms of x
coordinate = sp.Matrix([[1, -beta]])/(2*(2*beta - 1)*(beta - 1))  # the sign: cAb is -1
coordinate = sp.Matrix([[beta, 1]])/(2*(2*beta - 1)*(beta - 1))  # c parallel to b, not orthogonal
equation = sp.Eq(y.diff(t, 2) + 4*y.diff(t) + 3*y, u.diff(t) + (4*beta - 1)*u)  # the equation of x2
# the last row of the form moved to the left without a change of sign
equation = sp.Eq(y.diff(t, 2) - 4*y.diff(t) - 3*y, u)
equation = sp.Eq(y.diff(t) + 3*y, (beta - 1)*u)  # a single one of the modes: of first order

# %% right
possible = sp.Ne(4*beta**2 - 6*beta + 2, 0)  # the determinant
# three intervals
possible = sp.Union(sp.Interval.open(-sp.oo, 0.5), sp.Interval.open(0.5, 1), sp.Interval.open(1, sp.oo))
lost = {1: [[-3, 3]], 0.5: [[1, -0.5]]}  # a decimal as the value, other lengths
lost = {sp.S.Half: [sp.Matrix([[-2, 1]])], sp.S.One: [sp.Matrix([[1, -1]])]}  # rows as matrices
# an array
import numpy as np
canonical = np.array([[0.0, 1], [-3, -4]])
coordinate = [1/(6*beta - 4*beta**2 - 2), beta/(4*beta**2 - 6*beta + 2)]  # multiplied out, a list
coordinate = sp.Matrix([[2, -1]])/(4*beta - 2) - sp.Matrix([[1, -1]])/(2*beta - 2)  # by the modes
equation = sp.Eq(u, 3*y + 4*y.diff(t) + y.diff(t, 2))  # solved for u
# in factors, one bracket after the other
inner = y.diff(t) + 3*y
equation = sp.Eq(inner.diff(t) + inner - u, 0)
