# %% wrong
# Is the cost an integral here, or a terminal cost? (hint 1)
pontryagin = psi1 * (1 - y**2) + psi2 * u - x
pontryagin = psi1 * (1 - y**2)  # Was the second equation forgotten? (hint 1)
adjoint = [0, -2 * psi1 * y]  # Which sign precedes the derivative of $H$? (hint 1)
adjoint = [1 - y**2, u]  # Are these the equations of motion themselves? (hint 1)
transversality = [psi1 + 1]  # Is the drift minimised or maximised? (hint 1)
transversality = [psi1 - 1, psi2]  # Is the position across the river free at the end? (hint 1)
regular = sp.sign(psi1)  # Which costate is the factor of the control? (hint 1)
regular = -sp.sign(psi2)  # Does this maximise or minimise $H$? (hint 1)
# Where is the water at rest, and where does the switching function stay zero? (hint 1)
surface = sp.Eq(y**2, 1)
surface = sp.Eq(x, 0)  # Which coordinate does the derivative contain? (hint 1)
control = 1  # Does the raft stay on the surface under this control? (hint 1)
control = sp.sign(psi2) + 1  # Which control keeps the switching function at zero? (hint 1)
order = 2  # Is this the number of the derivative itself? (hint 1)
kelley = 2  # Which power of $-1$ belongs to this order? (hint 1)
kelley = -2 * y  # Was it differentiated with respect to the control? (hint 1)
holds = "no"  # Look at the sign of $\psi_1$ once more: is $\lambda_0$ positive? (hint 1)
distance = T - 2  # How far does the raft drift during the two crossings? (hint 1)
distance = sp.Rational(2, 3) * T  # Is this the drift with a uniform crossing? (hint 1)
law = -sp.sign(y)  # When does the raft reach the other bank? (hint 2)
# What does a raft beyond the middle do? (hint 1)
law = sp.Piecewise((1, y < 0), (1, s <= 1 - y), (0, True))
law = sp.Integer(1)  # Can the raft arrive at any time? (hint 1)

# %% right
transversality = sp.Eq(psi1, 1)  # a single equation
kelley = -2 * psi1  # with the costate
law = sp.Piecewise((1, s <= 1 - y), (1, y < 0), (0, sp.Eq(y, 0)), (-1, True))  # all four cases
