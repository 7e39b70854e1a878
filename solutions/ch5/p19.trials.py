# %% wrong
# Does this go to the left? (hint 1)
control = sp.Piecewise((1, t < sp.Rational(1, 2)), (-1, True))
control = -1  # Is the mass at rest at the end? (hint 2)
# Is the velocity zero at the end, if the push lasts longer than the braking? (hint 2)
control = sp.Piecewise((-1, t < sp.Rational(3, 4)), (1, True))
control = 0  # Does the mass move at all? (hint 1)
control = 2 * t - 1  # Is a force between its bounds the best one? (hint 1)
trajectory = -(t**2) / 2  # Is the mass braked? (hint 1)
# Is this a motion to the right? (hint 1)
trajectory = sp.Piecewise(
    (t**2 / 2, t < sp.Rational(1, 2)), (sp.Rational(1, 4) - (1 - t) ** 2 / 2, True)
)
trajectory = t**3 / 3 - t**2 / 2  # Which force does this motion need at $t = 0$? (hint 1)
trajectory = -t * (1 - t)  # Does this motion begin at rest? (hint 1)
cost = sp.Rational(-1, 8)  # Is this half of the distance, or the integral of Example 1? (hint 1)
cost = sp.Rational(-1, 2)  # Is this the distance without braking? (hint 1)
cost = sp.Rational(1, 4)  # On which side is the end? (hint 1)
cost = sp.Rational(-1, 6)  # Is the force at its bounds all the time here? (hint 1)
costate = [1, sp.Rational(1, 2) - t]  # Which sign does psi1 have at the end? (hint 1)
costate = [-1, t]  # Where does psi2 have to vanish? (hint 1)
# Is this the costate of Example 1? (hint 1)
costate = [
    -1,
    -((1 - t) ** 2) / 2 + sp.Rational(1, 8),
]

# %% right
control = [[-1, 0.5], [1, 1]]  # a list of arcs
control = sp.sign(t - sp.Rational(1, 2))  # the sign of psi2
# both states
trajectory = [
    sp.Piecewise((-(t**2) / 2, t < 0.5), (t**2 / 2 - t + 0.25, True)),
    sp.Abs(t - 0.5) - 0.5,
]
cost = -0.25  # decimals
costate = sp.Matrix([-1, (2 * t - 1) / 2])  # a column
costate = (-1.0, t - 0.5)  # decimals, a tuple
