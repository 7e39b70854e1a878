# %% wrong
exists = P >= m * g  # Is a rocket that hovers climbing? (hint 2)
exists = P > g  # Which force is the thrust compared with? Do not forget the mass. (hint 1)
exists = sp.Ne(P, m * g)  # May the radicand have either sign? (hint 1)
speed = sp.sqrt((P + m * g) / k)  # Which way does the weight act on a climbing rocket? (hint 1)
speed = sp.sqrt((P - g) / k)  # Is the weight written without the mass? (hint 1)
speed = -sp.sqrt((P - m * g) / k)  # Does the rocket climb with a velocity of this sign? (hint 2)
deviation = -sp.sqrt(k * (P - m * g)) / m  # Was the factor 2 lost in the derivative? (hint 1)
# Is this the number for the other root of the quadratic? (hint 1)
deviation = 2 * sp.sqrt(k * (P - m * g)) / m
deviation = -2 * sp.sqrt(k * (P - m * g))  # Was the mass lost? (hint 1)
stability = "unstable"  # Does a positive thrust mean that deviations grow? (hint 1)
stability = "stable"  # Does the speed come back, or does it only stay near? (hint 1)
# In which direction does the drag act on a falling rocket? (hint 1)
fall_acceleration = sp.Integer(0)
fall_acceleration = (P - m * g) / m  # Was the drag forgotten? (hint 2)

# %% right
# as a ratio of thrust and weight, plain symbols
exists = sp.Symbol("P") / (sp.Symbol("m") * sp.Symbol("g")) > 1
exists = (P - m * g) / k > 0  # the radicand
# with plain symbols
speed = sp.sqrt((sp.Symbol("P") - sp.Symbol("m") * sp.Symbol("g")) / sp.Symbol("k"))
speed = [(P / k - m * g / k) ** sp.Rational(1, 2)]  # as a list with one solution, in powers
# as a matrix with one element, a decimal factor
deviation = sp.Matrix([[-2.0 * sp.sqrt(k * P - k * m * g) / m]])
