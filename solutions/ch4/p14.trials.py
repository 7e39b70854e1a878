# %% wrong
estimate = [1, 1]  # Where does the line through the three points start? (hint 1)
estimate = [1, 0]  # Have height and slope changed places? (hint 1)
# Were the weights left out? (hint 1)
covariance = sp.Matrix([[sp.Rational(7, 3), -1], [-1, sp.Rational(1, 2)]])
# Is a square divided by the standard deviation or by the variance? (hint 2)
covariance = sp.Matrix([[4, 8], [8, 18]]).inv()
# Is this the matrix of the normal equations itself? (hint 1)
covariance = sp.Matrix([[6, 12], [12, 26]])
weighted = [(c - 2) / 3, 1]  # Were the weights left out? (hint 2)
# Is a square divided by the standard deviation or by the variance? (hint 2)
weighted = [(c - 2) / 2, 1]
weighted = [2 * (c + 1) / 3, 1]  # Is this the height in the middle of the times? (hint 2)
plain = [2 * (c - 2) / 3, 1]  # Are these the weights of the accurate measurement?
plain = [(4 + c) / 3, 1]  # Is this the height in the middle of the times?

# %% right
weighted = [(4 + 4 * c) / 6 - 2, sp.Rational(3 - 1, 2)]  # from the middle
