# %% wrong
# Does an entry of the noise enter twice? (hint 1)
limit = sp.Matrix([[sp.Rational(1, 30), 0], [0, sp.Rational(1, 5)]])
# Is the speed as large as the position? (hint 2)
limit = sp.Matrix([[sp.Rational(1, 60), 0], [0, sp.Rational(1, 60)]])
# Have the two coordinates changed places?
limit = sp.Matrix([[sp.Rational(1, 10), 0], [0, sp.Rational(1, 60)]])
limit = sp.zeros(2)  # The system decays. What does the noise do meanwhile? (hint 1)
# Is there one exponential only? (hint 1)
motion = sp.diag((1 - sp.exp(-4 * t)) / 60, (1 - sp.exp(-4 * t)) / 10)
# Which entries does the push have besides its square? Was the correlation left out? (hint 2)
limits = sp.Rational(1, 60), sp.Rational(1, 10)
motion = sp.diag(
    limits[0] - sp.exp(-4 * t) / 4 + 2 * sp.exp(-5 * t) / 5 - sp.exp(-6 * t) / 6,
    limits[1] - sp.exp(-4 * t) + 12 * sp.exp(-5 * t) / 5 - 3 * sp.exp(-6 * t) / 2,
)
# Which value does this matrix have at $t = 0$?
motion = sp.diag(sp.Rational(1, 60), sp.Rational(1, 10))

# %% right
# by the matrix exponential
E = (process.A * t).exp()
motion = sp.diag(1, 6) / 60 - E * sp.diag(1, 6) / 60 * E.T
