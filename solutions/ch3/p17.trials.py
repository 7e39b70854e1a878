# %% wrong
a_region = k < 0  # Is this the condition on the stiffness alone? The friction matters, too.
a_region = k > 0  # Was the sign of the control in the second equation lost?
# Is the feedback thought to act on the rate? It is the position that is measured.
a_region = k > 1
# What one coefficient cannot do an observer may; which mode would stand in its way?
a_margins = sp.false
# Is this the bound for a static feedback? An estimate of the rate is worth more.
a_margins = mu <= sp.Rational(1, 2)
a_repaired_region = k > 0  # Was the minus sign before u lost on the way?
a_repaired_region = k <= 0  # What do the roots look like if the spring has no stiffness at all?
# Is this where the roots become complex? They may be complex.
a_repaired_region = k < -sp.Rational(1, 4)
b_region = k < -sp.Rational(1, 2)  # Enough stiffness; what has become of the friction?
b_region = k > -3  # Enough friction; what has become of the stiffness?
b_region = sp.And(k > -3, k < sp.Rational(1, 2))  # A sign in the last coefficient: try $k = 0$.
# Was $z$ taken for $x_1$ with its factor 4 left out of the stiffness?
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
