# %% wrong
a_single = b > 0  # What is left of the equation for a linear spring? (hint 2)
a_single = b < 0  # Were the hard and the soft spring swapped? (hint 2)
# Which solution is lost in a division by x? (hint 1)
a_rest = [1 / sp.sqrt(-b), -1 / sp.sqrt(-b)]
# What is the sign of b here, and what does this mean for the root? (hint 1)
a_rest = [0, 1 / sp.sqrt(b), -1 / sp.sqrt(b)]
a_rest = [0, -1 / b, 1 / b]  # Was the root taken at the end? (hint 1)
# Was the cube differentiated, or only divided by x? (hint 1)
a_matrices = [sp.Matrix([[0, 1], [-1, -a]]), sp.Matrix([[0, 1], [0, -a]])]
# Was a sign lost when the outer stationary values were substituted? (hint 2)
a_matrices = [sp.Matrix([[0, 1], [-1, -a]]), sp.Matrix([[0, 1], [-2, -a]])]
# Does the cubic term enter the linearisation at zero? (hint 1)
a_stable = sp.And(a > 0, b > 0)
# Do imaginary roots make the linearisation asymptotically stable? (hint 1)
a_stable = a >= 0
a_growth = (-a - sp.sqrt(a**2 + 8)) / 2  # Which of the two roots makes a deviation grow? (hint 1)
a_growth = sp.sqrt(2)  # Is this the result without resistance? (hint 1)
# Are the roots at zero real or complex for these numbers? (hint 1)
a_kinds = {0: "stable node", 5: "saddle", -5: "saddle"}
# Is every unstable point a node? Look at the signs of its roots. (hint 2)
a_kinds = {0: "stable focus", 5: "unstable node", -5: "unstable node"}
# How many stationary points does the portrait have? The equation is odd in x.
a_kinds = {0: "stable focus", 5: "saddle"}
a_slopes = [1.414, -1.414]  # Are these the slopes without resistance? (hint 1)
a_slopes = [-2, 1]  # Which eigenvalue belongs to motions that leave the saddle? (hint 1)
b_rate = -a * x2  # Was a factor lost in the derivative of the kinetic part? (hint 1)
# Was the cubic force left out when $\dot x_2$ was substituted? (hint 1)
b_rate = -a * x2**2 + b * x1**3 * x2
# Is the derivative of V negative definite? Find a state other than zero where it vanishes. (hint 1)
b_null = sp.And(sp.Eq(x1, 0), sp.Eq(x2, 0))
# Does the derivative of V vanish on this axis, or on the other one? (hint 1)
b_null = sp.Eq(x1, 0)
b_leave = -x1  # May the linearisation be used far from zero? (hint 1)
# Is this the velocity of the motion there, and not its acceleration? (hint 1)
b_leave = sp.Integer(0)
b_global = b > 0  # What follows from V for a linear spring? (hint 2)
# Is a derivative of V that is nowhere positive enough in the large? (hint 1)
b_global = sp.And(b > -sp.oo, b < sp.oo)
b_level = -1 / (2 * b)  # Was the term of fourth order left out of V? (hint 2)
b_level = 1 / (4 * b)  # What is the sign of b here? Can the level be negative? (hint 2)
# Is this the level of $V = 0$, and does it bound a piece around the origin? (hint 1)
b_level = sp.Integer(0)
b_basin = V < -1 / (4 * b)  # Does this inequality also hold far away from zero? (hint 1)
# Do all motions in this strip stay in it? The set has to be bounded by a level of V. (hint 1)
b_basin = sp.Abs(x1) < 1 / sp.sqrt(-b)
# Is it enough that V is positive? An upper bound on V is needed too. (hint 1)
b_basin = sp.And(V > 0, sp.Abs(x1) < 1 / sp.sqrt(-b))
b_basin = x1**2 + x2**2 < -1 / b  # Is this disc bounded by a level line of V? (hint 1)

# %% right
a_single = sp.Or(b > 0, sp.Eq(b, 0))  # in two pieces
# as sp.solve writes them, with a plain symbol
p = sp.Symbol("b")
a_rest = [0, -sp.sqrt(-1 / p), sp.sqrt(-1 / p)]
# as points of the phase plane, by the modulus
a_rest = [(0, 0), (1 / sp.sqrt(sp.Abs(b)), 0), (-1 / sp.sqrt(sp.Abs(b)), 0)]
a_matrices = [[[0, 1], [2, -a]], [[0, 1], [-1, -a]]]  # the other order, nested lists
# one for each stationary value, the last two alike
a_matrices = [
    field.jacobian(state).subs({x1: value, x2: 0})
    for value in (0, 1 / sp.sqrt(-b), -1 / sp.sqrt(-b))
]
a_growth = 4 / (a + sp.sqrt(a**2 + 8))  # the root in the denominator
a_growth = -0.5 * a + sp.sqrt(0.25 * a**2 + 2.0)  # in two terms, with decimals
# pairs with points of the phase plane, capitals
a_kinds = [[(0, 0), "Stable focus"], [(5, 0), "Saddle"], [(-5, 0), "Saddle"]]
b_null = sp.Eq(x2**2, 0)  # with the square
b_leave = -a * x2 - x1 - b * x1**3  # with the resistance, which vanishes there
b_level = 0.25 / sp.Abs(b)  # by the modulus, with a decimal
# between the two parabolas, in a list
b_basin = [x2 < (1 + b * x1**2) / sp.sqrt(-2 * b), x2 > -(1 + b * x1**2) / sp.sqrt(-2 * b)]
# without roots and fractions
b_basin = sp.And(-2 * b * x2**2 < (1 + b * x1**2) ** 2, -b * x1**2 < 1)
