# %% wrong
estimate = [1, sp.Rational(4, 3)]  # Have height and slope changed places? (hint 1)
# Is this the height in the middle of the times? Where does the line start? (hint 2)
estimate = [sp.Rational(7, 3), 1]
estimate = [2, 1]  # Does the line have to pass through the first point? (hint 1)
estimate = [0, 2]  # Does the sum of squares look at the first point too? (hint 1)
first_two = [2, 1]  # Which way does the line fall? (hint 1)
first_two = [sp.Rational(4, 3), 1]  # Is this the estimate with the third measurement? (hint 1)

# %% right
estimate = [sp.Rational(7, 3) - 1, sp.Rational(4 - 2, 2)]  # from the means
