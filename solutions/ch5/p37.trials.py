# %% wrong
# Does a climb make the point faster? (hint 1)
a_pontryagin = psi1 * v * sp.cos(theta) + psi2 * v * sp.sin(theta) + psi3 * g * sp.sin(theta)
# Is the cost an integral here, or a terminal cost? (hint 1)
a_pontryagin = psi1 * v * sp.cos(theta) + (psi2 * v - psi3 * g) * sp.sin(theta) + x
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [0, 0, psi1 * sp.cos(theta) + psi2 * sp.sin(theta)]
# Was $H$ differentiated with respect to the control as well? (hint 1)
a_adjoint = [0, 0, -psi1 * sp.cos(theta) - psi2 * sp.sin(theta) + g * sp.cos(theta) * psi3]
# Which sign does a range that is to be maximised have in a cost? (hint 1)
a_transversality = [psi1 + 1, psi2, psi3]
a_transversality = [psi1 - 1, psi2]  # Is the speed prescribed at the end? (hint 1)
# Which sign does the weight have in the third equation? (hint 1)
a_direction = sp.atan2(psi2 * v + psi3 * g, psi1 * v)
# For which signs does this angle minimise $H$? (hint 2)
a_direction = sp.atan((psi2 * v - psi3 * g) / (psi1 * v))
# Does the dive become flatter or steeper? Follow the signs of the two rates. (hint 2)
a_equation = -g * sp.cos(theta) / v
# Is this what comes out if the bracket at the rate of the angle is taken for $v$? (hint 2)
a_equation = g / v
# Which sign does each of the two terms with the weight have? (hint 2)
a_equation = g * sp.cos(theta) * sp.cos(2 * theta) / v
a_portrait = v * sp.cos(theta)  # Which sign does the logarithm of the cosine have? (hint 1)
a_portrait = v**2 / 2  # Is the height constant? (hint 1)
a_portrait = v + g * theta  # Were the variables separated before the integration? (hint 1)
b_angle = -g * t / (2 * v0)  # Is the flight level at the initial or at the final time? (hint 2)
b_angle = sp.Integer(0)  # Can height be turned into range? (hint 1)
b_angle = -sp.pi / 4  # Is the best straight slope the best path? (hint 1)
b_motion = [v0 * t, 0, v0]  # Is it worthwhile to stay at the initial height? (hint 1)
# Is the cosine of the angle missing in one of the integrals? (hint 1)
q = g * t / (2 * v0) - sp.pi / 3
b_motion = [
    4 * v0**2 / g * (sp.sin(q) + sp.sqrt(3) / 2),
    2 * v0**2 / g * (sp.cos(q) ** 2 - sp.Rational(1, 4)),
    2 * v0 * sp.cos(q),
]
b_costate = sp.Integer(0)  # Is a little more speed during the flight worth nothing? (hint 1)
# Is more speed worth less? Look at the sign. (hint 1)
b_costate = 2 * v0 / g * sp.sin(g * t / (2 * v0) - sp.pi / 3)
b_costate = 2 * sp.pi * v0 / (3 * g) - t  # Does the angle stay zero? (hint 1)
b_range = g * T**2 / 4  # Is this the best straight slope? (hint 1)
b_range = 2 * g * T**2 / sp.pi  # Is the speed at the end its mean as well? (hint 1)

# %% right
a_transversality = [sp.Eq(psi1, 1), sp.Eq(psi2, 0), sp.Eq(psi2 + psi3, 0)]  # combined
a_direction = -sp.atan2(psi3 * g - psi2 * v, psi1 * v) + 2 * sp.pi  # another turn
a_equation = g * sp.cos(theta) ** 2 / (v * sp.cos(theta))  # not cancelled
a_portrait = sp.log(v) - sp.log(sp.cos(theta))  # its logarithm
a_portrait = sp.cos(theta) ** 2 / v**2  # a power of it
b_angle = sp.asin(sp.sin(g * t / (2 * v0) - sp.pi / 3))  # by its sine
