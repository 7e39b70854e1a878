# %% wrong
# How fast is the point at its position? (hint 1)
a_pontryagin = psi_x * sp.cos(theta) + psi_y * sp.sin(theta) - 1
# Is the time to be maximised here? (hint 1)
a_pontryagin = speed * (psi_x * sp.cos(theta) + psi_y * sp.sin(theta)) + 1
# Was each costate's equation differentiated with respect to its own coordinate, with both terms of
# $H$? (hint 1)
a_adjoint = [-psi_x * v_x * sp.cos(theta), -psi_y * v_y * sp.sin(theta)]
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [
    (psi_x * sp.cos(theta) + psi_y * sp.sin(theta)) * v_x,
    (psi_x * sp.cos(theta) + psi_y * sp.sin(theta)) * v_y,
]
a_maximum = sp.atan(psi_y / psi_x)  # What does this give when $\psi_x$ is negative? (hint 2)
# Which of the two arguments of `atan2` comes first? (hint 2)
a_maximum = sp.atan2(psi_x, psi_y)
# Where is the front ahead, and to which side does it turn? (hint 2)
a_equation = v_y * sp.cos(theta) - v_x * sp.sin(theta)
# Is this the change of the speed along the path? (hint 2)
a_equation = v_x * sp.cos(theta) + v_y * sp.sin(theta)
b_time = sp.sqrt(x0**2 + y0**2) * v0  # Does a faster point take longer? (hint 1)
# Is this the path along one axis after the other? (hint 1)
b_time = (sp.Abs(x0) + sp.Abs(y0)) / v0
b_heading = sp.atan2(y0, x0)  # Does this direction lead to the origin or away from it? (hint 1)
# From which initial states does this lead away from the origin? (hint 1)
b_heading = sp.atan(y0 / x0)
# Does the point keep the speed that it has at the origin? (hint 1)
c_time = sp.sqrt(x0**2 + y0**2) / v0
# How long does the straight path take, and is it the fastest? (hint 2)
c_time = sp.sqrt(x0**2 + y0**2) * sp.log((v0 + k * y0) / v0) / (k * y0)
# From which line is height measured in the hyperbolic plane: where is the speed zero? (hint 3)
c_time = sp.acosh(1 + k**2 * (x0**2 + y0**2) / (v0 * (v0 + k * y0))) / k
c_heading = sp.Integer(0)  # Is it faster above the straight path? (hint 1)
# Does the path first climb or first sink? (hint 1)
c_heading = sp.atan(sp.sinh(k * t - sp.asinh(k * a / v0)))
c_heading = -sp.atan(sp.sinh(k * t))  # When is the point halfway? (hint 2)
c_height = sp.sqrt(a**2 + v0**2 / k**2)  # From which line is this height measured? (hint 1)
c_height = a  # Does the centre of the circle lie between both ends? (hint 1)

# %% right
a_maximum = 2 * sp.atan2(psi_y, psi_x + sp.sqrt(psi_x**2 + psi_y**2))  # by half the angle
# by the direction of the gradient
a_equation = sp.sqrt(v_x**2 + v_y**2) * sp.sin(theta - sp.atan2(v_y, v_x))
b_heading = sp.atan2(y0, x0) - sp.pi  # from the opposite direction
# by the inverse hyperbolic sine of half the distance
c_time = 2 / k * sp.asinh(k * sp.sqrt(x0**2 + y0**2) / (2 * sp.sqrt(v0 * (v0 + k * y0))))
# by the exponential
c_heading = sp.pi / 2 - 2 * sp.atan(sp.exp(k * t) * (sp.sqrt(v0**2 + k**2 * a**2) - k * a) / v0)
c_height = a**2 / (sp.sqrt(a**2 + v0**2 / k**2) + v0 / k)  # with the root in the denominator
