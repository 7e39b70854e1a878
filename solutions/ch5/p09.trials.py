# %% wrong
a_solvable = sp.Abs(x1 + x2) < 1  # Is this the condition for the origin as the target? (hint 2)
# Can the circle be reached from everywhere, as the problem book says? (hint 1)
a_solvable = sp.true
# On which side must the initial state lie for this motion to meet the circle? (hint 2)
a_solvable = sp.Or(
    sp.Abs(x1 + x2) < 1,
    sp.And(
        R > 1 / sp.sqrt(2),
        sp.Or(
            x2**2 - (x1 - 1) ** 2 <= R**2 - sp.Rational(1, 2),
            x2**2 - (x1 + 1) ** 2 <= R**2 - sp.Rational(1, 2),
        ),
    ),
)
# Is every point of this semicircle an end, as for the double integrator? (hint 1)
a_reached = sp.true
# Is the arc too short, or too long? Insert its ends into the final H. (hint 1)
a_reached = sp.cos(alpha) < 0
# Was the arc followed forwards in time instead of backwards? (hint 2)
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha)) / (sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = (
    1 + (R * (sp.cos(alpha) + sp.sin(alpha)) - 1) * r,
    1 + (R * (sp.cos(alpha) - sp.sin(alpha)) - 1) / r,
)
a_switching = [(w0 + v0) / 2, (w0 - v0) / 2]
# Which of the two controls belongs to the last arc? (hint 1)
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha)) / (sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = (
    -1 + (R * (sp.cos(alpha) + sp.sin(alpha)) + 1) / r,
    -1 + (R * (sp.cos(alpha) - sp.sin(alpha)) + 1) * r,
)
a_switching = [(w0 + v0) / 2, (w0 - v0) / 2]
# Is this the law for the origin as the target? (hint 1)
a_law = -sp.sign(x2 + sp.sign(x1) * sp.sqrt(x1**2 + 2 * sp.Abs(x1)))
a_barrier = 1 - x1  # Is this the boundary of the strip instead of a trajectory? (hint 1)
a_barrier = sp.sqrt(x1**2 + R**2)  # Is this the hyperbola of free motion? (hint 1)
# Is this the strip of item a, where the bounds are symmetric? (hint 1)
b_solvable = sp.Abs(x1 + x2) < 1
# Can the circle be reached from outside the strip as well? (hint 2)
b_solvable = sp.And(x1 + x2 > -1, x1 + x2 <= 0)
# Is a piece missing where the circle is large? (hint 2)
w = x1 + x2
b_solvable = sp.Or(
    sp.And(w > -1, w <= 0), sp.And(w > 0, sp.Or(x1 < 0, x2 < 0), sp.Abs(x1**2 - x2**2) <= R**2)
)
# Is this the condition of item a? (hint 1)
b_reached = sp.Or(
    sp.And(sp.sin(alpha) > 0, R * sp.cos(alpha) < sp.Rational(1, 2)),
    sp.And(sp.sin(alpha) < 0, R * sp.cos(alpha) > -sp.Rational(1, 2)),
)
# Is every point of the lower semicircle an end? (hint 1)
b_reached = sp.Or(sp.sin(alpha) < 0, sp.cos(alpha) < 0)
b_left = -x1  # Is this the asymptote of the curve? (hint 2)
b_left = sp.sqrt(x1**2 - R**2)  # Is this the arc of free motion? (hint 1)
# Was the curve on the left simply mirrored? The bounds are not symmetric. (hint 1)
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha)) / (sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = R * (sp.cos(alpha) + sp.sin(alpha)) / r, R * (sp.cos(alpha) - sp.sin(alpha)) * r
b_right = [(w0 + v0) / 2, (w0 - v0) / 2]
# Was the curve of item a taken as it is? (hint 1)
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha)) / (sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = (
    1 + (R * (sp.cos(alpha) + sp.sin(alpha)) - 1) / r,
    1 + (R * (sp.cos(alpha) - sp.sin(alpha)) - 1) * r,
)
b_right = [(w0 + v0) / 2, (w0 - v0) / 2]
# Are the two sides interchanged? (hint 1)
left = sp.sqrt(x1**2 - R**4 / x1**2)
b_law = sp.Piecewise(
    (
        1,
        sp.Or(sp.And(x1 <= -R, x2 > left), sp.And(sp.Abs(x1) < R, x2 > 0), sp.And(x1 >= R, x2 > z)),
    ),
    (0, True),
)
# Is this the time of the exit from the disc instead of the entry? (hint 2)
b_time = sp.log((R**2 + sp.sqrt(R**4 - (x1**2 - x2**2) ** 2)) / (x1 + x2) ** 2) / 2
# Was a factor of the time lost? (hint 2)
b_time = sp.log((R**2 - sp.sqrt(R**4 - (x1**2 - x2**2) ** 2)) / (x1 + x2) ** 2)

# %% right
# with the condition on R
h = sp.Rational(1, 2)
a_solvable = sp.Or(
    sp.And(x1 + x2 < 1, x1 + x2 > -1),
    sp.And(
        2 * R**2 > 1,
        sp.Or(
            sp.And(x1 + x2 >= 1, x1 < h, (x2 - x1 + 1) * (x2 + x1 - 1) < R**2 - h),
            sp.And(x1 + x2 <= -1, x1 > -h, (x2 - x1 - 1) * (x2 + x1 + 1) < R**2 - h),
        ),
    ),
)
# by the modes
w, v = x1 + x2, x1 - x2
a_solvable = sp.Or(
    w**2 < 1,
    sp.And(
        2 * R**2 > 1,
        sp.Or(
            sp.And(w >= 1, w + v < 1, (w - 1) * (1 - v) <= R**2 - 0.5),
            sp.And(w <= -1, w + v > -1, (-w - 1) * (1 + v) <= R**2 - 0.5),
        ),
    ),
)
a_reached = 2 * R * sp.cos(alpha) < 1  # the strict inequality
a_reached = sp.Or(sp.cos(alpha) < 0, R < 1 / (2 * sp.cos(alpha)))  # by cases
# by the tangent
k = sp.sqrt((1 - sp.tan(alpha)) / (1 + sp.tan(alpha)))
w0, v0 = (
    1 + (R * (sp.cos(alpha) + sp.sin(alpha)) - 1) / k,
    1 + (R * (sp.cos(alpha) - sp.sin(alpha)) - 1) * k,
)
a_switching = [w0 / 2 + v0 / 2, w0 / 2 - v0 / 2]
# hyperbolic functions of the time
s0 = sp.atanh(-sp.tan(alpha))
a_switching = sp.Matrix(
    [
        1 + (R * sp.cos(alpha) - 1) * sp.cosh(s0) - R * sp.sin(alpha) * sp.sinh(s0),
        R * sp.sin(alpha) * sp.cosh(s0) - (R * sp.cos(alpha) - 1) * sp.sinh(s0),
    ]
)
# cases
a_law = sp.Piecewise(
    (-1, sp.Or(sp.And(x1 < -R, x2 > z), sp.And(sp.Abs(x1) <= R, x2 > 0), sp.And(x1 > R, x2 > -z))),
    (1, True),
)
# the height made zero above the disc
a_law = -sp.sign(x2 + sp.sign(x1) * sp.Piecewise((z, sp.Abs(x1) > R), (0, True)))
a_barrier = sp.sqrt(2 * x1**2 - 4 * x1 + 1 + 2 * R**2) / sp.sqrt(2)  # expanded
# both borders at once
w = x1 + x2
b_solvable = sp.Or(
    sp.And(w > -1, w <= 0),
    sp.And(w > 0, sp.Or(x1 < 0, x2 < 0), sp.Abs(x1**2 - x2**2) < R**2),
    sp.And(2 * R**2 > 1, w <= -1, 2 * x1 > -1, x2**2 - (x1 + 1) ** 2 < R**2 - 0.5),
)
# by the modes
w, v = x1 + x2, x1 - x2
b_solvable = sp.Or(
    sp.And(w > -1, w <= 0),
    sp.And(w > 0, sp.Or(w + v < 0, w < v), (w * v) ** 2 <= R**4),
    sp.And(R > 1 / sp.sqrt(2), w <= -1, w + v > -1, -(w + 1) * (1 + v) <= R**2 - sp.Rational(1, 2)),
)
# by angles
b_reached = sp.Or(
    sp.And(alpha > sp.pi / 2, alpha < sp.pi), sp.And(alpha > sp.pi, 2 * R * sp.cos(alpha) > -1)
)
# with the strict inequalities
b_reached = sp.Or(
    sp.And(sp.sin(alpha) >= 0, sp.cos(alpha) < 0),
    sp.And(sp.sin(alpha) < 0, R * sp.cos(alpha) > -0.5),
)
b_left = -sp.sqrt(x1**4 - R**4) / x1  # over x1
b_left = sp.sqrt((x1**2 - R**2) * (x1**2 + R**2)) / sp.Abs(x1)  # factors
# hyperbolic functions of the time
s0 = sp.atanh(-sp.tan(alpha))
b_right = [
    -1 + (R * sp.cos(alpha) + 1) * sp.cosh(s0) - R * sp.sin(alpha) * sp.sinh(s0),
    R * sp.sin(alpha) * sp.cosh(s0) - (R * sp.cos(alpha) + 1) * sp.sinh(s0),
]
# by the tangent, a column
k = sp.sqrt((1 - sp.tan(alpha)) / (1 + sp.tan(alpha)))
w0, v0 = (
    -1 + (R * (sp.cos(alpha) + sp.sin(alpha)) + 1) / k,
    -1 + (R * (sp.cos(alpha) - sp.sin(alpha)) + 1) * k,
)
b_right = sp.Matrix([(w0 + v0) / 2, (w0 - v0) / 2])
# the lower part first
b_law = sp.Piecewise(
    (
        1,
        sp.Or(
            sp.And(x1 < -R, x2 < sp.sqrt(x1**2 - R**4 / x1**2)),
            sp.And(sp.Abs(x1) <= R, x2 < 0),
            sp.And(x1 > R, x2 < z),
        ),
    ),
    (0, True),
)
# with Heaviside's function
b_law = sp.Piecewise(
    (sp.Heaviside(sp.sqrt(x1**2 - R**4 / x1**2) - x2), x1 < -R),
    (sp.Heaviside(-x2), x1 < R),
    (sp.Heaviside(z - x2), True),
)
# the smaller root
b_time = sp.log((R**2 - sp.sqrt(R**4 - (x1**2 - x2**2) ** 2)) / (x1 + x2) ** 2) / 2
# logarithm of a root
b_time = sp.log(
    (x2 - x1) / sp.sqrt(R**2 + sp.sqrt((R**2 - x1**2 + x2**2) * (R**2 + x1**2 - x2**2)))
)
