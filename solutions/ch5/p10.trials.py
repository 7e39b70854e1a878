# %% wrong
a_reached = True  # Is every point of the line reached from this side? (hint 1)
a_reached = v < 0  # Can the control make the motion approach the line? (hint 1)
a_curve = x2**2 / 2  # Is this the trajectory to the origin? (hint 1)
a_curve = sp.Rational(3, 2)  # Was the motion followed forwards instead of backwards? (hint 1)
a_barrier = sp.Rational(1, 2)  # Is the vertical line continued upwards? (hint 1)
a_barrier = (3 - x2**2) / 2  # Is this the trajectory with the other control? (hint 1)
a_law = -sp.sign(x1 - x2)  # Is it best to push towards the line all the time? (hint 1)
# Was the curve across which the time jumps forgotten? (hint 2)
h = sp.Rational(1, 2)
a_law = sp.Piecewise(
    (sp.Piecewise((1, x1 < h), (-1, True)), x1 > x2), (sp.Piecewise((-1, x1 > -h), (1, True)), True)
)
# Is this the first meeting with the line, or a later one? (hint 2)
a_time = 1 - x2 + sp.sqrt(1 + x2**2 - 2 * x1)
# Does the motion have to go round from all initial states? (hint 1)
a_time = 1 + x2 + sp.sqrt(sp.Abs(x2**2 + 2 * x1 - 1))
b_reached = v > 0  # Is one branch of the parabola enough? (hint 1)
b_curve = -(x2**2) / 8  # Was a factor in the normal lost? (hint 1)
b_curve = -(x2**2) / 2  # Is this the trajectory to the vertex? (hint 1)
b_dispersal = x2**2  # Is this a false root, brought in by squaring? (hint 1)
b_dispersal = 7 * x2**2  # Do both times really agree on this curve? (hint 1)
# Inside the parabola, is it best to push along the velocity? (hint 1)
b_law = sp.Piecewise(
    (sp.Piecewise((-1, sp.And(x2 > 0, x1 > -(x2**2) / 3)), (1, True)), x1 < x2**2),
    (sp.sign(x2), True),
)
# Is there no switching outside? (hint 1)
b_law = sp.Piecewise(
    (-sp.sign(x2), x1 < x2**2),
    (sp.Piecewise((1, sp.And(x2 > 0, x1 < 13 * x2**2)), (-1, True)), True),
)

# %% right
a_reached = sp.Interval(-sp.oo, 1)  # an interval
# all cases side by side, in plain symbols
a, b = sp.symbols("x1 x2")
a_law = sp.Piecewise(
    (1, sp.And(a > b, b <= 0, 2 * a < 1)),
    (1, sp.And(a > b, b > 0, b < 1, 2 * a < 1 + b**2)),
    (-1, a > b),
    (-1, sp.And(b >= 0, 2 * a > -1)),
    (-1, sp.And(b < 0, b > -1, 2 * a > -1 - b**2)),
    (1, True),
)
# by the maximum of x2 and 0, decimals
p = sp.Heaviside(0.5 * (1 + sp.Max(x2, 0) ** 2) - x1) * sp.Heaviside(1 - x2)
q = sp.Heaviside(0.5 * (1 + sp.Max(-x2, 0) ** 2) + x1) * sp.Heaviside(1 + x2)
a_law = sp.Piecewise((2 * p - 1, x1 > x2), (1 - 2 * q, True))
# by the roots of the quadratic equations
g = x1 - x2
a_time = sp.Piecewise(
    (1 - x2 - sp.sqrt((1 - x2) ** 2 - 2 * g), sp.And(x2 < 1, 2 * x1 < 1 + sp.Max(x2, 0) ** 2)),
    (1 + x2 + sp.sqrt((1 + x2) ** 2 - 2 * (1 - g)), True),
)
# the far part first
a_time = sp.Piecewise(
    (1 + x2 + (x2**2 + 2 * x1 - 1) ** 0.5, sp.Or(x2 >= 1, x1 > 0.5 + 0.5 * sp.Max(0, x2) ** 2)),
    (1 - x2 - (1 + x2**2 - 2 * x1) ** 0.5, True),
)
b_reached = True  # the vertex counted in
b_reached = -v - 2 * sp.Abs(v) < 0  # the rate
b_curve = -0.333 * x2**2  # three digits
b_dispersal = 13.0 * x2**2  # a decimal
# four regions
b_law = sp.Piecewise(
    (-1, sp.And(x2 > 0, x1 > -(x2**2) / 3, x1 < x2**2)),
    (1, x1 < x2**2),
    (1, sp.And(x2 > 0, x1 < 13 * x2**2)),
    (-1, True),
)
# inside by the times themselves
p, m = -x2 + sp.sqrt(2 * x1 - x2**2), x2 + sp.sqrt((2 * x1 + x2**2) / 3)
b_law = sp.Piecewise(
    (sp.sign(m - p), x1 > x2**2), (-1, sp.And(x2 > 0, 3 * x1 + x2**2 > 0)), (1, True)
)
