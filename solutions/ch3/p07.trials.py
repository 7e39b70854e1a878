# %% wrong
# Does an output show everything because it contains both x and its rate? (hint 1)
printed_obstacle = {}
printed_obstacle = {-1: [1, -1, 1]}  # Does this motion decay, and is it really hidden? (hint 1)
printed_obstacle = {3: [1, 3, 9]}  # Is the fastest motion the one that is not seen? (hint 1)
margins = mu < 1  # Is a margin reached where a root lies just on its border? (hint 1)
margins = sp.true  # Is a hidden mode no hindrance because it decays? (hint 1)
margins = sp.false  # Has a system no observer as soon as something is not seen? (hint 1)
gain = sp.Matrix([0, 0, 0])  # Do the errors decay if the system is left to itself? (hint 1)
# Is this the sign of a feedback $u = Kx$? The correction enters the errors with a minus. (hint 1)
gain = sp.Matrix([0, -3, -8])
# Were the corrections of the new coordinate taken for those of x? (hint 1)
gain = sp.Matrix([3, 11, 0])
# Is it impossible because the system is not observable? How fast does the hidden motion decay?
# (hint 1)
gain = []
gain = sp.Matrix([0, sp.Rational(5, 2), 6])  # Do all roots lie far enough to the left? (hint 1)
# Was the factor of the measurement forgotten? (hint 1)
family = sp.Matrix([0, beta1 + 2, beta1 + beta2])
family = []  # Is a polynomial with the right factor impossible? (hint 1)

# %% right
printed_obstacle = {1.0: sp.Matrix([-2, -2, -2])}  # another multiple, decimals
margins = sp.Not(mu > 1)  # the complement
gain = sp.Matrix([2, 1, 10])  # with q = 2
gain = [0, 4, 14]  # other roots of y, a flat list
gain = sp.Matrix([-8, 11, 0])  # no correction of the last equation
# no correction of the second equation
family = sp.Matrix([beta1 / 2 + 2, 0, 2 * beta1 + beta2 / 2 + sp.Rational(13, 2)])
