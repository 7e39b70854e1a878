# %% wrong
# Is stability required here as well? (hint 1)
a_region = sp.And(lam1 < 0, lam2 < 0, sp.Ne(lam1, lam2))
a_region = sp.true  # Is the whole system controllable whenever each part is? (hint 1)
a_region = sp.Ne(lam1**2, lam2**2)  # Are rates of opposite sign equal? (hint 1)
b_region = sp.false  # Does an equal stiffness give a common eigenvalue? (hint 2)
b_region = sp.true  # Are both controllable together whenever each is? (hint 1)
# Was the real part of an eigenvalue compared with a coefficient? (hint 1)
b_region = sp.Ne(p, 1)
b_region = sp.And(sp.Ne(p, 2), p**2 < 20)  # Must the second house oscillate? (hint 1)
# How many eigenvalues are common? Each makes one combination uncontrollable. (hint 2)
b_uncontrolled = {2: [[1, 0, -1, 0]]}
# Sums or differences: in which of them does u cancel? (hint 1)
b_uncontrolled = {2: [[1, 0, 1, 0], [0, 1, 0, 1]]}
# Does a double root of one house alone destroy controllability? (hint 2)
b_uncontrolled = {2: [[1, 0, -1, 0], [0, 1, 0, -1]], sp.sqrt(20): [[1, 0, -1, 0]]}
# In what proportion does the pipe fill the tanks? (hint 2)
c_uncontrolled = {2: [[1, 0, -1]], 3: [[2, -1, -2]]}
# Does the content of the lower tank alone obey an equation with one rate? (hint 1)
c_uncontrolled = {2: [[2, 0, -1]], 3: [[0, 2, -1]]}
c_uncontrolled = {2: [[2, 0, -1]]}  # Was only one of the tanks compared with y? (hint 1)
# Are these motions, columns, where rows are required? (hint 1)
c_uncontrolled = {2: [[1, 2, -2]], 3: [[0, 1, -1]]}
d_own_pipe = False  # Does the theorem used here hold for two controls of this kind? (hint 1)
d_lower_pipe = sp.true  # Does every second control make the tanks controllable? (hint 1)
# Does the theorem used here hold for a pipe into this tank? (hint 1)
d_lower_pipe = sp.And(sp.Ne(r, 2), sp.Ne(r, 3))
# Does the rate of the tank that the second pipe fills matter? (hint 1)
d_lower_pipe = sp.Ne(r, 3)

# %% right
# the difference squared, with plain symbols
v1, v2 = sp.symbols("lam1 lam2")
a_region = (v1 - v2) ** 2 > 0
a_region = sp.Or(lam1 > lam2, lam1 < lam2)  # two open half-planes
b_region = sp.Ne(5 * (p - 2) ** 2, 0)  # the determinant
# two intervals, with a plain symbol
v = sp.Symbol("p")
b_region = sp.Or(sp.And(v > 0, v < 2), v > 2)
b_uncontrolled = {2: [[1, 1, -1, -1], [1, -1, -1, 1]]}  # another basis of the same plane
# a matrix with the basis as columns, a decimal key
b_uncontrolled = {2.0: sp.Matrix([[-3, 0], [0, 2], [3, 0], [0, -2]])}
c_uncontrolled = {3: [[-4, 2, 2]], 2: [[-2, 0, 1]]}  # other lengths and signs, in another order
c_uncontrolled = {2: [(1, 0, -0.5)], 3: [(1, -0.5, -0.5)]}  # divided by the first coefficient
d_lower_pipe = (r - 2) ** 2 > 0  # a square of the difference
# two intervals, with a plain symbol
v = sp.Symbol("r")
d_lower_pipe = sp.Or(sp.And(v > 0, v < 2), v > 2)
