# %% wrong
cycle = u >= 2  # Is a circle of radius zero a closed trajectory? (hint 1)
cycle = u > 0  # Does any positive control give a real radius? (hint 1)
cycle = u > -2  # Did the shift get the wrong sign in the equation for r? (hint 1)
amplitude = u - 2  # Was the root taken at the end? (hint 1)
amplitude = sp.sqrt(u + 2)  # Did the shift get the wrong sign in the equation for r? (hint 1)
period = 2 * sp.pi / sp.sqrt(u - 2)  # Was the constant part of the angular rate forgotten? (hint 1)
period = 2 * sp.pi  # Does the rate of the angle depend on the radius? (hint 1)
deviation = u - 2  # Was the equation linearised at rest instead of on the cycle? (hint 1)
deviation = sp.Integer(0)  # Was the cube differentiated with its factor? (hint 1)
stability = "unstable"  # Is this said of the equilibrium instead of the cycle? (hint 1)
stability = "stable"  # Does this hold for the phase, and not for the radius? (hint 1)

# %% right
cycle = sp.Symbol("u") - 2 > 0  # the radicand, plain symbol
amplitude = [sp.sqrt(u - 2)]  # as a list with one radius
period = 2 * sp.pi * (sp.sqrt(u - 2) - 1) / (u - 3)  # freed from the root in the denominator
period = 6.28 / (1 + sp.sqrt(u - 2))  # with decimals
deviation = [[u - 2 - 3 * sp.sqrt(u - 2) ** 2]]  # by the amplitude, as a matrix with one element
