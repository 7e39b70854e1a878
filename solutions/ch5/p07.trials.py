# %% wrong
a_interval = 2*sp.pi  # a whole period
a_interval = sp.pi/2  # a quarter
# only the semicircles next to the origin, continued by a straight line
a_switching = sp.Piecewise((-sp.sign(x1)*sp.sqrt(1 - (sp.Abs(x1) - 1)**2), sp.Abs(x1) < 2), (0, True))
a_switching = sp.sign(x1)*sp.sqrt(1 - (sp.Abs(x1) - 2*sp.floor(sp.Abs(x1)/2) - 1)**2)  # the other semicircles
a_law = -sp.sign(x1 + x2*sp.Abs(x2)/2)  # the parabola of the double integrator
a_law = -sp.sign(x2)  # against the velocity
a_solvable = x1**2 + x2**2 < 1  # as for real eigenvalues, where all starts in a bounded set
a_solvable = x1**2 + x2**2 <= 4  # the disc that one switching can deal with
a_count = 1  # once, as for real eigenvalues
a_count = sp.floor(R/2)  # the half-turns without the first switching
a_count = sp.floor(R/2) + 2  # one too many
a_time = sp.pi*R/2  # only half-turns
a_time = 2*sp.sqrt(R)  # the time of the double integrator
a_time = sp.acos(((R + 1)**2 + 3)/(4*(R + 1))) + sp.acos((5 - (R + 1)**2)/4)  # the case R < 2 for every R
a_radius = n  # half of it
a_radius = sp.pi*n  # as if the whole force could be used
b_solvable = sp.true  # every start
b_solvable = sp.Abs(x1 + x2) <= 1  # the border counted in
b_solvable = sp.Abs(x1 - x2) < 1  # the decaying mode
b_solvable = x1 + x2 < 1  # one side only
b_switching = -sp.sign(x1)*sp.sqrt(sp.Abs(x1**2 - 2*sp.Abs(x1)))  # the hyperbola about the wrong centre
b_switching = -x1  # the stable direction
b_law = sp.sign(x2 + sp.sign(x1)*sp.sqrt(x1**2 + 2*sp.Abs(x1)))  # the sides exchanged
# one side only
b_time = sp.log((3 - (1 - x1)**2 + x2**2
                 + sp.sqrt((1 - (1 - x1)**2 + x2**2)*(9 - (1 - x1)**2 + x2**2)))/(2*(1 - x1 - x2)))
b_time = -sp.log(1 - sp.Abs(x1 + x2))  # the time of the unstable mode alone
c_solvable = sp.Abs(x2) < 1  # the strip of system d
c_solvable = sp.Abs(x1 + x2) < 1  # a strip of the other mode
c_switching = -x2*sp.Abs(x2)/2  # the parabola without friction
c_switching = -x2  # the line of free motion
c_switching = x2 + sp.sign(x2)*sp.log(1 - sp.Abs(x2)/3)  # the curve of system d
c_law = -sp.sign(x1 + x2*sp.Abs(x2)/2)  # the parabola without friction
c_time = sp.Abs(x1 + x2)  # the smaller root
c_time = x1 + x2 + 2*sp.log(1 + sp.sqrt(1 - (1 + x2)*sp.exp(-x1 - x2)))  # one side only
d_solvable = sp.true  # every start
d_solvable = sp.Abs(x2) <= 1  # the border counted in
d_solvable = sp.Abs(x1 - x2) < 1  # the other mode
d_switching = -x2 + sp.sign(x2)*sp.log(1 + sp.Abs(x2))  # the curve of system c
d_switching = -x2*sp.Abs(x2)/2  # the parabola without friction
d_law = -sp.sign(x1 + x2*sp.Abs(x2)/2)  # the parabola without friction
d_time = -sp.log(1 - sp.Abs(x2))  # the time of the unstable mode alone
d_time = x1 - x2 + 2*sp.log((1 + sp.sqrt(1 - (1 - x2)*sp.exp(x2 - x1)))/(1 - x2))  # one side only

