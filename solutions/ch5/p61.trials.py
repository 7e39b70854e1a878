# %% wrong
a_pontryagin = psi1 * x2 + psi2 * u + x1**2  # Is the cost minimised or maximised? (hint 1)
a_pontryagin = psi1 * x2 + psi2 * u  # Where is the integrand of the cost? (hint 1)
# Which sign does the cost have in $H$, and which one the derivative of $H$? (hint 1)
a_adjoint = [-2 * x1, -psi1]
a_adjoint = [2 * x1, psi1]  # Look at the sign of the second equation. (hint 1)
a_regular = sp.sign(psi1)  # Which costate is the factor of the control? (hint 1)
a_regular = -sp.sign(psi2)  # Does this maximise or minimise $H$? (hint 1)
# Is this all that follows from the derivatives? Differentiate once more. (hint 1)
b_surface = [sp.Eq(x1, 0)]
b_surface = [sp.Eq(x2, 0)]  # What follows from the derivative before this one? (hint 1)
b_control = 1  # Does the body stay where the equations hold under this control? (hint 1)
# Which control keeps the switching function at zero? (hint 1)
b_control = sp.sign(psi2) + x1 - 1
b_order = 4  # Is this the number of the derivative itself? (hint 1)
b_order = 1  # Does the second derivative contain the control? (hint 1)
c_kelley = 2  # Which power of $-1$ belongs to this order? (hint 1)
c_kelley = -1  # Was the factor of the square in the cost kept? (hint 1)
c_holds = "no"  # Which sign does the condition require if $H$ is maximised? (hint 1)
# This curve belongs to the minimum time. Does the control switch on it only once? (hint 1)
d_curve = x2**2 / 2
# Is this curve steep enough for the motion to cross it? (hint 3)
d_curve = sp.sqrt((sp.sqrt(33) + 1) / 24) * x2**2
# Which power of the speed is consistent with the scaling of time? (hint 1)
d_curve = sp.sqrt((sp.sqrt(33) - 1) / 24) * x2
# On which side of the origin is the body when it begins to brake? (hint 1)
d_curve = -sp.sqrt((sp.sqrt(33) - 1) / 24) * x2**2
# Was the cost of minimum time taken? (hint 1)
t, w = sp.Symbol("t"), sp.sqrt(b + c**2 / 2)
d_cost = sp.integrate((b + c * t - t**2 / 2) ** 2, (t, 0, c + w)) + w**5 / 20
# Does the cost not depend on the initial speed? (hint 3)
d_cost = sp.Rational(76402, 100000) * b ** sp.Rational(5, 2)

# %% right
b_surface = [x1**2 + x2**2]  # a sum of squares
b_surface = [sp.Eq(x1, 0), sp.Eq(x1 + x2, 0)]  # another pair of equations
# by homogeneity from rest
xi = sp.sqrt((sp.sqrt(33) - 1) / 24)
w = sp.sqrt((b + c**2 / 2) / (xi + sp.Rational(1, 2)))
d_cost = (
    c * (15 * b**2 + 10 * b * c**2 + 2 * c**4) / 15
    + (sp.Rational(2, 15) + 2 * xi / 3 + xi**2 + sp.Rational(2, 5) * xi**3) * w**5
)
