# %% wrong
mean = mu0 * sp.exp(2 * a * t)  # Is this the rate of a square? (hint 1)
mean = mu0 + Q * t  # Does white noise have a mean other than zero? (hint 1)
# Does the square of a deviation change at this rate? (hint 1)
variance = P0 * sp.exp(a * t) + Q * (sp.exp(a * t) - 1) / a
# Does the contribution of early noise stay constant? (hint 1)
variance = P0 * sp.exp(2 * a * t) + Q * t
# What is the sign of the equilibrium? (hint 2)
variance = (P0 - Q / (2 * a)) * sp.exp(2 * a * t) + Q / (2 * a)
# Was the initial state known exactly? (hint 2)
variance = Q * (sp.exp(2 * a * t) - 1) / (2 * a)
# Is the intensity already a square?
variance = P0 * sp.exp(2 * a * t) + Q**2 * (sp.exp(2 * a * t) - 1) / (2 * a)
# For uncorrelated steps, which quantities add up: the steps or their squares? (hint 1)
wiener = P0 + Q * t**2
wiener = Q * t  # What was the initial variance? (hint 1)
wiener = P0  # Is there no noise when $a = 0$? (hint 1)
settles = a <= 0  # Try the border case itself. (hint 1)
settles = a > 0  # For which $a$ do deviations decay? (hint 1)
limit = -Q / a  # Is this the rate of the deviation or of its square? (hint 1)
limit = Q / (2 * a)  # Can a variance have this sign where there is a limit? (hint 1)
rises = a > 0  # Can the variance increase although deviations decay? (hint 1)
# Can the variance increase although deviations decay? (hint 1)
rises = a >= 0
rises = 2 * a * P0 + Q >= 0  # Does the variance of a stationary process increase?
rises = 2 * a * P0 - Q > 0  # What is the sign of the noise in the rate of change? (hint 1)
rises = a * P0 + Q > 0  # Is the rate that of a deviation or of its square? (hint 1)

# %% right
# with a hyperbolic function
variance = P0 * sp.exp(2 * a * t) + Q * sp.exp(a * t) * sp.sinh(a * t) / a
# both cases at once
variance = sp.Piecewise(
    (P0 + Q * t, sp.Eq(a, 0)), ((P0 + Q / (2 * a)) * sp.exp(2 * a * t) - Q / (2 * a), True)
)
settles = sp.Interval.open(-sp.oo, 0)  # as a set
limit = Q / (2 * sp.Abs(a))  # with the modulus
rises = sp.Or(a >= 0, P0 < -Q / (2 * a))  # below the limit, or no limit
