# %% wrong
pontryagin = psi1 * u - psi2 * x1  # Does the control appear in both equations? (hint 1)
pontryagin = psi1 * u + psi2 * u * x1  # Which sign does the second right-hand side have? (hint 1)
transversality = [psi1, psi2 - 1]  # Is the cost minimised or maximised? (hint 1)
transversality = [psi1]  # What follows from the cost for the other costate? (hint 1)
switching = psi1  # Is this the whole factor of the control? (hint 1)
switching = psi1 + psi2 * x1  # Which sign does the second right-hand side have? (hint 1)
rate = psi2 * u  # Was the motion of $x_1$ forgotten? (hint 1)
rate = -psi2 * u  # Was the motion of the costate forgotten? (hint 1)
family = c  # To which end does a constant control lead? (hint 1)
family = c * (1 - t)  # What is the mean of this control? (hint 2)
family = 0  # With which value does this control begin? (hint 2)
cost = -(xi**2)  # Is the derivative of a square just the product? (hint 1)
cost = xi**2 / 2  # Which sign does the integrand have? (hint 1)
least = -1  # Is the derivative of a square just the product? (hint 1)
least = 0  # Does every control give this? (hint 1)
greatest = sp.Rational(1, 2)  # Which process would cost this? (hint 1)

# %% right
switching = psi1 + x1  # with the costate that is known
family = c * sp.cos(sp.pi * t)  # half a wave
family = c * (1 - 6 * t + 6 * t**2)  # a parabola
transversality = [sp.Eq(psi1, 0), sp.Eq(psi2, -1)]  # equations
