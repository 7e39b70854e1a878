# %% wrong
# Is this the normal of a circle instead of that of the ellipse? (hint 1)
reached = sp.Or(
    sp.And(sp.sin(alpha) > 0, R * sp.cos(alpha) < 1),
    sp.And(sp.sin(alpha) < 0, R * sp.cos(alpha) > -1),
)
# Is there another arc that is not reached? (hint 1)
reached = sp.And(sp.Ne(sp.sin(alpha), 0), sp.Or(sp.sin(alpha) < 0, sp.cos(alpha) < R))
# Is this the time to the switching for a circle? (hint 1)
curve = [
    R * sp.cos(alpha) + sp.tan(alpha) * (sp.sin(alpha) - sp.tan(alpha) / 2),
    sp.sin(alpha) - sp.tan(alpha),
]
law = -sp.sign(x2)  # Does the law have no switching curve besides the axis? (hint 1)
# Is this the switching curve of the circle? (hint 1)
W = sp.sqrt(R**2 + 1 + 2 * sp.Abs(x1))
law = sp.Piecewise(
    (-sp.sign(x2 + sp.sign(x1) * W * sp.sqrt(1 - 1 / (W - R) ** 2)), sp.Abs(x1) > R),
    (-sp.sign(x2), True),
)
# Was the sign of the control changed in the second determinant? (hint 1)
crossing = [(sp.sin(alpha) - R * sp.tan(alpha)) * (2 * R / sp.cos(alpha) ** 2 - sp.cos(alpha))] * 2
continuous = R <= 1  # Does the whole range that is printed keep the time continuous? (hint 1)
barrier = (1 - x2**2) / 2  # Does the trajectory through the top of the ellipse touch it? (hint 1)
# Is this the law of the transfer to the origin? (hint 1)
law_wide = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)
law_thin = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)  # Is the segment the same as the origin? (hint 1)
law_thin = -sp.sign(x1)  # Is the segment the same as the whole line? (hint 1)

# %% right
reached = sp.sin(alpha) * sp.cos(alpha) - R * sp.Abs(sp.sin(alpha)) < 0  # the rate itself
# what is not reached, negated
reached = sp.Not(
    sp.Or(
        sp.And(sp.sin(alpha) >= 0, sp.cos(alpha) >= R),
        sp.And(sp.sin(alpha) <= 0, sp.cos(alpha) <= -R),
    )
)
# as the backward motion comes
curve = [
    R * sp.cos(alpha) + R * sp.tan(alpha) * sp.sin(alpha) - R**2 * sp.tan(alpha) ** 2 / 2,
    sp.sin(alpha) - R * sp.tan(alpha),
]
# by the cosine, decimals
c = sp.cos(alpha)
curve = sp.Matrix([R / c + 0.5 * R**2 * (1 - 1 / c**2), sp.sqrt(1 - c**2) * (1 - R / c)])
# one half, then symmetry
p = sp.sqrt(1 + R**2 - 2 * x1)
q = sp.sqrt(1 + R**2 + 2 * x1)
law = sp.Piecewise(
    (sp.sign(p * sp.sqrt(1 - R**2 / (p - 1) ** 2) - x2), x1 < -R),
    (-sp.sign(x2 + q * sp.sqrt(1 - R**2 / (q - 1) ** 2)), x1 > R),
    (-sp.sign(x2), True),
)
# with a step function
W = (1.0 + R**2 + 2 * sp.Abs(x1)) ** 0.5
y = sp.Piecewise(
    (0, x1**2 < R**2), (sp.sign(x1) * W * sp.sqrt((W - 1 - R) * (W - 1 + R)) / (W - 1), True)
)
law = 1 - 2 * sp.Heaviside(x2 + y)
# as the differentiation leaves it
P = [R / sp.cos(alpha) - R**2 * sp.tan(alpha) ** 2 / 2, sp.sin(alpha) - R * sp.tan(alpha)]
crossing = [sp.diff(P[0], alpha) * value - sp.diff(P[1], alpha) * P[1] for value in (1, -1)]
# multiplied out
y = sp.sin(alpha) - R * sp.tan(alpha)
crossing = (2 * R * y / sp.cos(alpha) ** 2 - y * sp.cos(alpha), sp.sin(alpha) * (R - sp.cos(alpha)))
continuous = sp.Interval.open(1, sp.oo)  # an interval
continuous = 1 - R**2 <= 0  # a square
law_wide = -x2 / sp.Abs(x2)  # a quotient
law_wide = sp.Piecewise((-1, x2 > 1), (1, True))  # two cases
# case by case
law_thin = sp.Piecewise(
    (1, sp.And(x1 < 0, x2 < sp.sqrt(1 - 2 * x1))),
    (-1, x1 < 0),
    (-1, x2 > -sp.sqrt(1 + 2 * x1)),
    (1, True),
)
# by squares
law_thin = sp.Piecewise((sp.sign(-x2), x2**2 > 1 + 2 * sp.Abs(x1)), (-sp.sign(x1), True))
