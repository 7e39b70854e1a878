# %% wrong
# Does the time have the sign that this aim requires? (hint 1)
a_pontryagin = psi1 * (b - sp.cos(beta)) + psi2 * (sp.sin(beta) / rho + u) - 1
# Where is the cost? (hint 1)
a_pontryagin = psi1 * (b - sp.cos(beta)) + psi2 * (sp.sin(beta) / rho + u)
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [-psi2 * sp.sin(beta) / rho**2, psi1 * sp.sin(beta) + psi2 * sp.cos(beta) / rho]
# Does the distance not enter the equations? (hint 1)
a_adjoint = [0, -psi1 * sp.sin(beta) - psi2 * sp.cos(beta) / rho]
a_transversality = [psi1]  # Which coordinate is given at the end? (hint 1)
a_transversality = [psi1, psi2]  # Are both coordinates free at the end? (hint 1)
a_control = -ubar * sp.sign(psi2)  # Does this maximise or minimise $H$? (hint 1)
a_control = ubar * sp.sign(psi1)  # Which costate is the factor of the control? (hint 1)
# This is where the distance is stationary. Where is $\psi_2$ stationary? (hint 1)
a_surface = sp.Eq(sp.cos(beta), b)
a_surface = sp.Eq(beta, sp.pi / 2)  # What is the sine there? (hint 1)
a_singular = ubar  # Does the angle keep its value under this control? (hint 1)
# How fast does the angle change under this control where the sine vanishes? (hint 1)
a_singular = -1 / rho
# Which sign does $\psi_1$ have if the time is maximised? (hint 2)
a_kelley = sp.cos(beta) / (b - sp.cos(beta))
# Does the angle enter the second derivative in no other way? (hint 1)
a_kelley = -1 / (b - sp.cos(beta))
a_ahead = "no"  # Look at the sign of $\psi_1$ once more. (hint 1)
a_behind = "yes"  # Was the cosine taken on the right arc? (hint 1)
a_law = ubar * sp.sign(beta)  # Does the pursuer turn towards the target? (hint 1)
a_law = -ubar * sp.sign(sp.cos(beta))  # When is the distance to grow slowest? (hint 1)
# Where is no turn needed, and where does the pursuer point at first? (hint 1)
a_law = sp.Integer(0)
b_kelley = -sp.cos(beta) / (b - sp.cos(beta))  # Is this the expression of item a? (hint 1)
b_kelley = 1 / (b - sp.cos(beta))  # Does the angle enter the second derivative in no other way?
# Which signs do the costate of the distance and the cosine have on this arc? (hint 1)
b_behind = "no"
b_law = ubar * sp.sign(beta)  # Does the pursuer turn towards the target? (hint 1)
b_law = sp.Integer(0)  # Does the pursuer always point at the target at first? (hint 1)

# %% right
a_transversality = sp.Eq(psi2, 0)  # a single equation
a_surface = sp.Eq(sp.tan(beta), 0)  # by another function
a_surface = sp.Eq(sp.sin(2 * beta) / sp.cos(beta), 0)  # as a quotient
a_kelley = psi1 * sp.cos(beta)  # with the costate
a_law = sp.Piecewise((-ubar, beta > 0), (0, sp.Eq(beta, 0)), (ubar, True))  # cases
b_law = sp.Piecewise((-ubar, beta > 0), (0, sp.Eq(beta, 0)), (ubar, True))  # cases
