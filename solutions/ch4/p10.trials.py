# %% wrong
# Is this where the first two lines meet? What does the third one say? (hint 1)
estimate = [1, 1]
# Is a plain mean of the three crossings the least sum? (hint 2)
estimate = [sp.Rational(7, 9), sp.Rational(13, 9)]
# Have the two components changed places? (hint 1)
estimate = [sp.Rational(9, 7), sp.Rational(8, 7)]
least = 0  # Is there a point on all three lines?
# Is it the length of the residual that was asked, or its square?
least = sp.sqrt(sp.Rational(2, 7))
least = 2  # Were the residuals taken at the crossing of two lines? (hint 1)

# %% right
estimate = [8 * sp.Rational(1, 7), 9 * sp.Rational(1, 7)]  # over a common denominator
least = sp.Rational(9 + 1 + 4, 49)  # as the sum of three squares
