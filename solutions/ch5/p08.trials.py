# %% wrong
# Can the control make the distance from the origin decrease? (hint 1)
reached = sp.sin(alpha) * sp.cos(alpha) < 0
# About which centre does the motion turn under this control? (hint 1)
curve = [-R * sp.cos(2 * alpha), R * sp.sin(2 * alpha)]
# Is this the switching curve of the transfer to the origin? (hint 1)
curve = [-1 - sp.cos(alpha), sp.sin(alpha)]
# Does the switching curve end after the first semicircle? (hint 2)
law = sp.Piecewise(
    (
        -sp.sign(x2 + sp.sign(x1) * sp.sqrt(1 - (sp.Abs(x1) - R - 1) ** 2)),
        sp.And(sp.Abs(x1) > R, sp.Abs(x1) < R + 2),
    ),
    (-sp.sign(x2), True),
)
# Is this the law of the transfer to the origin? (hint 1)
n = sp.floor(sp.Abs(x1) / 2)
law = -sp.sign(x2 + sp.sign(x1) * sp.sqrt(1 - (sp.Abs(x1) - 1 - 2 * n) ** 2))
# Was a term of the velocity forgotten? (hint 1)
crossing = [sp.sin(alpha) * (1 - sp.cos(alpha)), -sp.sin(alpha) * (1 + sp.cos(alpha))]
# Does the semicircle of one radius hold for all radii? (hint 1)
in_dispersal = sp.sqrt(1 - (x1 - R + 1) ** 2)
in_dispersal = 0  # Is the axis the boundary between the two controls? (hint 2)
in_law = sp.sign(x2)  # Is it best to push along the velocity at every instant? (hint 1)
in_law = -sp.sign(x2)  # Is this the law from outside? (hint 1)
# Does the law of small circles hold for large ones? (hint 2)
D = (R**2 - x1**2 - x2**2) / 2
in_law_all = sp.Piecewise((sp.sign(x2 - x1 * sp.sqrt(D / (2 - D))), D < 2), (sp.sign(x2), True))
in_law_all = sp.sign(x2)  # Is it best to push along the velocity at every instant? (hint 3)

# %% right
reached = True  # everywhere, the two points on the axis counted in
reached = -R * sp.Abs(sp.sin(alpha)) < 0  # by the rate
# not simplified
curve = sp.Matrix(
    [
        -1 - (R * sp.cos(alpha) + 1) * sp.cos(alpha) - R * sp.sin(alpha) ** 2,
        (R * sp.cos(alpha) + 1) * sp.sin(alpha) - R * sp.sin(alpha) * sp.cos(alpha),
    ]
)
# with a remainder instead of a floor
law = sp.Piecewise(
    (
        -sp.sign(x2 + sp.sign(x1) * sp.sqrt(1 - (sp.Mod(sp.Abs(x1) - R, 2) - 1) ** 2)),
        sp.Abs(x1) > R,
    ),
    (-sp.sign(x2), True),
)
# left and right apart
m = sp.floor((x1 - R) / 2)
k = sp.floor((-x1 - R) / 2)
law = sp.Piecewise(
    (sp.Piecewise((1, x2 < -sp.sqrt(1 - (x1 - R - 1 - 2 * m) ** 2)), (-1, True)), x1 >= R),
    (sp.Piecewise((-1, x2 > sp.sqrt(1 - (x1 + R + 1 + 2 * k) ** 2)), (1, True)), x1 <= -R),
    (-1, x2 > 0),
    (1, True),
)
# by the radius: r**2 as an expression in x1, decimals
p = 0.5 * ((R**2 - 4) + ((R**2 - 4) ** 2 + 16 * x1**2) ** 0.5)
in_dispersal = (p - x1**2) ** 0.5
# by the explicit dispersal curve
in_law = sp.sign(
    x2 - sp.sign(x1) * sp.sqrt((sp.sqrt((4 - R**2) ** 2 + 16 * x1**2) - (4 - R**2)) / 2 - x1**2)
)
# case by case
q = (R**2 - x1**2 - x2**2) / (4 - R**2 + x1**2 + x2**2)
in_law = sp.Piecewise((1, x2 > x1 * sp.sqrt(q)), (-1, True))
# right half only, the left by symmetry
r = sp.sqrt(x1**2 + x2**2)
b = R - 2 * sp.floor((R - r) / 2)
y = sp.sign(x1) * x2
h = sp.Piecewise(
    (sp.Abs(x1) * sp.sqrt((b**2 - r**2) / (4 - b**2 + r**2)), b <= 2),
    (sp.sqrt(1 - (sp.Abs(x1) - b + 1) ** 2), sp.Abs(x1) > b - 2),
    (0, True),
)
in_law_all = sp.sign(x1) * sp.sign(y - h)
# with a remainder instead of a floor
r = sp.sqrt(x1**2 + x2**2)
b = r + sp.Mod(R - r, 2)
g = (b**2 - r**2) / 2
in_law_all = sp.Piecewise(
    (sp.sign(x2 - x1 * sp.sqrt(g / (2 - g))), b <= 2),
    (sp.sign(x2), sp.Abs(x1) < b - 2),
    (sp.sign(x2 - sp.sign(x1) * sp.sqrt(1 - (sp.Abs(x1) - b + 1) ** 2)), True),
)
