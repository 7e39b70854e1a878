# %% wrong
a_control = sp.Matrix([[-b2, -b1]])  # Has what the plant itself brings along been cancelled?
a_control = sp.Matrix([[2 + b2, 1 + b1]])  # Is the feedback taken with a minus sign, $u = -Kx$?
# Which of the two numbers is multiplied by x, and which by its rate?
a_control = sp.Matrix([[-1 - b1, -2 - b2]])
# The product of the roots holds both numbers. Is the second one complete?
a_correction = sp.Matrix([g1 + 1, g2 + 2])
# Are these the numbers for a plant without roots of its own?
a_correction = sp.Matrix([g1, g2])
# Does the correction enter the equation of the errors as + LH?
a_correction = sp.Matrix([-g1 - 1, -g1 - g2 - 3])
# Is there a motion that the measurement does not show? What becomes of an error along it?
b_margins = sp.true
b_margins = sp.false  # Something is hidden. Does it grow or decay?
b_margins = mu < 1  # Look at the margin 1 itself: can the slowest root be as fast as that?
b_margins = mu <= 2  # Which of the two roots is the one that stays?
# Put it into $A - LH$: where is the second root for $\gamma = 1$?
b_correction = sp.Matrix([g, 0])
b_correction = sp.Matrix([g + 1, g + 3])  # Is this the gain of a measurement of x alone?
# In which combination do the two numbers enter the polynomial?
b_correction = sp.Matrix([g + 2, g + 2])
c_margins = mu <= 1  # The exponential that is not shown: is it a motion of this plant?
# A zero of the measurement is no hidden motion. Compare it with the roots of the equation.
c_margins = sp.false
# Which sign has the friction that the plant has already?
c_control = sp.Matrix([[-1 - b2, -2 - b1]])
# Which sign has the stiffness that the plant has already?
c_control = sp.Matrix([[1 - b2, 2 - b1]])
# The sum and the difference of two numbers, and then?
c_correction = sp.Matrix([g1 + g2 - 1, g2 - g1 + 3])
# Are these the numbers themselves, or their difference and their sum?
c_correction = sp.Matrix([g1 - 2, g2 + 1])
# Does the plant move like the exponential that the measurement does not show?
d_margins = sp.false
d_margins = mu <= 2  # Is a zero of the measurement a root that no gain can move?
# Is this the equation of item a? Mind the sign of the friction.
d_control = sp.Matrix([[-2 - b2, -1 - b1]])
d_control = sp.Matrix([[2 + b2, b1 - 1]])  # Is the feedback taken with a minus sign, $u = -Kx$?
# Is the right-hand side divided by what stands before $l_1$ and $l_2$?
d_correction = sp.Matrix([2 * g1 + g2, 2 * g2 + 4])
# The sum of the roots holds both numbers. Is the first one complete?
d_correction = sp.Matrix([g1 / 2, g2 / 2 + 1])

# %% right
a_control = [-b2 - 2, -b1 - 1]  # a flat list
a_correction = sp.Matrix([[g1 + 1, g1 + 1 + g2 + 2]])  # lying down
b_margins = sp.And(mu > 0, mu <= 1)  # with what is known of mu
b_margins = mu**2 <= 1  # a square
b_correction = sp.Matrix([0, g + 2])  # the whole correction on the second equation
b_correction = sp.Matrix([g, 2])  # another splitting of the sum
b_correction = sp.Matrix([1, 1]) * (g + 2) / 2  # in two halves
c_margins = mu > 0  # what is known of mu
c_control = -sp.Matrix([[1 + b2, b1 - 2]])  # a factor taken out
c_correction = [(g1 + g2) / 2 - 0.5, (g2 - g1) / 2 + 1.5]  # decimals
d_margins = mu < sp.oo  # no bound
d_control = sp.Matrix([-2 - b2, 1 - b1])  # upright
d_correction = [g1 / 2 + g2 / 4, g2 / 2 + 1]  # each by itself
