# %% wrong
gain = [0, 1]  # Does this put energy into the oscillation? (hint 1)
gain = [0, -2]  # Is this the gain of the filter? (hint 1)
gain = [-2, -1]  # Is the place paid for? (hint 1)
gain = [-1, 0]  # Which row of S does B select?
# Can a place be known exactly, if only the velocity is measured, with errors?
covariance = sp.diag(0, 2)
# Can variances be zero beside a covariance that is not? (hint 2)
covariance = sp.Matrix([[0, 2], [2, 0]])
# Which power of the velocity's variance stands in the last equation?
covariance = sp.diag(4, 4)
covariance = sp.eye(2)  # Is this the matrix of the regulator? (hint 1)
covariance = sp.diag(-2, -2)  # Can a variance be negative?
filter_gain = [0, 1]  # Is this the gain of the regulator, put into the filter?
filter_gain = [2, 0]  # Which of the two coordinates is measured? (hint 1)
filter_gain = [0, -2]  # Does the filter move towards the measurement with this sign?
filter_gain = [0, 4]  # Is this the intensity of the noise itself?
controller = [e2, -e1 + 2 * (z - e2)]  # Does the filter contain the control? (hint 1)
controller = [e2, -e1 - e2 + (z - e2)]  # Which gain belongs to the innovation? (hint 1)
# Is the sign of the control right, and from what is the measurement counted?
controller = [e2, -e1 + e2 + 2 * (z - e2)]
controller = [e2 + 2 * (z - e2), -e1 - e2]  # Into which equation does the correction go?
price = 4  # Is the state known without an error? (hint 2)
price = 2  # Is this the price of not knowing alone?
price = 8  # Was the error of the place paid for, too? (hint 2)
price = 3  # Was a half put before the sum?
known = 6  # What is this with the measurement that there is? (hint 1)
known = 1  # Does the strength of the noise not matter? (hint 1)
known = 8  # On how many of the two equations does the noise act? (hint 1)
known = 0  # Is there no noise, if the state is known?

# %% right
gain = sp.Matrix([[0, -1]])  # a row
covariance = 2 * sp.eye(2)  # a multiple of the unit matrix
filter_gain = sp.Matrix([0, 2])  # a column
controller = sp.Matrix([e2, 2 * z - 3 * e2 - e1])  # a column, collected
price = 6.0  # a decimal
known = sp.sqrt(16)  # a root
