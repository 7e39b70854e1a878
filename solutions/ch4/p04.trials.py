# %% wrong
# Are the two errors uncorrelated? (hint 1)
before = sp.Matrix([[Q * T**3 / 3, 0], [0, Q * T]])
# Was a factor 2 lost in the integration? (hint 1)
before = sp.Matrix([[Q * T**3 / 6, Q * T**2 / 2], [Q * T**2 / 2, Q * T]])
# Is the noise constant during a journey? (hint 1)
before = sp.Matrix([[Q * T**4 / 4, Q * T**3 / 2], [Q * T**3 / 2, Q * T**2]])
before_deviations = [333.33, 0.001]  # Are these variances? (hint 1)
before_deviations = [18.26, 31.6]  # What is the unit of the second one? (hint 1)
correction = [0, Q * T * z / (Q * T + R)]  # Are the two errors uncorrelated here? (hint 2)
correction = [T * z / 2, z]  # Is the reading free of errors? (hint 1)
# Is this the variance of the corrected quantity? (hint 2)
correction = [Q * T**3 * z / (3 * (Q * T + R)), Q * T * z / (Q * T + R)]
# Is only the speed corrected? (hint 1)
after = sp.Matrix([[Q * T**3 / 3, Q * T**2 / 2], [Q * T**2 / 2, Q * T * R / (Q * T + R)]])
after = sp.Matrix([[Q * T**3 / 12, 0], [0, 0]])  # Is this what an exact reading would leave?
# Do the errors of the reading make it better? (hint 1)
after = sp.Matrix(
    [
        [Q * T**3 / 3 - Q * T**3 / (4 * (1 - R / (Q * T))), Q * T * R / 2 / (Q * T - R) * T],
        [Q * T * R / 2 / (Q * T - R) * T, Q * T * R / (Q * T - R)],
    ]
)
after_deviations = [18.26, 0.001]  # Is the position left unchanged?
after_deviations = [83.58, 0.001]  # Is the first number a variance? (hint 1)
after_deviations = [9.5, 0.001]  # Did you round intermediate results? (hint 1)

# %% right
before = Q * sp.Matrix([[T**3 / 3, T**2 / 2], [T**2 / 2, T]])  # the intensity in front
correction = [T * z / 2 / (1 + R / (Q * T)), z / (1 + R / (Q * T))]  # by the ratio of the variances
after_deviations = [9.14, 0.001]  # rounded to three digits
# by the correlation
rest = R / (Q * T + R)
after = sp.Matrix(
    [
        [Q * T**3 / 3 * (1 - sp.Rational(3, 4) * (1 - rest)), Q * T**2 / 2 * rest],
        [Q * T**2 / 2 * rest, Q * T * rest],
    ]
)
