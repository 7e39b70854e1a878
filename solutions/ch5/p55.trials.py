# %% wrong
# Does the time have the sign that this aim requires? (hint 1)
pontryagin = psi1 * (sp.cos(alpha) - b) + psi2 * (u - sp.sin(alpha) / rho) - 1
# Where is the cost? (hint 1)
pontryagin = psi1 * (sp.cos(alpha) - b) + psi2 * (u - sp.sin(alpha) / rho)
# Which sign precedes the derivative of $H$? (hint 1)
adjoint = [psi2 * sp.sin(alpha) / rho**2, -psi1 * sp.sin(alpha) - psi2 * sp.cos(alpha) / rho]
# Does the distance not enter the equations? (hint 1)
adjoint = [0, psi1 * sp.sin(alpha) + psi2 * sp.cos(alpha) / rho]
transversality = [psi1]  # Which coordinate is given at the end? (hint 1)
transversality = [psi1, psi2]  # Are both coordinates free at the end? (hint 1)
regular = -ubar * sp.sign(psi2)  # Does this maximise or minimise $H$? (hint 1)
regular = ubar * sp.sign(psi1)  # Which costate is the factor of the control? (hint 1)
# This is where the distance is stationary. Where is $\psi_2$ stationary? (hint 1)
surface = sp.Eq(sp.cos(alpha), b)
surface = sp.Eq(alpha, sp.pi / 2)  # What is the sine there? (hint 1)
singular = ubar  # Does the angle keep its value under this control? (hint 1)
# How fast does the angle change under this control where the sine vanishes? (hint 1)
singular = 1 / rho
# Look at the sign of $\psi_1$ and at that of the condition. (hint 2)
kelley = sp.cos(alpha) / (b - sp.cos(alpha))
# Does the angle enter the second derivative in no other way? (hint 1)
kelley = 1 / (sp.cos(alpha) - b)
fleeing = "no"  # Look at the sign of $\psi_1$ once more. (hint 1)
meeting = "yes"  # Look at both signs once more. (hint 1)
law = ubar * sp.sign(alpha)  # Does the target turn away from the pursuer? (hint 1)
law = sp.Integer(0)  # In which direction does the target move at first? (hint 1)
straight = (rho_T - rho0) / (1 + b)  # Do the two move in the same direction? (hint 1)
straight = rho_T - rho0  # Does the pursuer stand still? (hint 1)

# %% right
transversality = sp.Eq(psi2, 0)  # a single equation
surface = sp.Eq(sp.tan(alpha), 0)  # by another function
kelley = -psi1 * sp.cos(alpha)  # with the costate
law = sp.Piecewise((-ubar, alpha > 0), (0, sp.Eq(alpha, 0)), (ubar, True))  # cases
