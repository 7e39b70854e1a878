# %% wrong
a_switchings = 0  # none at all
a_switchings = 2  # counted as arcs
a_switching = x2*sp.Abs(x2)/2  # the other branches, which lead away from the origin
a_switching = -x2*sp.Abs(x2)  # the factor 1/2 of the parabola lost
a_switching = -x2**2/2  # a parabola on both sides
a_law = sp.sign(x1 + x2*sp.Abs(x2)/2)  # the sides exchanged
a_law = -sp.sign(x1 + x2)  # a straight switching line
a_law = -sp.sign(x1)  # the velocity left out
a_law = -sp.sign(x1 + x2**2/2)  # a switching parabola without the sign
a_time = x2 + 2*sp.sqrt(x1 + x2**2/2)  # right of the curve only
# only the second arc
a_time = sp.Piecewise((sp.sqrt(x1 + x2**2/2), x1 + x2*sp.Abs(x2)/2 >= 0), (sp.sqrt(x2**2/2 - x1), True))
a_time = 2*sp.sqrt(sp.Abs(x1))  # from rest only
a_control = sp.Piecewise((1, t < 1), (-1, True))  # the controls exchanged
a_control = sp.Piecewise((-1, t < sp.sqrt(2)), (1, True))  # braking too late
a_control = -1  # no braking
a_costate = [1, 1 - t]  # the signs of the costates turned
a_costate = [1, t - 1]  # psi2' = +psi1
a_costate = [-1, t - 2]  # the zero not at the switching
b_solvable = sp.true  # every start, as the problem book has it
b_solvable = sp.And(x2 < 0, x1 > 0)  # the distance of braking forgotten
b_solvable = sp.And(x2 < 0, x1 > x2**2/2)  # the border left out, from which braking leads to the origin
b_solvable = sp.And(x2 <= 0, x1 >= x2**2/2)  # rest counted in, though a point at rest cannot be pushed to the left
b_solvable = x1 >= x2**2/2  # both signs of the velocity
b_law = sp.Piecewise((1, x1 > x2**2/2), (0, True))  # the sides exchanged
b_law = 0  # always drifting
b_law = 1  # braking at once
b_law = sp.Piecewise((0, x1 > x2**2), (1, True))  # braking too early
b_time = -x1/x2  # the drifting alone
b_time = -x2  # the braking alone
b_time = -x1/x2 - x2  # drifting all the way, and braking after it
b_control = [[1, 1], [0, sp.Rational(3, 2)]]  # braking first
b_control = sp.Piecewise((0, t < 1), (1, True))  # drifting too long
b_control = sp.Piecewise((-1, t < sp.Rational(1, 2)), (1, True))  # the lower bound is 0

# %% right
a_switching = -sp.sign(x2)*x2**2/2  # with the sign
a_switching = sp.Piecewise((x2**2/2, x2 < 0), (-x2**2/2, True))  # cases
a_law = -sp.sign(x1 + x2*sp.Abs(x2)/2)  # the sign of the distance from the curve
# cases by regions, plain symbols
p, q = sp.symbols("x1 x2")
a_law = sp.Piecewise((-1, sp.Or(p > -q*sp.Abs(q)/2, sp.And(sp.Eq(p, -q**2/2), q > 0))), (1, True))
a_law = -sp.sign(x2 + sp.sign(x1)*sp.sqrt(2*sp.Abs(x1)))  # solved for x2
a_law = 1 - 2*sp.Heaviside(x1 + x2*sp.Abs(x2)/2)  # with Heaviside's function
a_time = sp.sign(x1 + x2*sp.Abs(x2)/2)*x2 + 2*sp.sqrt(sp.sign(x1 + x2*sp.Abs(x2)/2)*x1 + x2**2/2)  # by a sign
# as one root
a_time = sp.Piecewise((x2 + sp.sqrt(4*x1 + 2*x2**2), x1 > -x2*sp.Abs(x2)/2), (sp.sqrt(2*x2**2 - 4*x1) - x2, True))
a_control = [[-1, 1], [1, 2]]  # a list of arcs
a_control = sp.sign(t - 1)  # the sign of psi2
a_costate = sp.Matrix([-1, t - 1])  # a column
a_costate = (-1.0, 1.0*t - 1.0)  # decimals, a tuple
b_solvable = [2*x1 - x2**2 >= 0, x2 < 0]  # a list of conditions
b_solvable = sp.And(x1 > 0, x2 < 0, x2 >= -sp.sqrt(2*x1))  # solved for x2
b_law = 1 - sp.Heaviside(x1 - x2**2/2, 0)  # with Heaviside's function
b_law = sp.Piecewise((1, x2 <= -sp.sqrt(2*x1)), (0, True))  # solved for x2
b_time = (2*x1 + x2**2)/(2*sp.Abs(x2))  # over a common denominator, with the absolute value
b_control = sp.Piecewise((0, t < sp.Rational(1, 2)), (1, True))  # cases in time
