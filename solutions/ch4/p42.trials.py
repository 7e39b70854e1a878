# %% wrong
shaping = [-1, 1, 1]  # Does the variance stay 1 with this intensity? (hint 2)
shaping = [1, 2, 1]  # Does the correlation decay with this coefficient? (hint 1)
shaping = [-1, 2, 0]  # Is a stationary process known exactly at $t = 0$?
admissible = K > 0  # Does the decay of the process not contribute to that of the errors? (hint 1)
admissible = K < 1  # What is the sign of the gain in the equation of the error? (hint 1)
# Is it enough that the formula of the variance can be computed? (hint 1)
admissible = sp.Ne(K, -1)
variance = 2 / (2 * (K + 1))  # Does the measurement error not enter the estimate? (hint 1)
variance = (K + 2) / (2 * (K + 1))  # How does a factor of a noise enter its intensity? (hint 1)
# At what rate does a variance decay, compared with the error itself? (hint 2)
variance = (K**2 + 2) / (K + 1)
variance = (K**2 + 1) / (2 * (K + 1))  # What is the intensity of the process noise? (hint 1)
gain = -1 - sp.sqrt(3)  # Do the errors decay with this gain? (hint 1)
gain = sp.sqrt(2) - 1  # What is the intensity of the process noise? (hint 1)
gain = 1  # Is the derivative zero there? (hint 1)
least = 1  # Is this the variance without a measurement? (hint 1)
least = sp.sqrt(2) - 1  # What is the intensity of the process noise? (hint 1)
least = (sp.sqrt(3) - 1) / 2  # Is this half of the variance? Put the gain in again. (hint 1)
# What is the sign of the linear term of the Riccati equation? (hint 1)
kalman_gain = sp.sqrt(3) + 1
kalman_gain = sp.sqrt(2) - 1  # What is the intensity of the process noise? (hint 1)
kalman_variance = -1 - sp.sqrt(3)  # Can a variance be negative? (hint 1)
kalman_variance = sp.sqrt(2)  # Was the decay of the process left out?

# %% right
variance = (K - 1) / 2 + sp.Rational(3, 2) / (K + 1)  # divided out
gain = 2 / (1 + sp.sqrt(3))  # without a difference
least = 0.732  # three digits
kalman_gain = sp.sqrt(4 - 2 * sp.sqrt(3))  # a root of a root
admissible = 2 * K + 2 > 0  # the rate of the variance
