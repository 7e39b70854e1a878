# %% wrong
pontryagin = psi1 * u + psi2 * x1**2  # Is this the function of the previous problem? (hint 1)
# Is the cost an integral here, or a terminal cost? (hint 1)
pontryagin = psi1 * u - psi2 * x1**2 - x2
adjoint = [-2 * psi2 * x1, 0]  # Which sign precedes the derivative of $H$? (hint 1)
adjoint = [2 * psi2 * x1, -1]  # Does $H$ depend on the second state? (hint 1)
# Which state does the derivative of the switching function contain? (hint 1)
surface = sp.Eq(x2, 0)
surface = sp.Eq(x1, 1)  # Is this where the best motion ends? (hint 1)
control = 1  # How long does this control keep the switching function at zero? (hint 1)
control = -1  # Is this a singular control, or one at the bound? (hint 1)
kelley = -2  # What is $\psi_2$ here, with its sign? (hint 1)
kelley = -2 * psi2 - 4  # Was the power of $-1$ counted twice? (hint 2)
holds = "yes"  # Look at the sign of $\psi_2$ and at the power of $-1$ once more. (hint 1)
best = 0  # The conditions hold for this one. Does another control do better? (hint 1)
# This is an extremal. Is it the best one? (hint 2)
best = sp.Piecewise((1, t < sp.Rational(1, 3)), (-1, True))
least = 0  # Is this the cost of the singular control? (hint 1)
least = -sp.Rational(1, 27)  # Is this the cost of an extremal with a reversal? (hint 1)

# %% right
best = -1  # the mirror image
kelley = -2 * psi2  # with the costate
surface = sp.Eq(2 * x1, 0)  # a multiple
