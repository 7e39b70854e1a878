# %% wrong
# Is the cost an integral here, or a terminal cost? (hint 1)
pontryagin = psi1 * u + psi2 * x1**2 - x2
pontryagin = psi1 * u - psi2 * x1**2  # Which sign does the second right-hand side have? (hint 1)
adjoint = [2 * psi2 * x1, 0]  # Which sign precedes the derivative of $H$? (hint 1)
adjoint = [-2 * x1, 0]  # Was a costate left out in the derivative? (hint 1)
transversality = [psi1, psi2 - 1]  # Is the cost minimised or maximised? (hint 1)
transversality = [psi1, psi2]  # Does the cost have no influence? (hint 1)
transversality = [psi2 + 1]  # What follows from a free end for the other costate? (hint 1)
# Which state does the derivative of the switching function contain? (hint 1)
surface = sp.Eq(x2, 0)
# Does the cost so far matter for what is best from now on? (hint 1)
surface = sp.Eq(x1, x2)
control = 1  # How long does this control keep the switching function at zero? (hint 1)
# What is the sign of zero, and does it determine the control? (hint 1)
control = sp.sign(psi1)
order = 2  # Is this the number of the derivative itself? (hint 1)
kelley = 2  # Which power of $-1$ belongs to this order? (hint 1)
kelley = -1  # Was a square differentiated? (hint 1)
holds = "no"  # Look at the sign of $\psi_2$ and at the power of $-1$ once more. (hint 1)
# Does your motion cross the line and move away again? (hint 1)
least = a**2 - sp.Abs(a) + sp.Rational(1, 3)
least = a**3 / 3  # Can a sum of squares be negative? (hint 2)
least = a**2  # Is this the cost of staying at the initial state? (hint 1)

# %% right
transversality = [sp.Eq(psi1, 0), sp.Eq(psi2, -1)]  # equations
transversality = [psi1 + psi2 + 1, psi1 - psi2 - 1]  # combined
surface = sp.Eq(x1**2, 0)  # a square
kelley = 2 * psi2  # with the costate
adjoint = [-2 * psi2 * x1, sp.Integer(0)]  # SymPy's zero
least = sp.Piecewise((a**3 / 3, a > 0), (-(a**3) / 3, True))  # by cases
