# %% wrong
shaping = [0, D, 0]  # Does a constant change with time? (hint 1)
shaping = [1, 0, D]  # Is the error constant with this equation? (hint 1)
shaping = [0, 0, 0]  # Is the error of the accelerometer known, then? (hint 1)
# Is the error of the force white noise here?
before = sp.Matrix([[D * T**3 / 3, D * T**2 / 2, 0], [D * T**2 / 2, D * T, 0], [0, 0, D]])
# Are three multiples of one random number uncorrelated? (hint 2)
before = sp.diag(D * T**4 / 4, D * T**2, D)
# What is the integral of a constant, integrated once more? (hint 1)
before = D * sp.Matrix([[T**4, T**3, T**2], [T**3, T**2, T], [T**2, T, 1]])
correlation = sp.sqrt(3) / 2  # Is this the value for white noise?
# Is a larger error of the speed not a sign of a larger error of the coordinate? (hint 1)
correlation = 0
correlation_noise = 1  # Does the final speed determine the whole history? (hint 2)
correlation_noise = sp.Rational(3, 4)  # Is this the square of the coefficient? (hint 2)
correlation_noise = sp.sqrt(3)  # Can a correlation coefficient be larger than one? (hint 2)
# Is this the covariance before the measurement?
after = D * sp.Matrix([[T**4 / 4, T**3 / 2, T**2 / 2], [T**3 / 2, T**2, T], [T**2 / 2, T, 1]])
# Does the measurement of the speed not help the coordinate as well? (hint 1)
after = sp.Matrix(
    [
        [D * T**4 / 4, D * T**3 / 2, D * T**2 / 2],
        [D * T**3 / 2, R * D * T**2 / (R + D * T**2), D * T],
        [D * T**2 / 2, D * T, D],
    ]
)
# Which fraction is subtracted, and which remains? (hint 1)
after = (
    D
    * T**2
    / (R + D * T**2)
    * D
    * sp.Matrix([[T**4 / 4, T**3 / 2, T**2 / 2], [T**3 / 2, T**2, T], [T**2 / 2, T, 1]])
)
deviations_before = [250000, 1, sp.Rational(1, 10**6)]  # Are these the variances? (hint 1)
# Was the factor 1/2 of the second integral forgotten?
deviations_before = [1000, 1, sp.Rational(1, 1000)]
deviations_after = [500, 0.001, 0.001]  # Is only the speed known better than before? (hint 1)
deviations_after = [9.13, 0.001, 0.001]  # Is this the coordinate in the case of white noise?
deviations_after = [0.25, 1e-6, 1e-12]  # Are these the variances? (hint 1)

# %% right
# as an outer product
column = sp.Matrix([T**2, 2 * T, 2]) / 2
before = D * column * column.T
# by the sum of inverses
after = sp.Matrix([T**2, 2 * T, 2]) * sp.Matrix([[T**2, 2 * T, 2]]) / 4 / (1 / D + T**2 / R)
correlation_noise = sp.sin(sp.pi / 3)  # by an angle
deviations_after = [0.5, 0.001, 0.000001]  # three digits