# %% right
a_switching = -sp.sign(x1)*sp.sqrt(sp.Mod(sp.Abs(x1), 2)*(2 - sp.Mod(sp.Abs(x1), 2)))  # a product under the root
# cases
q = x1 - 2*sp.floor(x1/2) - 1
a_switching = sp.Piecewise((-sp.sqrt(1 - q**2), x1 > 0), (sp.sqrt(1 - q**2), True))
# the sign of the distance from the curve
a_law = -sp.sign(x2 + sp.sign(x1)*sp.sqrt(1 - (sp.Abs(x1) - 2*sp.floor(sp.Abs(x1)/2) - 1)**2))
# by products under the root
a_law = sp.Piecewise((-1, x2 > -sp.sign(x1)*sp.sqrt(sp.Mod(sp.Abs(x1), 2)*(2 - sp.Mod(sp.Abs(x1), 2)))), (1, True))
a_count = sp.ceiling(R/2)  # the ceiling
# with the remainder of R
p, k = R - 2*sp.floor(R/2), sp.floor(R/2)
a_time = k*sp.pi + sp.acos(1 - (p*(2 - p))/(4*(R + 1)*(k + 1))) + sp.acos(1 - p*(R + 2 + 2*k)/(4*(k + 1)))
a_radius = 2.0*n  # a decimal
b_solvable = sp.And(x1 + x2 < 1, x1 + x2 > -1)  # two inequalities
b_solvable = (x1 + x2)**2 < 1  # a square
b_switching = -sp.sign(x1)*sp.sqrt((sp.Abs(x1) + 1)**2 - 1)  # the hyperbola
b_switching = sp.Piecewise((-sp.sqrt(x1*(x1 + 2)), x1 > 0), (sp.sqrt(x1*(x1 - 2)), True))  # cases
# cases, the curve itself too
q = x2 + sp.sign(x1)*sp.sqrt(x1**2 + 2*sp.Abs(x1))
b_law = sp.Piecewise((-1, q > 0), (1, q < 0), (-sp.sign(x2), True))
b_law = -sp.sign(x1 + sp.sign(x2)*(sp.sqrt(1 + x2**2) - 1))  # solved for x1
# by the greater root
m, n1 = (1 - x1)**2 - x2**2, (1 + x1)**2 - x2**2
b_time = sp.Piecewise((sp.log(3 - m + sp.sqrt(m**2 - 10*m + 9)) - sp.log(2 - 2*x1 - 2*x2),
                       x2 > -sp.sign(x1)*sp.sqrt(x1**2 + 2*sp.Abs(x1))),
                      (sp.log(3 - n1 + sp.sqrt(n1**2 - 10*n1 + 9)) - sp.log(2 + 2*x1 + 2*x2), True))
# by the sign of the side
g = sp.sign(x2 + sp.sign(x1)*sp.sqrt(x1**2 + 2*sp.Abs(x1)))
m = (1 - g*x1)**2 - x2**2
b_time = sp.log((3 - m + sp.sqrt((1 - m)*(9 - m)))/(2*(1 - g*(x1 + x2))))
c_solvable = sp.Or(x1 + x2 >= 0, x1 + x2 <= 0)  # a condition that always holds
c_switching = sp.Piecewise((-x2 - sp.log(1 - x2), x2 < 0), (-x2 + sp.log(1 + x2), True))  # cases
c_switching = -x2 - sp.sign(x2)*sp.log(1/(1 + sp.Abs(x2)))  # another logarithm
c_law = sp.Piecewise((-1, x1 + x2 > sp.sign(x2)*sp.log(1 + sp.Abs(x2))), (1, True))  # cases
c_law = 1 - 2*sp.Heaviside(x1 + x2 - sp.sign(x2)*sp.log(1 + sp.Abs(x2)))  # with Heaviside's function
# by the sign of the side
g = sp.sign(x1 + x2 - sp.sign(x2)*sp.log(1 + sp.Abs(x2)))
c_time = g*(x1 + x2) + 2*sp.log(1 + sp.sqrt(1 - (1 + g*x2)*sp.exp(-g*(x1 + x2))))
# by the root of the quadratic equation
g = sp.sign(x1 + x2 - sp.sign(x2)*sp.log(1 + sp.Abs(x2)))
z = sp.exp(g*(x1 + x2))
c_time = 2*sp.log(z + sp.sqrt(z**2 - (1 + g*x2)*z)) - g*(x1 + x2)
d_solvable = sp.And(x2 < 1, x2 > -1)  # two inequalities
d_solvable = x2**2 < 1  # a square
d_switching = sp.Piecewise((x2 - sp.log(1 + x2), x2 < 0), (x2 + sp.log(1 - x2), True))  # cases
d_switching = x2 - sp.sign(x2)*sp.log(1/(1 - sp.Abs(x2)))  # another logarithm
# cases, the curve itself too
q = x1 - x2 - sp.sign(x2)*sp.log(1 - sp.Abs(x2))
d_law = sp.Piecewise((-1, q > 0), (1, q < 0), (-sp.sign(x2), True))
# by the sign of the side
g = sp.sign(x1 - x2 - sp.sign(x2)*sp.log(1 - sp.Abs(x2)))
d_time = g*(x1 - x2) + 2*sp.log((1 + sp.sqrt(1 - (1 - g*x2)*sp.exp(-g*(x1 - x2))))/(1 - g*x2))
# by the root of the quadratic equation
g = sp.sign(x1 - x2 - sp.sign(x2)*sp.log(1 - sp.Abs(x2)))
z = sp.exp(g*(x1 - x2))
d_time = g*(x1 - x2) - 2*sp.log(z - sp.sqrt(z**2 - (1 - g*x2)*z))
