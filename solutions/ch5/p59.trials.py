# %% wrong
# Is the cost minimised or maximised? (hint 1)
a_pontryagin = psi1 * x2 + psi2 * (x1 + u) + x1**2 + 2 * x2**2
# Which equation does the body satisfy without a force? (hint 1)
a_pontryagin = psi1 * x2 + psi2 * u - x1**2 - 2 * x2**2
# The plant is not a double integrator: what is missing? (hint 1)
a_adjoint = [2 * x1, -psi1 + 4 * x2]
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [psi2 - 2 * x1, psi1 - 4 * x2]
a_regular = sp.sign(psi1)  # Which costate is the factor of the control? (hint 1)
a_regular = -sp.sign(psi2)  # Does this maximise or minimise $H$? (hint 1)
b_surface = sp.Eq(x2, x1)  # Was $H = 0$ used with both terms of the cost? (hint 2)
b_surface = sp.Eq(x2, -x1 / sp.sqrt(2))  # Did the square root leave one line only? (hint 2)
b_control = -x1  # Does this keep the switching function at zero? (hint 1)
b_control = x1 / 2  # Look at the sign in the second derivative. (hint 1)
b_order = 2  # Is this the number of the derivative itself? (hint 1)
c_kelley = 4  # Which power of $-1$ belongs to this order? (hint 1)
c_kelley = -2  # Was the factor of the velocity in the cost kept? (hint 1)
c_holds = "no"  # Which sign does the condition require? (hint 1)
d_starts = sp.Abs(b) < 1  # Does the velocity not matter? (hint 1)
d_starts = b + c < 1  # What about the other side? (hint 1)
d_starts = sp.Abs(b - c) < 1  # Which combination grows, and which one decays? (hint 1)
# When is the line reached, and which control keeps the body on it? (hint 2)
d_control = [[-1, 1], [0, 3]]
d_control = [[-b, 3]]  # Is a small initial control an advantage? (hint 1)
d_cost = sp.sqrt(2) * b**2  # Is the initial state on the line? (hint 1)
# Does the first arc cost nothing? (hint 1)
d_cost = sp.sqrt(2) * (1 - (1 - b) * sp.cosh(sp.asinh(1 / (1 - b)) - sp.asinh(1))) ** 2

# %% right
b_surface = sp.Eq(sp.Abs(x1), sp.sqrt(2) * sp.Abs(x2))  # with absolute values
b_control = -(x2**2) / x1  # with the equation of the lines
d_starts = sp.And(b + c < 1, b + c > -1)  # two inequalities
# with logarithms
w = (1 + sp.sqrt(1 + (1 - b) ** 2)) / ((1 - b) * (1 + sp.sqrt(2)))
start = 1 - (1 - b) * (w + 1 / w) / 2
d_control = [[-1, sp.log(w)], [-start * sp.exp(-t / sp.sqrt(2)) * w ** (1 / sp.sqrt(2)) / 2, 3]]
