# %% wrong
reached = sp.Ne(sp.sin(alpha), 0)  # as for R = 1: the whole circle
# only the parts where the motion comes down on the circle without the control's help
reached = sp.sin(alpha)*sp.cos(alpha) < 0
# the control followed forwards instead of backwards
curve = [R*sp.cos(alpha) - R*sp.sin(alpha)*sp.tan(alpha) - sp.tan(alpha)**2/2, R*sp.sin(alpha) + sp.tan(alpha)]
curve = [R*(1/sp.cos(alpha) - sp.tan(alpha)**2/2), R*(sp.sin(alpha) - sp.tan(alpha))]  # the curve for R = 1 scaled up
law = -sp.sign(x1 + x2*sp.Abs(x2)/2)  # the law of the transfer to the origin
law = -sp.sign(x2)  # no switching curve
# one branch of the switching curve forgotten
w = sp.sqrt(R**2 + 1 - 2*x1)
law = sp.Piecewise((-sp.sign(x2 - w*sp.sqrt(1 - 1/(w - R)**2)), x1 < -R), (-sp.sign(x2), True))
crossing = [2*(R*sp.sin(alpha) - sp.tan(alpha))/sp.cos(alpha)**2, 0]  # the curve taken for a trajectory with u = -1
# the order turned
crossing = [-R*sp.cos(alpha)*(R*sp.sin(alpha) - sp.tan(alpha)),
            (R*sp.sin(alpha) - sp.tan(alpha))*(2/sp.cos(alpha)**2 - R*sp.cos(alpha))]
barrier = (R**2 - x2**2)/2  # the trajectory through the top of the circle
barrier = R - x2**2/2  # the trajectory through (R, 0)

# %% right
# by angles
a = sp.acos(1/R)
reached = sp.Or(sp.And(alpha > a, alpha < sp.pi), sp.And(alpha > sp.pi + a, alpha < 2*sp.pi))
reached = R*sp.sin(alpha)*sp.cos(alpha) - sp.Abs(sp.sin(alpha)) < 0  # by the rate itself
# as the backward motion comes
curve = sp.Matrix([R*sp.cos(alpha) + sp.tan(alpha)*(R*sp.sin(alpha) - sp.tan(alpha)/2),
                   R*sp.sin(alpha) - sp.tan(alpha)])
# by the cosine alone, in decimals
c = sp.cos(alpha)
curve = (R/c - 0.5*(1/c**2 - 1), sp.sqrt(1 - c**2)*(R - 1/c))
# case by case, in plain symbols
a, b, r = sp.symbols("x1 x2 R")
p, q = sp.sqrt(r**2 + 1 - 2*a), sp.sqrt(r**2 + 1 + 2*a)
law = sp.Piecewise((sp.Piecewise((-1, b > p*sp.sqrt(1 - 1/(p - r)**2)), (1, True)), a <= -r),
                   (sp.Piecewise((1, b < -q*sp.sqrt(1 - 1/(q - r)**2)), (-1, True)), a >= r), (-1, b > 0), (1, True))
# with a step function and decimals
p = sp.sqrt(R**2 + 1.0 + 2.0*sp.Abs(x1))
y = sp.Piecewise((sp.sign(x1)*p*sp.sqrt(1 - (p - R)**(-2)), x1**2 > R**2), (0, True))
law = 1 - 2*sp.Heaviside(x2 + y)
# as the differentiation leaves it
P = [R/sp.cos(alpha) - sp.tan(alpha)**2/2, R*sp.sin(alpha) - sp.tan(alpha)]
crossing = [sp.Matrix([[sp.diff(P[0], alpha), P[1]], [sp.diff(P[1], alpha), value]]).det() for value in (1, -1)]
# in factors
y = sp.sin(alpha)*(R*sp.cos(alpha) - 1)/sp.cos(alpha)
crossing = [y*(2 - R*sp.cos(alpha)**3)/sp.cos(alpha)**2, -y*R*sp.cos(alpha)]
