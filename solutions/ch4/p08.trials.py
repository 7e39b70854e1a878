# %% wrong
# Is the mean of a power the power of the mean? (hint 1)
means = [third, third**2, third**3, third**4]
# Were the values taken as equally likely? (hint 1)
means = [0, sp.Rational(2, 3), 0, sp.Rational(2, 3)]
covariance = third  # Is this the mean of the product alone? (hint 1)
covariance = 0  # Uncorrelated by symmetry? Are the values 1 and -1 equally likely? (hint 2)
correlation = 1  # One determines the other; is that what the coefficient measures? (hint 1)
# Is it the variances that stand below, or their roots? (hint 1)
correlation = sp.Rational(1, 10)
correlation = sp.sqrt(third) / 2  # Are means of squares the variances? (hint 2)

# %% right
correlation = sp.sqrt(10) / 10  # without a root below
means = [half - third / 2, half + third / 2, half - third / 2, half + third / 2]  # as sums
