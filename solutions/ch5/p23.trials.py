# %% wrong
# Which sign has the cost in the adjoint equation? (hint 1)
costate = [2 - t, -sp.Rational(5, 2) + 3 * t - t**2 / 2]
# Was the velocity in the cost forgotten? (hint 2)
costate = [t - 2, -sp.Rational(3, 2) + 2 * t - t**2 / 2]
# Where does the control switch, and where is this second function zero? (hint 2)
costate = [t - 2, 3 * t - t**2 / 2]
# Where should the carriage be while it waits? (hint 1)
control = sp.Piecewise((1, t < 1), (-1, True))
control = -1  # Is the velocity zero at the end? (hint 2)
control = sp.Integer(0)  # Is rest the best there is? (hint 1)
trajectory = -(t**2) / 2  # Does this motion come to rest in the end? (hint 1)
# Do the two arcs join? (hint 1)
trajectory = sp.Piecewise((-(t**2) / 2, t < 1), ((t - 2) ** 2 / 2, True))
# Is the cost small on this side? (hint 1)
trajectory = sp.Piecewise((t**2 / 2, t < 1), (1 - (t - 2) ** 2 / 2, True))
cost = -1  # Was the integral of the velocity left out? (hint 1)
cost = 2  # Is this the greatest value? (hint 1)

# %% right
costate = sp.Matrix([t - 2, (5 - t) * (t - 1) / 2])  # factors, a column
control = [[-1, 1], [1, 2]]  # a list of arcs
control = sp.sign(t - 1)  # the sign of the switching function
# both states
trajectory = [sp.Piecewise((-(t**2) / 2, t <= 1), (t**2 / 2 - 2 * t + 1, True)), -1 + sp.Abs(t - 1)]
# the second arc first, expanded
trajectory = sp.Piecewise((1 - 2 * t + t**2 / 2, t > 1), (-(t**2) / 2, True))
cost = -2.0  # a decimal
