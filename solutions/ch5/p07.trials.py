# %% wrong
a_interval = 2 * sp.pi  # Is this a whole period instead of the time between two zeros? (hint 1)
a_interval = sp.pi / 2  # After how long does a sine change its sign again? (hint 1)
# Does the curve end in a straight line? (hint 2)
a_switching = sp.Piecewise(
    (-sp.sign(x1) * sp.sqrt(1 - (sp.Abs(x1) - 1) ** 2), sp.Abs(x1) < 2), (0, True)
)
# On which side of the axis does each semicircle lie? (hint 1)
a_switching = sp.sign(x1) * sp.sqrt(1 - (sp.Abs(x1) - 2 * sp.floor(sp.Abs(x1) / 2) - 1) ** 2)
# Is this the parabola of the double integrator? (hint 1)
a_law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)
a_law = -sp.sign(x2)  # Is it best to push against the velocity always? (hint 1)
a_solvable = x1**2 + x2**2 < 1  # Is this what one expects of real eigenvalues? (hint 1)
a_solvable = x1**2 + x2**2 <= 4  # Can there be more than one switching? (hint 1)
a_count = 1  # Is this what one expects of real eigenvalues? (hint 1)
a_count = sp.floor(R / 2)  # Was the first switching counted? (hint 2)
a_count = sp.floor(R / 2) + 2  # Is one too many counted here? (hint 2)
a_time = sp.pi * R / 2  # Does the motion consist of whole half-turns? (hint 1)
a_time = 2 * sp.sqrt(R)  # Is this the time of the double integrator? (hint 1)
# Does this hold for large distances as well? (hint 2)
a_time = sp.acos(((R + 1) ** 2 + 3) / (4 * (R + 1))) + sp.acos((5 - (R + 1) ** 2) / 4)
a_radius = n  # Is this only half of it? Integrate over a whole half-turn. (hint 1)
a_radius = sp.pi * n  # Can the whole force be used all the time? (hint 1)
b_solvable = sp.true  # Can a growing mode be stopped from everywhere? (hint 1)
b_solvable = sp.Abs(x1 + x2) <= 1  # Can the state be moved inwards from the boundary? (hint 1)
b_solvable = sp.Abs(x1 - x2) < 1  # Is this the mode that decays by itself? (hint 1)
b_solvable = x1 + x2 < 1  # Does the other side have no boundary? (hint 1)
# About which centre do the hyperbolas of the last arc run? (hint 1)
b_switching = -sp.sign(x1) * sp.sqrt(sp.Abs(x1**2 - 2 * sp.Abs(x1)))
b_switching = -x1  # Is this the direction along which free motions decay? (hint 1)
# Are the two sides of the curve interchanged? (hint 1)
b_law = sp.sign(x2 + sp.sign(x1) * sp.sqrt(x1**2 + 2 * sp.Abs(x1)))
# Does this hold on both sides of the curve? (hint 1)
b_time = sp.log(
    (3 - (1 - x1) ** 2 + x2**2 + sp.sqrt((1 - (1 - x1) ** 2 + x2**2) * (9 - (1 - x1) ** 2 + x2**2)))
    / (2 * (1 - x1 - x2))
)
b_time = -sp.log(1 - sp.Abs(x1 + x2))  # Is this the time of the unstable mode alone? (hint 1)
c_solvable = sp.Abs(x2) < 1  # Is this the strip of another system? (hint 1)
c_solvable = sp.Abs(x1 + x2) < 1  # Does any mode of this system grow? (hint 1)
c_switching = -x2 * sp.Abs(x2) / 2  # Was the friction forgotten? (hint 1)
c_switching = -x2  # Is this the line of free motion? (hint 1)
# Is this the curve of system d? (hint 1)
c_switching = x2 + sp.sign(x2) * sp.log(1 - sp.Abs(x2) / 3)
c_law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)  # Was the friction forgotten? (hint 1)
c_time = sp.Abs(x1 + x2)  # Can the time be as short as this change alone requires? (hint 1)
# Does this hold on both sides of the curve? (hint 1)
c_time = x1 + x2 + 2 * sp.log(1 + sp.sqrt(1 - (1 + x2) * sp.exp(-x1 - x2)))
d_solvable = sp.true  # Can a growing mode be stopped from everywhere? (hint 1)
d_solvable = sp.Abs(x2) <= 1  # Can the state be moved inwards from the boundary? (hint 1)
d_solvable = sp.Abs(x1 - x2) < 1  # Is this the other mode, which does not grow? (hint 1)
# Is this the curve of system c? (hint 1)
d_switching = -x2 + sp.sign(x2) * sp.log(1 + sp.Abs(x2))
# Was the term with the velocity forgotten in its own equation? (hint 1)
d_switching = -x2 * sp.Abs(x2) / 2
# Was the term with the velocity forgotten in its own equation? (hint 1)
d_law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)
d_time = -sp.log(1 - sp.Abs(x2))  # Is this the time of the unstable mode alone? (hint 1)
# Does this hold on both sides of the curve? (hint 1)
d_time = x1 - x2 + 2 * sp.log((1 + sp.sqrt(1 - (1 - x2) * sp.exp(x2 - x1))) / (1 - x2))

