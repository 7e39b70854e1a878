# %% wrong
a_switchings = 0  # Can a motion from rest to rest go without braking? (hint 1)
a_switchings = 2  # Were the arcs counted instead of the switchings? (hint 1)
a_switching = x2 * sp.Abs(x2) / 2  # Do these branches lead to the origin, or away from it? (hint 2)
a_switching = -x2 * sp.Abs(x2)  # Was a factor of the parabola lost? (hint 2)
a_switching = -(x2**2) / 2  # Is it one parabola on both sides? (hint 2)
# Are the two sides of the curve interchanged? (hint 1)
a_law = sp.sign(x1 + x2 * sp.Abs(x2) / 2)
a_law = -sp.sign(x1 + x2)  # Is the switching line straight? (hint 1)
a_law = -sp.sign(x1)  # Does the velocity not matter? (hint 1)
# Does the switching parabola look the same for both signs of the velocity? (hint 1)
a_law = -sp.sign(x1 + x2**2 / 2)
a_time = x2 + 2 * sp.sqrt(x1 + x2**2 / 2)  # Does this hold on both sides of the curve? (hint 1)
# Is this the time of the last arc alone? (hint 2)
a_time = sp.Piecewise(
    (sp.sqrt(x1 + x2**2 / 2), x1 + x2 * sp.Abs(x2) / 2 >= 0), (sp.sqrt(x2**2 / 2 - x1), True)
)
a_time = 2 * sp.sqrt(sp.Abs(x1))  # Does the motion begin at rest here? (hint 2)
# Are the two controls interchanged? (hint 1)
a_control = sp.Piecewise((1, t < 1), (-1, True))
# Does braking begin too late here? (hint 1)
a_control = sp.Piecewise((-1, t < sp.sqrt(2)), (1, True))
a_control = -1  # Does the motion stop at the origin without braking? (hint 1)
a_costate = [1, 1 - t]  # Do the costates have the wrong sign? (hint 2)
a_costate = [1, t - 1]  # Which sign does psi1 have in the equation for psi2? (hint 1)
a_costate = [-1, t - 2]  # Is the zero of psi2 at the switching? (hint 1)
# Can the origin be reached from everywhere, as the problem book says? (hint 1)
b_solvable = sp.true
b_solvable = sp.And(x2 < 0, x1 > 0)  # Was the braking distance forgotten? (hint 2)
# Can the origin be reached from the boundary itself, by braking alone? (hint 2)
b_solvable = sp.And(x2 < 0, x1 > x2**2 / 2)
# Can a point at rest be pushed to the left? (hint 1)
b_solvable = sp.And(x2 <= 0, x1 >= x2**2 / 2)
b_solvable = x1 >= x2**2 / 2  # Do both signs of the velocity lead to the origin? (hint 1)
# Are the two sides of the curve interchanged? (hint 1)
b_law = sp.Piecewise((1, x1 > x2**2 / 2), (0, True))
b_law = 0  # Does drifting alone stop at the origin? (hint 1)
b_law = 1  # Is it best to brake at once? (hint 1)
# Does braking begin too early here? (hint 2)
b_law = sp.Piecewise((0, x1 > x2**2), (1, True))
b_time = -x1 / x2  # Is this the time of drifting alone? (hint 1)
b_time = -x2  # Is this the time of braking alone? (hint 1)
b_time = -x1 / x2 - x2  # Does the drift lead to the origin? (hint 1)
b_control = [[1, 1], [0, sp.Rational(3, 2)]]  # Which of the two arcs comes last? (hint 1)
# Does the drift last too long here? (hint 1)
b_control = sp.Piecewise((0, t < 1), (1, True))
# Between which bounds may the control lie in item b? (hint 1)
b_control = sp.Piecewise((-1, t < sp.Rational(1, 2)), (1, True))

# %% right
a_switching = -sp.sign(x2) * x2**2 / 2  # with the sign
a_switching = sp.Piecewise((x2**2 / 2, x2 < 0), (-(x2**2) / 2, True))  # cases
a_law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)  # the sign of the distance from the curve
# cases by regions, plain symbols
p, q = sp.symbols("x1 x2")
a_law = sp.Piecewise(
    (-1, sp.Or(p > -q * sp.Abs(q) / 2, sp.And(sp.Eq(p, -(q**2) / 2), q > 0))), (1, True)
)
a_law = -sp.sign(x2 + sp.sign(x1) * sp.sqrt(2 * sp.Abs(x1)))  # solved for x2
a_law = 1 - 2 * sp.Heaviside(x1 + x2 * sp.Abs(x2) / 2)  # with Heaviside's function
# by a sign
a_time = sp.sign(x1 + x2 * sp.Abs(x2) / 2) * x2 + 2 * sp.sqrt(
    sp.sign(x1 + x2 * sp.Abs(x2) / 2) * x1 + x2**2 / 2
)
# as one root
a_time = sp.Piecewise(
    (x2 + sp.sqrt(4 * x1 + 2 * x2**2), x1 > -x2 * sp.Abs(x2) / 2),
    (sp.sqrt(2 * x2**2 - 4 * x1) - x2, True),
)
a_control = [[-1, 1], [1, 2]]  # a list of arcs
a_control = sp.sign(t - 1)  # the sign of psi2
a_costate = sp.Matrix([-1, t - 1])  # a column
a_costate = (-1.0, 1.0 * t - 1.0)  # decimals, a tuple
b_solvable = [2 * x1 - x2**2 >= 0, x2 < 0]  # a list of conditions
b_solvable = sp.And(x1 > 0, x2 < 0, x2 >= -sp.sqrt(2 * x1))  # solved for x2
b_law = 1 - sp.Heaviside(x1 - x2**2 / 2, 0)  # with Heaviside's function
b_law = sp.Piecewise((1, x2 <= -sp.sqrt(2 * x1)), (0, True))  # solved for x2
# as it is displayed, for the possible starts alone
b_law = sp.Piecewise((0, sp.And(x1 > x2**2 / 2, x2 < 0)), (1, sp.And(sp.Eq(x1, x2**2 / 2), x2 < 0)))
b_time = (2 * x1 + x2**2) / (2 * sp.Abs(x2))  # over a common denominator, with the absolute value
b_control = sp.Piecewise((0, t < sp.Rational(1, 2)), (1, True))  # cases in time
