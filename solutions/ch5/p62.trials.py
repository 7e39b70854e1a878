# %% wrong
a_pontryagin = psi1 * x2 + psi2 * u + x1**2  # Is the cost minimised or maximised? (hint 1)
# Which costate belongs to which equation? (hint 1)
a_pontryagin = psi1 * x1 + psi2 * x2 + u - x1**2
# Which sign does the cost have in $H$, and which one the derivative of $H$? (hint 1)
a_adjoint = [-2 * x1, -psi1]
a_adjoint = [2 * x1, psi1]  # Look at the sign of the second equation. (hint 1)
a_regular = sp.sign(psi1)  # Which costate is the factor of the control? (hint 1)
# Does this maximise $H$, or is it only a plausible guess? (hint 1)
a_regular = -sp.sign(x1)
# Is this all that follows from the derivatives? Differentiate once more. (hint 1)
b_surface = [sp.Eq(x1, 0)]
# Which derivatives of the switching function are free of costates? (hint 1)
b_surface = [sp.Eq(x1**2, x2**2)]
b_control = 1  # Does the body stay where the equations hold under this control? (hint 1)
b_control = -1  # Does the body stay where the equations hold under this control? (hint 1)
b_order = 4  # Is this the number of the derivative itself? (hint 1)
b_order = 1  # Does the second derivative contain the control? (hint 1)
c_kelley = 2  # Which power of $-1$ belongs to this order? (hint 1)
c_kelley = -1  # Was the factor of the square in the cost kept? (hint 1)
c_holds = "no"  # Which sign does the condition require if $H$ is maximised? (hint 1)
d_plan = 32 / 5  # Was a factor of the motion with constant acceleration forgotten? (hint 1)
d_plan = sp.Rational(8, 5)  # Was the return forgotten? (hint 1)
# Is this the curve of the plan itself? Can an optimal motion leave along it? (hint 2)
d_leaving = x2**2 / 2
# How does the position change when the time is reversed? (hint 1)
d_leaving = -sp.sqrt((sp.sqrt(33) - 1) / 24) * x2**2
# Is this the cost of the plan? Are its arcs joined as the order allows? (hint 1)
d_cost = sp.Rational(16, 5)
# Were the motions there and back taken as time-optimal? (hint 3)
w = sp.sqrt(2 + c**2 / 2)
t = sp.Symbol("t")
d_cost = 2 * sp.integrate((2 - c * t - t**2 / 2) ** 2, (t, 0, w - c)) + w**5 / 10

# %% right
b_surface = [x1**2 + x2**2]  # a sum of squares
d_leaving = sp.sqrt(-6 + 6 * sp.sqrt(33)) * x2**2 / 12  # another root
# by homogeneity from rest
xi = sp.sqrt((sp.sqrt(33) - 1) / 24)
w = sp.sqrt((2 + c**2 / 2) / (xi + sp.Rational(1, 2)))
d_cost = (
    2 * (sp.Rational(2, 15) + 2 * xi / 3 + xi**2 + sp.Rational(2, 5) * xi**3) * w**5
    - 2 * c * (60 + 20 * c**2 + 2 * c**4) / 15
)
