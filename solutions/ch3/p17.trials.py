# %% wrong
a_region = k < 0  # Is this the condition on the stiffness alone? The friction matters, too.
a_region = k > 0  # Was the sign of the control in the second equation lost?
# Was the feedback assumed to act on the rate? The position is measured.
a_region = k > 1
# An observer can do more than a single coefficient; is there a mode that limits it?
a_margins = sp.false
# Is this the bound for a static feedback? With an estimate of the rate more is possible.
a_margins = mu <= sp.Rational(1, 2)
a_repaired_region = k > 0  # Was the minus sign before u lost?
a_repaired_region = k <= 0  # What do the roots look like if the spring has no stiffness at all?
# Is this where the roots become complex? Complex roots are allowed.
a_repaired_region = k < -sp.Rational(1, 4)
b_region = k < -sp.Rational(1, 2)  # Enough stiffness; what has become of the friction?
b_region = k > -3  # Enough friction; what has become of the stiffness?
b_region = sp.And(k > -3, k < sp.Rational(1, 2))  # A sign in the last coefficient: try $k = 0$.
# Was the factor 4 of $x_1$ in $z$ left out of the stiffness?
b_region = sp.And(k > -3, k < -2)
b_region = sp.And(k >= -3, k <= -sp.Rational(1, 2))  # On the border, do the motions decay?

# %% right
a_region = sp.And(k > 1, k < 0)  # two conditions that exclude each other
a_margins = mu > 0  # what was assumed of mu
a_margins = mu < sp.oo  # no bound
a_repaired_region = -k > 0  # the stiffness
a_repaired_region = k**3 < 0  # a cube of the same sign
b_region = (k + 3) * (2 * k + 1) < 0  # the product of the two coefficients
# middle and half length of the interval
b_region = sp.Abs(k + sp.Rational(7, 4)) < sp.Rational(5, 4)
