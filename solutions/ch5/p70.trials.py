# %% wrong
gain = [0, -gain[1]]  # Does this put energy into the oscillation? (hint 1)
gain = [0, -filter_gain[1]]  # Is this the gain of the filter? (hint 1)
gain = [2 * gain[1], gain[1]]  # Does the cost contain the position? (hint 1)
gain = [gain[1], 0]  # Which row of S does B select?
# Can the position be known exactly, if only the velocity is measured, with errors?
covariance = sp.diag(0, covariance[1, 1])
# Can a variance be zero if the covariance is not? (hint 2)
covariance = covariance[1, 1] * sp.Matrix([[0, 1], [1, 0]])
# Which power of the velocity's variance appears in the last equation?
covariance = intensity * sp.eye(2)
covariance = sp.sqrt(weight) * sp.eye(2)  # Is this the matrix of the regulator? (hint 1)
covariance = -covariance  # Can a variance be negative?
# Is this the gain of the regulator, inserted into the filter?
filter_gain = [0, sp.sqrt(weight)]
filter_gain = filter_gain[::-1]  # Which of the two coordinates is measured? (hint 1)
# Does the filter move towards the measurement with this sign?
filter_gain = [0, -filter_gain[1]]
filter_gain = [0, intensity]  # Is this the intensity of the noise itself?
# Does the filter contain the control? (hint 1)
controller = [e2, -e1 + filter_gain[1] * (z - e2)]
# Which gain belongs to the innovation? (hint 1)
controller = [e2, -e1 + gain[1] * e2 - gain[1] * (z - e2)]
# Is the sign of the control right, and which value is subtracted from the measurement?
controller = [e2, -e1 - gain[1] * e2 + filter_gain[1] * (z - e2)]
# Into which equation does the correction go?
controller = [e2 + filter_gain[1] * (z - e2), -e1 + gain[1] * e2]
price = known  # Is the state known without error? (hint 2)
price = price - known  # Is this the cost of not knowing the state alone?
price = 2 * price - known  # Was the error of the position included in the cost? (hint 2)
price = price / 2  # Was a factor one half put in front of the sum?
known = price  # What is this value with the given measurement? (hint 1)
known = known / intensity  # Does the strength of the noise not matter? (hint 1)
known = 2 * known  # On how many of the two equations does the noise act? (hint 1)
known = 0  # Is there no noise, if the state is known?

# %% right
gain = sp.Matrix([[0, -sp.sqrt(weight)]])  # a row
covariance = sp.sqrt(intensity) * sp.eye(2)  # a multiple of the unit matrix
filter_gain = sp.Matrix([0, sp.sqrt(intensity)])  # a column
# a column, collected
controller = sp.Matrix([e2, filter_gain[1] * z - (filter_gain[1] - gain[1]) * e2 - e1])
price = float(price)  # a decimal
known = sp.sqrt(known**2)  # a root

# %% numbers
weight, intensity = [
    (damping**2, gain**2)
    for damping, gain in [
        *[(1, 2), (2, 3), (3, 4), (2, 5), (3, 15), (1, 7), (2, 8)],
        *[(2, 9), (1, 11), (1, 10), (4, 6), (1, 13), (1, 12), (3, 14)],
    ]
]
shown = [r"E\big[«weight*»x_2^2(t) + u^2(t)\big]", r"«intensity»\,\delta(t - \tau)"]
damping, correction = sp.sqrt(weight), sp.sqrt(intensity)
gain, filter_gain = [0, -damping], [0, correction]
covariance = correction * sp.eye(2)
controller = [e2, -e1 - damping * e2 + correction * (z - e2)]
known = damping * intensity
price = known + weight * correction
