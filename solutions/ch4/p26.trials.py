# %% wrong
estimate = [4, 1]  # Is this what one expects before anything is measured? (hint 1)
# Does the measured position say nothing about the speed? (hint 2)
estimate = [sp.Rational(61, 20), 1]
# Was the noise left out of the covariance? (hint 2)
estimate = [sp.Rational(34, 11), sp.Rational(8, 11)]
# In which order do expected and measured value stand?
estimate = [sp.Rational(99, 20), sp.Rational(11, 8)]
# Is this before the measurement? (hint 1)
covariance = sp.Matrix([[19, sp.Rational(15, 2)], [sp.Rational(15, 2), 4]])
# Does the variance of the speed stay as it was? (hint 2)
covariance = sp.Matrix([[sp.Rational(19, 20), sp.Rational(3, 8)], [sp.Rational(3, 8), 4]])
# Was the noise left out on the way?
covariance = sp.Matrix([[10, 3], [3, 2]]) / 11

# %% right
# the inverse matrices add up
covariance = (
    sp.Matrix([[19, sp.Rational(15, 2)], [sp.Rational(15, 2), 4]]).inv() + sp.diag(1, 0)
).inv()
# the position from the two variances, the speed from the regression on it
estimate = [
    (4 * 1 + 3 * sp.Integer(19)) / 20,
    1 + sp.Rational(15, 2) * (sp.Rational(61, 20) - 4) / 19,
]
