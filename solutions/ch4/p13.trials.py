# %% wrong
# Is this the line through the first and the last point? (hint 1)
slope = sp.Rational(readings[-1] - readings[0], times[-1] - times[0])
estimate = [readings[0] - slope * times[0], slope]
# Is this the height in the middle of the times? (hint 2)
estimate = [sp.Rational(sum(readings), 4), estimate[1]]
# Was a sign lost between the middle and $t = 0$? (hint 2)
estimate = [-estimate[0], estimate[1]]
# Is this the matrix of the normal equations itself? (hint 1)
covariance = covariance.inv()
# Is the inverse of a matrix that of its entries? (hint 1)
normal = covariance.inv()
covariance = sp.diag(1 / normal[0, 0], 1 / normal[1, 1])
# What is the sign of the off-diagonal entries of the inverse? (hint 1)
covariance = covariance.applyfunc(abs)

# %% right
# from the means
slope = estimate[1]
estimate = [sp.Rational(sum(readings), 4) - slope * sp.Rational(sum(times), 4), slope]
# as an inverse
rows = sp.Matrix([[1, t] for t in record])
covariance = (rows.T * rows).inv()

# %% numbers
times, readings = [
    ([1, 2, 4, 5], [0, 1, 2, 4]),
    ([1, 3, 4, 6], [2, 1, 4, 3]),
    ([1, 2, 3, 6], [1, 3, 2, 6]),
    ([1, 3, 5, 7], [3, 1, 4, 6]),
    ([2, 3, 4, 7], [1, 2, 2, 5]),
    ([1, 2, 5, 6], [5, 3, 1, 2]),
    ([2, 3, 5, 6], [1, 4, 3, 6]),
    ([1, 2, 3, 4], [5, 4, 2, 3]),
    ([2, 4, 5, 7], [1, 3, 6, 5]),
    ([1, 4, 5, 8], [2, 4, 5, 9]),
    ([3, 4, 6, 7], [1, 2, 5, 6]),
    ([1, 3, 6, 8], [6, 3, 2, 3]),
    ([2, 3, 4, 5], [1, 4, 3, 7]),
    ([1, 4, 6, 7], [2, 3, 6, 4]),
]
shown = [
    "$z(«times[0]») = «readings[0]»$, $z(«times[1]») = «readings[1]»$, "
    "$z(«times[2]») = «readings[2]»$, $z(«times[3]») = «readings[3]»$"
]
H, z = sp.Matrix([[1, t] for t in times]), sp.Matrix(readings)
covariance = (H.T * H).inv()
estimate = list(covariance * H.T * z)
