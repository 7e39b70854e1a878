# %% wrong
control = -1  # Is the mass slow at the end with this force? (hint 2)
# How often can a linear $\psi_2$ with $\psi_2(0) = 0$ change its sign? (hint 2)
control = sp.Piecewise((-1, t < sp.Rational(1, 2)), (1, True))
control = 2  # Is this force within its bounds? (hint 1)
trajectory = t  # Is this the printed plant, with a constant velocity? (hint 1)
trajectory = t**2 / 2  # Does this motion reach the second position? (hint 1)
trajectory = (3 * t - t**2) / 2  # Is this the motion that is slowest at the end? (hint 1)
trajectory = t**2  # Which force does this motion need? (hint 1)
cost = sp.Rational(-5, 8)  # Is this the end for the other bound? (hint 1)
cost = sp.Rational(-9, 8)  # Was the final position left out? (hint 1)
cost = -1  # Is the velocity constant here? (hint 1)
cost = sp.Rational(-13, 4)  # Was the factor in the cost forgotten? (hint 1)
costate = [0, sp.Rational(3, 2)]  # What is psi2 where the initial velocity is free? (hint 1)
# Which sign does psi2 have at the end? (hint 1)
costate = [sp.Rational(3, 2), -sp.Rational(3, 2) * t]
costate = [-1, t]  # Does psi2 at the end satisfy transversality? (hint 1)

# %% right
control = [[1, 1]]  # one arc
trajectory = t * (t + 1) / 2  # a product
trajectory = [(t + t**2) / 2, t + 0.5]  # both states
cost = -1.625  # decimals
costate = sp.Matrix([-1.5, 1.5 * t])  # a column, decimals
costate = (sp.Rational(-3, 2), 3 * t / 2)  # a tuple
