# %% wrong
cycle = u >= 2  # the circle of radius zero counted
cycle = u > 0  # any positive control thought to do
cycle = u > -2  # the sign of the shift
amplitude = u - 2  # the root not taken
amplitude = sp.sqrt(u + 2)  # the sign of the shift
period = 2*sp.pi/sp.sqrt(u - 2)  # the constant part of the angular rate forgotten
period = 2*sp.pi  # the linear system at rest: the dependence on r forgotten
deviation = u - 2  # linearised at rest instead of on the cycle
deviation = sp.Integer(0)  # the derivative of the cube without its factor 3
stability = "unstable"  # the control is positive, so growth is expected: it is the state of rest that is unstable
stability = "stable"  # this holds for the phase, not for r

# %% right
cycle = sp.Symbol("u") - 2 > 0  # the radicand, plain symbol
amplitude = [sp.sqrt(u - 2)]  # as a list with one radius
period = 2*sp.pi*(sp.sqrt(u - 2) - 1)/(u - 3)  # freed from the root in the denominator
period = 6.28/(1 + sp.sqrt(u - 2))  # with decimals
deviation = [[u - 2 - 3*sp.sqrt(u - 2)**2]]  # by the amplitude, as a matrix with one element
