# %% wrong
# Is the whole circle reached from outside, as for a smaller radius? (hint 2)
reached = sp.Ne(sp.sin(alpha), 0)
# Can the control make the distance from the centre decrease? (hint 1)
reached = sp.sin(alpha) * sp.cos(alpha) < 0
# Was the control followed forwards in time instead of backwards? (hint 2)
curve = [
    R * sp.cos(alpha) - R * sp.sin(alpha) * sp.tan(alpha) - sp.tan(alpha) ** 2 / 2,
    R * sp.sin(alpha) + sp.tan(alpha),
]
# Does the curve for $R = 1$ simply scale with the circle? (hint 1)
curve = [R * (1 / sp.cos(alpha) - sp.tan(alpha) ** 2 / 2), R * (sp.sin(alpha) - sp.tan(alpha))]
law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)  # Is this the law of the transfer to the origin? (hint 1)
law = -sp.sign(x2)  # Does the law have no switching curve besides the axis? (hint 1)
# Was one branch of the switching curve forgotten? (hint 2)
w = sp.sqrt(R**2 + 1 - 2 * x1)
law = sp.Piecewise(
    (-sp.sign(x2 - w * sp.sqrt(1 - 1 / (w - R) ** 2)), x1 < -R), (-sp.sign(x2), True)
)
# Is the switching curve itself a trajectory? (hint 1)
crossing = [2 * (R * sp.sin(alpha) - sp.tan(alpha)) / sp.cos(alpha) ** 2, 0]
# What is the order of the columns of the determinant? (hint 1)
crossing = [
    -R * sp.cos(alpha) * (R * sp.sin(alpha) - sp.tan(alpha)),
    (R * sp.sin(alpha) - sp.tan(alpha)) * (2 / sp.cos(alpha) ** 2 - R * sp.cos(alpha)),
]
# Does the trajectory through the top of the circle touch it? (hint 1)
barrier = (R**2 - x2**2) / 2
barrier = R - x2**2 / 2  # Does the trajectory through this point touch the circle first? (hint 1)

# %% right
# by angles
a = sp.acos(1 / R)
reached = sp.Or(sp.And(alpha > a, alpha < sp.pi), sp.And(alpha > sp.pi + a, alpha < 2 * sp.pi))
reached = R * sp.sin(alpha) * sp.cos(alpha) - sp.Abs(sp.sin(alpha)) < 0  # by the rate itself
# as the backward motion comes
curve = sp.Matrix(
    [
        R * sp.cos(alpha) + sp.tan(alpha) * (R * sp.sin(alpha) - sp.tan(alpha) / 2),
        R * sp.sin(alpha) - sp.tan(alpha),
    ]
)
# by the cosine alone, in decimals
c = sp.cos(alpha)
curve = (R / c - 0.5 * (1 / c**2 - 1), sp.sqrt(1 - c**2) * (R - 1 / c))
# case by case, in plain symbols
a, b, r = sp.symbols("x1 x2 R")
p, q = sp.sqrt(r**2 + 1 - 2 * a), sp.sqrt(r**2 + 1 + 2 * a)
law = sp.Piecewise(
    (sp.Piecewise((-1, b > p * sp.sqrt(1 - 1 / (p - r) ** 2)), (1, True)), a <= -r),
    (sp.Piecewise((1, b < -q * sp.sqrt(1 - 1 / (q - r) ** 2)), (-1, True)), a >= r),
    (-1, b > 0),
    (1, True),
)
# with a step function and decimals
p = sp.sqrt(R**2 + 1.0 + 2.0 * sp.Abs(x1))
y = sp.Piecewise((sp.sign(x1) * p * sp.sqrt(1 - (p - R) ** (-2)), x1**2 > R**2), (0, True))
law = 1 - 2 * sp.Heaviside(x2 + y)
# as the differentiation leaves it
P = [R / sp.cos(alpha) - sp.tan(alpha) ** 2 / 2, R * sp.sin(alpha) - sp.tan(alpha)]
crossing = [
    sp.Matrix([[sp.diff(P[0], alpha), P[1]], [sp.diff(P[1], alpha), value]]).det()
    for value in (1, -1)
]
# in factors
y = sp.sin(alpha) * (R * sp.cos(alpha) - 1) / sp.cos(alpha)
crossing = [y * (2 - R * sp.cos(alpha) ** 3) / sp.cos(alpha) ** 2, -y * R * sp.cos(alpha)]
