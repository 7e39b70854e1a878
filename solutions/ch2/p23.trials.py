# %% wrong
a_region = sp.And(lam1 < 0, lam2 < 0, sp.Ne(lam1, lam2))  # stable rates asked for
a_region = sp.true  # each part is controllable, so the whole is thought to be
a_region = sp.Ne(lam1**2, lam2**2)  # rates of opposite sign excluded too
b_region = sp.false  # equal stiffness taken for a common eigenvalue
b_region = sp.true  # each house is controllable, so both are thought to be
b_region = sp.Ne(p, 1)  # the real part of the eigenvalue compared with p
b_region = sp.And(sp.Ne(p, 2), p**2 < 20)  # a swinging second house asked for
b_uncontrolled = {2: [[1, 0, -1, 0]]}  # the velocity forgotten: two eigenvalues are common
b_uncontrolled = {2: [[1, 0, 1, 0], [0, 1, 0, 1]]}  # sums in place of differences, as for outputs that cancel
# double real roots of the second house thought to be bad as well
b_uncontrolled = {2: [[1, 0, -1, 0], [0, 1, 0, -1]], sp.sqrt(20): [[1, 0, -1, 0]]}
c_uncontrolled = {2: [[1, 0, -1]], 3: [[2, -1, -2]]}  # the shares of the pipe forgotten
# the content of the lower tank taken for the quantity with the rate -3
c_uncontrolled = {2: [[2, 0, -1]], 3: [[0, 2, -1]]}
c_uncontrolled = {2: [[2, 0, -1]]}  # only the tank that the pipe fills compared with y
c_uncontrolled = {2: [[1, 2, -2]], 3: [[0, 1, -1]]}  # columns: what a motion with the common rate looks like
d_own_pipe = False  # the theorem used for two controls
d_lower_pipe = sp.true  # any second control thought to repair a common eigenvalue
d_lower_pipe = sp.And(sp.Ne(r, 2), sp.Ne(r, 3))  # the theorem used for two controls
d_lower_pipe = sp.Ne(r, 3)  # the pipe into the tank with the rate -3 thought to collide with r = 3

# %% right
# the difference squared, with plain symbols
v1, v2 = sp.symbols("lam1 lam2")
a_region = (v1 - v2)**2 > 0
a_region = sp.Or(lam1 > lam2, lam1 < lam2)  # two open half-planes
b_region = sp.Ne(5*(p - 2)**2, 0)  # the determinant
# two intervals, with a plain symbol
v = sp.Symbol("p")
b_region = sp.Or(sp.And(v > 0, v < 2), v > 2)
b_uncontrolled = {2: [[1, 1, -1, -1], [1, -1, -1, 1]]}  # another basis of the same plane
# a matrix with the basis as columns, a decimal key
b_uncontrolled = {2.0: sp.Matrix([[-3, 0], [0, 2], [3, 0], [0, -2]])}
c_uncontrolled = {3: [[-4, 2, 2]], 2: [[-2, 0, 1]]}  # other lengths and signs, in another order
c_uncontrolled = {2: [(1, 0, -0.5)], 3: [(1, -0.5, -0.5)]}  # divided by the first coefficient
d_lower_pipe = (r - 2)**2 > 0  # a square of the difference
# two intervals, with a plain symbol
v = sp.Symbol("r")
d_lower_pipe = sp.Or(sp.And(v > 0, v < 2), v > 2)
