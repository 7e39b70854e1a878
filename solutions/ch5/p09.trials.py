# %% wrong
a_solvable = sp.Abs(x1 + x2) < 1  # as for the origin, for every R
a_solvable = sp.true  # every start, as printed
# without the condition on the side
a_solvable = sp.Or(sp.Abs(x1 + x2) < 1, sp.And(R > 1/sp.sqrt(2),
                                               sp.Or(x2**2 - (x1 - 1)**2 <= R**2 - sp.Rational(1, 2),
                                                     x2**2 - (x1 + 1)**2 <= R**2 - sp.Rational(1, 2))))
a_reached = sp.true  # as for the double integrator, the whole semicircle
a_reached = sp.cos(alpha) < 0  # the half of it
# the sign of the time: the arc followed forwards
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha))/(sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = 1 + (R*(sp.cos(alpha) + sp.sin(alpha)) - 1)*r, 1 + (R*(sp.cos(alpha) - sp.sin(alpha)) - 1)/r
a_switching = [(w0 + v0)/2, (w0 - v0)/2]
# with the other control
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha))/(sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = -1 + (R*(sp.cos(alpha) + sp.sin(alpha)) + 1)/r, -1 + (R*(sp.cos(alpha) - sp.sin(alpha)) + 1)*r
a_switching = [(w0 + v0)/2, (w0 - v0)/2]
a_law = -sp.sign(x2 + sp.sign(x1)*sp.sqrt(x1**2 + 2*sp.Abs(x1)))  # the law for the origin
a_barrier = 1 - x1  # the border of the strip
a_barrier = sp.sqrt(x1**2 + R**2)  # the hyperbola of free motion
b_solvable = sp.Abs(x1 + x2) < 1  # the strip of item a
b_solvable = sp.And(x1 + x2 > -1, x1 + x2 <= 0)  # the strip alone
# without the piece for large R
w = x1 + x2
b_solvable = sp.Or(sp.And(w > -1, w <= 0), sp.And(w > 0, sp.Or(x1 < 0, x2 < 0), sp.Abs(x1**2 - x2**2) <= R**2))
# as in item a
b_reached = sp.Or(sp.And(sp.sin(alpha) > 0, R*sp.cos(alpha) < sp.Rational(1, 2)),
                  sp.And(sp.sin(alpha) < 0, R*sp.cos(alpha) > -sp.Rational(1, 2)))
b_reached = sp.Or(sp.sin(alpha) < 0, sp.cos(alpha) < 0)  # the lower semicircle always
b_left = -x1  # the asymptote
b_left = sp.sqrt(x1**2 - R**2)  # the arc of free motion
# the left curve mirrored
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha))/(sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = R*(sp.cos(alpha) + sp.sin(alpha))/r, R*(sp.cos(alpha) - sp.sin(alpha))*r
b_right = [(w0 + v0)/2, (w0 - v0)/2]
# the curve of item a, not mirrored
r = sp.sqrt((sp.cos(alpha) - sp.sin(alpha))/(sp.cos(alpha) + sp.sin(alpha)))
w0, v0 = 1 + (R*(sp.cos(alpha) + sp.sin(alpha)) - 1)/r, 1 + (R*(sp.cos(alpha) - sp.sin(alpha)) - 1)*r
b_right = [(w0 + v0)/2, (w0 - v0)/2]
# the sides exchanged
left = sp.sqrt(x1**2 - R**4/x1**2)
b_law = sp.Piecewise((1, sp.Or(sp.And(x1 <= -R, x2 > left), sp.And(sp.Abs(x1) < R, x2 > 0), sp.And(x1 >= R, x2 > z))),
                     (0, True))
b_time = sp.log((R**2 + sp.sqrt(R**4 - (x1**2 - x2**2)**2))/(x1 + x2)**2)/2  # the exit from the disc
b_time = sp.log((R**2 - sp.sqrt(R**4 - (x1**2 - x2**2)**2))/(x1 + x2)**2)  # a factor lost

# %% right
# with the condition on R
h = sp.Rational(1, 2)
a_solvable = sp.Or(sp.And(x1 + x2 < 1, x1 + x2 > -1),
                   sp.And(2*R**2 > 1, sp.Or(sp.And(x1 + x2 >= 1, x1 < h, (x2 - x1 + 1)*(x2 + x1 - 1) < R**2 - h),
                                            sp.And(x1 + x2 <= -1, x1 > -h, (x2 - x1 - 1)*(x2 + x1 + 1) < R**2 - h))))
# by the modes
w, v = x1 + x2, x1 - x2
a_solvable = sp.Or(w**2 < 1, sp.And(2*R**2 > 1,
                                    sp.Or(sp.And(w >= 1, w + v < 1, (w - 1)*(1 - v) <= R**2 - 0.5),
                                          sp.And(w <= -1, w + v > -1, (-w - 1)*(1 + v) <= R**2 - 0.5))))
a_reached = 2*R*sp.cos(alpha) < 1  # the strict inequality
a_reached = sp.Or(sp.cos(alpha) < 0, R < 1/(2*sp.cos(alpha)))  # by cases
# by the tangent
k = sp.sqrt((1 - sp.tan(alpha))/(1 + sp.tan(alpha)))
w0, v0 = 1 + (R*(sp.cos(alpha) + sp.sin(alpha)) - 1)/k, 1 + (R*(sp.cos(alpha) - sp.sin(alpha)) - 1)*k
a_switching = [w0/2 + v0/2, w0/2 - v0/2]
# hyperbolic functions of the time
s0 = sp.atanh(-sp.tan(alpha))
a_switching = sp.Matrix([1 + (R*sp.cos(alpha) - 1)*sp.cosh(s0) - R*sp.sin(alpha)*sp.sinh(s0),
                         R*sp.sin(alpha)*sp.cosh(s0) - (R*sp.cos(alpha) - 1)*sp.sinh(s0)])
# cases
a_law = sp.Piecewise((-1, sp.Or(sp.And(x1 < -R, x2 > z), sp.And(sp.Abs(x1) <= R, x2 > 0), sp.And(x1 > R, x2 > -z))),
                     (1, True))
a_law = -sp.sign(x2 + sp.sign(x1)*sp.Piecewise((z, sp.Abs(x1) > R), (0, True)))  # the height made zero above the disc
a_barrier = sp.sqrt(2*x1**2 - 4*x1 + 1 + 2*R**2)/sp.sqrt(2)  # expanded
# both borders at once
w = x1 + x2
b_solvable = sp.Or(sp.And(w > -1, w <= 0), sp.And(w > 0, sp.Or(x1 < 0, x2 < 0), sp.Abs(x1**2 - x2**2) < R**2),
                   sp.And(2*R**2 > 1, w <= -1, 2*x1 > -1, x2**2 - (x1 + 1)**2 < R**2 - 0.5))
# by the modes
w, v = x1 + x2, x1 - x2
b_solvable = sp.Or(sp.And(w > -1, w <= 0), sp.And(w > 0, sp.Or(w + v < 0, w < v), (w*v)**2 <= R**4),
                   sp.And(R > 1/sp.sqrt(2), w <= -1, w + v > -1, -(w + 1)*(1 + v) <= R**2 - sp.Rational(1, 2)))
b_reached = sp.Or(sp.And(alpha > sp.pi/2, alpha < sp.pi), sp.And(alpha > sp.pi, 2*R*sp.cos(alpha) > -1))  # by angles
# with the strict inequalities
b_reached = sp.Or(sp.And(sp.sin(alpha) >= 0, sp.cos(alpha) < 0), sp.And(sp.sin(alpha) < 0, R*sp.cos(alpha) > -0.5))
b_left = -sp.sqrt(x1**4 - R**4)/x1  # over x1
b_left = sp.sqrt((x1**2 - R**2)*(x1**2 + R**2))/sp.Abs(x1)  # factors
# hyperbolic functions of the time
s0 = sp.atanh(-sp.tan(alpha))
b_right = [-1 + (R*sp.cos(alpha) + 1)*sp.cosh(s0) - R*sp.sin(alpha)*sp.sinh(s0),
           R*sp.sin(alpha)*sp.cosh(s0) - (R*sp.cos(alpha) + 1)*sp.sinh(s0)]
# by the tangent, a column
k = sp.sqrt((1 - sp.tan(alpha))/(1 + sp.tan(alpha)))
w0, v0 = -1 + (R*(sp.cos(alpha) + sp.sin(alpha)) + 1)/k, -1 + (R*(sp.cos(alpha) - sp.sin(alpha)) + 1)*k
b_right = sp.Matrix([(w0 + v0)/2, (w0 - v0)/2])
# the lower part first
b_law = sp.Piecewise((1, sp.Or(sp.And(x1 < -R, x2 < sp.sqrt(x1**2 - R**4/x1**2)), sp.And(sp.Abs(x1) <= R, x2 < 0),
                               sp.And(x1 > R, x2 < z))), (0, True))
# with Heaviside's function
b_law = sp.Piecewise((sp.Heaviside(sp.sqrt(x1**2 - R**4/x1**2) - x2), x1 < -R), (sp.Heaviside(-x2), x1 < R),
                     (sp.Heaviside(z - x2), True))
b_time = sp.log((R**2 - sp.sqrt(R**4 - (x1**2 - x2**2)**2))/(x1 + x2)**2)/2  # the smaller root
b_time = sp.log((x2 - x1)/sp.sqrt(R**2 + sp.sqrt((R**2 - x1**2 + x2**2)*(R**2 + x1**2 - x2**2))))  # logarithm of a root
