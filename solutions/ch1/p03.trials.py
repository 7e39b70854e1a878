# %% wrong
a_single = b > 0  # the linear spring forgotten
a_single = b < 0  # hard and soft springs interchanged
a_rest = [1/sp.sqrt(-b), -1/sp.sqrt(-b)]  # divided by x: the solution zero lost
a_rest = [0, 1/sp.sqrt(b), -1/sp.sqrt(b)]  # the sign of b forgotten under the root
a_rest = [0, -1/b, 1/b]  # the root not taken
# the cube not differentiated: 1 + b x^2 instead of 1 + 3 b x^2
a_matrices = [sp.Matrix([[0, 1], [-1, -a]]), sp.Matrix([[0, 1], [0, -a]])]
a_matrices = [sp.Matrix([[0, 1], [-1, -a]]), sp.Matrix([[0, 1], [-2, -a]])]  # a sign lost at the outer points
a_stable = sp.And(a > 0, b > 0)  # the hard spring demanded, which the first approximation does not see
a_stable = a >= 0  # imaginary roots counted as asymptotically stable
a_growth = (-a - sp.sqrt(a**2 + 8))/2  # the negative root of the two
a_growth = sp.sqrt(2)  # without resistance
a_kinds = {0: "stable node", 5: "saddle", -5: "saddle"}  # focus and node interchanged
a_kinds = {0: "stable focus", 5: "unstable node", -5: "unstable node"}  # every unstable point called a node
a_kinds = {0: "stable focus", 5: "saddle"}  # one of the saddles overlooked
a_slopes = [1.414, -1.414]  # symmetric, as without resistance
a_slopes = [-2, 1]  # those that come and those that leave interchanged
b_rate = -a*x2  # one factor x2 lost
b_rate = -a*x2**2 + b*x1**3*x2  # the cubic force left out of the motion
b_null = sp.And(sp.Eq(x1, 0), sp.Eq(x2, 0))  # V' taken for negative definite
b_null = sp.Eq(x1, 0)  # the wrong axis
b_leave = -x1  # the first approximation used far from zero
b_leave = sp.Integer(0)  # the velocity taken for the acceleration
b_global = b > 0  # the linear spring forgotten
b_global = sp.And(b > -sp.oo, b < sp.oo)  # V' <= 0 everywhere taken for enough: soft springs counted in
b_level = -1/(2*b)  # the term of fourth order forgotten
b_level = 1/(4*b)  # the sign of b overlooked: a negative level
b_level = sp.Integer(0)  # the level through the zeros of V on the axis
b_basin = V < -1/(4*b)  # the parts beyond the saddles taken along
b_basin = sp.Abs(x1) < 1/sp.sqrt(-b)  # the strip between the saddles taken for the estimate
b_basin = sp.And(V > 0, sp.Abs(x1) < 1/sp.sqrt(-b))  # the set where V is positive
b_basin = x1**2 + x2**2 < -1/b  # the largest disc between the saddles, which is no level set

# %% right
a_single = sp.Or(b > 0, sp.Eq(b, 0))  # in two pieces
# as sp.solve writes them, with a plain symbol
p = sp.Symbol("b")
a_rest = [0, -sp.sqrt(-1/p), sp.sqrt(-1/p)]
a_rest = [(0, 0), (1/sp.sqrt(sp.Abs(b)), 0), (-1/sp.sqrt(sp.Abs(b)), 0)]  # as points of the phase plane, by the modulus
a_matrices = [[[0, 1], [2, -a]], [[0, 1], [-1, -a]]]  # the other order, nested lists
# one for each stationary value, the last two alike
a_matrices = [field.jacobian(state).subs({x1: value, x2: 0}) for value in (0, 1/sp.sqrt(-b), -1/sp.sqrt(-b))]
a_growth = 4/(a + sp.sqrt(a**2 + 8))  # the root in the denominator
a_growth = -0.5*a + sp.sqrt(0.25*a**2 + 2.0)  # in two terms, with decimals
# pairs with points of the phase plane, capitals
a_kinds = [[(0, 0), "Stable focus"], [(5, 0), "Saddle"], [(-5, 0), "Saddle"]]
b_null = sp.Eq(x2**2, 0)  # with the square
b_leave = -a*x2 - x1 - b*x1**3  # with the resistance, which vanishes there
b_level = 0.25/sp.Abs(b)  # by the modulus, with a decimal
b_basin = [x2 < (1 + b*x1**2)/sp.sqrt(-2*b), x2 > -(1 + b*x1**2)/sp.sqrt(-2*b)]  # between the two parabolas, in a list
b_basin = sp.And(-2*b*x2**2 < (1 + b*x1**2)**2, -b*x1**2 < 1)  # without roots and fractions