# %% right
# a product under the root
a_switching = -sp.sign(x1) * sp.sqrt(sp.Mod(sp.Abs(x1), 2) * (2 - sp.Mod(sp.Abs(x1), 2)))
# cases
q = x1 - 2 * sp.floor(x1 / 2) - 1
a_switching = sp.Piecewise((-sp.sqrt(1 - q**2), x1 > 0), (sp.sqrt(1 - q**2), True))
# the sign of the distance from the curve
a_law = -sp.sign(
    x2 + sp.sign(x1) * sp.sqrt(1 - (sp.Abs(x1) - 2 * sp.floor(sp.Abs(x1) / 2) - 1) ** 2)
)
# by products under the root
a_law = sp.Piecewise(
    (-1, x2 > -sp.sign(x1) * sp.sqrt(sp.Mod(sp.Abs(x1), 2) * (2 - sp.Mod(sp.Abs(x1), 2)))),
    (1, True),
)
a_count = sp.ceiling(R / 2)  # the ceiling
# with the remainder of R
p, k = R - 2 * sp.floor(R / 2), sp.floor(R / 2)
a_time = (
    k * sp.pi
    + sp.acos(1 - (p * (2 - p)) / (4 * (R + 1) * (k + 1)))
    + sp.acos(1 - p * (R + 2 + 2 * k) / (4 * (k + 1)))
)
a_radius = 2.0 * n  # a decimal
b_solvable = sp.And(x1 + x2 < 1, x1 + x2 > -1)  # two inequalities
b_solvable = (x1 + x2) ** 2 < 1  # a square
b_switching = -sp.sign(x1) * sp.sqrt((sp.Abs(x1) + 1) ** 2 - 1)  # the hyperbola
# cases
b_switching = sp.Piecewise((-sp.sqrt(x1 * (x1 + 2)), x1 > 0), (sp.sqrt(x1 * (x1 - 2)), True))
# cases, the curve itself too
q = x2 + sp.sign(x1) * sp.sqrt(x1**2 + 2 * sp.Abs(x1))
b_law = sp.Piecewise((-1, q > 0), (1, q < 0), (-sp.sign(x2), True))
b_law = -sp.sign(x1 + sp.sign(x2) * (sp.sqrt(1 + x2**2) - 1))  # solved for x1
# by the greater root
m, n1 = (1 - x1) ** 2 - x2**2, (1 + x1) ** 2 - x2**2
b_time = sp.Piecewise(
    (
        sp.log(3 - m + sp.sqrt(m**2 - 10 * m + 9)) - sp.log(2 - 2 * x1 - 2 * x2),
        x2 > -sp.sign(x1) * sp.sqrt(x1**2 + 2 * sp.Abs(x1)),
    ),
    (sp.log(3 - n1 + sp.sqrt(n1**2 - 10 * n1 + 9)) - sp.log(2 + 2 * x1 + 2 * x2), True),
)
# by the sign of the side
g = sp.sign(x2 + sp.sign(x1) * sp.sqrt(x1**2 + 2 * sp.Abs(x1)))
m = (1 - g * x1) ** 2 - x2**2
b_time = sp.log((3 - m + sp.sqrt((1 - m) * (9 - m))) / (2 * (1 - g * (x1 + x2))))
c_solvable = sp.Or(x1 + x2 >= 0, x1 + x2 <= 0)  # a condition that always holds
# cases
c_switching = sp.Piecewise((-x2 - sp.log(1 - x2), x2 < 0), (-x2 + sp.log(1 + x2), True))
c_switching = -x2 - sp.sign(x2) * sp.log(1 / (1 + sp.Abs(x2)))  # another logarithm
c_law = sp.Piecewise((-1, x1 + x2 > sp.sign(x2) * sp.log(1 + sp.Abs(x2))), (1, True))  # cases
# with Heaviside's function
c_law = 1 - 2 * sp.Heaviside(x1 + x2 - sp.sign(x2) * sp.log(1 + sp.Abs(x2)))
# by the sign of the side
g = sp.sign(x1 + x2 - sp.sign(x2) * sp.log(1 + sp.Abs(x2)))
c_time = g * (x1 + x2) + 2 * sp.log(1 + sp.sqrt(1 - (1 + g * x2) * sp.exp(-g * (x1 + x2))))
# by the root of the quadratic equation
g = sp.sign(x1 + x2 - sp.sign(x2) * sp.log(1 + sp.Abs(x2)))
z = sp.exp(g * (x1 + x2))
c_time = 2 * sp.log(z + sp.sqrt(z**2 - (1 + g * x2) * z)) - g * (x1 + x2)
d_solvable = sp.And(x2 < 1, x2 > -1)  # two inequalities
d_solvable = x2**2 < 1  # a square
d_switching = sp.Piecewise((x2 - sp.log(1 + x2), x2 < 0), (x2 + sp.log(1 - x2), True))  # cases
d_switching = x2 - sp.sign(x2) * sp.log(1 / (1 - sp.Abs(x2)))  # another logarithm
# cases, the curve itself too
q = x1 - x2 - sp.sign(x2) * sp.log(1 - sp.Abs(x2))
d_law = sp.Piecewise((-1, q > 0), (1, q < 0), (-sp.sign(x2), True))
# by the sign of the side
g = sp.sign(x1 - x2 - sp.sign(x2) * sp.log(1 - sp.Abs(x2)))
d_time = g * (x1 - x2) + 2 * sp.log(
    (1 + sp.sqrt(1 - (1 - g * x2) * sp.exp(-g * (x1 - x2)))) / (1 - g * x2)
)
# by the root of the quadratic equation
g = sp.sign(x1 - x2 - sp.sign(x2) * sp.log(1 - sp.Abs(x2)))
z = sp.exp(g * (x1 - x2))
d_time = g * (x1 - x2) - 2 * sp.log(z - sp.sqrt(z**2 - (1 - g * x2) * z))
