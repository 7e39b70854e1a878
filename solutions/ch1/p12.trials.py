# %% wrong
cycle = u >= shift  # Is a circle of radius zero a closed trajectory? (hint 1)
cycle = u > 0  # Does any positive control give a real radius? (hint 1)
cycle = u > -shift  # Does the shift have the wrong sign in the equation for r? (hint 1)
amplitude = amplitude**2  # Was the root taken at the end? (hint 1)
# Does the shift have the wrong sign in the equation for r? (hint 1)
amplitude = sp.sqrt((u + shift) / cubic)
period = 2 * sp.pi / amplitude  # Was the constant part of the angular rate forgotten? (hint 1)
period = 2 * sp.pi / turn  # Does the rate of the angle depend on the radius? (hint 1)
# Was the equation linearised at rest instead of on the cycle? (hint 1)
deviation = u - shift
deviation = sp.Integer(0)  # Was the factor 3 lost in the derivative of the cube? (hint 1)
stability = "unstable"  # Is this true of the equilibrium instead of the cycle? (hint 1)
stability = "stable"  # Does this hold for the phase, and not for the radius? (hint 1)

# %% right
cycle = sp.Symbol("u") - shift > 0  # the radicand, plain symbol
amplitude = [amplitude]  # as a list with one radius
# freed from the root in the denominator
period = 2 * sp.pi * cubic * (amplitude - turn) / (u - shift - cubic * turn**2)
period = 6.28 / (turn + amplitude)  # with decimals
# by the amplitude, as a matrix with one element
deviation = [[u - shift - 3 * cubic * amplitude**2]]

# %% numbers
shift, cubic, turn = [
    (2, 1, 1),
    (1, 4, 2),
    (3, 1, 3),
    (4, 4, 1),
    (5, 9, 2),
    (sp.Rational(2, 3), 1, 1),
    (sp.Rational(5, 3), 1, 1),
    (sp.Rational(1, 3), 1, 1),
    (sp.Rational(3, 2), 1, 1),
    (6, 4, 3),
    (sp.Rational(8, 3), 1, 1),
    (sp.Rational(1, 2), 1, 2),
    (sp.Rational(7, 2), 1, 1),
    (sp.Rational(4, 3), 1, 1),
]
shown = [
    r"\dot r = (u - «shift»)\,r - «cubic*»r^3, \qquad \dot\varphi = r + «turn» .",
]
cycle = u > shift
amplitude = sp.sqrt((u - shift) / cubic)
period = 2 * sp.pi / (amplitude + turn)
deviation = -2 * (u - shift)
