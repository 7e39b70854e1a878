# %% wrong
control = 2 * sp.cosh(2 * t) / sp.sinh(2)  # Is the velocity of the motion all control? (hint 2)
# Which sign has u in the equation of the motion? (hint 2)
control = (sp.sinh(2 * t) - 2 * sp.cosh(2 * t)) / sp.sinh(2)
control = 1 - t  # Does this belong to a steady motion? What does it cost? (hint 1)
control = (sp.cosh(t) - sp.sinh(t)) / sp.sinh(1)  # Was the price of x forgotten? (hint 1)
# Does the law for an infinite time lead away from zero? (hint 1)
control = -3 * sp.sinh(2 * t) / sp.sinh(2)
# Was the free motion of the system left out in the elimination? (hint 1)
motion = sp.sinh(sp.sqrt(3) * t) / sp.sinh(sp.sqrt(3))
motion = t  # Is the straight line an extremal? (hint 1)
# Which sign has the term with x in the equation of the second order? (hint 1)
motion = sp.sin(2 * t) / sp.sin(2)
motion = sp.exp(2 * t - 2)  # Where does this motion begin? (hint 2)
motion = sp.sinh(t) / sp.sinh(1)  # Does being away from zero cost nothing? (hint 1)
# With H to be made greatest, which sign has the costate? (hint 1)
costate = (sp.sinh(2 * t) - 2 * sp.cosh(2 * t)) / sp.sinh(2)
# Was the half before the integral left out? (hint 1)
costate = (4 * sp.cosh(2 * t) - 2 * sp.sinh(2 * t)) / sp.sinh(2)
# Is the Riccati equation for an infinite time of use with a given end? (hint 1)
costate = -3 * sp.sinh(2 * t) / sp.sinh(2)
cost = 2 * sp.coth(2) - 1  # Was the half before the integral left out? (hint 1)
cost = sp.coth(2)  # Was a derivative in the integrand forgotten? (hint 1)
# Which sign has the product of x and its velocity in the square of u? (hint 1)
cost = sp.coth(2) + sp.Rational(1, 2)
cost = sp.Rational(1, 2)  # Is this bound attained by a motion with these ends?

# %% right
control = (sp.exp(2 * t) + 3 * sp.exp(-2 * t)) / (sp.exp(2) - sp.exp(-2))  # with exponentials
motion = sp.sinh(t) * sp.cosh(t) / (sp.sinh(1) * sp.cosh(1))  # of the half argument
costate = [(sp.exp(2 * t) + 3 * sp.exp(-2 * t)) / (sp.exp(2) - sp.exp(-2))]  # a list of one
cost = sp.Rational(1, 2) + 2 / (sp.exp(4) - 1)  # with an exponential
cost = 0.537  # three digits
